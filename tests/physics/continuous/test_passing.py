"""Passing in the continuous mode: a ball that comes in past a bare end passes; one that was pushed on does not."""

import pytest

from carom import Arc, Ball, Segment, World
from tests.worlds import continuous_world


@pytest.mark.parametrize("beside", [0.3, 0.249, 0.1, 1e-6])
def test_a_bare_end_is_passed(beside: float) -> None:
    world = continuous_world(Segment((0, 0), (0, 3)))
    ball = world.add(Ball((-2, -beside), 0.25, velocity=(5, 0)))
    assert len(world.run(1)) == 0
    assert ball.position == pytest.approx((3, -beside))


@pytest.mark.parametrize("within", [0.0, 1e-4, 0.1])
def test_what_is_beside_the_segment_bounces(within: float) -> None:
    world = continuous_world(Segment((0, 0), (0, 3)))
    ball = world.add(Ball((-2, within), 0.25, velocity=(5, 0)))
    assert len(world.run(1)) == 1
    assert ball.position == pytest.approx((-3.5, within))


@pytest.mark.parametrize("speed", [0.5, 5.0, 500.0])
@pytest.mark.parametrize("motion", ["static", "kinematic"])
def test_a_ball_that_comes_in_past_an_end_goes_on_along_the_shape(speed: float, motion: str) -> None:
    world = continuous_world(Segment((0, 0), (0, 3), motion=motion))
    ball = world.add(Ball((-0.1, -1), 0.25, velocity=(0, speed)))
    assert len(world.run(6 / speed, dt=0.3 / speed)) == 0
    assert ball.position == pytest.approx((-0.1, 5))
    world = continuous_world(Arc((0, 0), 2, 0, 2, motion=motion))
    ball = world.add(Ball((2.1, -1), 0.25, velocity=(0, speed)))
    assert len(world.run(6 / speed, dt=0.3 / speed)) == 0
    assert ball.position == pytest.approx((2.1, 5))


def test_whichever_way_it_leaves_there_is_no_contact() -> None:
    world = continuous_world(Segment((0, 0), (0, 3)))
    ball = world.add(Ball((-0.1, -0.5), 0.25, velocity=(0, 2)))
    world.run(0.5)
    ball.velocity = (1, 0)
    assert len(world.run(1)) == 0
    assert ball.position[0] > 0.5
    ball.velocity = (-1, 0)
    assert len(world.run(1)) == 1


@pytest.mark.parametrize("deep", [0.01, 0.1, 0.24])
def test_a_ball_that_was_put_onto_a_shape_is_pushed_out(deep: float) -> None:
    world = continuous_world(Segment((0, -3), (0, 3)))
    ball = world.add(Ball((-0.25 + deep, 0), 0.25, velocity=(1, 0)))
    assert len(world.step(0.1)) == 1
    assert ball.position == pytest.approx((-0.35, 0), abs=1e-9)


@pytest.mark.slow
@pytest.mark.compiled
def test_a_ball_that_another_pushes_onto_a_wall_stays_before_it() -> None:
    world = World(detection="continuous", gravity=(0, -10))
    for shape in (Segment((-1, 0), (1, 0)), Segment((-0.5, -1), (-0.5, 9)), Segment((0.5, -1), (0.5, 9))):
        world.add(shape)
    for k in range(6):
        world.add(Ball((0, 0.5 + k), 0.5, mass=1.0 + 50.0 * k, elasticity=0.3))
    world.run(3)
    assert (abs(world.balls.position[:, 0]) <= 1e-6).all()
    assert (world.balls.position[:, 1] >= 0.5 - 1e-3).all()
    assert world._states[0]["relations"] <= 20


@pytest.mark.parametrize("spin", [5.0, 100.0])
def test_a_turning_bar_lets_what_comes_past_its_end_pass(spin: float) -> None:
    # The ball lies across the bar's end circle: the bar never has the ball's centre beside it.
    bar = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=spin)
    world = continuous_world(bar)
    ball = world.add(Ball((0, 2.05), 0.25))
    assert len(world.run(20 / spin, dt=0.5 / spin)) == 0
    assert ball.position == (0, 2.05)
