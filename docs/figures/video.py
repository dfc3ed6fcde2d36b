"""Makes half a minute of carom, six runs one after the other: `python -m docs.figures.video FILE.mp4`.

The extra `draw` brings the encoder, ffmpeg in the package imageio-ffmpeg; the file is H.264, which all browsers play.
"""

import sys
from collections.abc import Callable
from math import pi, sin
from pathlib import Path

import numpy as np

import carom
from carom import Recording, draw

SIZE = (960, 540)
LAYERS = draw.DEFAULT_LAYERS | {draw.Layer.LIGHTS}
FRAME = 1 / 60


def pinball(seconds: float) -> Recording:
    """The pinball table, whose flippers strike when a ball comes near."""
    world = carom.scenes.pinball().build()
    flippers = [world.shapes[f"{side} flipper"] for side in ("left", "right")]
    recorder = carom.Recorder(world, name="Pinball", about="Flippers, bumpers, gates, and three balls.")
    for _ in range(round(seconds / FRAME)):
        for flipper, way in zip(flippers, (1.0, -1.0), strict=True):
            near = any(flipper.distance(ball.position) < 1.2 for ball in world.balls)
            flipper.angular_velocity = way * (25.0 if near else -15.0)
        recorder.note(world.step(FRAME))
    return recorder.finish()


def breakout(seconds: float) -> Recording:
    """Breakout, its paddle under a hand that is never quite steady."""
    world = carom.scenes.breakout().build()
    paddle, ball = world.shapes["paddle"], world.balls[0]
    ball.velocity = (5.0, 34.0)
    recorder = carom.Recorder(
        world, name="Breakout", about="Bricks that are gone once they were hit, and a paddle under a hand."
    )
    for number in range(round(seconds / FRAME)):
        x = min(max(ball.position[0] + 0.9 * sin(number / 31), 2.5), 21.5)
        paddle.velocity = (float(np.clip((x - paddle.position[0]) / FRAME, -40.0, 40.0)), 0.0)
        recorder.note(world.step(FRAME))
    return recorder.finish()


def cradle(seconds: float) -> Recording:
    """Newton's cradle."""
    world = carom.scenes.newtons_cradle(balls=5).build()
    return Recording.of(world, seconds, name="Newton's cradle", about="What goes in at one end comes out at the other.")


def galton(seconds: float) -> Recording:
    """A board of pegs."""
    world = carom.scenes.galton(rows=12, balls=400).build()
    world.run(1.0)
    return Recording.of(world, seconds, name="Galton's board", about="400 balls among pegs draw the bell curve.")


def stadium(seconds: float) -> Recording:
    """A fan of balls that do not meet, in a stadium."""
    world = carom.scenes.stadium().build()
    world.remove(*world.balls)
    angles = 1.0 + 0.004 * np.arange(16)
    velocity = 6.0 * np.column_stack((np.cos(angles), np.sin(angles)))
    world.add_balls(position=np.zeros((16, 2)), velocity=velocity, radius=0.06, layer=2, collides_with=1)
    return Recording.of(world, seconds, name="Stadium", about="Ways that begin as one soon part: chaos.")


def gas(seconds: float) -> Recording:
    """Balls in a quarter of a box."""
    world = carom.World(detection="continuous")
    world.add(*carom.outlines.rectangle(0, 0, 32, 20))
    angles = 2.0 * pi * np.random.default_rng(1).random(600)
    places = np.column_stack((0.5 + 0.5 * (np.arange(600) % 30), 0.5 + 0.5 * (np.arange(600) // 30)))
    velocity = 6.0 * np.column_stack((np.cos(angles), np.sin(angles)))
    world.add_balls(position=places, velocity=velocity, radius=0.18)
    return Recording.of(world, seconds, name="A gas", about="600 elastic balls: energy stays, to the last digits.")


#: What is shown, and for how many seconds: thirty in all.
RUNS: list[tuple[Callable[[float], Recording], float]] = [
    (pinball, 9.0), (breakout, 6.0), (galton, 5.0), (cradle, 3.0), (stadium, 4.0), (gas, 3.0),
]  # fmt: skip


def films(share: float = 1.0) -> list[draw.Film]:
    """The films, or the first part of each."""
    return [
        draw.Film(run(share * seconds), layers=LAYERS, theme=draw.ThemeName.DARK, size=SIZE) for run, seconds in RUNS
    ]


if __name__ == "__main__":
    draw.write_film(films(), Path(sys.argv[1]))
