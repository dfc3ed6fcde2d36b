"""The queue of coming events: whoever comes and goes, the earliest stands in front."""

from math import inf
from random import Random
from typing import Any

import numpy as np
import pytest

from carom.geometry.instants import is_before
from carom.rows.flight import FLIGHT, NO_BALL, NO_PLACE, QUEUE
from carom.rows.tables import Rows
from carom.world.kernels.continuous.queue import (
    QUEUE_LEAST,
    QUEUE_MOST,
    front_of,
    is_sooner,
    open_queue,
    put_event,
    row_of,
    take_event,
)
from tests.kernel_calls import ball_rows, state_row

BALLS = 40


def order_of(flights: Rows, ball: int) -> tuple[float, float, int, int]:
    """What a ball's place in the queue follows from."""
    row = flights[ball]
    return float(row["due_time"]), float(row["due_low"]), int(row["due_key"]), ball


@pytest.mark.parametrize("seed", range(3))
def test_the_earliest_event_is_in_front_and_of_equal_ones_that_of_the_least_key(seed: int) -> None:
    random = Random(seed)
    state, flights, queue = state_row(ball_rows([]), "grid", 1), np.zeros(BALLS, FLIGHT), np.zeros(BALLS, QUEUE)
    queue["place"] = NO_PLACE
    waiting: set[int] = set()
    for _ in range(600):
        ball = random.randrange(BALLS)
        if random.random() < 0.6:
            flights[ball]["due_time"] = random.choice((1.0, 2.0, random.random()))
            flights[ball]["due_low"] = random.choice((0.0, 1e-17, -1e-17))
            flights[ball]["due_key"] = random.randrange(3)
            put_event(state, flights, queue, ball)
            waiting.add(ball)
        else:
            take_event(state, flights, queue, ball)
            waiting.discard(ball)
        assert state["queued"] == len(waiting)
        assert not waiting or queue[0]["ball"] == min(waiting, key=lambda ball: order_of(flights, ball))
        for place in range(len(waiting)):
            assert queue[queue[place]["ball"]]["place"] == place
    order = []
    while state["queued"]:
        order.append(int(queue[0]["ball"]))
        take_event(state, flights, queue, order[-1])
    assert order == sorted(waiting, key=lambda ball: order_of(flights, ball))
    assert (queue["place"] == NO_PLACE).all()


@pytest.mark.parametrize("seed", range(5))
def test_the_order_in_which_balls_were_put_in_does_not_show(seed: int) -> None:
    random, flights = np.random.default_rng(seed), np.zeros(BALLS, FLIGHT)
    flights["due_time"], flights["due_key"] = random.integers(0, 4, BALLS), random.integers(0, 2, BALLS)
    orders: list[list[int]] = []
    for _ in range(3):
        state, queue, order = state_row(ball_rows([]), "grid", 1), np.zeros(BALLS, QUEUE), []
        queue["place"] = NO_PLACE
        for ball in random.permutation(BALLS).tolist():
            put_event(state, flights, queue, ball)
        while state["queued"]:
            order.append(int(queue[0]["ball"]))
            take_event(state, flights, queue, order[-1])
        orders.append(order)
    assert orders[0] == orders[1] == orders[2]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ({"due_time": 1.0, "due_low": 9.0, "due_key": 9}, {"due_time": 2.0}),
        ({"due_time": 1.0, "due_low": -1e-17, "due_key": 9}, {"due_time": 1.0}),
        ({"due_time": 1.0, "due_key": 3}, {"due_time": 1.0, "due_key": 4}),
    ],
)
def test_the_instant_comes_first_and_then_the_key(first: dict[str, Any], second: dict[str, Any]) -> None:
    for one, other in ((0, 1), (1, 0)):
        flights = np.zeros(2, FLIGHT)
        for row, values in ((one, first), (other, second)):
            for name, value in values.items():
                flights[row][name] = value
        assert is_sooner(flights, one, other)
        assert not is_sooner(flights, other, one)
        same = first.get("due_time") == second.get("due_time")
        lows = first.get("due_low", 0.0), second.get("due_low", 0.0)
        assert is_before(first["due_time"], lows[0], second["due_time"], lows[1]) == (not same or lows[0] < lows[1])


def test_of_two_at_one_instant_with_one_key_the_lower_row_comes_first() -> None:
    flights = np.zeros(2, FLIGHT)
    assert is_sooner(flights, 0, 1)
    assert not is_sooner(flights, 1, 0)


def test_a_row_is_handed_on_as_a_plain_number() -> None:
    assert row_of(np.int32(7)) == 7
    assert type(row_of(np.int32(7))) is int


@pytest.mark.parametrize("seed", range(3))
def test_of_a_crowd_the_queue_holds_what_comes_soon_and_all_come_in_order(seed: int) -> None:
    random = Random(seed)
    count = 400
    state, flights, queue = state_row(ball_rows([]), "grid", 1), np.zeros(count, FLIGHT), np.zeros(count + 1, QUEUE)
    state["balls"], state["binned"] = count, 1
    open_queue(state, queue)
    waiting: set[int] = set()

    def let_wait(ball: int) -> None:
        flights[ball]["due_time"] = state["now"] + random.choice((0.25, 1.0, random.expovariate(1.0)))
        flights[ball]["due_low"] = random.choice((0.0, 1e-17, -1e-17))
        put_event(state, flights, queue, ball)
        waiting.add(ball)

    for ball in range(count):
        let_wait(ball)
    assert state["queued"] == 0
    longest = 0
    for _ in range(3000):
        front = front_of(state, flights, queue)
        longest = max(longest, int(state["queued"]))
        if not waiting:
            assert front == NO_BALL
            break
        first = int(queue[0]["ball"])
        assert first == front == min(waiting, key=lambda ball: order_of(flights, ball))
        for place in range(int(state["queued"])):
            assert queue[queue[place]["ball"]]["place"] == place
        state["now"] = flights[first]["due_time"]
        take_event(state, flights, queue, first)
        waiting.discard(first)
        # Others are put elsewhere, sooner or later, or taken out.
        for _ in range(random.randrange(2)):
            let_wait(random.randrange(count))
        other = random.randrange(count)
        take_event(state, flights, queue, other)
        waiting.discard(other)
    assert not waiting
    assert (int(state["queued"]), float(queue[count]["time"])) == (0, inf)
    assert 4 < longest < count


@pytest.mark.parametrize("soon", [0.0, 1e-6])
def test_a_queue_that_was_filled_with_too_few_or_too_many_is_filled_otherwise_the_next_time(soon: float) -> None:
    count, fillings = 100, []
    state, flights, queue = state_row(ball_rows([]), "grid", 1), np.zeros(count, FLIGHT), np.zeros(count + 1, QUEUE)
    state["balls"], state["binned"] = count, 1
    open_queue(state, queue)
    for ball in range(count):
        flights[ball]["due_time"] = soon * ball if ball < 98 else 1.0
        put_event(state, flights, queue, ball)
    # Nearly all wait for what comes at once, or all but, then for what comes much later, then for what comes soon.
    for k in range(15 * count):
        if state["queued"] == 0:
            front_of(state, flights, queue)
            fillings.append((k, int(state["queued"])))
        first = int(queue[0]["ball"])
        state["now"] = flights[first]["due_time"]
        flights[first]["due_time"] += (100.0 if k < 3 * count else 1.0) * (1.0 + first / count)
        put_event(state, flights, queue, first)
    later = [found for k, found in fillings if count < k < 3 * count]
    assert 0 < len(later) < 2 / QUEUE_LEAST
    assert fillings[-1][1] < 2 * QUEUE_MOST * count


@pytest.mark.parametrize("overdue", [0, 1, 30, 40])
def test_what_was_to_come_before_now_comes_at_once_and_keeps_nothing_else_waiting(overdue: int) -> None:
    random = Random(overdue)
    state, flights, queue = state_row(ball_rows([]), "grid", 1), np.zeros(BALLS, FLIGHT), np.zeros(BALLS + 1, QUEUE)
    state["balls"], state["binned"], state["now"] = BALLS, 1, 3.0
    open_queue(state, queue)
    for ball in range(BALLS):
        flights[ball]["due_time"] = random.uniform(0.0, 3.0) if ball < overdue else random.uniform(3.0, 3.01)
        put_event(state, flights, queue, ball)
    order = []
    while (front := front_of(state, flights, queue)) != NO_BALL:
        order.append(front)
        state["now"] = max(float(state["now"]), float(flights[front]["due_time"]))
        take_event(state, flights, queue, front)
    assert order == sorted(range(BALLS), key=lambda ball: order_of(flights, ball))
