"""Neighbours: what is nearest to a place, and how far away."""

from math import pi

import pytest

from carom import Arc, Ball, Circle, Segment
from carom.world import Neighbor
from tests.worlds import world_of


def test_the_nearest_shape_is_told_with_its_distance_and_point() -> None:
    segment, arc, ball = Segment((0, 0), (4, 0)), Arc((10, 0), 2, 0, pi), Ball((0, 29), 1)
    world = world_of(segment, arc, ball)
    assert world.nearest((7, 4)) == Neighbor(arc, pytest.approx(3), pytest.approx((8.8, 1.6)))
    assert world.nearest((-3, 4)) == Neighbor(segment, 5, (0, 0))
    assert world.nearest((2, 1)) == Neighbor(segment, 1, (2, 0))
    assert world.nearest((0, 32)) == Neighbor(ball, 2, (0, 30))
    assert world.nearest((11, -1)).shape is arc


def test_distances_are_negative_inside_of_what_is_solid() -> None:
    ball, disc, ring = Ball((0, 0), 2), Circle((20, 0), 5, solid=True), Circle((20, 0), 5)
    small = Ball((0, 1.9), 0.05)
    assert world_of(ball, small).nearest((0, 1)) == Neighbor(ball, -1, (0, 2))
    assert world_of(Ball((0, 0.5), 1), ball := Ball((0, 0), 2)).nearest((0, 1)).shape is ball
    assert world_of(disc).nearest((20, 0)).distance == -5
    assert world_of(ring).nearest((20, 1)) == Neighbor(ring, 4, (20, 5))


def test_of_two_as_near_the_one_added_first_is_nearest() -> None:
    ball, wall = Ball((-3, 0), 1), Segment((2, -1), (2, 1))
    assert world_of(ball, wall).nearest((0, 0)).shape is ball
    ball, wall = Ball((-3, 0), 1), Segment((2, -1), (2, 1))
    assert world_of(wall, ball).nearest((0, 0)).shape is wall
