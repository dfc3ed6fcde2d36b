"""SVG path data as pieces.

The grammar is read here and not by svgelements, which takes 80 to 150 µs for a short path and passes over what it does
not understand; ten microseconds and an error that names the place are needed.
"""

from __future__ import annotations

import re
from math import isfinite

from carom.scene.drawings.ellipses import between
from carom.scene.drawings.pieces import Cubic, Piece, Straight, Vector

#: Atomic: digits that stand together are one number, and are not tried as several.
NUMBER = r"(?>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)"
_NUMBER = re.compile(NUMBER)
_LIST = re.compile(rf"(?:[, \n\t\r\f]|{NUMBER})*+")
#: What lists of numbers are made of that stand apart; `float` reads other words too.
_APART = re.compile(r"[-+.0-9eE, \n\t\r\f]*")
COMMAND = re.compile(r"([MmZzLlHhVvCcSsQqTtAa])([^MmZzLlHhVvCcSsQqTtAa]*)")
_GAP = r"[\s,]*"
#: The flags of an arc are single digits, and need nothing between them.
_ARC = re.compile(_GAP.join(["", *[rf"({NUMBER})"] * 3, *[r"([01])"] * 2, *[rf"({NUMBER})"] * 2, ""]))

#: How many numbers each command takes.
TAKES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


def count_numbers(text: str) -> int:
    """How many numbers there are in a text."""
    return len(_NUMBER.findall(text))


def numbers(text: str) -> list[float]:
    """The numbers in a list of them; raises `ValueError`, which says what else there is."""
    try:
        values = list(map(float, text.replace(",", " ").split())) if _APART.fullmatch(text) else _close_numbers(text)
    except ValueError:  # of numbers that stand together, such as 1-2
        values = _close_numbers(text)
    if not all(map(isfinite, values)):
        raise ValueError("must be finite")
    return values


def _close_numbers(text: str) -> list[float]:
    """The numbers in a list of them, which need nothing between them where it is clear where each ends."""
    good = _LIST.match(text)
    end = good.end() if good else 0
    if end < len(text):
        rest = text[end : end + 20].replace(",", " ").split()
        raise ValueError(f"must hold numbers alone, not {rest[0] if rest else text[end]!r}")
    return [float(number) for number in _NUMBER.findall(text)]


def points(text: str) -> list[Vector]:
    """The points of a polyline; raises `ValueError`."""
    values = numbers(text)
    if len(values) % 2:
        raise ValueError("must be pairs of numbers, but their number is odd")
    return list(zip(values[::2], values[1::2], strict=True))


def subpaths(data: str) -> list[list[Piece]]:
    """The pieces of each subpath; raises `ValueError`, which says what is wrong with `data`."""
    pen = _Pen()
    if not data.strip() or data.strip() == "none":
        return []
    begin = data.lstrip()
    if begin[0] not in "Mm":
        raise ValueError(f"must begin with M, not {begin[:20]!r}")
    for found in COMMAND.finditer(begin):
        try:
            pen.obey(found[1], found[2])
        except ValueError as error:
            raise ValueError(
                f"{error}, in the command at character {len(data) - len(begin) + found.start() + 1}"
            ) from None
    pen.lift()
    return pen.done


class _Pen:
    """What draws a path: where it is, where the subpath began, and what a smooth continuation mirrors."""

    def __init__(self) -> None:
        self.done: list[list[Piece]] = []
        self._pieces: list[Piece] = []
        self._place = self._begin = (0.0, 0.0)
        self._cubic_handle: Vector | None = None
        self._quadratic_handle: Vector | None = None

    def lift(self) -> None:
        """End the subpath."""
        if self._pieces:
            self.done.append(self._pieces)
        self._pieces = []

    def obey(self, command: str, given: str) -> None:
        """Draw what a command says."""
        kind, relative = command.upper(), command.islower()
        if kind == "Z":
            if given.strip(" ,\n\t\r\f"):
                raise ValueError(f"Z takes no numbers, not {given.strip()[:20]!r}")
            self._close()
            return
        values = _arc_numbers(given) if kind == "A" else numbers(given)
        takes = TAKES[kind]
        if not values or len(values) % takes:
            raise ValueError(f"{command} takes {takes} numbers at a time, not {len(values)}")
        for at in range(0, len(values), takes):
            # After the first pair, M draws lines.
            self._draw("L" if kind == "M" and at else kind, values[at : at + takes], relative)

    def _draw(self, kind: str, values: list[float], relative: bool) -> None:
        """Draw one piece."""
        x, y = self._place if relative else (0.0, 0.0)
        if kind == "H":
            self._line((x + values[0], self._place[1]))
        elif kind == "V":
            self._line((self._place[0], y + values[0]))
        elif kind == "A":
            self._arc(values, (x + values[5], y + values[6]))
        else:
            places = [(x + px, y + py) for px, py in zip(values[::2], values[1::2], strict=True)]
            if kind == "M":
                self.lift()
                self._begin = places[0]
                self._go(places[0])
            elif kind == "L":
                self._line(places[0])
            elif kind in "CS":
                self._cubic(*([self._mirrored(self._cubic_handle), *places] if kind == "S" else places))
            else:
                self._quadratic(*([self._mirrored(self._quadratic_handle), *places] if kind == "T" else places))

    def _go(self, place: Vector) -> None:
        """Be somewhere else, with nothing to mirror."""
        self._place = place
        self._cubic_handle = self._quadratic_handle = None

    def _line(self, end: Vector) -> None:
        self._pieces.append(Straight(self._place, end))
        self._go(end)

    def _close(self) -> None:
        if self._place != self._begin:
            self._line(self._begin)
        self.lift()
        self._go(self._begin)

    def _cubic(self, first: Vector, second: Vector, end: Vector) -> None:
        self._pieces.append(Cubic(self._place, first, second, end))
        self._go(end)
        self._cubic_handle = second

    def _quadratic(self, handle: Vector, end: Vector) -> None:
        """Draw a quadratic Bézier curve, as the cubic one that it is."""
        (x0, y0), (x1, y1), (x2, y2) = self._place, handle, end
        first = x0 + 2.0 * (x1 - x0) / 3.0, y0 + 2.0 * (y1 - y0) / 3.0
        second = x2 + 2.0 * (x1 - x2) / 3.0, y2 + 2.0 * (y1 - y2) / 3.0
        self._pieces.append(Cubic(self._place, first, second, end))
        self._go(end)
        self._quadratic_handle = handle

    def _mirrored(self, handle: Vector | None) -> Vector:
        """The handle that continues the last one smoothly; where the pen is if there is none."""
        x, y = self._place
        return (x, y) if handle is None else (2.0 * x - handle[0], 2.0 * y - handle[1])

    def _arc(self, values: list[float], end: Vector) -> None:
        """Draw a piece of an ellipse."""
        rx, ry, turn, large, onward = values[:5]
        piece = between(self._place, end, (rx, ry), turn, large=large == 1.0, onward=onward == 1.0)
        if piece is not None:
            self._pieces.append(piece)
        self._go(end)


def _arc_numbers(given: str) -> list[float]:
    """The numbers after an A, seven for each arc; raises `ValueError`."""
    values: list[float] = []
    at = 0
    while at < len(given):
        found = _ARC.match(given, at)
        if found is None:
            what = given[at : at + 20].strip()
            raise ValueError(f"A takes 7 numbers at a time, of which the fourth and fifth are 0 or 1, not {what!r}")
        values += map(float, found.groups())
        at = found.end()
    if not all(map(isfinite, values)):
        raise ValueError("must be finite")
    return values
