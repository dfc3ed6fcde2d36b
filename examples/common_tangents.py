"""A belt is made of common tangents.
==================================

Where a belt runs round pulleys it is straight between them, along their common tangents, and round on them. The same
lines and arcs make a room without a single corner: no end of it needs a guard point.
"""

from math import atan2
from pathlib import Path

import carom
from carom import draw

PULLEYS = [carom.Circle((0, 0), 1.6), carom.Circle((2.6, 3.6), 0.7), carom.Circle((7, 0.6), 1.1)]  # clockwise


def angle(pulley: carom.Circle, place: tuple[float, float]) -> float:
    """The direction of a place from a pulley's middle."""
    return atan2(place[1] - pulley.center[1], place[0] - pulley.center[0])


def on(pulley: carom.Circle, tangent: carom.Segment) -> tuple[float, float]:
    """The end of a tangent that touches a pulley."""
    return min(tangent.p0, tangent.p1, key=pulley.distance)


tangents = [one.common_tangent(PULLEYS[(k + 1) % 3]) for k, one in enumerate(PULLEYS)]
rounds = []
for k, pulley in enumerate(PULLEYS):
    leaves, arrives = on(pulley, tangents[k]), on(pulley, tangents[k - 1])
    rounds.append(carom.Arc(pulley.center, pulley.radius, angle(pulley, leaves), angle(pulley, arrives)))

belt = [*tangents, *rounds]
assert carom.guard_points(belt) == []
length = sum(part.length for part in belt)
print(f"the belt is {length:.3f} long")

# %%
# Three balls in that room, without gravity or loss.

world = carom.World()
for part in belt:
    world.add(part)
for x, y in ((0, 0), (3, 1.5), (6, 0.5)):
    world.add(carom.Ball((x, y), radius=0.2, velocity=(3, 2)))
trace = draw.Trace(world)
for _ in range(360):
    trace.note(world.step(1 / 60))
picture = draw.picture_of(world, "Belt", trace=trace, size=640)
Path("common_tangents.svg").write_text(draw.svg(picture), encoding="utf-8")
