"""Recorded runs that pages are made of."""

from functools import cache
from math import pi

import carom
from carom import Recording

NASTY = "</script ></script><b>bold</b> <!-- & \N{LINE SEPARATOR} \"quoted\" '{{script}}' \N{HEAVY BLACK HEART}"


def furnished() -> carom.World:
    """A room with one of everything: each layer has something to show within a second."""
    world = carom.World(gravity=(0.0, -4.0))
    for start, end in (((0, 0), (12, 0)), ((12, 0), (12, 8)), ((0, 8), (0, 0))):
        world.add(carom.Segment(start, end, name="wall"))
    world.add(carom.Arc((6.0, 5.0), 3.0, 0.1 * pi, 0.9 * pi, name="arch"))
    world.add(carom.Circle((9.0, 3.0), 0.8, solid=True, elasticity=1.2, name="bumper"))
    world.add(carom.Gate((3.0, 2.0), (3.0, 4.0), direction=(1, 0), name="gate"))
    world.add(carom.Segment((4.0, 1.0), (8.0, 1.0), sensor=True, name="sensor"))
    world.add(carom.Segment((5.0, 3.0), (7.0, 3.0), motion="kinematic", angular_velocity=1.0, name="paddle"))
    world.add(carom.Point((10.5, 6.0), name="post"))
    for place, velocity in enumerate(((3.0, 2.0), (-2.0, 3.0), (5.0, -2.0), (0.5, -4.0))):
        world.add(carom.Ball((1.5 + 2.7 * place, 1.6), radius=0.35, velocity=velocity, name=f"ball {'abcd'[place]}"))
    return world


@cache
def furnished_run() -> Recording:
    """Two seconds of the furnished room."""
    return Recording.of(furnished(), 2.0, name="Furnished", about="A room with one of everything.")


@cache
def nasty_run() -> Recording:
    """A run whose names try to be more than text."""
    world = carom.World()
    world.add(carom.Segment((0, 0), (4, 0), name=NASTY))
    world.add(carom.Ball((2, 1), radius=0.3, velocity=(0, -4), name=NASTY))
    return Recording.of(world, 0.5, name=NASTY, about=NASTY)


@cache
def changing_run() -> Recording:
    """A target that drops at frame 10 and rises at frame 20; a ball that leaves at 15, one that comes at 25."""
    world = carom.World(broad_phase="brute")
    target = world.add(carom.Segment((0, 0), (4, 0), name="target"))
    world.add(carom.Ball((3, 1), radius=0.4))
    leaves = world.add(carom.Ball((1, 1), radius=0.4))
    recorder = carom.Recorder(world)
    for frame in range(1, 31):
        if frame == 15:
            world.remove(leaves)
        if frame == 25:
            world.add(carom.Ball((2, 1), radius=0.4))
        target.can_collide = not 10 <= frame < 20
        recorder.note(world.step(0.1))
    return recorder.finish()


@cache
def sleepy_run() -> Recording:
    """A ball that rolls and one that falls asleep on the floor."""
    world = carom.World(gravity=(0.0, -10.0), sleep_speed=0.1, sleep_time=0.2)
    world.add(carom.Segment((0, 0), (9, 0), elasticity=0.0))
    world.add(carom.Ball((1, 0.4), radius=0.4))
    world.add(carom.Ball((3, 0.4), radius=0.4, velocity=(2, 0)))
    return Recording.of(world, 1.0)


@cache
def bare_runs() -> dict[str, Recording]:
    """Runs that lack what most have, or lie where few do."""
    alone = carom.World()
    alone.add(carom.Ball((1, 2), radius=0.5, velocity=(3, 1)))
    still = carom.World()
    still.add(carom.Point((0, 0)))
    far = carom.World(gravity=(0.0, -1.0))
    far.add(carom.Segment((1e6, 1e6), (1e6 + 1, 1e6)))
    far.add(carom.Ball((1e6 + 0.5, 1e6 + 0.3), radius=0.1))
    lost = carom.World()
    lost.add(carom.Segment((0, 0), (1, 0)))
    lost.add(carom.Ball((0, 1), radius=0.1, velocity=(1e9, 0)))
    tree = furnished()
    tree.broad_phase = "quadtree"
    return {
        "nothing": Recording.of(carom.World(), 0.0),
        "nothing, for a while": Recording.of(carom.World(), 0.1),
        "a ball alone": Recording.of(alone, 0.5),
        "shapes alone": Recording.of(still, 0.1),
        "far away": Recording.of(far, 0.5),
        "a ball that is lost": Recording.of(lost, 0.5),
        "a quadtree": Recording.of(tree, 0.1),
    }
