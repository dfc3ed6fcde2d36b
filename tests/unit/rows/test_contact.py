"""Contacts of balls with shapes and with each other: their numbers, the speed of the surface, masks, and misses."""

import pytest

from carom import Ball, Circle, Gate, Segment
from carom.rows.contact import contact_of_balls, contact_with_shape


def test_a_ball_in_a_wall_is_pushed_out_by_its_depth_and_comes_with_its_speed() -> None:
    wall, ball = Segment((0, 0), (10, 0)), Ball((4, 0.75), 1, velocity=(3, -4))
    assert contact_with_shape(wall._row, ball._row) == (4.0, 0.0, 0.0, 1.0, 0.25, 5.0)
    ball.position = (4, 1)
    assert contact_with_shape(wall._row, ball._row) is None


def test_the_speed_is_relative_to_the_surface_at_the_point() -> None:
    wheel = Circle((0, 0), 2, solid=True, motion="kinematic", angular_velocity=3.0, velocity=(1, 0))
    ball = Ball((0, 2.5), 1, velocity=(1, 0))
    assert contact_with_shape(wheel._row, ball._row) == pytest.approx((0, 2, 0, 1, 0.5, 6))


def test_where_centres_coincide_the_way_relative_to_the_surface_decides() -> None:
    post = Circle((0, 0), 2, solid=True, motion="kinematic", velocity=(0, 3))
    assert contact_with_shape(post._row, Ball((0, 0), 1)._row) == pytest.approx((0, 2, 0, 1, 3, 3))


def test_a_gate_yields_one_on_its_closed_side_alone() -> None:
    gate = Gate((0, 0), (10, 0), direction=(0, 1))
    assert contact_with_shape(gate._row, Ball((4, 0.5), 1, velocity=(0, -1))._row) is not None
    assert contact_with_shape(gate._row, Ball((4, -0.5), 1, velocity=(0, 1))._row) is None


def test_of_two_balls_the_normal_leads_from_the_first_to_the_second() -> None:
    first, second = Ball((0, 0), 1, velocity=(1, 0)), Ball((1.5, 0), 1, velocity=(-1, 0))
    assert contact_of_balls(first._row, second._row) == (1.0, 0.0, 1.0, 0.0, 0.5, 2.0)
    assert contact_of_balls(second._row, first._row) == (0.5, 0.0, -1.0, 0.0, 0.5, 2.0)
    second.position = (2, 0)
    assert contact_of_balls(first._row, second._row) is None


@pytest.mark.parametrize("change", [{"can_collide": False}, {"layer": 2}, {"collides_with": 2}])
def test_masks_and_switches_hold(change: dict[str, int]) -> None:
    wall, ball = Segment((0, 0), (10, 0), collides_with=1), Ball((4, 0.5), 1, collides_with=1)
    other = Ball((4, 1), 1, **change)
    assert contact_of_balls(ball._row, other._row) is None
    assert contact_of_balls(other._row, ball._row) is None
    assert contact_with_shape(wall._row, Ball((4, 0.5), 1, **change)._row) is None
    assert contact_with_shape(wall._row, ball._row) is not None
