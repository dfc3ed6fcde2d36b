"""When a ball in flight, or a moved circle, first touches a shape of every kind, at rest or in motion."""

from math import cos, sin

import pytest

from carom.geometry.path import Path, Turning
from carom.rows import kinds_in_motion
from tests.unit.rows.samples import KINDS, NEAR, RADIUS, SAMPLES, first_moment, row_of, thrown


@KINDS
def test_a_ball_touches_when_its_way_comes_within_its_radius(kind: str) -> None:
    x, y, vx, vy = thrown(kind)
    for ax, ay in ((0.0, 0.0), (0.3, -0.4)):
        moment = first_moment(
            kind, lambda t, a=(ax, ay): (x + (vx + 0.5 * a[0] * t) * t, y + (vy + 0.5 * a[1] * t) * t)
        )
        found = kinds_in_motion.impact_at_rest(row_of(kind), Path(x, y, vx, vy, ax, ay), RADIUS, 1.0)
        assert found == pytest.approx(moment, abs=NEAR)
    assert kinds_in_motion.impact_at_rest(row_of(kind), Path(x, y, -vx, -vy, 0.0, 0.0), RADIUS, 1.0) is None


@KINDS
def test_a_ball_touches_a_shape_that_travels_and_turns_when_it_comes_within_its_radius(kind: str) -> None:
    x, y, vx, vy = thrown(kind)
    row = row_of(kind)
    px, py = float(row["pivot_x"]), float(row["pivot_y"])

    def seen(t: float, ux: float, uy: float, spin: float) -> tuple[float, float]:
        dx, dy = x + vx * t - px - ux * t, y + vy * t - py - uy * t
        c, s = cos(spin * t), sin(spin * t)
        return px + c * dx + s * dy, py - s * dx + c * dy

    for ux, uy, spin in ((0.2, -0.1, 0.0), (0.1, 0.2, 0.3)):
        moment = first_moment(kind, lambda t, u=(ux, uy, spin): seen(t, *u))
        turning, path = Turning(px, py, ux, uy, spin), Path(x, y, vx, vy, 0.0, 0.0)
        found = kinds_in_motion.impact_in_frame(row, turning, path, RADIUS, 1.0)
        assert found == pytest.approx(moment, abs=NEAR)


@KINDS
def test_a_moved_circle_stops_where_it_touches_and_a_gate_only_from_its_closed_side(kind: str) -> None:
    _, (px, py), (nx, ny) = SAMPLES[kind]
    x, y, dx, dy = thrown(kind)
    share = first_moment(kind, lambda t: (x + dx * t, y + dy * t))
    found = kinds_in_motion.ray_shape(row_of(kind), x, y, RADIUS, dx, dy)
    assert found == pytest.approx((share, px, py, nx, ny), abs=NEAR)
    behind = kinds_in_motion.ray_shape(row_of(kind), px - 2.0 * nx, py - 2.0 * ny, RADIUS, -dx, -dy)
    assert (behind is None) == (kind == "gate")
