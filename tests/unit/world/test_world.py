"""What a world holds: shapes, balls and compounds that are live views of their rows, and what may be added."""

import pytest

import carom
from tests.worlds import crowded, named, quiet


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
    # Where they have left, and only just.
    assert [ball.position for ball in world.strays] == [pytest.approx((11, y), abs=1e-8) for y in (5, 8)]
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
