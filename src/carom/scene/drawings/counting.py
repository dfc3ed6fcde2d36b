"""How much there is in a drawing, counted in its text: what is too large is told before anything in it is followed."""

from __future__ import annotations

import re
from collections import Counter
from itertools import islice
from typing import NamedTuple, NoReturn

from carom.errors import SceneError
from carom.scene.drawings.limits import DEEPEST, LONGEST_NUMBER, MOST_CURVES, MOST_ELEMENTS, MOST_MARKS, SLOW
from carom.scene.drawings.paths import COMMAND, TAKES, count_numbers
from carom.scene.drawings.tree import Element

#: The commands of paths that draw curves, and characters beyond which there may be more than one curve for each.
CURVES = "CcSsQqTtAa"
LONG = 60
#: The elements that have curves where their radii differ, and how many.
ROUNDED = {"ellipse": 1, "rect": 4}
#: So few entities of a DXF are read soon, and who follows them can say which of them draws too much.
QUICK = 10_000
#: The kinds of a DXF's structures that are no entities.
_NO_ENTITY = frozenset({"BLOCK", "ENDBLK", "ENDSEC", "EOF", "SECTION", "SEQEND"})
_STRUCTURE = re.compile(r"^ *0\n *([A-Z]\w*) *$", re.MULTILINE)


class Amount(NamedTuple):
    """How much is drawn for an element: elements, characters of outlines that are no digits, and curves at least."""

    elements: int
    marks: int
    curves: int


def refuse_amount(elements: int, marks: int, where: object) -> NoReturn:
    """Raise for what is more than a drawing may hold: elements, marks, or else curves, up to an element."""
    if elements > MOST_ELEMENTS:
        raise SceneError(f"{where}: draws more than {MOST_ELEMENTS} elements, by reference")
    if marks > MOST_MARKS:
        raise SceneError(f"{where}: the outlines of the drawing have too many points, all taken together")
    raise SceneError(f"{where}: a drawing may have at most {MOST_CURVES} curves")


def own_of(element: Element) -> tuple[int, int]:
    """How many marks and curves an SVG element draws by itself: see `Amount`."""
    attributes = element.attributes
    text = attributes.get("d") or attributes.get("points")
    if text:
        marks = len(text.encode().translate(None, b"0123456789"))
        if len(text) > LONGEST_NUMBER * (marks + 1):
            raise SceneError(f"{element}: has numbers with more than {LONGEST_NUMBER} digits")
        # More of them are refused for that.
        return marks, curves_in(text) if element.tag == "path" and marks <= MOST_MARKS else 0
    if element.tag in ROUNDED and attributes.get("rx") != attributes.get("ry") and "rx" in attributes:
        return 0, ROUNDED[element.tag] if "ry" in attributes else 0
    return 0, 0


def curves_in(data: str) -> int:
    """How many curves path data draw, at least."""
    commands = sum(map(data.count, CURVES))
    if len(data) <= LONG * commands or commands == 0:
        return commands
    return sum(
        count_numbers(found[2]) // TAKES[found[1].upper()] for found in COMMAND.finditer(data) if found[1] in CURVES
    )


# -- DXF ---------------------------------------------------------------------------------------------------------------


def check_text(text: str) -> None:
    """Raise `SceneError` where the text of a DXF has more entities or curves than a drawing may, by reference too.

    What cannot be told from the text, such as blocks that are inserted in themselves, is left to who follows it.
    """
    found = list(islice(_STRUCTURE.finditer(text), 2 * MOST_ELEMENTS + 1))
    if len(found) > 2 * MOST_ELEMENTS:
        raise SceneError(f"a drawing may have at most {MOST_ELEMENTS} entities")
    ends = [*(one.start() for one in found[1:]), len(text)]
    held: dict[str, _Held] = {"": _Held()}
    container, drawn = held[""], False
    for one, end in zip(found, ends, strict=False):
        kind = one[1]
        if kind == "SECTION":
            drawn = _values(text[one.end() : end], "2")[:1] in (["ENTITIES"], ["BLOCKS"])
        elif kind == "BLOCK":
            container = held.setdefault("".join(_values(text[one.end() : end], "2")[:1]).upper(), _Held())
        elif kind == "ENDBLK":
            container = held[""]
        elif drawn and kind not in _NO_ENTITY:
            container.add(kind, text, one.end(), end)
    written = sum(one.entities for one in held.values())
    if written > MOST_ELEMENTS:
        raise SceneError(f"a drawing may have at most {MOST_ELEMENTS} entities")
    entities, curves = _total(held, "", {})
    if entities > MOST_ELEMENTS and written > QUICK:
        raise SceneError(f"a drawing may have at most {MOST_ELEMENTS} entities, those of blocks counted each time")
    if curves > MOST_CURVES:
        raise SceneError(f"a drawing may have at most {MOST_CURVES} curves")


class _Held:
    """What model space or a block holds."""

    def __init__(self) -> None:
        self.entities = 0
        self.curves = 0
        self.inserted: Counter[str] = Counter()

    def add(self, kind: str, text: str, begin: int, end: int) -> None:
        """Count an entity, whose groups stand in a part of the text."""
        self.entities += 1
        if kind == "INSERT":
            groups = text[begin:end]
            copies = [_whole(_values(groups, code)) for code in ("70", "71")]
            self.inserted["".join(_values(groups, "2")[:1]).upper()] += copies[0] * copies[1]
        elif kind == "SPLINE":
            groups = text[begin:end]
            # Each end may have as many knots apart as its degree says, between which there is no curve.
            degree = _whole(_values(groups, "71"))
            knots = _values(groups, "40")
            stretches = max(0, len(set(knots)) - 1 - 2 * degree)
            clamped = len(set(knots[: degree + 1])) == 1 == len(set(knots[-degree - 1 :]))
            self.curves += stretches * (1 if degree <= 3 and clamped and not _values(groups, "41") else SLOW)
        elif kind == "ELLIPSE":
            self.curves += 1


def _total(held: dict[str, _Held], name: str, known: dict[str, tuple[int, int]], depth: int = 0) -> tuple[int, int]:
    """How many entities and curves something draws; none of what is nested too deeply, or in itself."""
    if depth > DEEPEST:
        return 0, 0
    if name not in known:
        known[name] = (0, 0)
        mine = held.get(name, _Held())
        entities, curves = mine.entities, mine.curves
        for block, copies in mine.inserted.items():
            more, bent = _total(held, block, known, depth + 1)
            entities, curves = entities + copies * more, curves + copies * bent
        known[name] = (entities, curves)
    return known[name]


def _values(groups: str, code: str) -> list[str]:
    """The values of a code in a structure's groups, which begin with a new line."""
    lines = groups.split("\n")[1:]
    return [value.strip() for number, value in zip(lines[::2], lines[1::2], strict=False) if number.strip() == code]


def _whole(values: list[str]) -> int:
    """The first of some values as a whole number, 1 at least."""
    return max(1, int(values[0])) if values and values[0].isdecimal() else 1
