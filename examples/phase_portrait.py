"""A phase portrait in ten lines.
==============================

Each dot is a hit on the wall of a mushroom: how far along the wall, and the sine of the angle at which the ball came.
Orbits that never leave the cap draw curves and rows of dots; the others share one sea.
"""

from math import acos, sqrt

import matplotlib.pyplot as plt

import carom
from carom import study
from carom.study import plots

mushroom = carom.scenes.mushroom(radius=2.0, width=1.6, height=2.0)
found = study.boundary_map(mushroom, n=40, hits=120, seed=2)
plots.boundary_map(found).set_title("Order and chaos in a mushroom")
plt.show()

# %%
# What the sea holds is known: the orbits that come into the stem. Starts are uniform, so their share is one of areas.

cap = (4.0 * acos(0.4) - 0.8 * sqrt(4.0 - 0.64)) / found.table.area
stem = study.section(mushroom, cut=((0.8, 0.0), (-0.8, 0.0)), n=400, hits=100, seed=2)
order = 1.0 - len(set(stem.orbit.tolist())) / 400
print(f"{order:.3f} of 400 orbits stay in the cap; {cap:.3f} would in the long run")
