"""The ledger of balls."""

import pytest

import carom
from carom.play.pinball import Ledger


def test_a_ball_is_in_one_place_from_its_making_to_its_end() -> None:
    ledger = Ledger()
    ledger.serve()
    assert (ledger.created, ledger.held) == (1, 1)
    ledger.enter()
    assert (ledger.held, ledger.in_play) == (0, 1)
    ledger.take(held=False)
    assert (ledger.in_play, ledger.drained, ledger.stray) == (0, 1, 0)
    assert ledger.balances


def test_strays_and_balls_in_the_lane_are_booked_out_too() -> None:
    ledger = Ledger()
    ledger.serve()
    ledger.take(held=True)
    ledger.serve()
    ledger.enter()
    ledger.take(held=False, stray=True)
    assert ledger == Ledger(created=2, drained=1, stray=1)
    assert ledger.balances


@pytest.mark.parametrize(
    "wrong",
    [
        Ledger(created=1),
        Ledger(created=1, in_play=1, drained=1),
        Ledger(created=0, in_play=1, held=-1),
        Ledger(created=2, held=1, stray=0),
    ],
)
def test_a_ball_lost_or_counted_twice_is_seen(wrong: Ledger) -> None:
    assert not wrong.balances


def test_the_world_holds_the_balls_that_the_ledger_says() -> None:
    world = carom.World()
    ledger = Ledger(created=2, in_play=1, drained=1)
    assert not ledger.check(world)
    world.add(carom.Ball((0.0, 0.0), 0.6))
    assert ledger.check(world)
    assert not Ledger(created=2, in_play=1).check(world)
