"""Segments: the order of their ends, and what follows from it."""

from math import inf, pi

import pytest

from carom import Ball, InvalidArgument, Segment


@pytest.mark.parametrize(("start", "end"), [((5, 1), (2, 7)), ((2, 7), (5, 1))])
def test_p0_is_the_left_end_whatever_order_was_given(start: tuple[int, int], end: tuple[int, int]) -> None:
    segment = Segment(start, end)
    assert (segment.p0, segment.p1) == ((2.0, 7.0), (5.0, 1.0))
    assert (segment.start, segment.end) == (segment.p0, segment.p1)
    assert segment.position == (3.5, 4.0)


def test_p0_of_a_vertical_one_is_the_lower_end() -> None:
    segment = Segment((2, 7), (2, 1))
    assert (segment.p0, segment.t0, segment.normal) == ((2.0, 1.0), (0.0, 1.0), (-1.0, 0.0))


def test_a_vertical_one_stays_in_order() -> None:
    segment = Segment((2, 1), (2, 7))
    segment.p0 = (2, 9)
    assert (segment.p0, segment.p1, segment.t0) == ((2.0, 7.0), (2.0, 9.0), (0.0, 1.0))


def test_tangents_point_into_it() -> None:
    segment = Segment((0, 0), (3, 4))
    assert (segment.length, segment.t0, segment.t1) == (5.0, (0.6, 0.8), (-0.6, -0.8))
    assert segment.normal == (-0.8, 0.6)


def test_the_numbers_of_its_line() -> None:
    segment = Segment((1, 2), (3, 3))
    found = (segment.gradient, segment.inverse_gradient, segment.x_intercept, segment.y_intercept)
    assert found == pytest.approx((0.5, 2.0, -3.0, 1.5))
    assert (Segment((1, 0), (1, 5)).gradient, Segment((0, 2), (5, 2)).x_intercept) == (inf, inf)


def test_an_end_that_moves_past_the_other_swaps_them() -> None:
    segment = Segment((0, 0), (4, 0))
    segment.p0 = (9, 0)
    assert (segment.p0, segment.p1, segment.pivot) == ((4.0, 0.0), (9.0, 0.0), (6.5, 0.0))
    segment.end = (4, 3)
    assert (segment.p0, segment.p1) == ((4.0, 0.0), (4.0, 3.0))
    segment.set_ends((1, 1), (0, 1))
    assert (segment.start, segment.length, tuple(segment.aabb)) == ((0.0, 1.0), 1.0, (0.0, 1.0, 1.0, 1.0))


def test_the_order_holds_after_half_a_turn() -> None:
    segment = Segment((0, 0), (4, 0), motion="kinematic")
    segment.rotate((0, 0), 0.75 * pi)
    assert segment.p0 == pytest.approx((-4 * 0.5**0.5, 4 * 0.5**0.5))
    assert segment.p1 == (0.0, 0.0)


def test_the_closest_point_is_an_end_past_it() -> None:
    segment = Segment((0, 0), (4, 0))
    assert [segment.closest_point(p) for p in [(-3, 4), (1, 9), (5, 0)]] == [(0.0, 0.0), (1.0, 0.0), (4.0, 0.0)]
    assert segment.distance((-3, 4)) == 5.0


@pytest.mark.parametrize("x", [-0.001, 4.001])
def test_past_an_end_a_ball_misses(x: float) -> None:
    assert Segment((0, 0), (4, 0)).detect(Ball((x, 0.1), 1)) is None
    assert Segment((0, 0), (4, 0)).detect(Ball((min(max(x, 0.0), 4.0), 0.1), 1)) is not None


def test_ends_that_rounding_makes_one_are_refused() -> None:
    segment = Segment((0, 0), (1e-10, 0))
    with pytest.raises(InvalidArgument, match="position must leave the two ends apart"):
        segment.position = (1e10, 0)
    assert segment.p1 == (1e-10, 0.0)


def test_the_range_of_numbers_is_not_left() -> None:
    with pytest.raises(InvalidArgument, match="end must leave the shape's place and box finite"):
        Segment((-1.7e308, 0), (1.7e308, 0))
    assert Segment((0, 0), (1.7e308, 0)).t0 == (1.0, 0.0)
    assert Segment((0, 0), (5e-324, 0)).t0 == (1.0, 0.0)


def test_a_parameter_is_the_way_from_the_first_end_to_the_nearest_place() -> None:
    segment = Segment((4, 3), (0, 0))
    assert segment.parameter((0.8 * 2 - 0.6, 0.6 * 2 + 0.8)) == pytest.approx(2.0)
    assert (segment.parameter((-1, -1)), segment.parameter((9, 9))) == (0.0, 5.0)
    assert segment.parameter(segment.p1) == pytest.approx(5.0)
