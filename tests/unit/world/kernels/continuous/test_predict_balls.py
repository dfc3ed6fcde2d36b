"""The next impact of a ball with another: the earliest of all, the same whoever looks, when, and by which cells."""

from math import inf

import numpy as np
import pytest

from carom import World
from carom.geometry.path import Path
from carom.rows.flight import ASLEEP, HIT_BALL, NOTHING
from carom.rows.tables import Rows
from carom.world.kernels.continuous.bins import file_ball, open_bins, own_level, time_filed, unfile_ball
from carom.world.kernels.continuous.flight import consider, event_age, place_after
from carom.world.kernels.continuous.predict_balls import (
    may_near,
    only_slide,
    pair_begin,
    predict_balls,
    predict_balls_beyond,
    predict_pair,
)
from carom.world.tables import Arrays
from tests.kernel_calls import foreseen, in_flight, look_at

COUNT, SPAN = 30, 0.4


def crowd(seed: int, sleepers: int = 4, gravity: tuple[float, float] = (1, -5)) -> Arrays:
    """Balls in flight that do not overlap, some of which sleep."""
    random = np.random.default_rng(seed)
    world = World(detection="continuous", gravity=gravity)
    cells = np.stack(np.meshgrid(np.arange(6.0), np.arange(5.0)), -1).reshape(-1, 2)
    world.add_balls(0.8 * cells + random.uniform(-0.03, 0.03, (COUNT, 2)), random.normal(0, 2, (COUNT, 2)), radius=0.35)
    arrays = in_flight(world, SPAN)
    for still in random.choice(COUNT, sleepers, replace=False):
        arrays.flights[still]["kind"] = ASLEEP
        arrays.flights[still]["ax"] = arrays.flights[still]["ay"] = 0.0
    return arrays


def foresee(arrays: Arrays, i: int, heads: Rows | None = None) -> tuple[int, float, float, int]:
    """The next impact of a ball with another, asking all of them."""
    arrays.flights[i]["event"] = NOTHING
    found = np.zeros(0, "i4") if heads is None else heads
    predict_balls(arrays.states[0], arrays.balls.rows, found, arrays.flights, arrays.relations, i, True)
    return foreseen(arrays, i)


def touch_time(arrays: Arrays, i: int, j: int, times: np.ndarray) -> float:
    """When two balls touch first, by looking at many moments."""
    places = [
        np.array([place_after(arrays.balls.rows[k], arrays.flights[k], float(time))[:2] for time in times])
        for k in (i, j)
    ]
    near = np.hypot(*(places[0] - places[1]).T) <= float(
        arrays.balls.rows[i]["radius"] + arrays.balls.rows[j]["radius"]
    )
    return float(times[np.argmax(near)]) if near.any() else inf


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_the_impact_that_is_foreseen_is_the_earliest_of_all(seed: int) -> None:
    arrays, times, seen = crowd(seed), np.linspace(0, SPAN, 401), 0
    for i in range(0, COUNT, 3):
        event, time, _low, partner = foresee(arrays, i)
        expected = min((touch_time(arrays, i, j, times), j) for j in range(COUNT) if j != i)
        if expected[0] < inf:
            seen += 1
            assert event == HIT_BALL
            assert expected[0] - 1e-3 <= time <= expected[0] + 1e-12
            touched = touch_time(arrays, i, partner, times)
            assert touched <= expected[0] + 1e-3
        else:
            assert event == NOTHING or time > SPAN - 1e-3
    assert seen >= 5


@pytest.mark.parametrize("gravity", [(0, 0), (1, -5)])
@pytest.mark.parametrize("seed", range(3))
def test_both_balls_of_a_pair_foresee_the_same_to_the_bit_from_whenever(
    seed: int, gravity: tuple[float, float]
) -> None:
    arrays, seen = crowd(seed, gravity=gravity), 0
    rows = arrays.balls.rows, arrays.flights, arrays.relations
    for i in range(COUNT):
        event, time, low, partner = foresee(arrays, i)
        if event != HIT_BALL:
            continue
        seen += 1
        for share in (0.3, 0.99):
            look_at(arrays, share * time)
            assert foresee(arrays, i) == (event, time, low, partner)
        arrays.flights[partner]["event"] = NOTHING
        predict_pair(arrays.states[0], *rows, partner, i)
        assert foreseen(arrays, partner) == (HIT_BALL, time, low, i)
        assert arrays.flights[partner]["event_key"] == arrays.flights[i]["event_key"]
        look_at(arrays, 0.0)
    assert seen > 10


@pytest.mark.parametrize("seed", range(3))
def test_cells_find_what_asking_everyone_finds_to_the_bit(seed: int) -> None:
    arrays, seen = crowd(seed), 0
    state, flights = arrays.states[0], arrays.flights
    alone = [foresee(arrays, i) for i in range(COUNT)]
    heads = np.zeros(4096, "i4")
    assert open_bins(state, arrays.balls.rows, flights, heads)
    for i in range(COUNT):
        # No farther than both balls may go before they are filed anew.
        both = [i] if alone[i][3] < 0 else [i, alone[i][3]]
        until = min(
            inf if flights[k]["kind"] == ASLEEP else time_filed(state, arrays.balls.rows[k], flights[k], 0.0)
            for k in both
        )
        found = foresee(arrays, i, heads)
        if alone[i][1] < until:
            seen += 1
            assert found == alone[i]
        else:
            assert found[1] >= alone[i][1]
    assert seen > 5


@pytest.mark.parametrize("seed", range(3))
def test_who_is_filed_anew_asks_those_who_were_not_near_before(seed: int) -> None:
    arrays = crowd(seed, sleepers=0)
    state, flights, balls, heads = arrays.states[0], arrays.flights, arrays.balls.rows, np.zeros(4096, "i4")
    assert open_bins(state, balls, flights, heads)
    for i in range(COUNT):
        column, line = int(flights[i]["column"]), int(flights[i]["line"])
        before = foresee(arrays, i, heads)
        unfile_ball(state, flights, heads, i)
        file_ball(state, balls, flights, heads, i, SPAN, own_level(state, balls[i]))
        everyone = foresee(arrays, i, heads)
        flights[i]["event"] = NOTHING
        tables = heads, flights, arrays.relations
        predict_balls_beyond(state, balls, *tables, i, column, line, True)
        beyond = foreseen(arrays, i)
        # Of those near it now, some were before: the first of both is the first of all.
        assert min((before, everyone), key=lambda event: event[1]) == min((before, beyond), key=lambda event: event[1])
        asked = int(state["box_tests"])
        predict_balls_beyond(state, balls, *tables, i, int(flights[i]["column"]), int(flights[i]["line"]), True)
        assert state["box_tests"] == asked


def test_a_pair_is_looked_at_from_when_the_later_of_its_flights_began() -> None:
    arrays = crowd(0, sleepers=0)
    flights = arrays.flights
    assert pair_begin(flights[0], flights[1]) == (0.0, 0.0)
    flights[1]["time"], flights[1]["low"] = 3.0, 1e-17
    assert pair_begin(flights[0], flights[1]) == (3.0, 1e-17)
    assert pair_begin(flights[1], flights[0]) == (3.0, 1e-17)


@pytest.mark.parametrize("seed", range(3))
def test_who_is_left_out_at_first_sight_does_not_meet(seed: int) -> None:
    arrays, left_out = crowd(seed), 0
    rows, flights = arrays.balls.rows, arrays.flights
    for i in range(COUNT):
        foresee(arrays, i)
        until = event_age(flights[i])
        for j in range(COUNT):
            if j != i and not may_near(rows[i], flights[i], rows[j], flights[j]):
                left_out += 1
                before = foreseen(arrays, i)
                predict_pair(arrays.states[0], rows, flights, arrays.relations, i, j)
                assert foreseen(arrays, i) == before
        assert event_age(flights[i]) == until
    assert left_out > 100


@pytest.mark.parametrize("pull", [(0.0, 0.0), (3.0, -1.0)])
@pytest.mark.parametrize("seed", range(3))
def test_who_touches_now_is_not_left_out_for_what_else_comes_now(seed: int, pull: tuple[float, float]) -> None:
    random = np.random.default_rng(seed)
    for _ in range(100):
        places, radii = random.uniform(-8, 8, (2, 2)), random.uniform(0.1, 0.5, 2)
        away = places[1] - places[0]
        places[1] = places[0] + away * (radii.sum() / np.hypot(*away))
        world = World(detection="continuous")
        world.add_balls(places, [away, -away], radius=radii)
        arrays = in_flight(world)
        rows, flights = arrays.balls.rows, arrays.flights
        flights[0]["ax"], flights[0]["ay"] = pull
        # Another impact is known, at this very time.
        assert consider(flights[0], 0.0, HIT_BALL, 7)
        assert may_near(rows[0], flights[0], rows[1], flights[1])


def test_who_cannot_collide_is_not_foreseen() -> None:
    arrays = crowd(0)
    who = next(i for i in range(COUNT) if foresee(arrays, i)[0] == HIT_BALL)
    first = foresee(arrays, who)[3]
    arrays.balls.rows["layer"][first] = 2
    arrays.balls.rows["collides_with"][:COUNT] = 1
    assert foresee(arrays, who)[3] != first


def test_what_an_impact_has_left_of_an_approach_is_no_impact() -> None:
    world = World(detection="continuous")
    # They have just met without elasticity, and go on side by side; between their velocities there is hardly any.
    place = (0.41773540117507973, 7.237045668118878), (0.49796891336290977, 6.885959496577001)
    velocity = (-0.35665017546876704, 0.3066137660812847), (-0.36128141318279583, 0.30555539210448757)
    world.add_balls(place, velocity=velocity, radius=[0.18506161913602182, 0.1750757384456752])
    arrays = in_flight(world)
    assert foresee(arrays, 0)[0] == NOTHING
    assert foresee(arrays, 1)[0] == NOTHING


def test_balls_that_are_pulled_together_or_near_faster_than_rounding_do_not_only_slide() -> None:
    still = Path(0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
    assert only_slide(still, Path(0.0, 2.0, 3.0, -1e-16, 0.0, 0.0))
    assert not only_slide(still, Path(0.0, 2.0, 3.0, -1e-14, 0.0, 0.0))
    assert not only_slide(still, Path(0.0, 2.0, 3.0, -1e-16, 0.0, -1.0))
    assert not only_slide(still, Path(0.0, 0.0, 3.0, -1e-16, 0.0, 0.0))
