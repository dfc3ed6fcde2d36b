"""Mistakes in what was asked: told in words, without a traceback, with exit status 2."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


class Mistake(Exception):
    """What was asked cannot be done; the message says why, and what can be."""


def meant(text: str, known: Iterable[str]) -> str:
    """A question for the one of the `known` names that `text` is nearest to, in small letters or large; "" for none."""
    names = {name.lower(): name for name in known}
    near = get_close_matches(text.lower(), names, n=1)
    return f"did you mean {names[near[0]]}?" if near else ""


def no_such(what: str, text: str, known: Iterable[str], option: str = "") -> Mistake:
    """The mistake of naming a `what` that is not among the `known` ones, as the value of an `option` or by itself."""
    names = list(known)
    hint = meant(text, names) or f"there are {', '.join(names)}"
    return Mistake(f"{option} {text}: no such {what}; {hint}".lstrip())
