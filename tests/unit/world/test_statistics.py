"""Counters of what a world has done."""

import inspect

import carom
from carom.world.statistics import COUNTERS, Statistics
from tests.worlds import crowded, quiet


def test_every_counter_is_an_attribute_and_in_the_dictionary() -> None:
    properties = [name for name, value in vars(Statistics).items() if isinstance(value, property)]
    # What no ball does any more is no counter; its name stays for a while.
    properties.remove("stalled")
    assert tuple(properties) == COUNTERS
    assert carom.World().statistics.stalled == 0
    statistics = carom.World().statistics
    assert statistics.as_dict() == dict.fromkeys(COUNTERS, 0)
    assert all(getattr(statistics, name) == 0 and inspect.getdoc(getattr(Statistics, name)) for name in COUNTERS)


def test_collisions_are_bounces() -> None:
    world = crowded()
    hits = world.run(2.0)
    assert world.statistics.collisions == (hits["kind"] == carom.HitKind.BOUNCE).sum() > 0
    assert world.statistics.box_tests > world.statistics.full_tests > world.statistics.collisions


def test_statistics_are_live_and_can_be_reset() -> None:
    world = quiet()
    statistics = world.statistics
    world.run(1.0)
    assert statistics.collisions == 1
    statistics.reset()
    assert world.statistics.as_dict() == dict.fromkeys(COUNTERS, 0)
    world.run(0.1)
    assert statistics.collisions == 0
    assert statistics.box_tests > 0
    assert repr(statistics).startswith(f"Statistics(box_tests={statistics.box_tests}, ")


def test_a_reset_forgets_no_sleeper() -> None:
    world = carom.World(sleep_speed=1.0, sleep_time=0.1)
    ball = world.add(carom.Ball((0, 0), 1))
    world.run(0.5)
    world.statistics.reset()
    assert world.statistics.sleeping == 1
    assert ball.asleep
    ball.velocity = (3, 0)
    world.step(0.1)
    assert world.statistics.sleeping == 0


def test_balls_at_the_same_place_are_counted_and_parted() -> None:
    world = carom.World()
    world.add_balls([(0, 0), (0, 0)], radius=1.0)
    world.step(0.1)
    assert world.statistics.overlaps == 1
    (first, second) = world.balls.position.tolist()
    assert first != second


def test_balls_over_the_speed_limit_are_slowed_at_a_response_and_counted() -> None:
    world = carom.World(max_speed=2.0)
    world.add(carom.Segment((0, -5), (0, 5)))
    ball = world.add(carom.Ball((-3, 0), 1, (8, 0)))
    world.step(0.1)
    assert ball.velocity == (8, 0)
    world.run(1.0)
    assert ball.velocity == (-2, 0)
    assert world.statistics.slowed == 1


def test_counting_needs_no_wake() -> None:
    world = carom.World(sleep_speed=1.0, sleep_time=0.1)
    world.add(carom.Ball((0, 0), 1))
    world.run(0.5)
    world.statistics.reset()
    world.step(0.1)
    assert world.statistics.sleeping == 1
