"""A world that a scene can say all of."""

from typing import Any

import carom


def flipper(**options: Any) -> carom.Compound:
    """A compound of a circle and a segment."""
    parts = [carom.Circle((0, 0), 0.5), carom.Segment((0, 0.5), (3, 0.25), elasticity=0.5, name="edge")]
    return carom.Compound(parts, (0, 0), **options)


def world_of_everything() -> carom.World:
    """A world with every kind of shape, at rest and turned, and with settings of its own."""
    world = carom.World(gravity=(0, -1), bounds=carom.Aabb(-9, -9, 9, 9), broad_phase="brute", max_speed=5)
    world.add(carom.Point((1, 2), name="post", kick=2.0, once=True))
    world.add(carom.Segment((4, 0), (0, 0), elasticity=0.25, layer=2, collides_with=3))
    world.add(carom.Gate((0, 5), (0, 7), direction=(1, 0)))
    world.add(carom.Circle((-5, -5), 1.0, solid=True, sensor=True))
    world.add(carom.Arc((5, 5), 1.5, 1.0, 6.0, can_collide=False))
    world.add(carom.Segment((-2, 1), (-1, 1), motion="kinematic", angular_velocity=0.5, turn_limits=(-1, 1)))
    world.add(carom.Arc((-5, 5), 1.0, 0.0, 2.0, motion="kinematic", pivot=(-4, 5), velocity=(0.5, 0.25)))
    world.add(flipper(angular_velocity=3.0, turn_limits=(0, 0.75), name="flipper"))
    world.add(carom.Group([carom.Segment((6, -5), (7, -5), kick=1.0), carom.Point((7, -5))], once=True, name="brick"))
    world.add(carom.Ball((0.5, -3.0), 0.25, velocity=(1, 0), mass=2.0, name="cue"))
    world.add_balls([[-3.0, -3.0], [-3.0, -2.0]], radius=0.125)
    return world
