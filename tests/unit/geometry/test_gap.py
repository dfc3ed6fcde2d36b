"""Gaps: how far a ball is from a shape and in which direction, and how deep it is as it comes past an end."""

from math import atan2, cos, fsum, hypot, pi, sin, sqrt
from random import Random

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given

from carom.geometry import gap as gaps
from carom.geometry.arc import arc_ends
from tests.flat import flat
from tests.naive import closest, in_sector, margin
from tests.strategies import Ball, Figure, meetings, seeds, vectors

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


@given(seeds)
def test_the_depth_in_a_segments_line_is_the_lesser_of_those_at_the_start_and_at_the_edge(seed: int) -> None:
    random = Random(seed)
    turn, extent, radius = random.uniform(0, 6.3), random.uniform(1, 5), random.uniform(0.2, 2)
    tx, ty = cos(turn), sin(turn)
    ax, ay = random.uniform(-3, 3), random.uniform(-3, 3)
    begin = random.choice((-random.uniform(0.1, 3), extent + random.uniform(0.1, 3)))
    sides = random.uniform(-2, 2), random.uniform(-2, 2)
    end = random.uniform(0.0, extent)

    def place(along: float, side: float) -> tuple[float, float]:
        return ax + along * tx - side * ty, ay + along * ty + side * tx

    edge = 0.0 if begin < 0.0 else extent
    at_edge = sides[0] + (sides[1] - sides[0]) * (edge - begin) / (end - begin)
    found = gap.depth_on_entry_segment(ax, ay, tx, ty, extent, radius, *place(begin, sides[0]), *place(end, sides[1]))
    assert found == pytest.approx(radius - max(abs(sides[0]), abs(at_edge)))


@given(seeds)
def test_the_depth_in_an_arcs_circle_is_likewise(seed: int) -> None:
    random = Random(seed)
    cx, cy, r, radius = random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(1, 5), random.uniform(0.2, 2)
    start, sweep = random.uniform(0, 6.28), random.uniform(0.3, 5.5)
    end = (start + sweep) % (2 * pi)

    def place(inside: bool) -> tuple[float, float]:
        while True:
            x, y = random.uniform(-1.5 * r, 1.5 * r), random.uniform(-1.5 * r, 1.5 * r)
            if in_sector(start, end, x, y) == inside:
                return x, y

    (x0, y0), (x1, y1) = place(False), place(True)
    share = np.linspace(0, 1, 100_001)
    xs, ys = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
    away = np.hypot(xs, ys)
    # The last time that it comes in: it may cross the sector before.
    outside = [not in_sector(start, end, x, y) for x, y in zip(xs[::50], ys[::50], strict=True)]
    last = 50 * max(k for k, out in enumerate(outside) if out)
    edge = next(k for k in range(last, len(xs)) if in_sector(start, end, xs[k], ys[k]))
    expected = radius - max(abs(away[0] - r), abs(away[edge] - r))
    ends = arc_ends(cx, cy, r, start, end)
    found = gap.depth_on_entry_arc(cx, cy, r, *ends, radius, cx + x0, cy + y0, cx + x1, cy + y1)
    assert found == pytest.approx(expected, abs=1e-3)


def test_a_way_crosses_a_ray_where_it_crosses_its_line_on_the_rays_side() -> None:
    assert gap.crossing_share(2.0, 0.0, 1.0, -1.0, 1.0, 3.0) == 0.25
    assert gap.crossing_share(2.0, 0.0, -1.0, -1.0, -1.0, 3.0) == 0.0
    assert gap.crossing_share(2.0, 0.0, 1.0, 1.0, 1.0, 3.0) == 0.0
    x, y = cos(2.0), sin(2.0)
    share = gap.crossing_share(x, y, 0.0, 3.0, -3.0, 0.0)
    assert atan2(3 - 3 * share, -3 * share) == pytest.approx(2.0)
    assert hypot(x, y) == pytest.approx(1.0)
