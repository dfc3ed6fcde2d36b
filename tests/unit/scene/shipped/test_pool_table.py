"""The pool table is as large as its balls want it, its rim is one smooth line, and every pocket lets in and notices."""

from math import hypot, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom.scene.shape_descriptors import ArcDescriptor, CircleDescriptor, GateDescriptor, SegmentDescriptor
from carom.scene.shipped.pool_table import BALL_RADIUS, LENGTH, WIDTH, pool


def named(name: str) -> list[Any]:
    """The shapes of the table with a name, in their order."""
    return [shape for shape in pool().shapes if shape.name == name]


def rim() -> list[carom.Shape]:
    """The cushions and the pockets' walls, in their order."""
    return [shape.build() for shape in pool().shapes if shape.name in ("cushion", "pocket")]


def ends(part: Any) -> set[tuple[float, float]]:
    """The ends of a segment or an arc, to ten digits."""
    return {(round(x, 10), round(y, 10)) for x, y in (part.p0, part.p1)}


def test_the_rim_is_one_closed_line_that_needs_no_points() -> None:
    line = rim()
    assert carom.guard_points(line) == []
    for before, part in zip([line[-1], *line], line, strict=False):
        assert len(ends(before) & ends(part)) == 1


def test_the_noses_of_the_cushions_are_the_playing_surface() -> None:
    straight = [part for part in named("cushion") if isinstance(part, SegmentDescriptor)]
    level = [part for part in straight if part.start[1] == pytest.approx(part.end[1], abs=1e-9)]
    upright = [part for part in straight if part.start[0] == pytest.approx(part.end[0], abs=1e-9)]
    assert sorted(round(part.start[1], 9) for part in level) == [0.0, 0.0, WIDTH, WIDTH]
    assert sorted(round(part.start[0], 9) for part in upright) == [0.0, LENGTH]
    assert LENGTH == 2.0 * WIDTH
    assert {ball.radius for ball in pool().balls} == {BALL_RADIUS}


def test_each_pocket_has_a_gate_that_opens_into_it_and_a_sensor_within() -> None:
    pockets, gates = named("pocket"), named("pocket gate")
    sensors = [shape for shape in pool().shapes if isinstance(shape, CircleDescriptor) and shape.sensor]
    assert len(pockets) == len(gates) == len(sensors) == len({sensor.name for sensor in sensors}) == 6
    for pocket in pockets:
        assert isinstance(pocket, ArcDescriptor)
        x, y = pocket.center
        within = [sensor for sensor in sensors if hypot(sensor.center[0] - x, sensor.center[1] - y) < pocket.radius]
        assert len(within) == 1
        (gate,) = [gate for gate in gates if hypot(gate.start[0] - x, gate.start[1] - y) < 3.0 * pocket.radius]
        assert isinstance(gate, GateDescriptor)
        assert gate.direction is not None
        assert gate.direction[0] * (x - gate.start[0]) + gate.direction[1] * (y - gate.start[1]) > 0.0
        width = hypot(gate.end[0] - gate.start[0], gate.end[1] - gate.start[1])
        assert width > 2.0 * BALL_RADIUS, "a ball goes through"


def test_the_cue_ball_is_aimed_at_where_it_sends_the_eight_into_a_pocket() -> None:
    cue, eight = (np.array(ball.position) for ball in pool().balls)
    (way,) = [np.array(ball.velocity) for ball in pool().balls if ball.velocity != (0.0, 0.0)]
    way /= np.hypot(*way)
    # Where the cue ball touches the eight: on its way, two radii from the eight, before the place nearest to it.
    near = cue + way * (way @ (eight - cue))
    touch = near - way * sqrt((2.0 * BALL_RADIUS) ** 2 - (near - eight) @ (near - eight))
    off = (eight - touch) / np.hypot(*(eight - touch))
    (pocket,) = [np.array(shape.center) for shape in pool().shapes if shape.name == "upper right pocket"]
    to_x, to_y = pocket - eight
    assert off @ (to_x, to_y) > 0.0
    assert abs(off[0] * to_y - off[1] * to_x) < 1.0, "it passes through the pocket's sensor"
