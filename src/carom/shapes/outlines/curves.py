"""Curves as tangent arcs within a tolerance: Béziers, whatever a function draws, and directions through points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import ldexp
from typing import NamedTuple, Unpack

from carom.checks import non_negative, refuse
from carom.constants import LEAST_TOLERANCE
from carom.errors import InvalidArgument
from carom.geometry.vector import unit
from carom.shapes.outlines.abreast import are_brisk, follow_abreast
from carom.shapes.outlines.bow import PLACE_ROUNDING, Bow
from carom.shapes.outlines.cubic import Cubic, cross, dot
from carom.shapes.outlines.following import follow
from carom.shapes.outlines.places import places_of
from carom.shapes.outlines.spline import Curve, cubics_along, slope_by_steps, value_of
from carom.shapes.outlines.through import through
from carom.shapes.outlines.track import brisk_track, tracks
from carom.shapes.outlines.walls import Frame, builder, frame_of, tolerance_in, walled
from carom.shapes.shape import Shape, ShapeOptions
from carom.typing import Pair, Vector

#: Places at which a curve is looked at first, and the share of the tolerance that cubics along it may use up.
FIRST_LOOKS, CUBICS_SHARE = 64, 0.04

#: A curve is closed smoothly whose ends are this near to each other, in its size, and its directions, in radians.
SAME_PLACE, SAME_WAY = 1e-9, 1e-6


class Chain(NamedTuple):
    """Arcs that continue each other, the tolerance that they keep and the frame that both are reckoned in."""

    bows: list[Bow]
    tolerance: float
    frame: Frame


@builder
def bezier(
    points: Iterable[Pair], tolerance: float, guard: bool = True, **options: Unpack[ShapeOptions]
) -> list[Shape]:
    """Arcs and segments along a Bézier curve, each within `tolerance` of it, and the points that they need.

    Args:
        points: Its control points: 3 for a quadratic, 4 for a cubic.
        tolerance: How far the outline may lie from the curve, and the curve from the outline; a length, at least 1e-11
            of the curve's size.
        guard: Whether the points that bare ends need are there too; see `guard_points`.
        options: What every `Shape` takes; it holds for all of them.

    Returns:
        The shapes from the first control point to the last, without a bend where they meet but for cusps, and then the
        points. They are about as few as can be. What is nearly straight becomes a segment.

    Raises:
        InvalidArgument: There are not 3 or 4 points, or all are one; the tolerance is too small for the curve.

    >>> import carom
    >>> [shape.kind for shape in carom.outlines.bezier([(0, 0), (1, 2), (2, 0)], 0.01)]
    ['arc', 'arc', 'arc', 'arc', 'arc', 'arc', 'point', 'point']
    """
    return walled(*bezier_chain(points, tolerance), guard, options)


def bezier_chain(points: Iterable[Pair], tolerance: float) -> Chain:
    """The arcs that `bezier` makes shapes of; raises as it does."""
    places = places_of("points", points)
    if len(places) not in {3, 4} or len(set(places)) < 2:
        raise refuse("points", "must be 3 or 4 points, not all the same", places)
    cubic, within, frame = _framed(places, tolerance)
    return Chain(followed([cubic], within), within, frame)


def bezier_chains(curves: Iterable[Sequence[Vector]], tolerance: float) -> list[Chain | None]:
    """For each of many curves, of 3 or 4 finite points, what `bezier_chain` gives; None where that raises.

    It takes a tenth of the time.
    """
    chains: list[Chain | None] = []
    framed: list[tuple[Chain, Cubic]] = []
    for places in curves:
        try:
            cubic, within, frame = _framed(places, tolerance)
        except InvalidArgument:
            chains.append(None)
        else:
            framed.append((Chain([], within, frame), cubic))
            chains.append(framed[-1][0])
    brisk = are_brisk([cubic for _, cubic in framed])
    ways = [
        (chain, track)
        for (chain, cubic), is_brisk in zip(framed, brisk, strict=True)
        for track in ([brisk_track(cubic)] if is_brisk else tracks([cubic]))
    ]
    found = follow_abreast([track for _, track in ways], [chain.tolerance for chain, _ in ways])
    for (chain, track), bows in zip(ways, found, strict=True):
        chain.bows.extend(follow(track, chain.tolerance) if bows is None else bows)
    return [chain if chain is not None and chain.bows else None for chain in chains]


def _framed(places: Sequence[Vector], tolerance: float) -> tuple[Cubic, float, Frame]:
    """A Bézier curve as a cubic in a frame, with the tolerance there; raises as `bezier` does where it cannot be."""
    frame = frame_of("points", places)
    a, *between, d = map(frame.inward, places)
    if len(between) == 1:
        between = [(a + 2.0 * between[0]) / 3.0, (d + 2.0 * between[0]) / 3.0]
    cubic = Cubic(a, between[0], between[1], d)
    return cubic, tolerance_in(frame, tolerance, cubic.size()), frame


@builder
def fit(
    curve: Curve,
    tolerance: float,
    derivative: Curve | None = None,
    guard: bool = True,
    **options: Unpack[ShapeOptions],
) -> list[Shape]:
    """Arcs and segments along a smooth curve, each within `tolerance` of it, and the points that they need.

    Args:
        curve: A function of t, from 0 to 1, whose value is a place (x, y): an ellipse, a cam. It is called at some
            hundreds of places, and has to be smooth between them; it may have cusps, where it stands still.
        tolerance: How far the outline may lie from the curve; a length, at least 1e-11 of the curve's size.
        derivative: The derivative of `curve` by t, a function likewise. By default it is taken from differences.
        guard: Whether the points that bare ends need are there too; see `guard_points`.
        options: What every `Shape` takes; it holds for all of them.

    Returns:
        The shapes from curve(0) to curve(1), without a bend where they meet, also there, where both are one place and
        the curve goes on smoothly; and then the points.

    Raises:
        InvalidArgument: The curve is no function, or its value no place; it stays in one place; it cannot be followed
            to the tolerance, which is too small for it, or where it jumps.

    >>> import carom
    >>> from math import cos, pi, sin
    >>> ellipse = carom.outlines.fit(lambda t: (3 * cos(2 * pi * t), 2 * sin(2 * pi * t)), 1e-3)
    >>> {shape.kind for shape in ellipse}
    {'arc'}
    """
    return walled(*fit_chain(curve, tolerance, derivative), guard, options)


def fit_chain(curve: Curve, tolerance: float, derivative: Curve | None = None) -> Chain:
    """The arcs that `fit` makes shapes of; raises as it does."""
    for name, function in (("curve", curve), ("derivative", derivative)):
        if not callable(function) and not (name == "derivative" and function is None):
            raise refuse(name, "must be a function of t", function)
    looks = [value_of("curve", curve, index / FIRST_LOOKS) for index in range(FIRST_LOOKS + 1)]
    frame = frame_of("curve", looks)
    places = [frame.inward(look) for look in looks]
    size = sum(abs(b - a) for a, b in pairwise(places))
    if size == 0.0:
        raise refuse("curve", "must not stay in one place", curve)
    within = tolerance_in(frame, tolerance, size)

    def place(t: float) -> complex:
        return frame.inward(value_of("curve", curve, t))

    def slope(t: float) -> complex:
        return slope_by_steps(place, t) if derivative is None else frame.inward(value_of("derivative", derivative, t))

    cubics = cubics_along(place, slope, CUBICS_SHARE * within)
    return Chain(followed(_closed(cubics, size), (1.0 - CUBICS_SHARE) * within), within, frame)


def _closed(cubics: list[Cubic], size: float) -> list[Cubic]:
    """The cubics, whose last end goes over into their first start without a gap or bend where these are rounding."""
    first, last = cubics[0], cubics[-1]
    out, into = first.b - first.a, last.d - last.c
    if abs(last.d - first.a) > SAME_PLACE * size or dot(out, into) <= 0.0:
        return cubics
    if abs(cross(out, into)) > SAME_WAY * abs(out) * abs(into):
        return cubics
    return [*cubics[:-1], Cubic(last.a, last.b, first.a - abs(into) / abs(out) * out, first.a)]


@builder
def biarcs(
    points: Iterable[Pair],
    tangents: Iterable[Pair],
    tolerance: float = 0.0,
    guard: bool = True,
    **options: Unpack[ShapeOptions],
) -> list[Shape]:
    """Arcs and segments through points in given directions, two from one to the next, and the points that they need.

    Args:
        points: Two places or more, each apart from the one before it. The last may be the first again.
        tangents: For each of them the direction of travel, a vector of any length but 0.
        tolerance: A length: points that the outline passes at no more than this are left out, so that a finely drawn
            curve becomes few arcs. 0 leaves out none that rounding does not.
        guard: Whether the points that bare ends need are there too; see `guard_points`.
        options: What every `Shape` takes; it holds for all of them.

    Returns:
        The shapes from the first point to the last, without a bend where they meet, and then the points.

    Raises:
        InvalidArgument: There are too few points, not as many tangents as points, two points in a row in one place, or
            a tangent of no length.

    >>> import carom
    >>> carom.outlines.biarcs([(0, 0), (2, 0)], [(0, 1), (0, -1)], guard=False)
    [Arc((1.0, 0.0), 1.0, 0.0, 3.141592653589793)]
    """
    places, ways = places_of("points", points), places_of("tangents", tangents)
    frame = frame_of("points", places or [(0.0, 0.0)])
    spots = [frame.inward(place) for place in places]
    if len(places) < 2 or len(places) != len(ways):
        raise refuse("tangents", f"must be as many as the points, which are 2 or more, not {len(places)}", len(ways))
    for index, (before, after) in enumerate(pairwise(spots)):
        if before == after:
            raise refuse(f"points[{index + 1}]", "must differ from the one before it", places[index + 1])
    headings = [_heading(f"tangents[{index}]", way) for index, way in enumerate(ways)]
    within = ldexp(min(non_negative("tolerance", tolerance), frame.length(2.0)), -frame.power)
    arcs = through(spots, headings, max(within, PLACE_ROUNDING))
    return walled(arcs, max(within, LEAST_TOLERANCE), frame, guard, options)


def _heading(name: str, way: Vector) -> complex:
    """The unit vector along a direction; raises where it has no length."""
    found = unit(*way)
    if found is None:
        raise refuse(name, "must have a length", way)
    return complex(*found)


def followed(cubics: Sequence[Cubic], tolerance: float) -> list[Bow]:
    """Arcs along cubics that continue each other."""
    return [bow for track in tracks(cubics) for bow in follow(track, tolerance)]
