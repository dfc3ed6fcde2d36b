"""Two balls and a wall count out the digits of π.
===============================================

A heavy ball drives a light one against a wall. If it is 100 to the power of d times as heavy, the number of impacts
has the first d + 1 digits of π. With the axes stretched by the roots of the masses, energy is a circle, and each
impact a chord of it, all between balls at one angle: how many fit into half a turn is the count.

Source: G. Galperin, Playing pool with π (2003).
"""

import matplotlib.pyplot as plt
import numpy as np

import carom


def impacts(digits: int) -> carom.Recording:
    """The run in which the heavy ball comes, and goes."""
    world = carom.World()
    world.add(carom.Segment((0, -1), (0, 1), name="wall"))
    world.add(carom.Ball((3, 0), radius=0.2))
    world.add(carom.Ball((6, 0), radius=1.0, velocity=(-1, 0), mass=100.0**digits))
    return carom.Recording.of(world, seconds=60, dt=60)


for digits in range(4):
    print(f"mass 100^{digits}: {len(impacts(digits).hits)} impacts")

# %%
# The velocities before and after each of the 31 impacts, from their impulses.

hits = impacts(1).hits
velocities = [np.array([0.0, -1.0])]  # of the light ball, and of the heavy one
for impulse, normal, shape in zip(hits["impulse"], hits["normal"][:, 0], hits["shape"], strict=True):
    push = impulse * normal  # normals point from the hit's shape to its ball
    light_is_pushed = shape == hits["shape"][1]  # the second impact is the first one at the wall
    change = [push, 0.0] if light_is_pushed else [-push, push / 100.0]
    velocities.append(velocities[-1] + change)
light, heavy = np.array(velocities).T

_, axes = plt.subplots(figsize=(5, 5), layout="constrained")
axes.plot(light, 10 * heavy, "o-", color="#1f8aa8", markersize=4, linewidth=1)
axes.set_aspect("equal")
axes.set_xlabel("√m · v of the light ball in √mass · length/s")
axes.set_ylabel("√M · V of the heavy ball in √mass · length/s")
plt.show()
