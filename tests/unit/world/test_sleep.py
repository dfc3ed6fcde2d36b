"""Sleep: who falls asleep and when, what a sleeping ball does not do, and what wakes it."""

from collections.abc import Callable
from math import pi

import pytest

from carom import Ball, Circle, Point, Segment, World


def still_world(**settings: object) -> tuple[World, Ball]:
    """A world in which a ball at rest has fallen asleep, at the origin."""
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.25, **settings)  # type: ignore[arg-type]
    ball = world.add(Ball((0, 0), radius=1))
    world.run(0.5, dt=0.125)
    assert ball.asleep
    return world, ball


def test_a_ball_sleeps_when_it_was_slow_for_long_enough() -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.5)
    slow = world.add(Ball((0, 0), radius=1, velocity=(0.0625, 0)))
    fast = world.add(Ball((0, 9), radius=1, velocity=(0.125, 0)))
    world.run(0.375, dt=0.125)
    assert not slow.asleep
    world.step(0.125)
    assert slow.asleep
    assert slow.velocity == (0, 0)
    assert slow.position == (0.03125, 0)
    world.run(1, dt=0.125)
    assert slow.position == (0.03125, 0)
    assert not fast.asleep
    assert world.statistics.sleeping == 1


def test_a_ball_that_was_fast_again_starts_counting_anew() -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=1, sleep_time=0.5, gravity=(0, -4))
    ball = world.add(Ball((0, 0), radius=1, velocity=(0, 2.5)))
    world.run(0.75, dt=0.125)  # slow from 0.5 s to 0.75 s
    assert ball.velocity[1] == -0.5
    assert ball._row["still_time"] == 0.375
    world.add(Segment((-5, -9), (5, -9)))
    while ball.velocity[1] < 1:
        world.step(0.125)
        assert not ball.asleep
    assert ball._row["still_time"] == 0.0


def test_no_ball_sleeps_by_default() -> None:
    world = World(detection="discrete")
    ball = world.add(Ball((0, 0), radius=1))
    world.run(5)
    assert not ball.asleep


def test_a_sleeping_ball_does_not_fall_or_slide() -> None:
    world, ball = still_world()
    world.statistics.reset()
    tests = world.statistics.box_tests
    world.run(2, dt=0.125)
    assert ball.position == (0, 0)
    assert ball.velocity == (0, 0)
    assert world.statistics.box_tests == tests


def test_a_sleeping_ball_is_not_tested_against_shapes() -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.25)
    world.add(Segment((-5, -1), (5, -1)))
    ball = world.add(Ball((0, 0), radius=1))
    world.run(0.5, dt=0.125)
    assert ball.asleep
    before = world.statistics.full_tests
    world.run(1, dt=0.125)
    assert world.statistics.full_tests == before


def test_a_hit_wakes() -> None:
    world, ball = still_world()
    world.add(Ball((4, 0), radius=1, velocity=(-8, 0)))
    world.run(0.25, dt=0.125)
    world.balls[0].position  # noqa: B018  # looking wakes nothing
    hits = world.run(0.25, dt=0.125)
    assert len(hits) == 1
    assert not ball.asleep
    assert ball.velocity == (-8, 0)


def test_a_ball_woken_by_a_hit_counts_its_rest_anew() -> None:
    world, ball = still_world()
    other = world.add(Ball((3, 0), radius=1, velocity=(-1, 0), mass=1e-3))
    while not len(world.step(0.125)):
        assert other.velocity == (-1, 0)
    assert not ball.asleep
    assert ball.velocity[0] == pytest.approx(-0.002, rel=1e-2)
    world.step(0.125)
    assert ball.asleep


@pytest.mark.parametrize(
    "change",
    [
        lambda world, post: setattr(post, "elasticity", 0.5),
        lambda world, post: setattr(post, "position", (0, 60)),
        lambda world, post: setattr(world, "gravity", (0, -1)),
        lambda world, post: setattr(world, "substeps", 2),
        lambda world, post: setattr(world.balls[1], "velocity", (1, 0)),
        lambda world, post: setattr(world.balls[1], "elasticity", 0.9),
        lambda world, post: world.balls.velocity.__setitem__((1, 0), 2.0),
        lambda world, post: world.balls.position.__setitem__((1, 1), 30.0),
        lambda world, post: world.balls.mass.__setitem__(1, 3.0),
        lambda world, post: world.balls.radius.__setitem__(1, 0.5),
        lambda world, post: world.add(Point((70, 70))),
        lambda world, post: world.add(Ball((80, 80), radius=1)),
        lambda world, post: world.add_balls([(90.0, 90.0)], radius=1.0),
        lambda world, post: world.remove(post),
        lambda world, post: world.remove(world.balls[1]),
    ],
)
def test_any_change_from_outside_wakes_all(change: Callable[[World, Point], object]) -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.25)
    post = world.add(Point((0, 50)))
    ball = world.add(Ball((0, 0), radius=1))
    world.add(Ball((20, 20), radius=1))
    world.run(0.5, dt=0.125)
    assert world.statistics.sleeping == 2
    change(world, post)
    assert ball._row["still_time"] > 0.2
    world.step(0.125)
    assert not ball.asleep
    assert ball._row["still_time"] <= 0.125


def test_looking_wakes_nothing() -> None:
    world, ball = still_world()
    assert world.balls.position.tolist() == [[0, 0]]
    assert world.balls.velocity.tolist() == [[0, 0]]
    world.snapshot()
    world.step(0.125)
    assert ball.asleep


def test_a_turning_shape_wakes_the_balls_in_its_way_alone() -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.25)
    hand = world.add(Segment((0, 0), (10, 0), motion="kinematic", pivot=(0, 0)))
    near = world.add(Ball((8, 3), radius=1))
    far = world.add(Ball((-8, -8), radius=1))
    world.run(0.5, dt=0.125)
    assert world.statistics.sleeping == 2
    row = hand._row
    row["angular_velocity"], world._states[0]["moving_stale"] = 4.0, 1  # from within: the setter would wake all
    world.step(0.125)
    assert not near.asleep
    assert far.asleep


def test_a_shape_that_turns_far_in_a_substep_wakes_what_it_sweeps_over() -> None:
    world = World(detection="discrete", substeps=1, sleep_speed=0.1, sleep_time=0.25)
    hand = world.add(Segment((0, 0), (8, -8), motion="kinematic", pivot=(0, 0)))
    ball = world.add(Ball((10.5, 0), radius=1))
    world.run(0.5, dt=0.125)
    assert ball.asleep
    hand._row["angular_velocity"], world._states[0]["moving_stale"] = 4 * pi, 1  # to (8, 8), by way of (11.3, 0)
    world.step(0.125)
    assert not ball.asleep


def test_a_travelling_shape_wakes_the_balls_that_it_comes_to() -> None:
    world, ball = still_world()
    paddle = world.add(Circle((6, 0), 1, solid=True, motion="kinematic"))
    world.run(0.5, dt=0.125)
    assert ball.asleep
    paddle._row["velocity_x"], world._states[0]["moving_stale"] = -8.0, 1
    world.step(0.125)
    assert ball.asleep
    world.run(0.375, dt=0.125)
    world.step(0.125)
    assert not ball.asleep
    assert ball.velocity == (-16, 0)


def put_to_sleep(world: World, ball: Ball) -> None:
    """Make a ball sleep from within, so that nothing wakes it as changed from outside."""
    row = ball._row
    row["asleep"], row["still_time"], row["vx"], row["vy"] = 1, world.sleep_time, 0.0, 0.0
    arrays = world._arrays
    arrays.states[0]["sleeping"] += 1
    for field in ("x", "y", "vx", "vy"):
        arrays.saved[field][: arrays.balls.count] = arrays.balls.used[field]


def pile(iterations: int) -> tuple[World, Ball, Ball]:
    """A ball that sleeps on the floor, and one above that comes to rest on it."""
    world = World(detection="discrete", gravity=(0, -10), iterations=iterations, sleep_speed=0.2, sleep_time=0.5)
    world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
    lower = world.add(Ball((0, 1), radius=1, elasticity=0.5))
    world.run(1)
    assert lower.asleep
    upper = world.add(Ball((0, 3), radius=1, elasticity=0.5))
    return world, lower, upper


def test_a_ball_that_rests_on_a_sleeping_one_does_not_push_it_through_the_floor() -> None:
    world, lower, upper = pile(iterations=6)
    world.step(1 / 60)
    put_to_sleep(world, lower)
    for _ in range(25):
        world.step(1 / 60)
        assert lower.asleep
        assert not upper.asleep
        assert lower.velocity == (0, 0)
    assert lower.position[1] == pytest.approx(1, abs=1e-4)
    assert upper.position[1] == pytest.approx(3, abs=1e-3)


def test_a_pile_falls_asleep_and_stays_so() -> None:
    world, lower, upper = pile(iterations=6)
    world.run(3)
    assert lower.asleep
    assert upper.asleep
    places = lower.position, upper.position
    world.run(1)
    assert (lower.position, upper.position) == places
    assert world.statistics.sleeping == 2


def test_the_count_of_sleepers_is_that_of_the_balls() -> None:
    world = World(detection="discrete", gravity=(0, -10), sleep_speed=0.5, sleep_time=0.1)
    world.add(Segment((-20, 0), (20, 0), elasticity=0.3))
    for k in range(12):
        world.add(Ball((1.5 * (k % 4), 1 + 2.01 * (k // 4)), radius=1, elasticity=0.3))
    for _ in range(90):
        world.step(1 / 60)
        assert world.statistics.sleeping == sum(ball.asleep for ball in world.balls)
