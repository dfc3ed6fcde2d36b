"""Balls as large as the bend in which they lie: which those are, where they are pulled, and when they drop out."""

from math import cos, pi, sin

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Segment, Shape
from carom.constants import SHORT_GAP
from carom.world.kernels.continuous.filling import (
    drops_out,
    fills_bend,
    is_bent_there,
    pull_in_bend,
    settle_in_bend,
)
from carom.world.kernels.continuous.surfaces import out_of_frame
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world

MOVING = {"motion": "kinematic", "pivot": (0.5, -0.5), "velocity": (1.5, -0.5), "angular_velocity": 2.0}


def bends() -> list[Shape]:
    """A ring and an arc that travel and turn."""
    made: list[Shape] = [Circle((1, 1), 0.7, **MOVING), Arc((1, 1), 0.7, 0.3, 3.0, **MOVING)]
    for shape in made:
        shape._row["spin"] = 2.0
    return made


@pytest.mark.parametrize("kind", range(2))
@pytest.mark.parametrize("age", [0.0, 0.4, -1.3])
def test_a_ball_fills_a_bend_if_it_is_at_its_centre_wherever_that_has_come_to(kind: int, age: float) -> None:
    row = bends()[kind]._row
    x, y = out_of_frame(row, age, 1.0, 1.0)
    for angle in (0.0, 2.0, 4.0):
        for off in (0.0, 0.9, 1.1):
            away = off * SHORT_GAP * 0.7
            assert fills_bend(row, age, x + away * cos(angle), y + away * sin(angle), 0.7) == (off < 1.0)


def test_nothing_fills_what_is_straight() -> None:
    assert not fills_bend(Segment((-1, 0), (2, 0))._row, 0.0, 0.0, 0.0, 0.7)


@pytest.mark.parametrize("age", [0.0, 0.4])
def test_what_pulls_a_ball_in_a_bend_is_gravity_less_what_its_centre_is_accelerated_by(age: float) -> None:
    row = bends()[0]._row
    x, y = out_of_frame(row, age, 1.0, 1.0)
    ball = in_flight(continuous_world(Ball((x, y), 0.7))).balls.rows[0]
    step = 1e-4
    places = np.array([out_of_frame(row, age + step * k, 1.0, 1.0) for k in (-1, 0, 1)])
    bent = (places[0] - 2 * places[1] + places[2]) / step**2
    found = pull_in_bend(ball, row, age, 3.0, -10.0)
    assert found is not None
    assert found[2:] == pytest.approx(bent, abs=1e-5)
    pull = np.subtract((3.0, -10.0), bent)
    assert found[:2] == pytest.approx(pull / np.hypot(*pull), abs=1e-6)
    assert pull_in_bend(ball, row, age, *found[2:]) is None  # as in free fall
    ball["x"] += 0.1
    assert pull_in_bend(ball, row, age, 3.0, -10.0) is None


@pytest.mark.parametrize("half", [0.55, 1.2, pi / 2, 2.0])
@pytest.mark.parametrize("away", [0.0, 1e-16, 1e-9, 1e-6])
def test_a_ball_settles_where_it_is_pulled_or_drops_out_of_no_more_than_half_a_turn(half: float, away: float) -> None:
    arrays = in_flight(continuous_world(Arc((0, 0), 1, -half, half), Ball((0, away), 1)))
    flight, row = arrays.flights[0], arrays.shapes.rows[0]
    for angle in np.arange(-3.1, 3.2, 0.2):
        ball = arrays.balls.rows[0].copy()
        px, py = cos(angle), sin(angle)
        below = abs(angle) < half
        assert is_bent_there(ball, row, 0.0, px, py) == below
        assert drops_out(ball, flight, row, 10 * px, 10 * py) == (not below and half < 1.6)
        assert settle_in_bend(ball, flight, row, 0.0, 10 * px, 10 * py) == below
        if below:
            assert (ball["x"], ball["y"]) == pytest.approx((away * px, away * py), rel=1e-12, abs=1e-30)
            assert (flight["ax"], flight["ay"]) == (0.0, 0.0)


def test_no_ball_drops_out_of_a_ring() -> None:
    arrays = in_flight(continuous_world(Circle((0, 0), 1), Ball((0, 0), 1)))
    assert not drops_out(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], 0.0, -10.0)
    assert settle_in_bend(arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], 0.0, 0.0, -10.0)
