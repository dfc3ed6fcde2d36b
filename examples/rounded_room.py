"""A rounded room with an ellipse in it.
=====================================

The walls are outlines: a rectangle whose corners are arcs, and an ellipse as tangent arcs that lie within a thousandth
of it. Nothing of either has a corner, so neither needs a guard point. Twenty balls start side by side, and the ellipse
and the corners scatter them; nobody loses any speed.
"""

from math import cos, pi, sin
from pathlib import Path

import carom
from carom import draw, outlines

world = carom.World()
room = outlines.rectangle(-6, -3.5, 6, 3.5, corner=1.5, name="room")
ellipse = outlines.fit(lambda t: (2.2 * cos(2 * pi * t), 1.2 * sin(2 * pi * t)), 1e-3, name="ellipse")
world.add(*room, *ellipse)
for k in range(20):
    world.add(carom.Ball((-5 + 0.02 * k, -2.0 + 0.2 * k), radius=0.04, velocity=(3, 0.4), layer=2, collides_with=1))

trace = draw.Trace(world)
for _ in range(60):
    trace.note(world.step(1 / 60))
speeds = (world.balls.velocity**2).sum(axis=1) ** 0.5
print(f"{len(room)} shapes of a room and {len(ellipse)} arcs of an ellipse; the slowest ball has {speeds.min():.12f}")

picture = draw.picture_of(world, "A rounded room", trace=trace, size=760)
Path("rounded_room.svg").write_text(draw.svg(picture), encoding="utf-8")
