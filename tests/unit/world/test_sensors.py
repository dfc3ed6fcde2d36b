"""Sensors: an `ENTER` and an `EXIT`, once each, whatever ends the overlap, and nothing is moved."""

import pytest

from carom import Arc, Ball, Circle, HitKind, Point, Segment, World
from tests.worlds import world_of

ENTER, EXIT = HitKind.ENTER, HitKind.EXIT


def kinds(world: World, seconds: float) -> list[HitKind]:
    """The kinds of the hits of some steps of a tenth of a second."""
    return [hit.kind for hit in world.run(seconds, dt=0.1)]


@pytest.mark.parametrize(
    "sensor",
    [
        Circle((0, 0), 2, solid=True, sensor=True),
        Segment((0, -3), (0, 3), sensor=True),
        Point((0, 0), sensor=True, kick=9),
        Arc((0, -5), 5, 0.5, 2.6, sensor=True),
        Ball((0, 0), radius=2, sensor=True),
    ],
)
def test_a_ball_that_crosses_a_sensor_enters_and_leaves_once(sensor: object) -> None:
    ball = Ball((-5, 0.5), radius=1, velocity=(1, 0))
    world = world_of(sensor, ball, substeps=2)
    hits = world.run(10, dt=0.1)
    assert [(hit.kind, hit.ball, hit.shape) for hit in hits] == [(ENTER, ball, sensor), (EXIT, ball, sensor)]
    assert ball.velocity == (1, 0)
    assert ball.position == (pytest.approx(5), 0.5)
    for hit in hits:
        assert (hit.setback, hit.impulse) == (0, 0)
        assert hit.velocity == (1, 0)
        assert hit.position[0] == pytest.approx(hit.time - 5)
    assert 1 < hits[0].time < hits[1].time < 9
    assert world.statistics.collisions == 0


def test_the_inside_of_a_ring_is_no_part_of_it() -> None:
    world = world_of(Circle((0, 0), 4, sensor=True), Ball((-7, 0), radius=1, velocity=(1, 0)), substeps=2)
    assert kinds(world, 20) == [ENTER, EXIT, ENTER, EXIT]


def test_a_ball_that_is_a_sensor_reports_walls_and_balls_and_goes_through() -> None:
    probe = Ball((-5, 0), radius=1, velocity=(1, 0), sensor=True)
    wall = Segment((0, -3), (0, 3))
    world = world_of(wall, probe, substeps=2)
    other = world.add(Ball((5, 0), radius=1))
    hits = world.run(13, dt=0.1)
    assert [(hit.kind, hit.shape) for hit in hits] == [(ENTER, wall), (EXIT, wall), (ENTER, probe), (EXIT, probe)]
    assert [hit.ball for hit in hits] == [probe, probe, other, other]
    assert probe.velocity == (1, 0)
    assert other.velocity == (0, 0)


def test_a_sensor_that_moves_over_balls_at_rest_meets_them() -> None:
    eye = Circle((-5, 0), 1, solid=True, sensor=True, motion="kinematic", velocity=(1, 0))
    world = world_of(eye, Ball((0, 0), 1), substeps=2)
    world.sleep_speed = 0.1
    assert kinds(world, 10) == [ENTER, EXIT]


def inside(sensor: object) -> tuple[World, Ball]:
    """A world in which a ball has entered a sensor, and rests there."""
    ball = Ball((0, 0.5), radius=1)
    world = world_of(sensor, ball, substeps=2)
    assert kinds(world, 0.5) == [ENTER]
    return world, ball


@pytest.mark.parametrize("of_ball", [True, False])
@pytest.mark.parametrize("whose", ["ball", "sensor"])
@pytest.mark.parametrize("how", ["removed", "off", "mask", "moved"])
def test_however_the_overlap_ends_there_is_one_exit(of_ball: bool, whose: str, how: str) -> None:
    sensor = Ball((0, 0), 2, sensor=True) if of_ball else Circle((0, 0), 2, solid=True, sensor=True)
    world, ball = inside(sensor)
    target = ball if whose == "ball" else sensor
    if how == "removed":
        world.remove(target)
    elif how == "off":
        target.can_collide = False
    elif how == "mask":
        target.layer = 0
    else:
        target.position = (50, 50)
    hits = world.run(1, dt=0.1)
    assert [(hit.kind, hit.ball, hit.shape) for hit in hits] == [(EXIT, ball, sensor)]
    assert hits[0].time >= 0.5


def test_a_sensor_that_becomes_solid_is_left_and_met() -> None:
    sensor = Circle((0, 0), 2, solid=True, sensor=True)
    world, ball = inside(sensor)
    ball.velocity = (0, -1)
    sensor.sensor = False
    assert sorted(kinds(world, 0.1)) == [HitKind.BOUNCE, EXIT]
    assert ball.position[1] == pytest.approx(3, rel=0.1)


def test_switched_off_and_on_again_it_enters_anew() -> None:
    sensor = Circle((0, 0), 2, solid=True, sensor=True)
    world, _ = inside(sensor)
    sensor.can_collide = False
    assert kinds(world, 0.3) == [EXIT]
    sensor.can_collide = True
    assert kinds(world, 0.3) == [ENTER]


def test_a_stray_that_is_removed_leaves_its_sensor() -> None:
    world = World(bounds=(-10, -10, 10, 10), remove_strays=True)
    world.add(Circle((12, 0), 3, solid=True, sensor=True))
    world.add(Ball((0, 0), radius=1, velocity=(10, 0)))
    hits = world.run(3)
    assert [hit.kind for hit in hits] == [ENTER, EXIT]
    assert len(world.balls) == 0
    assert world.statistics.strays == 1


def test_a_sleeping_ball_stays_inside() -> None:
    world, ball = inside(Circle((0, 0), 2, solid=True, sensor=True))
    world.sleep_speed = 0.1
    assert kinds(world, 3) == []
    assert ball.asleep


def test_insides_are_state() -> None:
    world, _ = inside(Circle((0, 0), 2, solid=True, sensor=True))
    twin = World()
    twin.restore(world.snapshot())
    assert kinds(twin, 0.5) == []
    twin.balls[0].position = (50, 0)
    assert kinds(twin, 0.5) == [EXIT]


@pytest.mark.compiled
def test_many_sensors_at_once_lose_no_hit() -> None:
    world = World(substeps=1)
    for k in range(70):
        world.add(Circle((0.01 * k, 0), 5, solid=True, sensor=True))
    world.add_balls([(0.0, 0.1 * k) for k in range(6)], radius=0.01)
    world.balls.velocity[:] = (1.0, 0.0)
    entered = world.step(0.1)
    assert len(entered) == 6 * 70
    left = world.step(100)
    assert len(left) == 6 * 70
    assert set(left["kind"].tolist()) == {EXIT}
    assert world._states[0]["relations"] == 0


def test_a_ball_in_a_sensor_counts_as_no_overlap_that_needs_another_iteration() -> None:
    world = World(substeps=1, iterations=50, broad_phase="brute")
    world.add(Circle((0, 0), 2, solid=True, sensor=True))
    world.add(Ball((0, 0), radius=1))
    world.step(0.1)
    assert world.statistics.full_tests == 1
