"""Some of the curves of a DXF, as a text of its own: it is read soon, and tells what all of them would become."""

from __future__ import annotations

import re
from random import Random
from typing import NamedTuple

from carom.scene.drawings.bodies import Drawing
from carom.scene.drawings.limits import SAMPLE

_ENTITIES = re.compile(r"^ *0\n *SECTION *\n *2\n *ENTITIES *\n", re.MULTILINE)
#: What stands before each structure; a value 0 is not before a word.
_BEGIN = re.compile(r"^ *0\n(?= *[A-Z])", re.MULTILINE)
_PLACE = re.compile(r"\n *[12][01]\n *([-+.\deE]+)")
#: The entities that others do not need.
_ALONE = frozenset({"ARC", "CIRCLE", "ELLIPSE", "HATCH", "LINE", "LWPOLYLINE", "MTEXT", "POINT", "SPLINE", "TEXT"})


class Sample(NamedTuple):
    """Some of the bodies of a drawing, the share of all that they are, about, and the longer side of its page."""

    drawing: Drawing
    share: float
    page: float


class Some(NamedTuple):
    """The text of a DXF with a share of its entities alone, and a length that all of it is not longer than."""

    text: str
    share: float
    size: float


def some_of(text: str) -> Some | None:
    """Some of a DXF that has very many curves in model space; None where it has not, or has blocks there."""
    curves = text.count("\nELLIPSE\n") + text.count("\nSPLINE\n")
    found = _ENTITIES.search(text)
    share = SAMPLE / max(1, curves)
    if share > 0.5 or found is None:
        return None
    head, *entities = _BEGIN.split(text[found.end() :])
    places = list(map(float, _PLACE.findall(text, found.end())))
    if not places:
        return None
    kept, chance, ended = [head], Random(0), False
    for entity in entities:
        kind = entity[: entity.find("\n")].strip()
        ended = ended or kind == "ENDSEC"
        if kind == "INSERT":
            return None
        if ended or kind not in _ALONE or chance.random() < share:
            kept.append(entity)
    return Some(text[: found.end()] + "0\n".join(kept), share, max(places) - min(places))
