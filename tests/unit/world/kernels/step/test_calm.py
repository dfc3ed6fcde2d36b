"""Kinematic shapes that are left alone in a step are, when it is over, what every substep would have made of them."""

from collections.abc import Callable

import numpy as np
import pytest

from carom import Ball, Segment, World
from carom.rows.pose import advance
from carom.rows.state import DONE, NEEDS_PAIRS, NEEDS_ROOM, STALE
from carom.rows.tables import Row
from carom.world.kernels.broad_phase.shape_index import MOVING
from carom.world.kernels.step import calm, discrete, motion
from carom.world.kernels.step.calm import is_calm, pay_turns
from tests.kernel_calls import begun, prepared
from tests.worlds import world_of

H = 1 / 480


def hand(**motion: object) -> Segment:
    """A shape that turns about the origin."""
    return Segment((0, 0), (3, 1), motion="kinematic", pivot=(0, 0), **motion)  # type: ignore[arg-type]


def stopped(low: float, high: float, orientation: float, spin: float) -> Row:
    """The row of one that has stops."""
    row = hand(angular_velocity=spin)._row
    row["turn_limited"], row["turn_low"], row["turn_high"], row["orientation"] = 1, low, high, orientation
    return row


def test_calm_is_what_only_turns_and_meets_no_stop() -> None:
    assert is_calm(hand(angular_velocity=2.0)._row, H, 8)
    assert not is_calm(hand(angular_velocity=2.0, velocity=(0, 1e-9))._row, H, 8)
    sent = hand(angular_velocity=2.0)._row
    sent["time_left"] = 1.0
    assert not is_calm(sent, H, 8)
    assert is_calm(stopped(-1, 1, 1.0, 5.0), H, 8)  # pressed against its stop
    assert is_calm(stopped(-1, 1, -1.0, 5.0), H, 8)  # leaves it
    assert not is_calm(stopped(-1, 1, 0.99, 5.0), H, 8)
    assert not is_calm(stopped(-1, 1, -0.99, -5.0), H, 8)


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_one_that_is_calm_meets_no_stop_however_sums_are_rounded(sign: float) -> None:
    random, calm = np.random.default_rng(3), 0
    for _ in range(2000):
        start = random.uniform(-1, 1) * 10.0 ** random.integers(-3, 12)
        spin = sign * abs(start) * 10.0 ** random.uniform(-14, -10)
        way = sign * np.spacing(start) * random.integers(0, 400)
        ends = sorted((start - sign, start + way))
        row = stopped(ends[0], ends[1], start, spin)
        if is_calm(row, H, 8):
            calm += 1
            for _ in range(8):
                assert advance(row, H) != 0 or row["spin"] == 0.0
                assert ends[0] < row["orientation"] < ends[1] or row["orientation"] == start
    assert calm > 200


def test_turns_that_are_owed_are_added_one_by_one() -> None:
    for count in range(9):
        row, other = (hand(angular_velocity=0.7)._row for _ in range(2))
        pay_turns(row, H, count)
        for _ in range(count):
            advance(other, H)
        assert row["orientation"] == other["orientation"]
    still = stopped(0.0, 1.0, -0.0, 0.0)
    pay_turns(still, H, 3)
    assert np.signbit(still["orientation"])


def table(ball: tuple[float, float], velocity: tuple[float, float], more: int = 0) -> World:
    """A ball, a hand that turns, one pressed against its stop, one that comes to one as a step ends, one on its way.

    And so many more balls beside that one, and hands that turn.
    """
    world = world_of(hand(angular_velocity=4.0), substeps=8)
    for x, spin, stops in ((20.0, 3.0, (-1.0, 0.0)), (60.0, 9.0, (0.0, 0.14))):
        limits = {"angular_velocity": spin, "turn_limits": stops, "pivot": (x, 0)}
        world.add(Segment((x, 0), (x + 3, 1), motion="kinematic", **limits))  # type: ignore[arg-type]
    world.add(Segment((40, 0), (43, 1), motion="kinematic", velocity=(1, 0)))
    world.add(Ball(ball, 0.25, velocity=velocity))
    for k in range(more):
        world.add(Segment((9 * k, -20), (9 * k, -18), motion="kinematic", angular_velocity=2.0, pivot=(9 * k, -20)))
        world.add(Ball((ball[0], ball[1] + 0.6 * k + 0.6), 0.25, velocity=velocity))
    return world


@pytest.mark.parametrize("more", [0, 12])
@pytest.mark.parametrize(
    ("ball", "velocity"),
    [
        ((0.0, 90.0), (0.0, 0.0)),
        ((8.0, 1.0), (-120.0, 0.0)),
        ((6.0, 1.0), (-400.0, 0.0)),
        ((23.0, 3.0), (0.0, -90.0)),
        ((62.0, 3.2), (0.0, -90.0)),
    ],
)
def test_a_step_is_the_same_to_the_bit_whether_any_is_left_alone(
    ball: tuple[float, float], velocity: tuple[float, float], more: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, left = table(ball, velocity, more), 0
    asked: Callable[..., int] = calm.leave_alone

    def counted(*arguments: object) -> int:
        nonlocal left
        alone = asked(*arguments)
        left += alone
        return alone

    monkeypatch.setattr(motion, "leave_alone", counted)
    digests = [stepped(first) for _ in range(6)]
    monkeypatch.setattr(motion, "leave_alone", lambda *_: 0)
    second = table(ball, velocity, more)
    assert digests == [stepped(second) for _ in range(6)]
    assert left > more


def stepped(world: World) -> str:
    """The digest after one more step, interpreted."""
    arrays = prepared(world)
    state = arrays.states[0]
    state["dt"], state["steps_left"], state["moving_stale"] = 1 / 60, 1, STALE
    while (status := discrete.step_discrete(*arrays.block().arguments)) != DONE:
        assert status in (NEEDS_ROOM, NEEDS_PAIRS)
        arrays.extend(status)
    return world.digest()


def test_none_is_left_alone_while_a_ball_is_near_or_many_are_there() -> None:
    for ball, left in (((0.0, 90.0), 2), ((2.0, 2.0), 0)):
        arrays = prepared(table(ball, (0.0, 0.0)))
        arrays.states[0]["dt"], arrays.states[0]["moving_stale"] = 1 / 60, STALE
        assert begun(arrays) == DONE
        entry = arrays.index[MOVING]
        assert entry["calm"] == 2
        tables = arrays.balls.rows, arrays.shapes.rows, arrays.order
        motion.move_shapes(arrays.states[0], *tables, entry, H)
        assert entry["calm"] == left
    world = table((0.0, 90.0), (0.0, 0.0))
    for k in range(8):
        world.add(Ball((4.0 * k, 80.0), 0.25))
    arrays = prepared(world)
    arrays.states[0]["moving_stale"] = STALE
    assert begun(arrays) == DONE
    assert arrays.index[MOVING]["calm"] == 0
