"""The queue of coming events: whoever comes and goes, the earliest stands in front."""

from random import Random

import numpy as np
import pytest

from carom.rows.flight import FLIGHT, NO_PLACE
from carom.world.kernels.continuous.queue import put_event, take_event
from tests.kernel_calls import ball_rows, state_row


@pytest.mark.parametrize("seed", range(3))
def test_the_earliest_event_is_in_front_and_of_equal_ones_that_of_the_first_ball(seed: int) -> None:
    random = Random(seed)
    state, flights, queue = state_row(ball_rows([]), "grid", 1), np.zeros(40, FLIGHT), np.zeros(40, "i4")
    flights["place"] = NO_PLACE
    times: dict[int, float] = {}
    for _ in range(600):
        ball = random.randrange(40)
        if random.random() < 0.6:
            times[ball] = flights[ball]["event_time"] = random.choice((1.0, 2.0, random.random()))
            put_event(state, flights, queue, ball)
        else:
            times.pop(ball, None)
            take_event(state, flights, queue, ball)
        assert state["queued"] == len(times)
        assert not times or queue[0] == min(times, key=lambda ball: (times[ball], ball))
    order = []
    while state["queued"]:
        order.append(int(queue[0]))
        take_event(state, flights, queue, order[-1])
    assert order == sorted(times, key=lambda ball: (times[ball], ball))
    assert (flights["place"] == NO_PLACE).all()
