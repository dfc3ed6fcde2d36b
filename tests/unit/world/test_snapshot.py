"""`snapshot`, `restore`, `digest`, copies: the very same world again, with the objects that were there."""

import io
import json
from typing import Any

import numpy as np
import pytest

import carom
from carom.shapes.shape import Shape
from tests import fresh
from tests.worlds import bits, busy, crowded, named, quiet

GO_ON = """
import sys
import carom
world = carom.World()
world.restore(sys.stdin.buffer.read())
print(world.digest())
for _ in range(500):
    world.step(1 / 60)
print(world.digest())
"""


def state_of(world: carom.World) -> Any:
    """What a world and its objects say, to compare before and after."""
    shapes = [part for shape in world.shapes for part in ([shape, *getattr(shape, "shapes", ())])]
    return world.snapshot(), [(id(member), member.id, member.name) for member in (*shapes, *world.balls)]


# -- the same bits ---------------------------------------------------------------------------------------------------


@pytest.mark.compiled
@pytest.mark.parametrize("steps", [0, 1, 7, 60])
def test_a_restored_world_goes_on_to_the_same_bits(steps: int) -> None:
    world = crowded()
    for _ in range(steps):
        world.step(1 / 60)
    twin = carom.World(gravity=(9, 9))
    twin.restore(world.snapshot())
    assert twin.digest() == world.digest()
    assert twin.snapshot() == world.snapshot()
    assert bits(twin.run(2.0)) == bits(world.run(2.0))
    assert twin.digest() == world.digest()


@pytest.mark.slow
def test_another_process_goes_on_to_the_same_bits_for_500_steps() -> None:
    world = busy(balls=6)
    told = fresh.printed(GO_ON, given=world.snapshot()).split()
    before = world.digest()
    for _ in range(500):
        world.step(1 / 60)
    assert told == [before, world.digest()]


def test_the_way_to_a_state_leaves_no_trace_in_it() -> None:
    roomy = busy()
    tight = carom.World()
    tight.restore(roomy.snapshot())
    guests = [roomy.add(carom.Ball((50 + 3 * n, 50), 0.1)) for n in range(40)]
    roomy.step(0.0)
    twin = carom.World()
    twin.restore(roomy.snapshot())
    for world in (roomy, twin):
        for ball in list(world.balls)[-len(guests) :]:
            world.remove(ball)
    assert roomy.snapshot() == twin.snapshot()


def test_a_digest_is_that_of_the_state_alone() -> None:
    world = busy()
    before = world.digest()
    assert len(before) == 32
    assert int(before, 16) >= 0
    looks = (world.snapshot, world.digest, world.balls.radius.copy, lambda: list(world.balls), lambda: world.strays)
    for look in looks:
        look()
        assert world.digest() == before
    world.balls[0].user = object()
    assert world.digest() == before


@pytest.mark.compiled
@pytest.mark.parametrize(
    "change",
    [
        lambda world: world.step(0.001),
        lambda world: setattr(world, "friction", 0.3),
        lambda world: setattr(world.balls[0], "radius", 0.31),
        lambda world: setattr(world.balls[0], "name", "another"),
        lambda world: setattr(world.shapes[0], "elasticity", 0.3),
        lambda world: setattr(named(world, "mill"), "angular_velocity", 2.5),
        lambda world: world.statistics.reset(),
        lambda world: world.remove(world.balls[0]),
        lambda world: world.add(carom.Point((0, 0))),
        lambda world: world.balls.position.__setitem__((0, 0), 3.0),
    ],
)
def test_every_change_of_state_changes_the_digest(change: Any) -> None:
    world = busy()
    before = world.digest()
    change(world)
    assert world.digest() != before


def test_sensors_passing_pairs_and_sleepers_are_in_it() -> None:
    world = carom.World(sleep_speed=0.1, sleep_time=0.2)
    world.add(carom.Circle((0, 0), 3, sensor=True, solid=True))
    inside = world.add(carom.Ball((0, 0), 1))
    world.add(carom.Gate((10, 0), (10, 5), direction=(1, 0)))
    passing = world.add(carom.Ball((9.5, 2.5), 1, (0.5, 0)))
    world.step(0.1)
    world.run(0.5)
    assert inside.asleep
    twin = carom.World()
    twin.restore(world.snapshot())
    assert twin.balls[0].asleep
    for either in (world, twin):
        assert len(either.step(0.1)) == 0
        assert either.statistics.sleeping == 1
    twin_passing = twin.balls[1]
    assert twin_passing.velocity == passing.velocity == (0.5, 0)
    twin.balls[0].position = (50, 50)
    assert [hit.kind for hit in twin.step(0.1)] == [carom.HitKind.EXIT]


def test_hits_that_wait_for_the_next_step_are_in_it() -> None:
    world = quiet()
    world.run(1.0)
    world.remove(named(world, "up"))
    twin = carom.World()
    twin.restore(world.snapshot())
    (leave,) = twin.step(0.01)
    assert leave.kind == carom.HitKind.EXIT
    assert leave.shape is named(twin, "eye")
    assert leave.ball is None  # it left before there was a twin


def test_a_ball_that_was_moved_through_a_view_still_wakes_the_others_after_a_restore() -> None:
    world = carom.World(sleep_speed=0.1, sleep_time=0.1)
    world.add_balls([(0, 0), (9, 9)], radius=1.0)
    world.run(0.5)
    world.balls.position[0] = (1, 1)
    twin = carom.World()
    twin.restore(world.snapshot())
    assert twin.digest() == world.digest()
    for either in (world, twin):
        either.step(0.01)
        assert either.statistics.sleeping == 0
    assert twin.digest() == world.digest()


# -- objects, compounds, names -----------------------------------------------------------------------------------------


def test_objects_that_are_in_it_are_kept_those_missing_made_and_others_detached() -> None:
    world = quiet()
    wall, eye = world.shapes
    down, up = world.balls
    state = world.snapshot()
    world.run(0.2)
    later = world.add(carom.Ball((9, 9), 1))
    post = world.add(carom.Point((9, 0)))
    world.remove(eye)
    world.remove(up)
    world.restore(state)
    assert world.snapshot() == state
    assert world.shapes[0] is wall
    assert world.balls[0] is down
    assert down.position == (-2.0, 2.0)
    assert later.world is post.world is eye.world is up.world is None
    assert (later.position, post.position) == ((9, 9), (9, 0))
    assert named(world, "eye").world is world
    assert named(world, "eye") is not eye
    assert named(world, "up") is world.balls[1]


def test_after_a_restore_hits_name_the_new_objects_not_those_that_left() -> None:
    world = quiet()
    old = world.balls[1]
    state = world.snapshot()
    world.remove(old)
    world.restore(state)
    hits = [hit for hit in world.run(1.0) if hit.kind == carom.HitKind.ENTER]
    assert [hit.ball for hit in hits] == [world.balls[1]]
    assert old.world is None


def test_strays_of_another_time_are_forgotten() -> None:
    world = carom.World(bounds=(0, 0, 10, 10), remove_strays=True)
    world.add_balls([(20, 5), (5, 5)], radius=1.0)
    state = world.snapshot()
    world.step(0.1)
    assert len(world.strays) == 1
    world.restore(state)
    assert world.strays == []


def test_users_own_data_stays_on_the_objects_that_stay() -> None:
    world = busy()
    ball, mill = world.balls[0], named(world, "mill")
    ball.user, mill.user = ["ball"], ["mill"]
    state = world.snapshot()
    world.run(0.5)
    world.restore(state)
    assert world.balls[0].user == ["ball"]
    assert named(world, "mill").user == ["mill"]
    twin = carom.World()
    twin.restore(state)
    assert twin.balls[0].user is named(twin, "mill").user is None


def test_compounds_come_back_as_what_they_were() -> None:
    world = busy()
    mill = named(world, "mill")
    twin = carom.World()
    twin.restore(world.snapshot())
    copied = named(twin, "mill")
    assert [part.kind for part in copied.shapes] == [part.kind for part in mill.shapes]
    assert copied.center_point.id == mill.center_point.id
    assert all(part.compound is copied for part in (*copied.shapes, copied.center_point))
    assert (copied.orientation, copied.angular_velocity, copied.pivot) == (
        mill.orientation,
        mill.angular_velocity,
        mill.pivot,
    )
    assert copied.elasticity == 0.9
    assert copied.add(carom.Point((4, 4))).elasticity == 0.9
    world.restore(world.snapshot())
    assert named(world, "mill") is mill


def test_a_part_that_was_added_since_leaves_the_compound_again() -> None:
    world = carom.World()
    mill = world.add(carom.Compound([carom.Point((1, 0))], pivot=(0, 0)))
    lone = world.add(carom.Point((5, 0)))
    state = world.snapshot()
    since = mill.add(carom.Point((2, 0)))
    mill.add(lone)
    world.restore(state)
    assert [part.position for part in mill.shapes] == [(1, 0)]
    assert since.compound is since.world is None
    assert lone.compound is None
    assert list(world.shapes) == [mill, lone]
    mill.add(lone)
    assert list(world.shapes) == [mill]


def test_a_shape_that_a_newer_compound_had_taken_is_on_its_own_again() -> None:
    world = carom.World()
    shape = world.add(carom.Point((5, 0)))
    state = world.snapshot()
    mill = world.add(carom.Compound([carom.Point((1, 0))], pivot=(0, 0)))
    mill.add(shape)
    newer = world.snapshot()
    world.restore(state)
    assert list(world.shapes) == [shape]
    assert shape.compound is mill.world is None
    assert [part.position for part in mill.shapes] == [(1, 0)]
    world.restore(newer)
    (again,) = world.shapes
    assert again is not mill
    assert again.shapes[1] is shape


def test_names_are_those_of_the_snapshot() -> None:
    world = quiet()
    state = world.snapshot()
    world.shapes[0].name, world.balls[0].name = "another", None
    world.add_balls([(9, 9)], radius=1.0)
    world.balls[2].name = 'quotes " and ☃'
    later = world.snapshot()
    world.restore(state)
    assert [member.name for member in (*world.shapes, *world.balls)] == ["wall", "eye", "down", "up"]
    world.restore(later)
    assert [member.name for member in (*world.shapes, *world.balls)] == ["another", "eye", None, "up", 'quotes " and ☃']


def test_ids_go_on_from_the_snapshot() -> None:
    world = quiet()
    state = world.snapshot()
    first = world.add(carom.Point((0, 9))).id
    world.restore(state)
    assert world.add(carom.Point((1, 9))).id == first
    twin = carom.World()
    twin.restore(state)
    assert twin.add(carom.Point((1, 9))).id == first


def test_settings_and_time_are_restored() -> None:
    world = crowded(restitution="total", max_speed=50.0, rest_speed=0.25, substeps=3, remove_strays=True)
    world.run(0.5)
    twin = carom.World()
    twin.restore(world.snapshot())
    from carom.world.settings import SETTINGS

    assert [getattr(twin, name) for name in SETTINGS] == [getattr(world, name) for name in SETTINGS]
    assert twin.time == world.time
    assert twin.statistics.as_dict() == world.statistics.as_dict()


def test_views_are_of_the_restored_rows() -> None:
    world = quiet()
    state = world.snapshot()
    world.run(1.0)
    world.restore(state)
    position = world.balls.position
    assert position.tolist() == [[-2, 2], [0, 2]]
    position[0] = (7, 7)
    assert world.balls[0].position == (7, 7)
    assert carom.World().restore(state) is None


# -- pickle and copies -------------------------------------------------------------------------------------------------


# -- what is refused ---------------------------------------------------------------------------------------------------


@pytest.mark.compiled
@pytest.mark.parametrize("given", [None, 5, "text", [1, 2], b"", b"carom snapshot 1\n", b"carom snapshot 2\n" * 9])
def test_what_is_no_snapshot_is_refused(given: Any) -> None:
    world = busy()
    before = state_of(world)
    with pytest.raises(carom.SnapshotError, match="snapshot"):
        world.restore(given)
    assert state_of(world) == before


def test_what_a_world_does_after_a_restore_changes_nothing_of_the_next_one() -> None:
    world = crowded()
    snapshot, digest = world.snapshot(), world.digest()
    for _ in range(3):
        world.restore(snapshot)
        assert (world.digest(), world.snapshot()) == (digest, snapshot)
        world.step(1 / 60)
        world.balls[0].radius *= 0.5
        world.balls.velocity[:] = 1.0
        assert world.digest() != digest


def test_of_the_same_ids_those_that_are_another_kind_are_made_anew() -> None:
    points, circles = carom.World(), carom.World()
    old = points.add(carom.Point((0, 0)), carom.Point((1, 0)))
    circles.add(carom.Circle((0, 0), 1), carom.Point((1, 0)))
    points.restore(circles.snapshot())
    assert [shape.kind for shape in points.shapes] == ["circle", "point"]
    assert points.shapes[1] is old[1]
    assert old[0].world is None
    assert points.digest() == circles.digest()


def test_its_arrays_are_in_numpys_file_format() -> None:
    world = crowded()
    file = io.BytesIO(world.snapshot().split(b"\n", 1)[1][16:])
    text, state, balls, shapes, *others = [np.load(file) for _ in range(7)]
    assert set(json.loads(text.tobytes())) == {"names", "compounds", "groups"}
    assert float(state["time"][0]) == world.time
    assert balls["x"].tolist() == world.balls.position[:, 0].tolist()
    assert shapes["id"].tolist() == sorted(key for key, member in world._objects.items() if isinstance(member, Shape))
    assert len(others) == 3
    assert file.read() == b""


def test_buffers_of_bytes_are_taken() -> None:
    state = busy().snapshot()
    for given in (bytearray(state), memoryview(state)):
        carom.World().restore(given)
