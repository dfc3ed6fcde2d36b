"""Biarcs: their joint, and arcs by where they begin and how they bend."""

from cmath import exp, phase
from math import cos, fabs, hypot, pi, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp, mpf

from carom.geometry.biarc import bend, biarc_joint, side_of_arc
from tests.strategies import angles, points, radii

Vector = tuple[float, float]


def reflected(way: complex, chord: complex) -> complex:
    """The direction in which a circle comes to the end of a chord that it left in a direction."""
    along = chord / abs(chord)
    return along * along * way.conjugate()


@given(points, points, angles, angles)
def test_both_arcs_of_a_biarc_pass_its_joint_in_the_same_direction(
    a: Vector, b: Vector, out: float, into: float
) -> None:
    start, end = complex(*a), complex(*b)
    assume(abs(end - start) > 1e-3)
    t, u = exp(1j * out), exp(1j * into)
    found = biarc_joint(*a, t.real, t.imag, *b, u.real, u.imag)
    assume(found is not None)
    assert found is not None
    joint, way = complex(found[0], found[1]), complex(found[2], found[3])
    assume(min(abs(joint - start), abs(joint - end)) > 1e-3)
    assert fabs(phase(reflected(t, joint - start) / way)) < 1e-9
    assert fabs(phase(reflected(way, end - joint) / u)) < 1e-9


def test_the_joint_of_a_half_circle_is_its_top() -> None:
    assert biarc_joint(0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, -1.0) == (1.0, 1.0, 1.0, 0.0)


def test_where_both_ends_lead_away_there_is_no_biarc() -> None:
    assert biarc_joint(0.0, 0.0, -1.0, 0.0, 2.0, 0.0, -1.0, 0.0) is None
    assert biarc_joint(1.0, 2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 1.0) is None


@given(points, radii, angles, st.floats(0.01, 3.0))
def test_a_bend_is_one_over_the_radius_and_positive_to_the_left(
    center: Vector, radius: float, angle: float, turn: float
) -> None:
    ax, ay = center[0] + radius * cos(angle), center[1] + radius * sin(angle)
    for sign in (1.0, -1.0):
        later = angle + sign * turn
        bx, by = center[0] + radius * cos(later), center[1] + radius * sin(later)
        found = bend(ax, ay, -sign * sin(angle), sign * cos(angle), bx, by)
        assert found == pytest.approx(sign / radius, rel=1e-9 * max(1.0, (hypot(*center) + radius) / radius))


def test_nowhere_to_go_is_no_bend() -> None:
    assert bend(1.0, 2.0, 1.0, 0.0, 1.0, 2.0) == 0.0


@given(st.floats(-3.0, 3.0), st.floats(-12.0, 2.0), st.booleans(), st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
def test_the_side_is_the_exact_one_however_large_the_radius(
    angle: float, power: float, left: bool, x: float, y: float
) -> None:
    curvature = 10.0**power * (1.0 if left else -1.0)
    tx, ty = cos(angle), sin(angle)
    with mp.workdps(60):
        cx, cy = -mpf(ty) / mpf(curvature), mpf(tx) / mpf(curvature)
        radius = mp.hypot(cx, cy)
        exact = (radius - mp.hypot(mpf(x) - cx, mpf(y) - cy)) * (1 if left else -1)
    # The unit tangent is off by its rounding, which moves the centre by as much of the radius, along with the circle.
    assert side_of_arc(tx, ty, curvature, x, y) == pytest.approx(
        float(exact), rel=1e-7, abs=2e-15 * (1.0 + curvature**2)
    )


def test_the_centre_is_a_radius_to_the_side() -> None:
    assert side_of_arc(1.0, 0.0, 0.5, 0.0, 2.0) == pytest.approx(2.0, rel=1e-7)
    assert side_of_arc(1.0, 0.0, 0.0, 7.0, -3.0) == -3.0
    assert side_of_arc(0.0, 1.0, 1.0 / pi, -pi, pi) == pytest.approx(0.0, abs=1e-15)
