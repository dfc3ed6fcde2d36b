"""A ball is where it touches, at the time found, to a few units in the last place of its flight, however long it is."""

from math import cos, inf, nextafter, sin
from typing import Any

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry.figures import CircleGeometry, SegmentGeometry
from carom.geometry.impact import impact_circle, impact_point, impact_segment
from carom.geometry.path import Path, path_after
from tests.strategies import angles

#: In units of the last place of the largest coordinate, of the shape, the flight, or what the flight is made of.
MOST = 4.0

sizes = st.floats(-3.0, 3.0).map(lambda power: 10.0**power)
speeds = st.floats(-3.0, 6.0).map(lambda power: 10.0**power)
slopes = st.one_of(st.just(1.0), st.floats(-6.0, 0.0).map(lambda power: 10.0**power))
pulls = st.one_of(st.just(0.0), st.floats(-6.0, 2.0).map(lambda power: 10.0**power))
ages = st.one_of(st.floats(-6.0, 0.0), st.floats(0.0, 9.0)).map(lambda power: 10.0**power)
places = st.one_of(st.just((0.0, 0.0)), st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6)))
kinds = st.sampled_from(("point", "segment", "disc", "circle"))
Case = tuple[str, tuple[float, float], float, float, float, Path]


@st.composite
def cases(draw: st.DrawFn) -> Case:
    """A shape about a place, of a size and turned by an angle, and a ball's radius and path that led to a touch."""
    kind, (cx, cy), size, radius, turn = draw(kinds), draw(places), draw(sizes), draw(sizes), draw(angles)
    nx, ny, away = cos(turn), sin(turn), radius
    if kind in {"disc", "circle"}:
        away = size + radius
    sign = 1.0
    if kind == "circle":  # from inside
        radius = min(radius, 0.9 * size)
        away, sign = size - radius, -1.0
    speed, slope, pull, aim = draw(speeds), draw(slopes), draw(pulls), draw(angles)
    gx, gy = pull * cos(aim), pull * sin(aim)
    touch = Path(
        cx + away * nx, cy + away * ny, speed * (-sign * slope * nx - ny), speed * (-sign * slope * ny + nx), gx, gy
    )
    return kind, (cx, cy), size, radius, turn, path_after(touch, -draw(ages))


def found(case: Case) -> float | None:
    """The first touch, of a line and not of a segment."""
    kind, (cx, cy), size, radius, turn, path = case
    if kind == "point":
        return impact_point(cx, cy, path, radius, inf)
    if kind == "segment":
        return impact_segment(SegmentGeometry(cx, cy, -sin(turn), cos(turn), 1e300), path, radius, inf, 1e300)
    return impact_circle(CircleGeometry(cx, cy, size, kind == "disc"), path, radius, inf)


def gap(case: Case, time: float) -> Any:
    """How far the ball is from the shape at a time, below 0 where they overlap, in sixty digits."""
    kind, (cx, cy), size, radius, turn, path = case
    x, y, vx, vy, gx, gy = (mpmath.mpf(number) for number in path)
    x, y = x + vx * time + gx * time * time / 2 - cx, y + vy * time + gy * time * time / 2 - cy
    if kind == "segment":
        return abs(mpmath.mpf(cos(turn)) * x + mpmath.mpf(sin(turn)) * y) - radius
    away = mpmath.sqrt(x * x + y * y) - (0 if kind == "point" else size)
    return (abs(away) if kind == "circle" else away) - radius


def unit_in_last_place(case: Case, time: float) -> float:
    """Of the largest number that the flight is made of until a time."""
    _, (cx, cy), size, radius, _, path = case
    x, y, vx, vy, gx, gy = (abs(number) for number in path)
    terms = x, y, vx * time, vy * time, 0.5 * gx * time * time, 0.5 * gy * time * time
    largest = max(*terms, abs(cx), abs(cy), size, radius)
    return nextafter(largest, inf) - largest


@given(cases())
def test_at_its_impact_a_ball_touches_to_a_few_units_in_the_last_place(case: Case) -> None:
    with mpmath.workdps(60):
        assume(gap(case, 0.0) > 0.0)
        time = found(case)
        assume(time is not None)
        assert abs(gap(case, time or 0.0)) <= MOST * unit_in_last_place(case, time or 0.0)


@pytest.mark.slow
@given(cases())
def test_a_touch_that_a_flight_was_led_back_from_is_not_missed(case: Case) -> None:
    # Where it approaches steeply, so that no rounding of its long way makes a miss of it.
    with mpmath.workdps(60):
        assume(gap(case, 0.0) > 0.0)
        _, _, size, radius, _, _ = case
        least = min(size, radius)
        times = [10.0 ** (0.05 * power) for power in range(-120, 181)]
        deep = [time for time in times if gap(case, time) < -1e-3 * least]
        assume(deep and unit_in_last_place(case, deep[0]) < 1e-6 * least)
        time = found(case)
        assert time is not None
        assert time <= deep[0]
