"""A ball in a round room whose velocity is turned round goes back along its own way."""

from fractions import Fraction
from math import cos, hypot, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from tests.worlds import continuous_world

IMPACTS = 100_000
MOST = 1e-9  # of the room's radius and of the speed, after so many impacts there and as many back
CENTERS = [(0.0, 0.0), (3.3, -7.1)]

#: A ball's radius, where it starts and how fast, all as parts of the room's radius, and its two angles.
RADII, STARTS, ANGLES = st.floats(0.01, 0.5), st.floats(0.0, 0.9), st.floats(0.0, 2.0 * pi)
SCALES = st.sampled_from([1e-3, 1.0, 1e3])


def launched(
    center: tuple[float, float], room: float, radius: float, start: float, turn: float, angle: float
) -> tuple[carom.World, carom.Ball]:
    """A round room with one ball, which crosses a radius of the room in a second."""
    world = continuous_world(carom.Circle(center, room))
    away = start * (1.0 - radius) * room
    place = center[0] + away * cos(turn), center[1] + away * sin(turn)
    return world, world.add(carom.Ball(place, radius * room, velocity=(room * cos(angle), room * sin(angle))))


def turning(ball: carom.Ball, center: tuple[float, float]) -> Fraction:
    """The angular momentum of a ball about a place, per mass, without rounding."""
    x, y = (Fraction(place) - Fraction(middle) for place, middle in zip(ball.position, center, strict=True))
    vx, vy = map(Fraction, ball.velocity)
    return x * vy - y * vx


def square_of_speed(ball: carom.Ball) -> Fraction:
    """The square of a ball's speed without rounding."""
    vx, vy = map(Fraction, ball.velocity)
    return vx * vx + vy * vy


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("center", CENTERS)
@pytest.mark.parametrize("angle", [0.3, 1.1, 1.9, 2.8, 4.0, 5.1])
def test_a_ball_comes_back_to_where_it_was_sent(center: tuple[float, float], angle: float) -> None:
    world, ball = launched(center, 1.0, 0.05, 0.6, 2.0, angle)
    place, velocity = ball.position, ball.velocity
    impacts = steps = 0
    while impacts < IMPACTS:
        impacts += len(world.step(1000.0))
        steps += 1
    ball.velocity = -ball.velocity[0], -ball.velocity[1]
    for _ in range(steps):
        world.step(1000.0)
    assert ball.position == pytest.approx(place, abs=MOST)
    assert ball.velocity == pytest.approx((-velocity[0], -velocity[1]), abs=MOST)


@pytest.mark.compiled
@given(center=st.sampled_from(CENTERS), room=SCALES, radius=RADII, start=STARTS, turn=ANGLES, angle=ANGLES)
def test_what_rounding_takes_from_speed_and_turning_does_not_add_up(
    center: tuple[float, float], room: float, radius: float, start: float, turn: float, angle: float
) -> None:
    world, ball = launched((room * center[0], room * center[1]), room, radius, start, turn, angle)
    center, way = (room * center[0], room * center[1]), (1.0 - radius) * room
    turned, square = turning(ball, center), square_of_speed(ball)
    steepest = hypot(*ball.velocity) * way
    if abs(float(turned)) > 0.999 * steepest:
        return  # it goes along the wall, where speed and turning tell the same
    world.run(2000.0, 100.0)
    # Places are rounded as the centre's distance from the origin says.
    roundings = 1.0 + hypot(*center) / way
    assert abs(float(turning(ball, center) - turned)) <= 4e-16 * roundings * room * way
    assert abs(float(square_of_speed(ball) - square)) <= 1e-15 * room * room
