"""Lasting contacts with two shapes at once, and of balls that lean on each other."""

from functools import partial
from math import asin, cos, pi, sin

import pytest

from carom import Ball, Circle, Segment, World
from carom.world.kernels.continuous.encounter import keep_push_out
from tests.worlds import continuous_world

#: Worlds with gravity in which a ball is soon stalled.
stalling_world = partial(continuous_world, gravity=(0.0, -10.0), max_impacts=1000)


@pytest.mark.parametrize("top", [4.9, 5.0, 5.1], ids=["overhanging", "upright", "leaning back"])
@pytest.mark.parametrize("elasticity", [0.0, 0.5])
def test_a_ball_rests_where_a_slope_ends_at_a_wall(top: float, elasticity: float) -> None:
    # Gravity does not press it onto the wall, the slope does.
    world = stalling_world(Segment((-5, 1), (5, 0)), Segment((5, 0), (top, 5)))
    ball = world.add(Ball((4, 1), 0.5, elasticity=elasticity))
    world.run(4, dt=1 / 30)
    assert world.statistics.stalled == 0
    assert world.statistics.full_tests < 5000
    assert ball.velocity == pytest.approx((0, 0), abs=1e-9)
    assert 4.4 < ball.position[0] < 4.6
    assert len(world.run(1, dt=1 / 30)) == 0


@pytest.mark.parametrize("dt", [0.1, 1.0])
@pytest.mark.parametrize("elasticity", [0.0, 0.6])
def test_a_wedge_holds_a_ball_in_long_steps(dt: float, elasticity: float) -> None:
    slope = pi / 6
    world = stalling_world(
        Segment((-5, 5 * sin(slope) / cos(slope)), (0, 0)),
        Segment((0, 0), (5, 5 * sin(slope) / cos(slope))),
        substeps=1,
    )
    ball = world.add(Ball((0.3, 0.4), 0.05, elasticity=elasticity))
    for _ in range(round(8 / dt)):
        world.step(dt)
        x, y = ball.position
        assert y * cos(slope) - abs(x) * sin(slope) >= 0.05 * (1 - 1e-3)
    assert ball.position == pytest.approx((0, 0.05 / cos(slope)), abs=1e-9)
    assert ball.velocity == pytest.approx((0, 0), abs=1e-9)


def test_two_balls_slide_round_a_bowl_in_contact_without_gravity() -> None:
    world = stalling_world(Circle((0, 0), 5), gravity=(0, 0))
    for side, speed in ((-1, 1.0), (1, 0.8)):
        angle = side * asin(0.5 / 4.5)
        place = (4.5 * cos(angle), 4.5 * sin(angle))
        world.add(Ball(place, 0.5, velocity=(-speed * sin(angle), speed * cos(angle)), elasticity=0.0))
    world.run(0.6)
    assert world.statistics.stalled == 0
    assert world.statistics.full_tests < 5000


@pytest.mark.parametrize(
    ("aim", "expected"), [((0.0, -3.0), (0.0, 0.5)), ((0.1, 0.58), (0.1, 0.58)), ((3.0, 0.6), (0.125, 0.6))]
)
def test_a_push_is_short_and_stops_at_a_wall(aim: tuple[float, float], expected: tuple[float, float]) -> None:
    world = stalling_world(Segment((-5, 0), (5, 0)), gravity=(0, 0))
    world.add(Ball((0, 0.6), 0.5))
    world.step(0.01)
    _states, balls, shapes, _order, index, cells, members = world._block.arguments[:7]
    balls[0]["x"], balls[0]["y"] = aim
    keep_push_out(balls[0], shapes, index, cells, members, world._arrays.relations, 0.0, 0.6)
    assert (balls[0]["x"], balls[0]["y"]) == pytest.approx(expected)


@pytest.mark.parametrize("heavier", [1.0, 50.0])
def test_a_ball_does_not_fall_into_the_one_below_it_in_long_steps(heavier: float) -> None:
    world = World(gravity=(0, -10), detection="continuous", substeps=1)
    world.add(Segment((-1, 0), (1, 0)))
    low, high = Ball((0, 0.01), 0.01, elasticity=0.0), Ball((0, 0.03), 0.01, elasticity=0.0, mass=heavier)
    world.add(low)
    world.add(high)
    for _ in range(2):
        world.step(0.5)
        assert low.position[1] == pytest.approx(0.01, rel=1e-9)
        assert high.position[1] > 0.028
