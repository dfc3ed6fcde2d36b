"""Runs in slices: the same as in one piece, followed step by step where asked, stopped between two slices."""

import signal

import pytest

import carom
from carom.cli.running import LONGEST_SLICE, SHORTEST_SLICE, Outcome, next_size, run

DT = 1 / 60


def toy_run(steps: int, *, keep_hits: bool = False, follow: bool = False) -> tuple[carom.World, Outcome, list[int]]:
    """The world and the outcome of a run of the toy, and the steps made at the end of each slice."""
    world = carom.scenes.toy().build()
    slices: list[int] = []
    outcome = run(world, steps, DT, keep_hits=keep_hits, follow=follow, tell=lambda done, took: slices.append(done))
    return world, outcome, slices


@pytest.mark.compiled
def test_slices_bring_what_one_run_brings() -> None:
    world, outcome, slices = toy_run(300, keep_hits=True)
    whole = carom.scenes.toy().build()
    hits = whole.run(300 * DT, dt=DT)
    assert len(slices) > 1
    assert slices[-1] == outcome.steps == 300
    assert world.digest() == whole.digest()
    assert outcome.hits.tobytes() == hits.tobytes()
    assert sum(count.bounces for count in outcome.tally.counts()) == world.statistics.collisions
    assert not outcome.stopped


def test_hits_are_kept_only_where_they_are_asked_for() -> None:
    _, outcome, _ = toy_run(60)
    assert len(outcome.hits) == 0
    assert outcome.trace is None


def test_a_run_that_is_followed_is_followed_at_every_step() -> None:
    _, outcome, slices = toy_run(60, follow=True)
    assert slices == list(range(1, 61))
    assert len(outcome.trace.tracks()[0].times) >= 61


def test_no_steps_are_no_run() -> None:
    world, outcome, slices = toy_run(0, follow=True)
    assert slices == []
    assert world.time == 0.0
    assert not outcome.stopped


def test_ctrl_c_stops_between_two_steps() -> None:
    world = carom.scenes.toy().build()

    def tell(done: int, took: float) -> None:
        if done == 7:
            signal.raise_signal(signal.SIGINT)

    outcome = run(world, 100, DT, keep_hits=False, follow=True, tell=tell)
    assert outcome.stopped
    assert outcome.steps == 7
    assert world.time == pytest.approx(7 * DT)


def test_slices_grow_while_they_are_short_and_shrink_when_they_are_long() -> None:
    assert next_size(8, 0.5 * SHORTEST_SLICE) == 16
    assert next_size(8, 0.5 * (SHORTEST_SLICE + LONGEST_SLICE)) == 8
    assert next_size(8, 2 * LONGEST_SLICE) == 4
    assert next_size(1, 2 * LONGEST_SLICE) == 1
