"""What tests of outlines measure by: distances in high precision, bends at joints, and cubics of every kind."""

import itertools
from cmath import phase
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from math import pi

from hypothesis import strategies as st
from mpmath import mp, mpf

from carom import Arc, Segment, Shape

Vector = tuple[float, float]


def exact_cubic(points: Sequence[Vector], t: Fraction) -> tuple[mpf, mpf]:
    """The place on a cubic, from exact fractions."""
    s = 1 - t
    weights = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
    x, y = (sum(w * Fraction(p[axis]) for w, p in zip(weights, points, strict=True)) for axis in (0, 1))
    return mpf(x.numerator) / x.denominator, mpf(y.numerator) / y.denominator


def exact_distance(shape: Shape, x: mpf, y: mpf) -> mpf:
    """How far a place is from a segment or arc, which is where its numbers say."""
    if isinstance(shape, Segment):
        (ax, ay), (bx, by) = shape.p0, shape.p1
        ux, uy = mpf(bx) - mpf(ax), mpf(by) - mpf(ay)
        along = ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)
        share = min(max(along, mpf(0)), mpf(1))
        return mp.hypot(x - ax - share * ux, y - ay - share * uy)
    assert isinstance(shape, Arc)
    cx, cy = map(mpf, shape.center)
    sweep = (mpf(shape.end_angle) - mpf(shape.start_angle)) % (2 * mp.pi)
    ahead = (mp.atan2(y - cy, x - cx) - mpf(shape.start_angle)) % (2 * mp.pi)
    if ahead <= sweep:
        return abs(mp.hypot(x - cx, y - cy) - mpf(shape.radius))
    ends = [(cx + shape.radius * mp.cos(angle), cy + shape.radius * mp.sin(angle)) for angle in shape.angles]
    return min(mp.hypot(x - ex, y - ey) for ex, ey in ends)


def farthest(curve: Callable[[Fraction], tuple[mpf, mpf]], shapes: Sequence[Shape], looks: int) -> float:
    """The farthest that a place on a curve is from the nearest of the shapes, which come in its order; 60 digits."""
    walls = [shape for shape in shapes if isinstance(shape, (Segment, Arc))]
    most = mpf(0)
    with mp.workdps(60):
        for index in range(looks + 1):
            x, y = curve(Fraction(index, looks))
            rough = [wall.distance((float(x), float(y))) for wall in walls]
            nearest = sorted(range(len(walls)), key=rough.__getitem__)[:4]
            most = max(most, min(exact_distance(walls[index], x, y) for index in nearest))
        return float(most)


def farthest_back(curve: Callable[[float], Vector], shapes: Sequence[Shape], looks: int) -> float:
    """The farthest that a place on the shapes is from the nearest of many places on a curve."""
    places = [complex(*curve(index / looks)) for index in range(looks + 1)]
    most = 0.0
    for place in (complex(*place) for shape in shapes for place in places_on(shape)):
        index = min(range(looks + 1), key=lambda at: abs(places[at] - place))
        low, high = max(index - 1, 0) / looks, min(index + 1, looks) / looks
        for _ in range(60):  # ternary search between the neighbours of the nearest
            third = (high - low) / 3.0
            if abs(complex(*curve(low + third)) - place) < abs(complex(*curve(high - third)) - place):
                high -= third
            else:
                low += third
        most = max(most, abs(complex(*curve(low)) - place))
    return most


def places_on(shape: Shape) -> Iterator[Vector]:
    """Some places on a segment or arc, its ends among them."""
    if isinstance(shape, Segment):
        (ax, ay), (bx, by) = shape.p0, shape.p1
        yield from ((ax + s / 8 * (bx - ax), ay + s / 8 * (by - ay)) for s in range(9))
    elif isinstance(shape, Arc):
        sweep = (shape.end_angle - shape.start_angle) % (2 * pi)
        for s in range(9):
            turned = complex(*shape.center) + shape.radius * _direction(shape.start_angle + s / 8 * sweep)
            yield turned.real, turned.imag


def _direction(angle: float) -> complex:
    return complex(float(mp.cos(angle)), float(mp.sin(angle)))


def ways(shapes: Sequence[Shape]) -> list[tuple[complex, complex, complex, complex]]:
    """For each segment and arc in a chain: where it starts, the direction there, where it ends, the direction there."""
    found: list[tuple[complex, complex, complex, complex]] = []
    walls = [shape for shape in shapes if isinstance(shape, (Segment, Arc))]
    for index, wall in enumerate(walls):
        p0, p1 = complex(*wall.p0), complex(*wall.p1)
        t0, t1 = complex(*wall.t0), complex(*wall.t1)
        forth = (p0, t0, p1, -t1) if isinstance(wall, Segment) else (p0, -t0, p1, t1)
        back = (forth[2], -forth[3], forth[0], -forth[1])
        if index + 1 < len(walls):
            after = [complex(*walls[index + 1].p0), complex(*walls[index + 1].p1)]
            gaps = [min(abs(way[2] - end) for end in after) for way in (forth, back)]
        else:
            gaps = [abs(found[-1][2] - way[0]) if found else 0.0 for way in (forth, back)]
        found.append(forth if gaps[0] <= gaps[1] else back)
    return found


def joints(shapes: Sequence[Shape]) -> list[tuple[complex, float, float]]:
    """For each joint of a chain its place, the gap there, and the angle by which the direction changes."""
    chain = ways(shapes)
    return [
        (after[0], abs(before[2] - after[0]), abs(phase(after[1] / before[3])))
        for before, after in itertools.pairwise(chain)
    ]


numbers = st.floats(-1.0, 1.0, allow_subnormal=False)
places = st.tuples(numbers, numbers)


@st.composite
def nasty_cubics(draw: st.DrawFn) -> tuple[list[Vector], float]:
    """Four control points, and a length about as large as they are far apart; of every kind and size.

    Among them are loops and inflections, cusps and what is almost one, straight ones that turn back, those whose ends
    or control points coincide, and those that are so nearly straight or pointed that rounding decides.
    """
    kind = draw(st.sampled_from(("any", "cusp", "nearly", "straight", "twice", "flat")))
    a, b, c, d = (complex(*draw(places)) for _ in range(4))
    if kind in {"cusp", "nearly"}:
        # Its slope is w·(t - s)·(...) with a double zero direction at s: b and c so that the derivative vanishes there.
        a, b, c, d = 0j, 1.0 + 1.0j, 0j, 1.0 + 0j
        off = draw(st.floats(-12.0, -1.0)) if kind == "nearly" else -300.0
        turn, shift = complex(*draw(places)) + 1.5, complex(*draw(places))
        a, b, c, d = (shift + turn * place for place in (a, b, c + 1j - 10.0**off, d))
    elif kind == "straight":
        way = d - a
        a, b, c, d = (a + draw(numbers) * way for _ in range(4))
    elif kind == "flat":
        way = 1j * 10.0 ** draw(st.floats(-14.0, -1.0))
        a, b, c, d = (complex(place.real) + way * place.imag for place in (a, b, c, d))
    elif kind == "twice":
        a, b, c, d = draw(
            st.sampled_from(((a, a, c, d), (a, b, b, d), (a, b, d, d), (a, a, d, d), (a, b, c, a), (a, b, a, b)))
        )
    scale = 10.0 ** draw(st.sampled_from((0, 0, 0, 3, -3, 150, -150, 280, -280)))
    size = max(abs(a - b), abs(b - c), abs(c - d))
    if size < 1e-3:
        a, b, c, d, size = 0j, 1j, 1.0 + 1j, 1.0 + 0j, 1.0
    return [(scale * p.real, scale * p.imag) for p in (a, b, c, d)], scale * size
