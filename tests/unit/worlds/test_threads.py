"""Threads: shares that are all copies, an interruption that stops everybody, forks, and one thread in a worker."""

import multiprocessing
import os
from typing import Any

import pytest

import carom
from carom.worlds import threads
from carom.worlds.stage import Stage
from tests.forks import forked
from tests.worlds import game_table


@pytest.mark.parametrize(("most", "count"), [(1, 5), (2, 31), (2, 32), (7, 1000), (64, 100)])
def test_shares_are_all_copies_once(most: int, count: int) -> None:
    shares = threads.Crew(most).shares(count)
    assert [copy for first, last in shares for copy in range(first, last)] == list(range(count))
    assert len(shares) == max(1, min(most, count // threads.SHARE))


def test_an_interruption_stops_all_and_leaves_whole_copies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(threads, "SHARE", 1)
    many = carom.Worlds(game_table("discrete"), 4, threads=2)
    many.step(1 / 50)
    work = Stage.work

    def interrupted(self: Stage, stop: Any) -> bool:
        if self is many._stages[0]:
            raise KeyboardInterrupt
        return work(self, stop)

    monkeypatch.setattr(Stage, "work", interrupted)
    with pytest.raises(KeyboardInterrupt):
        many.step(1 / 50)
    monkeypatch.setattr(Stage, "work", work)
    assert many.time[:2].tolist() == [1 / 50, 1 / 50]
    many.reset()
    many.step(1 / 50)
    assert len(set(many.digests())) == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no process is forked here")
def test_a_forked_process_has_threads_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(threads, "SHARE", 1)
    many, alone = (carom.Worlds(game_table("discrete"), 4, threads=count) for count in (3, 1))
    many.step(1 / 50)
    alone.run(2 / 50, 1 / 50)

    def goes_on() -> None:
        many.step(1 / 50)
        assert many.digests() == alone.digests()

    assert forked(goes_on) == 0
    assert forked(lambda: forked(goes_on)) == 0
    goes_on()


def test_a_process_that_another_has_started_has_one(monkeypatch: pytest.MonkeyPatch) -> None:
    assert threads.cores() >= 1
    monkeypatch.setattr(multiprocessing, "parent_process", object)
    assert threads.cores() == 1
