"""What a world that goes on leaves behind, for some seconds: ways of the first balls that are there, and bounces."""

import numpy as np
import pytest

import carom
from carom.draw.history.past import MOST_BOUNCES, SPACING, Past
from carom.draw.history.trace import MOST_FOLLOWED
from carom.rows.hit import HIT
from tests.worlds import world_of

STEP = 1 / 64


def noted(world: carom.World, past: Past, steps: int) -> None:
    """Note some steps."""
    for _ in range(steps):
        past.note(world.step(STEP))


def test_ways_reach_back_as_far_as_the_span_and_end_where_balls_are_now() -> None:
    world = world_of(carom.Ball((0, 0), 0.5, velocity=(64, 0)))
    past = Past(world, 0.5)
    noted(world, past, 100)
    (track,) = past.tracks()
    assert past.since == track.times[-1] - 0.5 == world.time - 0.5
    assert past.since <= track.times[0] < past.since + 2 * SPACING
    assert track.points[-1].tolist() == [100.0, 0.0]
    assert track.points[:, 0] == pytest.approx(64 * track.times)
    # Where nothing is hit, far fewer places than steps are kept.
    assert len(track.times) < 0.5 / SPACING + 2 < 32


def test_a_way_goes_through_the_places_where_its_ball_bounced() -> None:
    world = world_of(carom.Segment((-5, 0), (5, 0)), carom.Ball((0, 2), 0.5, velocity=(0, -40)), detection="continuous")
    past = Past(world, 5.0)
    noted(world, past, 8)
    (track,) = past.tracks()
    assert track.points[:, 1].min() == pytest.approx(0.5)
    assert len(past.hits) == len(past.latest) == 1


def test_the_first_balls_are_followed_whenever_they_came_and_no_others() -> None:
    world = carom.World()
    world.add_balls([(3.0 * k, 0) for k in range(MOST_FOLLOWED + 3)], radius=1.0)
    past = Past(world, 1.0)
    noted(world, past, 2)
    first = world.balls.id.tolist()
    assert past.followed == first[:MOST_FOLLOWED]
    world.remove(world.balls[0], world.balls[5])
    noted(world, past, 2)
    assert past.followed == [*first[1:5], *first[6 : MOST_FOLLOWED + 2]]
    past.forget()
    assert past.followed == [] == list(past.tracks())


def test_of_bounces_those_of_the_span_are_kept_and_of_too_many_the_last() -> None:
    world = carom.World()
    past = Past(world, 1.0)
    hits = np.zeros(MOST_BOUNCES + 50, HIT)
    hits["time"], hits["impulse"] = np.linspace(-1.0, 0.0, len(hits)), np.arange(len(hits))
    past.note(hits)
    assert past.hits["impulse"].tolist() == list(range(len(hits) - 1, 49, -1))
    world.step(0.5)
    past.note(hits[:1])
    assert sorted(past.hits["time"].tolist()) == [time for time in hits["time"].tolist() if time > -0.5]
    world.run(2.0)
    past.note(hits[:0])
    assert len(past.hits) == len(past.latest) == 0


def test_what_are_no_hits_of_the_world_is_refused() -> None:
    world, other = (world_of(carom.Ball((0, 0), 0.5)) for _ in range(2))
    past = Past(world, 1.0)
    for bad in (None, [], other.step(STEP)):
        with pytest.raises(carom.InvalidArgument, match="hits must be those"):
            past.note(bad)
    past.note(world.step(STEP))
