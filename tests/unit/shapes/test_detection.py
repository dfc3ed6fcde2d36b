"""Who meets whom, and what a contact says."""

from dataclasses import FrozenInstanceError

import pytest

from carom import Arc, Ball, Circle, Contact, Point, Segment, Shape

SHAPES = [Point((0, 0)), Segment((-1, 0), (1, 0)), Circle((0, 0), 0.1), Arc((0, -0.1), 0.1, 0.5, 2.5)]


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_a_contact_says_all(shape: Shape) -> None:
    ball = Ball((0, 0.75), 1, velocity=(3, -4))
    contact = shape.detect(ball)
    assert contact is not None
    assert (contact.shape, contact.ball) == (shape, ball)
    top = shape.aabb.top
    assert contact.point == pytest.approx((0.0, top), abs=1e-15)
    assert contact.normal == (0.0, 1.0)
    assert contact.setback == pytest.approx(0.25 + top)
    assert contact.speed == 5.0
    assert {type(number) for number in (*contact.point, *contact.normal, contact.setback, contact.speed)} == {float}


def test_touching_is_no_contact() -> None:
    assert Point((0, 0)).detect(Ball((0, 1), 1)) is None
    assert Ball((0, 0), 1).detect(Ball((2, 0), 1)) is None


def test_a_contact_cannot_be_changed() -> None:
    contact = Point((0, 0)).detect(Ball((0, 0.5), 1))
    assert contact is not None
    with pytest.raises(FrozenInstanceError):
        contact.speed = 0.0  # type: ignore[misc]
    assert contact == Contact(contact.shape, contact.ball, (0.0, 0.0), (0.0, 1.0), 0.5, 0.0)


@pytest.mark.parametrize(
    ("options", "ball_options"),
    [
        ({"can_collide": False}, {}),
        ({}, {"can_collide": False}),
        ({"layer": 2}, {"collides_with": 1}),
        ({"collides_with": 2}, {"layer": 1}),
        ({"layer": 0}, {}),
    ],
)
def test_who_is_not_met(options: dict[str, int], ball_options: dict[str, int]) -> None:
    ball = Ball((0, 0.5), 1, **ball_options)
    assert Point((0, 0), **options).detect(ball) is None
    assert Ball((0, 0), 1, **options).detect(ball) is None
    assert ball.detect(Ball((0, 0), 1, **options)) is None


def test_layers_that_meet() -> None:
    ball = Ball((0, 0.5), 1, layer=0b100, collides_with=0b011)
    assert Point((0, 0), layer=0b010, collides_with=0b110).detect(ball) is not None


def test_a_ball_on_a_point_is_moved_back_against_its_velocity() -> None:
    contact = Point((1, 1)).detect(Ball((1, 1), 2, velocity=(0, 5)))
    assert contact is not None
    assert (contact.normal, contact.setback) == ((0.0, -1.0), 2.0)
    resting = Point((1, 1)).detect(Ball((1, 1), 2))
    assert resting is not None
    assert resting.normal == (0.0, 1.0)
