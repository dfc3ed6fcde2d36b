"""Cells of balls in flight: each ball stands in one, and whoever touches it is filed near by."""

from itertools import chain, combinations
from math import hypot

import numpy as np
import pytest

from carom import World
from carom.rows.flight import NO_BALL
from carom.rows.tables import Rows
from carom.world.kernels.continuous.bins import bin_number, file_ball, leash, may_meet, open_bins, unfile_ball
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
            cell = bin_number(state, float(flights[ball]["bin_x"]), float(flights[ball]["bin_y"]), level)
            assert ball in cells[cell]
            assert (state["bin_levels"] >> level) & 1
            # Cells are at least twice as wide as the balls of their level, and a leash is a part of that.
            width = float(state["bin_side"]) / 2**level
            assert width > 4 * float(balls[ball]["radius"])
            assert leash(state, flights[ball]) == pytest.approx(width / 8)
        unfile_ball(flights, heads, step)
        assert step not in chain(*filed(arrays, heads))
        balls[step]["x"] += 3.0
        file_ball(state, balls, flights, heads, step, 0.0)


@pytest.mark.parametrize("sizes", [(0.5, 0.5), (0.01, 3.0)])
def test_balls_that_touch_are_filed_within_reach_of_each_other(sizes: tuple[float, float]) -> None:
    arrays = in_flight(crowd(2, sizes), 1.0)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    assert open_bins(state, balls, flights, heads)
    random, seen = np.random.default_rng(3), 0
    for i in range(60):
        angle, way = random.uniform(0, 6.3), random.uniform(0, 1) * leash(state, flights[i])
        balls[i]["x"] += way * np.cos(angle)
        balls[i]["y"] += way * np.sin(angle)
    for i, j in combinations(range(60), 2):
        reach = float(balls[i]["radius"] + balls[j]["radius"])
        if hypot(balls[i]["x"] - balls[j]["x"], balls[i]["y"] - balls[j]["y"]) <= reach:
            apart = [abs(flights[i][name] - flights[j][name]) for name in ("bin_x", "bin_y")]
            assert max(apart) <= reach + leash(state, flights[i]) + leash(state, flights[j])
            seen += 1
    assert seen > 10


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
    assert flights["bin_x"][7] == x + 1.5
    unfile_ball(flights, heads, 7)
    file_ball(state, balls, flights, heads, 7, 2.0)
    assert flights["bin_x"][7] == x + 6.0
    assert balls["x"][7] == x
