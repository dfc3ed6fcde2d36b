"""Order and chaos on one boundary.
=================================

A table's *boundary map* marks each hit of a ball by how far along the wall it was and by the sine of its angle of
incidence. In a stadium, two half circles joined by straights, one ball fills the map like dust, the ways straight up
and down between the straights last. In a round room every ball keeps its angle: a line.
"""

from math import pi

import matplotlib.pyplot as plt

import carom


def boundary_map(outline: list[carom.Shape], hits: int = 2000) -> tuple[carom.World, carom.Hits]:
    """A world with one small ball inside an outline, and its first hits."""
    world = carom.World()
    world.add(*outline)
    world.add(carom.Ball((0.2, 0.1), radius=0.01, velocity=(0.6, 0.8)))
    return world, world.run(seconds=1e6, dt=10, until=hits)


stadium = [
    carom.Segment((-1, -1), (1, -1)),
    carom.Arc((1, 0), 1, -pi / 2, pi / 2),
    carom.Segment((-1, 1), (1, 1)),
    carom.Arc((-1, 0), 1, pi / 2, -pi / 2),
]
room = [carom.Circle((0, 0), 1.5)]

# %%
# `until` ends the runs after so many hits; `boundary` makes arrays of them.

figure, both = plt.subplots(2, sharey=True, layout="constrained")
for axes, outline, title in zip(both, (stadium, room), ("stadium", "round room"), strict=True):
    world, hits = boundary_map(outline)
    on_outline, arc_length, sine = hits.boundary(outline)
    print(f"{title}: {len(sine)} hits, sines from {sine.min():.6f} to {sine.max():.6f}")
    axes.plot(arc_length, sine, ".", markersize=2)
    axes.set(title=title, xlabel="arc length in lengths", ylabel="sine of the angle of incidence", ylim=(-1, 1))
plt.show()
