"""Whether a step begins with waking all balls."""

import pytest

import carom
from carom.world.waking import will_wake
from tests.worlds import world_of


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_was_put_elsewhere_wakes_only_where_something_sleeps(detection: str) -> None:
    world = world_of(carom.Ball((0, 0), 1.0), detection=detection, sleep_speed=0.1, sleep_time=0.1)
    world.run(0.05)
    assert not will_wake(world._arrays)
    world.balls.position[0] = (1.0, 0.0)
    assert not will_wake(world._arrays)
    world.run(1.0)
    assert world.balls.asleep.all()
    assert not will_wake(world._arrays)
    world.balls.position[0] = (0.0, 0.0)
    assert will_wake(world._arrays)
