"""Hits counted by what was hit."""

import numpy as np
import pytest

import carom
from carom.rows.hit import BOUNCE, ENTER, EXIT
from carom.world.counts import COUNT, Counter
from carom.world.touches import touches_of
from tests.worlds import crowded


@pytest.fixture(scope="module")
def hits() -> carom.Hits:
    """Bounces of many balls, and sensors entered and left."""
    return crowded().run(1.0)


def test_counts_are_those_of_each_shapes_hits(hits: carom.Hits) -> None:
    rows = hits.view(np.ndarray)
    counts = hits.counts()
    assert counts["shape"].tolist() == np.unique(rows["shape"]).tolist()
    for count in counts:
        mine = rows[rows["shape"] == count.shape.id]
        bounces = mine[mine["kind"] == BOUNCE]
        numbers = [np.count_nonzero(mine["kind"] == kind) for kind in (BOUNCE, ENTER, EXIT)]
        assert [count.bounces, count.entries, count.exits] == numbers
        assert count.touches == len(touches_of(mine))
        assert count.first == mine["time"][0]
        assert count.fastest == bounces["speed"].max(initial=0.0)
        assert count.strongest == bounces["impulse"].max(initial=0.0)
    assert repr(counts) == f"<counts of {len(counts)} shapes>"
    assert counts["entries"].sum() > 0


@pytest.mark.parametrize("gathered", [1, 7, 10**6])
def test_counts_do_not_depend_on_how_many_hits_are_counted_at_once(
    hits: carom.Hits, gathered: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("carom.world.counts.GATHERED", gathered)
    rows, counter = hits.view(np.ndarray), Counter()
    for place in range(0, len(rows), 5):
        counter.add(rows[place : place + 5])
    assert counter.rows().tobytes() == hits.counts().tobytes()


def test_nothing_was_counted_where_nothing_was_hit() -> None:
    assert len(Counter().rows()) == 0
    assert Counter().rows().dtype == COUNT
    assert not carom.World().run(1.0).counts()
