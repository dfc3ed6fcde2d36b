"""Spans of a substep: each ends when the next shape stops or arrives, and what may meet in it is found."""

from itertools import combinations
from math import inf
from random import Random

import numpy as np
import pytest

from carom import Ball, Segment, World
from carom.rows.flight import STALLED
from carom.rows.state import BRUTE
from carom.world.kernels.continuous.spans import (
    begin_flights,
    move_shapes_on,
    set_shapes_going,
    span_length,
    sweep_pairs,
    time_to_stop,
)
from tests.kernel_calls import in_flight, prepared
from tests.worlds import continuous_world


def hand(**options: object) -> Segment:
    """A hand that turns about its end."""
    return Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), **options)  # type: ignore[arg-type]


def test_the_time_to_a_stop_is_the_way_to_it_by_the_speed() -> None:
    turned = hand(angular_velocity=2.0, turn_limits=(-1, 0.5))
    assert time_to_stop(turned._row) == 0.25
    turned._row["orientation"] = 0.25
    assert time_to_stop(turned._row) == 0.125
    assert time_to_stop(hand(angular_velocity=-2.0, turn_limits=(-1, 0.5))._row) == 0.5
    assert time_to_stop(hand(angular_velocity=2.0)._row) < 0.0
    assert time_to_stop(hand(turn_limits=(-1, 0.5))._row) < 0.0


@pytest.mark.parametrize("seed", range(8))
def test_a_span_lasts_until_the_first_shape_stops_or_arrives_and_that_is_there_exactly(seed: int) -> None:
    random = Random(seed)
    world = continuous_world()
    times, hands = [1.0], []
    for _ in range(5):
        spin, stop, duration = random.choice((-2.0, 0.0, 3.0)), random.uniform(0.1, 4), random.uniform(0.1, 2)
        hands.append(world.add(hand(turn_limits=(-stop, stop))))
        if random.random() < 0.3:
            hands[-1].move_to((random.uniform(-1, 1), 0), dt=duration)
            times.append(duration)
        else:
            hands[-1].angular_velocity = spin
            times.append(stop / abs(spin) if spin else inf)
    room = prepared(world)
    state, shapes, order = room.states[0], room.shapes.rows, room.order
    state["span"] = span_length(state, shapes, order, 1.0)
    assert state["span"] == pytest.approx(min(times))
    set_shapes_going(state, room.balls.rows, shapes, order)
    move_shapes_on(state, shapes, order)
    first = times.index(min(times))
    if first and hands[first - 1].angular_velocity:
        assert abs(hands[first - 1].orientation) == hands[first - 1].turn_limits[1]
    assert state["moving_stale"] == 1


@pytest.mark.parametrize("seed", range(4))
def test_all_pairs_that_come_near_in_a_span_are_found_at_once(seed: int) -> None:
    random = np.random.default_rng(seed)
    world = World(detection="continuous", gravity=(0, -3))
    world.add_balls(random.uniform(-5, 5, (40, 2)), random.uniform(-2, 2, (40, 2)), radius=random.uniform(0.3, 0.6, 40))
    room = in_flight(world, 0.1)
    state, balls = room.states[0], room.balls.used
    assert begin_flights(state, balls, room.flights)
    pairs = np.zeros((1000, 2), "i4")
    assert sweep_pairs(state, balls, room.flights, room.slots, np.zeros(9999, "i4"), pairs)
    assert state["swept"] == 1
    found = {frozenset(pair) for pair in pairs[: int(state["pairs"])].tolist()}
    times = np.linspace(0, 0.1, 30)
    near = set()
    for i, j in combinations(range(40), 2):
        dx = balls["x"][i] - balls["x"][j] + (balls["vx"][i] - balls["vx"][j]) * times
        dy = balls["y"][i] - balls["y"][j] + (balls["vy"][i] - balls["vy"][j]) * times
        if np.hypot(dx, dy).min() <= balls["radius"][i] + balls["radius"][j]:
            near.add(frozenset((i, j)))
    assert near <= found
    assert len(found) < 40 * 39 / 4
    assert len(near) > 5


def test_balls_that_are_too_fast_are_not_swept_and_a_few_are_neither_swept_nor_binned() -> None:
    world = World(detection="continuous")
    world.add_balls(np.zeros((9, 2)), (100, 0), radius=0.1)
    room = in_flight(world, 1.0)
    room.flights["kind"][3] = STALLED
    assert begin_flights(room.states[0], room.balls.rows, room.flights)
    assert (room.flights["kind"] == STALLED).sum() == 1
    nothing = np.zeros(0, "i4"), np.zeros((0, 2), "i4")
    assert sweep_pairs(room.states[0], room.balls.rows, room.flights, room.slots, *nothing)
    assert room.states[0]["swept"] == 0
    few = in_flight(continuous_world(*(Ball((3.0 * k, 0), 1) for k in range(4))), 1.0)
    assert not begin_flights(few.states[0], few.balls.rows, few.flights)
    assert few.states[0]["bin_levels"] == 1
    assert few.states[0]["broad_phase"] != BRUTE
