"""`worlds.shapes`: found by name and index, told how to move, switched and counted."""

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
    with pytest.raises(carom.InvalidArgument, match="index must be"):
        shapes[len(shapes)]
    twice = carom.Worlds(world_of(carom.Point((0, 0), name="a"), carom.Point((1, 0), name="a")), 1)
    with pytest.raises(carom.InvalidArgument, match="must be that of one shape, not of 2"):
        twice.shapes["a"]


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


def test_a_part_is_moved_by_its_compound_alone() -> None:
    part = carom.Segment((0, 0), (1, 0), name="part")
    worlds = carom.Worlds(world_of(carom.Compound([part], pivot=(0, 0), name="whole")), 2, threads=1)
    with pytest.raises(carom.InvalidArgument, match="must be left to the compound"):
        worlds.shapes["part"].angular_velocity = 1.0
    worlds.shapes["part"].can_collide = [True, False]
    assert worlds.shapes["whole"].can_collide.tolist() == [True, False]
    with pytest.raises(carom.InvalidArgument, match="counted for the compound"):
        _ = worlds.shapes["part"].bounces


def test_what_was_sent_somewhere_rests_when_it_is_told_to_turn() -> None:
    world = world_of(carom.Segment((0, 0), (1, 0), motion="kinematic", name="paddle"))
    world.shapes[0].move_to((5, 5), dt=1.0)
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.shapes["paddle"].angular_velocity = 2.0
    assert worlds.shapes["paddle"].velocity.tolist() == [[0.0, 0.0]] * 2
    worlds.step(0.5)
    assert worlds.shapes["paddle"].orientation.tolist() == [1.0, 1.0]
    assert worlds.shapes["paddle"].position.tolist() == [[0.5, 0.0]] * 2
