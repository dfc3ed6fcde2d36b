"""What is remembered of a run: whose ways, how long, through which bounces, and the strongest hits."""

import numpy as np
import pytest

import carom
from carom.draw.history.trace import MOST_FOLLOWED, MOST_HITS, MOST_STEPS, MOST_WAITING, Trace, followed
from carom.draw.history.tracks import centers_at
from carom.rows.hit import HIT
from carom.world.hits import HitKind
from tests.worlds import world_of

STEP = 1 / 64


def traced(world: carom.World, steps: int) -> Trace:
    """The trace of some steps."""
    trace = Trace(world)
    for _ in range(steps):
        trace.note(world.step(STEP))
    return trace


def bounce(**fields: object) -> np.ndarray:
    """One bounce, of zeros but for `fields`."""
    hits = np.zeros(1, HIT)
    for name, value in fields.items():
        hits[name] = value
    return hits


def test_few_balls_are_all_followed_and_many_are_sampled_evenly() -> None:
    assert followed(np.array([1, 3, 9])).tolist() == [1, 3, 9]
    chosen = followed(np.arange(10_000))
    assert len(chosen) == MOST_FOLLOWED
    assert chosen[0] == 0
    assert chosen[-1] == 9_999
    assert np.ptp(np.diff(chosen)) <= 1


def test_a_track_holds_where_its_ball_was_after_each_step() -> None:
    right, down = carom.Ball((0, 0), 0.5, velocity=(64, 0)), carom.Ball((0, 5), 0.5, velocity=(0, -64))
    first, second = traced(world_of(right, down), 3).tracks()
    assert (first.ball, second.ball) == (right.id, down.id)
    assert first.times.tolist() == [0.0, STEP, 2 * STEP, 3 * STEP]
    assert first.points.tolist() == [[0, 0], [1, 0], [2, 0], [3, 0]]
    assert second.points.tolist() == [[0, 5], [0, 4], [0, 3], [0, 2]]


def test_only_the_last_steps_are_remembered() -> None:
    (track,) = traced(world_of(carom.Ball((0, 0), 0.5, velocity=(64, 0))), MOST_STEPS + 100).tracks()
    assert len(track.times) == MOST_STEPS + 1
    assert track.points[0].tolist() == [100, 0]
    assert track.points[-1].tolist() == [MOST_STEPS + 100, 0]


def test_steps_of_no_length_take_no_room() -> None:
    trace = traced(world := world_of(carom.Ball((0, 0), 0.5, velocity=(64, 0))), 3)
    for _ in range(5):
        trace.note(world.step(0.0))
    (track,) = trace.tracks()
    assert track.points[:, 0].tolist() == [0, 1, 2, 3]


def test_a_ball_that_leaves_the_world_ends_its_track_and_others_keep_theirs() -> None:
    gone, stays = carom.Ball((1, 1), 0.5), carom.Ball((3, 3), 0.5)
    world = world_of(gone, stays)
    trace = traced(world, 1)
    gone_id = gone.id
    world.remove(gone)
    trace.note(world.step(STEP))
    assert {track.ball: len(track.times) for track in trace.tracks()} == {gone_id: 2, stays.id: 3}
    assert trace.followed == [gone_id, stays.id]


def test_a_track_goes_through_the_place_where_its_ball_bounced() -> None:
    world = world_of(carom.Ball((0, 2), 0.5, velocity=(0, -40)), substeps=64)
    world.add(carom.Segment((-5, 0), (5, 0)))
    trace = traced(world, 4)
    (track,) = trace.tracks()
    assert trace.bounces == 1
    assert track.points[:, 1].min() == pytest.approx(0.5)
    assert (np.diff(track.times) >= 0).all()


def test_of_two_balls_that_meet_each_is_on_its_own_side_of_the_point() -> None:
    pair = bounce(time=0.5, ball=4, shape=3, point=(0.0, 0.0), normal=(1.0, 0.0))
    assert centers_at(pair, 4, 0.25)[1].tolist() == [[0.25, 0.0]]
    assert centers_at(pair, 3, 0.5)[1].tolist() == [[-0.5, 0.0]]
    assert len(centers_at(pair, 5, 0.5)[0]) == 0


def test_of_the_hits_the_strongest_bounces_are_kept_and_all_are_counted() -> None:
    trace = Trace(world_of())
    impulses = np.random.default_rng(0).permutation(MOST_WAITING + MOST_HITS).astype(float)
    for part in np.array_split(impulses, 7):
        hits = np.zeros(len(part), HIT)
        hits["impulse"] = part
        trace.note(hits)
    trace.note(bounce(kind=HitKind.ENTER, impulse=1e9))
    assert trace.bounces == len(impulses)
    assert trace.hits["impulse"].tolist() == sorted(impulses, reverse=True)[:MOST_HITS]


def test_of_equally_strong_hits_the_earliest_are_kept() -> None:
    trace = Trace(world_of())
    for start in range(0, 3 * MOST_WAITING, 1000):
        hits = np.zeros(1000, HIT)
        hits["impulse"] = 1.0
        hits["time"] = np.arange(start, start + 1000)
        trace.note(hits)
    assert trace.hits["time"].tolist() == list(range(MOST_HITS))


def test_tracing_changes_nothing() -> None:
    worlds = [carom.scenes.toy().build() for _ in range(2)]
    traced(worlds[0], 60)
    for _ in range(60):
        worlds[1].step(STEP)
    assert worlds[0].digest() == worlds[1].digest()


def test_what_are_no_hits_of_the_world_is_refused() -> None:
    world, other = (world_of(carom.Ball((0, 0), 0.5)) for _ in range(2))
    trace = Trace(world)
    for bad in (None, [], other.step(STEP)):
        with pytest.raises(carom.InvalidArgument, match="hits must be those"):
            trace.note(bad)
    trace.note(world.step(STEP))
