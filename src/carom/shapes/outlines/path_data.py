"""What SVG path data says: lines, cubics and elliptical arcs from place to place."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

from carom.checks import number, refuse
from carom.errors import InvalidArgument

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_SPACE = re.compile(r"[\s,]*")

#: How many numbers each command takes; an arc's fourth and fifth are flags.
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}

#: Characters of the data that an error shows.
_SHOWN = 20


class Line(NamedTuple):
    """A straight piece."""

    start: complex
    end: complex


class Bezier(NamedTuple):
    """A cubic, by its control points."""

    start: complex
    first: complex
    last: complex
    end: complex


class Ellipse(NamedTuple):
    """A part of an ellipse that has these half axes, the first turned by so many degrees."""

    start: complex
    end: complex
    half_width: float
    half_height: float
    turned: float
    large: bool
    counterclockwise: bool


Piece: TypeAlias = Line | Bezier | Ellipse


def pieces_of(data: str) -> list[list[Piece]]:
    """The pieces of each subpath, in the order of the data; those of no length are left out.

    Numbers are taken as they stand: what grows upwards there grows upwards here, and an arc whose second flag is 1 runs
    counterclockwise. Source: Scalable Vector Graphics (SVG) 2, section 9.3.

    Raises:
        InvalidArgument: The data is no path; says at which character, counted from 0, and what must be there.
    """
    return _Pen(data).draw()


class _Pen:
    """Reads path data, command by command."""

    def __init__(self, data: str) -> None:
        """Begin before the first character, nowhere."""
        self._data = data
        self._at = 0
        self._moved = False
        self._here = self._start = 0j
        self._control: tuple[str, complex] = ("", 0j)
        self._subpaths: list[list[Piece]] = [[]]

    def draw(self) -> list[list[Piece]]:
        """All pieces."""
        strokes: dict[str, Callable[[list[float], complex], None]] = {
            "M": self._move,
            "L": self._line,
            "H": self._line,
            "V": self._line,
            "C": self._cubic,
            "S": self._smooth_cubic,
            "Q": self._quadratic,
            "T": self._smooth_quadratic,
            "A": self._arc,
        }
        command = ""
        self._skip()
        while self._at < len(self._data):
            letter = self._data[self._at]
            if letter.upper() in _COUNTS:
                command = letter
                self._at += 1
            elif command in {"", "Z", "z"}:
                raise self._error("a command, one of MLHVCSQTAZ or a small one,")
            kind = command.upper()
            if kind != "M" and not self._moved:
                raise self._error("M first", self._at - 1)
            if kind == "Z":
                self._close()
            else:
                numbers = self._numbers(kind)
                strokes[kind](self._placed(kind, numbers, command.islower()), self._here)
                if kind == "M":
                    command = "l" if command == "m" else "L"
            self._skip()
        return [subpath for subpath in self._subpaths if subpath]

    def _error(self, must: str, at: int | None = None) -> InvalidArgument:
        """The error for what stands at a character."""
        place = self._at if at is None else at
        return refuse("data", f"must have {must} at character {place}", self._data[place : place + _SHOWN])

    def _skip(self) -> None:
        """Go past spaces and commas."""
        found = _SPACE.match(self._data, self._at)
        assert found is not None
        self._at = found.end()

    def _numbers(self, kind: str) -> list[float]:
        """The numbers of one stroke."""
        found = []
        for index in range(_COUNTS[kind]):
            self._skip()
            if kind == "A" and index in {3, 4}:
                if self._data[self._at : self._at + 1] not in {"0", "1"}:
                    raise self._error("a flag, 0 or 1,")
                found.append(float(self._data[self._at]))
                self._at += 1
                continue
            match = _NUMBER.match(self._data, self._at)
            if match is None:
                raise self._error("a number")
            found.append(number(f"data[{self._at}:{match.end()}]", float(match.group())))
            self._at = match.end()
        return found

    def _placed(self, kind: str, numbers: list[float], relative: bool) -> list[float]:
        """The numbers with their places in full: of a line both coordinates, none relative to where the pen is."""
        x, y = (self._here.real, self._here.imag) if relative else (0.0, 0.0)
        if kind == "H":
            return [x + numbers[0], self._here.imag]
        if kind == "V":
            return [self._here.real, y + numbers[0]]
        if kind == "A":
            return [*numbers[:5], x + numbers[5], y + numbers[6]]
        return [value + (y if index % 2 else x) for index, value in enumerate(numbers)]

    def _close(self) -> None:
        """Go back to where the subpath began, and let the next one begin there."""
        self._add(Line(self._here, self._start), self._start)
        self._subpaths.append([])

    def _add(self, piece: Piece, end: complex, control: tuple[str, complex] = ("", 0j)) -> None:
        """Take a piece that has a length, and go to its end; a curve that ends where it began may have one."""
        if any(place != piece.start for place in piece if isinstance(place, complex)):
            self._subpaths[-1].append(piece)
        self._here, self._control = end, control

    def _move(self, numbers: list[float], _here: complex) -> None:
        self._subpaths.append([])
        self._moved = True
        self._here = self._start = complex(*numbers)
        self._control = ("", 0j)

    def _line(self, numbers: list[float], here: complex) -> None:
        end = complex(*numbers)
        self._add(Line(here, end), end)

    def _cubic(self, numbers: list[float], here: complex) -> None:
        first, last, end = (complex(*numbers[index : index + 2]) for index in (0, 2, 4))
        self._add(Bezier(here, first, last, end), end, ("cubic", last))

    def _smooth_cubic(self, numbers: list[float], here: complex) -> None:
        first = self._mirrored("cubic")
        self._cubic([first.real, first.imag, *numbers], here)

    def _quadratic(self, numbers: list[float], here: complex) -> None:
        control, end = complex(*numbers[:2]), complex(*numbers[2:])
        self._add(
            Bezier(here, here + 2.0 / 3.0 * (control - here), end + 2.0 / 3.0 * (control - end), end),
            end,
            ("quadratic", control),
        )

    def _smooth_quadratic(self, numbers: list[float], here: complex) -> None:
        control = self._mirrored("quadratic")
        self._quadratic([control.real, control.imag, *numbers], here)

    def _mirrored(self, kind: str) -> complex:
        """The last control point of the curve before, mirrored in where the pen is; there, if that was none."""
        before, control = self._control
        return 2.0 * self._here - control if before == kind else self._here

    def _arc(self, numbers: list[float], here: complex) -> None:
        width, height, turned, large, counterclockwise, *last = numbers
        end = complex(*last)
        if width == 0.0 or height == 0.0:
            self._add(Line(here, end), end)
        else:
            self._add(Ellipse(here, end, abs(width), abs(height), turned, large == 1.0, counterclockwise == 1.0), end)
