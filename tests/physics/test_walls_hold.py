"""What stands still holds in the discrete mode: no mover, setter or ball pushes a ball through it, at any slowness."""

from collections.abc import Callable
from math import cos, hypot, pi, sin
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Compound, Gate, Point, Segment, World
from carom.shapes.shape import Shape

#: The most that anything moves in a substep, in radii of the smallest ball; the documented bound is a half.
WAY = 0.45

#: Which side of a wall a place is on.
Side = Callable[[float, float], bool]


def random_wall(random: Random, turn: float, options: dict[str, Any]) -> tuple[list[Shape], Side]:
    """A wall that nobody gets around, and the side of it; the origin is beside it, 0.4 or more away along `turn`."""
    near = random.uniform(0.4, 1.5)
    c, s = cos(turn), sin(turn)
    kind = random.choice(("segment", "gate", "room", "outside", "disc", "arc", "bulge", "polygon"))
    if kind in ("segment", "gate"):
        ends = (near * c - 900 * s, near * s + 900 * c), (near * c + 900 * s, near * s - 900 * c)
        wall = Segment(*ends, **options) if kind == "segment" else Gate(*ends, (-c, -s), **options)
        return [wall], lambda x, y: x * c + y * s > near
    if kind == "polygon":
        corners = [(2 * near * cos(turn + k * 2 * pi / 3), 2 * near * sin(turn + k * 2 * pi / 3)) for k in range(3)]
        walls: list[Shape] = [Segment(corners[k - 1], corners[k], **options) for k in range(3)]
        return [*walls, *(Point(corner, **options) for corner in corners)], lambda x, y: all(
            (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0
            for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
        )
    inside = kind in ("room", "arc")
    radius = random.uniform(2.0, 8.0) if inside else random.uniform(0.3, 8.0)
    q = ((near - radius) * c, (near - radius) * s) if inside else ((near + radius) * c, (near + radius) * s)
    round_walls: list[Shape] = [Circle(q, radius, solid=kind == "disc", **options)]
    if kind in ("arc", "bulge"):
        start, stop = turn + random.uniform(-3, 3), turn + random.uniform(3.5, 6)
        round_walls = [Arc(q, radius, start, stop, **options), Arc(q, radius, stop, start, **options)]
    return round_walls, lambda x, y: hypot(x - q[0], y - q[1]) > radius


def random_mover(random: Random, turn: float, most: float) -> Shape | Compound:
    """A shape of any kind that comes by the origin about along `turn`, at up to `most` or far slower; some turn."""
    away, size = random.uniform(0.7, 1.5), random.uniform(0.2, 1.5)
    turn, lean = turn + pi + random.choice((0.0, random.gauss(0, 0.7))), random.uniform(0, 2 * pi)
    x, y = away * cos(turn), away * sin(turn)
    speed = most * 10 ** random.uniform(-1.5, 0)
    reach = 2 * size + 0.01
    part = random.choice((0.0, 0.0, random.uniform(0, 0.9)))
    motion: dict[str, Any] = {
        "velocity": (-(1 - part) * speed * cos(turn), -(1 - part) * speed * sin(turn)),
        "angular_velocity": random.choice((-1, 1)) * part * speed / reach,
    }
    dx, dy = size * cos(lean), size * sin(lean)
    kind = random.choice(("point", "segment", "gate", "ring", "disc", "arc", "compound"))
    shape: Shape
    if kind == "compound":
        return Compound([Segment((x, y), (x + dx, y + dy)), Point((x, y))], (x, y), **motion)
    motion |= {"motion": "kinematic", "elasticity": random.choice((1.0, random.uniform(0, 1.2)))}
    if kind == "point":
        shape = Point((x, y), **motion)
    elif kind == "segment":
        shape = Segment((x - dx, y - dy), (x + dx, y + dy), **motion)
    elif kind == "gate":
        shape = Gate((x - dx, y - dy), (x + dx, y + dy), (dy, -dx), **motion)
    elif kind == "arc":
        shape = Arc((x, y), 0.5 * size, lean, lean + random.uniform(0.5, 6), **motion)
    else:
        shape = Circle((x, y), 0.4 * size, solid=kind == "disc", **motion)
    return shape


def pressed_world(seed: int) -> tuple[World, Side]:
    """Balls about the origin, between a wall at rest and one to three movers, and the side of the wall."""
    random = Random(seed)
    substeps = random.choice((1, 3, 16))
    dt = 1 / 60
    radii = [random.uniform(0.05, 0.3) for _ in range(random.choice((1, 1, 2, 4)))]
    most = WAY * min(radii) / (dt / substeps)
    world = World(
        detection="discrete",
        substeps=substeps,
        iterations=random.choice((1, 2, 6, 6)),
        broad_phase=random.choice(("grid", "brute", "quadtree")),
        restitution=random.choice(("normal", "normal", "total")),
        max_speed=most,
        gravity=random.choice(((0.0, 0.0), (0.0, -0.02 * most))),
    )
    options: dict[str, Any] = {"elasticity": random.choice((1.0, random.uniform(0, 1.2)))}
    if random.random() < 0.2:
        options["motion"] = "kinematic"
    turn = random.uniform(0, 2 * pi)
    walls, side = random_wall(random, turn, options)
    for shape in [*walls, *(random_mover(random, turn, most) for _ in range(random.choice((1, 1, 2, 3))))]:
        world.add(shape)
    for radius in radii:
        place = random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25)
        mass, elasticity = random.choice((1.0, 10 ** random.uniform(-3, 3))), random.choice((1.0, random.uniform(0, 1)))
        velocity = random.uniform(-1, 1) * 0.2 * most, random.uniform(-1, 1) * 0.2 * most
        world.add(Ball(place, radius, velocity, mass=mass, elasticity=elasticity))
    return world, side


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1))
def test_no_mover_pushes_a_ball_through_what_stands_still(seed: int) -> None:
    world, side = pressed_world(seed)
    here = [side(*ball.position) for ball in world.balls]
    for _ in range(300):
        world.step(1 / 60)
        assert [side(*ball.position) for ball in world.balls] == here


@pytest.mark.compiled
def test_a_press_goes_over_a_ball_that_a_wall_holds() -> None:
    world = World(detection="discrete", substeps=256)
    world.add(Segment((5, -9), (5, 9), elasticity=0.5))
    world.add(Segment((4.6, -2), (4.6, 2), motion="kinematic", velocity=(1, 0), elasticity=0.5))
    ball = world.add(Ball((4.82, 0), 0.15))
    for _ in range(24):
        world.step(1 / 60)
        assert ball.position[0] < 5
        assert hypot(*ball.velocity) < 3
    assert world.statistics.squeezed == 1
    assert World().digest() != world.digest()
    twin = World()
    twin.restore(world.snapshot())
    assert twin.digest() == world.digest()


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("gravity", [0.0, -10.0, 10.0])
def test_a_shape_that_is_put_onto_a_ball_leaves_it_on_its_side(detection: Any, gravity: float) -> None:
    world = World(detection=detection, gravity=(gravity, 0))
    world.add(Segment((0, -1), (0, 1)))
    disc = world.add(Circle((0.5, 0), 0.05, solid=True, motion="kinematic"))
    ball = world.add(Ball((0.04, 0), 0.03))
    disc.position = 0.075, 0
    for _ in range(20):
        world.step(1 / 60)
        assert ball.position[0] > 0
    assert world.statistics.squeezed > 0
    assert world.statistics.stalled == 0


def put_onto(random: Random, world: World, x: float, y: float) -> None:
    """Put a shape of any kind, by any setter, onto the place (x, y), or as good as."""
    x, y, lean = x + random.gauss(0, 0.05), y + random.gauss(0, 0.05), random.uniform(0, 2 * pi)
    motion = random.choice(("static", "kinematic"))
    how = random.choice(("position", "radius", "ends", "angles", "turn", "compound", "add"))
    if how == "radius":
        disc = world.add(Circle((x + 1, y), 0.1, solid=random.random() < 0.5, motion=motion))
        world.step(0.0)
        disc.radius = random.uniform(0.8, 1.2)
    elif how == "ends":
        line = world.add(Segment((x + 5, y), (x + 5, y + 1), motion=motion))
        world.step(0.0)
        line.p0 = x - cos(lean), y - sin(lean)
    elif how == "angles":
        arc = world.add(Arc((x - 0.5 * cos(lean), y - 0.5 * sin(lean)), 0.5, lean + 1, lean + 2, motion=motion))
        world.step(0.0)
        arc.start_angle = lean - 1
    elif how == "turn":
        line = world.add(Segment((x, y + 1), (x, y + 3), motion="kinematic"))
        world.step(0.0)
        line.rotate((x, y + 1), lean)
    elif how == "compound":
        both = world.add(Compound([Segment((9, 9), (9.2, 9.1)), Circle((9, 9), 0.1, solid=True)], (9, 9)))
        world.step(0.0)
        both.position = x, y
        both.rotate((x, y), lean)
    else:
        shape: Shape = random.choice(
            (
                Point((x, y), motion=motion),
                Circle((x, y), 0.2, solid=True, motion=motion),
                Segment((x - 0.3 * cos(lean), y - 0.3 * sin(lean)), (x + cos(lean), y + sin(lean)), motion=motion),
                Gate((x - 0.3 * cos(lean), y - 0.3 * sin(lean)), (x + cos(lean), y + sin(lean)), motion=motion),
            )
        )
        if how == "position":
            shape.position = 40, 40
            world.add(shape)
            world.step(0.0)
            shape.position = x, y
        else:
            world.add(shape)


@given(st.integers(0, 2**32 - 1), st.sampled_from(["discrete", "continuous"]))
def test_nothing_that_is_put_onto_a_ball_pushes_it_through_what_stands_still(seed: int, detection: Any) -> None:
    random = Random(seed)
    world = World(detection=detection, substeps=random.choice((1, 4)), max_speed=0.4)
    turn = random.uniform(0, 2 * pi)
    walls, side = random_wall(random, turn, {"elasticity": random.uniform(0, 1)})
    for wall in walls:
        world.add(wall)
    near = 0.0
    while side(near * cos(turn), near * sin(turn)) == side(0, 0):
        near += 0.001
    near -= random.choice((0.002, random.uniform(0.002, 0.2)))
    place = near * cos(turn), near * sin(turn)
    ball = world.add(Ball(place, random.uniform(0.03, 0.15), (random.gauss(0, 0.1), random.gauss(0, 0.1))))
    if random.random() < 0.5:
        world.step(0.0)
    put_onto(random, world, *place)
    if random.random() < 0.3:
        ball.position = place
    for _ in range(5):
        world.step(1 / 600)
        assert side(*ball.position) == side(0, 0)
    assert world.statistics.stalled == 0
