"""Contacts that last in the continuous mode: balls that rest, roll and slide, and leave when they are pulled off."""

from copy import deepcopy
from functools import partial
from itertools import pairwise
from math import cos, hypot, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, World, guard_points
from carom.rows.relation import LASTING
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import box, continuous_world, energy, guarded

G = 10.0

#: Worlds with gravity.
falling_world = partial(continuous_world, gravity=(0.0, -G))


def held(world: World) -> int:
    """How many contacts last."""
    used = world._arrays.relations[: int(world._states[0]["relations_high"])]
    return int(((used["kind"] == LASTING) & (used["ball"] >= 0)).sum())


PLACES: dict[str, tuple[list[Shape], tuple[float, float], list[tuple[float, float]]]] = {
    "floor": ([Segment((-5, 0), (5, 0))], (0.3, 3), [(0.3, 0.5)]),
    "corner": ([Segment((-5, 3), (0, 0)), Segment((0, 0), (5, 3))], (0.4, 3), [(0, 0.5 * hypot(1, 0.6))]),
    "two arcs": ([Arc((-1, 0), 1, 0, pi), Arc((1, 0), 1, 0, pi), Point((0, 0))], (0.02, 1.3), [(0, sqrt(1.25))]),
    "two points": ([Point((-0.3, 0)), Point((0.3, 0))], (0.01, 0.6), [(0, 0.4)]),
    "two circles": ([Circle((-0.4, 0), 0.1), Circle((0.4, 0), 0.1)], (0.01, 0.6), [(0, sqrt(0.36 - 0.16))]),
}


@pytest.mark.compiled
@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("elasticity", [0.0, 0.3, 0.6])
def test_a_dropped_ball_comes_to_rest_where_it_is_held(place: str, elasticity: float) -> None:
    shapes, start, (rest,) = PLACES[place]
    world = falling_world(*deepcopy(shapes))
    ball = world.add(Ball(start, 0.5, elasticity=elasticity))
    world.run(40, dt=1 / 30)
    assert len(world.run(2, dt=1 / 30)) == 0
    assert ball.position == pytest.approx(rest, abs=1e-9)
    assert ball.velocity == pytest.approx((0, 0), abs=1e-9)
    assert held(world) >= 1
    assert world.statistics.stalled == 0


@pytest.mark.compiled
@pytest.mark.parametrize("shape", [Arc((0, 0), 2, pi, 0), Circle((0, 0), 2)], ids=repr)
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
def test_a_ball_swings_in_a_bowl_with_the_same_energy_for_ever(shape: Shape, elasticity: float) -> None:
    world = falling_world(deepcopy(shape))
    radius, away = 0.3, 1.7
    ball = world.add(Ball((away * sin(1), -away * cos(1)), radius, elasticity=elasticity))
    before = energy(world)
    swings = 0
    was = ball.velocity[0]
    for _ in range(1500):
        tests = world.statistics.full_tests
        assert len(world.step(1 / 60)) == 0
        assert world.statistics.full_tests - tests <= 4 * 64 + 4
        assert energy(world) == pytest.approx(before, rel=1e-9)
        assert hypot(*ball.position) == pytest.approx(away, abs=1e-3 * radius)
        swings += was * ball.velocity[0] < 0
        was = ball.velocity[0]
    assert swings >= 15
    assert held(world) == 1
    assert world.statistics.stalled == 0


@pytest.mark.compiled
def test_the_period_of_a_small_swing_is_that_of_a_pendulum() -> None:
    world = falling_world(Circle((0, 0), 2))
    ball = world.add(Ball((1.7 * sin(1e-3), -1.7 * cos(1e-3)), 0.3, elasticity=0.5))
    period = 2 * pi * sqrt(1.7 / G)
    world.run(10 * period, dt=period / 100)
    assert ball.position[0] == pytest.approx(1.7 * sin(1e-3), rel=1e-4)
    assert abs(ball.velocity[0]) < 1e-3 * 1e-3 * sqrt(G * 1.7)


@pytest.mark.parametrize("substeps", [1, pytest.param(4, marks=pytest.mark.compiled)])
def test_a_ball_circles_without_gravity_at_its_speed(substeps: int) -> None:
    world = falling_world(Circle((1, 2), 2), gravity=(0, 0), substeps=substeps)
    ball = world.add(Ball((1 + 1.7, 2), 0.3, velocity=(0, 3), elasticity=0.5))
    turned = 3 / 1.7 * 10
    assert len(world.run(10)) == 0
    assert hypot(*ball.velocity) == pytest.approx(3, rel=1e-12)
    place = (1 + 1.7 * cos(turned), 2 + 1.7 * sin(turned))
    assert ball.position == pytest.approx(place, abs=1e-5)


@pytest.mark.compiled
@pytest.mark.parametrize("first", [1e-4, 0.3])
def test_a_ball_that_slides_down_a_dome_leaves_it_at_two_thirds_of_its_height(first: float) -> None:
    world = falling_world(Circle((0, 0), 2, solid=True))
    ball = world.add(Ball((2.5 * sin(first), 2.5 * cos(first)), 0.5, elasticity=0.5))
    before = energy(world)
    world.step(1e-4)
    while held(world):
        at = ball.position[1] / hypot(*ball.position)
        assert len(world.step(1e-4 if at < 0.7 else 2e-3)) == 0
    assert ball.position[1] / hypot(*ball.position) == pytest.approx(2 / 3 * cos(first), abs=2e-4)
    assert energy(world) == pytest.approx(before, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(4))
def test_whatever_a_ball_rolls_off_it_leaves_in_the_end(seed: int) -> None:
    random = np.random.default_rng(seed)
    for _ in range(200):
        size, radius, pull = 10.0 ** random.uniform((-1, -1, -1), (1, 1, 2))
        center, angle = tuple(random.uniform(-5, 5, 2)), random.uniform(-0.5, 0.5)
        elasticity = random.choice([0.0, 0.3, 0.5, 0.9, 1.0])
        shape: Shape = Circle(center, size, elasticity=elasticity)
        kind = random.integers(3)
        if kind == 1:
            shape, size = Point(center, elasticity=elasticity), 0.0
        elif kind == 2:
            shape.motion, shape.angular_velocity = "kinematic", random.uniform(-1, 1)
        world = continuous_world(shape, gravity=(0.0, -pull))
        away = size + radius
        ball = world.add(Ball((center[0] + away * sin(angle), center[1] + away * cos(angle)), radius))
        duration = 6 * sqrt(away / pull)
        with within(20):
            world.run(duration, dt=duration / 60)
        assert hypot(ball.position[0] - center[0], ball.position[1] - center[1]) >= away * (1 - 1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize(("speed", "round_it_goes"), [(5.0, False), (8.9, False), (9.45, False), (9.55, True)])
def test_a_loop_is_run_through_by_a_ball_that_is_fast_enough(speed: float, round_it_goes: bool) -> None:
    rho = 1.8
    assert (speed * speed >= 5 * G * rho) == round_it_goes
    world = falling_world(Arc((0, 2), 2, -pi / 2, pi), Segment((-6, 0), (0, 0)))
    ball = world.add(Ball((-1, 0.2), 0.2, velocity=(speed, 0), elasticity=0.5))
    before = energy(world)
    highest = 0.0
    left = (0.0, 0.0)
    while ball.position[0] > -1.79 and world.time < 3:
        assert len(world.step(1 / 600)) == 0
        highest = max(highest, ball.position[1])
        if not held(world) and ball.position[0] > 0 and ball.position[1] > 2:
            left = (ball.position[1] - 2, energy(world) - before)
            break
    assert energy(world) == pytest.approx(before, rel=1e-9)
    if round_it_goes:
        assert highest == pytest.approx(2 + rho, abs=1e-4)
        assert left == (0.0, 0.0)
    elif speed > sqrt(2 * G * rho):
        # v² = g·ρ·sin of the height's angle, and v² = v0² - 2g·(ρ + height).
        assert left[0] == pytest.approx((speed * speed - 2 * G * rho) / (3 * G), abs=0.01)
    else:
        assert highest == pytest.approx(0.2 + speed * speed / (2 * G), abs=1e-4)


@pytest.mark.parametrize("guarded", [False, True])
def test_a_ball_rolls_off_the_end_of_a_floor(guarded: bool) -> None:
    floor = Segment((-5, 0), (0, 0))
    world = falling_world(floor, *(guard_points([floor]) if guarded else []))
    ball = world.add(Ball((-2, 0.5), 0.5, velocity=(1, 0), elasticity=0.5))
    before = energy(world)
    world.run(1.9)
    assert ball.position == pytest.approx((-0.1, 0.5), abs=1e-9)
    assert ball.velocity == pytest.approx((1, 0), abs=1e-9)
    assert len(world.run(0.6)) == 0
    assert energy(world) == pytest.approx(before, rel=1e-9)
    if not guarded:
        assert ball.position == pytest.approx((0.5, 0.5 - 0.5 * G * 0.25), abs=1e-7)
    else:
        assert ball.position[0] > 0.5


@pytest.mark.compiled
@pytest.mark.parametrize("gravity", [(0.0, -G), (0.0, 0.0)])
def test_a_thousand_tangent_pieces_are_one_way(gravity: tuple[float, float]) -> None:
    pieces: list[Shape] = [Segment((0.01 * k, 0), (0.01 * (k + 1), 0)) for k in range(1000)]
    world = falling_world(*pieces, gravity=gravity)
    ball = world.add(Ball((0.005, 0.5), 0.5, velocity=(2, 0), elasticity=0.5))
    assert len(world.run(4.75)) == 0
    assert ball.position == pytest.approx((9.505, 0.5), abs=1e-9)
    assert ball.velocity == pytest.approx((2, 0), abs=1e-9)
    assert world.statistics.stalled == 0


@pytest.mark.compiled
@pytest.mark.parametrize("gravity", [(0.0, -G), (0.0, 0.0)])
def test_a_bowl_of_a_hundred_arcs_is_one_bowl(gravity: tuple[float, float]) -> None:
    angles = [pi + pi * k / 100 for k in range(101)]
    world = falling_world(*[Arc((0, 0), 2, a, b) for a, b in pairwise(angles)], gravity=gravity)
    ball = world.add(Ball((1.7 * sin(-1), -1.7 * cos(1)), 0.3, elasticity=0.5))
    ball.velocity = (0.5 * cos(-1), 0.5 * sin(-1))
    before = energy(world)
    for _ in range(120 if gravity == (0.0, 0.0) else 600):
        assert len(world.step(1 / 60)) == 0
        assert energy(world) == pytest.approx(before, rel=1e-9)
        assert hypot(*ball.position) == pytest.approx(1.7, abs=3e-4)


@pytest.mark.parametrize("elasticity", [0.2, 0.9])
def test_bounces_without_a_rest_speed_come_to_an_end(elasticity: float) -> None:
    world = falling_world(Segment((-5, 0), (5, 0)), rest_speed=0)
    ball = world.add(Ball((0, 2), 0.5, elasticity=elasticity))
    # 2·√(2h/g)·e/(1 - e) after the first fall.
    fall = sqrt(2 * 1.5 / G)
    end = fall + 2 * fall * elasticity / (1 - elasticity)
    hits = world.run(1.1 * end + 0.1)
    assert len(world.run(1)) == 0
    assert ball.position == pytest.approx((0, 0.5), abs=1e-12)
    assert hits[len(hits) - 1].time <= end
    assert world.statistics.stalled == 0


@pytest.mark.parametrize("elasticity", [1.0, 1.5])
def test_an_elastic_ball_that_was_put_onto_a_floor_stays_there(elasticity: float) -> None:
    world = falling_world(Segment((-5, 0), (5, 0)))
    ball = world.add(Ball((0, 0.5), 0.5, elasticity=elasticity))
    world.run(5)
    assert ball.position == pytest.approx((0, 0.5), abs=1e-9)
    assert world.statistics.stalled == 0
    assert world.statistics.full_tests < 100 * 4 * 300


@pytest.mark.compiled
def test_what_lasts_is_in_a_snapshot() -> None:
    world = falling_world(Circle((0, 0), 2), Segment((3, 0), (9, 0)))
    world.add(Ball((1.7 * sin(1), -1.7 * cos(1)), 0.3, elasticity=0.5))
    world.add(Ball((4, 0.5), 0.5, velocity=(1, 0), elasticity=0.5))
    world.run(1)
    assert held(world) == 2
    other = World()
    other.restore(world.snapshot())
    assert held(other) == 2
    for _ in range(500):
        assert np.asarray(world.step(1 / 60)).tobytes() == np.asarray(other.step(1 / 60)).tobytes()
        assert world.digest() == other.digest()


@pytest.mark.parametrize("how", ["remove", "switch off"])
def test_a_ball_falls_when_its_floor_goes(how: str) -> None:
    world = falling_world()
    floor = world.add(Segment((-5, 0), (5, 0)))
    ball = world.add(Ball((0, 0.5), 0.5, elasticity=0.5))
    world.run(1)
    assert held(world) == 1
    if how == "remove":
        world.remove(floor)
    else:
        floor.can_collide = False
    world.run(1)
    assert held(world) == 0
    assert ball.position == pytest.approx((0, 0.5 - 0.5 * G), abs=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize(
    ("count", "elasticity"),
    [(10, 0.0), (10, 0.5), *[pytest.param(25, e, marks=pytest.mark.slow) for e in (0.5, 0.8)]],
)
def test_a_pile_of_balls_settles(count: int, elasticity: float) -> None:
    rng = np.random.default_rng(1)
    world = falling_world(*guarded(box(3.2, 12)))
    places = [(0.35 + k % 5 * 0.6 + rng.uniform(-0.04, 0.04), 0.5 + k // 5 * 0.6) for k in range(count)]
    world.add_balls(places, velocity=rng.uniform(-1, 1, (count, 2)), radius=0.25, elasticity=elasticity)
    world.run(10)
    assert 0.5 * float((world.balls.velocity**2).sum()) / count < 1e-3
    x, y = world.balls.position.T
    assert (x > 0.25 - 1e-3).all()
    assert (x < 2.95 + 1e-3).all()
    assert (y > 0.25 - 1e-3).all()
    assert world.statistics.stalled == 0
    apart = np.hypot(x[:, None] - x, y[:, None] - y) + np.eye(count)
    assert apart.min() > 0.5 * (1 - 1e-3)


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
def test_balls_on_top_of_each_other_stay(elasticity: float) -> None:
    world = falling_world(Segment((-5, 0), (5, 0)))
    balls = [world.add(Ball((0, 0.5 + k), 0.5, elasticity=elasticity)) for k in range(4)]
    world.run(2)
    for k, ball in enumerate(balls):
        assert ball.position == pytest.approx((0, 0.5 + k), abs=1e-3)
    assert world.statistics.stalled == 0


@pytest.mark.parametrize("elasticity", [0.6, 1.0])
@pytest.mark.parametrize("uneven", [1e-8, -1e-8, 1e-6, 1e-3])
def test_a_ball_that_slides_over_an_uneven_joint_goes_on(uneven: float, elasticity: float) -> None:
    # A chute that ends at a drum, almost in its tangent: the drum touches the ball, and cannot hold it.
    slope = -0.55
    end, normal = (3.0 * cos(slope), 3.0 * sin(slope)), (-sin(slope), cos(slope))
    turned = (normal[0] * cos(uneven) + normal[1] * sin(uneven), normal[1] * cos(uneven) - normal[0] * sin(uneven))
    drum = Circle((end[0] - 0.6 * turned[0], end[1] - 0.6 * turned[1]), 0.6, solid=True, elasticity=elasticity)
    world = falling_world(Segment((0, 0), end, elasticity=0.5), drum, gravity=(0, -35))
    ball = world.add(Ball((0.6 * normal[0], 0.6 * normal[1]), 0.6, velocity=(8 * cos(slope), 8 * sin(slope))))
    hits = world.run(0.5, dt=1 / 480)
    assert len(hits) < 10
    assert world.statistics.stalled == 0
    assert world.statistics.full_tests < 20_000
    assert ball.position[1] < -2


@pytest.mark.parametrize("balls", [1, 2, 3])
@pytest.mark.parametrize(
    "floor", [Segment((-5, 0), (5, 0)), Circle((0, -2), 2, solid=True), Circle((0, 5), 5)], ids=lambda floor: floor.kind
)
def test_what_gets_a_kick_throws_off_what_lies_on_it(floor: Shape, balls: int) -> None:
    lane = [Segment((x, 0.3), (x, 20), elasticity=0.5) for x in (-0.5, 0.5)]
    world = falling_world(deepcopy(floor), *lane)
    for place in range(balls):
        world.add(Ball((0, 0.5 + 1.05 * place), 0.5, elasticity=0.6))
    world.run(5.0)
    assert np.abs(world.balls.velocity).max() < 1e-6
    world.shapes[0].kick = 5.0
    (hit,) = world.step(1 / 1024)
    assert hit.impulse == pytest.approx(5.0, rel=1e-3)
    heights = world.balls.position[:, 1].copy()
    # What is on top carries on what the lowest one was given.
    assert world.balls.velocity[-1, 1] > 1.0
    assert (world.balls.velocity[:, 1] > -0.01).all()
    assert world.balls.velocity[:, 1].sum() == pytest.approx(5.0 - balls * G / 1024, abs=0.02)
    world.step(1 / 64)
    assert (world.balls.position[:, 1] >= heights - 1e-6).all()
    assert world.statistics.squeezed == 0


@pytest.mark.parametrize("lying", [0, 1, 2])
@pytest.mark.parametrize("elasticity", [0.0, 0.5])
@pytest.mark.parametrize("wall", [0.0, -1.0])
@pytest.mark.parametrize("pin", [0.0, 0.001, -0.2, 0.5])
def test_a_pin_that_comes_through_what_carries_a_ball_lifts_it(
    pin: float, wall: float, elasticity: float, lying: int
) -> None:
    options: dict[str, Any] = {"elasticity": 0.5, "motion": "kinematic"}
    world = falling_world(Segment((-2, 0), (2, 0), velocity=(0, wall), **options))
    lane = [Segment((x, -9), (x, 9), elasticity=0.5) for x in (-0.5, 0.5)]
    world.add(*lane, *[Ball((0, 0.5 + place), 0.5, elasticity=elasticity) for place in range(lying + 1)])
    world.run(0.25)
    # It begins a little below the wall, and is a little above it after a second.
    sharp = world.add(Point((0, 0.25 * wall - 0.5 * (pin - wall)), velocity=(0, pin), **options))
    world.run(1.25)
    floor = world.shapes[0]
    assert sharp.position[1] - floor.start[1] == pytest.approx(0.75 * (pin - wall), abs=1e-12)
    tops = np.sort(world.balls.position[:, 1])
    assert tops[0] == pytest.approx(max(sharp.position[1], floor.start[1]) + 0.5, abs=1e-3)
    assert np.diff(tops) == pytest.approx(1.0, abs=1e-3)
    assert world.statistics.squeezed == 0
