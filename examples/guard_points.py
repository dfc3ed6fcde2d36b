"""A bare end needs a guard point.
===============================

Three balls fall on each of two shelves: on its middle, on its end, and just past it. The left shelf has bare ends.
There the ball at the end is met only when its centre is over the shelf, and the last one falls past, through the very
end. The right shelf has a point at each end, as ``guard_points`` makes them, and the balls bounce off it to the side.
"""

from pathlib import Path

import carom
from carom import draw

world = carom.World(gravity=(0, -9.8))
bare = carom.Segment((-3, 0), (0, 0), elasticity=0.6, name="bare shelf")
guarded = carom.Segment((3, 0), (6, 0), elasticity=0.6, name="guarded shelf")
for shape in (bare, guarded, *carom.guard_points([guarded])):
    world.add(shape)
corners = [(-4, -2), (8, -2), (8, 2.6), (-4, 2.6)]
for k in range(4):
    world.add(carom.Segment(corners[k - 1], corners[k], elasticity=0.3, name="room"))

for shelf in (bare, guarded):
    for past_the_end in (-1.5, -0.1, 0.15):
        start = (shelf.p1[0] + past_the_end, 1.8)
        world.add(carom.Ball(start, radius=0.3, velocity=(0.1, 0), layer=2, collides_with=1))  # not with each other

trace = draw.Trace(world)
met: dict[bool, set[carom.Ball]] = {False: set(), True: set()}
for _ in range(75):
    hits = world.step(1 / 60)
    trace.note(hits)
    for hit in hits:
        if hit.point[1] > -1:  # at a shelf, not on the floor
            met[hit.point[0] > 1.5].add(hit.ball)
print(f"the bare shelf was met by {len(met[False])} of 3 balls, the guarded one by {len(met[True])}")

picture = draw.picture_of(world, "Ends", trace=trace, size=760)
Path("guard_points.svg").write_text(draw.svg(picture), encoding="utf-8")
