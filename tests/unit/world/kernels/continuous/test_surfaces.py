"""Shapes that move, seen from the ball and from their own frame: places, velocities, gaps, times of impact."""

from math import cos, hypot, sin

import numpy as np
import pytest

from carom import Arc, Circle, Point, Segment, Shape
from carom.geometry.path import Path
from carom.rows.flight import FLIGHT
from carom.rows.kinds import gap_at_rest
from carom.rows.pose import surface_velocity
from carom.world.kernels.continuous.surfaces import (
    age_of_motion,
    center_of_bend,
    gap_to_shape,
    impact_in_motion,
    into_frame,
    out_of_frame,
)

MOVING = {"motion": "kinematic", "pivot": (0.5, -0.5), "velocity": (1.5, -0.5), "angular_velocity": 2.0}


def shapes() -> list[Shape]:
    """A shape of each kind that travels and turns."""
    made: list[Shape] = [
        Point((1, 1), **MOVING),
        Segment((-1, 0), (2, 1), **MOVING),
        Circle((1, 1), 0.7, **MOVING),
        Arc((1, 1), 1.2, 0.3, 3.0, **MOVING),
    ]
    for shape in made:
        shape._row["spin"] = 2.0
    return made


SHAPES = pytest.mark.parametrize("kind", range(4))


def test_a_place_in_the_frame_of_a_shape_turns_and_travels_with_it() -> None:
    row = shapes()[0]._row
    for time in (0.0, 0.4, 1.7):
        c, s = cos(2 * time), sin(2 * time)
        px, py = 0.5 + 1.5 * time, -0.5 - 0.5 * time
        x, y = out_of_frame(row, time, 3.5, 1.5)
        assert (x, y) == pytest.approx((px + 3 * c - 2 * s, py + 3 * s + 2 * c))
        assert into_frame(row, time, x, y) == pytest.approx((3.5, 1.5))
        step = 1e-6
        near = np.subtract(out_of_frame(row, time + step, 3.5, 1.5), out_of_frame(row, time - step, 3.5, 1.5))
        assert surface_velocity(row, 2.0, x, y, time) == pytest.approx(near / (2 * step), abs=1e-6)


def test_the_surface_of_a_shape_at_rest_does_not_move() -> None:
    assert surface_velocity(Point((1, 1))._row, 0.0, 3.0, 4.0, 0.5) == (0.0, 0.0)


@pytest.mark.parametrize("age", [0.0, 0.4, -1.3])
def test_the_centre_of_what_is_bent_moves_with_it(age: float) -> None:
    point, segment, circle, arc = shapes()
    for shape in (point, circle, arc):
        assert center_of_bend(shape._row, age) == out_of_frame(shape._row, age, 1.0, 1.0)
    assert center_of_bend(segment._row, age) is None
    assert center_of_bend(Circle((3, 4), 1)._row, age) == (3, 4)


@SHAPES
@pytest.mark.parametrize("age", [0.0, 0.4, -1.3])
def test_a_gap_is_that_in_the_frame_in_which_the_shape_stands_still(kind: int, age: float) -> None:
    row = shapes()[kind]._row
    for angle in np.linspace(0, 6, 13):
        x, y = 1 + 2 * cos(angle), 1 + 2 * sin(angle)
        moved = out_of_frame(row, age, x, y)
        still, seen = gap_at_rest(row, x, y, 0.3, 0.0, 0.0, 6e-10), gap_to_shape(row, age, *moved, 0.3, 0.0, 0.0)
        assert (still is None) == (seen is None)
        if still is not None and seen is not None:
            assert seen[0] == pytest.approx(still[0], abs=1e-12)
            c, s = cos(2 * age), sin(2 * age)
            expected = still[1] * c - still[2] * s, still[1] * s + still[2] * c
            assert abs(seen[1:][0] * expected[0] + seen[1:][1] * expected[1]) == pytest.approx(1.0)


def test_the_age_of_a_motion_counts_from_its_beginning_to_the_flight_s() -> None:
    row, flight = shapes()[0]._row, np.zeros(1, FLIGHT)[0]
    row["since"], row["since_low"], flight["time"], flight["low"] = 1e9, 1e-9, 1e9, 3e-9
    assert age_of_motion(row, flight) == pytest.approx(2e-9, rel=1e-9)
    assert age_of_motion(Point((1, 1))._row, flight) == 0.0


@SHAPES
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_ball_touches_where_the_gap_closes_forwards_and_back_in_time(kind: int, sign: float) -> None:
    row, radius, seen = shapes()[kind]._row, 0.4, 0
    for angle in np.linspace(0, 6, 25):
        to_x, to_y = out_of_frame(row, 0.6 + sign * 0.5, 1.0, 1.0)
        x, y, ay = to_x + 4 * cos(angle), to_y + 4 * sin(angle), -1.0
        vx, vy = 2 * (to_x - x), 2 * (to_y - y)
        found = impact_in_motion(row, 0.6, Path(x, y, vx, vy, 0.0, ay), radius, 1.0, sign)
        if found is None:
            continue
        seen += 1
        for share in (0.5, 0.9, 1.0):
            delay = share * found
            at = x + vx * delay, y + vy * delay + 0.5 * ay * delay**2
            wx, wy = sign * vx, sign * (vy + ay * delay)
            gap = gap_to_shape(row, 0.6 + sign * delay, *at, radius, wx, wy)
            assert gap is None or gap[0] > 0.0 or share == 1.0
        assert gap is not None
        assert gap == pytest.approx((0.0, gap[1], gap[2]), abs=1e-7)
        assert hypot(gap[1], gap[2]) == pytest.approx(1.0)
        ux, uy = surface_velocity(row, 2.0, *at, 0.6 + sign * found)
        assert sign * ((wx - ux) * gap[1] + (wy - uy) * gap[2]) < 1e-6
    assert seen > 4
