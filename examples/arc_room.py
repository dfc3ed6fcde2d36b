"""A round room is no polygon.
===========================

An elastic ball in a circle keeps its angular momentum, so it never comes near the middle: its ways all touch one
inner circle. In a polygon every bounce changes it a little, and the ball finds its way in, sooner where the sides are
few. The left room is made of two true arcs, the middle one of 12 segments, the right one of 64.
"""

from math import cos, pi, sin
from pathlib import Path

import carom
from carom import draw

RADIUS = 2.0


def polygon(x: float, sides: int) -> list[carom.Segment]:
    """The walls of a room with corners on the circle about (x, 0)."""
    corners = [(x + RADIUS * cos(2 * pi * k / sides), RADIUS * sin(2 * pi * k / sides)) for k in range(sides)]
    return [carom.Segment(corners[k - 1], corners[k]) for k in range(sides)]


world = carom.World()
arcs = [carom.Arc((0, 0), RADIUS, 0, pi), carom.Arc((0, 0), RADIUS, pi, 2 * pi)]
assert carom.guard_points(arcs) == []  # the arcs continue each other
for wall in (*arcs, *polygon(5, 12), *polygon(10, 64)):
    world.add(wall)
balls = [world.add(carom.Ball((x + 1.2, 0), radius=0.1, velocity=(1, 8))) for x in (0, 5, 10)]


def momenta() -> list[float]:
    """Each ball's angular momentum about the middle of its room."""
    middles = zip(balls, (0, 5, 10), strict=True)
    return [(b.position[0] - x) * b.velocity[1] - b.position[1] * b.velocity[0] for b, x in middles]


before = momenta()
trace = draw.Trace(world)
for _ in range(600):
    trace.note(world.step(1 / 60))
for words, first, last in zip(("arcs", "12 sides", "64 sides"), before, momenta(), strict=True):
    print(f"{words:>8}: angular momentum {first:.6f}, after ten seconds {last:.6f}")

picture = draw.picture_of(world, "Round rooms", trace=trace, size=760)
Path("arc_room.svg").write_text(draw.svg(picture), encoding="utf-8")
