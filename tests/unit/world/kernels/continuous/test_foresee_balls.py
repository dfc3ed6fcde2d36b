"""The next impact of a ball with another: the earliest of all, whether cells, pairs or everyone is looked through."""

from math import inf, sqrt

import numpy as np
import pytest

from carom import World
from carom.rows.flight import HIT_BALL, STALLED
from carom.world.kernels.continuous.bins import leash, open_bins
from carom.world.kernels.continuous.flight import top_speed
from carom.world.kernels.continuous.foresee_balls import foresee_balls, foresee_pairs
from carom.world.kernels.continuous.spans import sweep_pairs
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight

COUNT, SPAN = 30, 0.4


def crowd(seed: int) -> Arrays:
    """Balls in flight that do not overlap, some of which stand still."""
    random = np.random.default_rng(seed)
    world = World(detection="continuous", gravity=(1, -5))
    cells = np.stack(np.meshgrid(np.arange(6.0), np.arange(5.0)), -1).reshape(-1, 2)
    world.add_balls(0.8 * cells + random.uniform(-0.03, 0.03, (COUNT, 2)), random.normal(0, 2, (COUNT, 2)), radius=0.35)
    arrays = in_flight(world, SPAN)
    for still in random.choice(COUNT, 4, replace=False):
        arrays.flights[still]["kind"] = STALLED
        arrays.flights[still]["ax"] = arrays.flights[still]["ay"] = 0.0
    arrays.flights["event_time"] = SPAN
    return arrays


def touch_time(arrays: Arrays, i: int, j: int) -> float:
    """When two balls touch first: by the formula where both fall alike, else by looking at many moments."""
    rows, flights, times = arrays.balls.rows, arrays.flights, np.linspace(0, SPAN, 4001)
    flying = [float(flights[k]["kind"] != STALLED) for k in (i, j)]
    dx, dy = (float(rows[j][name] - rows[i][name]) for name in ("x", "y"))
    ux, uy = (float(rows[j][name] * flying[1] - rows[i][name] * flying[0]) for name in ("vx", "vy"))
    reach = float(rows[i]["radius"] + rows[j]["radius"])
    if flying[0] == flying[1]:
        a, b, c = ux * ux + uy * uy, dx * ux + dy * uy, dx * dx + dy * dy - reach * reach
        root = b * b - a * c
        return (-b - sqrt(root)) / a if a > 0.0 and b < 0.0 and root >= 0.0 else inf
    ax, ay = (float(flights[j][name] - flights[i][name]) for name in ("ax", "ay"))
    away = np.hypot(dx + ux * times + ax * times**2 / 2, dy + uy * times + ay * times**2 / 2)
    return float(times[np.argmax(away <= reach)]) if (away <= reach).any() else inf


def earliest(arrays: Arrays, i: int) -> tuple[float, int]:
    """When a ball touches another first, and which."""
    return min((touch_time(arrays, i, j), j) for j in range(COUNT) if j != i)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("binned", [False, True])
def test_the_impact_that_is_foreseen_is_the_earliest_of_all(seed: int, binned: bool) -> None:
    arrays, seen = crowd(seed), 0
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    if binned:
        assert open_bins(state, balls, flights, heads)
    for i in range(COUNT):
        if flights[i]["kind"] == STALLED:
            continue
        until = SPAN
        if binned:  # no farther than a ball may go before it is filed anew
            until = min(SPAN, leash(state, flights[i]) / top_speed(balls[i], flights[i], SPAN))
            flights[i]["event_time"] = until
        foresee_balls(state, balls, heads, flights, arrays.relations, i, True)
        time, partner = earliest(arrays, i)
        if time < until - 1e-3:
            seen += 1
            assert (flights[i]["event"], flights[i]["partner"]) == (HIT_BALL, partner)
            assert flights[i]["event_time"] == pytest.approx(time, abs=2e-4)
        else:
            assert flights[i]["event"] != HIT_BALL or time < until + 1e-3
    assert seen > (3 if binned else 10)


@pytest.mark.parametrize("seed", range(3))
def test_each_pair_is_foreseen_by_one_of_its_balls(seed: int) -> None:
    arrays = crowd(seed)
    state, balls, flights = arrays.states[0], arrays.balls.rows, arrays.flights
    state["span"] = 0.05
    arrays.pairs = np.zeros((999, 2), "i4")
    assert sweep_pairs(state, balls, flights, arrays.slots, np.zeros(999, "i4"), arrays.pairs)
    assert state["swept"] == 1
    foresee_pairs(state, balls, arrays.pairs, flights, arrays.relations)
    times = [earliest(arrays, i)[0] for i in range(COUNT) if flights[i]["kind"] != STALLED]
    found = flights["event_time"][:COUNT]
    assert found.min() == pytest.approx(min(*times, SPAN), abs=2e-4)
    soon = sorted(time for time in set(times) if time < 0.05)
    assert len(soon) <= (found < SPAN).sum()


def test_who_cannot_collide_is_not_foreseen() -> None:
    arrays = crowd(0)
    first = earliest(arrays, 0)[1]
    arrays.balls.rows["layer"][first] = 2
    arrays.balls.rows["collides_with"][:COUNT] = 1
    foresee_balls(arrays.states[0], arrays.balls.rows, np.zeros(0, "i4"), arrays.flights, arrays.relations, 0, True)
    assert arrays.flights[0]["event"] != HIT_BALL or arrays.flights[0]["partner"] != first
