"""Hits are given while there is room, and counted by what was met."""

import numpy as np
import pytest

from carom.rows.copies import JOB, LAYOUT, STEP_DUE
from carom.rows.hit import BOUNCE, ENTER, EXIT, HIT_ROW
from carom.world.kernels.copies import stepping
from carom.world.kernels.copies.stepping import LINE, call_at, call_step, count_hits, give_hits, prefetch_copy


def test_hits_are_given_while_there_is_room() -> None:
    jobs = np.zeros(1, JOB)
    job = jobs[0]
    job["keep_hits"] = 1
    hits, rows, copies = np.zeros(3, HIT_ROW), np.zeros(4, HIT_ROW), np.zeros(4, np.int64)
    hits["time"] = [1.0, 2.0, 3.0]
    assert give_hits(job, hits, 3, 7, (rows, copies))
    assert not give_hits(job, hits, 2, 8, (rows, copies))
    assert (job["written"], job["wanted"]) == (3, 5)
    assert give_hits(job, hits, 1, 8, (rows, copies))
    assert rows["time"].tolist() == [1.0, 2.0, 3.0, 1.0]
    assert copies.tolist() == [7, 7, 7, 8]
    job["keep_hits"] = 0
    assert give_hits(job, hits, 3, 9, (rows, copies))


def test_bounces_and_entries_are_counted_by_what_was_met() -> None:
    hits = np.zeros(5, HIT_ROW)
    hits["shape"], hits["kind"] = [1, 3, 3, 2, 3], [BOUNCE, ENTER, BOUNCE, BOUNCE, EXIT]
    counts = np.zeros(2 * 2 * 2, np.int64)
    count_hits(hits, 5, 1, (np.array([2, 0, -1, 1]), counts))
    assert counts.reshape(2, 2, 2).tolist() == [[[0, 0], [0, 0]], [[1, 0], [1, 1]]]


def test_all_of_a_copy_is_brought_near_and_nothing_behind_the_last(monkeypatch: pytest.MonkeyPatch) -> None:
    layout, memory, asked = np.zeros(1, LAYOUT)[0], np.zeros(60, np.int64), list[int]()
    layout["words"] = 20
    monkeypatch.setattr(stepping, "prefetch", lambda _memory, word: asked.append(word))
    for copy in range(5):
        prefetch_copy(layout, memory, copy)
    for copy in range(3):
        lines = {word // LINE for word in range(20 * copy, 20 * copy + 20 - LINE)}
        assert lines <= {word // LINE for word in asked if 20 * copy <= word < 20 * copy + 20}
    assert len(asked) == 9
    assert max(asked) < 60


def test_where_no_step_can_be_called_the_caller_makes_it() -> None:
    jobs = np.zeros(1, JOB)
    jobs[0]["status"] = STEP_DUE
    assert call_step(jobs[0]) == STEP_DUE == call_at(0, 0)
    jobs[0]["status"] = 0
    assert call_step(jobs[0]) == 0
    assert jobs[0]["status"] == STEP_DUE
