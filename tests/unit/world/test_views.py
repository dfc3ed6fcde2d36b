"""`world.balls` and `world.shapes`: sequences of objects, and columns that are the world's own memory."""

import random
import sys

import numpy as np
import pytest

import carom
from tests.worlds import crowded, quiet

COLUMNS = {"position": "position", "velocity": "velocity", "radius": "radius", "mass": "mass"}


def filled(count: int = 3) -> carom.World:
    """A world of some balls that differ in everything."""
    world = carom.World()
    for n in range(count):
        world.add(carom.Ball((10 * n, n), 1 + n, (n, -n), 2 + n))
    return world


def test_balls_are_a_sequence_of_the_very_objects() -> None:
    world = carom.World()
    balls = [world.add(carom.Ball((n, 0), 0.1)) for n in range(4)]
    assert len(world.balls) == 4
    assert list(world.balls) == balls
    assert list(reversed(world.balls)) == balls[::-1]
    assert [world.balls[n] for n in range(-4, 4)] == balls * 2
    assert world.balls[1:3] == balls[1:3]
    assert world.balls[np.int64(2)] is balls[2]
    assert balls[2] in world.balls
    assert carom.Ball((2, 0), 0.1) not in world.balls
    assert carom.Point((0, 0)) not in world.balls
    assert world.balls.index(balls[3]) == 3
    for outside in (4, -5):
        with pytest.raises(IndexError):
            world.balls[outside]


def test_shapes_are_a_sequence_of_the_very_objects() -> None:
    world = carom.World()
    shapes = [world.add(carom.Point((n, 0))) for n in range(3)]
    mill = world.add(carom.Compound([carom.Point((1, 1))], pivot=(0, 0)))
    assert list(world.shapes) == [*shapes, mill]
    assert world.shapes[-1] is mill
    assert world.shapes[:2] == shapes[:2]
    assert len(world.shapes) == 4
    assert mill in world.shapes
    assert mill.shapes[0] not in world.shapes
    assert world.add(carom.Ball((9, 9), 1)) not in world.shapes
    with pytest.raises(IndexError):
        world.shapes[4]


def shape_of(number: int) -> carom.Shape | carom.Compound:
    """A shape, or every fifth time a compound."""
    point = carom.Point((number, 0))
    return carom.Compound([point], pivot=(0, 0)) if number % 5 == 0 else point


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_shapes_are_what_a_list_would_hold_whatever_comes_and_goes(seed: int) -> None:
    chance = random.Random(seed)
    world, listed, strangers = carom.World(), [], [carom.Point((0, 0)), carom.Compound([], pivot=(0, 0))]
    snapshots = []
    for number in range(150):
        deed = chance.choice(("add", "add", "add", "remove", "join", "snapshot", "restore", "look"))
        if deed == "add":
            new = [shape_of(number + place) for place in range(chance.choice((1, 1, 3)))]
            world.add(*new)
            listed += new
        elif deed == "remove" and listed:
            leaving = chance.sample(listed, chance.randint(1, len(listed)) if chance.random() < 0.2 else 1)
            world.remove(*leaving)
            listed = [shape for shape in listed if shape not in leaving]
            strangers += leaving
        elif deed == "join" and any(isinstance(shape, carom.Compound) for shape in listed):
            compound = chance.choice([shape for shape in listed if isinstance(shape, carom.Compound)])
            part = chance.choice([shape for shape in listed if isinstance(shape, carom.Shape)] or [carom.Point((1, 2))])
            compound.add(part)
            listed = [shape for shape in listed if shape is not part]
            strangers.append(part)
        elif deed == "snapshot":
            snapshots.append((world.snapshot(), [shape.id for shape in listed]))
        elif deed == "restore" and snapshots:
            snapshot, ids = chance.choice(snapshots)
            strangers += listed
            world.restore(snapshot)
            listed = list(world.shapes)
            assert [shape.id for shape in listed] == ids
            strangers = [shape for shape in strangers if not any(shape is other for other in listed)]
        elif deed == "look" and listed:
            place = chance.randrange(-len(listed), len(listed))
            assert world.shapes[place] is listed[place]
            assert world.shapes[place:] == listed[place:]
        assert len(world.shapes) == len(listed)
        if number % 10 == 0:
            assert list(world.shapes) == listed
            assert all(shape in world.shapes for shape in listed)
            assert not any(shape in world.shapes for shape in strangers)


def test_shapes_may_be_added_and_taken_out_while_they_are_walked() -> None:
    world = carom.World()
    points = [world.add(carom.Point((n, 0))) for n in range(4)]
    for shape in world.shapes:
        world.add(carom.Point((9, 9)))
        world.remove(shape)
    assert len(world.shapes) == 4
    assert not any(point in world.shapes for point in points)


@pytest.mark.parametrize("leaving", [1, 2, 63, 64, 65, 150])
def test_of_few_or_many_that_leave_together_the_others_stay_listed_in_their_order(leaving: int) -> None:
    world = carom.World()
    given: list[carom.Point | carom.Group] = []
    for n in range(100):
        point, group = carom.Point((n, 0)), carom.Group([carom.Point((n, 1)), carom.Point((n, 2))])
        given += world.add(group, point)
    assert list(world.shapes) == given
    chance = random.Random(leaving)
    gone = chance.sample(given, leaving)
    world.remove(*gone)
    given = [shape for shape in given if shape not in gone]
    assert [world.shapes[n] for n in range(-len(given), len(given))] == given * 2
    host = next(shape for shape in given if isinstance(shape, carom.Group))
    joining = next(shape for shape in given if isinstance(shape, carom.Point))
    host.add(joining)
    given.remove(joining)
    assert list(world.shapes) == given


def test_the_list_of_many_shapes_is_not_made_anew_for_one_that_leaves() -> None:
    world = carom.World()
    points = world.add(*(carom.Point((n, 0)) for n in range(10)))
    assert world.shapes[3] is points[3]
    listed = world._listed
    world.remove(points[3])
    assert world.shapes[3] is points[4]
    assert world._listed is listed


def test_places_of_balls_are_whole_numbers_within_their_count() -> None:
    balls = filled(3).balls
    assert [balls[np.int64(n)] for n in (-3, 0, 2)] == [balls[n] for n in (-3, 0, 2)]
    for beyond in (3, -4):
        with pytest.raises(IndexError, match=f"index {beyond} is out of bounds"):
            balls[beyond]


def test_finding_a_shape_or_a_ball_takes_no_more_work_among_many() -> None:
    def calls_among(count: int) -> int:
        world = carom.World()
        shapes = world.add(*(carom.Point((n, 0)) for n in range(count)))
        balls = world.add(*(carom.Ball((n, 0), 0.1) for n in range(count)))
        calls: list[str] = []
        for _ in range(2):  # the first time is for what is made once
            calls.clear()
            sys.setprofile(lambda _, event, about: calls.append(event) if "call" in event else None)
            try:
                found = world.shapes[count // 2], world.balls[count // 2], world.shapes[-1]
                inside = shapes[-1] in world.shapes, balls[-1] in world.balls, len(world.shapes)
            finally:
                sys.setprofile(None)
        assert found == (shapes[count // 2], balls[count // 2], shapes[-1])
        assert inside == (True, True, count)
        return len(calls)

    assert calls_among(1000) == calls_among(10)


@pytest.mark.parametrize("name", COLUMNS)
def test_columns_read_what_the_objects_say(name: str) -> None:
    world = filled()
    column = getattr(world.balls, name)
    assert column.dtype == np.float64
    assert column.shape == ((3, 2) if name in ("position", "velocity") else (3,))
    assert column.tolist() == [np.array(getattr(ball, name)).tolist() for ball in world.balls]


@pytest.mark.parametrize("name", COLUMNS)
def test_columns_are_the_worlds_own_memory_and_can_be_written_to(name: str) -> None:
    world = filled()
    column = getattr(world.balls, name)
    assert np.shares_memory(column, world._arrays.balls.rows)
    column[1] = 7.5
    value = getattr(world.balls[1], name)
    assert value == ((7.5, 7.5) if name in ("position", "velocity") else 7.5)
    setattr(world.balls[2], name, 3.25 if isinstance(value, float) else (3.25, 3.25))
    assert column[2].tolist() == np.full(column.shape[1:], 3.25).tolist()
    world.step(0.5)
    assert column.tolist() == getattr(world.balls, name).tolist()


def test_ids_can_be_read_alone() -> None:
    world = filled()
    assert world.balls.id.tolist() == [ball.id for ball in world.balls]
    assert np.shares_memory(world.balls.id, world._arrays.balls.rows)
    with pytest.raises(ValueError, match="read-only"):
        world.balls.id[0] = 9
    assert world.balls[0].position == (0, 0)


@pytest.mark.parametrize("name", [*COLUMNS, "id"])
def test_columns_of_no_balls_are_empty(name: str) -> None:
    for world in (carom.World(), filled(1)):
        for ball in list(world.balls):
            world.remove(ball)
        assert getattr(world.balls, name).shape[0] == 0


def test_columns_stay_valid_while_the_world_runs_and_shapes_come_and_go() -> None:
    world = crowded()
    position = world.balls.position
    world.run(0.5)
    shape = world.add(carom.Point((50, 50)))
    world.gravity = (0, -1)
    world.run(0.5)
    world.remove(shape)
    world.run(0.1)
    assert position.tolist() == [list(ball.position) for ball in world.balls]
    assert np.shares_memory(position, world.balls.position)


def test_writing_a_velocity_acts_in_the_next_step() -> None:
    world = filled()
    world.detection = "discrete"  # where each step rounds the place anew
    world.step(0.1)
    world.balls.velocity[:] = (0, 1)
    before = world.balls.position.copy()
    world.step(1.0)
    assert (world.balls.position - before).tolist() == [[0, 1]] * 3


@pytest.mark.parametrize("name", COLUMNS)
def test_writing_to_a_column_wakes_and_reading_it_does_not(name: str) -> None:
    world = filled()
    world.sleep_speed, world.sleep_time = 0.5, 0.1
    world.balls.velocity[:] = 0
    column = getattr(world.balls, name)
    world.run(1.0)
    assert world.statistics.sleeping == 3
    before = world.digest()
    column.copy(), getattr(world.balls, name)
    assert world.digest() == before
    world.step(0.001)
    assert world.statistics.sleeping == 3
    column[0] += 0.125
    world.step(0.001)
    assert world.statistics.sleeping == 0
    world.run(1.0)
    assert world.statistics.sleeping == 3


def test_a_radius_that_was_written_is_met_at_once() -> None:
    world = quiet()
    world.step(0.001)
    world.balls.radius[0] = 1.9
    (hit,) = world.run(0.1)
    assert hit.ball is world.balls[0]


@pytest.mark.parametrize(("name", "value"), [("radius", 0.0), ("radius", -1.0), ("mass", 0.0), ("mass", -2.0)])
def test_a_bad_size_that_was_written_is_refused_by_the_next_step(name: str, value: float) -> None:
    world = filled()
    getattr(world.balls, name)[1] = value
    before = world.digest()
    with pytest.raises(carom.InvalidArgument, match=rf"^{name} must be positive, not {value} as for balls 2$"):
        world.step(0.1)
    assert world.digest() == before
    getattr(world.balls, name)[1] = 1.0
    world.step(0.1)
    assert world.time == 0.1


def test_a_ball_is_found_by_its_name_the_first_that_bears_it() -> None:
    world = carom.World()
    (plain,) = world.add_balls([(9, 9)], radius=1.0)
    first, second = world.add(carom.Ball((0, 0), 1, name="red"), carom.Ball((3, 0), 1, name="red"))
    world.add(carom.Point((0, 5), name="post"))
    assert world.balls["red"] is first
    world.remove(first)
    assert world.balls["red"] is second
    world.object(int(plain)).name = "plain"
    assert world.balls["plain"] is world.balls[0]
    with pytest.raises(
        carom.InvalidArgument, match=r"name must be that of a ball .* \(did you mean red\?\), not 'rad'"
    ):
        world.balls["rad"]
    with pytest.raises(carom.InvalidArgument, match="name must be that of a ball in the world, not 'post'"):
        world.balls["post"]


def test_a_shape_is_found_by_its_name_the_first_that_bears_it() -> None:
    world = carom.World()
    first, second = world.add(carom.Point((0, 0), name="post"), carom.Point((1, 0), name="post"))
    brick = world.add(carom.Group([carom.Point((2, 0), name="corner")], name="brick"))
    assert (world.shapes["post"], world.shapes["brick"]) == (first, brick)
    world.remove(first)
    assert world.shapes["post"] is second
    with pytest.raises(
        carom.InvalidArgument, match=r"name must be that of a shape .* \(did you mean brick\?\), not 'brik'"
    ):
        world.shapes["brik"]
    with pytest.raises(carom.InvalidArgument, match="name must be that of a shape in the world"):
        world.shapes["corner"]
