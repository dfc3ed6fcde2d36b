"""What a run keeps of its hits."""

from math import nan
from typing import Any

import numpy as np
import pytest

import carom
from carom.world.counts import Counts
from tests.worlds import bits, crowded


@pytest.mark.compiled
def test_a_run_that_keeps_counts_counts_what_one_that_keeps_all_has() -> None:
    world, twin = crowded(), crowded()
    counts = world.run(4.0, keep="counts")
    hits = twin.run(4.0, keep="all")
    assert isinstance(counts, Counts)
    assert counts.tobytes() == hits.counts().tobytes()
    assert counts["bounces"].sum() > 50
    assert [count.shape.id for count in counts] == counts["shape"].tolist()
    assert world.digest() == twin.digest()


def test_a_run_that_keeps_nothing_goes_the_same_way() -> None:
    world, twin = crowded(), crowded()
    hits = world.run(0.5, keep="none")
    assert isinstance(hits, carom.Hits)
    assert len(hits) == 0
    twin.run(0.5)
    assert world.digest() == twin.digest()
    assert bits(world.step(1 / 60)) == bits(twin.step(1 / 60))


@pytest.mark.parametrize("keep", ["none", "counts"])
def test_what_is_not_kept_takes_no_room(keep: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.world.running.SLICE_SECONDS", 0.0)
    monkeypatch.setattr("carom.world.counts.GATHERED", 100)
    world = carom.World(detection="continuous", substeps=1)
    world.add(carom.Segment((-1, -1), (-1, 1)), carom.Segment((1, -1), (1, 1)))
    world.add(carom.Ball((0, 0), 0.5, velocity=(90, 0)))
    kept = world.run(20.0, dt=0.1, keep=keep)
    assert world.statistics.collisions > 1700
    assert len(world._arrays.hits) < 200
    assert kept.nbytes < 1000


def test_the_strays_of_a_run_are_told_whatever_it_keeps() -> None:
    for keep in ("all", "none", "counts"):
        world = carom.World(bounds=(-1, -1, 1, 1), remove_strays=True)
        world.add(carom.Ball((0, 0), 0.1, (5, 0), name="lost"))
        world.run(1.0, keep=keep)
        assert [ball.name for ball in world.strays] == ["lost"]


def test_a_failure_tells_what_was_kept_until_then() -> None:
    for keep in ("all", "none", "counts"):
        world = crowded()

        def spoil(done: float, total: float, world: carom.World = world) -> None:
            if done > 0.4:
                world.balls.velocity[0] = nan

        with pytest.raises(carom.NonFiniteState) as caught:
            world.run(5.0, progress=spoil, keep=keep)
        hits = crowded().run(world.time)
        if keep == "counts":
            assert caught.value.hits.tobytes() == hits.counts().tobytes()
        else:
            assert bits(caught.value.hits) == (bits(hits) if keep == "all" else b"")


def test_an_interruption_leaves_only_all_hits_to_the_next_step() -> None:
    for keep in ("all", "none", "counts"):
        world, straight = crowded(), crowded()

        def stop(done: float, total: float) -> None:
            if done > 0.4:
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            world.run(5.0, progress=stop, keep=keep)
        before = straight.run(world.time)
        after = straight.step(1 / 60)
        found = world.step(1 / 60)
        assert np.asarray(found["time"]).tolist() == ([*before["time"]] if keep == "all" else []) + [*after["time"]]


class Interrupt(Exception):
    """What a user's function raises."""


def bouncing() -> carom.World:
    """A world in which a ball bounces ten times a second."""
    world = carom.World()
    world.add(carom.Segment((-1, -1), (-1, 1), name="left"), carom.Segment((1, -1), (1, 1), name="right"))
    world.add(carom.Ball((0.0, 0), 0.5, velocity=(10, 0)))
    return world


@pytest.mark.parametrize("seen_by", ["until", "progress"])
def test_what_a_function_raises_loses_no_hit_and_returns_none_twice(seen_by: str) -> None:
    world, straight = bouncing(), bouncing()
    seen: list[float] = []

    def looks(hits: carom.Hits) -> bool:
        seen.extend(hits["time"].tolist())
        if len(seen) >= 4:
            raise Interrupt
        return False

    def progress(done: float, total: float) -> None:
        raise Interrupt

    with pytest.raises(Interrupt):
        world.run(1.0, until=looks, progress=progress if seen_by == "progress" else None)
    left = straight.run(world.time)
    assert seen == left["time"].tolist()
    again: list[float] = []
    rest = world.run(1.0, until=lambda hits: again.extend(hits["time"].tolist()))
    more = straight.run(1.0)
    assert again == more["time"].tolist()
    assert bits(rest) == bits(left) + bits(more)
    assert bits(world.step(1.0)) == bits(straight.step(1.0))


@pytest.mark.parametrize("until", [2, "right", "each"])
def test_hits_of_a_run_that_was_interrupted_end_no_other_run(until: int | str) -> None:
    world, straight = bouncing(), bouncing()

    def stop(hits: carom.Hits) -> None:
        if len(hits):
            raise Interrupt

    with pytest.raises(Interrupt):
        world.run(1.0, until=stop)
    left = straight.run(world.time)
    assert len(left) == 1
    ends = {"until_each": 2} if until == "each" else {"until": until}
    hits, expected = world.run(1.0, **ends), straight.run(1.0, **ends)
    assert bits(hits) == bits(left) + bits(expected)
    assert world.digest() == straight.digest()


def test_a_ball_that_left_a_sensor_by_removal_is_told_to_the_next_run() -> None:
    world = carom.World()
    sensor = world.add(carom.Circle((0, 0), 2.0, sensor=True))
    world.add(carom.Ball((-3.0, 0), 0.5, velocity=(10, 0)))
    assert len(world.run(0.1)) == 1
    world.remove(sensor)
    kinds: list[int] = []
    world.run(0.1, until=lambda hits: kinds.extend(hits["kind"].tolist()))
    assert kinds == [carom.HitKind.EXIT]


def test_hits_of_a_state_that_is_gone_are_owed_no_more() -> None:
    world = bouncing()
    before = world.snapshot()

    def stop(hits: carom.Hits) -> None:
        if len(hits):
            raise Interrupt

    with pytest.raises(Interrupt):
        world.run(1.0, until=stop)
    world.restore(before)
    assert bits(world.run(0.5, until=100)) == bits(bouncing().run(0.5))


def test_an_error_of_another_world_brings_its_own_hits_alone() -> None:
    for keep in ("all", "none"):
        world, straight, other = bouncing(), bouncing(), bouncing()

        def spoil(done: float, total: float, other: carom.World = other) -> None:
            other.balls.velocity[0] = nan

        def looks(hits: carom.Hits, other: carom.World = other, spoil: Any = spoil) -> None:
            if len(hits):
                other.run(1.0, progress=spoil)

        with pytest.raises(carom.NonFiniteState) as caught:
            world.run(1.0, until=looks, keep=keep)
        assert bits(caught.value.hits) == bits(bouncing().run(other.time))
        left = straight.run(world.time)
        found = world.step(0.1)
        assert bits(found) == (bits(left) if keep == "all" else b"") + bits(straight.step(0.1))


def test_other_words_are_refused() -> None:
    with pytest.raises(carom.InvalidArgument, match="keep must be"):
        carom.World().run(1.0, keep="some")
