"""The members of a world: what comes back, the ids, the parts of compounds, and what may not come in."""

import inspect

import numpy as np
import pytest

import carom
from carom.typing import Detection
from carom.world.settings import SETTINGS


def test_what_is_added_comes_back_and_is_in_the_world() -> None:
    world = carom.World()
    wall, ball = carom.Segment((0, 0), (1, 0)), carom.Ball((0, 1), 0.5)
    mill = carom.Compound([carom.Point((1, 1))], pivot=(0, 0))
    assert world.add(wall) is wall
    assert world.add(ball) is ball
    assert world.add(mill) is mill
    assert list(world.shapes) == [wall, mill]
    assert list(world.balls) == [ball]
    assert wall.world is ball.world is mill.world is mill.shapes[0].world is world


def test_entering_a_world_changes_nothing_but_the_id() -> None:
    shapes = [
        carom.Point((1, 2), kick=3.0),
        carom.Gate((0, 0), (3, 4), layer=5),
        carom.Arc((1, 1), 2, 1.0, 4.0, motion="kinematic", angular_velocity=2.0, turn_limits=(-1, 1)),
        carom.Ball((1, 2), 3, (4, 5), 6, elasticity=0.5, sensor=True),
    ]
    world = carom.World()
    for shape in shapes:
        before = shape._row.copy()
        world.add(shape)
        before["id"] = shape.id
        assert shape._row.tobytes() == before.tobytes()


def test_ids_ascend_in_the_order_of_adding_and_are_never_used_twice() -> None:
    world = carom.World()
    first = world.add(carom.Point((0, 0)))
    many = world.add_balls([(1, 1), (2, 2)], radius=0.1)
    last = world.add(carom.Ball((3, 3), 0.1))
    used = [first.id, *many.tolist(), last.id]
    assert used == sorted(set(used))
    world.remove(last)
    world.remove(first)
    assert world.add(last).id not in used
    assert last.id == max(used) + 1


def test_adding_twice_is_refused() -> None:
    world, other = carom.World(), carom.World()
    shape = world.add(carom.Point((0, 0)))
    mill = world.add(carom.Compound([carom.Point((1, 1))], pivot=(0, 0)))
    before = world.digest()
    for thing in (shape, mill, mill.shapes[0], mill.center_point):
        for target in (world, other):
            with pytest.raises(carom.InvalidArgument, match="in a world already"):
                target.add(thing)
    assert world.digest() == before
    assert other.digest() == carom.World().digest()


def test_a_part_is_not_added_without_its_compound() -> None:
    part = carom.Point((1, 1))
    mill = carom.Compound([part], pivot=(0, 0))
    with pytest.raises(carom.InvalidArgument, match="part of a compound"):
        carom.World().add(part)
    assert part.world is mill.world is None


def test_a_part_that_a_compound_gets_later_is_in_its_world_at_once() -> None:
    world = carom.World()
    mill = world.add(carom.Compound([], pivot=(0, 0), angular_velocity=1.0))
    part = mill.add(carom.Segment((1, 0), (2, 0)))
    assert part.world is world
    assert list(world.shapes) == [mill]
    world.step(0.5)
    assert part.orientation == pytest.approx(0.5)


def test_a_shape_of_the_world_that_becomes_a_part_is_listed_no_more() -> None:
    world = carom.World()
    mill = world.add(carom.Compound([], pivot=(0, 0)))
    shape = world.add(carom.Point((1, 0)))
    mill.add(shape)
    assert list(world.shapes) == [mill]
    assert shape not in world.shapes
    twin = carom.World()
    twin.restore(world.snapshot())
    assert [part.kind for compound in twin.shapes for part in compound.shapes] == ["point"]
    world.remove(mill)
    assert len(world.shapes) == 0
    assert carom.World().restore(world.snapshot()) is None


def test_objects_are_found_by_id_and_are_always_the_same() -> None:
    world = carom.World()
    wall, ball = world.add(carom.Segment((0, 0), (1, 0))), world.add(carom.Ball((0, 1), 0.5))
    (other,) = world.add_balls([(3, 3)], radius=0.5)
    assert world.object(wall.id) is wall
    assert world.object(ball.id) is ball
    made = world.object(int(other))
    assert isinstance(made, carom.Ball)
    assert made is world.object(other) is world.balls[1]
    for unknown in (0, 4, 2**62):
        with pytest.raises(carom.InvalidArgument, match=str(unknown)):
            world.object(unknown)


def test_balls_are_added_all_at_once_from_arrays_rows_and_numbers() -> None:
    world = carom.World()
    ids = world.add_balls(np.array([[0, 0], [1, 2]]), velocity=[(1, 2), (3, 4)], radius=[0.1, 0.2], mass=2)
    more = world.add_balls([(5, 5), (6, 6), (7, 7)], velocity=(9, 9), radius=0.3, elasticity=0.5)
    assert ids.tolist() + more.tolist() == world.balls.id.tolist()
    assert world.balls.position.tolist() == [[0, 0], [1, 2], [5, 5], [6, 6], [7, 7]]
    assert world.balls.velocity.tolist() == [[1, 2], [3, 4], [9, 9], [9, 9], [9, 9]]
    assert world.balls.radius.tolist() == [0.1, 0.2, 0.3, 0.3, 0.3]
    assert world.balls.mass.tolist() == [2, 2, 1, 1, 1]
    assert [ball.elasticity for ball in world.balls] == [1, 1, 0.5, 0.5, 0.5]
    assert world.add_balls(np.zeros((0, 2)), radius=1.0).tolist() == []


def test_balls_from_arrays_are_the_same_as_balls_one_by_one() -> None:
    one, many = carom.World(), carom.World()
    places = [(0.0, 0.0), (3.0, 1.0)]
    for place in places:
        one.add(carom.Ball(place, 0.5, (1, 0), 2.0, elasticity=0.9))
    many.add_balls(places, (1, 0), 0.5, 2.0, 0.9)
    assert one.digest() == many.digest()


def test_balls_that_are_refused_use_no_ids() -> None:
    world = carom.World()
    with pytest.raises(carom.InvalidArgument, match=r"position\[1, 0\] must be finite, not nan"):
        world.add_balls([(0, 0), (float("nan"), 0)], radius=1)
    with pytest.raises(carom.InvalidArgument, match=r"radius\[2\] must be positive, not -1.0"):
        world.add_balls(np.zeros((3, 2)), radius=[1, 1, -1])
    with pytest.raises(carom.InvalidArgument, match=r"position\[1\] must leave the ball's box finite"):
        world.add_balls([(0, 0), (1e308, 0)], radius=1e308)
    assert world.digest() == carom.World().digest()


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_set_to_what_it_is_was_not_changed(detection: Detection) -> None:
    members = [
        carom.Point((1, 2)),
        carom.Segment((3, 4), (5, 4), motion="kinematic", turn_limits=(-1, 1)),
        carom.Gate((6, 7), (8, 7), direction=(0, 1)),
        carom.Circle((10, 10), 1, elasticity=0.5, kick=2.0),
        carom.Arc((20, 10), 2, 0.5, 2.5, sensor=True),
        carom.Compound([carom.Segment((30, 1), (31, 1)), carom.Point((32, 0))], (30, 1)),
        carom.Group([carom.Segment((40, 1), (41, 1))], once=True),
        carom.Ball((50, 1), 0.5, velocity=(0, 1), mass=2, friction=0.25),
    ]
    world = carom.World(detection=detection, friction=0.5)
    world.add(*members)
    world.step(0.125)
    rows, count = world._arrays.shapes.used.tobytes() + world._arrays.balls.used.tobytes(), 0
    for thing in (world, *members):
        for name, attribute in inspect.getmembers(type(thing)):
            if getattr(attribute, "fset", None) is not None or name in SETTINGS:
                setattr(thing, name, getattr(thing, name))
                assert world._will_wake() == 0, (thing, name)
                count += 1
    assert world._arrays.shapes.used.tobytes() + world._arrays.balls.used.tobytes() == rows
    assert detection == "discrete" or (world._arrays.flights["id"][:1] > 0).all()
    assert count > 120
