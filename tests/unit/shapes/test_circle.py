"""Circles: arenas and bumpers."""

from math import pi

import pytest

from carom import Ball, Circle, InvalidArgument


def test_a_circle_is_what_it_was_made() -> None:
    circle = Circle((1, 2), 3)
    assert (circle.center, circle.position, circle.radius, circle.solid) == ((1.0, 2.0), (1.0, 2.0), 3.0, False)
    assert tuple(circle.aabb) == (-2.0, -1.0, 4.0, 5.0)
    assert (repr(circle), repr(Circle((1, 2), 3, solid=True))) == (
        "Circle((1.0, 2.0), 3.0)",
        "Circle((1.0, 2.0), 3.0, solid=True)",
    )


def test_the_closest_point_is_on_the_perimeter() -> None:
    circle = Circle((1, 2), 3)
    assert circle.closest_point((1, 9)) == (1.0, 5.0)
    assert circle.closest_point((1, 2.5)) == (1.0, 5.0)
    assert circle.closest_point((1, 2)) == (4.0, 2.0)
    assert (circle.distance((1, 2.5)), circle.distance((1, 9))) == (2.5, 4.0)


def test_a_parameter_is_the_way_round_from_angle_zero() -> None:
    circle = Circle((1, 2), 3)
    assert circle.length == 6 * pi
    assert circle.parameter((9, 2)) == 0.0
    assert circle.parameter((1, 2)) == 0.0
    assert circle.parameter((1, 2.5)) == pytest.approx(1.5 * pi)
    assert circle.parameter((4, 2 - 1e-6)) == pytest.approx(6 * pi - 1e-6)


def test_a_ball_inside_bounces_off_the_inside_of_an_arena() -> None:
    contact = Circle((0, 0), 10).detect(Ball((9.5, 0), 1))
    assert contact is not None
    assert (contact.point, contact.normal, contact.setback) == ((10.0, 0.0), (-1.0, 0.0), 0.5)


def test_a_ball_inside_a_bumper_is_pushed_out() -> None:
    contact = Circle((0, 0), 10, solid=True).detect(Ball((9.5, 0), 1))
    assert contact is not None
    assert (contact.point, contact.normal, contact.setback) == ((10.0, 0.0), (1.0, 0.0), 1.5)


def test_in_the_middle_of_an_arena_nothing_is_met() -> None:
    assert Circle((0, 0), 10).detect(Ball((1, 1), 1)) is None


@pytest.mark.parametrize(("velocity", "normal"), [((3, 4), (-0.6, -0.8)), ((0, 0), (0.0, 1.0))])
def test_centres_that_coincide(velocity: tuple[int, int], normal: tuple[float, float]) -> None:
    contact = Circle((0, 0), 2, solid=True).detect(Ball((0, 0), 1, velocity))
    assert contact is not None
    assert contact.normal == pytest.approx(normal)
    assert contact.setback == 3.0


def test_changes_keep_everything_in_step() -> None:
    circle = Circle((1, 2), 3)
    circle.radius = 5
    circle.center = (0, 0)
    assert (tuple(circle.aabb), circle.pivot) == ((-5.0, -5.0, 5.0, 5.0), (0.0, 0.0))
    circle.solid = True
    assert circle.detect(Ball((1, 0), 1)) is not None


def test_the_range_of_numbers_is_not_left() -> None:
    with pytest.raises(InvalidArgument, match="radius must leave the shape's place and box finite"):
        Circle((1e308, 0), 1e308)
    circle = Circle((1e308, 0), 1)
    with pytest.raises(InvalidArgument, match="radius must leave"):
        circle.radius = 1.7e308
    assert circle.radius == 1.0
