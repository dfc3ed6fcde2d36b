"""What goes in at one end comes out at the other.
===============================================

Newton's cradle, lying down: a ball runs into a row of balls that touch. The blow goes through them within one moment,
as a chain of impacts in order; the last ball leaves, comes back from the wall, and the blow returns.
"""

import matplotlib.pyplot as plt

import carom

BALLS = 5

world = carom.scenes.newtons_cradle(balls=BALLS).build()
run = carom.Recording.of(world, seconds=5)

_, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for ball in range(BALLS):
    axes.plot(run.times, run.positions[:, ball, 0], linewidth=2)
axes.set_xlabel("time in s")
axes.set_ylabel("where each ball is, in lengths")
axes.set_title("Newton's cradle")

energy = run.kinetic_energy()
print(f"{len(run.hits)} hits; energy {energy[0]:.12f} before, {energy[-1]:.12f} after")
plt.show()
