"""What is carried out of the memory comes back the same, whichever balls are in play."""

import numpy as np
import pytest

import carom
from carom.world.kernels.copies.carrying import carry_words
from tests.worlds import game_table, world_of


def test_words_go_there_and_back() -> None:
    memory, table = np.arange(10), np.zeros(4, int)
    carry_words(memory, 3, table, 1, 2, True)
    assert table.tolist() == [0, 3, 4, 0]
    table[1:3] = 30, 40
    carry_words(memory, 3, table, 1, 2, False)
    assert memory.tolist() == [0, 1, 2, 30, 40, 5, 6, 7, 8, 9]


def test_balls_that_are_not_in_play_are_left_out_and_left_alone() -> None:
    worlds = carom.Worlds(game_table("continuous"), 2, threads=1)
    worlds.balls.in_play[1, 1] = False
    worlds.step(0.01)
    rest = worlds.balls.position[1, 1].copy()
    stage = worlds._stages[0]
    stage.take(1)
    assert stage.arrays.balls.used["id"].tolist() == worlds.balls.id[[0, 2]].tolist()
    stage.arrays.balls.used["x"] += 1.0
    before = worlds.balls.position[1].copy()
    assert stage.put(1)
    assert (worlds.balls.position[1] - before)[:, 0].tolist() == [1.0, 0.0, 1.0]
    assert worlds.balls.position[1, 1].tolist() == rest.tolist()


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_stands_elsewhere_in_each_copy_is_met_there(detection: carom.typing.Detection) -> None:
    paddle = carom.Segment((-1, 0), (1, 0), motion="kinematic", name="paddle")
    world = world_of(paddle, carom.Ball((0, 2), 0.1, (0, -1)), carom.Ball((50, 2), 0.1, (0, -1)), detection=detection)
    worlds = carom.Worlds(world, 3, threads=1)
    places = np.array([(0.0, 0.0), (50.0, 0.5), (0.0, -0.5)])
    worlds.shapes["paddle"].position = places
    worlds.step(0.01)
    hits = worlds.run(3.0, 0.01)
    assert hits["world"].tolist() == [0, 1, 2]
    for hit, (x, y) in zip(hits, places.tolist(), strict=True):
        assert hit.ball.id == worlds.balls.id[int(x > 0.0)]
        assert hit.point == pytest.approx((x, y), abs=0.02)


def test_what_is_gone_in_one_copy_is_there_in_the_next() -> None:
    target = carom.Segment((-1, 0), (1, 0), once=True)
    worlds = carom.Worlds(world_of(target, carom.Ball((0, 1), 0.1, (0, -1))), 3, threads=1)
    worlds.balls.velocity[1] = 0.0
    assert worlds.run(2.0)["world"].tolist() == [0, 2]
    worlds.balls.velocity[:, 0] = (0.0, -4.0)
    assert worlds.run(2.0)["world"].tolist() == [1]
    assert worlds.balls.position[0, 0, 1] < 0.0


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_each_ball_leaves_what_it_was_in_there(detection: carom.typing.Detection) -> None:
    sensors = [carom.Circle((x, 0), 1.0, sensor=True, solid=True, name=str(x)) for x in (0, 10, 20)]
    worlds = carom.Worlds(world_of(*sensors, carom.Ball((0, 0), 0.1), detection=detection), 3, threads=1)
    worlds.balls.position[:, 0, 0] = (20.0, 0.0, 10.0)
    entered = worlds.step(0.1)
    worlds.balls.velocity[:, 0] = (0.0, 3.0)
    left = worlds.run(1.0, 0.1)
    for hits, kind in ((entered, carom.HitKind.ENTER), (left, carom.HitKind.EXIT)):
        assert [(hit.world, hit.kind, hit.shape.name) for hit in hits] == [
            (0, kind, "20"),
            (1, kind, "0"),
            (2, kind, "10"),
        ]
