"""Fast balls and a thin wall, in both modes.
==========================================

Two hundred balls fly at a wall, each in a lane of its own and from a place of its own. The discrete mode looks for
overlaps after moving, and misses some balls once they travel more than a radius between two looks. The continuous
mode computes when they meet the wall, and misses none.
"""

import matplotlib.pyplot as plt
import numpy as np

import carom

RADIUS, BALLS = 0.5, 200
STEP = 1 / 60


def lost(travel: float, detection: str) -> float:
    """The share of balls beyond the wall, if they travel so many radii in a substep."""
    world = carom.World(detection=detection, substeps=1)
    world.add(carom.Segment((0, -1), (0, 2 * BALLS)))
    lanes = 2.0 * np.arange(BALLS)
    starts = -3 - travel * RADIUS * np.linspace(0, 1, BALLS)
    speed = travel * RADIUS / STEP
    world.add_balls(position=np.column_stack((starts, lanes)), velocity=(speed, 0), radius=RADIUS)
    world.run(seconds=STEP * (2 + 8 / travel), dt=STEP)
    return float(np.mean(world.balls.position[:, 0] > 0))


travels = np.linspace(0.25, 6, 24)
_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for detection, colour in (("discrete", "#d9480f"), ("continuous", "#1f8aa8")):
    shares = [lost(travel, detection) for travel in travels]
    axes.plot(travels, shares, "o-", color=colour, label=detection)
    print(f"{detection}: at most {max(shares):.0%} get through")
axes.set_xlabel("way of a ball in a substep, in its radii")
axes.set_ylabel("share that gets through")
axes.legend(frameon=False)
plt.show()
