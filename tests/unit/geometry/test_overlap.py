"""Overlaps of a ball with each kind: worked examples, edges, and the cases that have no direction of their own."""

from math import hypot, pi

import pytest

from carom.geometry import overlap as overlaps
from carom.geometry.arc import arc_ends
from tests.flat import flat

overlap = flat(overlaps)
FLOOR = (0.0, 0.0, 1.0, 0.0, 10.0)
QUARTER = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 0.25 * pi, 0.75 * pi))


def test_a_point_pushes_along_the_line_of_centres() -> None:
    assert overlap.overlap_point(1.0, 2.0, 4.0, 6.0, 7.0, 0.0, 0.0) == (1.0, 2.0, 0.6, 0.8, 2.0)


def test_touching_is_no_overlap() -> None:
    assert overlap.overlap_point(1.0, 2.0, 4.0, 6.0, 5.0, 0.0, 0.0) is None
    assert overlap.overlap_segment(*FLOOR, 5.0, 2.0, 2.0, 0.0, -1.0) is None
    assert overlap.overlap_circle(0.0, 0.0, 5.0, 0, 7.0, 0.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_circle(0.0, 0.0, 5.0, 0, 3.0, 0.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_circle(0.0, 0.0, 5.0, 1, 7.0, 0.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_arc(*QUARTER, 0.0, 7.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_ball(0.0, 0.0, 5.0, 7.0, 0.0, 2.0, 0.0, 0.0) is None


def test_a_segment_pushes_to_the_side_where_the_centre_is() -> None:
    assert overlap.overlap_segment(*FLOOR, 4.0, 0.5, 2.0, 0.0, 0.0) == (4.0, 0.0, 0.0, 1.0, 1.5)
    assert overlap.overlap_segment(*FLOOR, 4.0, -0.5, 2.0, 0.0, 0.0) == (4.0, 0.0, 0.0, -1.0, 1.5)


def test_a_centre_past_an_end_of_a_segment_is_rejected() -> None:
    assert overlap.overlap_segment(*FLOOR, 0.0, 1.0, 2.0, 0.0, 0.0) is not None
    assert overlap.overlap_segment(*FLOOR, 10.0, 1.0, 2.0, 0.0, 0.0) is not None
    assert overlap.overlap_segment(*FLOOR, -1e-12, 1.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_segment(*FLOOR, 10.0 + 1e-12, 1.0, 2.0, 0.0, 0.0) is None


def test_the_normal_of_a_segment_keeps_its_digits_next_to_it() -> None:
    contact = overlap.overlap_segment(0.0, 0.0, 0.6, 0.8, 10.0, 3.0 + 8e-16, 4.0, 1.0, 0.0, 0.0)
    assert contact is not None
    assert contact[2:4] == (0.8, -0.6)


def test_a_circle_pushes_out_and_in() -> None:
    assert overlap.overlap_circle(1.0, 0.0, 5.0, 0, 7.5, 0.0, 2.0, 0.0, 0.0) == (6.0, 0.0, 1.0, 0.0, 0.5)
    assert overlap.overlap_circle(1.0, 0.0, 5.0, 0, 4.5, 0.0, 2.0, 0.0, 0.0) == (6.0, 0.0, -1.0, 0.0, 0.5)


def test_a_solid_circle_pushes_out_from_inside() -> None:
    assert overlap.overlap_circle(1.0, 0.0, 5.0, 1, 7.5, 0.0, 2.0, 0.0, 0.0) == (6.0, 0.0, 1.0, 0.0, 0.5)
    assert overlap.overlap_circle(1.0, 0.0, 5.0, 1, 2.0, 0.0, 2.0, 0.0, 0.0) == (6.0, 0.0, 1.0, 0.0, 6.0)


def test_an_arc_pushes_within_its_sector_alone() -> None:
    inside = overlap.overlap_arc(*QUARTER, 0.0, 4.0, 2.0, 0.0, 0.0)
    assert inside == (0.0, 5.0, 0.0, -1.0, 1.0)
    assert overlap.overlap_arc(*QUARTER, 5.0, 0.0, 2.0, 0.0, 0.0) is None
    assert overlap.overlap_arc(*QUARTER, 0.0, -5.0, 2.0, 0.0, 0.0) is None


def test_a_ball_is_pushed_from_the_first_to_the_second() -> None:
    assert overlap.overlap_ball(0.0, 0.0, 2.0, 0.0, -3.0, 4.0, 0.0, 0.0) == (0.0, -2.0, 0.0, -1.0, 3.0)


@pytest.mark.parametrize(
    ("velocity", "normal"), [((0.0, -3.0), (0.0, 1.0)), ((3.0, -4.0), (-0.6, 0.8)), ((0, 0), (0, 1))]
)
def test_where_there_is_no_direction_the_ball_goes_back_where_it_came_from(
    velocity: tuple[float, float], normal: tuple[float, float]
) -> None:
    w = (float(velocity[0]), float(velocity[1]))
    contacts = (
        overlap.overlap_point(1.0, 2.0, 1.0, 2.0, 1.0, *w),
        overlap.overlap_segment(*FLOOR, 4.0, 0.0, 1.0, *w),
        overlap.overlap_circle(0.0, 0.0, 5.0, 0, 3.0, 4.0, 1.0, *w),
        overlap.overlap_circle(3.0, 4.0, 5.0, 1, 3.0, 4.0, 1.0, *w),
        overlap.overlap_arc(0.0, 0.0, 5.0, 5.0, 0.0, -5.0, 0.0, 3.0, 4.0, 1.0, *w),
        overlap.overlap_ball(3.0, 4.0, 5.0, 3.0, 4.0, 1.0, *w),
    )
    for contact in contacts:
        assert contact is not None
        assert contact[2:4] == normal


def test_a_ball_at_the_centre_of_a_circle_that_it_fills_meets_it_at_angle_zero() -> None:
    assert overlap.overlap_circle(1.0, 2.0, 3.0, 0, 1.0, 2.0, 4.0, 0.0, -1.0) == (4.0, 2.0, -1.0, 0.0, 1.0)
    assert overlap.overlap_circle(1.0, 2.0, 3.0, 0, 1.0, 2.0, 3.0, 0.0, -1.0) is None


def test_a_ball_at_the_centre_of_an_arc_that_it_fills_meets_its_middle() -> None:
    contact = overlap.overlap_arc(1.0, 2.0, 3.0, 4.0, 2.0, -2.0, 2.0, 1.0, 2.0, 4.0, 0.0, -1.0)
    assert contact == (1.0, 5.0, 0.0, -1.0, 1.0)


@pytest.mark.parametrize("tangent", [(1.0, 0.0), (0.6, 0.8)])
def test_a_gate_meets_balls_from_its_closed_side_alone(tangent: tuple[float, float]) -> None:
    tx, ty = tangent
    gate = (0.0, 0.0, tx, ty, 10.0, -ty, tx)  # lets pass along its own normal

    def at(side: float, speed: float) -> tuple[float, float, float, float, float] | None:
        x, y = 4.0 * tx - side * ty, 4.0 * ty + side * tx
        return overlap.overlap_gate(*gate, x, y, 1.0, -speed * ty, speed * tx)

    assert at(0.5, -1.0) == overlap.overlap_segment(*gate[:5], 4.0 * tx - 0.5 * ty, 4.0 * ty + 0.5 * tx, 1.0, 0.0, 0.0)
    assert at(0.5, 1.0) is None
    assert at(0.5, 0.0) is None
    assert at(-0.5, 1.0) is None
    assert at(-0.5, -1.0) is None
    assert at(1.5, -1.0) is None


def test_a_ball_on_the_line_of_a_gate_is_let_by() -> None:
    for speed in (-1.0, 0.0, 1.0):
        assert overlap.overlap_gate(*FLOOR, 0.0, 1.0, 4.0, 0.0, 1.0, 0.0, speed) is None


@pytest.mark.parametrize("size", [1e-150, 1e-100, 1e100, 1e150])
def test_overlaps_hold_at_any_magnitude(size: float) -> None:
    contact = overlap.overlap_circle(0.0, 0.0, 5.0 * size, 0, 3.0 * size, 3.5 * size, size, 0.0, 0.0)
    assert contact is not None
    _, _, nx, ny, setback = contact
    assert hypot(nx, ny) == pytest.approx(1.0, abs=1e-15)
    assert setback == pytest.approx(size * (1.0 - (5.0 - hypot(3.0, 3.5))), rel=1e-12)
