"""A gas forgets how it began.
===========================

Four hundred discs start with one speed in all directions. After some impacts each their speeds follow Maxwell's law,
which for discs in the plane is a Rayleigh distribution; energy stays the same all the while.
"""

import matplotlib.pyplot as plt
import numpy as np

import carom
from carom.study import plots

SPEED = 7.5

world = carom.scenes.gas(balls=400).build()
angles = np.random.default_rng(3).uniform(0, 2 * np.pi, len(world.balls))
world.balls.velocity[:] = SPEED * np.column_stack((np.cos(angles), np.sin(angles)))

begin = carom.Recording.of(world, seconds=0.05)
run = carom.Recording.of(world, seconds=10)

_, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
plots.speeds(begin, left, bins=40).set_title("In the first moment")
plots.speeds(run, right, since=4.0, bins=40).set_title("From the fourth second on")

energy = run.energy()
print(f"{len(run.hits)} hits; energy changed by {np.ptp(energy) / energy[0]:.1e} of itself")
plt.show()
