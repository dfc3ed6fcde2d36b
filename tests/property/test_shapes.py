"""Laws of shapes and balls as users hold them: contacts, responses, turns, and state that is always in step."""

from math import hypot, pi

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import carom
from tests import naive
from tests.kernel_calls import advance_pose
from tests.strategies import (
    Figure,
    angles,
    arcs,
    balls,
    coordinates,
    elasticities,
    figures,
    masses,
    meetings,
    numbers,
    points,
    segments,
    vectors,
)
from tests.worlds import row_bits

Vector = tuple[float, float]
Numbers = tuple[float, float, float]

#: Lengths; the figures of these tests are within 200 of the origin.
ROUNDING = 1e-12
CLEAR = 1e-9

#: How far a ball is kept from where a normal turns about, so that places off by rounding give normals off by 1e-9.
STEADY = 1e-4

spins = numbers(-10.0, 10.0)
turns = st.lists(st.tuples(points, numbers(-20.0, 20.0)), min_size=1, max_size=5)


def made(figure: Figure, **options: object) -> carom.Shape:
    """The shape of a figure."""
    kind, given_numbers = figure
    first, rest = given_numbers[:2], given_numbers[2:]
    if kind == "point":
        return carom.Point(first, **options)
    if kind == "segment":
        return carom.Segment(first, rest, **options)
    if kind == "arc":
        return carom.Arc(first, *rest, **options)
    return carom.Circle(first, rest[0], kind == "disc", **options)


def kinematic(figure: Figure, pivot: Vector, spin: float, velocity: Vector) -> carom.Shape:
    """The shape of a figure, turning and travelling."""
    return made(figure, motion="kinematic", pivot=pivot, angular_velocity=spin, velocity=velocity)


def apart(a: Vector, b: Vector) -> float:
    """The distance between two points."""
    return hypot(a[0] - b[0], a[1] - b[1])


# -- contacts ----------------------------------------------------------------------------------------------------------


@given(meetings(), vectors)
def test_contacts_are_those_of_the_slow_twin(meeting: tuple[Figure, Numbers], velocity: Vector) -> None:
    figure, (x, y, radius) = meeting
    assume(naive.margin(figure, x, y, radius) > STEADY)
    contact = made(figure).detect(carom.Ball((x, y), radius, velocity))
    expected = naive.find_overlap(figure, x, y, radius)
    assert (contact is None) == (expected is None)
    if contact is not None:
        found = (*contact.point, *contact.normal, contact.setback)
        assert found == pytest.approx(expected, rel=1e-9, abs=1e-9)
        assert contact.speed == pytest.approx(hypot(*velocity))


@given(meetings(), vectors, points, spins, vectors)
def test_the_surface_speed_is_that_of_a_small_step(
    meeting: tuple[Figure, Numbers], velocity: Vector, pivot: Vector, spin: float, travel: Vector
) -> None:
    figure, (x, y, radius) = meeting
    shape = kinematic(figure, pivot, spin, travel)
    contact = shape.detect(carom.Ball((x, y), radius, velocity))
    assume(contact is not None)
    assert contact is not None
    h = 1e-6
    moved = carom.rotate_point(contact.point, pivot, spin * h)
    surface = [(moved[k] - contact.point[k]) / h + travel[k] for k in (0, 1)]
    expected = hypot(velocity[0] - surface[0], velocity[1] - surface[1])
    assert contact.speed == pytest.approx(expected, rel=1e-3, abs=0.1)


@given(meetings(), vectors, points, elasticities)
def test_a_flipper_at_rest_is_a_wall_to_the_bit(
    meeting: tuple[Figure, Numbers], velocity: Vector, pivot: Vector, elasticity: float
) -> None:
    figure, (x, y, radius) = meeting
    wall, flipper = made(figure), made(figure, motion="kinematic", pivot=pivot)
    first, second = (carom.Ball((x, y), radius, velocity, elasticity=elasticity) for _ in range(2))
    contact, other = wall.detect(first), flipper.detect(second)
    assert (contact is None) == (other is None)
    if contact is not None and other is not None:
        first.respond(contact)
        second.respond(other)
    assert row_bits(first) == row_bits(second)


# -- responses ---------------------------------------------------------------------------------------------------------


@given(meetings(), vectors, points, spins, elasticities, st.sampled_from(("normal", "total")))
def test_a_response_moves_the_ball_out_and_makes_it_leave(
    meeting: tuple[Figure, Numbers], velocity: Vector, pivot: Vector, spin: float, e: float, restitution: str
) -> None:
    figure, (x, y, radius) = meeting
    shape = kinematic(figure, pivot, spin, (0.0, 0.0))
    ball = carom.Ball((x, y), radius, velocity, elasticity=e)
    contact = shape.detect(ball)
    assume(contact is not None and naive.margin(figure, x, y, radius) > CLEAR)
    assert contact is not None
    surface = shape.surface_velocity(contact.point)
    before = along(velocity, surface, contact.normal)
    ball.respond(contact, restitution)
    after = along(ball.velocity, surface, contact.normal)
    assert apart(ball.position, contact.point) == pytest.approx(radius, rel=1e-12, abs=ROUNDING)
    expected = -e * before if before < 0.0 else before
    assert after == pytest.approx(expected, rel=1e-11, abs=1e-10)


def along(velocity: Vector, surface: Vector, normal: Vector) -> float:
    """The part of a relative velocity along a normal."""
    return (velocity[0] - surface[0]) * normal[0] + (velocity[1] - surface[1]) * normal[1]


@given(meetings(), vectors)
def test_an_elastic_static_wall_keeps_the_speed(meeting: tuple[Figure, Numbers], velocity: Vector) -> None:
    figure, (x, y, radius) = meeting
    ball = carom.Ball((x, y), radius, velocity)
    contact = made(figure).detect(ball)
    assume(contact is not None)
    assert contact is not None
    ball.respond(contact)
    assert hypot(*ball.velocity) == pytest.approx(hypot(*velocity), rel=1e-14)


@pytest.mark.slow
@given(balls, balls, vectors, vectors, masses, masses, elasticities)
def test_pairs_keep_their_momentum_and_their_centre_of_mass(
    one: Numbers, other: Numbers, v1: Vector, v2: Vector, m1: float, m2: float, e: float
) -> None:
    first = carom.Ball(one[:2], one[2], v1, m1, elasticity=e)
    second = carom.Ball(other[:2], other[2], v2, m2)
    contact = first.detect(second)
    assume(contact is not None)
    assert contact is not None
    before = carom.Ball(one[:2], one[2], v1, m1), carom.Ball(other[:2], other[2], v2, m2)
    second.respond(contact)
    scale = m1 * (1 + hypot(*v1)) + m2 * (1 + hypot(*v2))
    for k in (0, 1):
        momentum = [m1 * pair[0].velocity[k] + m2 * pair[1].velocity[k] for pair in (before, (first, second))]
        assert momentum[1] == pytest.approx(momentum[0], rel=0.0, abs=1e-13 * scale)
        middle = [
            (m1 * pair[0].position[k] + m2 * pair[1].position[k]) / (m1 + m2) for pair in (before, (first, second))
        ]
        assert middle[1] == pytest.approx(middle[0], rel=0.0, abs=ROUNDING)
    assert apart(first.position, second.position) == pytest.approx(one[2] + other[2], rel=1e-12)
    energy = [
        m1 * hypot(*pair[0].velocity) ** 2 + m2 * hypot(*pair[1].velocity) ** 2 for pair in (before, (first, second))
    ]
    if e <= 1.0:
        assert energy[1] <= energy[0] * (1 + 1e-12)
    assert along(second.velocity, first.velocity, contact.normal) >= -1e-12 * (hypot(*v1) + hypot(*v2))


@given(balls, balls, vectors, vectors)
def test_a_pair_may_be_taken_in_either_order(one: Numbers, other: Numbers, v1: Vector, v2: Vector) -> None:
    assume(apart(one[:2], other[:2]) > CLEAR)
    pairs = [(carom.Ball(one[:2], one[2], v1), carom.Ball(other[:2], other[2], v2)) for _ in range(2)]
    forth, back = pairs[0][0].detect(pairs[0][1]), pairs[1][1].detect(pairs[1][0])
    assert (forth is None) == (back is None)
    if forth is None or back is None:
        return
    assert forth.normal == pytest.approx((-back.normal[0], -back.normal[1]), abs=1e-15)
    pairs[0][1].respond(forth)
    pairs[1][0].respond(back)
    for k in (0, 1):
        assert pairs[0][k].velocity == pytest.approx(pairs[1][k].velocity, rel=1e-12, abs=1e-10)
        assert pairs[0][k].position == pytest.approx(pairs[1][k].position, rel=1e-12, abs=ROUNDING)


# -- turns -------------------------------------------------------------------------------------------------------------


@given(figures, turns)
def test_only_the_last_turn_counts(figure: Figure, several: list[tuple[Vector, float]]) -> None:
    shape, fresh = made(figure, motion="kinematic"), made(figure, motion="kinematic")
    for pivot, angle in several:
        shape.rotate(pivot, angle)
    fresh.rotate(*several[-1])
    assert row_bits(shape) == row_bits(fresh)
    shape.reset()
    assert (shape.position, shape.aabb) == (made(figure).position, made(figure).aabb)


@pytest.mark.slow
@given(meetings(), vectors, points, angles)
def test_turning_shape_and_ball_turns_the_contact(
    meeting: tuple[Figure, Numbers], velocity: Vector, pivot: Vector, angle: float
) -> None:
    figure, (x, y, radius) = meeting
    assume(naive.margin(figure, x, y, radius) > STEADY)
    shape = made(figure, motion="kinematic")
    contact = shape.detect(carom.Ball((x, y), radius, velocity))
    shape.rotate(pivot, angle)
    ball = carom.Ball(carom.rotate_point((x, y), pivot, angle), radius, carom.rotate_point(velocity, (0, 0), angle))
    turned = shape.detect(ball)
    assert (contact is None) == (turned is None)
    if contact is not None and turned is not None:
        assert turned.point == pytest.approx(carom.rotate_point(contact.point, pivot, angle), abs=CLEAR)
        assert turned.normal == pytest.approx(carom.rotate_point(contact.normal, (0, 0), angle), abs=CLEAR)
        assert turned.setback == pytest.approx(contact.setback, abs=CLEAR)


@given(segments(), points, numbers(-20.0, 20.0))
def test_a_segments_ends_are_always_in_order(ends: tuple[float, ...], pivot: Vector, angle: float) -> None:
    segment = carom.Segment(ends[:2], ends[2:], motion="kinematic")
    length = segment.length
    segment.rotate(pivot, angle)
    assert segment.p0 <= segment.p1
    assert segment.length == pytest.approx(length, rel=1e-9)
    assert hypot(*segment.t0) == pytest.approx(1.0, abs=4e-16)
    assert segment.normal == carom.perp(segment.t0)
    assert segment.t1 == (0.0 - segment.t0[0], 0.0 - segment.t0[1])


@given(segments(), points, numbers(-20.0, 20.0))
def test_a_gate_never_flips(ends: tuple[float, ...], pivot: Vector, angle: float) -> None:
    gate = carom.Gate(ends[:2], ends[2:], motion="kinematic")
    expected = carom.rotate_point(gate.direction, (0, 0), angle)
    gate.rotate(pivot, angle)
    assert gate.direction == pytest.approx(expected, abs=1e-15)


@given(arcs())
def test_an_arc_and_its_complement_are_the_circle(arc: tuple[float, ...]) -> None:
    shape = carom.Arc(arc[:2], *arc[2:])
    rest = shape.complement()
    assert shape.length + rest.length == pytest.approx(2 * pi * shape.radius)
    assert (rest.p0, rest.p1) == (shape.p1, shape.p0)
    assert rest.t0 == pytest.approx((-shape.t1[0], -shape.t1[1]), abs=1e-15)


@given(figures, points)
def test_the_closest_point_is_on_the_shape_and_in_its_box(figure: Figure, p: Vector) -> None:
    shape = made(figure)
    near = shape.closest_point(p)
    box = shape.aabb
    assert box.left - ROUNDING <= near[0] <= box.right + ROUNDING
    assert box.bottom - ROUNDING <= near[1] <= box.top + ROUNDING
    assert shape.distance(near) <= ROUNDING
    assert shape.distance(p) == pytest.approx(apart(p, near))


# -- state in step -----------------------------------------------------------------------------------------------------


@pytest.mark.slow
@given(arcs(), arcs(), angles)
def test_setting_an_arc_piece_by_piece_is_making_it_anew(
    arc: tuple[float, ...], other: tuple[float, ...], turn: float
) -> None:
    shape = carom.Arc(arc[:2], *arc[2:], motion="kinematic")
    shape.rotate((0, 0), turn)
    shape.radius = other[2]
    shape.center = other[:2]
    shape.set_angles(*other[3:])
    assert row_bits(shape) == row_bits(carom.Arc(other[:2], *other[2:], motion="kinematic", pivot=shape.pivot))


@given(segments(), segments(), angles)
def test_setting_a_segment_piece_by_piece_is_making_it_anew(
    ends: tuple[float, ...], other: tuple[float, ...], turn: float
) -> None:
    shape = carom.Segment(ends[:2], ends[2:], motion="kinematic")
    shape.rotate((0, 0), turn)
    shape.set_ends(other[2:], other[:2])
    assert row_bits(shape) == row_bits(carom.Segment(other[:2], other[2:], motion="kinematic", pivot=shape.pivot))


@given(figures, points, spins, vectors, st.integers(1, 30))
def test_substeps_go_where_the_orientation_says(
    figure: Figure, pivot: Vector, spin: float, velocity: Vector, count: int
) -> None:
    shape = kinematic(figure, pivot, spin, velocity)
    for _ in range(count):
        advance_pose(shape._row, 0.01)
    assert shape.orientation == pytest.approx(spin * 0.01 * count, rel=1e-12)
    turned = made(figure, motion="kinematic")
    turned.rotate(pivot, shape.orientation)
    moved = [turned.position[k] + shape.pivot[k] - pivot[k] for k in (0, 1)]
    assert shape.position == pytest.approx(moved, rel=1e-12, abs=1e-11)


@given(figures, points, spins.filter(bool), numbers(0.0, 2.0), st.integers(1, 40))
def test_no_stop_is_ever_passed(figure: Figure, pivot: Vector, spin: float, reach: float, count: int) -> None:
    shape = made(figure, motion="kinematic", pivot=pivot, angular_velocity=spin, turn_limits=(-reach, reach))
    for _ in range(count):
        advance_pose(shape._row, 0.05)
        assert -reach <= shape.orientation <= reach
    if abs(spin) * 0.05 * count > reach * (1 + 1e-9):
        assert (abs(shape.orientation), shape.angular_velocity) == (reach, 0.0)


@pytest.mark.slow
@given(st.lists(figures, min_size=1, max_size=4), points, points, angles)
def test_a_compound_is_rigid(parts: list[Figure], pivot: Vector, other: Vector, angle: float) -> None:
    compound = carom.Compound([made(part) for part in parts], pivot)
    shapes = (compound.center_point, *compound.shapes)
    before = [[apart(a.position, b.position) for a in shapes] for b in shapes]
    compound.rotate(other, angle)
    after = [[apart(a.position, b.position) for a in shapes] for b in shapes]
    for row, expected in zip(after, before, strict=True):
        assert row == pytest.approx(expected, rel=1e-12, abs=1e-11)
    assert {(part.orientation, part.pivot) for part in shapes} == {(angle, other)}
    compound.reset()
    assert [part.position for part in compound.shapes] == [made(part).position for part in parts]


@given(coordinates, coordinates, numbers(0.0, 10.0), vectors, vectors)
def test_a_free_ball_falls_as_galilei_says(x: float, y: float, dt: float, velocity: Vector, gravity: Vector) -> None:
    ball = carom.Ball((x, y), 1, velocity)
    ball.move(dt, gravity)
    for k, start in enumerate((x, y)):
        expected = start + velocity[k] * dt + gravity[k] * dt * dt / 2
        assert ball.position[k] == pytest.approx(expected, rel=1e-13, abs=1e-10)
        assert ball.velocity[k] == pytest.approx(velocity[k] + gravity[k] * dt, rel=1e-13, abs=1e-10)
