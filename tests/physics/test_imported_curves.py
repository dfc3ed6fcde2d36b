"""A ball that rolls along an imported curve feels no joint."""

from math import hypot
from pathlib import Path

import pytest

import carom
from tests.drawings import loaded, svg

WORLD = 'width="100" height="100" data-carom-detection="continuous"'
#: An egg: an ellipse, and the same kind of room of four Bézier curves that a program wrote with three digits.
ROOMS = {
    "ellipse": '<ellipse id="room" cx="50" cy="50" rx="40" ry="20" data-carom-elasticity="0"/>',
    "curves": '<path id="room" data-carom-elasticity="0" d="M 50 70 C 72.091 70.002 90 61.046 90 50 C 90.001 38.954 '
    '72.091 30 50 30 C 27.909 29.999 10 38.954 10 50 C 9.999 61.046 27.909 70 50 70 Z"/>',
}


@pytest.mark.parametrize("room", [pytest.param("ellipse", marks=pytest.mark.slow), "curves"])
def test_a_ball_rolls_round_a_room_and_keeps_its_speed(tmp_path: Path, room: str) -> None:
    world = loaded(tmp_path, svg(ROOMS[room], WORLD)).build()
    assert {shape.kind for shape in world.shapes} == {"arc"}
    # It touches the floor and moves along it. What is not elastic would take all of any speed against it at a seam.
    ball = world.add(carom.Ball((50.0, 32.0), radius=2.0, velocity=(30.0, 0.0)))
    world.run(0.1)  # it comes to lie on the arcs, which are not the curve to the last digit
    speed = hypot(*ball.velocity)
    hits = world.run(1.9)
    assert ball.position[0] > 75.0
    assert all(hit.impulse <= 1e-9 * speed for hit in hits)
    assert hypot(*ball.velocity) == pytest.approx(speed, rel=1e-9)
