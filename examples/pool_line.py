"""Aiming shows where both balls will go.
======================================

``aim`` follows a ball to its next impact, and says how both leave. Here it looks for the direction in which the cue
ball sends another one to a pocket, with a cushion of balls in the way; then the shot is played.
"""

from math import atan2, cos, sin
from pathlib import Path

import numpy as np

import carom
from carom import draw

world = carom.World(friction=0.6)
corners = [(0, 0), (8, 0), (8, 4), (0, 4)]
for k in range(4):
    world.add(carom.Segment(corners[k - 1], corners[k], elasticity=0.8))
pocket = (7.6, 3.6)
world.add(carom.Circle(pocket, 0.3, sensor=True, solid=True, name="pocket"))
cue = world.add(carom.Ball((1.2, 1.0), radius=0.15, name="cue ball"))
target = world.add(carom.Ball((4.6, 2.2), radius=0.15, name="target"))
for place in ((3.0, 2.6), (5.6, 1.2), (6.2, 1.9)):
    world.add(carom.Ball(place, radius=0.15))

directions = np.linspace(-0.1, 0.8, 20_001)
lines = world.aim(cue, np.column_stack((np.cos(directions), np.sin(directions))))  # all at once
wanted = atan2(pocket[1] - target.position[1], pocket[0] - target.position[0])
on_target = lines["shape"] == target.id
turned = np.arctan2(lines["other_direction"][:, 1], lines["other_direction"][:, 0])
best = int(np.argmin(np.where(on_target, np.abs(turned - wanted), np.inf)))
line = lines[best]
print(f"aim at {np.degrees(directions[best]):.2f}°: the target leaves along {np.degrees(turned[best]):.2f}°")
print(f"the pocket is at {np.degrees(wanted):.2f}°; the ghost ball at ({line.ghost[0]:.3f}, {line.ghost[1]:.3f})")

cue.velocity = (7 * cos(directions[best]), 7 * sin(directions[best]))
trace = draw.Trace(world)
for _ in range(150):
    hits = world.step(1 / 60)
    trace.note(hits)
    for hit in hits:
        if hit.kind is carom.HitKind.ENTER and hit.ball is target:
            print(f"in the pocket after {hit.time:.2f} s")
picture = draw.picture_of(world, "A shot", trace=trace, size=760)
Path("pool_line.svg").write_text(draw.svg(picture), encoding="utf-8")
