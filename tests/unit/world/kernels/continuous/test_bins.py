"""Cells of balls in flight: each ball stands in one, and whoever touches it is filed near by."""

from itertools import chain, combinations
from math import hypot, inf, nan, sqrt

import numpy as np
import pytest

from carom import World
from carom.constants import CELL_CLAMP, FINEST_LEVEL
from carom.rows.flight import NO_BALL
from carom.rows.tables import Rows
from carom.world.kernels.continuous.bins import (
    FILINGS_IN_A_ROW,
    TESTS_MOST,
    WIDEST,
    WIDEST_LEVEL,
    bin_number,
    cell_at,
    file_ball,
    fit_bins,
    level_after,
    may_meet,
    open_bins,
    own_level,
    side_of,
    stretch_of,
    time_filed,
    time_within,
    unfile_ball,
)
from carom.world.kernels.continuous.flight import place_after
from carom.world.kernels.continuous.predict_balls import cells_near
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, look_at


def crowd(seed: int, sizes: tuple[float, float]) -> World:
    """Balls of sizes between two, all over the place."""
    random = np.random.default_rng(seed)
    world = World(detection="continuous")
    world.add_balls(random.uniform(-10, 10, (60, 2)), radius=np.exp(random.uniform(*np.log(sizes), 60)))
    return world


def filed(arrays: Arrays, heads: Rows) -> list[list[int]]:
    """The balls in each cell."""
    found = []
    for head in heads.tolist():
        found.append([])
        while head != NO_BALL:
            found[-1].append(head)
            head = int(arrays.flights[head]["next"])
    return found


@pytest.mark.parametrize("sizes", [(0.5, 0.5), (0.01, 3.0)])
def test_every_ball_is_filed_once_under_the_cell_of_its_level_that_holds_it(sizes: tuple[float, float]) -> None:
    arrays = in_flight(crowd(1, sizes), 1.0)
    state, balls, flights = arrays.states[0], arrays.balls.rows, arrays.flights
    assert not open_bins(state, balls, flights, np.zeros(3, "i4"))
    heads = np.zeros(int(state["wanted_starts"]), "i4")
    assert open_bins(state, balls, flights, heads)
    for step in range(40):
        cells = filed(arrays, heads)
        assert sorted(chain(*cells)) == list(range(60))
        for ball in range(60):
            level = int(flights[ball]["level"])
            column, line = cell_at(state, float(balls[ball]["x"]), float(balls[ball]["y"]), level)
            assert (flights[ball]["column"], flights[ball]["line"]) == (column, line)
            assert ball in cells[bin_number(state, column, line, level)]
            assert (state["bin_levels"] >> level) & 1
            # Cells are at least twice as wide as the balls of their level.
            assert float(state["bin_side"]) / 2**level > 4 * float(balls[ball]["radius"])
        unfile_ball(state, flights, heads, step)
        assert step not in chain(*filed(arrays, heads))
        balls[step]["x"] += 3.0
        file_ball(state, balls, flights, heads, step, 0.0, own_level(state, balls[step]))


def allowed(arrays: Arrays, i: int) -> list[tuple[float, float]]:
    """Where a ball may be across and along as long as it stays filed as it is, from the corner of all cells."""
    flight = arrays.flights[i]
    side = side_of(arrays.states[0], int(flight["level"]))
    return [stretch_of(int(flight[name]), side) for name in ("column", "line")]


@pytest.mark.parametrize("least", [0.0, 0.7, 300.0])
@pytest.mark.parametrize("far", [0.0, 0.3])
@pytest.mark.parametrize("sizes", [(0.5, 0.5), (0.01, 3.0)])
def test_balls_that_touch_are_filed_in_neighbouring_cells_or_where_the_other_looks(
    sizes: tuple[float, float], far: float, least: float
) -> None:
    arrays = in_flight(crowd(2, sizes), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    state["bin_least"] = least
    assert open_bins(state, balls, flights, heads)
    random, seen = np.random.default_rng(3), 0
    for _ in range(5):
        for i in range(60):
            level = random.integers(FINEST_LEVEL, WIDEST_LEVEL) + 1 if random.random() < far else None
            unfile_ball(state, flights, heads, i)
            file_ball(state, balls, flights, heads, i, 0.0, level or own_level(state, balls[i]))
        for i in range(60):
            (left, right), (bottom, top) = np.clip(allowed(arrays, i), -30.0, 30.0).tolist()
            balls[i]["x"] = state["bin_left"] + random.choice((left, right, random.uniform(left, right)))
            balls[i]["y"] = state["bin_bottom"] + random.choice((bottom, top, random.uniform(bottom, top)))
        for i, j in combinations(range(60), 2):
            reach = float(balls[i]["radius"] + balls[j]["radius"])
            if hypot(balls[i]["x"] - balls[j]["x"], balls[i]["y"] - balls[j]["y"]) > reach:
                continue
            seen += 1
            one, other = flights[i], flights[j]
            if one["level"] == other["level"]:
                assert max(abs(int(one[name]) - int(other[name])) for name in ("column", "line")) <= 1
                continue
            for ball, flight, partner in ((balls[i], one, other), (balls[j], other, one)):
                left, right, bottom, top = cells_near(state, ball, flight, int(partner["level"]))
                # Too many cells are asked by their numbers, all of them.
                if (left, right, bottom, top) != (0, state["bin_mask"], 0, 0):
                    assert left <= partner["column"] <= right
                    assert bottom <= partner["line"] <= top
    assert seen > 30


@pytest.mark.parametrize("pull", [0.0, 3.0])
@pytest.mark.parametrize("seed", range(4))
def test_a_ball_is_where_it_is_filed_until_it_is_filed_anew(seed: int, pull: float) -> None:
    arrays = in_flight(crowd(seed, (0.1, 0.5)), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    random = np.random.default_rng(seed)
    for i in range(60):
        balls[i]["vx"], balls[i]["vy"] = random.normal(0, 4, 2)
        flights[i]["ax"], flights[i]["ay"] = random.normal(0, pull, 2) if pull else (0, 0)
    assert open_bins(state, balls, flights, heads)
    for i in range(60):
        wait = time_filed(state, balls[i], flights[i], 0.0)
        assert wait > 0.0
        for share in np.linspace(0.0, 1.0 - 1e-12, 40):
            x, y, _vx, _vy = place_after(balls[i], flights[i], share * wait)
            for place, (low, high) in zip(
                (x - state["bin_left"], y - state["bin_bottom"]), allowed(arrays, i), strict=True
            ):
                assert low - 1e-9 <= place <= high + 1e-9
        if pull == 0.0:
            # A straight one is there to the last.
            assert time_filed(state, balls[i], flights[i], wait * (1 + 1e-9)) == -1.0


def test_the_last_cells_have_no_end_and_what_stands_stays() -> None:
    last = int(CELL_CLAMP)
    assert stretch_of(last, 2.0)[1] == inf
    assert stretch_of(-last, 2.0)[0] == -inf
    assert stretch_of(3, 2.0) == (5.5, 8.5)
    assert time_within(7.0, 0.0, 0.0, (5.5, 8.5)) == inf
    assert time_within(7.0, 1.0, 0.0, (5.5, 8.5)) == 1.5
    assert time_within(7.0, -1.0, 0.0, (5.5, inf)) == 1.5
    assert time_within(7.0, 1.0, 0.0, (5.5, inf)) == inf
    assert time_within(9.0, -1.0, 0.0, (5.5, 8.5)) == -1.0
    assert time_within(7.0, 0.0, 2.0, (5.5, 8.5)) == pytest.approx(sqrt(1.5))
    assert time_within(nan, 1.0, 0.0, (5.5, 8.5)) != 0.0


def test_masks_may_exclude_every_meeting_of_balls() -> None:
    arrays = in_flight(crowd(1, (0.5, 0.5)), 1.0)
    balls = arrays.balls.used
    assert may_meet(arrays.states[0], balls)
    balls["layer"], balls["collides_with"] = 2, 1
    assert not may_meet(arrays.states[0], balls)
    balls["layer"][7] = 1
    assert may_meet(arrays.states[0], balls)


def test_a_ball_is_filed_where_it_is_at_an_age_of_its_flight() -> None:
    arrays = in_flight(crowd(1, (0.5, 0.5)), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    balls["vx"][7], x = 3.0, float(balls["x"][7])
    look_at(arrays, 0.5)
    assert open_bins(state, balls, flights, heads)
    assert flights["column"][7] == cell_at(state, x + 1.5, 0.0, int(flights["level"][7]))[0]
    unfile_ball(state, flights, heads, 7)
    file_ball(state, balls, flights, heads, 7, 2.0, own_level(state, balls[7]))
    assert flights["column"][7] == cell_at(state, x + 6.0, 0.0, int(flights["level"][7]))[0]
    assert balls["x"][7] == x


def test_cells_of_the_levels_halve_and_those_for_balls_that_fly_far_are_a_thousand_times_as_wide() -> None:
    arrays = in_flight(crowd(1, (0.5, 0.5)), 1.0)
    state = arrays.states[0]
    state["bin_side"] = 6.0
    assert [side_of(state, level) for level in range(4)] == [6.0, 3.0, 1.5, 0.75]
    assert side_of(state, FINEST_LEVEL) == 6.0 * 2.0**-FINEST_LEVEL
    wide = [side_of(state, level) for level in range(FINEST_LEVEL + 1, WIDEST_LEVEL + 1)]
    assert wide == [6.0 * 2.0**10, 6.0 * 2.0**20, 6.0 * 2.0**30, WIDEST]


def test_a_ball_is_filed_under_a_wider_level_after_so_many_cells_in_a_row_and_under_the_widest_for_good() -> None:
    arrays = in_flight(crowd(1, (0.01, 3.0)), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    assert open_bins(state, balls, flights, heads)
    flight, in_a_row = flights[5], FILINGS_IN_A_ROW + 60 // 8
    own, levels = int(flight["level"]), []
    for _ in range(5):
        for filing in range(in_a_row + 1):
            levels.append(level_after(state, flight))
            if levels[-1] != flight["level"]:
                assert filing == in_a_row
                flight["level"] = levels[-1]
    assert sorted(levels) == levels
    assert sorted(set(levels)) == [own, *range(FINEST_LEVEL + 1, WIDEST_LEVEL + 1)]


@pytest.mark.parametrize(
    ("filings", "predictions", "tests", "factor"),
    [
        (10, 10, 10, None),  # too few to tell
        (600, 200, 600, 2.0),
        (600, 200, 6000, None),  # as wide as pays
        (600, 300, 600, None),  # hardly any filings to save
        (60_000, 20, 0, 8.0),
        (600, 10, TESTS_MOST * 601, 0.5),
        (10, 600, TESTS_MOST * 601, 0.5),
        (10, 600, TESTS_MOST * 599, None),
    ],
)
def test_cells_are_fitted_to_what_was_done(filings: int, predictions: int, tests: int, factor: float | None) -> None:
    arrays = in_flight(crowd(1, (0.4, 0.5)), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    state["events"] = 1
    for least in (0.0, 5.0, 40.0):
        state["bin_least"] = least
        assert open_bins(state, balls, flights, heads)
        width = side_of(state, int(flights["level"][:60].max()))
        assert width >= least
        state["bin_filings"], state["bin_predictions"], state["bin_tests"] = filings, predictions, tests
        if factor is None or (factor < 1.0 and least == 0.0):
            assert not fit_bins(state)
            assert state["bin_least"] == least
            continue
        state["events"] = 2
        assert not fit_bins(state)
        state["events"] = 1
        assert fit_bins(state)
        assert state["bin_least"] == (factor * max(least, width) if factor > 1.0 else factor * least)
        # What was done is told from here on anew.
        assert not fit_bins(state)
        assert open_bins(state, balls, flights, heads)
        assert side_of(state, int(flights["level"][:60].max())) >= state["bin_least"]
