"""What rounding takes from a ball at an impact with what is bent is kept, and given back."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.rows.ball import BALL, BallRow
from carom.rows.flight import FLIGHT, FlightRow
from carom.world.kernels.continuous.rounding import keep_rounding, way_of
from tests.worlds import continuous_world

#: Roundings by which a velocity is off, in units of the last place of 1.
OFF = st.integers(-4, 4)


def ball_at(x: float, y: float, vx: float, vy: float) -> tuple[BallRow, FlightRow]:
    """The rows of a ball of radius .25 that falls nowhere."""
    ball, flight = np.zeros(1, BALL)[0], np.zeros(1, FLIGHT)[0]
    for name, value in {"x": x, "y": y, "vx": vx, "vy": vy, "radius": 0.25}.items():
        ball[name] = value
    return ball, flight


def turned(ball: BallRow, flight: FlightRow) -> tuple[Fraction, Fraction]:
    """The angular momentum about the origin and the square of the speed, with what the velocity's doubles lack."""
    x, y = Fraction(float(ball["x"])), Fraction(float(ball["y"]))
    vx = Fraction(float(ball["vx"])) + Fraction(float(flight["low_vx"]))
    vy = Fraction(float(ball["vy"])) + Fraction(float(flight["low_vy"]))
    return x * vy - y * vx, vx * vx + vy * vy


def a_ring() -> carom.World:
    """A world with a ring of radius 1."""
    return continuous_world(carom.Circle((0, 0), 1))


@given(off_x=OFF, off_y=OFF, low=st.floats(-1e-16, 1e-16))
def test_turning_and_speed_are_what_they_were_before_the_impact(off_x: int, off_y: int, low: float) -> None:
    shape = a_ring()._arrays.shapes.used[0]
    ball, flight = ball_at(0.1, 0.2, 0.6, -0.4)
    flight["low_vx"] = low
    before, came = turned(ball, flight), way_of(ball, flight)
    # It comes to (.45, .6), more or less, and is sent back there with a velocity that is off by some roundings.
    ball["x"], ball["y"], flight["low_vx"] = 0.45, 0.6, 0.0
    turning = before[0]
    # The velocity of that turning and speed which leads into the room, to the last digits.
    along = float(turning) / 0.75
    inward = -(float(before[1] - Fraction(along) ** 2) ** 0.5)
    ball["vx"] = inward * 0.6 - along * 0.8 + off_x * 2.0**-53
    ball["vy"] = inward * 0.8 + along * 0.6 + off_y * 2.0**-53
    keep_rounding(ball, flight, shape, came)
    after = turned(ball, flight)
    assert abs(after[0] - before[0]) < 1e-30
    assert abs(after[1] - before[1]) < 1e-30
    assert float(ball["vx"]) + float(flight["low_vx"]) == ball["vx"]


@pytest.mark.parametrize(("name", "value"), [("ax", 1e-3), ("ay", -10.0)], ids=["a pull along x", "a pull along y"])
def test_a_ball_that_falls_is_left_as_it_is(name: str, value: float) -> None:
    ball, flight = ball_at(0.45, 0.6, 0.3, -0.5)
    flight[name] = value  # type: ignore[literal-required]
    left = ball.copy()  # type: ignore[attr-defined]
    keep_rounding(ball, flight, a_ring()._arrays.shapes.used[0], (0.1, 0.2, 0.3, 0.5, 0.0, 0.0))
    assert ball == left
    assert flight["low_vx"] == flight["low_vy"] == 0.0


def test_an_impact_that_takes_more_than_rounding_is_left_as_it_is() -> None:
    ball, flight = ball_at(0.45, 0.6, -0.3, -0.4)
    left = ball.copy()  # type: ignore[attr-defined]
    # It came with twice the speed.
    keep_rounding(ball, flight, a_ring()._arrays.shapes.used[0], (0.0, 0.0, 0.6, 0.8, 0.0, 0.0))
    assert ball == left
    assert flight["low_vx"] == flight["low_vy"] == 0.0


def test_what_a_velocity_lacks_is_kept_in_snapshots_and_forgotten_where_the_velocity_is_set() -> None:
    world, other = a_ring(), carom.World()
    ball = world.add(carom.Ball((0.1, 0.2), 0.25, velocity=(0.6, -0.4)))
    world.step(1.0)
    while world._arrays.flights[0]["low_vx"] == 0.0:
        world.step(1.0)
    other.restore(world.snapshot())
    other.step(0.0)
    world.step(0.0)
    assert other._arrays.flights[0]["low_vx"] == world._arrays.flights[0]["low_vx"]
    assert other.run(50.0, 5.0).tobytes() == world.run(50.0, 5.0).tobytes()
    assert other.digest() == world.digest()
    ball.velocity = (0.3, 0.1)
    world.step(1e-6)
    assert world._arrays.flights[0]["low_vx"] == world._arrays.flights[0]["low_vy"] == 0.0
