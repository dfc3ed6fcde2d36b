"""A ball in Sinai's billiard is everywhere as often.
==================================================

A square room round a disc: the disc spreads the ways of a ball so thoroughly that in the long run it spends the same
time in equal areas. Five balls, a thousand seconds.
"""

import matplotlib.pyplot as plt

import carom
from carom.study import plots

world = carom.scenes.sinai().build()
run = carom.Recording.of(world, seconds=1000, dt=1 / 10)
plots.heat_map(run, cells=32)
plt.show()

# %%
# What they hit.

plots.hits_by_shape(run)
print(f"{len(run.hits)} hits, {len(run.hits) / 5 / run.duration:.2f} a second for each ball")
plt.show()
