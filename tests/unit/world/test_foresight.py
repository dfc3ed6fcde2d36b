"""`aim` without a direction foretells what the steps to come show, to the bit."""

from math import cos, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom import Arc, Ball, Circle, Gate, InvalidArgument, Point, Segment, World
from tests.worlds import box, crowded, world_of


def room(seed: int) -> World:
    """Shapes of all kinds that stand, go and turn, sensors, and balls of all sizes in flight, that meet."""
    random = np.random.default_rng(seed)
    gravity = (0.0, 0.0) if random.random() < 0.3 else tuple(random.normal(0, 5, 2))
    world = World(detection="continuous", gravity=gravity, friction=float(random.choice([0.0, 0.5])))
    world.add(*box(24.0, 24.0))
    for k, (x, y) in enumerate(random.uniform(3, 21, (6, 2))):
        turn, elasticity = random.uniform(0, 6), float(random.choice([0.5, 0.9, 1.0]))
        moves = {}
        if random.random() < 0.5:
            moves = {
                "motion": "kinematic",
                "velocity": tuple(random.normal(0, 1, 2)),
                "angular_velocity": random.normal(),
            }
        tip = (x + 2 * cos(turn), y + 2 * sin(turn))
        shape = (
            Segment((x, y), tip, elasticity=elasticity, **moves),
            Arc((x, y), 2.0, turn, turn + 3.0, elasticity=elasticity, **moves),
            Circle((x, y), 1.0, solid=bool(random.random() < 0.5), elasticity=elasticity, **moves),
            Point((x, y), elasticity=elasticity, **moves),
            Gate((x, y), tip),
            Circle((x, y), 1.5, sensor=True, solid=True),
        )[(k + seed) % 6]
        world.add(shape)
    for _ in range(int(random.integers(1, 12))):
        place, velocity = random.uniform(2, 22, 2), random.normal(0, 6, 2)
        world.add(
            Ball(tuple(place), random.uniform(0.1, 0.6), tuple(velocity), mass=random.uniform(0.5, 3), elasticity=0.9)
        )
    return world


@pytest.mark.slow
@given(seed=st.integers(0, 2**32 - 1), aged=st.sampled_from([0.0, 0.3, 1.1]), seconds=st.sampled_from([1 / 60, 0.25]))
def test_aim_tells_what_the_first_hit_of_the_ball_will_say(seed: int, aged: float, seconds: float) -> None:
    world = room(seed)
    world.step(aged)
    before = world.digest()
    lines = {ball: world.aim(ball) for ball in world.balls}
    assert world.digest() == before
    hits = [hit for _ in range(8) for hit in world.step(seconds) if hit.kind is carom.HitKind.BOUNCE]
    for ball, line in lines.items():
        own = [hit for hit in hits if ball in (hit.ball, hit.shape)]
        if not own:
            assert line is None or line.time > world.time
            continue
        hit = own[0]
        assert line is not None
        sign, other = (1, hit.shape) if hit.ball is ball else (-1, hit.ball)
        assert (line.time, line.shape, line.point) == (hit.time, other, hit.point)
        assert line.normal == (sign * hit.normal[0], sign * hit.normal[1])


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(12))
def test_ghost_and_directions_are_where_a_step_up_to_the_impact_leaves_both(seed: int) -> None:
    world = room(seed)
    world.step(0.25)
    ball = world.balls[0]
    line = world.aim(ball)
    if line is None:
        return
    twin = World()
    twin.restore(world.snapshot())
    twin.step(line.time - twin.time)
    # The step ends within the rounding of the impact's time, before it or after.
    after = twin.balls[0]
    assert after.position == pytest.approx(line.ghost, abs=1e-12)
    twin.step(1e-12)
    after = twin.balls[0]
    expected = (0.0, 0.0) if line.direction is None else line.direction
    assert after.velocity == pytest.approx((line.speed * expected[0], line.speed * expected[1]), abs=1e-9)


@pytest.mark.slow
def test_nothing_to_meet_is_none_and_many_are_asked_at_once() -> None:
    world = World(detection="continuous", gravity=(0, -10))
    floor = world.add(Segment((-5, 0), (5, 0)))
    balls = [world.add(Ball((x, 3), 1.0)) for x in (0.0, 20.0)]
    assert world.aim(balls[1]) is None
    lines = world.aim(balls)
    assert lines.found.tolist() == [True, False]
    assert lines[0] is not None
    assert lines[0].shape is floor
    assert lines[0].time == pytest.approx(0.4**0.5)
    assert lines[0].direction == (0.0, 1.0)


def test_a_ball_at_rest_in_a_heap_meets_nothing_in_the_end() -> None:
    world = World(detection="continuous", gravity=(0, -10))
    world.add(Segment((-5, 0), (5, 0), elasticity=0.5))
    ball = world.add(Ball((0, 1), 1.0))
    world.run(0.5)
    assert world.aim(ball) is None


@pytest.mark.parametrize("direction", [(1e308, 0), (1e308, 1e308), (5e-324, 0), (0, -1e-310)])
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_a_direction_so_long_or_short_that_numbers_do_not_reach_is_refused(
    direction: tuple[float, float], detection: str
) -> None:
    world = world_of(*box(9, 9), Ball((4, 4), 0.5), detection=detection)
    with pytest.raises(InvalidArgument, match=r"direction must be of a length that leaves times .* finite, not"):
        world.aim(world.balls[0], direction)
    with pytest.raises(InvalidArgument, match="direction must be"):
        world.aim(world.balls[0], np.array([(1.0, 0.0), direction]))
    assert world.aim(world.balls[0], (1e150, 0))


def test_the_discrete_mode_wants_a_direction() -> None:
    world = crowded(3)
    with pytest.raises(carom.InvalidArgument, match="direction must be given in the discrete mode, not None"):
        world.aim(world.balls[0])
