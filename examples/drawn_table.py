"""A table that was drawn.
=======================

What Inkscape, Illustrator or a text editor draws is a scene. Red bumpers kick, a ramp of one Bézier curve becomes arcs
without a bend, a group with a pivot is a flipper, and a circle is the ball. The page "Draw a table in Inkscape and
play it" tells the rest. Needs ``pip install "carom[drawings]"``.
"""

from pathlib import Path

import carom
from carom import draw

DRAWING = """\
<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100"
     fill="none" stroke="black" data-carom-gravity="0 -40" data-carom-detection="continuous">
  <rect id="frame" x="5" y="5" width="190" height="90" rx="20"/>
  <circle id="left" cx="75" cy="35" r="10" fill="red" data-carom-kick="20"/>
  <circle id="right" cx="125" cy="35" r="10" fill="red" data-carom-kick="20"/>
  <path id="ramp" d="M 12 70 C 40 70 50 92 80 92"/>
  <g id="flipper" data-carom-pivot="120 80" data-carom-angular-velocity="3" data-carom-turn-limits="0 0.8">
    <line x1="120" y1="80" x2="150" y2="85"/>
  </g>
  <circle id="ball" cx="60" cy="30" r="3" data-carom-ball="" data-carom-velocity="90 30"/>
</svg>
"""

Path("table.svg").write_text(DRAWING, encoding="utf-8")
world = carom.Scene.load("table.svg").build()
kinds = [shape.kind for shape in world.shapes]
print(f"{len(DRAWING.splitlines())} lines are {len(kinds)} shapes, {kinds.count('arc')} of them arcs")

trace = draw.Trace(world)
met = set()
for _ in range(10 * 60):
    hits = world.step(1 / 60)
    trace.note(hits)
    met |= {hit.shape.name for hit in hits}
print(f"In ten seconds the ball meets {', '.join(sorted(met))}")
picture = draw.picture_of(world, "A drawn table", trace=trace, size=760)
Path("drawn_table.svg").write_text(draw.svg(picture), encoding="utf-8")
