"""SVG path data as shapes: lines and circular arcs exactly, all else within the tolerance."""

from cmath import exp, pi
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from carom import Arc, InvalidArgument, Segment, outlines
from tests.curves import joints


def test_lines_and_circular_arcs_are_exact() -> None:
    line, arc, back, *points = outlines.path("M 0 0 L 4 0 A 1 1 0 0 1 4 2 Z")
    assert isinstance(line, Segment)
    assert isinstance(arc, Arc)
    assert isinstance(back, Segment)
    assert (line.p0, line.p1, back.p0, back.p1) == ((0.0, 0.0), (4.0, 0.0), (0.0, 0.0), (4.0, 2.0))
    assert (arc.center, arc.radius, arc.angles) == ((4.0, 1.0), 1.0, (1.5 * pi, 0.5 * pi))
    assert sorted(point.position for point in points) == [(0.0, 0.0), (4.0, 2.0)]


@settings(max_examples=50)
@given(st.floats(-pi, pi), st.floats(0.1, 6.1), st.booleans(), st.floats(0.1, 50.0))
def test_a_circular_arc_is_the_one_of_four_that_the_flags_say(
    start: float, turn: float, counterclockwise: bool, radius: float
) -> None:
    assume(abs(turn - pi) > 1e-3)
    sign = 1.0 if counterclockwise else -1.0
    a, b = radius * exp(1j * start), radius * exp(1j * (start + sign * turn))
    flags = f"{int(turn > pi)} {int(counterclockwise)}"
    data = f"M {a.real!r} {a.imag!r} A {radius!r} {radius!r} 77 {flags} {b.real!r} {b.imag!r}"
    (arc,) = outlines.path(data, guard=False)
    assert isinstance(arc, Arc)
    assert arc.center == pytest.approx((0.0, 0.0), abs=1e-9 * radius)
    assert arc.length == pytest.approx(radius * turn)


def test_radii_that_do_not_reach_are_made_longer() -> None:
    (arc,) = outlines.path("M 0 0 A 1 1 0 0 1 8 0", guard=False)
    assert isinstance(arc, Arc)
    assert (arc.center, arc.radius) == ((4.0, 0.0), 4.0)


@pytest.mark.parametrize("turned", [0.0, 30.0, -200.0])
def test_an_elliptical_arc_is_within_the_tolerance_of_its_ellipse_and_closes(turned: float) -> None:
    tilt = exp(1j * pi * turned / 180.0)
    a, b = 3.0 * tilt, -3.0 * tilt
    data = (
        f"M {a.real!r} {a.imag!r} A 3 2 {turned} 0 1 {b.real!r} {b.imag!r} A 3 2 {turned} 0 1 {a.real!r} {a.imag!r} Z"
    )
    shapes = outlines.path(data, 1e-3)
    assert {shape.kind for shape in shapes} == {"arc"}
    assert all(gap < 1e-12 and bend < 1e-9 for _, gap, bend in joints([*shapes, shapes[0]]))
    for index in range(200):
        place = tilt * complex(3.0 * exp(2j * pi * index / 200).real, 2.0 * exp(2j * pi * index / 200).imag)
        assert min(shape.distance((place.real, place.imag)) for shape in shapes) <= 1e-3 * (1.0 + 1e-9)


def test_beziers_that_continue_each_other_need_no_point_between() -> None:
    shapes = outlines.path("M0 0C1 1 2 1 3 0S5-1 6 0", 1e-2)
    ends = [x for shape in shapes if shape.kind == "point" for x in shape.position]
    assert ends == pytest.approx([0.0, 0.0, 6.0, 0.0], abs=1e-14)
    bent = outlines.path("M0 0C1 1 2 1 3 0C4 1 5 1 6 0", 1e-2)
    assert len([shape for shape in bent if shape.kind == "point"]) == 3


def test_without_a_tolerance_it_is_a_thousandth_of_the_size() -> None:
    data = "M0 0C30 10 20 10 30 0"
    assert list(map(repr, outlines.path(data))) == list(map(repr, outlines.path(data, 30e-3)))
    assert len(outlines.path(data)) < len(outlines.path(data, 3e-5))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: outlines.path(7), "data must be SVG path data, a string"),
        (lambda: outlines.path(""), "data must draw something"),
        (lambda: outlines.path("M 3 3 Z"), "data must draw something"),
        (lambda: outlines.path("M 0 0 H 1", 0.0), "tolerance must be positive"),
        (lambda: outlines.path("M 0 0 H 1", layer=-1), "layer must be from 0"),
    ],
)
def test_mistakes_are_named(call: Any, message: str) -> None:
    with pytest.raises(InvalidArgument, match=message):
        call()
