"""Laws of guard points: every bare end has one, none is needless, and neither order nor place matters."""

from math import atan2, cos, hypot, pi, sin

from hypothesis import assume, given
from hypothesis import strategies as st

import carom
from carom.constants import GUARD_ANGLE_TOLERANCE, GUARD_TOLERANCE
from tests.strategies import angles, arcs, circles, motions, numbers, points, segments

Vector = tuple[float, float]
End = tuple[Vector, float, carom.Shape]

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


scenes = st.one_of(grids(), st.lists(st.one_of(walls, covers), min_size=1, max_size=6))


def places(shapes: list[carom.Shape]) -> list[Vector]:
    """Where the guard points of shapes stand."""
    return [point.position for point in carom.guard_points(shapes)]


def ends_of(shape: carom.Shape) -> list[End]:
    """Each end of a shape with the direction in which it goes on, by the arctangent."""
    if isinstance(shape, carom.Segment):
        direction = atan2(shape.p1[1] - shape.p0[1], shape.p1[0] - shape.p0[0])
        return [(shape.p0, direction + pi, shape), (shape.p1, direction, shape)]
    if isinstance(shape, carom.Arc):
        return [(shape.p0, shape.start_angle - pi / 2, shape), (shape.p1, shape.end_angle + pi / 2, shape)]
    return []


def is_near(a: Vector, b: Vector, tolerance: float = GUARD_TOLERANCE) -> bool:
    """Whether two points are one place."""
    return hypot(a[0] - b[0], a[1] - b[1]) <= tolerance


def needs_guard(end: End, shapes: list[carom.Shape]) -> bool:
    """What the definition says of one end, shape by shape."""
    place = end[0]
    neighbours = [other for shape in shapes for other in ends_of(shape) if is_near(place, other[0])]
    for _, first, one in neighbours:
        for _, second, other in neighbours:
            bend = abs((first - second) % (2 * pi) - pi)
            if one is not other and bend <= GUARD_ANGLE_TOLERANCE:
                return False
    for shape in shapes:
        if any(shape is other[2] for other in neighbours):
            continue
        if shape.distance(place) <= GUARD_TOLERANCE:
            return False
        if isinstance(shape, carom.Circle) and shape.solid and shape.contains(place):
            return False
    return True


@given(scenes)
def test_they_are_what_the_definition_says(shapes: list[carom.Shape]) -> None:
    found = places(shapes)
    for shape in shapes:
        for end in ends_of(shape):
            assert any(is_near(end[0], point) for point in found) == needs_guard(end, shapes)
    for point in found:
        assert any(is_near(end[0], point) for shape in shapes for end in ends_of(shape))
        assert sum(is_near(point, other) for other in found) == 1


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
