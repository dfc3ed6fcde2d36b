"""A ball comes to rest in a bowl, and keeps its energy in another.
================================================================

Two equal bowls, each one arc. In the left one nothing is lost, and the ball goes on for ever. The right one gives a
bounce half its speed back: the ball hops, then slides, to and fro and without friction, as a pendulum does.
"""

from math import pi
from pathlib import Path

import matplotlib.pyplot as plt

import carom
from carom import draw
from carom.study import plots

_, panels = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
world = carom.World(gravity=(0, -9.8))
for middle, elasticity, axes in ((0, 1.0, panels[0]), (5, 0.5, panels[1])):
    alone = carom.World(gravity=(0, -9.8))
    for place in (alone, world):
        place.add(carom.Arc((middle, 0), 2.0, pi, 2 * pi, elasticity=elasticity))
        place.add(carom.Ball((middle - 1.4, -0.2), radius=0.2))
    run = carom.Recording.of(alone, seconds=6)
    plots.energy(run, axes).set_title(f"elasticity {elasticity}")
    print(f"elasticity {elasticity}: {len(run.hits)} hits, energy less by {run.energy()[0] - run.energy()[-1]:.6f}")

trace = draw.Trace(world)
for _ in range(360):
    trace.note(world.step(1 / 60))
picture = draw.picture_of(world, "Bowls", trace=trace, size=760)
Path("bowl.svg").write_text(draw.svg(picture), encoding="utf-8")
plt.show()
