"""Going back gives the same bits again.
=====================================

A snapshot is the whole state of a world. Restored, in this process or another, the world goes on to the same bits.
Changed in the fifteenth digit of one number, it does not: in a gas every impact makes a small difference larger.
"""

import matplotlib.pyplot as plt
import numpy as np

import carom

world = carom.scenes.gas(balls=100).build()
world.run(seconds=1)
state = world.snapshot()

first = carom.Recording.of(world, seconds=8)
end = world.digest()
world.restore(state)
world.run(seconds=8)
print(f"{len(state)} bytes; the same end: {world.digest() == end}")

# %%
# The same with one ball moved by the last digits.

world.restore(state)
world.balls.position[0, 0] *= 1 + 1e-15
second = carom.Recording.of(world, seconds=8)
apart = np.linalg.norm(second.positions - first.positions, axis=2)

_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.semilogy(first.times, np.maximum(apart.max(axis=1), 1e-16), color="#d9480f", label="the farthest ball")
axes.semilogy(first.times, np.maximum(np.median(apart, axis=1), 1e-16), color="#1f8aa8", label="half of the balls")
axes.set_xlabel("time in s")
axes.set_ylabel("distance from the first run in lengths")
axes.legend(frameon=False)
plt.show()
