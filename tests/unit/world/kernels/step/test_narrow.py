"""A ball that overlaps a shape or another ball: how they are moved apart, and what they give each other."""

from math import cos, pi, sin

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, World
from carom.world.kernels.step.narrow import boxes_apart, is_between_ends, seen_from
from tests.kernel_calls import advance_pose


def test_boxes_that_touch_are_not_apart() -> None:
    ball = Ball((0, 0), radius=1)._row
    assert not boxes_apart(ball, Point((1, 1))._row)
    assert boxes_apart(ball, Point((np.nextafter(1, 2), 0))._row)
    assert boxes_apart(ball, Point((0, np.nextafter(-1, -2)))._row)


def test_a_normal_points_from_the_shape_to_the_ball_on_either_side() -> None:
    for y in (1, -1):
        world = World(detection="discrete", substeps=1)
        world.add(Segment((-9, 0), (9, 0)))
        world.add(Ball((0, y), radius=1, velocity=(0, -y)))
        (hit,) = world.step(0.1)
        assert hit.normal == (0, y)


@pytest.mark.parametrize("masses", [(1e-9, 1e9), (1e9, 1e-9)])
def test_the_impulse_of_a_pair_is_right_however_unequal_the_masses(masses: tuple[float, float]) -> None:
    world = World(detection="discrete", substeps=1)
    for x, mass in zip((0.0, 1.9), masses, strict=True):
        world.add(Ball((x, 0), radius=1, velocity=(0.3 - x, 0.1), mass=mass))
    (hit,) = world.step(0.0)
    assert hit.impulse == pytest.approx(2 * 1e-9 * 1.9, rel=1e-12)


def test_the_impulse_is_the_momentum_given_along_the_normal() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        world = World(
            detection="discrete", substeps=1, iterations=1, restitution="total" if rng.random() < 0.5 else "normal"
        )
        options = {"elasticity": rng.uniform(0, 1.3), "kick": rng.uniform(0, 2)}
        world.add(Circle((0, 0), 1, solid=True, motion="kinematic", velocity=tuple(rng.normal(size=2)), **options))
        ball = world.add(Ball(tuple(rng.normal(size=2)), radius=1.5, velocity=tuple(rng.normal(size=2)), mass=3))
        before = ball.velocity
        for hit in world.step(0.01):
            change = [ball.velocity[k] - before[k] for k in range(2)]
            assert hit.impulse == pytest.approx(3 * (change[0] * hit.normal[0] + change[1] * hit.normal[1]), rel=1e-9)


def test_two_balls_at_one_place_part_against_their_relative_velocity_and_are_counted() -> None:
    world = World(detection="discrete", substeps=1)
    first = world.add(Ball((0, 0), radius=1))
    second = world.add(Ball((-0.5, 0), radius=1, velocity=(1, 0)))
    hits = world.step(0.5)
    assert world.statistics.overlaps == 1
    assert (first.position, second.position) == ((1, 0), (-1, 0))
    assert (first.velocity, second.velocity) == ((1, 0), (0, 0))
    assert len(hits) == 1


def test_balls_at_rest_at_one_place_part_upwards() -> None:
    world = World(detection="discrete", substeps=1)
    balls = [world.add(Ball((3, 3), radius=1)) for _ in range(2)]
    assert len(world.step(0.1)) == 0
    assert [ball.position for ball in balls] == [(3, 2), (3, 4)]
    assert world.statistics.overlaps == 1


def test_a_ball_at_rest_on_a_post_is_moved_up() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Point((3, 3)))
    ball = world.add(Ball((3, 3), radius=1))
    world.step(0.1)
    assert ball.position == (3, 4)
    assert ball.velocity == (0, 0)


def test_a_moved_ball_is_seen_from_a_shape_at_rest_where_it_is() -> None:
    hand = Segment((0.1, 0.7), (3.3, 1.9), motion="kinematic", pivot=(0.3, 0.1))
    advance_pose(hand._row, 0.1)
    places = np.random.default_rng(1).uniform(-9, 9, (200, 2))
    assert [seen_from(hand._row, x, y) for x, y in places.tolist()] == [tuple(place) for place in places.tolist()]


def test_a_place_that_turns_and_travels_with_a_shape_is_seen_where_it_comes_to() -> None:
    hand = Segment((1, 0), (3, 0), motion="kinematic", pivot=(1, 0), angular_velocity=pi, velocity=(2, -4))
    advance_pose(hand._row, 0.5)
    assert seen_from(hand._row, 3.0, 0.0) == pytest.approx((2, 0))
    assert hand._row["by"] == pytest.approx(0)


def test_the_reach_of_an_arc_is_its_sector_and_that_of_a_segment_its_slab() -> None:
    arc = Arc((1, 1), 5, pi / 4, 3 * pi / 4)._row
    assert is_between_ends(arc, 1 + cos(pi / 4), 1 + sin(pi / 4), 0.1)
    assert is_between_ends(arc, 1.0, 90.0, 0.1)
    assert not is_between_ends(arc, 9.0, 2.0, 0.1)
    wall = Segment((0, 0), (0, 4))._row
    assert is_between_ends(wall, 7.0, 4.0, 0.1)
    assert is_between_ends(wall, 0.0, 4.0000000001, 0.5)
    assert not is_between_ends(wall, 0.0, 4.0000001, 0.5)
