"""What a world holds: shapes, balls and compounds that are live views of their rows, and what may be added."""

import numpy as np
import pytest

import carom
from tests.worlds import crowded, named, quiet


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


def test_attributes_act_at_once() -> None:
    world = quiet()
    wall, down = named(world, "wall"), named(world, "down")
    wall.can_collide = False
    world.run(2.0)
    assert down.position[1] < -1.0
    down.position, down.velocity = (0.0, -1.0), (0.0, 3.0)
    wall.can_collide = True
    world.run(1.0)
    assert down.velocity == (0.0, -3.0)


def test_a_kinematic_shape_obeys_from_the_next_step() -> None:
    world = carom.World(substeps=1)
    flipper = world.add(carom.Segment((0, 0), (1, 0), motion="kinematic", pivot=(0, 0)))
    world.step(0.5)
    assert flipper.orientation == 0.0
    flipper.angular_velocity = 1.0
    world.step(0.5)
    assert flipper.orientation == 0.5
    flipper.reset()
    assert flipper.orientation == 0.0
    flipper.motion = "kinematic"
    flipper.rotating = False
    world.step(0.5)
    assert flipper.orientation == 0.0


def test_a_shape_that_becomes_kinematic_moves_and_one_that_moved_is_met_where_it_is() -> None:
    world = carom.World()
    shape = world.add(carom.Point((0, 0)))
    ball = world.add(carom.Ball((10, 0), 0.5, (-1, 0)))
    world.step(0.1)
    shape.motion = "kinematic"
    shape.velocity = (1.0, 0.0)
    (hit,) = world.run(10.0)
    assert hit.shape is shape
    assert hit.point[0] == pytest.approx(5, abs=1)
    shape.position = (100.0, 0.0)
    shape.velocity = (0.0, 0.0)
    ball.position, ball.velocity = (98.0, 0.0), (2.0, 0.0)
    (hit,) = world.run(1.0)
    assert hit.shape is shape


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


def test_time_is_the_sum_of_the_steps() -> None:
    world = carom.World()
    assert world.time == 0.0
    world.step(0.25)
    world.step(0.0)
    world.run(1.0, dt=0.125)
    assert world.time == 1.25


def test_a_world_without_anything_steps() -> None:
    world = carom.World()
    assert len(world.step(0.1)) == 0
    assert len(world.run(1.0)) == 0


def test_a_world_says_what_is_in_it() -> None:
    world = crowded(balls=2)
    assert repr(world) == f"<World at 0 s: {len(world.shapes)} shapes, 2 balls>"
    assert repr(world.shapes) == f"<{len(world.shapes)} shapes>"
    assert repr(world.balls) == "<2 balls>"


def test_strays_are_counted_once_and_listed_while_they_are_outside() -> None:
    world = carom.World(bounds=(0, 0, 10, 10))
    inside = world.add(carom.Ball((5, 5), 1))
    stray = world.add(carom.Ball((8, 5), 1, (3, 0)))
    assert world.strays == []
    world.step(1.0)
    assert world.strays == []  # its box still touches the bounds
    world.step(0.5)
    world.step(0.5)
    assert world.strays == [stray]
    assert world.statistics.strays == 1
    stray.velocity = (-3, 0)
    world.step(1.5)
    assert world.strays == []
    stray.velocity = (3, 0)
    world.step(2.0)
    assert world.strays == [stray]
    assert world.statistics.strays == 2
    assert inside in world.balls


def test_without_bounds_there_are_no_strays() -> None:
    world = carom.World(bounds=(0, 0, 10, 10))
    ball = world.add(carom.Ball((20, 20), 1))
    world.step(0.1)
    assert world.strays == [ball]
    world.bounds = None
    assert world.strays == []
    world.step(0.1)
    world.bounds = (0, 0, 10, 10)
    assert world.strays == []
    world.step(0.1)
    assert world.strays == [ball]
    assert world.statistics.strays == 2


def test_strays_are_removed_where_that_is_wanted_and_listed_until_the_next_step() -> None:
    world = carom.World(bounds=(0, 0, 10, 10), remove_strays=True)
    stay, stray = world.add(carom.Ball((5, 5), 1)), world.add(carom.Ball((8, 5), 1, (9, 0), name="gone"))
    world.add_balls([(8, 8)], (9, 0), 1)
    world.step(1.0)
    assert list(world.balls) == [stay]
    assert world.strays[0] is stray
    assert stray.world is None
    assert [ball.position for ball in world.strays] == [(17.0, 5.0), (17.0, 8.0)]
    assert world.strays[1] is world.strays[1]
    assert world.statistics.strays == 2
    world.step(1.0)
    assert world.strays == []


def test_a_run_lists_all_strays_that_it_removed() -> None:
    world = carom.World(bounds=(0, 0, 10, 10), remove_strays=True)
    world.add_balls([(9, 1), (7, 2), (5, 3), (3, 4)], (4, 0), 0.5)
    world.run(20.0)
    assert [ball.position[1] for ball in world.strays] == [1, 2, 3, 4]
    assert len(world.balls) == 0


def test_a_stray_that_is_there_already_is_removed_once_that_is_wanted() -> None:
    world = carom.World(bounds=(0, 0, 10, 10))
    stray = world.add(carom.Ball((20, 5), 1))
    world.step(0.1)
    world.remove_strays = True
    world.step(0.1)
    assert stray.world is None
    assert world.statistics.strays == 1


def test_a_stray_can_be_added_again() -> None:
    world = carom.World(bounds=(0, 0, 10, 10), remove_strays=True)
    world.add(carom.Circle((20, 5), 3, sensor=True, solid=True))
    world.add_balls([(9, 5)], (9, 0), 1)
    world.run(1.0)
    (stray,) = world.strays
    stray.position, stray.velocity = (5, 5), (0, 0)
    world.add(stray)
    world.run(1.0)
    assert stray.world is world
    assert stray.position == (5, 5)
    assert world.strays == []
