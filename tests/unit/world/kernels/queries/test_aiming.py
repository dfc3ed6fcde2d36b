"""A pool player's line: where a ball that is shot gets to, and where both go from there."""

from math import cos, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import Arc, Ball, Circle, Gate, Point, Segment, World
from carom.world import Aim


def test_a_cut_shot_sends_the_object_ball_along_the_line_of_centres() -> None:
    world = World()
    cue, black = world.add(Ball((0, 1), 1)), world.add(Ball((10, 0), 1))
    line = world.aim(cue, (1, 0))
    x = 10 - sqrt(3)
    assert line == Aim(
        ball=cue,
        shape=black,
        time=pytest.approx(x),
        start=(0, 1),
        ghost=pytest.approx((x, 1)),
        distance=pytest.approx(x),
        point=pytest.approx((10 - sqrt(0.75), 0.5)),
        normal=pytest.approx((-sqrt(0.75), 0.5)),
        direction=pytest.approx((0.5, sqrt(0.75))),
        speed=pytest.approx(0.5),
        other_direction=pytest.approx((sqrt(0.75), -0.5)),
        other_speed=pytest.approx(sqrt(0.75)),
    )
    # 90 degrees between the two: the rule that pool players know.
    assert np.dot(line.direction, line.other_direction) == pytest.approx(0, abs=1e-12)


def test_a_full_shot_stops_a_ball_and_a_heavier_one_sends_it_back() -> None:
    world = World()
    cue, black = world.add(Ball((0, 0), 1)), world.add(Ball((10, 0), 1))
    line = world.aim(cue, (3, 0))
    assert (line.direction, line.speed, line.other_direction, line.other_speed) == (None, 0, (1, 0), 3)
    black.mass = 3
    line = world.aim(cue, (3, 0))
    assert (line.direction, line.speed, line.other_direction, line.other_speed) == ((-1, 0), 1.5, (1, 0), 1.5)
    black.elasticity = 0
    line = world.aim(cue, (4, 0))
    assert (line.direction, line.speed, line.other_speed) == ((1, 0), 1, 1)


def test_a_full_shot_in_any_direction_stops_a_ball() -> None:
    for angle in range(50):
        world = World()
        x, y = cos(angle), sin(angle)
        cue, black = world.add(Ball((3, 5), 1)), world.add(Ball((3 + 40 * x, 5 + 40 * y), 1))
        line = world.aim(cue, (x, y))
        assert (line.shape, line.direction, line.speed) == (black, None, 0)
        assert line.other_direction == pytest.approx((x, y))


@pytest.mark.parametrize(("elasticity", "direction"), [(1, (0.6, 0.8)), (0.5, (0.6, 0.4)), (0, (0.6, 0))])
def test_a_wall_scales_the_normal_part_by_its_elasticity(elasticity: float, direction: Any) -> None:
    world = World()
    wall = world.add(Segment((-50, 0), (50, 0), elasticity=elasticity))
    cue = world.add(Ball((0, 5), 1))
    line = world.aim(cue, (3, -4))
    length = sqrt(direction[0] * direction[0] + direction[1] * direction[1])
    assert (line.shape, line.ghost, line.distance) == (wall, pytest.approx((3, 1)), pytest.approx(5))
    assert line.direction == pytest.approx((direction[0] / length, direction[1] / length))
    assert line.speed == pytest.approx(5 * length)
    assert (line.other_direction, line.other_speed) == (None, 0)


def test_total_restitution_and_kicks_count() -> None:
    world = World(restitution="total")
    wall = world.add(Segment((-50, 0), (50, 0), elasticity=0.5))
    cue = world.add(Ball((0, 5), 1))
    line = world.aim(cue, (3, -4))
    assert (line.direction, line.speed) == (pytest.approx((0.6, 0.8)), pytest.approx(2.5))
    wall.kick = 2
    assert world.aim(cue, (0, -4)).speed == pytest.approx(4)


@pytest.mark.parametrize(
    "shape",
    [Point((5, 0)), Segment((5, -4), (5, 4)), Gate((5, 4), (5, -4), (-1, 0)), Circle((9, 0), 4), Arc((9, 0), 4, 2, 4)],
)
def test_every_kind_of_shape_turns_a_ball_back(shape: Any) -> None:
    world = World()
    world.add(shape)
    cue = world.add(Ball((0, 0), 2))
    line = world.aim(cue, (1, 0))
    assert (line.shape, line.ghost, line.direction) == (shape, pytest.approx((3, 0)), (-1, 0))


def test_a_ball_aims_through_what_it_would_not_meet() -> None:
    world = World()
    world.add(Gate((2, -4), (2, 4), (1, 0)))
    world.add(Segment((3, -4), (3, 4), sensor=True))
    world.add(Segment((4, -4), (4, 4), can_collide=False))
    world.add(Segment((5, -4), (5, 4), layer=2))
    wall = world.add(Segment((6, -4), (6, 4)))
    cue = world.add(Ball((0, 0), 1, collides_with=1))
    assert world.aim(cue, (1, 0)).shape is wall
    for change in ({"layer": 0}, {"sensor": True}, {"can_collide": False}):
        cue.layer, cue.sensor, cue.can_collide = 1, False, True
        for name, value in change.items():
            setattr(cue, name, value)
        assert world.aim(cue, (1, 0)) is None


def test_a_ball_that_meets_nothing_has_no_line_and_distance_does_not_matter() -> None:
    world = World()
    cue = world.add(Ball((0, 0), 1))
    assert world.aim(cue, (1, 0)) is None
    wall = world.add(Segment((1e6, -1e6), (1e6, 1e6)))
    assert world.aim(cue, (1, 0.5)).shape is wall
    assert world.aim(cue, (1e-200, 0)).ghost == pytest.approx((1e6 - 1, 0))
    assert world.aim(cue, (-1, 0)) is None


def test_a_ball_that_touches_another_aims_at_it_at_once_or_away() -> None:
    world = World()
    cue, black = world.add(Ball((0, 0), 1)), world.add(Ball((2, 0), 1))
    wall = world.add(Segment((-5, -1), (-5, 1)))
    assert (world.aim(cue, (1, 0)).shape, world.aim(cue, (1, 0)).distance) == (black, 0)
    assert world.aim(cue, (-1, 0)).shape is wall


def test_many_directions_and_many_balls_in_one_call() -> None:
    world = World()
    world.add(Circle((0, 0), 100, elasticity=0.7))
    rng = np.random.default_rng(3)
    ids = world.add_balls(rng.uniform(-60, 60, (50, 2)), radius=0.5)
    balls = list(world.balls)
    angles = rng.uniform(0, 2 * pi, 50)
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    one = world.aim(balls[0], ways)
    assert list(one) == [world.aim(balls[0], tuple(way)) for way in ways]
    assert one.found.all()
    assert set(one["ball"]) == {ids[0]}
    many = world.aim(ids, ways)
    assert list(many) == [world.aim(ball, tuple(way)) for ball, way in zip(balls, ways, strict=True)]
    assert list(world.aim(balls, (1, 0))) == [world.aim(ball, (1, 0)) for ball in balls]
    assert world.aim(ids[:0], ways[:0]).tolist() == []


def test_rows_of_misses_hold_ball_and_start_alone() -> None:
    world = World()
    cue = world.add(Ball((3, 4), 1))
    (row,) = np.asarray(world.aim(cue, [(1, 0)]))
    assert (row["ball"], row["start"].tolist()) == (cue.id, [3, 4])
    assert not any(np.any(row[name]) for name in row.dtype.names if name not in ("ball", "start"))


def test_a_line_foretells_the_first_hit_of_the_continuous_mode() -> None:
    rng = np.random.default_rng(5)
    shots = 0
    for angle in rng.uniform(0, 2 * pi, 30):
        world = World(detection="continuous", rest_speed=0.0)
        for k, (x, y) in enumerate(rng.uniform(-10, 10, (8, 2))):
            world.add(Segment((3 * x, 3 * y), (3 * x + 9 * cos(k), 3 * y + 9 * sin(k)), elasticity=0.8))
            world.add(Arc((-2 * y, 3 * x), 1 + 0.3 * k, k, k + 3, elasticity=0.7))
            world.add(Point((-3 * x, 2 * y), elasticity=0.9))
            # All but the cue ball let each other be, wherever they overlap.
            others = {} if k == 3 else {"layer": 2, "collides_with": 1}
            world.add(Ball((x, y), 0.1 + 0.02 * k, mass=1 + k, elasticity=0.9, **others))
        world.add(Circle((0, 0), 45))
        cue = world.balls[3]
        if any(cue in (contact.ball, contact.shape) for contact in world.contacts()):
            continue
        shots += 1
        line = world.aim(cue, (3 * cos(angle), 3 * sin(angle)))
        cue.velocity = (3 * cos(angle), 3 * sin(angle))
        hits = world.run(line.distance / 3 + 1e-9, dt=line.distance / 3 + 1e-9)
        assert next(hit.time for hit in hits if cue in (hit.ball, hit.shape)) == pytest.approx(line.distance / 3)
        assert cue.position == pytest.approx(line.ghost)
        assert cue.velocity == pytest.approx(np.multiply(line.direction, line.speed))
    assert shots > 10


def test_what_follows_is_what_a_contact_there_leads_to() -> None:
    rng = np.random.default_rng(4)
    world = World()
    for k in range(12):
        x, y = rng.uniform(-10, 10, 2)
        world.add(Circle((2 * x, 3 * y), 1, solid=True, elasticity=0.3))
        world.add(Segment((3 * x, 3 * y), (3 * x + 9 * cos(k), 3 * y + 9 * sin(k)), elasticity=0.8))
        world.add(Ball((x, y), 0.2 + 0.05 * k, mass=1 + k, elasticity=0.9))
    cue = world.balls[3]
    lines = 0
    for angle in rng.uniform(0, 2 * pi, 100):
        line = world.aim(cue, (cos(angle), sin(angle)))
        if line is None or line.distance == 0:
            continue
        lines += 1
        deep = 1e-7
        place = (line.ghost[0] + deep * cos(angle), line.ghost[1] + deep * sin(angle))
        ball = Ball(place, cue.radius, (cos(angle), sin(angle)), cue.mass, elasticity=cue.elasticity)
        other = line.shape
        if isinstance(other, Ball):
            other = Ball(other.position, other.radius, mass=other.mass, elasticity=other.elasticity)
        contact = other.detect(ball)
        ball.respond(contact)
        assert ball.velocity == pytest.approx(np.multiply(line.direction, line.speed), abs=1e-5)
        if isinstance(other, Ball):
            assert other.velocity == pytest.approx(np.multiply(line.other_direction, line.other_speed), abs=1e-5)
    assert lines > 30


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda world: world.aim(world.balls[0], (0, 0)), r"direction must not be \(0, 0\)"),
        (lambda world: world.aim(world.balls[0], [(1, 0), (0, 0)]), r"direction must not be \(0, 0\)"),
        (lambda world: world.aim(world.balls[0], 3), "direction must be a pair"),
        (lambda world: world.aim(Ball((0, 0), 1), (1, 0)), "ball must be in this world"),
        (lambda world: world.aim([Ball((0, 0), 1)], (1, 0)), "ball must be in this world"),
        (lambda world: world.aim(Point((0, 0)), (1, 0)), "ball must be a Ball"),
        (lambda world: world.aim(1, (1, 0)), "ball must be a Ball"),
        (lambda world: world.aim(np.array([1.0]), (1, 0)), "ball must be a Ball"),
        (lambda world: world.aim(np.array([1, 99]), (1, 0)), "ball must hold ids"),
        (lambda world: world.aim(np.array([1, 2]), np.ones((3, 2))), "direction must be one or as many as ball"),
    ],
)
def test_bad_shots_are_refused_by_name(ask: Any, words: str) -> None:
    world = World()
    world.add_balls([(0, 0), (5, 5)], radius=1)
    with pytest.raises(carom.InvalidArgument, match=words):
        ask(world)
