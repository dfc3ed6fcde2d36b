"""Crossings of sensors' edges: where the ball touches, from which side, and how fast it goes over the surface."""

from copy import deepcopy
from math import hypot, pi, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import Arc, Ball, Circle, HitKind, Point, Segment, World

RADIUS = 0.25


def crossings(sensor: Any, ball: Ball, seconds: float = 4.0, **settings: Any) -> carom.Hits:
    """What one ball and one sensor have had to do with each other."""
    world = World(detection="continuous", **settings)
    world.add(sensor)
    world.add(ball)
    hits = world.run(seconds, dt=0.1)
    assert hits["kind"].tolist() == [HitKind.ENTER, HitKind.EXIT] * (len(hits) // 2)
    return hits


AT_REST = {
    "segment": Segment((0, -2), (0, 2), sensor=True),
    "slanted segment": Segment((-1, -1), (1, 2), sensor=True),
    "along a segment": Segment((-1, 0), (1, 0), sensor=True),
    "point": Point((0, 0), sensor=True),
    "ring": Circle((0, 0), 1.5, sensor=True),
    "disc": Circle((0, 0), 1.5, sensor=True, solid=True),
    "arc": Arc((0, 0), 1.5, pi - 1, pi + 1, sensor=True),
    "over the end of an arc": Arc((0, -1.4), 1.5, 0.0, pi / 2, sensor=True),
}


@pytest.mark.parametrize("name", AT_REST)
def test_a_crossing_says_where_the_ball_touches_and_how_it_moves(name: str) -> None:
    sensor = deepcopy(AT_REST[name])
    ball = Ball((-4, 0.1), RADIUS, velocity=(2, 0.05))
    hits = crossings(sensor, ball, gravity=(0, -0.1))
    assert len(hits) >= 2
    for hit in hits:
        x, y = 2 * hit.time - 4, 0.1 + 0.05 * hit.time - 0.05 * hit.time**2
        assert hit.position == pytest.approx((x, y), abs=1e-9)
        assert hit.velocity == pytest.approx((2, 0.05 - 0.1 * hit.time), abs=1e-12)
        assert hit.speed == pytest.approx(hypot(*hit.velocity), abs=1e-12)
        assert (hit.setback, hit.impulse) == (0.0, 0.0)
        place = sensor.closest_point(hit.position)
        dx, dy = x - place[0], y - place[1]
        # Past the end of something thin the ball is over it at once.
        over = name in ("along a segment", "over the end of an arc")
        assert hypot(dx, dy) <= RADIUS + 1e-9 if over else hypot(dx, dy) == pytest.approx(RADIUS, abs=1e-9)
        away = -1.0 if name == "disc" and hypot(x, y) < 1.5 else 1.0
        assert hit.normal == pytest.approx((away * dx / hypot(dx, dy), away * dy / hypot(dx, dy)), abs=1e-7)
        assert hit.point == pytest.approx(place, abs=1e-8)


def test_a_ball_comes_in_against_the_normal_and_leaves_along_it() -> None:
    for name in ("point", "disc"):
        enter, leave = crossings(deepcopy(AT_REST[name]), Ball((-4, 0.1), RADIUS, velocity=(2, 0)))
        assert np.dot(enter.velocity, enter.normal) < 0.0 < np.dot(leave.velocity, leave.normal)


def test_speeds_are_those_over_a_surface_that_moves() -> None:
    disc = Circle((2, 0), 0.5, solid=True, sensor=True, motion="kinematic", velocity=(-1, 0.0))
    enter, leave = crossings(disc, Ball((-2, 0), RADIUS, velocity=(2, 0)))
    assert (enter.speed, leave.speed) == (3.0, 3.0)
    assert (enter.velocity, leave.velocity) == ((2, 0), (2, 0))
    meets = (4 - 0.75) / 3
    assert enter.time == pytest.approx(meets)
    assert enter.position == pytest.approx((2 * meets - 2, 0))
    assert enter.point == pytest.approx((2 * meets - 2 + RADIUS, 0))
    assert enter.normal == pytest.approx((-1, 0))
    assert leave.point == pytest.approx((2 * leave.time - 2 - RADIUS, 0))
    turning = Segment((0, 0), (4, 0), sensor=True, motion="kinematic", pivot=(0, 0), angular_velocity=pi / 2)
    enter, leave = crossings(turning, Ball((0, 2), RADIUS), seconds=2.0)
    for hit, side in ((enter, 1), (leave, -1)):
        # Where it touches, the bar is as far from its pivot as the tangent of the ball through the pivot is long.
        arm = sqrt(4 - RADIUS**2)
        assert hypot(*hit.point) == pytest.approx(arm)
        assert hit.speed == pytest.approx(pi / 2 * arm)
        angle = pi / 2 * hit.time
        assert hit.point == pytest.approx((arm * np.cos(angle), arm * np.sin(angle)))
        assert hit.normal == pytest.approx((-side * np.sin(angle), side * np.cos(angle)))


def test_a_moving_segment_that_is_left_past_its_end_is_left_at_its_end() -> None:
    bar = Segment((-1, 0), (1, 0), sensor=True, motion="kinematic", velocity=(-1, 0.0))
    enter, leave = crossings(bar, Ball((-4, 0.1), RADIUS, velocity=(2, 0)))
    assert enter.time == pytest.approx(1.0)
    assert enter.point == pytest.approx((-2, 0), abs=1e-6)
    assert leave.time == pytest.approx(5 / 3)
    assert leave.point == pytest.approx((1 - 5 / 3, 0), abs=1e-6)
    assert leave.normal == pytest.approx((0, 1), abs=1e-6)


def test_balls_that_sense_each_other_touch_on_the_earlier_ones_edge() -> None:
    world = World(detection="continuous")
    first = world.add(Ball((0, 0), 1.0, velocity=(0.5, 0), sensor=True))
    last = world.add(Ball((4, 0), 0.5, velocity=(-1.5, 0)))
    enter, leave = world.run(4.0)
    for hit, side in ((enter, 1.0), (leave, -1.0)):
        assert (hit.ball, hit.shape, hit.speed, hit.velocity) == (last, first, 2.0, (-1.5, 0.0))
        assert hit.normal == (side, 0.0)
        assert hit.point == pytest.approx((0.5 * hit.time + side, 0))
        assert hit.position == pytest.approx((4 - 1.5 * hit.time, 0))


def test_balls_of_one_place_have_a_normal_too() -> None:
    world = World(detection="continuous")
    world.add(Ball((0, 0), 1.0, sensor=True))
    world.add(Ball((0, 0), 0.5))
    (enter,) = world.step(0.1)
    assert (enter.normal, enter.point, enter.speed) == ((0.0, 1.0), (0.0, 1.0), 0.0)


def test_what_a_switch_or_a_removal_ends_has_a_place_and_a_velocity_only() -> None:
    for gone in ("switch", "remove"):
        world = World(detection="continuous")
        eye = world.add(Circle((0, 0), 2, solid=True, sensor=True))
        world.add(Ball((0, 0), RADIUS, velocity=(1, 0)))
        assert [hit.kind for hit in world.step(0.5)] == [HitKind.ENTER]
        if gone == "switch":
            eye.can_collide = False
        else:
            world.remove(eye)
        leave = world.step(1e-3)[0]
        assert (leave.kind, leave.point, leave.normal, leave.speed) == (HitKind.EXIT, (0, 0), (0, 0), 0.0)
        assert leave.position == pytest.approx((0.5, 0.0))
        assert leave.velocity == (1.0, 0.0)
