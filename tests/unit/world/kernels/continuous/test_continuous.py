"""A step of the continuous mode: impacts one after the other at their exact times, however long the step is."""

from itertools import pairwise
from math import sqrt

import pytest

from carom import Ball, Circle, HitKind, Segment
from tests.worlds import box, continuous_world


@pytest.mark.parametrize("steps", [1, 7])
def test_a_dropped_ball_bounces_at_the_times_of_the_textbook(steps: int) -> None:
    world = continuous_world(Segment((-9, 0), (9, 0), elasticity=0.5), gravity=(0, -10), rest_speed=0.0, substeps=1)
    world.add(Ball((0, 6), 1))
    times = [float(time) for _ in range(steps) for time in world.step(2.4 / steps)["time"]]
    fall = sqrt(2 * 5 / 10)
    expected = [fall]
    while expected[-1] + 2 * fall * 0.5 ** len(expected) < 2.4:
        expected.append(expected[-1] + 2 * fall * 0.5 ** len(expected))
    assert times == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("dt", [20.0, 0.3])
def test_a_ball_between_walls_is_where_a_mirror_says(dt: float) -> None:
    world = continuous_world(*box(10.0, 7.0), substeps=1)
    ball = world.add(Ball((2, 3), 1, velocity=(3, -2)))
    hits = world.run(60, dt=dt)

    def mirrored(start: float, width: float) -> float:
        """Where a ball is that runs to and fro."""
        away = (start - 1) % (2 * (width - 2))
        return 1 + min(away, 2 * (width - 2) - away)

    assert ball.position == pytest.approx((mirrored(2 + 3 * 60, 10.0), mirrored(3 - 2 * 60, 7.0)), abs=1e-9)
    # It has 8 to run from side to side and had run 1 of them, 5 from floor to roof and had run 3.
    assert len(hits) == (1 + 3 * 60) // 8 + (3 + 2 * 60) // 5
    assert all(first <= second for first, second in pairwise(hits["time"].tolist()))


def test_a_ball_hits_a_closing_wall_ever_faster() -> None:
    press = Segment((20, -1), (20, 1), motion="kinematic", velocity=(-1, 0))
    world = continuous_world(Segment((0, -1), (0, 1)), press, substeps=1)
    ball = world.add(Ball((1, 0), 1, velocity=(3, 0)))
    place, speed, wall, time, speeds = 1.0, 3.0, 20.0, 0.0, []
    for _ in range(3):  # to the press, and back to the wall
        there = (wall - 1 - place) / (speed + 1)
        time, wall, speed = time + there, wall - there, speed + 2
        back = (wall - 2) / speed
        time, wall, place = time + back, wall - back, 1.0
        speeds.append(speed)
    hits = world.step(time + 1e-6)
    assert len(hits) == 6
    assert ball.velocity[0] == pytest.approx(speeds[-1])
    assert hits["time"][-1] == pytest.approx(time)


def test_a_sensor_is_entered_and_left_at_the_times_of_its_border_in_one_step() -> None:
    world = continuous_world(Circle((0, 0), 2, solid=True, sensor=True), substeps=1)
    world.add(Ball((-10, 0), 1, velocity=(4, 0)))
    hits = world.step(10.0)
    assert [(hit.kind, hit.time) for hit in hits] == [
        (HitKind.ENTER, pytest.approx(7 / 4)),
        (HitKind.EXIT, pytest.approx(13 / 4)),
    ]
