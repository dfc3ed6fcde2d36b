"""The billiards are the rooms of the textbooks, and their balls start almost alike and meet nothing but the walls."""

from collections.abc import Callable
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin

import pytest

import carom
from carom.scene.shipped.billiards import BALLS, SPEED, SPREAD, sinai, stadium
from carom.shapes.shape import Shape

BOTH = pytest.mark.parametrize("make", [stadium, sinai])


def shapes_of(scene: carom.Scene) -> list[Shape]:
    """The shapes of a scene's world, without the points that guard their ends."""
    return [shape for shape in scene.build().shapes if isinstance(shape, Shape) and not isinstance(shape, carom.Point)]


@BOTH
def test_balls_start_in_one_place_in_almost_one_direction(make: Callable[[], carom.Scene]) -> None:
    balls = make().balls
    assert len(balls) == BALLS
    assert len({ball.position for ball in balls}) == 1
    assert [hypot(*ball.velocity) for ball in balls] == pytest.approx([SPEED] * BALLS, rel=1e-15)
    directions = [atan2(ball.velocity[1], ball.velocity[0]) for ball in balls]
    assert [later - earlier for earlier, later in pairwise(directions)] == pytest.approx([SPREAD] * (BALLS - 1))


@BOTH
def test_balls_meet_walls_and_not_each_other_and_lose_nothing(make: Callable[[], carom.Scene]) -> None:
    world = make().build()
    for ball in world.balls:
        assert not any(ball.layer & other.collides_with for other in world.balls)
        for shape in world.shapes:
            assert ball.layer & shape.collides_with
            assert shape.layer & ball.collides_with
    assert {member.elasticity for member in (*shapes_of(make()), *world.balls)} == {1.0}


def test_the_stadium_is_what_lies_within_two_of_a_segment() -> None:
    walls = shapes_of(stadium())
    around = [(x, side * 2.0) for x in (-2.0, -0.5, 1.0, 2.0) for side in (-1.0, 1.0)]
    for step in range(20):
        angle = pi * (step / 19.0 - 0.5)
        around += [(side * (2.0 + 2.0 * cos(angle)), 2.0 * sin(angle)) for side in (-1.0, 1.0)]
    for place in around:
        assert min(wall.distance(place) for wall in walls) < 1e-12, place
    for x in (-2.0, -1.0, 0.0, 2.0):
        assert min(wall.distance((x, 0.0)) for wall in walls) == pytest.approx(2.0)


def test_sinais_room_is_a_square_round_a_solid_disc() -> None:
    *walls, disc = shapes_of(sinai())
    assert isinstance(disc, carom.Circle)
    assert (disc.center, disc.radius, disc.solid) == ((0.0, 0.0), 1.0, True)
    for along in (-2.0, -0.7, 0.0, 1.9):
        for place in ((along, -2.0), (along, 2.0), (-2.0, along), (2.0, along)):
            assert min(wall.distance(place) for wall in walls) == 0.0, place
    assert len(walls) == 4


def test_the_stadiums_joints_are_tangent() -> None:
    assert carom.guard_points([shape.build() for shape in stadium().shapes]) == []
    assert len(stadium().build().shapes) == len(stadium().shapes)
