"""Mistakes in what was asked: told in words, without a traceback, with exit status 2."""


class Mistake(Exception):
    """What was asked cannot be done; the message says why, and what can be."""
