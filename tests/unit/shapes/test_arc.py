"""Arcs: angles, ends, tangents and box, always in agreement."""

from math import cos, fabs, nextafter, pi, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom import Arc, Ball, InvalidArgument


def test_angles_are_kept_normalized() -> None:
    arc = Arc((0, 0), 2, start_angle=-pi / 2, end_angle=5 * pi)
    assert arc.start_angle == 1.5 * pi
    assert arc.end_angle == pytest.approx(pi)
    assert not arc.acute
    assert arc.length == pytest.approx(2 * 1.5 * pi)
    assert Arc((0, 0), 2, 0.5, 1.5).acute


def test_ends_and_tangents() -> None:
    arc = Arc((1, 1), 2, 0, pi / 2)
    assert (arc.p0, arc.t0) == ((3.0, 1.0), (0.0, -1.0))
    assert arc.p1 == pytest.approx((1.0, 3.0))
    assert arc.t1 == pytest.approx((-1.0, 0.0))


@pytest.mark.parametrize(
    ("start", "end", "box"),
    [
        (pi / 4, 3 * pi / 4, (-(0.5**0.5), 0.5**0.5, 0.5**0.5, 1.0)),
        (-pi / 4, pi / 4, (0.5**0.5, -(0.5**0.5), 1.0, 0.5**0.5)),
        (pi / 4, -pi / 4, (-1.0, -1.0, 0.5**0.5, 1.0)),
        (0.0, pi, (-1.0, 0.0, 1.0, 1.0)),
        (0.1, 0.0, (-1.0, -1.0, 1.0, 1.0)),
    ],
)
def test_boxes_hold_the_quadrant_points(start: float, end: float, box: tuple[float, ...]) -> None:
    assert tuple(Arc((0, 0), 1, start, end).aabb) == pytest.approx(box, abs=1e-15)


def test_sectors() -> None:
    arc = Arc((1, 1), 2, 0, pi / 2)
    assert [arc.in_sector(p) for p in [(2, 2), (9, 1), (1, 9), (0, 0), (2, 0.99)]] == [True, True, True, False, False]
    rest = arc.complement()
    assert [rest.in_sector(p) for p in [(2, 2), (9, 1), (1, 9), (0, 0), (2, 0.99)]] == [False, True, True, True, True]


def test_the_complement_is_the_rest_of_the_circle() -> None:
    arc = Arc((1, 1), 2, 0.5, 2, elasticity=0.5, motion="kinematic", angular_velocity=2, name="bend")
    arc.rotate((0, 0), 1.0)
    rest = arc.complement()
    assert (rest.start_angle, rest.end_angle, rest.center) == (arc.end_angle, arc.start_angle, arc.center)
    assert (rest.elasticity, rest.angular_velocity, rest.name) == (0.5, 2.0, None)
    assert rest.length + arc.length == pytest.approx(2 * pi * 2)
    rest.reset()
    arc.reset()
    assert (rest.p0, rest.p1) == (arc.p1, arc.p0)


def test_changes_keep_everything_in_step() -> None:
    arc = Arc((0, 0), 2, 0, 1)
    arc.end_angle = -pi / 2
    arc.radius = 3
    arc.center = (1, 1)
    arc.start_angle = pi / 2
    assert repr(arc) == repr(Arc((1, 1), 3, pi / 2, -pi / 2))
    fresh = Arc((1, 1), 3, pi / 2, -pi / 2)
    assert (arc.p0, arc.p1, arc.t0, arc.t1, arc.aabb) == (fresh.p0, fresh.p1, fresh.t0, fresh.t1, fresh.aabb)
    arc.set_angles(2, 1)
    assert (arc.start_angle, arc.end_angle) == (2.0, 1.0)


@pytest.mark.parametrize("end", [1.0, 1.0 + 2 * pi, nextafter(1.0, 2.0)])
def test_ends_in_one_place_are_refused(end: float) -> None:
    with pytest.raises(InvalidArgument, match="end_angle must"):
        Arc((1e6, 1e6), 2, 1.0, end)


def test_equal_angles_are_refused_by_setters_too() -> None:
    arc = Arc((0, 0), 2, 0, 1)
    with pytest.raises(
        InvalidArgument, match=r"start_angle must point another way .* \(`angles` sets both at once\), not 1"
    ):
        arc.start_angle = 1
    with pytest.raises(InvalidArgument, match=r"end_angle must point another way than start_angle=0.0 "):
        arc.end_angle = 2 * pi
    with pytest.raises(InvalidArgument, match=r"end_angle must point another way than start_angle=2 "):
        arc.set_angles(2, 2)
    with pytest.raises(InvalidArgument, match=r"angles\[1\] must point another way than angles\[0\]=2.0 "):
        arc.angles = (2, 2)
    assert arc.angles == (0.0, 1.0)


def test_a_full_circle_is_refused_with_the_name_of_what_it_is() -> None:
    with pytest.raises(InvalidArgument) as caught:
        Arc((0, 0), 2, 0, 2 * pi)
    words = "end_angle must point another way than start_angle=0 (a whole circle is a Circle), not 6.283185307179586"
    assert str(caught.value) == words


ANGLES = st.sampled_from([0.0, 1.0, 2.0, 4.0, -1.0]) | st.floats(-10, 10)


@given(ANGLES, ANGLES, ANGLES, ANGLES)
def test_both_angles_are_set_at_once_whatever_they_were(
    start: float, end: float, new_start: float, new_end: float
) -> None:
    assume(fabs(sin((end - start) / 2)) > 1e-6)
    assume(fabs(sin((new_end - new_start) / 2)) > 1e-6)
    arc, fresh = Arc((1, 2), 3, start, end), Arc((1, 2), 3, new_start, new_end)
    arc.angles = (new_start, new_end)
    assert arc.angles == (arc.start_angle, arc.end_angle) == fresh.angles
    assert arc._row.tobytes() == fresh._row.tobytes()


def test_the_closest_point() -> None:
    arc = Arc((0, 0), 2, 0, pi / 2)
    assert arc.closest_point((5, 5)) == pytest.approx((2**0.5, 2**0.5))
    assert arc.closest_point((5, -1)) == (2.0, 0.0)
    assert arc.closest_point((0, 0)) == pytest.approx((2**0.5, 2**0.5))


def test_balls_are_met_from_both_sides_within_the_sector() -> None:
    arc = Arc((0, 0), 10, 0, pi / 2)
    inside, outside = arc.detect(Ball((0, 9.5), 1)), arc.detect(Ball((0, 10.5), 1))
    assert inside is not None
    assert outside is not None
    assert (inside.normal, outside.normal) == ((0.0, -1.0), (0.0, 1.0))
    assert arc.detect(Ball((-0.001, 9.5), 1)) is None


@given(start=st.floats(0, 6.28), span=st.floats(1e-3, 6.28), share=st.floats(0, 1), away=st.floats(0.1, 3))
def test_a_parameter_is_the_way_from_the_first_end_to_the_nearest_place(
    start: float, span: float, share: float, away: float
) -> None:
    assume(abs(sin(0.5 * span)) > 1e-6)
    arc = Arc((1, 2), 2, start, start + span)
    angle = start + share * span
    along = arc.parameter((1 + away * cos(angle), 2 + away * sin(angle)))
    assert along == pytest.approx(min(2 * share * span, arc.length), abs=1e-9)
    assert 0.0 <= along <= arc.length
    assert (arc.parameter(arc.p0), arc.parameter(arc.p1)) == pytest.approx((0.0, arc.length), abs=1e-9)
