"""Breakout in fifty lines.
========================

A brick is a group of four walls and four corners, which switches itself off at the first bounce off any of its parts.
The paddle is an arc, so where the ball meets it says where it goes; here a hand that is never quite steady holds it. In
a window of pygame the mouse would.
"""

from math import copysign, pi, sin
from pathlib import Path

import carom
from carom import draw, outlines

WIDTH, HEIGHT, FRAME = 12.0, 14.0, 1 / 60
FASTEST = 40.0  # units a second; a hand is not faster

world = carom.World(max_speed=12.0)
world.add(*outlines.polyline([(0, -2), (0, HEIGHT), (WIDTH, HEIGHT), (WIDTH, -2)]))
for line in range(4):
    for column in range(5):
        left, bottom = 0.5 + 2.25 * column, 8.0 + 1.25 * line
        sides = outlines.rectangle(left, bottom, left + 2, bottom + 1)
        world.add(carom.Group(sides, once=True, name=f"brick {line} {column}"))
bat = world.add(carom.Arc((WIDTH / 2, -1), 2.0, pi / 3, 2 * pi / 3, motion="kinematic", name="bat"))
ball = world.add(carom.Ball((6, 5), 0.25, velocity=(2, -9)))
bricks = [shape for shape in world.shapes if isinstance(shape, carom.Group)]


def follow(mouse_x: float) -> None:
    """Send the paddle to the mouse, within the table, as fast as a hand."""
    x = min(max(mouse_x, 1.0), WIDTH - 1.0)
    way = x - bat.position[0]
    if abs(way) > FASTEST * FRAME:
        x = bat.position[0] + copysign(FASTEST * FRAME, way)
    bat.move_to((x, -1.0), FRAME)


score, trace = 0, draw.Trace(world)
for number in range(10 * 60):
    follow(ball.position[0] + 0.6 * sin(number / 25))
    hits = world.step(FRAME)
    trace.note(hits)
    score += sum(10 for hit in hits if hit.shape.group is not None)
standing = sum(brick.can_collide for brick in bricks)
print(f"{score} points after {world.time:.0f} s; {standing} of {len(bricks)} bricks stand")
picture = draw.picture_of(world, "Breakout", trace=trace, size=760)
Path("breakout.svg").write_text(draw.svg(picture), encoding="utf-8")
