"""Balls that slide along bends and turning lines, against fine steps of their equations of motion."""

from math import cos, hypot, inf, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Segment
from carom.world.kernels.continuous.sliding import along_track, past_end, slid_along, turned_back, work_along


def in_fine_steps(
    bend: float, arm: tuple[float, float], pull: tuple[float, float], spin: float, seconds: float, speed: float
) -> tuple[float, float]:
    """Way and speed of a bead on a wire that begins along x, by the classical rule of Runge and Kutta."""

    def rate(time: float, way: float, now: float) -> np.ndarray:
        x, y = (sin(bend * way) / bend, (1 - cos(bend * way)) / bend) if bend else (way, 0.0)
        tx, ty = cos(bend * way), sin(bend * way)
        turn = -spin * time
        gx = pull[0] * cos(turn) - pull[1] * sin(turn)
        gy = pull[0] * sin(turn) + pull[1] * cos(turn)
        along = tx * (gx + spin**2 * (arm[0] + x)) + ty * (gy + spin**2 * (arm[1] + y))
        return np.array([now, along])

    state, steps = np.array([0.0, speed]), 200
    h = seconds / steps
    for k in range(steps):
        t = k * h
        one = rate(t, *state)
        two = rate(t + h / 2, *(state + h / 2 * one))
        three = rate(t + h / 2, *(state + h / 2 * two))
        four = rate(t + h, *(state + h * three))
        state = state + h / 6 * (one + 2 * two + 2 * three + four)
    return float(state[0]), float(state[1])


numbers = st.floats(-2, 2)


@pytest.mark.slow
@given(numbers, numbers, numbers, numbers, numbers, numbers, numbers)
def test_a_bead_goes_as_its_equations_say(
    bend: float, arm_x: float, arm_y: float, pull_x: float, pull_y: float, spin: float, speed: float
) -> None:
    track, arm, pull, seconds = (1.0, 0.0, bend), (arm_x, arm_y), (pull_x, pull_y), 0.05
    way, now = slid_along(track, arm, pull, 0.0, spin, seconds, speed)
    true_way, true_now = in_fine_steps(bend, arm, pull, spin, seconds, speed)
    assert way == pytest.approx(true_way, abs=1e-6)
    assert now == pytest.approx(true_now, abs=1e-5)


@given(numbers, numbers, numbers, numbers)
def test_its_speed_is_that_which_the_work_leaves_it(bend: float, pull_x: float, pull_y: float, speed: float) -> None:
    track, pull = (1.0, 0.0, bend), (pull_x, pull_y)
    way, now = slid_along(track, (0.3, -0.2), pull, 0.0, 0.0, 0.1, speed)
    work = work_along(track, (0.3, -0.2), pull, 0.0, 0.0, 0.1, way, (speed, now), (0.0, 0.0))
    assert 0.5 * now * now - 0.5 * speed * speed == pytest.approx(work, abs=1e-9)


def test_a_track_is_a_line_or_a_circle() -> None:
    assert along_track(0.6, 0.8, 0.0, 2.0) == pytest.approx((1.2, 1.6, 0.6, 0.8))
    assert along_track(1.0, 0.0, 1.0, pi / 2) == pytest.approx((1, 1, 0, 1), abs=1e-15)
    assert along_track(1.0, 0.0, -0.5, 2 * pi) == pytest.approx((0, -4, -1, 0), abs=1e-14)


def test_what_stands_turns_backwards_as_seen_from_what_turns() -> None:
    assert turned_back(0.0, -1.0, 0.0) == (0.0, -1.0)
    assert turned_back(0.0, -1.0, pi / 2) == pytest.approx((-1, 0), abs=1e-15)


@pytest.mark.parametrize("sweep", [0.1, 1.0, pi - 0.1, pi, pi + 0.1, 5.0, 6.2])
def test_a_place_is_past_an_end_of_an_arc_where_its_ray_leaves_it_out(sweep: float) -> None:
    arc = Arc((1, 2), 3, 0.4, 0.4 + sweep)
    # Near its ends: that is where it is asked.
    for angle in (0.4, 0.4 + sweep):
        for turn in (-0.03, -1e-6, 1e-6, 0.03):
            x, y = 1 + 2.5 * cos(angle + turn), 2 + 2.5 * sin(angle + turn)
            inside = turn > 0 if angle == 0.4 else turn < 0
            assert (past_end(arc._row, x, y) <= 0.0) == inside


def test_a_place_is_past_an_end_of_a_segment_by_its_distance_along_it() -> None:
    row = Segment((0, 0), (3, 4))._row
    assert past_end(row, 1.5, 2.0) == pytest.approx(-2.5)
    assert past_end(row, -0.6, -0.8) == pytest.approx(1.0)
    assert past_end(row, 3.6, 4.8) == pytest.approx(1.0)
    assert past_end(row, *(np.array([1.5, 2.0]) + np.array([-4.0, 3.0]))) == pytest.approx(-2.5)


def test_a_small_swing_has_the_period_of_a_pendulum() -> None:
    way, speed, time = 1e-4, 0.0, 0.0
    step = 2 * pi / sqrt(10) / 64
    for _ in range(64):
        # Hung at the origin, a bead of a bend 1 that is `way` from the lowest place of its circle.
        track = (cos(way), sin(way), 1.0)
        more, speed = slid_along(track, (0.0, 0.0), (0.0, -10.0), 0.0, 0.0, step, speed)
        way += more
        time += step
    assert time < inf
    assert way == pytest.approx(1e-4, rel=1e-5)
    assert hypot(speed, 0) < 1e-8
