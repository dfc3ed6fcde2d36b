"""`worlds.shapes`: found by name and index, told how to move, switched and counted."""

from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import game_table, world_of


def test_by_index_and_by_name() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    shapes = worlds.shapes
    assert [shape.name for shape in shapes] == [shape.name for shape in game_table("discrete").shapes]
    assert shapes[-1].name == "platform"
    assert shapes["flipper"].kind == "compound"
    assert shapes["bumper"].kind == "circle"
    with pytest.raises(carom.InvalidArgument, match="did you mean flipper"):
        shapes["fliper"]
    with pytest.raises(IndexError):
        shapes[len(shapes)]


def test_what_is_static_is_shared() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    bumper = worlds.shapes["bumper"]
    assert bumper.position.tolist() == [[0.0, 0.8]] * 2
    for name, value in (("position", (0, 0)), ("angular_velocity", 1.0), ("velocity", (1, 0)), ("orientation", 1.0)):
        with pytest.raises(carom.InvalidArgument, match=f"{name} must be that of a kinematic shape"):
            setattr(bumper, name, value)


def test_bad_commands_change_nothing() -> None:
    worlds = carom.Worlds(game_table("discrete"), 3, threads=1)
    before = worlds.digests()
    flipper = worlds.shapes["flipper"]
    wrong = [
        ("angular_velocity", [1.0, 2.0]),
        ("angular_velocity", np.nan),
        ("velocity", [1.0, 2.0, 3.0]),
        ("orientation", [0, 0, 9.0]),
    ]
    wrong += [("can_collide", 1), ("can_collide", [True, False]), ("position", [[0, 0], [0, 0], [np.inf, 0]])]
    for name, value in wrong:
        with pytest.raises(carom.InvalidArgument, match=name):
            setattr(flipper, name, value)
    assert worlds.digests() == before


def test_parts_that_came_later_turn_with_the_others() -> None:
    late, other = carom.Point((5, 0)), carom.Segment((9, 9), (9, 8), motion="kinematic", name="other")
    world = world_of(late)
    whole = world.add(carom.Compound([], pivot=(0, 0), name="whole"))
    whole.add(late)
    world.add(other)
    whole.add(carom.Point((6, 0)))
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.shapes["whole"].angular_velocity = (1.0, 2.0)
    whole.angular_velocity = 2.0
    worlds.step(0.5)
    world.step(0.5)
    assert worlds.digests()[1] == world.digest()
    assert worlds.shapes["other"].orientation.tolist() == [0.0, 0.0]


def test_a_group_is_one_thing() -> None:
    brick = carom.Group(carom.outlines.rectangle(0, 0, 2, 1), once=True, name="brick")
    world = world_of(brick, carom.Ball((1, -1), 0.25, (0, 4)))
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.balls.velocity[0] = 0.0
    worlds.run(1.0)
    wall = worlds.shapes["brick"]
    assert (wall.kind, wall.can_collide.tolist(), wall.bounces.tolist()) == ("group", [True, False], [0, 1])
    assert wall.position.tolist() == [[1.0, 0.5]] * 2
    wall.can_collide = [False, True]
    assert wall.can_collide.tolist() == [False, True]


def test_what_was_sent_somewhere_rests_when_it_is_told_to_turn() -> None:
    world = world_of(carom.Segment((0, 0), (1, 0), motion="kinematic", name="paddle"))
    world.shapes[0].move_to((5, 5), dt=1.0)
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.shapes["paddle"].angular_velocity = 2.0
    assert worlds.shapes["paddle"].velocity.tolist() == [[0.0, 0.0]] * 2
    worlds.step(0.5)
    assert worlds.shapes["paddle"].orientation.tolist() == [1.0, 1.0]
    assert worlds.shapes["paddle"].position.tolist() == [[0.5, 0.0]] * 2


def test_one_that_was_sent_somewhere_comes_with_a_world_that_is_loaded() -> None:
    world = world_of(carom.Segment((0, 0), (1, 0), motion="kinematic"))
    worlds = carom.Worlds(world, 2, threads=1)
    world.shapes[0].move_to((5, 5), dt=1.0)
    worlds.load(1, world)
    lone = worlds[1]
    worlds.shapes[0].angular_velocity = lone.shapes[0].angular_velocity = 1.0
    for _ in range(3):
        worlds.step(0.1)
        lone.step(0.1)
    assert worlds.digests()[1] == lone.digest()


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_all_parts_of_a_compound_go_with_what_is_commanded(detection: carom.typing.Detection) -> None:
    arms = [carom.Segment((0, 0), (3, 1)), carom.Arc((0, 0), 3, 1, 2), carom.Segment((0, 0), (-3, 1))]
    wall = carom.Segment((20, 0), (20, 1), motion="kinematic", velocity=(0, 1))
    wheel = carom.Compound(arms, pivot=(0, 0), name="wheel")
    world = world_of(wall, wheel, carom.Ball((0.0, 2.0), 0.2), gravity=(0, -9), detection=detection)
    worlds = carom.Worlds(world, 3, threads=1)
    lone = worlds[2]
    for speed, (x, y) in ((4.0, (1.0, 0.5)), (-3.0, (0.0, 0.0)), (0.0, (-0.5, 0.0))):
        lone = worlds[2]
        turned: Any = lone.shapes["wheel"]
        for each in (worlds.shapes["wheel"], turned):
            each.angular_velocity = speed
            each.velocity = (x, y)
        assert worlds.digests()[2] == lone.digest()
        assert [part.angular_velocity for part in turned.shapes] == [speed] * len(wheel.shapes)
        worlds.run(0.5)
        lone.run(0.5)
        assert worlds.digests()[2] == lone.digest()
    worlds.shapes["wheel"].position = lone.shapes["wheel"].position = (1, 1)
    assert worlds.digests()[2] == lone.digest()
