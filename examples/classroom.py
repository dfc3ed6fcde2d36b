"""Sliders for a lesson.
=====================

A ball that is thrown into a room, four sliders and a player: in a notebook ``panel`` shows them. A slider that is moved
throws the ball anew, in the same picture; no page is made, and no cell is run again. The program moves one itself, to
see at which angle a ball flies farthest. ``pip install "carom[docs]"`` brings ipywidgets.
"""

from math import cos, radians, sin
from pathlib import Path

import ipywidgets as widgets

import carom
from carom import draw, outlines


def thrown(speed: float, angle: float, gravity: float, elasticity: float) -> carom.Recording:
    """The run of a ball that is thrown, at an angle in degrees."""
    world = carom.World(gravity=(0, -gravity))
    world.add(*outlines.rectangle(0, 0, 14, 7, elasticity=elasticity))
    velocity = (speed * cos(radians(angle)), speed * sin(radians(angle)))
    world.add(carom.Ball((0.2, 0.2), radius=0.2, velocity=velocity))
    return carom.Recording.of(world, 4.0, name="Throw", about=f"At {speed:g} m/s and {angle:g} degrees.")


ranges = {"speed": (10, 1, 20), "angle": (60, 0, 90), "gravity": (9.8, 0, 25), "elasticity": (0.8, 0, 1)}
sliders = {
    name: widgets.FloatSlider(value, min=low, max=high, description=name) for name, (value, low, high) in ranges.items()
}
frame = widgets.Play(value=240, max=240, step=2, interval=33)  # 30 pictures a second, each two frames on
time = widgets.IntSlider(value=240, max=240, description="frame")
stage = widgets.HTML()


def show(_: object = None) -> None:
    """Draw the frame that the player is at, with the ball's way up to it."""
    stage.value = draw.svg(draw.picture_at(run, frame.value, size=760))


def throw(_: object = None) -> None:
    """Throw the ball as the sliders say."""
    global run
    run = thrown(**{name: slider.value for name, slider in sliders.items()})
    show()


for slider in sliders.values():
    slider.observe(throw, names="value")
frame.observe(show, names="value")
widgets.jslink((frame, "value"), (time, "value"))
panel = widgets.VBox([*sliders.values(), widgets.HBox([frame, time]), stage])
throw()

for angle in (30, 45, 60, 75):
    sliders["angle"].value = angle  # as a hand would
    print(f"thrown at {angle} degrees it lands after {run.hits['point'][0, 0]:.2f} m")
Path("throw.svg").write_text(stage.value, encoding="utf-8")
