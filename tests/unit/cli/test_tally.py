"""Hits counted by what was hit: by name, by compound, by place, and balls among each other."""

import numpy as np

import carom
from carom.cli.tally import BALLS, Tally
from carom.rows.hit import HIT
from carom.world.hits import HitKind


def hits_of(*rows: tuple[int, int, float, float], begin: float = 0.0) -> np.ndarray:
    """Hits of given kind, shape, speed and impulse, all of one ball, which has left what it hits each time."""
    hits = np.zeros(len(rows), HIT)
    hits["normal"], hits["velocity"], hits["time"] = (0, 1), (0, -9), begin + np.arange(len(rows))
    for hit, (kind, shape, speed, impulse) in zip(hits, rows, strict=True):
        hit["kind"], hit["shape"], hit["speed"], hit["impulse"] = kind, shape, speed, impulse
    return hits


def test_shapes_of_one_name_count_together_whenever_they_are_hit() -> None:
    world = carom.World()
    left, right = (world.add(carom.Point((x, 0), name="post")) for x in (0, 1))
    tally = Tally.of(world)
    tally.add(hits_of((HitKind.BOUNCE, left.id, 2.0, 5.0), (HitKind.BOUNCE, right.id, 3.0, 4.0)))
    tally.add(hits_of())
    tally.add(hits_of((HitKind.BOUNCE, right.id, 1.0, 1.0), begin=5.0))
    (count,) = tally.counts()
    assert (count.label, count.touches, count.hits, count.fastest, count.strongest) == ("post", 3, 3, 3.0, 5.0)


def test_sensors_count_entries_only() -> None:
    world = carom.World()
    lane = world.add(carom.Segment((0, 0), (1, 0), sensor=True, name="lane"))
    tally = Tally.of(world)
    tally.add(hits_of((HitKind.ENTER, lane.id, 0.0, 0.0), (HitKind.EXIT, lane.id, 0.0, 0.0)))
    (count,) = tally.counts()
    assert (count.touches, count.bounces, count.entries, count.hits) == (1, 0, 1, 1)


def test_balls_among_each_other_are_one_line_and_the_most_frequent_comes_first() -> None:
    world = carom.World()
    wall = world.add(carom.Segment((0, 0), (1, 0), name="wall"))
    first, second = (world.add(carom.Ball((x, 1), 0.1)) for x in (0, 1))
    tally = Tally.of(world)
    bounces = [(HitKind.BOUNCE, shape.id, 1.0, 1.0) for shape in (first, second, wall)]
    tally.add(hits_of(*bounces))
    assert [(count.label, count.bounces) for count in tally.counts()] == [(BALLS, 2), ("wall", 1)]


def test_what_was_touched_most_often_comes_before_what_was_rolled_along() -> None:
    world = carom.World()
    rail, post = world.add(carom.Segment((0, 0), (9, 0), name="rail")), world.add(carom.Point((5, 5), name="post"))
    hits = hits_of(*[(HitKind.BOUNCE, rail.id, 1.0, 1.0)] * 9, *[(HitKind.BOUNCE, post.id, 1.0, 1.0)] * 2)
    hits["velocity"][:9] = (1, 0)
    tally = Tally.of(world)
    for part in np.split(hits, [4, 10]):
        tally.add(part)
    assert [(count.label, count.touches, count.hits) for count in tally.counts()] == [("post", 2, 2), ("rail", 1, 9)]
