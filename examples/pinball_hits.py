"""What a pinball table hits most.
===============================

A ball on the shipped pinball table for thirty seconds: which shapes it met how often, and how its energy went up and
down with bumpers and slopes.
"""

import matplotlib.pyplot as plt

import carom
from carom.study import plots

world = carom.scenes.pinball().build()
run = carom.Recording.of(world, seconds=30, name="pinball")
print(run)

plots.hits_by_shape(run, rows=10)
plt.show()

# %%
# Energy over time.

plots.energy(run)
plt.show()

# %%
# Where the balls were.

plots.heat_map(run, cells=60)
plt.show()
