"""Balls squeezed between moving and static shapes: the static one holds, the moving one goes over the ball."""

from collections.abc import Sequence
from math import asin, cos, hypot, pi, sin
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Compound, Gate, Point, Segment, World
from carom.constants import LIFT, MOST_AT_ONCE
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import continuous_world


@pytest.mark.parametrize("speed", [0.5, 10.0, 1000.0])
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 1.0])
def test_a_press_goes_over_a_ball_before_a_wall(speed: float, elasticity: float) -> None:
    press = Segment((-3, 0), (3, 0), motion="kinematic", velocity=(0, speed))
    world = continuous_world(Segment((-3, 3), (3, 3)), press)
    ball = world.add(Ball((0.2, 2), 0.5, elasticity=elasticity))
    for _ in range(100):
        world.step(0.06 / speed)
        assert np.isfinite(world.balls.position).all()
        assert ball.position[1] <= 2.5 + 1e-9
    assert world.statistics.squeezed >= 1
    assert world.statistics.stalled == 0


@pytest.mark.usefixtures("step_compiled")
@given(
    st.one_of(st.sampled_from([0.0, 0.5, 0.9, 1.0]), st.floats(0.0, 1.5)), st.floats(0.0, 6.0), st.floats(-1.0, 1.0),
    st.one_of(st.none(), st.floats(2.0, 10.0)), st.floats(0.3, 3.0), st.floats(0.0, 6.3),
)  # fmt: skip
def test_no_weight_pushes_a_ball_through_a_wall(
    elasticity: float, power: float, across: float, fastest: float | None, size: float, turn: float
) -> None:
    out = np.array([cos(turn), sin(turn)])
    # What bounces back faster than it came gets faster without end in a closed room.
    world = continuous_world(Circle((0, 0), 10), max_speed=fastest or (10.0 if elasticity > 1 else None))
    light = world.add(Ball(tuple(9.0 * out), 0.5, mass=1.0, elasticity=elasticity))
    place, velocity = (8.0 - size) * out + across * np.array([-out[1], out[0]]), 2 * out
    heavy = world.add(Ball(tuple(place), size, tuple(velocity), mass=10**power, elasticity=elasticity))
    for _ in range(8):
        with within(10):
            world.step(0.5)
        for ball in (light, heavy):
            assert hypot(*ball.position) <= 10 - ball.radius * (1 - 1e-3)


@pytest.mark.parametrize("spin", [1.0, 100.0, 1000.0])
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 1.0])
def test_a_flipper_presses_a_ball_onto_a_wall(spin: float, elasticity: float) -> None:
    flipper = Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), angular_velocity=spin, turn_limits=(0, 1.5))
    wall = Segment((0.5, 4), (5, 1))
    world = continuous_world(wall, flipper, Circle((0, 0), 12), gravity=(0, -10))
    ball = world.add(Ball((2.5, 1.2), 0.4, elasticity=elasticity))
    for _ in range(300):
        world.step(0.01 / spin)
        x, y = ball.position
        beyond = (x - 0.5) * 3 + (y - 4) * 4.5 > 0
        assert not (beyond and 0.5 < x < 5)
        assert hypot(x, y) < 12
        assert np.isfinite(world.balls.velocity).all()
    assert world.statistics.stalled == 0


def test_between_two_walls_a_ball_stays() -> None:
    world = continuous_world(Segment((-3, 0), (3, 0)), Segment((-3, 0.9), (3, 0.9)), gravity=(0, -10))
    ball = world.add(Ball((0, 0.45), 0.5, velocity=(0.1, 0), elasticity=0.5))
    world.run(2)
    assert np.isfinite(world.balls.position).all()
    assert 0 <= ball.position[1] <= 0.9


def test_a_pin_goes_over_a_ball_in_a_corner() -> None:
    world = continuous_world(
        Segment((-5, 0), (0, 0)), Segment((0, 0), (0, 5)), Point((-3, 0.5), motion="kinematic", velocity=(2, 0))
    )
    ball = world.add(Ball((-0.5, 0.5), 0.5, elasticity=0.5))
    world.run(3)
    assert np.isfinite(world.balls.position).all()
    assert ball.position[0] <= -0.5 + 1e-6
    assert ball.position[1] >= 0.5 - 1e-6
    assert world.statistics.stalled == 0


@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(40))
def test_a_ball_flies_out_of_a_ring_smaller_than_itself_as_if_there_were_none(seed: int) -> None:
    random = Random(seed)
    radius = 10 ** random.uniform(-3, 3)
    ring = radius * (1 - 10 ** random.uniform(-12, -0.1))
    motion = random.choice(({}, {"motion": "kinematic"}, {"motion": "kinematic", "angular_velocity": 1.0}))
    motion = random.choice((motion, {"motion": "kinematic", "velocity": (0.3 * radius, -0.2 * radius)}))
    bend = Circle((0, 0), ring, **motion) if random.random() < 0.5 else Arc((0, 0), ring, 0, 6.2, **motion)
    bend.elasticity = random.choice((0.0, 0.7, 1.0))
    away, angle, speed = ring * random.uniform(0, 0.99), random.uniform(0, 7), 5 * radius
    gravity = random.choice((0, -10 * radius))
    world = continuous_world(bend, gravity=(0, gravity))
    velocity = speed * cos(2 * angle), speed * sin(2 * angle)
    ball = world.add(Ball((away * cos(angle), away * sin(angle)), radius, velocity=velocity))
    with within(10):
        world.step(1e-6)  # it is moved apart as far as may be
        vx, vy = ball.velocity
        hits = world.run(1, 1 / 64)
    assert ball.velocity == pytest.approx((vx, vy + gravity), abs=1e-9 * speed)
    assert len(hits) == 0
    assert world.statistics.squeezed <= 1


def cage(random: Random, room: float, kinds: Sequence[str], **motion: Any) -> list[Shape]:
    """Walls around the origin that leave a ball of radius 1 some room, the distance of each."""
    count, turn = random.choice((3, 4, 5, 6)), random.uniform(0, 2 * pi)
    elasticity, bend = random.choice((0.0, 0.5, 1.0)), random.uniform(1, 6)
    walls: list[Shape] = []
    for k in range(count):
        angle = turn + 2 * pi * k / count
        nx, ny = cos(angle), sin(angle)
        x, y, kind = room * nx, room * ny, random.choice(kinds)
        if kind == "segment":
            walls.append(Segment((x - 3 * ny, y + 3 * nx), (x + 3 * ny, y - 3 * nx), **motion))
        elif kind == "arc":
            walls.append(Arc((x - bend * nx, y - bend * ny), bend, angle - 0.7, angle + 0.7, **motion))
        elif kind == "circle":
            walls.append(Circle((x + bend * nx, y + bend * ny), bend, solid=True, **motion))
        else:
            walls.append(Point((x, y), **motion))
        walls[-1].elasticity = elasticity
    return walls


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_ball_that_is_put_where_it_has_no_place_holds_no_step_up(seed: int) -> None:
    random = Random(seed)
    kinds = random.choice((("segment",), ("arc",), ("circle",), ("point",), ("segment", "arc", "circle", "point")))
    motion = random.choice(({}, {"motion": "kinematic"}, {"motion": "kinematic", "velocity": (0.2, 0.1)}))
    walls = cage(random, random.uniform(0.05, 1.02), kinds, **motion)
    world = continuous_world(*walls, gravity=(0, random.choice((0, -5))))
    velocity = random.choice(((0, 0), (random.uniform(-3, 3), random.uniform(-3, 3))))
    world.add(Ball((random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)), 1.0, velocity=velocity))
    for _ in range(20):
        with within(10):
            world.step(random.choice((1 / 60, 0.1)))
    assert np.isfinite(world.balls.position).all()


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_ball_that_all_but_fills_its_cage_stays_in_it(seed: int) -> None:
    random = Random(seed)
    # In less an elastic ball has so many impacts, each of them real, that a step takes long.
    elasticity, least = random.choice(((0.0, -12), (0.5, -12), (1.0, -4)))
    room = 1.0 + random.choice((0.0, 10 ** random.uniform(least, -1)))
    walls = cage(random, room, ("segment",))
    for wall in walls:
        wall.elasticity = elasticity
    world = continuous_world(*walls, gravity=(0, random.choice((0, -5))))
    speed = random.choice((0, 3))
    ball = world.add(Ball((0, 0), 1.0, velocity=(random.uniform(-speed, speed), random.uniform(-speed, speed))))
    for _ in range(20):
        with within(10):
            world.step(random.choice((1 / 60, 0.1)))
        assert hypot(*ball.position) <= 2 * (room - 1.0) + 1e-6


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(40))
def test_one_of_three_walls_that_close_goes_over_an_elastic_ball(seed: int) -> None:
    random = Random(seed)
    turn, speed = random.uniform(0, 2 * pi), 10 ** random.uniform(-2, 1)
    angles = [turn, turn + pi - random.uniform(1.06, 1.3), turn + pi + random.uniform(1.06, 1.3)]
    walls = []
    for angle in angles:
        nx, ny = cos(angle), sin(angle)
        walls.append(Segment((-2 * nx - 9 * ny, -2 * ny + 9 * nx), (-2 * nx + 9 * ny, -2 * ny - 9 * nx)))
    press = walls.pop(0)
    moving = Segment(press.p0, press.p1, motion="kinematic", velocity=(speed * cos(turn), speed * sin(turn)))
    world = continuous_world(*walls, moving)
    ball = world.add(Ball((0, 0), 1.0, velocity=(random.uniform(-3, 3), random.uniform(-3, 3))))
    for _ in range(200):
        with within(10):
            world.step(0.1 / speed)
        if world.statistics.squeezed:
            break
    assert world.statistics.squeezed == 1
    assert hypot(*ball.velocity) < 1e4


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("turn", [0.0, 1.0, 2.0, 3.0, 4.0, 5.0])
def test_far_from_the_origin_too_a_ball_without_room_ends_its_impacts(turn: float) -> None:
    # A place is rounded there by more than 1e-12 of the ball's radius.
    world = continuous_world(
        Segment((10007.132442514343, 10007.862680975399), (10007.183124830693, 10007.223617619924)),
        Circle((10007.218012682471, 10007.42938081571), 0.3514331988382041),
        Arc((10006.93819853923, 10005.692903765395), 1.694849081893039, 0.7256617681329418, 0.5900217944087307),
        max_impacts=3000,
    )
    vx, vy = 1.3132380397471541, -5.57019954429572
    velocity = vx * cos(turn) - vy * sin(turn), vx * sin(turn) + vy * cos(turn)
    world.add(Ball((10007.43348708267, 10007.452898165466), 0.35, velocity=velocity, elasticity=0.9))
    for _ in range(10):
        world.step(1 / 60)  # or there is an `ImpactLimit`
    assert np.isfinite(world.balls.position).all()


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(12))
def test_no_ball_gets_into_a_cup_with_a_narrower_mouth_that_turns_or_travels(seed: int) -> None:
    random = np.random.default_rng(seed)
    size, radius = 0.9, 0.4
    half = asin((1.0 - 0.1 * random.random()) * radius / size)
    parts = [Arc((0, 0), size, half, 2 * pi - half)]
    parts += [Point((size * cos(turn), size * sin(turn))) for turn in (half, -half)]
    cup = Compound(parts, (-0.6, 0.0))
    cup.angular_velocity = random.uniform(-100.0, 100.0) if seed % 3 else 0.0
    cup.velocity = tuple(random.normal(0.0, 10.0, 2)) if seed % 3 != 1 else (0.0, 0.0)
    world = continuous_world(cup)
    # Each flies towards where the mouth is at some instant.
    away, heading, speed = 3.0, random.uniform(0, 2 * pi, 2000), radius * 10 ** random.uniform(0.0, 4.0, 2000)
    time = (away - size) / speed
    turn, begins = cup.angular_velocity * time, heading + random.normal(0.0, 0.1, 2000)
    pivot = np.array((-0.6, 0.0)) + np.outer(time, cup.velocity)
    mouth = pivot + np.column_stack(((0.6 + size) * np.cos(turn), (0.6 + size) * np.sin(turn)))
    out = np.column_stack((np.cos(begins), np.sin(begins)))
    start = mouth + away * out
    clear = np.hypot(start[:, 0] + 0.6, start[:, 1]) > 0.6 + size + 1.1 * radius
    world.add_balls(start[clear], -(speed[:, None] * out)[clear], radius=radius, collides_with=1, layer=2)
    for _ in range(12):
        world.step(1 / 120)
        arc = cup.shapes[0]
        assert np.hypot(*(world.balls.position - arc.center).T).min() > size * cos(half)
    assert world.statistics.squeezed == 0
    assert world.statistics.collisions > 100


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_ball_is_carried_along_in_a_cage_that_moves_and_that_it_all_but_fills(seed: int) -> None:
    random = Random(seed)
    elasticity, least = random.choice(((0.0, -6), (0.5, -6), (1.0, -3)))
    room = 1.0 + 10 ** random.uniform(least, -1)
    moving = Compound(cage(random, room, ("segment",)), (random.uniform(-2, 2), random.uniform(-2, 2)))
    for wall in moving.shapes:
        wall.elasticity = elasticity
    moving.angular_velocity, moving.velocity = random.choice((0.0, random.gauss(0, 10))), (random.gauss(0, 5), 1.0)
    world = continuous_world(moving, gravity=(0, random.choice((0, -10))))
    world.add(Ball((0, 0), 1.0, velocity=(random.gauss(0, 3), random.gauss(0, 3))))
    for _ in range(10):
        with within(10):
            world.step(1 / 60)
        walls = [wall for wall in moving.shapes if isinstance(wall, Segment)]
        assert min(distance(wall, world.balls.position[0]) for wall in walls) > 1.0 - LIFT
        assert max(distance(wall, world.balls.position[0]) for wall in walls) < 5.0
    assert world.statistics.squeezed == 0


def distance(wall: Segment, place: Sequence[float]) -> float:
    """How far a place is from the line of a wall."""
    (ax, ay), (bx, by), (x, y) = wall.start, wall.end, place
    return abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / hypot(bx - ax, by - ay)


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", range(60))
def test_a_cage_that_moves_and_leaves_a_ball_no_room_holds_no_step_up(seed: int) -> None:
    random = Random(seed)
    room = 1.0 + random.choice((0.0, 10 ** random.uniform(-13, -7), -(10 ** random.uniform(-13, -1))))
    moving = Compound(cage(random, room, ("segment",)), (random.uniform(-2, 2), random.uniform(-2, 2)))
    for wall in moving.shapes:
        # With some room an elastic one has so many impacts, each of them real, that a step takes long.
        wall.elasticity = random.choice((0.0, 0.5, 0.9, 1.0 if room < 1.0 else 0.9))
    moving.angular_velocity, moving.velocity = random.choice((0.0, random.gauss(0, 10))), (random.gauss(0, 5), 1.0)
    world = continuous_world(moving, gravity=(0, random.choice((0, -10))))
    world.add(Ball((0, 0), 1.0, velocity=random.choice(((0, 0), moving.velocity, (random.gauss(0, 3), 9.0)))))
    for _ in range(10):
        with within(10):
            world.step(1 / 60)
    assert np.isfinite(world.balls.position).all()
    # Nor does it go to and fro in the cage for as long as that moves: dear steps could end in time all the same.
    assert world.statistics.held <= MOST_AT_ONCE
    assert world.statistics.full_tests < 50_000


@pytest.mark.compiled
def test_balls_too_close_for_a_turning_arc_that_one_of_them_all_but_fills_hold_up_no_step() -> None:
    # The arc's centre comes to within 1e-9 of a ball's as large, where rounding tells on which side of an end that is.
    arc = Arc((-2, 0.5), 1, pi, 0.0, elasticity=0.0, motion="kinematic", velocity=(1, 0), angular_velocity=-2)
    arc.pivot = (-1, 2)
    gate = Gate((2, -0.5), (2, 0), direction=(-1, 0), motion="kinematic", angular_velocity=10, pivot=(2, -0.5))
    ring = Circle((2, 3), 2, elasticity=0.9, motion="kinematic", velocity=(1, 0), angular_velocity=1, pivot=(0, -2))
    world = World(gravity=(3, -4), rest_speed=0.5)
    world.add(arc, gate, ring)
    places = [
        (0, 1.5),
        (-3, -1),
        (0.5, -1),
        (0, 2),
        (-1.5, 0),
        (-3, 3),
        (0.5, 3),
        (1, 0),
        (3, 0.5),
        (3, -0.5),
        (0.5, 1.5),
    ]
    speeds = [(-1, -3), (1, -3), (2, 1), (1, 2), (-1, 0), (1, 0), (0, 0), (-1, -3), (0, 2), (1, -3), (1, -3), (0, 0)]
    radii, light = {5: 0.05, 8: 0.5}, (0, 6, 9, 10, 11)
    for k, (place, speed) in enumerate(zip([*places, (-2, -1.5)], speeds, strict=True)):
        mass, layer = (1 if k in light else 2 if k == 7 else 100), (2 if k in (0, 3, 11) else 1)
        ball = Ball(place, radii.get(k, 1.0), speed, mass, elasticity=0.0, layer=layer, sensor=k == 6)
        world.add(ball)
    with within(5.0):
        for _ in range(64):
            world.step(1 / 64)
    assert np.isfinite(world.balls.position).all()
