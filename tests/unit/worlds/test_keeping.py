"""Copies as snapshots: balls that come in move the relations of others, and lent columns are seen."""

import numpy as np
import pytest

import carom
from carom.worlds import keeping
from tests.worlds import game_table, world_of


def test_balls_that_come_in_leave_the_others_in_what_they_are_in() -> None:
    sensor = carom.Circle((0, 0), 2.0, sensor=True, solid=True)
    balls = [carom.Ball((x, 0), 0.2, sensor=x > 0.5) for x in (-1.0, 0.0, 1.0)]
    world = world_of(sensor, *balls, carom.Ball((1.1, 0.1), 0.2))
    worlds = carom.Worlds(world, 1, threads=1)
    assert {hit.kind for hit in worlds.step(0.01)} == {carom.HitKind.ENTER}
    worlds.balls.in_play[0, 0] = False
    gone = worlds.step(0.01)
    assert [(hit.kind, hit.ball.id) for hit in gone] == [(carom.HitKind.EXIT, balls[0].id)]
    worlds.balls.in_play[0, 0] = True
    back = worlds.step(0.01)
    assert [(hit.kind, hit.ball.id) for hit in back] == [(carom.HitKind.ENTER, balls[0].id)]
    assert len(worlds.step(0.01)) == 0


def test_only_copies_that_were_changed_are_woken() -> None:
    worlds = carom.Worlds(game_table("continuous"), 3, threads=1)
    worlds.step(0.02)
    memory = worlds._common.memory
    lent = keeping.lent_columns(memory)
    memory.balls["mass"][1, 2] = 7.0
    keeping.wake_changed(memory, lent)
    assert memory.state["wake"].tolist() == [0, 1, 0]


def test_a_damaged_snapshot_is_refused() -> None:
    counts = np.zeros((2, 1, 2), np.int64)
    whole = keeping.packed([b"ab", b"c"], counts)
    parts, read = keeping.unpacked(whole, counts.shape)
    assert parts == [b"ab", b"c"]
    assert read.tolist() == counts.tolist()
    for wrong in (whole[:-1], whole + b"x", whole.replace(b"abc", b"abd"), b"carom"):
        with pytest.raises(carom.SnapshotError):
            keeping.unpacked(wrong, counts.shape)
    with pytest.raises(carom.SnapshotError, match="must be of 3 copies, not of 2"):
        keeping.unpacked(whole, (3, 1, 2))


def test_what_a_ball_has_that_is_not_in_play_wakes_nobody() -> None:
    world = game_table("continuous")
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.balls.in_play[:, 2] = False
    worlds.run(0.1)
    before = worlds.digests()
    worlds.balls.radius[0, 2] = 0.25
    assert worlds.digests() == before
    worlds.balls.radius[1, 1] = 0.25
    assert worlds.digests()[1] != before[1]
