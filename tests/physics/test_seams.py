"""Seams: walls of flush pieces, each with guard points of its own, turn balls as one wall does; none gets through."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, sin, sqrt

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from carom import Arc, Ball, Compound, Gate, Point, Segment, Shape, World, guard_points
from tests.strategies import angles, numbers

Vector = tuple[float, float]

#: Elasticities, speeds in radii a second from slow to half a radius a substep, and directions to the wall's normal.
bounces = st.tuples(
    st.floats(0.0, 1.5), st.floats(0.5, 239.0), st.floats(-1.4, 1.4), numbers(0.05, 3.0), st.integers(8, 40)
)


def turned(place: Vector, angle: float, shift: Vector = (0.0, 0.0)) -> Vector:
    """A place turned about the origin, then shifted."""
    x, y = place
    return x * cos(angle) - y * sin(angle) + shift[0], x * sin(angle) + y * cos(angle) + shift[1]


def guarded(pieces: list[Shape]) -> list[Shape]:
    """Pieces with the points that each of them would need alone: at every seam there is one that nothing needs."""
    return [*(point for piece in pieces for point in guard_points([piece])), *pieces]


def bricks(widths: list[float], angle: float, height: float, elasticity: float) -> list[list[Shape]]:
    """Rectangles in a row, whose upper sides make a wall from -8 to 8 and beyond, each with points of its own."""
    row = []
    x = -8.0
    while x < 8.0:
        width = widths[len(row) % len(widths)]
        corners = [(x, 0.0), (x + width, 0.0), (x + width, -height), (x, -height)]
        ends = [turned(corner, angle) for corner in corners]
        sides: list[Shape] = [
            Segment(a, b, elasticity=elasticity) for a, b in zip(ends, ends[1:] + ends[:1], strict=True)
        ]
        row.append([*sides, *guard_points(sides)])
        x += width
    return row


def first_bounce(world: World, ball: Ball, seconds: float) -> Vector:
    """The velocity of a ball after what it met first in the discrete mode."""
    for _ in range(round(seconds * 60) + 2):
        if len(world.step(1 / 60)):
            break
    return ball.velocity


def thrown(world: World, radius: float, speed: float, slant: float, angle: float, aim: float) -> Ball:
    """A ball that flies towards a wall through the origin, at an angle to its normal, and would touch it at `aim`."""
    vx, vy = speed * radius * sin(slant), -speed * radius * cos(slant)
    start = turned((aim - 0.1 * vx, radius - 0.1 * vy), angle)
    return world.add(Ball(start, radius, velocity=turned((vx, vy), angle)))


def reflected(ball: Vector, angle: float, elasticity: float) -> Vector:
    """What one long wall makes of a velocity."""
    along, across = turned(ball, -angle)
    return turned((along, -elasticity * across), angle)


@pytest.mark.slow
@given(st.lists(st.floats(0.25, 3.0), min_size=1, max_size=4), angles, numbers(-1.0, 1.0), bounces, st.booleans())
@example([1.0], 0.0, 0.02, (1.0, 50.0, 0.7, 0.2, 8), False)
@example([0.25], 0.0, 0.0, (0.0, 34.0, 0.0, 2.0, 9), False)
def test_a_wall_of_bricks_reflects_as_one_wall_does(
    widths: list[float], angle: float, aim: float, bounce: tuple[float, float, float, float, int], compound: bool
) -> None:
    elasticity, speed, slant, radius, substeps = bounce
    world = World(detection="discrete", substeps=substeps, rest_speed=0)
    for brick in bricks(widths, angle, 8.0, elasticity):
        world.add(Compound(brick, (0, 0)) if compound else brick[0])
        if not compound:
            world.add(*brick[1:])
    ball = thrown(world, radius, speed, slant, angle, aim)
    expected = reflected(ball.velocity, angle, elasticity)
    assert first_bounce(world, ball, 0.3) == pytest.approx(expected, abs=1e-9 * speed * radius)


@pytest.mark.slow
@given(st.integers(2, 9), numbers(5.0, 40.0), angles, numbers(0.0, 1.0), bounces, st.booleans())
def test_a_wall_of_arcs_reflects_as_one_arc_does(
    pieces: int, size: float, angle: float, share: float, bounce: tuple[float, float, float, float, int], inside: bool
) -> None:
    elasticity, speed, slant, radius, substeps = bounce
    edges = [angle + 2.0 * k / pieces for k in range(pieces + 1)]
    whole: list[Shape] = [Arc((0, 0), size, edges[0], edges[-1], elasticity=elasticity)]
    cut: list[Shape] = [Arc((0, 0), size, a, b, elasticity=elasticity) for a, b in pairwise(edges)]
    after = []
    for shapes in (guarded(whole), guarded(cut)):
        world = World(detection="discrete", substeps=substeps, rest_speed=0)
        world.add(*shapes)
        towards = angle + 0.5 + share
        direction = towards + slant + (0 if inside else pi)
        touch = size - radius if inside else size + radius
        velocity = speed * radius * cos(direction), speed * radius * sin(direction)
        start = touch * cos(towards) - 0.02 * velocity[0], touch * sin(towards) - 0.02 * velocity[1]
        ball = world.add(Ball(start, radius, velocity=velocity))
        first_bounce(world, ball, 0.1)
        after.append((*ball.velocity, *ball.position))
    assert after[1] == pytest.approx(after[0], abs=1e-9 * (size + speed * radius))


@given(numbers(-0.5, 0.5), bounces)
def test_a_point_anywhere_on_a_wall_turns_no_ball(aim: float, bounce: tuple[float, float, float, float, int]) -> None:
    elasticity, speed, slant, radius, substeps = bounce
    world = World(detection="discrete", substeps=substeps, rest_speed=0)
    world.add(Segment((-99, 0), (99, 0), elasticity=elasticity), Point((0, 0)), Point((0.3 * radius, 1e-4 * radius)))
    ball = thrown(world, radius, speed, slant, 0.0, aim * radius)
    expected = reflected(ball.velocity, 0.0, elasticity)
    assert first_bounce(world, ball, 0.3) == pytest.approx(expected, abs=1e-9 * speed * radius)


def test_the_post_of_a_flipper_turns_no_ball_that_the_flipper_meets() -> None:
    world = World(detection="discrete")
    world.add(Point((0, 0)), Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0)))
    ball = world.add(Ball((0.05, 1.0), 0.2, velocity=(0, -10)))
    assert first_bounce(world, ball, 1) == (0.0, 10.0)


@pytest.mark.parametrize("wall", [{"sensor": True}, {"can_collide": False}, {"layer": 2, "collides_with": 2}])
def test_a_wall_that_the_ball_does_not_meet_leaves_it_to_the_point(wall: dict[str, int]) -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Point((0, 0)), Segment((0, 0), (4, 0), **wall))  # type: ignore[arg-type]
    ball = world.add(Ball((0.1, 0.25), 0.2, velocity=(0, -6)))
    world.step(1 / 60)
    assert ball.velocity[0] > 1


def test_so_does_a_gate_that_lets_the_ball_by() -> None:
    for height, sideways in ((0.25, False), (-0.25, True)):
        world = World(detection="discrete", substeps=1)
        world.add(Point((0, 0)), Gate((0, 0), (4, 0), direction=(0, 1)))
        ball = world.add(Ball((0.1, height), 0.2, velocity=(0, -24 * height)))
        world.step(1 / 60)
        assert (abs(ball.velocity[0]) > 1) is sideways


def test_a_ball_that_passes_a_wall_still_meets_the_point_on_it() -> None:
    world = World(detection="discrete", substeps=8)
    world.add(Segment((0, 0), (4, 0)))
    ball = world.add(Ball((-0.3, 0.05), 0.2, velocity=(6, 0)))
    world.run(0.1)
    assert ball.velocity == (6.0, 0.0)  # it came over the bare end
    world.add(Point((1.5, 0)))
    world.run(0.3)
    assert ball.velocity[0] < 0


@given(st.floats(0.1, 3.0), st.floats(-1.0, 1.0), angles, st.integers(8, 32))
def test_corners_and_cusps_are_met_by_their_points(open_by: float, aim: float, angle: float, substeps: int) -> None:
    edges = [turned((-4 * cos(half), 4 * sin(half)), angle) for half in (open_by / 2, -open_by / 2)]
    walls: list[Shape] = [Segment((0, 0), edge) for edge in edges]
    world = World(detection="discrete", substeps=substeps)
    world.add(*guarded(walls))
    ball = world.add(Ball(turned((1, 0.2 * aim), angle), 0.25, velocity=turned((-20, 0), angle)))
    world.run(0.2)
    x, y = turned(ball.position, -angle)
    assert x > 0 or abs(atan2(y, -x)) > open_by / 2


def fall_into_joint(detection: str, bend: float, tilt: float, share: float, points: bool, substeps: int) -> bool:
    """Whether a ball that falls along a line between the slabs of two walls, exactly at their joint, gets through."""
    joint = (17.3 * sin(tilt), 6.1 * cos(tilt * 3))
    walls: list[Shape] = [
        Segment(turned((-3, 0), tilt, joint), joint),
        Segment(joint, turned((3, 0), tilt - bend, joint)),
    ]
    world = World(detection=detection, substeps=substeps)  # type: ignore[arg-type]
    world.add(*walls, *(guard_points(walls) if points else []))
    up = turned((0, 1), tilt - share * bend)
    start = joint[0] + 0.3 * up[0], joint[1] + 0.3 * up[1]
    ball = world.add(Ball(start, 0.2, velocity=(-up[0], -up[1])))
    world.run(1.0, dt=0.25)
    return (ball.position[0] - joint[0]) * up[0] + (ball.position[1] - joint[1]) * up[1] < 0


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@given(
    st.one_of(st.just(0.0), numbers(1e-16, 1e-9), st.floats(-12, -1).map(lambda power: 10.0**power)),
    angles,
    st.floats(0, 1),
    st.integers(3, 9),
)
@example(1e-7, 0.4, 0.5, 4)
def test_no_ball_falls_through_a_joint_that_has_the_points_it_needs(
    detection: str, bend: float, tilt: float, share: float, substeps: int
) -> None:
    assert not fall_into_joint(detection, bend, tilt, share, True, substeps)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@given(numbers(1e-16, 1e-9), angles, st.floats(0, 1), st.integers(3, 9))
def test_nor_through_one_that_needs_none(detection: str, bend: float, tilt: float, share: float, substeps: int) -> None:
    assert not fall_into_joint(detection, bend, tilt, share, False, substeps)


def highest_hop(length: float, digits: int, speed: float, detection: str) -> float:
    """How high, in radii, a ball hops that rolls down a slope of pieces with rounded corners."""
    tilt, radius = -0.3, 0.2
    places = [turned((length * k, 0), tilt) for k in range(round(12 / length))]
    corners = [(round(x, digits), round(y, digits)) for x, y in places]
    floor: list[Shape] = [Segment(a, b, elasticity=0.6) for a, b in pairwise(corners)]
    world = World(gravity=(0, -9.81), detection=detection)  # type: ignore[arg-type]
    world.add(*floor, *guard_points(floor))
    ball = world.add(Ball(turned((0.5, radius), tilt), radius, velocity=turned((speed, 0), tilt)))
    pull = 9.81 * sin(-tilt)
    free = (sqrt(speed * speed + 2 * pull * 10) - speed) / pull  # the time that the way takes on one long slope
    heights = []
    for _ in range(round(60 * free)):
        world.step(1 / 60)
        heights.append(turned(ball.position, -tilt)[1] / radius - 1)
    assert turned(ball.position, -tilt)[0] == pytest.approx(10.5, abs=0.3)
    assert min(heights) > -0.1
    return max(heights)


@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("speed", [1.0, 20.0])
@pytest.mark.parametrize(("length", "digits"), [(0.02, 4), (0.1, 4), (0.1, 3), (0.01, 6)])
def test_a_ball_rolls_over_a_map_whose_corners_were_rounded(
    length: float, digits: int, speed: float, detection: str
) -> None:
    # Pieces of 0.1 rounded to 1e-3 may turn by 0.02 rad at a joint, or a little more where both ends lie askew: at 20
    # the hop that physics asks for is (20 * 0.02)² / 2g, 0.04 radii and more. The discrete mode overlooks some of it.
    most = 0.05 if detection == "discrete" else 0.1
    assert highest_hop(length, digits, speed, detection) < most


@pytest.mark.slow
def test_bricks_at_default_substeps_do_not_turn_the_ball_of_the_report() -> None:
    for aim in (-0.09, -0.03, 0.0, 0.05, 0.1):
        for slant in (-0.6, 0.0, 0.3):
            world = World(detection="discrete")
            for brick in bricks([1.0], 0.0, 1.0, 1.0):
                world.add(*brick)
            ball = world.add(
                Ball((aim - sin(slant), 0.2 + cos(slant)), 0.2, velocity=(10 * sin(slant), -10 * cos(slant)))
            )
            after = first_bounce(world, ball, 0.3)
            assert after == pytest.approx((10 * sin(slant), 10 * cos(slant)), abs=1e-12)
            assert hypot(*after) == pytest.approx(10)
