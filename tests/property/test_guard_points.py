"""Laws of guard points: every bare end has one, none is needless, and neither order nor place matters."""

from math import cos, hypot, ldexp, pi, sin

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

import carom
from carom.constants import GUARD_TOLERANCE
from tests.naive_guards import ends_of, needs_guard
from tests.strategies import angles, arcs, circles, motions, numbers, points, segments

pytestmark = pytest.mark.slow

Vector = tuple[float, float]

walls = st.one_of(
    segments().map(lambda ends: carom.Segment(ends[:2], ends[2:])),
    arcs().map(lambda arc: carom.Arc(arc[:2], *arc[2:])),
)
covers = st.one_of(
    circles.map(lambda circle: carom.Circle(circle[:2], circle[2], solid=True)),
    circles.map(lambda circle: carom.Circle(circle[:2], circle[2])),
    points.map(carom.Point),
)


@st.composite
def grids(draw: st.DrawFn) -> list[carom.Shape]:
    """Segments between places of a coarse grid, so that many share ends, cross and continue each other."""
    place = st.tuples(st.integers(0, 3), st.integers(0, 3))
    ends = st.tuples(place, place).filter(lambda pair: pair[0] != pair[1])
    return [carom.Segment(*pair) for pair in draw(st.lists(ends, min_size=1, max_size=8))]


@st.composite
def fans(draw: st.DrawFn) -> list[carom.Shape]:
    """Segments and arcs that share an end, some of which continue each other there, and walls across them."""
    directions = st.integers(0, 11).map(lambda part: part * pi / 6)
    fan: list[carom.Shape] = [
        carom.Segment((0, 0), (size * cos(angle), size * sin(angle)))
        for angle, size in draw(st.lists(st.tuples(directions, st.sampled_from((0.5, 1.0, 3.0))), max_size=8))
    ]
    bows = [
        carom.Arc((cos(angle), sin(angle)), 1.0, angle + pi, angle + pi + 1)
        for angle in draw(st.lists(directions, max_size=4))
    ]
    return fan + bows + draw(st.lists(walls, min_size=1, max_size=3))


scenes = st.one_of(grids(), fans(), st.lists(st.one_of(walls, covers), min_size=1, max_size=6))


def places(shapes: list[carom.Shape]) -> list[Vector]:
    """Where the guard points of shapes stand."""
    return [point.position for point in carom.guard_points(shapes)]


def is_near(a: Vector, b: Vector, tolerance: float = GUARD_TOLERANCE) -> bool:
    """Whether two points are close by."""
    return hypot(a[0] - b[0], a[1] - b[1]) <= tolerance


@given(scenes)
def test_they_are_what_the_definition_says(shapes: list[carom.Shape]) -> None:
    found = places(shapes)
    for shape in shapes:
        for end in ends_of(shape):
            assert any(is_near(end[0], point) for point in found) == needs_guard(end, shapes)
    for point in found:
        assert any(is_near(end[0], point) for shape in shapes for end in ends_of(shape))
        assert sum(is_near(point, other) for other in found) == 1


def scaled(shape: carom.Shape, power: int) -> carom.Shape:
    """A shape 2^power times as large, seen from the origin."""
    x, y = (ldexp(number, power) for number in shape.position)
    if isinstance(shape, carom.Segment):
        ends = [(ldexp(x, power), ldexp(y, power)) for x, y in (shape.p0, shape.p1)]
        return carom.Segment(*ends)
    if isinstance(shape, carom.Arc):
        return carom.Arc((x, y), ldexp(shape.radius, power), shape.start_angle, shape.end_angle)
    if isinstance(shape, carom.Circle):
        return carom.Circle((x, y), ldexp(shape.radius, power), solid=shape.solid)
    return carom.Point((x, y))


@given(scenes, st.integers(-900, 900))
@example([carom.Segment((0, 0), (1, 0)), carom.Segment((1, 0), (1, -1))], -30)
def test_the_unit_of_length_does_not_matter(shapes: list[carom.Shape], power: int) -> None:
    assume(all(not 0.0 < abs(number) < 1e-30 for shape in shapes for number in shape.aabb))
    again = places([scaled(shape, power) for shape in shapes])
    assert again == [(ldexp(x, power), ldexp(y, power)) for x, y in places(shapes)]


@given(grids(), angles, st.integers(-900, 900), numbers(-1e8, 1e8), numbers(-1e8, 1e8))
def test_nor_does_the_distance_from_the_origin(
    shapes: list[carom.Shape], angle: float, power: int, right: float, up: float
) -> None:
    def moved(place: Vector) -> Vector:
        x, y = place[0] * cos(angle) - place[1] * sin(angle), place[0] * sin(angle) + place[1] * cos(angle)
        return ldexp(x + right, power), ldexp(y + up, power)

    far = [carom.Segment(*map(moved, (shape.p0, shape.p1))) for shape in shapes if isinstance(shape, carom.Segment)]
    found, again = places(shapes), places(list(far))
    assert len(again) == len(found)
    for place in map(moved, found):
        assert any(is_near(place, other, ldexp(1e-6, power)) for other in again)


@given(scenes, st.integers(-40, 40), numbers(1.0, 2.0))
def test_details_are_seen_beside_shapes_of_any_size(shapes: list[carom.Shape], power: int, size: float) -> None:
    small = ldexp(size, power)
    corner = [carom.Segment((0, 0), (small, 0)), carom.Segment((small, 0), (small, -small))]
    far = max(1e3, 1e3 * small)
    assert places([carom.Segment((far, 0), (far, 5e3)), *corner])[2:] == places(list(corner))
    assert len(places(list(corner))) == 3


@pytest.mark.slow
@pytest.mark.parametrize("shape", ["star", "fan", "chain", "pile", "rings", "discs", "hands"])
def test_thousands_of_shapes_are_no_matter(shape: str) -> None:
    count = 6_000
    turns = [k * (5**0.5 - 1) / 2 % 1 for k in range(count)]
    rays = [(cos(2 * pi * turn), sin(2 * pi * turn)) for turn in turns]
    rings: list[carom.Shape] = [
        carom.Circle((0, 0), 1 + 1e-4 * k, solid=shape == "discs") for k in range(1, count // 2)
    ]
    posts = [carom.Segment((x, y), (1.7 * x, 1.7 * y)) for x, y in rays[: count // 2]]
    shapes: list[carom.Shape]
    if shape == "star":
        shapes = [
            carom.Segment((0, 0), (x * (1 + turn), y * (1 + turn))) for (x, y), turn in zip(rays, turns, strict=True)
        ]
        expected = count + 1
    elif shape == "fan":
        shapes = [carom.Segment((0, 0), (k, 1)) for k in range(count)]
        expected = count + 1
    elif shape == "chain":
        shapes = [carom.Segment((k, k * k % 7), (k + 1, (k + 1) * (k + 1) % 7)) for k in range(count)]
        expected = count + 1 - sum(k * k % 7 - 2 * ((k + 1) ** 2 % 7) + (k + 2) ** 2 % 7 == 0 for k in range(count - 1))
    elif shape == "pile":
        shapes = [carom.Segment((0, 0), (1, 0)) for _ in range(count)]
        expected = 2
    elif shape == "hands":
        shapes = [carom.Segment((0, 0), ray, motion="kinematic", angular_velocity=k) for k, ray in enumerate(rays)]
        expected = 2 * count
    else:
        shapes = [*rings, *posts]
        expected = len(posts) * (1 if shape == "discs" else 2)
    assert len(carom.guard_points(shapes)) == expected


@given(scenes)
def test_with_its_guard_points_a_scene_needs_no_more(shapes: list[carom.Shape]) -> None:
    assert places([*shapes, *carom.guard_points(shapes)]) == []


@given(scenes.flatmap(lambda shapes: st.tuples(st.just(shapes), st.permutations(shapes))))
def test_the_order_of_shapes_does_not_matter(orders: tuple[list[carom.Shape], list[carom.Shape]]) -> None:
    found, again = places(orders[0]), places(orders[1])
    assert len(found) == len(again)
    assert all(any(is_near(point, other) for other in again) for point in found)


@given(scenes, motions)
def test_a_rigid_motion_moves_the_points_along(shapes: list[carom.Shape], motion: tuple[float, float, float]) -> None:
    angle, *way = motion
    margins = [shape.distance(end[0]) for shape in shapes for other in shapes for end in ends_of(other)]
    assume(not any(GUARD_TOLERANCE / 1e3 < margin < GUARD_TOLERANCE * 1e3 for margin in margins))
    found = places(shapes)
    for shape in shapes:
        shape.motion = "kinematic"
        shape.rotate((0, 0), angle)
        x, y = shape.position
        shape.position = (x + way[0], y + way[1])
        shape.pivot = (0, 0)
        shape.motion = "static"
    moved = [(x * cos(angle) - y * sin(angle) + way[0], x * sin(angle) + y * cos(angle) + way[1]) for x, y in found]
    again = places(shapes)
    assert len(again) == len(moved)
    assert all(any(is_near(point, other, 1e-9) for other in again) for point in moved)


@given(points, angles, numbers(0.1, 50.0), numbers(0.1, 50.0), numbers(0.1, 3.0), st.booleans())
def test_a_segment_that_runs_into_an_arc_leaves_no_point_at_the_joint(
    start: Vector, angle: float, length: float, radius: float, sweep: float, left: bool
) -> None:
    end = start[0] + length * cos(angle), start[1] + length * sin(angle)
    side = angle + pi / 2 if left else angle - pi / 2
    center = end[0] + radius * cos(side), end[1] + radius * sin(side)
    first = side + pi  # the angle of the joint, seen from the arc's centre
    arc = carom.Arc(center, radius, first, first + sweep) if left else carom.Arc(center, radius, first - sweep, first)
    found = places([carom.Segment(start, end), arc])
    assert not any(is_near(end, point, 1e-6) for point in found)


@given(st.lists(points, min_size=3, max_size=8, unique=True), st.booleans())
def test_a_closed_chain_has_as_many_points_as_bare_corners(corners: list[Vector], closed: bool) -> None:
    pairs = list(zip(corners, corners[1:] + corners[:1], strict=True))
    shapes = [carom.Segment(*pair) for pair in (pairs if closed else pairs[:-1])]
    assume(all(shape.length > 1e-3 for shape in shapes))
    found = places(shapes)
    assert len(found) <= len(corners)
    assert len(found) == len(set(found))
    assert set(found) <= {(float(x) + 0.0, float(y) + 0.0) for x, y in corners}
