"""The descriptors of what is there make it again as it stands."""

from typing import Any

import pytest

import carom
from tests.unit.scene.everything import world_of_everything


def test_a_scene_holds_the_state_of_a_world_that_has_moved() -> None:
    world = world_of_everything()
    world.run(1.0)
    scene = carom.Scene.from_world(world)
    twin = scene.build()
    assert scene.shapes[5].orientation == pytest.approx(0.5, abs=1e-12)
    assert (scene.shapes[7].orientation, scene.shapes[7].angular_velocity) == (0.75, 0.0)
    for shape, other in zip(world.shapes, twin.shapes, strict=True):
        if not isinstance(shape, carom.Group):
            assert other.orientation == shape.orientation
            assert other.pivot == pytest.approx(shape.pivot, abs=1e-12)
        assert tuple(other.aabb) == pytest.approx(tuple(shape.aabb), abs=1e-12)
    for ball, other in zip(world.balls, twin.balls, strict=True):
        assert (other.position, other.velocity) == (ball.position, ball.velocity)
    assert carom.Scene.from_world(twin) == scene


def test_a_shape_that_has_turned_remembers_where_it_began() -> None:
    world = carom.World()
    hand = world.add(carom.Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0)))
    hand.rotate((0, 0), 1.0)
    twin = carom.Scene.from_world(world).build().shapes[0]
    assert (twin.p0, twin.p1) == (hand.p0, hand.p1)
    twin.reset()
    assert (twin.p0, twin.p1) == ((0.0, 0.0), (2.0, 0.0))


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_under_way_rests_where_it_is(detection: Any) -> None:
    world = carom.World(detection=detection)
    bat = world.add(carom.Segment((0, 0), (1, 0), motion="kinematic"))
    mill = world.add(carom.Compound([carom.Segment((0, 5), (1, 5))], pivot=(0, 5)))
    free = world.add(carom.Compound([carom.Segment((0, 9), (1, 9))], pivot=(0, 9), velocity=(1, 0)))
    bat.move_to((4, 0), 1.0, orientation=1.0)
    mill.move_to((4, 5), 1.0, orientation=1.0)
    world.run(0.5)
    there = [(mover.pivot, mover.orientation) for mover in (bat, mill)]
    assert mill.velocity != (0.0, 0.0)
    twin = carom.Scene.from_world(world).build()
    twin.run(1.0)
    assert [(mover.pivot, mover.orientation) for mover in twin.shapes[:2]] == there
    assert twin.shapes[2].pivot[0] == pytest.approx(free.pivot[0] + 1.0)


@pytest.mark.parametrize("thing", [None, 3, carom.Ball((0, 0), 1), carom.Scene()])
def test_from_world_wants_a_world(thing: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"^world must be a World, not "):
        carom.Scene.from_world(thing)
