"""A ball's flight: along the parabola of its acceleration, in a box around that, at no more than its top speed."""

from math import hypot, inf

import numpy as np
import pytest

from carom import Ball
from carom.geometry.path import Path
from carom.rows.flight import ASLEEP, FLYING, HIT_BALL, HIT_SHAPE, STALLED
from carom.world.kernels.continuous.flight import begin_flight, consider, fly_to, path_box, place_at, top_speed
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world

RANDOM = np.random.default_rng(4)


def test_a_ball_flies_along_its_parabola_in_one_go_or_in_parts() -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0.5, -10)), 2.0)
    ball, flight = room.balls.rows[0], room.flights[0]
    for time in (0.0, 0.3, 0.7, 2.0):
        expected = 1 + 3 * time + 0.25 * time**2, 2 + 4 * time - 5 * time**2, 3 + 0.5 * time, 4 - 10 * time
        assert place_at(ball, flight, time) == pytest.approx(expected)
        fly_to(ball, flight, time)
        assert tuple(ball[name] for name in ("x", "y", "vx", "vy")) == pytest.approx(expected)
        assert flight["time"] == time
    # Seen from later, where it was.
    assert place_at(ball, flight, 0.3) == pytest.approx((1.9225, 2.75, 3.15, 1.0))


@pytest.mark.parametrize("kind", [ASLEEP, STALLED])
def test_who_sleeps_or_has_been_stopped_stays_where_it_is(kind: int) -> None:
    room = in_flight(continuous_world(Ball((1, 2), 1, velocity=(3, 4)), gravity=(0, -10)), 2.0)
    ball, flight = room.balls.rows[0], room.flights[0]
    ball["asleep"], flight["kind"] = int(kind == ASLEEP), kind if kind == STALLED else FLYING
    begin_flight(room.states[0], ball, flight)
    assert (flight["kind"], flight["ax"], flight["ay"]) == (kind, 0, 0)
    assert place_at(ball, flight, 2.0) == (1, 2, 0, 0)
    fly_to(ball, flight, 2.0)
    assert (ball["x"], ball["y"], ball["vx"]) == (1, 2, 3)


@pytest.mark.parametrize("case", range(20))
def test_a_box_holds_a_way_and_the_top_speed_is_not_exceeded(case: int) -> None:
    x, y, vx, vy, ax, ay = RANDOM.uniform(-9, 9, 6)
    begin, end = sorted(RANDOM.uniform(0, 3, 2))
    left, bottom, right, top = path_box(Path(x, y, vx, vy, ax, ay), begin, end)
    times = np.linspace(begin, end, 200)
    xs, ys = x + vx * times + ax * times**2 / 2, y + vy * times + ay * times**2 / 2
    slack = 1e-9
    assert left - slack <= xs.min() <= xs.max() <= right + slack
    assert bottom - slack <= ys.min() <= ys.max() <= top + slack
    # It is no wider than need be by more than a bulge, to each side.
    assert right - left <= xs.max() - xs.min() + abs(ax) * (end - begin) ** 2 / 4 + slack
    ball, flight = {"vx": vx, "vy": vy}, {"ax": ax, "ay": ay}
    most = top_speed(ball, flight, 3.0)  # type: ignore[arg-type]
    assert hypot(vx, vy) - slack <= max(hypot(vx + ax * t, vy + ay * t) for t in (0.0, 1.0, 2.0, 3.0)) <= most + slack


def test_the_soonest_event_is_kept() -> None:
    room = in_flight(continuous_world(Ball((0, 0), 1)), 1.0)
    flight = room.flights[0]
    flight["time"], flight["event_time"] = 0.25, inf
    for delay, event, partner in ((0.5, HIT_SHAPE, 3), (0.75, HIT_BALL, 4), (0.5, HIT_BALL, 5), (0.25, HIT_BALL, 6)):
        consider(flight, delay, event, partner)
    assert (flight["event_time"], flight["event"], flight["partner"]) == (0.5, HIT_BALL, 6)
