"""Checks at the door: each returns the clean value, or raises `InvalidArgument` naming the argument and its value."""

from __future__ import annotations

import os
from itertools import islice
from math import isfinite
from operator import index
from reprlib import Repr
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from carom.errors import InvalidArgument
from carom.rows.ball import ALL_LAYERS
from carom.typing import Vector

#: One of a few words.
Word = TypeVar("Word", bound=str)
#: Something of a class.
Kind = TypeVar("Kind")

#: Characters of a refused value in a message at most.
LONGEST_VALUE = 1000


def refuse(name: str, must: str, value: object) -> InvalidArgument:
    """The error to raise when argument `name` with `value` does not do what it `must`; shows up to a page of it."""
    shown = written(value, LONGEST_VALUE)
    if len(shown) > LONGEST_VALUE:
        shown = f"{shown[:LONGEST_VALUE]} ..."
    return InvalidArgument(f"{name} {must}, not {shown}")


def written(value: object, longest: int) -> str:
    """The beginning of `repr(value)`, more than `longest` characters of it where there are more; any value has one."""
    return _Beginning(longest).repr(value)


class _Beginning(Repr):
    """Writes as `repr` does, but no more than is asked for, no deeper than the stack allows, and any whole number."""

    def __init__(self, longest: int) -> None:
        super().__init__()
        self._longest = longest
        self.maxlevel = min(longest, 100)
        # Each item is one character at least, with a comma and a space after it.
        self._most = longest // 3 + 2
        self.maxtuple = self.maxlist = self.maxset = self.maxfrozenset = self.maxdeque = self.maxarray = self._most

    def repr1(self, x: Any, level: int) -> str:
        if isinstance(x, (str, bytes)):
            return repr(x[: self._longest])
        if isinstance(x, int):
            return _digits(x)[: self._longest + 1]
        return self._table(x, level) if type(x) is dict else super().repr1(x, level)

    def _table(self, table: dict[Any, Any], level: int) -> str:
        """A dictionary, in its own order."""
        if level <= 0:
            return "{...}"
        pairs = islice(table.items(), self._most)
        return "{" + ", ".join(f"{self.repr1(k, level - 1)}: {self.repr1(v, level - 1)}" for k, v in pairs) + "}"

    def repr_instance(self, x: Any, level: int) -> str:
        try:
            return repr(x) if level else "..."
        except Exception:  # noqa: BLE001  # whatever a stranger's `__repr__` may raise
            return object.__repr__(x)


def _digits(number: int) -> str:
    """A whole number as it is written; in hexadecimal, if Python refuses to write so many decimal digits."""
    try:
        return repr(number)
    except ValueError:
        return hex(number)


def number(name: str, value: Any) -> float:
    """`value` as a finite float."""
    if type(value) is float and isfinite(value):
        return value
    if isinstance(value, (bool, str, bytes)):
        raise refuse(name, "must be a number", value)
    try:
        result = float(value)
    except (TypeError, ValueError, OverflowError):
        raise refuse(name, "must be a number", value) from None
    if not isfinite(result):
        raise refuse(name, "must be finite", value)
    return result


def positive(name: str, value: Any) -> float:
    """`value` as a finite float above 0."""
    result = number(name, value)
    if result <= 0.0:
        raise refuse(name, "must be positive", value)
    return result


def non_negative(name: str, value: Any) -> float:
    """`value` as a finite float of 0 or more."""
    result = number(name, value)
    if result < 0.0:
        raise refuse(name, "must not be negative", value)
    return result


def pair(name: str, value: Any) -> Vector:
    """`value` as a tuple of two finite floats."""
    if type(value) is tuple and len(value) == 2:
        x, y = value
        if type(x) is type(y) is float and isfinite(x) and isfinite(y):
            return value
    if isinstance(value, (str, bytes, dict, set, frozenset)):
        raise refuse(name, "must be a pair of numbers", value)
    try:
        x, y = value
    except (TypeError, ValueError):
        raise refuse(name, "must be a pair of numbers", value) from None
    return number(f"{name}[0]", x), number(f"{name}[1]", y)


def flag(name: str, value: Any) -> bool:
    """`value` as a bool; only true booleans (Python's or NumPy's) are taken."""
    if value is True or value is False:
        return bool(value)
    if type(value).__name__ in {"bool", "bool_"}:
        return bool(value)
    raise refuse(name, "must be True or False", value)


def instance(name: str, value: Any, kind: type[Kind], what: str) -> Kind:
    """`value`, which must be of a class; `what` says that in words, `a World`."""
    if isinstance(value, kind):
        return value
    raise refuse(name, f"must be {what}", value)


def callable_or_none(name: str, value: Any) -> Any:
    """`value` as something that can be called, or None."""
    if value is None or callable(value):
        return value
    raise refuse(name, "must be callable or None", value)


def whole(name: str, value: Any, least: int = 0, most: int = 2**31 - 1, reason: str = "") -> int:
    """`value` as an int from `least` to `most`; a larger one is told the `reason` where there is one."""
    try:
        result = int(index(value))
    except TypeError:
        raise refuse(name, "must be a whole number", value) from None
    if isinstance(value, bool):
        raise refuse(name, "must be a whole number", value)
    if not least <= result <= most:
        why = f" ({reason})" if reason and result > most else ""
        raise refuse(name, f"must be from {least} to {most}{why}", value)
    return result


def layers(name: str, value: Any) -> int:
    """`value` as a mask of 32 layers."""
    return whole(name, value, 0, ALL_LAYERS)


def text(name: str, value: Any) -> str:
    """`value` as a string."""
    if isinstance(value, str):
        return value
    raise refuse(name, "must be a string", value)


def text_or_none(name: str, value: Any) -> str | None:
    """`value` as a string or None."""
    if value is None or isinstance(value, str):
        return value
    raise refuse(name, "must be a string or None", value)


def path(name: str, value: Any) -> str:
    """`value`, a string or what `os.fspath` makes one of, as the name of a file or folder."""
    try:
        given = os.fspath(value)
    except TypeError:
        given = None
    if isinstance(given, str) and given and "\0" not in given:
        return given
    raise refuse(name, "must be a file's name", value)


def one_of(name: str, value: Any, choices: tuple[Word, ...]) -> Word:
    """`value`, which must be one of the strings `choices`."""
    if isinstance(value, str) and value in choices:
        return choices[choices.index(value)]
    raise refuse(name, "must be one of " + ", ".join(map(repr, choices)), value)


def array(
    name: str,
    value: Any,
    shape: tuple[int, ...],
    above: float | None = None,
    least: float | None = None,
    besides: float | None = None,
) -> NDArray[np.float64]:
    """`value` as a float64 array of `shape` (-1: any length), one value or row standing for all, `[]` for none.

    All values must be finite, greater than `above` and not less than `least`, unless they are what is allowed
    `besides`.
    """
    given, result = _shaped(name, value, shape, "iuf", "numbers", np.float64)
    _check_all(name, "must be finite", given, np.isfinite(given))
    if above is not None:
        _check_all(name, "must be positive", given, given > above)
    if least is not None:
        must = "must not be negative" if besides is None else f"must be 0 or more, or {besides:g}"
        _check_all(name, must, given, (given >= least) | (given == besides))
    return result


def flags(name: str, value: Any, count: int) -> NDArray[np.bool_]:
    """`value` as an array of `count` bools, one standing for all; only true booleans are taken."""
    return _shaped(name, value, (count,), "b", "True or False, or an array of them", np.bool_)[1]


def masks(name: str, value: Any, count: int) -> NDArray[np.uint32]:
    """`value` as an array of `count` masks of 32 layers, one standing for all."""
    given, _ = _shaped(name, value, (count,), "iu", "whole numbers", None)
    _check_all(name, f"must be from 0 to {ALL_LAYERS}", given, (given >= 0) & (given <= ALL_LAYERS))
    return np.broadcast_to(given.astype(np.uint32), (count,))


def _shaped(
    name: str, value: Any, shape: tuple[int, ...], kinds: str, what: str, dtype: Any
) -> tuple[NDArray[Any], NDArray[Any]]:
    """`value` as an array of some kinds of NumPy's, as it was given and as `shape` (-1: any length) wants it."""
    needed = f"must be {what} of shape {('n', *shape[1:]) if shape[0] < 0 else shape}"
    try:
        given = np.asarray(value)
        if given.dtype.kind not in kinds and given.size:
            raise TypeError
        given = given if dtype is None else given.astype(dtype)
        if given.shape == (0,) and shape[0] <= 0:
            given = given.reshape(0, *shape[1:])  # a list of nothing has no rows to tell their lengths
        result = given if shape[0] < 0 else np.broadcast_to(given, shape)
    except (TypeError, ValueError):
        raise refuse(name, needed, value) from None
    if result.ndim != len(shape) or result.shape[1:] != shape[1:]:
        raise refuse(name, needed, value)
    return given, result


def _check_all(name: str, must: str, given: NDArray[Any], good: NDArray[np.bool_]) -> None:
    """Raise for the first value that is not good, naming its place."""
    if not good.all():
        place = np.unravel_index(int(np.argmin(good)), given.shape)
        index = f"[{', '.join(str(int(number)) for number in place)}]" if place else ""
        raise refuse(name + index, must, given[place].item())
