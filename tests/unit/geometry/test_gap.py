"""Gaps: how far a ball is from a shape, and in which direction, on either side and where the centre lies on it."""

from math import cos, fsum, hypot, pi, sin, sqrt
from random import Random

import mpmath
import pytest
from hypothesis import assume, given

from carom.geometry import gap as gaps
from tests.flat import flat
from tests.naive import closest, margin
from tests.strategies import Ball, Figure, meetings, vectors

gap = flat(gaps)

Vector = tuple[float, float]


def gap_to(figure: Figure, ball: Ball, velocity: Vector, slop: float = 0.0) -> tuple[float, float, float] | None:
    """What carom finds for a figure."""
    kind, numbers = figure
    if kind == "segment":
        ax, ay, bx, by = numbers
        extent = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
        return gap.gap_segment(ax, ay, (bx - ax) / extent, (by - ay) / extent, extent, *ball, *velocity, slop)
    if kind == "point":
        return gap.gap_circle(*numbers[:2], 0.0, True, *ball, *velocity)
    return gap.gap_circle(*numbers[:3], kind == "disc", *ball, *velocity)


@given(meetings(), vectors)
def test_a_gap_is_the_distance_to_the_closest_point_less_the_radius(
    meeting: tuple[Figure, Ball], velocity: Vector
) -> None:
    figure, (x, y, radius) = meeting
    figure = ("circle", figure[1][:3]) if figure[0] == "arc" else figure
    assume(margin(figure, x, y, radius) > 1e-6)
    found, place = gap_to(figure, (x, y, radius), velocity), closest(figure, x, y)
    assert (found is None) == (place is None)
    if found is not None and place is not None:
        away = hypot(x - place[0], y - place[1])
        side = -1.0 if figure[0] == "disc" and hypot(x - figure[1][0], y - figure[1][1]) < figure[1][2] else 1.0
        assert found[0] == pytest.approx(side * away - radius, abs=1e-8)
        normal = side * (x - place[0]) / away, side * (y - place[1]) / away
        assert found[1:] == pytest.approx(normal, abs=1e-6)


def test_a_centre_on_the_line_of_a_segment_is_on_the_side_that_it_comes_from() -> None:
    for velocity, normal in (((0.0, -3.0), (-0.0, 1.0)), ((0.0, 3.0), (0.0, -1.0)), ((2.0, 0.0), (-0.0, 1.0))):
        assert gap.gap_segment(0.0, 0.0, 1.0, 0.0, 4.0, 2.0, 0.0, 0.5, *velocity, 0.0) == (-0.5, *normal)


def test_a_centre_on_a_hollow_circle_is_on_the_side_that_it_comes_from() -> None:
    assert gap.gap_circle(0.0, 0.0, 5.0, False, 3.0, 4.0, 1.0, 3.0, 4.0) == (-1.0, -0.6, -0.8)
    assert gap.gap_circle(0.0, 0.0, 5.0, False, 3.0, 4.0, 1.0, -3.0, -4.0) == (-1.0, 0.6, 0.8)
    assert gap.gap_circle(0.0, 0.0, 5.0, True, 3.0, 4.0, 1.0, 3.0, 4.0) == (-1.0, 0.6, 0.8)


def test_in_the_middle_of_a_circle_the_way_is_the_one_that_the_ball_came() -> None:
    assert gap.gap_circle(1.0, 2.0, 5.0, False, 1.0, 2.0, 1.0, 3.0, 4.0) == (4.0, -0.6, -0.8)
    assert gap.gap_circle(1.0, 2.0, 5.0, True, 1.0, 2.0, 1.0, 0.0, 0.0) == (-6.0, 0.0, 1.0)
    assert gap.against(-3.0, 4.0) == (0.6, -0.8)


@pytest.mark.parametrize(("past", "slop", "is_there"), [(0.0, 0.0, True), (0.1, 0.2, True), (0.3, 0.2, False)])
def test_a_segment_reaches_past_its_ends_by_the_slop(past: float, slop: float, is_there: bool) -> None:
    for x in (4.0 + past, -past):
        found = gap.gap_segment(0.0, 0.0, 1.0, 0.0, 4.0, x, 3.0, 1.0, 0.0, 0.0, slop)
        assert found == ((2.0, -0.0, 1.0) if is_there else None)


@pytest.mark.parametrize("kind", ["segment", "circle", "disc"])
@pytest.mark.parametrize("r", [1.0, 0.7])
def test_a_ball_too_deep_or_not_near_enough_is_placed_at_the_surface_from_either_side(kind: str, r: float) -> None:
    # What rests is rounding, of either sign as often, whichever side the ball comes from.
    random, rests = Random(1), []
    reach = {"segment": 0.25, "circle": r - 0.25, "disc": r + 0.25}[kind]
    for _ in range(2000):
        turn, off = random.uniform(0.0, 2.0 * pi), random.uniform(-1e-6, 1e-6)
        nx, ny = cos(turn), sin(turn)
        x, y = (reach + off) * nx, (reach + off) * ny
        figure = (kind, (-ny, nx, ny, -nx) if kind == "segment" else (0.0, 0.0, r))
        found = gap_to(figure, (x, y, 0.25), (0.0, 0.0))
        assert found is not None
        scale = abs(x) + abs(y) + r
        x, y = gap.placed(x, y, *found, scale)
        again = gap_to(figure, (x, y, 0.25), (0.0, 0.0))
        assert again is not None
        assert abs(again[0]) <= 4e-16 * scale
        assert gap.placed(x, y, *again, scale) == (x, y)
        with mpmath.workdps(40):
            away = mpmath.sqrt(mpmath.mpf(x) ** 2 + mpmath.mpf(y) ** 2)
            if kind == "segment":
                extent = sqrt((2.0 * nx) ** 2 + (2.0 * ny) ** 2)
                away = mpmath.mpf(2.0 * ny / extent) * y - mpmath.mpf(-2.0 * nx / extent) * x
            rests.append(float(abs(away) - reach))
    # Within four standard errors of none.
    assert abs(sum(1 if rest > 0.0 else -1 for rest in rests)) <= 4.0 * sqrt(len(rests))
    assert abs(fsum(rests)) <= 4.0 * sqrt(fsum(rest * rest for rest in rests))


def test_a_gap_that_is_rounding_is_left() -> None:
    assert gap.placed(3.0, 1.0, 4e-15, 0.0, 1.0, 4.0) == (3.0, 1.0)
    assert gap.placed(3.0, 1.0, -0.5, 0.0, 1.0, 4.0) == (3.0, 1.5)
    assert gap.placed(3.0, 1.0, 0.5, 0.0, 1.0, 4.0) == (3.0, 0.5)
