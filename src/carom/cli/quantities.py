"""Numbers as they are written on the command line."""

from __future__ import annotations

from math import isfinite

from carom.cli.mistakes import Mistake


def number(option: str, text: str) -> float:
    """The finite number that `text` writes: `10`, `0.5`, `1e-3`, or a fraction like `1/60`; raises `Mistake`."""
    over, slash, under = text.partition("/")
    try:
        value = float(over) / float(under) if slash else float(over)
    except (ValueError, ZeroDivisionError):
        raise Mistake(f"{option} {text}: is no number, nor a fraction like 1/60") from None
    if not isfinite(value):
        raise Mistake(f"{option} {text}: must be finite")
    return value


def positive(option: str, text: str) -> float:
    """The number that `text` writes, which must be above 0; raises `Mistake`."""
    value = number(option, text)
    if value <= 0.0:
        raise Mistake(f"{option} {text}: must be above 0")
    return value


def non_negative(option: str, text: str) -> float:
    """The number that `text` writes, which must not be below 0; raises `Mistake`."""
    value = number(option, text)
    if value < 0.0:
        raise Mistake(f"{option} {text}: must not be below 0")
    return value
