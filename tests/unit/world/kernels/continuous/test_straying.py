"""When balls leave a world's bounds and come back, against looking at them again and again."""

import numpy as np
import pytest
from numpy.typing import NDArray

from carom import Ball
from carom.geometry.path import Path
from carom.rows.flight import ASLEEP, HIT_SHAPE, NOTHING, STRAY
from carom.world.kernels.continuous.flight import consider, event_age
from carom.world.kernels.continuous.straying import count_out, is_out, predict_stray, stays_within
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world

BOUNDS = (-3.0, -2.0, 3.0, 4.0)
RANDOM = np.random.default_rng(5)
SECONDS, LOOKS = 8.0, 80_001


def flying(*balls: Ball, pull: tuple[float, float] = (0.0, 0.0)) -> Arrays:
    """The tables of a world with bounds whose balls are in flight."""
    world = continuous_world(*balls, gravity=pull)
    world.bounds = BOUNDS
    return in_flight(world)


def out_at(times: NDArray[np.float64], ball: Ball, pull: tuple[float, float]) -> NDArray[np.bool_]:
    """Whether a ball is wholly outside at some times."""
    place = np.asarray(ball.position) + np.multiply.outer(times, ball.velocity)
    x, y = (place + np.multiply.outer(times**2 / 2, pull)).T
    left, bottom, right, top = BOUNDS
    return (x + ball.radius < left) | (x - ball.radius > right) | (y + ball.radius < bottom) | (y - ball.radius > top)


@pytest.mark.parametrize("case", range(60))
def test_the_next_change_is_foreseen_from_any_age_of_a_flight(case: int) -> None:
    pull = tuple(RANDOM.normal(0, 2, 2)) if case % 2 else (0.0, 0.0)
    ball = Ball(RANDOM.uniform(-4, 5, 2), RANDOM.uniform(0.1, 1.5), RANDOM.normal(0, 3, 2))
    room = flying(ball, pull=pull)
    times = np.linspace(0, SECONDS, LOOKS)
    outside = out_at(times, ball, pull)
    for k in (0, LOOKS // 9, LOOKS // 3):
        flight, row = room.flights[0], room.balls.rows[0]
        flight["event"], row["stray"] = NOTHING, outside[k]
        predict_stray(room.states[0], row, flight, float(times[k]))
        changes = np.flatnonzero(outside[k:] != outside[k])
        if len(changes):
            assert flight["event"] == STRAY
            assert event_age(flight) == pytest.approx(times[k + changes[0]], abs=2 * SECONDS / LOOKS)
        else:
            assert flight["event"] == NOTHING or event_age(flight) > SECONDS


@pytest.mark.parametrize("asleep", [False, True])
def test_what_begins_a_flight_on_the_other_side_changes_at_once(asleep: bool) -> None:
    room = flying(Ball((0, 0), 1), Ball((9, 0), 1))
    for k, stray in ((0, 1), (1, 0)):
        flight, row = room.flights[k], room.balls.rows[k]
        flight["event"], row["stray"] = NOTHING, stray
        if asleep:
            flight["kind"] = ASLEEP
        predict_stray(room.states[0], row, flight, 0.0)
        assert (flight["event"], event_age(flight)) == (STRAY, 0.0)
        flight["event"], row["stray"] = NOTHING, 1 - stray
        predict_stray(room.states[0], row, flight, 0.0)
        assert flight["event"] == NOTHING


def test_what_comes_before_it_stands() -> None:
    room = flying(Ball((0, 0), 1, (2, 0)))
    flight = room.flights[0]
    for hit, event in ((1.9, HIT_SHAPE), (2.1, STRAY)):
        flight["event"] = NOTHING
        consider(flight, hit, HIT_SHAPE, 0)
        predict_stray(room.states[0], room.balls.rows[0], flight, 0.0)
        assert flight["event"] == event


@pytest.mark.parametrize("case", range(40))
def test_what_stays_within_between_two_ages_is_never_outside_there(case: int) -> None:
    pull = tuple(RANDOM.normal(0, 2, 2))
    ball = Ball(RANDOM.uniform(-3, 4, 2), RANDOM.uniform(0.1, 1.0), RANDOM.normal(0, 2, 2))
    begin, end = sorted(RANDOM.uniform(0, 2, 2))
    path = (*ball.position, *ball.velocity, *pull)
    outside = out_at(np.linspace(begin, end, 2001), ball, pull).any()
    stays = stays_within(flying(ball).states[0], Path(*path), ball.radius, begin, end)
    assert not (stays and outside)
    # And one that stays far within is seen to: in a tenth of a second none of these goes farther than this.
    way = 0.1 * (np.hypot(*ball.velocity) + np.hypot(*pull))
    middle = Ball((0, 1), max(ball.radius, way), ball.velocity)
    assert stays_within(flying(middle).states[0], Path(0.0, 1.0, *ball.velocity, *pull), middle.radius, 0.0, 0.1)


def test_a_ball_is_out_that_has_left_bounds_beyond_which_none_is_kept() -> None:
    room = flying(Ball((0, 0), 1), Ball((1, 3), 0.5))
    state, row = room.states[0], room.balls.rows[0]
    for bounded in (0, 1):
        for removes in (0, 1):
            for stray in (0, 1):
                state["bounded"], state["remove_strays"], row["stray"] = bounded, removes, stray
                wanted = bounded + removes + stray == 3
                assert is_out(state, row) == wanted
                assert count_out(state, room.balls.rows) == int(wanted)
