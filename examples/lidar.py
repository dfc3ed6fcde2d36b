"""A thousand rays see the room.
=============================

Rays in all directions from one place of the collision toy, cast in one call. What they reach is what can be seen from
there.
"""

import matplotlib.pyplot as plt
import numpy as np

import carom

BEAMS, REACH = 1440, 100.0

world = carom.scenes.toy().build()
boxes = np.array([tuple(shape.aabb) for shape in world.shapes if not isinstance(shape, carom.Compound)])
eye = (0.5 * (boxes[:, 0].min() + boxes[:, 2].max()), 0.55 * (boxes[:, 1].min() + boxes[:, 3].max()))
angles = np.linspace(0, 2 * np.pi, BEAMS, endpoint=False)
hits = world.ray_cast(eye, eye + REACH * np.column_stack((np.cos(angles), np.sin(angles))))

_, axes = plt.subplots(figsize=(6, 6), layout="constrained")
axes.fill(*hits["point"].T, color="#1f8aa8", alpha=0.25)
axes.plot(*hits["point"].T, ".", color="#1f8aa8", markersize=2)
axes.plot(*eye, "o", color="#d9480f")
axes.set_aspect("equal")
axes.set(title="What is seen from one place", xlabel="x in lengths", ylabel="y in lengths")

seen = {world.object(shape).name or "something without a name" for shape in hits["shape"][hits.found].tolist()}
print(f"{hits.found.sum()} of {BEAMS} beams end on something; the nearest after {REACH * hits['fraction'].min():.2f}")
print("seen:", *sorted(seen), sep="\n  ")
plt.show()
