"""Whether a step begins with waking all balls."""

import numpy as np
import pytest

import carom
from carom.rows.state import CHANGED, MOTIONS_CHANGED, STATE
from carom.world.waking import note_changed, will_wake
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
    assert will_wake(world._arrays) == CHANGED


def test_what_changes_no_motion_is_told_from_what_may() -> None:
    mill = carom.Segment((0, 0), (1, 0), motion="kinematic")
    world = world_of(mill, carom.Circle((5, 0), 1.0), carom.Ball((0, 3), 1.0))
    world.step(0.1)
    wall = carom.Point((9, 9))
    for change in (lambda: world.add(wall), lambda: setattr(wall, "layer", 2), lambda: world.remove(wall)):
        change()
        assert world._will_wake() == CHANGED
        world.step(0.1)
        assert world._will_wake() == 0
    changes = [lambda: setattr(mill, "velocity", (1, 0)), lambda: setattr(mill, "position", (0, 1))]
    changes += [lambda: setattr(world, "friction", 0.1), lambda: setattr(wall, "motion", "kinematic")]
    world.add(wall)
    for change in changes:
        change()
        wall.layer = 1
        assert world._will_wake() == MOTIONS_CHANGED
        assert carom.World().restore(world.snapshot()) is None
        world.step(0.1)


def test_states_of_many_worlds_are_told_of_changes() -> None:
    states = np.zeros(4, STATE)
    states["wake"] = 0, 0, MOTIONS_CHANGED, 0
    note_changed(states, np.array([True, False, True, False]))
    assert states["wake"].tolist() == [CHANGED, 0, MOTIONS_CHANGED, 0]
