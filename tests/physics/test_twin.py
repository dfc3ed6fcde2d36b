"""The discrete world does what its slow twin does, to rounding, over random small worlds of all kinds."""

from math import cos, pi, sin
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Gate, HitKind, Point, Segment, World
from carom.shapes.shape import Shape
from tests.physics.twin import TwinBall, TwinShape, TwinWorld

DT = 1 / 60
SUBSTEPS = 2


def random_surface(random: Random) -> dict[str, Any]:
    """What a shape is made of."""
    surface: dict[str, Any] = {"elasticity": random.choice((1.0, random.uniform(0, 1.2)))}
    if random.random() < 0.15:
        surface["kick"] = random.uniform(0, 3)
    if random.random() < 0.12:
        surface["sensor"] = True
    if random.random() < 0.15:
        surface["layer"], surface["collides_with"] = random.choice((1, 2, 3)), random.choice((1, 2, 3))
    return surface


def random_motion(random: Random) -> dict[str, Any]:
    """How a shape moves."""
    if random.random() < 0.5:
        return {}
    motion: dict[str, Any] = {"pivot": (random.uniform(-4, 4), random.uniform(-4, 4))}
    if random.random() < 0.7:
        motion["angular_velocity"] = random.uniform(-4, 4)
    if random.random() < 0.3:
        motion["turn_limits"] = random.uniform(-0.3, 0), random.uniform(0, 0.3)
    if random.random() < 0.4:
        motion["velocity"] = random.uniform(-2, 2), random.uniform(-2, 2)
    return motion


def random_shape(random: Random) -> tuple[Shape, TwinShape]:
    """A shape, and its twin."""
    surface, motion = random_surface(random), random_motion(random)
    x, y, turn, size = (random.uniform(*span) for span in ((-4, 4), (-4, 4), (0, 2 * pi), (0.5, 4)))
    place = (x, y)
    end = (x + size * cos(turn), y + size * sin(turn))
    given = {**surface, **motion, "motion": "kinematic"} if motion else surface
    twin = {**surface, **motion, "kinematic": bool(motion)}
    kind = random.choice(("point", "segment", "segment", "gate", "circle", "disc", "arc", "arc"))
    if kind == "point":
        return Point(place, **given), TwinShape("point", (place,), **twin)
    if kind == "segment":
        return Segment(place, end, **given), TwinShape("segment", (place, end), **twin)
    if kind == "gate":
        direction = cos(turn + 1.2), sin(turn + 1.2)
        return Gate(place, end, direction, **given), TwinShape("gate", (place, end), direction=direction, **twin)
    if kind == "arc":
        stop = turn + random.uniform(0.3, 5.9)
        return Arc(place, size, turn, stop, **given), TwinShape("arc", (place,), size, (turn, stop), **twin)
    solid = kind == "disc"
    size = 0.5 * size if solid else 1.3 + 0.5 * size
    return Circle(place, size, solid=solid, **given), TwinShape("circle", (place,), size, solid=solid, **twin)


def random_ball(random: Random) -> dict[str, Any]:
    """What a ball is."""
    return {
        "radius": random.uniform(0.2, 1.2),
        "velocity": (random.gauss(0, 5), random.gauss(0, 5)) if random.random() < 0.9 else (0.0, 0.0),
        "mass": random.uniform(0.2, 5),
        "elasticity": random.choice((1.0, random.uniform(0, 1.1))),
        "sensor": random.random() < 0.1,
        "layer": random.choice((1, 1, 3)),
    }


def random_world(seed: int) -> tuple[World, TwinWorld]:
    """A small world, crowded about the origin, and its twin."""
    random = Random(seed)
    shapes = [random_shape(random) for _ in range(random.randint(0, 8))]
    any_moves = any(shape.angular_velocity != 0 or shape.velocity != (0, 0) for shape, _ in shapes)
    settings: dict[str, Any] = {
        "gravity": random.choice(((0.0, 0.0), (random.gauss(0, 3), random.gauss(-5, 3)))),
        "iterations": random.choice((1, 2, 6)),
        "friction": random.choice((0.0, 0.0, 2.0)),
        # What moves wakes what its swept box meets, which is not the twin's business.
        "sleep_speed": 0.0 if any_moves else random.choice((0.0, 0.5)),
        "sleep_time": 0.06,
        "rest_speed": random.choice((None, 0.0, 0.5)),
        "max_speed": random.choice((None, None, 6.0)),
    }
    total = random.random() < 0.3
    world = World(
        detection="discrete",
        broad_phase="brute",
        substeps=SUBSTEPS,
        restitution="total" if total else "normal",
        **settings,
    )
    twin = TwinWorld([], [], total=total, **settings)
    for shape, double in shapes:
        world.add(shape)
        twin.shapes.append(double)
    for _ in range(random.randint(1, 5)):
        place, options = (random.uniform(-4, 4), random.uniform(-4, 4)), random_ball(random)
        world.add(Ball(place, **options))
        twin.balls.append(TwinBall(place, **options))
    return world, twin


def told(world: World, hits: Any) -> list[tuple[str, int, int, float]]:
    """The hits of a step as the twin tells them, the faintest ones left out."""
    balls = {ball.id: k for k, ball in enumerate(world.balls)}
    shapes = {shape.id: k for k, shape in enumerate(world.shapes)}
    names = {HitKind.BOUNCE: ("bounce", "ball"), HitKind.ENTER: ("enter shape", "enter ball")}
    names[HitKind.EXIT] = ("exit shape", "exit ball")
    found = []
    for hit in hits:
        with_ball = hit.shape.id in balls
        other = balls[hit.shape.id] if with_ball else shapes[hit.shape.id]
        found.append((names[hit.kind][with_ball], balls[hit.ball.id], other, hit.impulse))
    return heard(found)


def heard(hits: list[tuple[str, int, int, float]]) -> list[tuple[str, int, int, float]]:
    """The hits but for bounces so faint that rounding makes them."""
    return sorted(hit for hit in hits if hit[0] not in ("bounce", "ball") or hit[3] > 1e-9)


def assert_alike(world: World, twin: TwinWorld) -> None:
    """All balls and all poses agree; then the twin takes the world's numbers, so that rounding does not grow."""
    for ball, double in zip(world.balls, twin.balls, strict=True):
        assert ball.position == pytest.approx(double.place, rel=1e-12, abs=1e-12)
        assert ball.velocity == pytest.approx(double.velocity, rel=1e-12, abs=1e-11)
        assert ball.asleep is double.asleep
        double.place, double.velocity = ball.position, ball.velocity
    for shape, double in zip(world.shapes, twin.shapes, strict=True):
        if double.kinematic:
            assert shape.orientation == pytest.approx(double.turn, rel=1e-13, abs=1e-15)
            assert shape.angular_velocity == double.angular_velocity


@given(st.integers(0, 2**32))
def test_the_world_does_what_its_twin_does(seed: int) -> None:
    world, twin = random_world(seed)
    for _ in range(12):
        twin.hits = []
        hits = world.step(DT)
        for _ in range(SUBSTEPS):
            twin.substep(DT / SUBSTEPS)
        if twin.doubtful:
            return
        assert_alike(world, twin)
        expected = heard(twin.hits)
        found = told(world, hits)
        assert [hit[:3] for hit in found] == [hit[:3] for hit in expected]
        assert [hit[3] for hit in found] == pytest.approx([hit[3] for hit in expected], rel=1e-9, abs=1e-11)
        assert world._arrays.states[0]["relations"] == len(twin.passing) + len(twin.inside)
