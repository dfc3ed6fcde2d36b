"""Taking shapes and balls out: rows move and objects follow, sensors are left, hits still know what they named."""

import pytest

import carom
from tests.worlds import crowded, quiet


def test_the_object_keeps_its_last_values_and_knows_no_world() -> None:
    world = quiet()
    ball, wall = world.balls[0], world.shapes[0]
    world.step(0.25)
    position, velocity = ball.position, ball.velocity
    world.remove(ball)
    world.remove(wall)
    assert (ball.position, ball.velocity) == (position, velocity)
    assert ball.world is ball.id is wall.world is wall.id is None
    assert not ball.asleep
    world.run(1.0)
    assert (ball.position, ball.velocity) == (position, velocity)


@pytest.mark.parametrize("place", [0, 3, 7])
def test_rows_move_up_and_objects_follow(place: int) -> None:
    world = carom.World()
    balls = [world.add(carom.Ball((100 * n, 0), 0.1 + n, name=str(n))) for n in range(8)]
    shapes = [world.add(carom.Point((n, 100))) for n in range(8)]
    ids = [ball.id for ball in balls], [shape.id for shape in shapes]
    world.remove(balls[place])
    world.remove(shapes[place])
    kept = [n for n in range(8) if n != place]
    assert list(world.balls) == [balls[n] for n in kept]
    assert list(world.shapes) == [shapes[n] for n in kept]
    for n in kept:
        assert (balls[n].position, balls[n].radius, balls[n].id) == ((100 * n, 0), 0.1 + n, ids[0][n])
        assert (shapes[n].position, shapes[n].id) == ((n, 100), ids[1][n])
    balls[kept[-1]].velocity = (0, 1)
    world.step(1.0)
    assert balls[kept[-1]].position == (100 * kept[-1], 1)


def test_a_world_goes_on_as_if_what_was_removed_had_never_met_it() -> None:
    with_guest, without = crowded(), crowded()
    guest = with_guest.add(carom.Ball((100, 100), 0.5))
    wall = with_guest.add(carom.Segment((90, 90), (91, 95)))
    for world in (with_guest, without):
        world.run(0.5)
    with_guest.remove(guest)
    with_guest.remove(wall)
    for world in (with_guest, without):
        world.gravity = world.gravity  # wakes both
        world.run(1.0)
    assert with_guest.balls.position.tolist() == without.balls.position.tolist()


def test_a_compound_goes_with_all_its_parts() -> None:
    world = carom.World()
    mill = world.add(carom.Compound([carom.Point((1, 1)), carom.Point((2, 2))], pivot=(0, 0)))
    world.remove(mill)
    assert len(world.shapes) == 0
    assert mill.world is None
    assert [part.compound for part in mill.shapes] == [mill, mill]
    assert world.add(mill).world is world


@pytest.mark.parametrize("part", ["shapes", "center_point"])
def test_a_part_is_not_removed_alone(part: str) -> None:
    world = carom.World()
    mill = world.add(carom.Compound([carom.Point((1, 1))], pivot=(0, 0)))
    with pytest.raises(carom.InvalidArgument, match="remove the compound"):
        world.remove(mill.shapes[0] if part == "shapes" else mill.center_point)
    assert mill in world.shapes


def test_what_is_not_in_the_world_is_not_removed() -> None:
    world, other = quiet(), quiet()
    before = world.digest()
    gone = world.balls[0]
    for thing in (carom.Ball((0, 0), 1), other.balls[0], other.shapes[0]):
        with pytest.raises(carom.InvalidArgument, match="must be in this world"):
            world.remove(thing)
    assert world.digest() == before
    world.remove(gone)
    for _ in range(2):
        world.step(0.01)
    with pytest.raises(carom.InvalidArgument, match="must be in this world"):
        world.remove(gone)


@pytest.mark.parametrize("which", ["ball", "sensor", "switched off"])
def test_leaving_a_sensor_by_removal_is_an_exit_at_that_time(which: str) -> None:
    world = quiet()
    ball, eye = world.balls[1], world.shapes[1]
    assert [hit.shape for hit in world.run(1.0) if hit.kind == carom.HitKind.ENTER and hit.ball is ball] == [eye]
    if which == "switched off":
        eye.can_collide = False
    else:
        world.remove(ball if which == "ball" else eye)
    before = world.time
    (leave,) = world.step(0.001)
    assert (leave.kind, leave.ball, leave.shape) == (carom.HitKind.EXIT, ball, eye)
    assert before <= leave.time <= before + 0.001
    assert (leave.point, leave.normal, leave.setback, leave.speed, leave.impulse) == ((0, 0), (0, 0), 0, 0, 0)
    assert leave.velocity == ball.velocity
    assert leave.position == pytest.approx(ball.position, abs=0.0011 * leave.velocity[1])
    assert not [hit for hit in world.run(1.0) if hit.kind == carom.HitKind.EXIT]


def test_leaving_a_sensing_ball_by_removal_is_an_exit() -> None:
    for gone in (0, 1):
        world = carom.World()
        balls = [world.add(carom.Ball((0, 0), 1, sensor=True)), world.add(carom.Ball((0.5, 0), 1))]
        (enter,) = world.step(0.1)
        assert (enter.ball, enter.shape) == (balls[1], balls[0])
        world.remove(balls[gone])
        (leave,) = world.step(0.1)
        assert (leave.kind, leave.ball, leave.shape) == (carom.HitKind.EXIT, balls[1], balls[0])


def test_other_relations_stay_when_rows_move() -> None:
    world = carom.World()
    first = world.add(carom.Ball((50, 50), 1))
    inside = world.add(carom.Ball((0, 0), 1))
    extra = world.add(carom.Point((90, 90)))
    eye = world.add(carom.Circle((0, 0), 3, sensor=True, solid=True))
    world.step(0.1)
    world.remove(first)
    world.remove(extra)
    assert len(world.step(0.1)) == 0
    inside.position = (30, 0)
    (leave,) = world.step(0.1)
    assert (leave.ball, leave.shape) == (inside, eye)


def test_removing_a_sleeper_keeps_the_count_of_sleepers() -> None:
    world = carom.World(sleep_speed=1.0, sleep_time=0.1)
    balls = [world.add(carom.Ball((5 * n, 0), 1)) for n in range(3)]
    world.run(1.0)
    assert world.statistics.sleeping == 3
    world.remove(balls[1])
    assert world.statistics.sleeping == 2
    world.run(1.0)
    assert world.statistics.sleeping == 2
