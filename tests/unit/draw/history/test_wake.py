"""What a world that goes on leaves behind, for some seconds: ways of the first balls that are there, and bounces."""

import numpy as np
import pytest

import carom
from carom.draw.history.trace import MOST_FOLLOWED
from carom.draw.history.wake import MOST_BOUNCES, SPACING, Wake
from carom.rows.hit import HIT
from tests.worlds import world_of

STEP = 1 / 64


def noted(world: carom.World, wake: Wake, steps: int) -> None:
    """Note some steps."""
    for _ in range(steps):
        wake.note(world.step(STEP))


def test_ways_reach_back_as_far_as_the_span_and_end_where_balls_are_now() -> None:
    world = world_of(carom.Ball((0, 0), 0.5, velocity=(64, 0)))
    wake = Wake(world, 0.5)
    noted(world, wake, 100)
    (track,) = wake.tracks()
    assert wake.since == track.times[-1] - 0.5 == world.time - 0.5
    assert wake.since <= track.times[0] < wake.since + 2 * SPACING
    assert track.points[-1].tolist() == [100.0, 0.0]
    assert track.points[:, 0] == pytest.approx(64 * track.times)
    # Where nothing is hit, far fewer places than steps are kept.
    assert len(track.times) < 0.5 / SPACING + 2 < 32


def test_a_way_goes_through_the_places_where_its_ball_bounced() -> None:
    world = world_of(carom.Segment((-5, 0), (5, 0)), carom.Ball((0, 2), 0.5, velocity=(0, -40)), detection="continuous")
    wake = Wake(world, 5.0)
    noted(world, wake, 8)
    (track,) = wake.tracks()
    assert track.points[:, 1].min() == pytest.approx(0.5)
    assert len(wake.hits) == len(wake.latest) == 1


def test_the_first_balls_are_followed_whenever_they_came_and_no_others() -> None:
    world = carom.World()
    world.add_balls([(3.0 * k, 0) for k in range(MOST_FOLLOWED + 3)], radius=1.0)
    wake = Wake(world, 1.0)
    noted(world, wake, 2)
    first = world.balls.id.tolist()
    assert wake.followed == first[:MOST_FOLLOWED]
    world.remove(world.balls[0], world.balls[5])
    noted(world, wake, 2)
    assert wake.followed == [*first[1:5], *first[6 : MOST_FOLLOWED + 2]]
    wake.forget()
    assert wake.followed == [] == list(wake.tracks())


def test_of_bounces_those_of_the_span_are_kept_and_of_too_many_the_last() -> None:
    world = carom.World()
    wake = Wake(world, 1.0)
    hits = np.zeros(MOST_BOUNCES + 50, HIT)
    hits["time"], hits["impulse"] = np.linspace(-1.0, 0.0, len(hits)), np.arange(len(hits))
    wake.note(hits)
    assert wake.hits["impulse"].tolist() == list(range(len(hits) - 1, 49, -1))
    world.step(0.5)
    wake.note(hits[:1])
    assert sorted(wake.hits["time"].tolist()) == [time for time in hits["time"].tolist() if time > -0.5]
    world.run(2.0)
    wake.note(hits[:0])
    assert len(wake.hits) == len(wake.latest) == 0
