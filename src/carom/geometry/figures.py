"""The numbers of each kind of shape, as one argument; a point is its place alone."""

from typing import NamedTuple


class SegmentGeometry(NamedTuple):
    """The segment of length `extent` from the end a along the unit vector t."""

    ax: float
    ay: float
    tx: float
    ty: float
    extent: float


class CircleGeometry(NamedTuple):
    """The circle of radius r about c: its perimeter, and its inside too if it is solid."""

    cx: float
    cy: float
    r: float
    solid: bool


class ArcGeometry(NamedTuple):
    """The part of the circle of radius r about c that runs counterclockwise from its end a to its end b."""

    cx: float
    cy: float
    r: float
    ax: float
    ay: float
    bx: float
    by: float


class CentredArc(NamedTuple):
    """An arc seen from its centre, whose sector is widened by `slop` beside both rays, as `reach` describes.

    Its ends are at a and b, both r away.
    """

    r: float
    ax: float
    ay: float
    bx: float
    by: float
    slop: float


def centred_arc(arc: ArcGeometry, slop: float) -> CentredArc:
    """An arc as seen from its centre."""
    cx, cy, r, ax, ay, bx, by = arc
    return CentredArc(r, ax - cx, ay - cy, bx - cx, by - cy, slop)
