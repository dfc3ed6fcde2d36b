"""The pool end game: a cue ball, the eight, a table with six pockets, and one shot after the other."""

from carom.play.pool.app import PoolApp, run

__all__ = ["PoolApp", "run"]
