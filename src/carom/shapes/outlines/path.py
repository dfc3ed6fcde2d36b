"""SVG path data as segments and arcs."""

from __future__ import annotations

from cmath import phase, rect
from math import cos, pi, sin, sqrt
from typing import Any, Unpack

from carom.checks import refuse
from carom.constants import HALF_PI, TWO_PI
from carom.shapes.arc import Arc
from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.curves import CUBICS_SHARE, followed
from carom.shapes.outlines.path_data import Bezier, Ellipse, Line, Piece, pieces_of
from carom.shapes.outlines.spline import cubics_along
from carom.shapes.outlines.walls import Frame, builder, frame_of, guarded, tolerance_in, walled
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape, ShapeOptions

#: The tolerance where none is given, in the size of what is drawn.
DEFAULT_SHARE = 1e-3


@builder
def path(data: str, tolerance: float | None = None, guard: bool = True, **options: Unpack[ShapeOptions]) -> list[Shape]:
    """What SVG path data draws: segments and arcs in its order, and then the points that they need.

    Args:
        data: Commands with their numbers, as in the attribute `d` of a `<path>`: M, L, H, V, C, S, Q, T, A and Z, small
            for places relative to the last. y points up, as everywhere here, so a second flag of 1 makes an arc run
            counterclockwise.
        tolerance: How far from Béziers and elliptical arcs the outline may be, a length; by default a thousandth of the
            size of what is drawn. Lines and circular arcs are exact.
        guard: Whether the points that bare ends need are there too; see `guard_points`.
        options: What every `Shape` takes; it holds for all of them.

    Raises:
        InvalidArgument: The data is no path, which says at which character; it draws nothing; the tolerance is too
            small for a curve.

    >>> import carom
    >>> [shape.kind for shape in carom.outlines.path("M 0 0 L 4 0 A 1 1 0 0 1 4 2 H 0 Z")]
    ['segment', 'arc', 'segment', 'segment', 'point', 'point']
    """
    if not isinstance(data, str):
        raise refuse("data", "must be SVG path data, a string", data)
    subpaths = pieces_of(data)
    if not subpaths:
        raise refuse("data", "must draw something", data)
    places = [place for pieces in subpaths for piece in pieces for place in piece if isinstance(place, complex)]
    frame = frame_of("data", [(place.real, place.imag) for place in places])
    width = max(place.real for place in places) - min(place.real for place in places)
    height = max(place.imag for place in places) - min(place.imag for place in places)
    given = DEFAULT_SHARE * max(width, height) if tolerance is None else tolerance
    within = tolerance_in(frame, given, max(width, height) / frame.length(1.0))
    walls = [shape for pieces in subpaths for shape in _walls(pieces, within, frame, options)]
    return guarded(walls, guard)


def _walls(pieces: list[Piece], tolerance: float, frame: Frame, options: ShapeOptions) -> list[Shape]:
    """The shapes for the pieces of one subpath; cubics that follow each other are taken as one curve."""
    shapes: list[Shape] = []
    cubics: list[Cubic] = []
    for piece in [*pieces, None]:
        if isinstance(piece, Bezier):
            cubics.append(Cubic(*(frame.inward((place.real, place.imag)) for place in piece)))
            continue
        shapes += walled(followed(cubics, tolerance), tolerance, frame, False, options)
        cubics = []
        if isinstance(piece, Line):
            shapes.append(Segment(_pair(piece.start), _pair(piece.end), **options))
        elif isinstance(piece, Ellipse):
            shapes += _arcs(piece, tolerance, frame, options)
    return shapes


def _arcs(piece: Ellipse, tolerance: float, frame: Frame, options: ShapeOptions) -> list[Shape]:
    """The shapes for a part of an ellipse: an arc if it is a circle, else arcs along it.

    Half axes that are too short to reach from end to end are made longer. Source: SVG 2, appendix B.2.
    """
    tilt = rect(1.0, (piece.turned % 180.0) * pi / 180.0)
    half = 0.5 * (piece.start - piece.end) / tilt
    width, height = piece.half_width, piece.half_height
    across = complex(half.real / width, half.imag / height)
    stretch = max(abs(across), 1.0)
    width, height, across = width * stretch, height * stretch, across / stretch
    # In units of the half axes the ellipse is a circle, and its centre lies off the chord's middle, at right angles.
    off = sqrt(max(0.0, 1.0 - abs(across) * abs(across))) / abs(across) if abs(across) < 1.0 else 0.0
    center = across * (-1j * off if piece.large != piece.counterclockwise else 1j * off)
    start = phase(across - center)
    turn = (phase(-across - center) - start) % TWO_PI
    if not piece.counterclockwise:
        turn -= TWO_PI
    middle = 0.5 * (piece.start + piece.end) + tilt * complex(width * center.real, height * center.imag)
    if piece.half_width == piece.half_height:
        # Angles of the ends as they are given: the turn of the axes drops out.
        first, last = phase(piece.start - middle), phase(piece.end - middle)
        angles = (first, last) if piece.counterclockwise else (last, first)
        return [Arc(_pair(middle), width, *angles, **options)]
    return walled(
        _along(middle, tilt, (width, height), (start, turn), tolerance, frame), tolerance, frame, False, options
    )


def _along(
    middle: complex,
    tilt: complex,
    axes: tuple[float, float],
    angles: tuple[float, float],
    tolerance: float,
    frame: Frame,
) -> list[Any]:
    """Arcs along a part of an ellipse, which begins at an angle and turns by another, in units of its half axes."""
    center = frame.inward(_pair(middle))
    width, height = frame.inward(axes).real, frame.inward(axes).imag
    start, turn = angles

    def place(t: float) -> complex:
        angle = start + turn * t
        return center + tilt * complex(width * cos(angle), height * sin(angle))

    def slope(t: float) -> complex:
        angle = start + turn * t + HALF_PI
        return turn * tilt * complex(width * cos(angle), height * sin(angle))

    cubics = cubics_along(place, slope, CUBICS_SHARE * tolerance)
    return followed(cubics, (1.0 - CUBICS_SHARE) * tolerance)


def _pair(place: complex) -> tuple[float, float]:
    """A place as a pair of floats."""
    return place.real, place.imag
