"""Balls: what they are, how they move, and how they respond."""

from math import hypot

import pytest

from carom import Aabb, Ball, Circle, InvalidArgument, Motion, Segment


def test_the_defaults() -> None:
    ball = Ball((1, 2), 3)
    assert (ball.kind, ball.position, ball.center, ball.radius) == ("ball", (1.0, 2.0), (1.0, 2.0), 3.0)
    assert (ball.velocity, ball.mass, ball.elasticity, ball.asleep) == ((0.0, 0.0), 1.0, 1.0, False)
    assert (ball.motion, ball.orientation, ball.id, ball.world) == (Motion.DYNAMIC, 0.0, None, None)
    assert ball.aabb == Aabb(-2, -1, 4, 5)
    assert repr(ball) == "Ball((1.0, 2.0), 3.0, velocity=(0.0, 0.0), mass=1.0)"


def test_everything_can_be_set() -> None:
    ball = Ball((1, 2), 3)
    ball.position, ball.velocity, ball.radius, ball.mass = (4, 5), (6, 7), 8, 9
    ball.elasticity, ball.sensor, ball.can_collide, ball.layer, ball.collides_with = 0.5, True, False, 2, 4
    ball.name, ball.user = "eight", {"points": 8}
    assert (ball.position, ball.velocity, ball.radius, ball.mass) == ((4.0, 5.0), (6.0, 7.0), 8.0, 9.0)
    assert (ball.elasticity, ball.sensor, ball.can_collide, ball.layer, ball.collides_with) == (0.5, True, False, 2, 4)
    assert (ball.name, ball.user) == ("eight", {"points": 8})
    ball.center = (0, 0)
    assert ball.position == (0.0, 0.0)


def test_a_ball_flies_the_exact_parabola() -> None:
    ball = Ball((0, 10), 1, velocity=(3, 4))
    ball.move(0.5, gravity=(0, -8))
    assert (ball.position, ball.velocity) == ((1.5, 11.0), (3.0, 0.0))
    ball.move(2)
    assert ball.position == (7.5, 11.0)
    split, whole = Ball((0, 10), 1, (3, 4)), Ball((0, 10), 1, (3, 4))
    for _ in range(64):
        split.move(1 / 64, (1, -9.8))
    whole.move(1, (1, -9.8))
    assert split.position == pytest.approx(whole.position, rel=1e-14)


def test_a_ball_stays_in_the_range_of_numbers() -> None:
    with pytest.raises(InvalidArgument, match="position must leave the ball's box and velocity finite"):
        Ball((1e308, 0), 1e308)
    ball = Ball((0, 0), 1, velocity=(1e308, 0))
    with pytest.raises(InvalidArgument, match="dt must leave"):
        ball.move(1e10)
    assert ball.position == (0.0, 0.0)


def test_the_distance_is_to_the_perimeter() -> None:
    ball = Ball((0, 0), 2)
    assert (ball.closest_point((0, 5)), ball.distance((0, 5)), ball.distance((0, 0.5))) == ((0.0, 2.0), 3.0, 1.5)


def test_a_static_wall_turns_the_normal_velocity_alone() -> None:
    ball = Ball((0, 0.75), 1, velocity=(3, -4), elasticity=0.5)
    wall = Segment((-5, 0), (5, 0), elasticity=0.5)
    ball.respond(wall.detect(ball))
    assert (ball.position, ball.velocity) == ((0.0, 1.0), (3.0, 1.0))


def test_the_total_restitution_scales_all_of_it() -> None:
    ball = Ball((0, 0.75), 1, velocity=(3, -4), elasticity=0.5)
    ball.respond(Segment((-5, 0), (5, 0)).detect(ball), restitution="total")
    assert (ball.position, ball.velocity) == ((0.0, 1.0), (1.5, 2.0))


def test_a_ball_that_leaves_is_moved_and_not_turned() -> None:
    ball = Ball((0, 0.75), 1, velocity=(3, 4))
    ball.respond(Segment((-5, 0), (5, 0), kick=9).detect(ball))
    assert (ball.position, ball.velocity) == ((0.0, 1.0), (3.0, 4.0))


def test_a_kick_is_added_along_the_normal() -> None:
    for restitution in ("normal", "total"):
        ball = Ball((0, 0.75), 1, velocity=(0, -4))
        ball.respond(Segment((-5, 0), (5, 0), kick=9).detect(ball), restitution)
        assert ball.velocity == (0.0, 13.0)


def test_a_flipper_at_rest_is_a_wall_and_a_swinging_one_adds_its_speed() -> None:
    ball = Ball((2, 0.75), 1, velocity=(0, -4))
    flipper = Segment((0, 0), (5, 0), motion="kinematic", pivot=(0, 0), elasticity=0.5)
    contact = flipper.detect(ball)
    assert contact is not None
    assert contact.speed == 4.0
    ball.respond(contact)
    assert ball.velocity == (0.0, 2.0)
    ball.position, ball.velocity, flipper.angular_velocity = (2, 0.75), (0, -4), 3.0
    contact = flipper.detect(ball)
    assert contact is not None
    assert contact.speed == 10.0  # the surface comes up at 6
    ball.respond(contact)
    assert ball.velocity == (0.0, 11.0)  # 6 up, and half of the relative 10


def test_a_sensor_is_met_and_moves_nothing() -> None:
    for shape_senses in (True, False):
        ball = Ball((0, 0.75), 1, velocity=(0, -4), sensor=not shape_senses)
        contact = Segment((-5, 0), (5, 0), sensor=shape_senses).detect(ball)
        assert contact is not None
        ball.respond(contact)
        assert (ball.position, ball.velocity) == ((0.0, 0.75), (0.0, -4.0))


def test_newtons_cradle() -> None:
    left, right = Ball((0, 0), 1, velocity=(3, 0)), Ball((1.5, 0), 1)
    contact = left.detect(right)
    assert contact is not None
    assert (contact.shape, contact.ball, contact.normal, contact.setback, contact.speed) == (
        left,
        right,
        (1.0, 0.0),
        0.5,
        3.0,
    )
    right.respond(contact)
    assert (left.position, right.position) == ((-0.25, 0.0), (1.75, 0.0))
    assert (left.velocity, right.velocity) == ((0.0, 0.0), (3.0, 0.0))


def test_the_heavier_ball_gives_way_less() -> None:
    light, heavy = Ball((0, 0), 1, mass=1), Ball((1, 0), 1, mass=3)
    light.respond(light.detect(heavy))
    assert (light.position, heavy.position) == ((-0.75, 0.0), (1.25, 0.0))


def test_pairs_are_always_normal() -> None:
    first, second = Ball((0, 0), 1, velocity=(2, 2)), Ball((1.5, 0), 1, velocity=(-2, 2), elasticity=0.5)
    second.respond(first.detect(second), restitution="total")
    assert (first.velocity, second.velocity) == ((-1.0, 2.0), (1.0, 2.0))


def test_balls_with_one_centre_part_against_their_velocity() -> None:
    first, second = Ball((0, 0), 1), Ball((0, 0), 1, velocity=(0, -3))
    contact = first.detect(second)
    assert contact is not None
    assert (contact.normal, contact.setback) == ((0.0, 1.0), 2.0)
    second.respond(contact)
    assert hypot(second.position[0] - first.position[0], second.position[1] - first.position[1]) == 2.0


def test_a_ball_does_not_meet_itself() -> None:
    ball = Ball((0, 0), 1)
    assert ball.detect(ball) is None


def test_the_contact_of_another_ball_is_refused() -> None:
    ball = Ball((0, 0), 1)
    contact = Circle((1, 0), 1).detect(ball)
    assert contact is not None
    with pytest.raises(InvalidArgument, match="contact must be a Contact of this ball"):
        Ball((0, 0), 1).respond(contact)
