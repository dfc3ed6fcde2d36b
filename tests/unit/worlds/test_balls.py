"""`worlds.balls`: views of all copies that act at once."""

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
