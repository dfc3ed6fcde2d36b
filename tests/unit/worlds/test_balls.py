"""`worlds.balls`: views of all copies that act at once."""

from collections.abc import Callable

import numpy as np
import pytest

import carom
from tests.worlds import game_table

COLUMNS = ("radius", "mass", "elasticity", "friction", "layer", "collides_with", "sensor", "can_collide")


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_written_acts_as_in_a_single_world(detection: str) -> None:
    new = {"radius": 0.1, "mass": 3.0, "elasticity": 0.2, "friction": 0.5, "layer": 2, "collides_with": 1}
    for name in COLUMNS:
        world = game_table(detection)
        worlds = carom.Worlds(world, 2, threads=1)
        for each in (world, worlds):
            each.run(0.1, 1 / 50)
        getattr(world.balls, name)[1] = new.get(name, name == "sensor")
        getattr(worlds.balls, name)[1, 1] = new.get(name, name == "sensor")
        for each in (world, worlds):
            each.run(0.3, 1 / 50)
        assert worlds.digests()[1] == world.digest(), name
        assert worlds.digests()[0] != world.digest(), name


def asleep_table(detection: str) -> carom.World:
    """A table on which balls sleep."""
    world = game_table(detection)
    world.gravity, world.sleep_speed, world.sleep_time = (0, -10), 100.0, 0.01
    world.run(0.1, 1 / 50)
    assert world.balls.asleep.any()
    return world


def fail_to_restore(worlds: carom.Worlds) -> None:
    """Give back a snapshot of other copies, which is refused."""
    with pytest.raises(carom.SnapshotError):
        worlds.restore(carom.Worlds(carom.World(), 2).snapshot())


#: What may be done to all copies, or to the one with the number 0, and changes nothing of the other.
MEANWHILE: dict[str, Callable[[carom.Worlds], object]] = {
    "reset by index": lambda worlds: worlds.reset([0]),
    "reset by mask": lambda worlds: worlds.reset(np.array([True, False])),
    "load": lambda worlds: worlds.load(0, worlds[0]),
    "get": lambda worlds: worlds[0],
    "store": lambda worlds: worlds.store(0, carom.World()),
    "digests": lambda worlds: worlds.digests(),
    "snapshot": lambda worlds: worlds.snapshot(),
    "restore": lambda worlds: worlds.restore(worlds.snapshot()),
    "fail to restore": fail_to_restore,
}


@pytest.mark.parametrize("meanwhile", MEANWHILE)
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_written_to_a_copy_is_seen_whatever_is_done_to_another_one_before_the_next_step(
    detection: str, meanwhile: str
) -> None:
    new = {"radius": 0.1, "mass": 3.0, "elasticity": 0.2, "friction": 0.5, "layer": 2, "collides_with": 1}
    for name in COLUMNS:
        start = asleep_table(detection)
        worlds = carom.Worlds(start, 2, threads=1)
        getattr(start.balls, name)[1] = new.get(name, name == "sensor")
        getattr(worlds.balls, name)[1, 1] = new.get(name, name == "sensor")
        MEANWHILE[meanwhile](worlds)
        assert worlds.digests()[1] == start.digest(), name
        for each in (start, worlds):
            each.step(1 / 50)
        assert worlds.digests()[1] == start.digest(), name


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_written_and_written_back_before_a_step_was_never_there_in_a_world_or_a_copy(detection: str) -> None:
    world, untouched = (asleep_table(detection) for _ in range(2))
    worlds = carom.Worlds(world, 2, threads=1)
    for name in COLUMNS:
        for balls, ball in ((world.balls, 1), (worlds.balls, (0, 1))):
            before = getattr(balls, name)[ball]
            getattr(balls, name)[ball] = not before
            getattr(balls, name)[ball] = before
    for each in (world, worlds, untouched):
        each.step(1 / 50)
    assert [world.digest(), *worlds.digests()] == [untouched.digest()] * 3


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_a_copy_that_was_written_to_is_put_back_to_the_bit(detection: str) -> None:
    start = asleep_table(detection)
    worlds = carom.Worlds(start, 2, threads=1)
    worlds.balls.radius[1, 1] = 0.1
    worlds.reset([1])
    assert worlds.digests() == [start.digest()] * 2
    worlds.step(1 / 50)
    assert worlds.balls.asleep.any(axis=1).all()


def test_shapes_and_what_cannot_be_written() -> None:
    worlds = carom.Worlds(game_table("discrete"), 4, threads=1)
    balls = worlds.balls
    assert len(balls) == 3
    assert balls.position.shape == balls.velocity.shape == (4, 3, 2)
    assert {getattr(balls, name).shape for name in (*COLUMNS, "in_play", "asleep")} == {(4, 3)}
    assert np.shares_memory(balls.position, worlds.balls.position)
    assert balls.id.tolist() == worlds[0].balls.id.tolist()
    with pytest.raises(ValueError, match="read-only"):
        balls.asleep[0] = True
    assert repr(balls) == "<3 balls in each of 4 worlds>"
