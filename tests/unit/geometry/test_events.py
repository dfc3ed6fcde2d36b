"""When a ball leaves a box, gets slow and stops: worked examples, and many moments of its flight."""

from math import hypot, inf

import numpy as np
import pytest
from hypothesis import given

from carom.geometry import events
from carom.geometry.path import Path, path_after, place_on
from tests.strategies import seeds

BOX = (-4.0, -3.0, 4.0, 3.0)
EVERYWHERE = (-inf, -inf, inf, inf)


def outside(path: Path, radius: float, time: float) -> bool:
    """Whether the ball's box has no point in common with the box."""
    (x, y), (left, bottom, right, top) = place_on(path, time), BOX
    return x - radius > right or x + radius < left or y - radius > top or y + radius < bottom


def test_a_ball_leaves_when_the_whole_of_it_has() -> None:
    assert events.leaving_time(Path(0.0, 0.0, 2.0, 0.0, 0.0, 0.0), 1.0, *BOX) == 2.5
    assert events.leaving_time(Path(0.0, 0.0, -2.0, 0.0, 0.0, 0.0), 1.0, *BOX) == 2.5
    assert events.leaving_time(Path(0.0, 0.0, 0.5, 4.0, 0.0, 0.0), 1.0, *BOX) == 1.0
    assert events.leaving_time(Path(0.0, 0.0, 0.0, 0.0, 0.0, -8.0), 1.0, *BOX) == 1.0
    # Thrown up over the upper edge it leaves, to the edge and back it does not, but falls out below.
    assert events.leaving_time(Path(0.0, 0.0, 0.0, 9.0, 0.0, -8.0), 1.0, *BOX) == pytest.approx(0.6096, abs=1e-4)
    assert events.leaving_time(Path(0.0, 0.0, 0.0, 8.0, 0.0, -8.0), 1.0, *BOX) == pytest.approx(1.0 + 2.0**0.5)


def test_a_ball_that_has_left_leaves_now_and_one_on_the_edge_if_it_goes_on() -> None:
    assert events.leaving_time(Path(6.0, 0.0, -9.0, 0.0, 0.0, 0.0), 1.0, *BOX) == 0.0
    assert events.leaving_time(Path(5.0, 0.0, 1.0, 0.0, 0.0, 0.0), 1.0, *BOX) == 0.0
    assert events.leaving_time(Path(5.0, 0.0, 0.0, 0.0, 1.0, 0.0), 1.0, *BOX) == 0.0
    assert events.leaving_time(Path(5.0, 0.0, -1.0, 0.0, 0.0, 0.0), 1.0, *BOX) == 10.0
    assert events.leaving_time(Path(5.0, 0.0, -1.0, 0.0, 2.0, 0.0), 1.0, *BOX) == 1.0


def test_a_ball_that_never_leaves_has_no_time() -> None:
    assert events.leaving_time(Path(5.0, 0.0, 0.0, 0.0, 0.0, 0.0), 1.0, *BOX) is None
    for pull in (0.0, 3.0, -3.0):
        for vx in (0.0, 7.0, -7.0):
            assert events.leaving_time(Path(0.0, 0.0, vx, 0.0, pull, pull), 1.0, *EVERYWHERE) is None
    assert events.leaving_time(Path(0.0, 0.0, 1e-300, 0.0, 0.0, 0.0), 1e300, *BOX) is None


@given(seeds)
def test_before_it_leaves_a_ball_is_in_the_box_and_then_it_is_not(seed: int) -> None:
    random = np.random.default_rng(seed)
    path, radius = Path(*random.uniform(-3, 3, 6).tolist()), random.uniform(0.1, 2)
    found = events.leaving_time(path, radius, *BOX)
    assert found is not None
    assert not any(outside(path, radius, time) for time in np.linspace(0.0, found * (1.0 - 1e-12), 200))
    assert outside(path, radius, found * (1.0 + 1e-9) + 1e-9)


@given(seeds)
def test_a_ball_is_slow_when_it_is_found_to_be(seed: int) -> None:
    random = np.random.default_rng(seed)
    path, speed = Path(*random.uniform(-3, 3, 6).tolist()), random.uniform(0.0, 3.0)
    found = events.slowing_time(path, speed)
    times = np.linspace(0.0, 20.0 if found is None else found, 400)
    paces = np.hypot(path.vx + path.gx * times, path.vy + path.gy * times)
    if found is None:
        assert paces.min() > speed
    elif found > 0.0:
        assert paces[:-1].min() > speed - 1e-12
        assert paces[-1] == pytest.approx(speed, abs=1e-14)
    else:
        assert paces[0] <= speed


def test_a_ball_that_falls_faster_is_never_slow_and_one_thrown_straight_up_stands_still() -> None:
    assert events.slowing_time(Path(0.0, 0.0, 0.0, -1.0, 0.0, -9.0), 0.5) is None
    assert events.slowing_time(Path(0.0, 0.0, 3.0, 4.0, 0.0, -9.0), 2.9) is None
    assert events.slowing_time(Path(0.0, 0.0, 3.0, 4.0, 0.0, 0.0), 2.9) is None
    assert events.slowing_time(Path(0.0, 0.0, 3.0, 4.0, 0.0, -8.0), 3.0) == 0.5
    assert events.slowing_time(Path(0.0, 0.0, 0.0, 4.0, 0.0, -8.0), 0.0) == 0.5
    assert events.slowing_time(Path(0.0, 0.0, 3.0, 4.0, 0.0, -8.0), 5.0) == 0.0
    assert events.slowing_time(Path(0.0, 0.0, 0.0, 1e8, 0.0, -1e-8), 1e8 - 1.0) == pytest.approx(1e8, rel=1e-7)


def test_a_ball_that_is_slowed_rolls_straight_on_until_it_stops() -> None:
    path = Path(1.0, 2.0, 3.0, -4.0, 7.0, 7.0)
    slowed = events.braked(path, 2.0)
    assert slowed == pytest.approx((1.0, 2.0, 3.0, -4.0, -1.2, 1.6))
    assert events.stopping_time(slowed, 2.0) == 2.5
    end = path_after(slowed, 2.5)
    assert hypot(end.vx, end.vy) <= 1e-15
    assert (end.x, end.y) == pytest.approx((1.0 + 0.6 * 6.25, 2.0 - 0.8 * 6.25))


def test_a_ball_at_rest_has_stopped_and_one_that_nothing_slows_never_does() -> None:
    rest = Path(1.0, 2.0, 0.0, 0.0, 0.0, 0.0)
    assert events.stopping_time(rest, 2.0) == 0.0
    assert events.braked(rest, 2.0) == rest
    for deceleration in (0.0, -1.0, 1e-320):
        assert events.stopping_time(Path(0.0, 0.0, 3.0, 4.0, 0.0, 0.0), deceleration) is None
