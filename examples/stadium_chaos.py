"""In a stadium, ways that begin as one soon part.
===============================================

Five balls leave one place of Bunimovich's stadium in directions a thousandth of a radian apart. They do not meet each
other. Their distance grows by a constant factor from bounce to bounce until it is as large as the room, which is
chaos: the energy of each stays what it was to the last digits, and yet none can be told from the others' beginning.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import carom
from carom import draw

world = carom.scenes.stadium().build()
trace = draw.Trace(world)
for _ in range(240):
    trace.note(world.step(1 / 60))
picture = draw.picture_of(world, "Stadium", trace=trace, size=760)
Path("stadium_chaos.svg").write_text(draw.svg(picture), encoding="utf-8")

# %%
# The same from nearer: one ball, and its twin a millionth of a millionth beside it.

scene = carom.scenes.stadium()
runs = []
for shift in (0.0, 1e-12):
    world = scene.build()
    ball = world.balls[0]
    ball.position = (ball.position[0] + shift, ball.position[1])
    runs.append(carom.Recording.of(world, seconds=40))
apart = np.linalg.norm(runs[1].positions[:, 0] - runs[0].positions[:, 0], axis=1)

_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.semilogy(runs[0].times, np.maximum(apart, 1e-16), color="#1f8aa8")
axes.set_xlabel("time in s")
axes.set_ylabel("distance of the twins in lengths")
print(f"apart by a radius after {runs[0].times[np.argmax(apart > 0.08)]:.1f} s")
plt.show()
