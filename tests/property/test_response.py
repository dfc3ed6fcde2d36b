"""Laws of responses: momentum, energy, and what stays as it was."""

from collections.abc import Callable
from fractions import Fraction
from math import cos, fsum, hypot, pi, sin, sqrt
from random import Random

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import overlap, response
from carom.geometry.figures import CircleGeometry
from carom.geometry.gap import gap_circle, placed
from carom.geometry.impact_straight import bowl_time
from carom.geometry.path import Path, place_on
from tests import naive
from tests.strategies import (
    angles,
    balls,
    elasticities,
    masses,
    positive_extremes,
    speeds,
    unit_vectors,
    vectors,
)

Vector = tuple[float, float]


@given(speeds, speeds, masses, masses, elasticities)
def test_momentum_is_conserved_at_every_elasticity(u1: float, u2: float, m1: float, m2: float, e: float) -> None:
    after1, after2 = response.exchanged(u1, u2, m1, m2, e)
    scale = (m1 + m2) * (abs(u1) + abs(u2))
    assert m1 * after1 + m2 * after2 == pytest.approx(m1 * u1 + m2 * u2, rel=0.0, abs=1e-14 * scale)


@given(speeds, speeds, masses, masses)
def test_energy_is_conserved_by_elastic_balls(u1: float, u2: float, m1: float, m2: float) -> None:
    after1, after2 = response.exchanged(u1, u2, m1, m2, 1.0)
    assert m1 * after1 * after1 + m2 * after2 * after2 == pytest.approx(m1 * u1 * u1 + m2 * u2 * u2, rel=1e-14)


@given(speeds, speeds, masses, masses, elasticities)
def test_energy_never_rises_below_elasticity_one(u1: float, u2: float, m1: float, m2: float, e: float) -> None:
    assume(e <= 1.0)
    after1, after2 = response.exchanged(u1, u2, m1, m2, e)
    before = m1 * u1 * u1 + m2 * u2 * u2
    assert m1 * after1 * after1 + m2 * after2 * after2 <= before * (1.0 + 1e-14)


@given(speeds, speeds, masses, masses, elasticities)
def test_balls_part_at_the_speed_of_approach_times_elasticity(
    u1: float, u2: float, m1: float, m2: float, e: float
) -> None:
    after1, after2 = response.exchanged(u1, u2, m1, m2, e)
    assert after2 - after1 == pytest.approx(e * (u1 - u2), rel=0.0, abs=1e-14 * (abs(u1) + abs(u2)))


@given(speeds, speeds, masses, masses, elasticities)
def test_an_exchange_is_that_about_the_centre_of_mass(u1: float, u2: float, m1: float, m2: float, e: float) -> None:
    expected = naive.exchanged(u1, u2, m1, m2, e)
    assert response.exchanged(u1, u2, m1, m2, e) == pytest.approx(expected, rel=0.0, abs=1e-13 * (abs(u1) + abs(u2)))


@given(speeds, speeds, masses, masses, elasticities)
def test_which_ball_comes_first_does_not_matter(u1: float, u2: float, m1: float, m2: float, e: float) -> None:
    after1, after2 = response.exchanged(u1, u2, m1, m2, e)
    assert response.exchanged(u2, u1, m2, m1, e) == pytest.approx((after2, after1), rel=1e-14, abs=1e-13)


@given(speeds, speeds, masses)
def test_equal_elastic_balls_swap_velocities_to_the_bit(u1: float, u2: float, m: float) -> None:
    assert response.exchanged(u1, u2, m, m, 1.0) == (u2, u1)


@given(speeds, speeds, masses, masses)
def test_balls_that_stick_have_one_velocity_to_the_bit(u1: float, u2: float, m1: float, m2: float) -> None:
    after1, after2 = response.exchanged(u1, u2, m1, m2, 0.0)
    assert after1 == after2


@given(vectors, vectors, unit_vectors, elasticities)
def test_a_bounce_turns_the_normal_part_and_leaves_the_rest(v: Vector, surface: Vector, n: Vector, e: float) -> None:
    s = (v[0] - surface[0]) * n[0] + (v[1] - surface[1]) * n[1]
    assume(s < 0.0)
    x, y, gain = response.reflected(*v, *surface, *n, e, s, 0.0, False)
    scale = 1e-14 * (hypot(*v) + hypot(*surface))
    assert (x - surface[0]) * n[0] + (y - surface[1]) * n[1] == pytest.approx(-e * s, rel=0.0, abs=scale)
    assert n[0] * y - n[1] * x == pytest.approx(n[0] * v[1] - n[1] * v[0], rel=0.0, abs=scale)
    assert gain == pytest.approx(-(1.0 + e) * s, rel=0.0, abs=scale)
    assert gain >= 0.0


@given(vectors, unit_vectors)
def test_an_elastic_bounce_off_a_wall_keeps_the_speed(v: Vector, n: Vector) -> None:
    s = v[0] * n[0] + v[1] * n[1]
    assume(s < 0.0)
    for total in (False, True):
        x, y, _ = response.reflected(*v, 0.0, 0.0, *n, 1.0, s, 0.0, total)
        assert x * x + y * y == pytest.approx(v[0] * v[0] + v[1] * v[1], rel=1e-14)


@given(vectors, vectors, unit_vectors, elasticities)
def test_the_total_rule_scales_the_mirrored_velocity(v: Vector, surface: Vector, n: Vector, e: float) -> None:
    wx, wy = v[0] - surface[0], v[1] - surface[1]
    s = wx * n[0] + wy * n[1]
    assume(s < 0.0)
    x, y, gain = response.reflected(*v, *surface, *n, e, s, 0.0, True)
    expected = (surface[0] + e * (wx - 2.0 * s * n[0]), surface[1] + e * (wy - 2.0 * s * n[1]))
    scale = 1e-14 * (hypot(*v) + hypot(*surface))
    assert (x, y) == pytest.approx(expected, rel=0.0, abs=scale)
    assert gain == pytest.approx((x - v[0]) * n[0] + (y - v[1]) * n[1], rel=0.0, abs=2.0 * scale)


@given(vectors, vectors, unit_vectors, speeds, speeds)
def test_both_rules_are_one_at_elasticity_one(
    v: Vector, surface: Vector, n: Vector, approach: float, kick: float
) -> None:
    one = response.reflected(*v, *surface, *n, 1.0, -abs(approach), abs(kick), False)
    other = response.reflected(*v, *surface, *n, 1.0, -abs(approach), abs(kick), True)
    assert other == pytest.approx(one, rel=0.0, abs=1e-12)


@given(speeds, speeds, speeds)
def test_an_approach_at_contact_conserves_energy(s: float, g_n: float, setback: float) -> None:
    setback = abs(setback)
    at_contact = response.approach_at_contact(s, g_n, setback)
    if s >= 0.0:
        assert at_contact == s
    else:
        assert at_contact <= 0.0
        square = max(0.0, s * s + 2.0 * g_n * setback)
        assert at_contact * at_contact == pytest.approx(square, rel=1e-14, abs=1e-12)


@given(balls, angles, masses, masses)
def test_separated_balls_touch_and_their_centre_of_mass_stays(
    ball: tuple[float, float, float], angle: float, m1: float, m2: float
) -> None:
    x1, y1, r1 = ball
    x2, y2 = naive.moved_point((angle, x1, y1), 0.5 * r1, 0.0)
    r2 = 0.75 * r1
    contact = overlap.overlap_ball(x1, y1, r1, x2, y2, r2, 0.0, 0.0)
    assert contact is not None
    _, _, nx, ny, setback = contact
    new_x1, new_y1, new_x2, new_y2 = response.separated(x1, y1, m1, x2, y2, m2, nx, ny, setback)
    assert hypot(new_x2 - new_x1, new_y2 - new_y1) == pytest.approx(r1 + r2, rel=0.0, abs=1e-13)
    total = m1 + m2
    slack = 1e-13 * total
    assert m1 * new_x1 + m2 * new_x2 == pytest.approx(m1 * x1 + m2 * x2, rel=0.0, abs=slack)
    assert m1 * new_y1 + m2 * new_y2 == pytest.approx(m1 * y1 + m2 * y2, rel=0.0, abs=slack)


@given(vectors, vectors, angles, positive_extremes, elasticities, speeds, st.booleans())
def test_a_rebound_is_a_reflection_by_the_unit_normal(
    v: Vector, surface: Vector, angle: float, length: float, e: float, kick: float, total: bool
) -> None:
    n = cos(angle), sin(angle)
    s = (v[0] - surface[0]) * n[0] + (v[1] - surface[1]) * n[1]
    expected = response.reflected(*v, *surface, *n, e, s, kick, total)
    found = response.rebounded(*v, *surface, length * n[0], length * n[1], e, kick, total)
    assert found == pytest.approx(expected, rel=0.0, abs=1e-14 * (hypot(*v) + hypot(*surface) + abs(kick)))


@pytest.mark.compiled
@pytest.mark.parametrize("r", [1.0, 0.7])
def test_neither_speed_nor_angular_momentum_drifts_in_a_round_room(r: float) -> None:
    # Where r² is a power of two, a unit normal's rounding and centres that are always moved drift by 5e-17 an impact.
    bounces, starts = 5000, 20
    drifts = []
    for seed in range(starts):
        random = Random(seed)
        angle, slope, speed = random.uniform(0.0, 2.0 * pi), random.uniform(0.1, 1.5), random.uniform(0.5, 2.0)
        begin = Path(r * cos(angle), r * sin(angle), -speed * cos(angle + slope), -speed * sin(angle + slope), 0.0, 0.0)
        path = begin
        for _ in range(bounces):
            time = bowl_time(path, r)
            assert time is not None
            x, y = place_on(path, time)
            found, nx, ny = gap_circle(CircleGeometry(0.0, 0.0, 2.0 * r, False), x, y, r, 0.0, 0.0)
            x, y = placed(x, y, found, nx, ny, 2.0 * r + abs(x) + abs(y))
            vx, vy, _ = response.rebounded(path.vx, path.vy, 0.0, 0.0, -x, -y, 1.0, 0.0, False)
            path = Path(x, y, vx, vy, 0.0, 0.0)
        drifts.append([float(relative_change(of, begin, path)) / bounces for of in (speed_squared, turning)])
    for drift in zip(*drifts, strict=True):
        mean = fsum(drift) / starts
        error = sqrt(fsum((part - mean) ** 2 for part in drift) / (starts - 1) / starts)
        assert abs(mean) <= 1e-17
        assert abs(mean) <= 4.0 * error


def relative_change(of: Callable[[Path], Fraction], before: Path, after: Path) -> Fraction:
    """By which part of itself something of a path has changed, exactly."""
    return of(after) / of(before) - 1


def speed_squared(path: Path) -> Fraction:
    """The square of the speed, exactly."""
    return Fraction(path.vx) ** 2 + Fraction(path.vy) ** 2


def turning(path: Path) -> Fraction:
    """The angular momentum about the origin for each unit of mass, exactly."""
    return Fraction(path.x) * Fraction(path.vy) - Fraction(path.y) * Fraction(path.vx)
