"""Nothing escapes: neither from closed rooms of any make, at any speed, nor through exact joints."""

from collections.abc import Callable, Iterator
from math import cos, pi, sin
from random import Random

import numpy as np
import pytest

import carom
from tests.physics.continuous.rooms import (
    Floats,
    Pair,
    add_loners,
    around,
    exact_world,
    launches,
    mixers,
    random_room,
    steps_apart,
)
from tests.worlds import guarded

#: Launches in one world: those of a larger campaign are at more rooms, for all hits of a step lie in memory at once.
LAUNCHES = 1000

#: Shots at exact joints.
SHOTS = 100_000

#: Fraction of a ball's radius by which a joint may let it in: rounding, seen from afar.
DEEP = 1e-9


def rooms_launched_at(launch_count: int) -> Iterator[tuple[int, Random]]:
    """The seeds of the rooms of so many launches, and what each draws from."""
    for seed in range(launch_count // LAUNCHES):
        yield seed, Random(seed)


@pytest.mark.compiled
def test_no_launch_ends_outside_of_its_room(launch_count: int) -> None:
    for seed, random in rooms_launched_at(launch_count):
        room = random_room(random)
        gravity = (0.0, 0.0) if seed % 2 else (random.gauss(0.0, 1.0), 10.0 ** random.uniform(-3.0, 1.0))
        radius = 10.0 ** random.uniform(-1.5, -0.1)
        world = exact_world(*room.shapes, gravity=gravity)
        add_loners(world, *launches(random, LAUNCHES, room.free, radius, 0.01, 1000.0), radius)
        for step in range(3):
            world.step(1.0)
            x, y = world.balls.position.T
            velocity = world.balls.velocity
            assert room.holds(x, y).all(), (seed, step, np.flatnonzero(~room.holds(x, y)))
            assert np.isfinite(velocity).all(), (seed, step)
        # A ball that passes a wall of a guarded room has found a gap in it.
        assert world._states[0]["relations"] == 0, seed
        assert world.statistics.stalled == 0, seed


@pytest.mark.slow
@pytest.mark.compiled
def test_no_launch_escapes_from_what_turns_inside_a_room(launch_count: int) -> None:
    dt, unmet = 1.0 / 60.0, 0
    for seed, random in rooms_launched_at(launch_count):
        room = random_room(random)
        radius = 10.0 ** random.uniform(-1.5, -0.35)
        reach = 1.5
        gravity = (0.0, 0.0) if seed % 2 else (random.gauss(0.0, 1.0), 10.0 ** random.uniform(-3.0, 1.0))
        world = exact_world(*room.shapes, gravity=gravity)
        for mixer in mixers(random, reach, 100.0):
            world.add(mixer)
        place, velocity = launches(random, LAUNCHES, 1.0, radius, 0.01 / dt, 1000.0 / dt)
        add_loners(world, around(place, reach + 1.01 * radius, room.free), velocity, radius)
        met = 0
        for step in range(6):
            hits = world.step(dt)
            for number, count in zip(*np.unique(hits["shape"], return_counts=True), strict=True):
                met += count if world.object(int(number)).motion == carom.Motion.KINEMATIC else 0
            x, y = world.balls.position.T
            assert room.holds(x, y).all(), (seed, step, np.flatnonzero(~room.holds(x, y)))
            assert np.isfinite(world.balls.velocity).all(), (seed, step)
            for cam in [shape for shape in world.shapes if is_cam(shape)]:
                away = np.hypot(x - cam.center[0], y - cam.center[1])
                assert (away >= cam.radius + radius * (1.0 - DEEP)).all(), (seed, step)
        unmet += met == 0
        assert world.statistics.stalled == 0, seed
        assert world.statistics.squeezed == 0, seed
        assert world._states[0]["relations"] == 0, seed
    # A post far out may turn too slowly to meet anybody.
    assert unmet <= launch_count // LAUNCHES // 200


def is_cam(shape: carom.Shape) -> bool:
    """True for a solid circle that turns."""
    return isinstance(shape, carom.Circle) and shape.motion == carom.Motion.KINEMATIC


@pytest.mark.compiled
def test_no_launch_leaves_a_ring_of_either_make(launch_count: int) -> None:
    for seed, random in rooms_launched_at(launch_count // 10):
        pieces, gravity = ((0, (0.0, 0.0)), (0, (0.5, -2.0)), (5, (0.0, 0.0)), (5, (0.5, -2.0)))[seed % 4]
        wall = [carom.Circle((0.0, 0.0), 5.0)] if pieces == 0 else ring_of(pieces)
        world = exact_world(*wall, gravity=gravity)
        radius = 0.3
        add_loners(world, *launches(random, LAUNCHES, 4.0, radius, 0.01, 1000.0), radius)
        for _ in range(3):
            world.step(1.0)
            assert (np.hypot(*world.balls.position.T) <= 5.0 - radius * (1.0 - DEEP)).all()


def ring_of(pieces: int) -> list[carom.Shape]:
    """A circle of radius 5 in pieces."""
    angles = [2.0 * pi * k / pieces for k in range(pieces)]
    return [carom.Arc((0.0, 0.0), 5.0, angles[k - 1], angles[k]) for k in range(pieces)]


def flat(turn: float) -> tuple[list[carom.Shape], float, float]:
    """Two segments in line."""
    end = (3.0 * cos(turn), 3.0 * sin(turn))
    return [carom.Segment((-end[0], -end[1]), (0.0, 0.0)), carom.Segment((0.0, 0.0), end)], turn + 0.5 * pi, 0.9


def tangent(side: float) -> Callable[[float], tuple[list[carom.Shape], float, float]]:
    """A segment that goes on as an arc, which bends towards the ball, or away from it."""

    def made(turn: float) -> tuple[list[carom.Shape], float, float]:
        up = turn + 0.5 * pi
        center = (side * 2.0 * cos(up), side * 2.0 * sin(up))
        start = (-3.0 * cos(turn), -3.0 * sin(turn))
        low = up + (pi if side > 0.0 else 0.0)
        first, last = (low, low + 1.5) if side > 0.0 else (low - 1.5, low)
        return [carom.Segment(start, (0.0, 0.0)), carom.Arc(center, 2.0, first, last)], up, 0.9

    return made


def bowls(side: float) -> Callable[[float], tuple[list[carom.Shape], float, float]]:
    """Two arcs of one circle, met from inside, or from outside."""

    def made(turn: float) -> tuple[list[carom.Shape], float, float]:
        up = turn + 0.5 * pi
        center = (side * 2.0 * cos(up), side * 2.0 * sin(up))
        low = up + (pi if side > 0.0 else 0.0)
        arcs: list[carom.Shape] = [carom.Arc(center, 2.0, low - 1.4, low), carom.Arc(center, 2.0, low, low + 1.4)]
        return arcs, up, 0.9

    return made


def ridge(turn: float) -> tuple[list[carom.Shape], float, float]:
    """Two segments that meet in an edge towards the ball."""
    ends = [(3.0 * cos(turn + a), 3.0 * sin(turn + a)) for a in (-0.6, pi + 0.6)]
    return [carom.Segment((0.0, 0.0), end) for end in ends], turn + 0.5 * pi, 0.5


JOINTS = {
    "two segments": flat,
    "segment and bowl": tangent(1.0),
    "segment and hill": tangent(-1.0),
    "two arcs, inside": bowls(1.0),
    "two arcs, outside": bowls(-1.0),
    "edge": ridge,
}


@pytest.mark.compiled
@pytest.mark.parametrize("gravity", [0.0, 1.0])
@pytest.mark.parametrize("joint", JOINTS)
def test_a_shot_at_an_exact_joint_bounces_once(joint: str, gravity: float) -> None:
    worlds, each = 40, SHOTS // (40 * 2 * len(JOINTS))
    radius = 0.25
    for seed in range(worlds):
        random = Random(seed)
        turn = random.choice((0.0, 0.5 * pi, pi, random.uniform(-pi, pi), random.uniform(-pi, pi)))
        shapes, up, spread = JOINTS[joint](turn)
        normal = (cos(up), sin(up))
        world = exact_world(*guarded(shapes), gravity=(-gravity * normal[0], -gravity * normal[1]))
        position, velocity = aimed(random, each + 1, up, spread, radius, gravity)
        add_loners(world, position, velocity, radius)
        hits = np.asarray(world.step(0.3))
        height = world.balls.position @ np.array(normal)
        ids, counts = np.unique(hits["ball"], return_counts=True)
        assert len(ids) == each + 1, (seed, "not all bounce")
        assert (counts == 1).all(), (seed, "a second impulse", world.object(int(ids[counts > 1][0])))
        assert (height > 0.0).all(), (seed, "a leak")
        assert world._states[0]["relations"] == 0, seed


def aimed(random: Random, count: int, up: float, spread: float, radius: float, gravity: float) -> tuple[Floats, Floats]:
    """Places above a joint at the origin, and velocities straight at it, 0, 1 or 2 doubles beside; ball for ball."""
    places, velocities = [], []
    for _ in range(count):
        heading = up + random.choice((0.0, random.uniform(-spread, spread)))
        away, speed = random.uniform(2.2, 3.0) * radius, random.uniform(2.0, 3.0)
        place = (away * cos(heading), away * sin(heading))
        # It arrives after this time, having fallen that far by then.
        time = (away - radius) / speed
        fallen = 0.5 * gravity * time
        velocity = (-speed * cos(heading) + fallen * cos(up), -speed * sin(heading) + fallen * sin(up))
        places.append(beside(random, place))
        velocities.append(velocity)
    return np.array(places), np.array(velocities)


def beside(random: Random, place: Pair) -> Pair:
    """A place up to 2 doubles off in each direction."""
    x, y = (steps_apart(value, random.randint(-2, 2)) for value in place)
    return x, y
