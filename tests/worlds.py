"""Worlds for tests, small enough to be interpreted, and what tests ask of any world, shape or ball.

Two of them stand for all: `crowded` has everything in it that a world can hold, in `quiet` nothing has happened yet.
"""

from collections.abc import Sequence
from functools import partial
from random import Random
from typing import Any

import numpy as np

import carom

SIDE = 12.0

Member = carom.Shape | carom.Compound | carom.Group | carom.Ball


def world_of(*members: Member, **settings: Any) -> carom.World:
    """A world that holds shapes, compounds and balls, of the discrete mode where nothing else is said."""
    world = carom.World(**({"detection": "discrete"} | settings))
    world.add(*members)
    return world


#: The same of the continuous mode.
continuous_world = partial(world_of, detection="continuous")


#: The shipped billiards: closed tables whose balls lose nothing and do not meet each other.
BILLIARDS = (
    *("annulus", "circle", "ellipse", "flower", "lemon", "lorentz", "mushroom", "rectangle", "sinai", "stadium"),
    "wedge",
)

#: Options of the shipped scenes whose number of balls, or of walls, can be chosen.
SMALL: dict[str, dict[str, Any]] = {
    "ellipse": {"tolerance": 1e-3},
    "galton": {"rows": 3, "balls": 20},
    "gas": {"balls": 20},
}


def small_scene(name: str) -> carom.Scene:
    """A shipped scene, with few balls and walls where their number can be chosen."""
    scene: carom.Scene = getattr(carom.scenes, name)(**SMALL.get(name, {}))
    return scene


def guarded(shapes: Sequence[carom.Shape]) -> list[carom.Shape]:
    """Shapes and the points that guard their ends."""
    return [*shapes, *carom.guard_points(shapes)]


def box(width: float, height: float) -> list[carom.Shape]:
    """Four walls from (0, 0) to (width, height)."""
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    return [carom.Segment(corners[i - 1], corners[i]) for i in range(4)]


def crowded(balls: int = 12, seed: int = 0, **settings: Any) -> carom.World:
    """A room with walls, of every kind of shape, at rest and moving, and balls of several sizes, named ones too.

    A gap in the upper wall lets balls stray. Nothing in it depends on anything but the arguments.
    """
    chosen: dict[str, Any] = {
        "detection": "discrete",
        "gravity": (0.5, -4.0),
        "substeps": 2,
        "iterations": 3,
        "friction": 0.2,
        "sleep_speed": 0.3,
        "sleep_time": 0.2,
        "bounds": carom.Aabb(-2.0, -2.0, SIDE + 2.0, SIDE + 2.0),
    }
    world = carom.World(**(chosen | settings))
    add_walls(world)
    add_furniture(world)
    random = Random(seed)
    for number in range(balls):
        world.add(
            carom.Ball(
                (random.uniform(1.0, SIDE - 1.0), random.uniform(5.0, SIDE - 1.0)),
                radius=random.choice((0.15, 0.25, 0.4)),
                velocity=(random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)),
                mass=random.uniform(0.5, 2.0),
                elasticity=random.choice((0.6, 0.9, 1.0)),
                sensor=number == 3,
                layer=1 if number % 4 else 3,
                name=f"ball {number}" if number % 2 else None,
            )
        )
    return world


def busy(balls: int = 12) -> carom.World:
    """A crowded world after a second."""
    world = crowded(balls)
    world.run(1.0)
    return world


def add_walls(world: carom.World) -> None:
    """Put a room with a gap in its upper wall into a world, and posts at its corners."""
    corners = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)]
    walls = [carom.Segment(start, end) for start, end in zip(corners, [*corners[1:], corners[0]], strict=True)]
    walls[2] = carom.Segment((SIDE, SIDE), (4.0, SIDE))
    world.add(*guarded(walls))


def add_furniture(world: carom.World) -> None:
    """Put one of everything into a room."""
    world.add(carom.Circle((3.0, 3.0), 0.8, solid=True, kick=1.5, elasticity=1.1, name="bumper"))
    world.add(carom.Circle((9.0, 8.0), 1.5, sensor=True, solid=True, name="eye"))
    world.add(carom.Arc((6.0, 3.0), 1.5, 3.5, 5.9, name="cup"))
    world.add(carom.Gate((0.0, 8.0), (2.0, 8.0), direction=(0.0, 1.0), name="gate"))
    world.add(carom.Point((10.0, 4.0), collides_with=2))
    world.add(carom.Segment((5.0, 6.0), (7.0, 6.0), motion="kinematic", velocity=(0.3, 0.1), name="lift"))
    world.add(
        carom.Segment((8.0, 2.0), (10.0, 1.5), motion="kinematic", pivot=(8.0, 2.0), turn_limits=(-0.5, 0.5))
    ).angular_velocity = 6.0
    world.add(
        carom.Compound(
            [carom.Segment((2.2, 6.0), (3.8, 6.0)), carom.Point((3.8, 6.0)), carom.Arc((3.0, 6.0), 0.5, 0.0, 2.0)],
            pivot=(3.0, 6.0),
            angular_velocity=2.0,
            elasticity=0.9,
            name="mill",
        )
    )


def quiet() -> carom.World:
    """A world without gravity that nothing has happened in: a wall, a sensor, and two balls that go towards them."""
    world = carom.World(detection="discrete")
    world.add(carom.Segment((-5.0, 0.0), (5.0, 0.0), name="wall"))
    world.add(carom.Circle((0.0, 5.0), 1.0, sensor=True, solid=True, name="eye"))
    world.add(carom.Ball((-2.0, 2.0), radius=0.5, velocity=(0.0, -3.0), name="down"))
    world.add(carom.Ball((0.0, 2.0), radius=0.5, velocity=(0.0, 3.0), name="up"))
    return world


def recorded(world: carom.World, steps: int, change: int, **options: str) -> carom.Recording:
    """A recording of some steps, after one of which a ball leaves and a shape is switched off."""
    recorder = carom.Recorder(world, **options)
    for step in range(steps):
        recorder.note(world.step(1 / 60))
        if step == change:
            world.remove(world.balls[2])
            world.shapes[0].can_collide = False
    return recorder.finish()


def named(world: carom.World, name: str) -> Any:
    """What has a name in a world."""
    (found,) = [member for member in (*world.shapes, *world.balls) if member.name == name]
    return found


def starve(world: carom.World) -> None:
    """Take all room from a world that its tables do not need right now, so that it has to grow again."""
    arrays = world._arrays
    relations = world._arrays.states[0]["relations"]
    kept = _relations(world)
    arrays.hits = arrays.hits[: int(arrays.states[0]["hits"]) + 1].copy()
    arrays.pairs = arrays.pairs[:1].copy()
    arrays.starts = arrays.starts[:1].copy()
    arrays.cells = arrays.cells[:1].copy()
    arrays.members = arrays.members[:1].copy()
    arrays.states[0]["index_stale"] = arrays.states[0]["moving_stale"] = 1
    arrays.relations = arrays.relations[:2].copy()
    _put_back(world, kept)
    assert arrays.states[0]["relations"] == relations
    world._forget_block()


def _relations(world: carom.World) -> Any:
    """All relations of a world."""
    from carom.world.removal import relations_in_order

    return relations_in_order(world._arrays)


def _put_back(world: carom.World, relations: Any) -> None:
    """Give a world its relations, in as little room as they need."""
    from carom.world.removal import set_relations

    set_relations(world._arrays, relations)


def energy(world: carom.World) -> float:
    """The energy of all balls: that of their motion, and where there is gravity that of their height."""
    balls = world.balls
    moving = 0.5 * balls.mass @ (balls.velocity**2).sum(axis=1)
    return float(moving - balls.mass @ (balls.position @ np.array(world.gravity)))


def bits(rows: Any) -> bytes:
    """The bytes of hits or of other answers of a world."""
    return np.asarray(rows).tobytes()


def row_bits(member: Member) -> list[bytes]:
    """All that a shape or ball knows, and the parts of a compound or group, but for their ids."""
    parts = member._parts if isinstance(member, carom.Compound | carom.Group) else (member,)
    rows = [part._row.copy() for part in parts]
    for row in rows:
        row["id"] = 0
    return [row.tobytes() for row in rows]


def game_table(detection: Any) -> carom.World:
    """A closed table with a flipper, a platform, a target that goes once hit, a sensor, and balls that come to rest."""
    world = carom.World(gravity=(0, -6), detection=detection, substeps=2, sleep_speed=0.3, sleep_time=0.1)
    world.add(*carom.outlines.rectangle(-4, -3, 4, 3, corner=0.7, elasticity=0.7))
    world.add(carom.Circle((0, 0.8), 0.5, solid=True, elasticity=0.9, kick=1.0, name="bumper"))
    world.add(carom.Segment((-1, 2), (1, 2.2), once=True, name="target"))
    world.add(carom.Circle((2.5, 0), 0.6, sensor=True, name="sensor"))
    flipper = [carom.Segment((-2, -1.2), (-0.6, -1.6)), carom.Point((-0.6, -1.6))]
    world.add(carom.Compound(flipper, pivot=(-2, -1.2), turn_limits=(-0.2, 0.6), elasticity=0.3, name="flipper"))
    platform = carom.Segment((0.5, -2), (1.5, -2), motion="kinematic", elasticity=0.5, name="platform")
    world.add(platform)
    for x, vx in ((-2.0, 3.0), (0.3, -1.0), (2.0, 0.5)):
        world.add(carom.Ball((x, 1.5 + 0.1 * x), 0.2, (vx, 1.0), elasticity=0.8))
    return world
