"""What a picture can show.
========================

A picture is made of layers, each of which can be switched on: on the command line by ``--layers hits,tracks``, in
Python by ``layers``. Here each is shown by itself, over the shapes and balls of a small table, in the order of the
list below.
"""

from math import pi
from pathlib import Path

import carom
from carom import draw
from carom.draw import Layer

world = carom.World(gravity=(0, -6))
dome = carom.Arc((4, 3), 4.0, 0, pi, name="dome")
walls = [carom.Segment((0, 3), (0, 0)), carom.Segment((8, 3), (8, 0)), carom.Segment((0, 0), (8, 0))]
ramp = carom.Segment((0, 2.6), (2.4, 1.6), name="ramp")
bumper = carom.Circle((5.2, 4.6), 0.7, solid=True, kick=2.0, name="bumper")
gate = carom.Gate((5.6, 1.6), (8, 1.6), direction=(0, -1), name="gate")
sensor = carom.Segment((2.4, 3.4), (4.2, 4.2), sensor=True, name="sensor")
wheel = carom.Segment((3.4, 0.8), (5, 0.8), motion="kinematic", angular_velocity=2.0, name="wheel")
for shape in (dome, *walls, ramp, bumper, gate, sensor, wheel, *carom.guard_points([dome, *walls, ramp, wheel])):
    world.add(shape)
for x, y in ((1.0, 4.5), (4.0, 6.3), (6.8, 4.0)):
    world.add(carom.Ball((x, y), radius=0.25, velocity=(2, 0)))
run = carom.Recording.of(world, seconds=1.1)

base = {Layer.SHAPES, Layer.SENSORS, Layer.BALLS}
shown = [layer for layer in Layer if layer not in base]
for number, layer in enumerate(shown):
    print(f"{number + 1:2}. {layer.value}")
    picture = draw.picture_at(run, layers=base | {layer}, size=460)
    Path(f"layers-{number:02}-{layer.value}.svg").write_text(draw.svg(picture), encoding="utf-8")
