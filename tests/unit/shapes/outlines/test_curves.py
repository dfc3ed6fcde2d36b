"""Curves as tangent arcs: within the tolerance in high precision, joined without a bend, in bounded time."""

from math import cos, hypot, nan, pi, sin
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import Arc, InvalidArgument, Segment, UnknownName, outlines
from carom.shapes.outlines.curves import bezier_chain, bezier_chains
from tests.clock import within
from tests.curves import exact_cubic, farthest, farthest_back, joints, nasty_cubics

Vector = tuple[float, float]

#: Roughly: the test's own rounding, in tolerances.
SLACK = 1.0 + 1e-6


def ellipse(t: float) -> Vector:
    """An ellipse with half axes 3 and 2, once round."""
    return 3.0 * cos(2.0 * pi * t), 2.0 * sin(2.0 * pi * t)


def slope_near(points: list[Vector], place: complex, size: float, reach: float) -> float:
    """The least slope of a cubic, in its size, where it is near a place."""
    a, b, c, d = (complex(x / size, y / size) for x, y in points)
    least = 10.0
    for index in range(4001):
        t = index / 4000
        s = 1.0 - t
        at = a * s**3 + 3 * b * s * s * t + 3 * c * s * t * t + d * t**3
        if abs(at - place / size) < reach:
            least = min(least, 3.0 * abs((b - a) * s * s + 2 * (c - b) * s * t + (d - c) * t * t))
    return least


def check_fit(points: list[Vector], size: float, tolerance: float, looks: int) -> None:
    """Fail where an outline leaves a cubic, has a gap, or a bend that is no cusp of the cubic."""
    with within(60.0):
        shapes = outlines.bezier(points, tolerance, guard=False)
    assert farthest(lambda t: exact_cubic(points, t), shapes, looks) <= tolerance * SLACK
    for place, gap, bend in joints(shapes):
        assert gap <= 1e-9 * size
        assert bend <= 1e-9 or slope_near(points, place, size, 2e-3) < 2e-2


@settings(max_examples=25)
@given(nasty_cubics(), st.floats(-4.0, 0.0))
def test_an_outline_keeps_to_any_cubic_and_is_tangent_but_for_cusps(
    given_: tuple[list[Vector], float], power: float
) -> None:
    points, size = given_
    check_fit(points, size, size * 10.0**power, 12)


@pytest.mark.slow
@settings(max_examples=30)
@given(nasty_cubics(), st.floats(-5.0, 0.0))
def test_an_outline_keeps_to_any_cubic_however_closely(given_: tuple[list[Vector], float], power: float) -> None:
    points, size = given_
    check_fit(points, size, size * 10.0**power, 60)


@pytest.mark.slow
@settings(max_examples=20)
@given(nasty_cubics(), st.floats(-3.0, 0.0))
def test_no_part_of_an_outline_is_away_from_the_cubic(given_: tuple[list[Vector], float], power: float) -> None:
    points, size = given_
    shapes = outlines.bezier(points, size * 10.0**power, guard=False)

    def curve(t: float) -> Vector:
        s = 1.0 - t
        weights = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t)
        x, y = (sum(w * p[axis] for w, p in zip(weights, points, strict=True)) for axis in (0, 1))
        return x, y

    assert farthest_back(curve, shapes, 200) <= size * 10.0**power * (1.0 + 1e-3)


def test_what_is_straight_is_one_segment() -> None:
    assert [shape.kind for shape in outlines.bezier([(0, 0), (1, 1), (3, 3)], 1e-6, guard=False)] == ["segment"]
    (wall,) = outlines.bezier([(0, 0), (5, 1e-12), (7, 0), (9, 0)], 1e-6, guard=False)
    assert isinstance(wall, Segment)
    assert (wall.p0, wall.p1) == ((0.0, 0.0), (9.0, 0.0))


def test_no_arc_of_what_is_nearly_straight_has_an_enormous_radius() -> None:
    for lift in (1e-3, 1e-5, 1e-7, 1e-9, 1e-11):
        for points in ([(0, 0), (1, lift), (2, -lift), (3, 0)], [(0, 0), (1, lift), (2, lift), (3, 0)]):
            arcs = [shape for shape in outlines.bezier(points, 1e-3) if isinstance(shape, Arc)]
            assert all(arc.radius <= 4e5 for arc in arcs)


def test_a_quadratic_is_the_cubic_that_it_is() -> None:
    a, b, c = 0j, 1 + 2j, 3 - 1j
    cubic = [a, (a + 2 * b) / 3, (c + 2 * b) / 3, c]
    twice = [outlines.bezier([(p.real, p.imag) for p in points], 1e-3) for points in ([a, b, c], cubic)]
    assert list(map(repr, twice[0])) == list(map(repr, twice[1]))


def test_an_ellipse_is_closed_without_a_bend_and_needs_no_points() -> None:
    shapes = outlines.fit(ellipse, 1e-4)
    assert {shape.kind for shape in shapes} == {"arc"}
    assert all(gap < 1e-14 and bend < 1e-14 for _, gap, bend in joints([*shapes, shapes[0]]))
    assert farthest_back(ellipse, shapes, 500) <= 1e-4 * SLACK


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-5])
def test_arcs_along_an_ellipse_are_about_as_few_as_can_be(tolerance: float) -> None:
    # By the asymptotic law: the best arcs deviate by 0.00802 times the slope of curvature times length cubed.
    ideal = 0.0
    for index in range(2000):
        angle = 2.0 * pi * (index + 0.5) / 2000
        speed = hypot(3.0 * sin(angle), 2.0 * cos(angle))
        slope = abs(-3.0 * 6.0 * (9.0 - 4.0) * sin(angle) * cos(angle)) / speed**6
        ideal += (0.00802 * slope / tolerance) ** (1.0 / 3.0) * speed * 2.0 * pi / 2000
    assert len(outlines.fit(ellipse, tolerance)) <= 1.5 * ideal + 4.0


def test_a_derivative_that_is_given_makes_no_difference_to_speak_of() -> None:
    found = outlines.fit(ellipse, 1e-3, derivative=lambda t: (-6 * pi * sin(2 * pi * t), 4 * pi * cos(2 * pi * t)))
    assert [arc.radius for arc in found if isinstance(arc, Arc)] == pytest.approx(
        [arc.radius for arc in outlines.fit(ellipse, 1e-3) if isinstance(arc, Arc)], rel=1e-6
    )


def test_a_cycloid_gets_a_point_at_its_cusp() -> None:
    shapes = outlines.fit(lambda t: (t - sin(4 * pi * t) / (4 * pi), 0.1 * (1 - cos(4 * pi * t))), 1e-3)
    points = sorted(shape.position for shape in shapes if shape.kind == "point")
    assert sum(points, ()) == pytest.approx((0.0, 0.0, 0.5, 0.0, 1.0, 0.0), abs=1e-6)


def test_biarcs_leave_out_what_they_pass_within_the_tolerance() -> None:
    ts = [index / 60 for index in range(61)]
    places = [ellipse(t) for t in ts]
    ways = [(-3.0 * sin(2.0 * pi * t), 2.0 * cos(2.0 * pi * t)) for t in ts]
    every = outlines.biarcs(places, ways)
    few = outlines.biarcs(places, ways, 1e-2)
    assert len(few) < len(every) / 3
    assert all(min(shape.distance(place) for shape in every) < 1e-12 for place in places)
    assert all(min(shape.distance(place) for shape in few) <= 1e-2 * SLACK for place in places)
    assert all(bend < 1e-12 for _, _, bend in joints(few))


def test_biarcs_find_a_way_where_both_ends_lead_away() -> None:
    shapes = outlines.biarcs([(0, 0), (2, 0)], [(-1, 0), (-1, 0)], guard=False)
    assert all(gap < 1e-14 and bend < 1e-14 for _, gap, bend in joints(shapes))
    assert max(shape.aabb.top for shape in shapes) < 3.0


def test_options_are_those_of_shapes_and_hold_for_points_too() -> None:
    shapes = outlines.bezier([(0, 0), (1, 2), (2, 0)], 0.1, elasticity=0.5, kick=2.0, layer=4, name="rail", user=7)
    assert {shape.kind for shape in shapes} == {"arc", "point"}
    for shape in shapes:
        assert (shape.elasticity, shape.kick, shape.layer, shape.name, shape.user) == (0.5, 2.0, 4, "rail", 7)
    assert "point" not in {shape.kind for shape in outlines.bezier([(0, 0), (1, 2), (2, 0)], 0.1, guard=False)}
    with pytest.raises(UnknownName, match=r"elastcity is no argument of bezier.*did you mean elasticity"):
        outlines.bezier([(0, 0), (1, 2), (2, 0)], 0.1, elastcity=0.5)  # type: ignore[call-arg]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: outlines.bezier([(0, 0), (1, 1)], 0.1), "points must be 3 or 4 points"),
        (lambda: outlines.bezier([(1, 1)] * 4, 0.1), "points must be 3 or 4 points, not all the same"),
        (lambda: outlines.bezier([(0, 0), (1, nan), (2, 2)], 0.1), r"points\[1\]\[1\] must be finite"),
        (lambda: outlines.bezier([(0, 0), (1, 1), (2, 0)], 0.0), "tolerance must be positive"),
        (lambda: outlines.bezier([(0, 0), (1, 1), (2, 0)], 1e-14), "tolerance must be at least 2.*e-11 .*not 1e-14"),
        (lambda: outlines.bezier([(0, 0), (1e300, 1), (2, 0)], 1.0), "points must have coordinates"),
        (lambda: outlines.bezier([(0, 0), (1, 1), (2, 0)], 0.1, guard=1), "guard must be True or False"),
        (lambda: outlines.bezier([(0, 0), (1, 1), (2, 0)], 0.1, elasticity=-1), "elasticity must not be negative"),
        (lambda: outlines.fit(lambda t: (1.0, 1.0), 0.1), "curve must not stay in one place"),
        (lambda: outlines.fit(lambda t: (t, nan), 0.1), r"curve\(0.0\)\[1\] must be finite"),
        (lambda: outlines.fit(lambda t: t, 0.1), r"curve\(0.0\) must be a pair"),
        (lambda: outlines.fit(3, 0.1), "curve must be a function of t, not 3"),
        (lambda: outlines.fit(ellipse, 0.1, derivative=3), "derivative must be a function of t, not 3"),
        (lambda: outlines.fit(lambda t: (t, float(t > 0.3)), 0.1), "curve must be smooth"),
        (lambda: outlines.fit(ellipse, 0.1, derivative=lambda t: 1.0), r"derivative\(0.0\) must be a pair"),
        (lambda: outlines.fit(lambda t: (t, float(t > 0.3)), 0.01), "curve must be smooth.*near t=0.3"),
        (lambda: outlines.biarcs([(0, 0), (1, 1)], [(1, 0)]), "tangents must be as many as the points"),
        (lambda: outlines.biarcs([(0, 0), (0, 0)], [(1, 0), (0, 1)]), r"points\[1\] must differ"),
        (lambda: outlines.biarcs([(0, 0), (1, 0)], [(1, 0), (0, 0)]), r"tangents\[1\] must have a length"),
        (lambda: outlines.biarcs(3, []), "points must be a list of points"),
    ],
)
def test_mistakes_are_named(call: Any, message: str) -> None:
    with within(20.0), pytest.raises(InvalidArgument, match=message):
        call()


def test_outlines_are_reached_from_the_package() -> None:
    assert carom.outlines is outlines


def test_many_beziers_at_once_are_what_each_is_alone_and_none_where_one_is_refused() -> None:
    curves: list[Any] = [[(k, 0.0), (k + 0.3, 1.0 + 0.01 * k), (k + 1.0, -0.5), (k + 1.0, 0.7)] for k in range(50)]
    curves[7] = [(2.0, 2.0)] * 4
    curves[9] = curves[9][:3]
    found = bezier_chains(curves, 1e-3)
    assert found[7] is None
    assert [chain for chain in found if chain is not None] == [
        bezier_chain(points, 1e-3) for place, points in enumerate(curves) if place != 7
    ]
