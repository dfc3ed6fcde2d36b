"""Laws of overlaps, for every kind of shape and a ball near it."""

from math import cos, hypot, isfinite, pi, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.geometry import overlap as overlaps
from carom.geometry.arc import arc_ends
from carom.geometry.vector import unit
from tests import naive
from tests.flat import flat
from tests.strategies import (
    Ball,
    Figure,
    Motion,
    angles,
    arcs,
    balls,
    circles,
    extremes,
    meetings,
    motions,
    positive_extremes,
    segments,
    vectors,
)

overlap = flat(overlaps)
Vector = tuple[float, float]
#: Lengths; the figures of these tests are within 200 of the origin.
ROUNDING = 1e-12
CLEAR = 1e-9


def alike(contact: naive.Contact | None, other: naive.Contact | None, tolerance: float) -> bool:
    """Whether two answers are both misses, or nearly the same contact."""
    if contact is None or other is None:
        return contact is other
    return contact == pytest.approx(other, rel=tolerance, abs=tolerance)


@given(meetings(), vectors)
def test_the_normal_is_a_unit_vector_and_the_setback_is_positive(meeting: tuple[Figure, Ball], w: Vector) -> None:
    figure, (x, y, radius) = meeting
    contact = naive.carom_overlap(figure, x, y, radius, *w)
    if contact is None:
        return
    _, _, nx, ny, setback = contact
    assert hypot(nx, ny) == pytest.approx(1.0, abs=5e-16)
    assert 0.0 < setback <= radius + (figure[1][2] if figure[0] == "disc" else 0.0)


@given(meetings(), vectors)
def test_pushed_out_the_ball_touches_and_is_no_longer_found(meeting: tuple[Figure, Ball], w: Vector) -> None:
    figure, (x, y, radius) = meeting
    contact = naive.carom_overlap(figure, x, y, radius, *w)
    assume(contact is not None and naive.margin(figure, x, y, radius) > CLEAR)
    px, py, nx, ny, setback = contact or (0.0,) * 5
    touching = (x + setback * nx, y + setback * ny)
    assert hypot(touching[0] - px, touching[1] - py) == pytest.approx(radius, rel=0.0, abs=ROUNDING)
    beyond = (x + (setback + ROUNDING) * nx, y + (setback + ROUNDING) * ny)
    left = naive.carom_overlap(figure, *beyond, radius, *w)
    # Out of a hollow circle narrower than itself a ball cannot get by one push.
    hollow = figure[0] in {"circle", "arc"} and figure[1][2] < radius + CLEAR
    inside = hollow and hypot(x - figure[1][0], y - figure[1][1]) < figure[1][2]
    assert left is None or inside


@given(meetings(), vectors)
def test_the_point_of_contact_is_on_the_shape_and_the_normal_leads_from_it(
    meeting: tuple[Figure, Ball], w: Vector
) -> None:
    figure, (x, y, radius) = meeting
    contact = naive.carom_overlap(figure, x, y, radius, *w)
    assume(contact is not None and naive.margin(figure, x, y, radius) > CLEAR)
    px, py, nx, ny, _ = contact or (0.0,) * 5
    kind, given_ = figure
    place = naive.closest(figure, px, py) if kind != "point" else given_
    assert place == pytest.approx((px, py), abs=1e-10)
    inside = kind == "disc" and hypot(x - given_[0], y - given_[1]) < given_[2]
    assert (nx * (x - px) + ny * (y - py) > 0.0) is not inside


@given(meetings(), vectors)
def test_overlaps_are_those_of_the_slow_twin(meeting: tuple[Figure, Ball], w: Vector) -> None:
    figure, (x, y, radius) = meeting
    assume(naive.margin(figure, x, y, radius) > 1e-6)
    expected = naive.find_overlap(figure, x, y, radius)
    contact = naive.carom_overlap(figure, x, y, radius, *w)
    assert alike(contact, expected, 1e-7)


@given(meetings(), vectors, motions)
def test_moved_as_one_shape_and_ball_meet_as_before(meeting: tuple[Figure, Ball], w: Vector, motion: Motion) -> None:
    figure, (x, y, radius) = meeting
    assume(naive.margin(figure, x, y, radius) > 1e-6)
    turn = (motion[0], 0.0, 0.0)
    before = naive.carom_overlap(figure, x, y, radius, *w)
    figure = naive.moved_figure(motion, figure)
    after = naive.carom_overlap(figure, *naive.moved_point(motion, x, y), radius, *naive.moved_point(turn, *w))
    if before is not None:
        px, py, nx, ny, setback = before
        before = (*naive.moved_point(motion, px, py), *naive.moved_point(turn, nx, ny), setback)
    assert alike(after, before, 1e-7)


@given(meetings())
def test_the_velocity_does_not_matter_where_the_normal_has_a_direction(meeting: tuple[Figure, Ball]) -> None:
    figure, ball = meeting
    assume(naive.margin(figure, *ball) > CLEAR)
    assert naive.carom_overlap(figure, *ball, 1.0, 2.0) == naive.carom_overlap(figure, *ball, -7.0, 0.0)


@given(balls, balls, vectors)
def test_two_balls_see_each_other_alike(first: Ball, second: Ball, w: Vector) -> None:
    there = overlap.overlap_ball(*first, *second, *w)
    back = overlap.overlap_ball(*second, *first, -w[0], -w[1])
    assert (there is None) == (back is None)
    if there is not None and back is not None and (first[:2] != second[:2] or w != (0.0, 0.0)):
        assert (back[2], back[3], back[4]) == (-there[2], -there[3], there[4])


@given(segments(), balls)
def test_a_segment_is_the_same_from_its_other_end(segment: tuple[float, float, float, float], ball: Ball) -> None:
    x, y, radius = ball
    assume(naive.margin(("segment", segment), x, y, radius) > CLEAR)
    there = naive.carom_overlap(("segment", segment), x, y, radius, 0.0, 0.0)
    back = naive.carom_overlap(("segment", segment[2:] + segment[:2]), x, y, radius, 0.0, 0.0)
    assert alike(there, back, 1e-12)


@given(arcs(), balls, vectors)
def test_an_arc_and_its_complement_make_the_circle(
    arc: tuple[float, float, float, float, float], ball: Ball, w: Vector
) -> None:
    cx, cy, r, start, end = arc
    whole = overlap.overlap_circle(cx, cy, r, 0, *ball, *w)
    parts = [
        overlap.overlap_arc(cx, cy, r, *arc_ends(cx, cy, r, *edges), *ball, *w)
        for edges in ((start, end), (end, start))
    ]
    if ball[:2] != (cx, cy):
        assert {part for part in parts if part is not None} == ({whole} if whole is not None else set())


@given(circles, balls, vectors)
def test_outside_a_circle_solid_and_hollow_are_the_same(
    circle: tuple[float, float, float], ball: Ball, w: Vector
) -> None:
    assume(naive.margin(("circle", circle), *ball) > CLEAR)
    assume(hypot(ball[0] - circle[0], ball[1] - circle[1]) > circle[2])
    hollow = overlap.overlap_circle(*circle, 0, *ball, *w)
    solid = overlap.overlap_circle(*circle, 1, *ball, *w)
    assert alike(solid, hollow, 1e-13)


@given(segments(), balls, vectors, angles)
def test_a_gate_is_a_segment_to_a_ball_from_one_side_and_nothing_from_the_other(
    segment: tuple[float, float, float, float], ball: Ball, w: Vector, angle: float
) -> None:
    ax, ay, bx, by = segment
    tx, ty = unit(bx - ax, by - ay) or (1.0, 0.0)
    length = hypot(bx - ax, by - ay)
    dx, dy = cos(angle), sin(angle)
    assume(abs(tx * dy - ty * dx) > 1e-6 and naive.margin(("segment", segment), *ball) > CLEAR)
    plain = overlap.overlap_segment(ax, ay, tx, ty, length, *ball, *w)
    one_way = overlap.overlap_gate(ax, ay, tx, ty, length, dx, dy, *ball, *w)
    other_way = overlap.overlap_gate(ax, ay, tx, ty, length, -dx, -dy, *ball, *w)
    approaches = plain is not None and plain[2] * w[0] + plain[3] * w[1] < 0.0
    assert [contact for contact in (one_way, other_way) if contact is not None] == ([plain] if approaches else [])


@given(st.tuples(*[extremes] * 6), positive_extremes, positive_extremes, extremes, extremes)
def test_every_answer_is_finite_at_any_magnitude(
    places: tuple[float, ...], r: float, radius: float, wx: float, wy: float
) -> None:
    cx, cy, ax, ay, x, y = places
    tx, ty = unit(ax - cx, ay - cy) or (0.0, 1.0)
    contacts = (
        overlap.overlap_point(cx, cy, x, y, radius, wx, wy),
        overlap.overlap_segment(cx, cy, tx, ty, r, x, y, radius, wx, wy),
        overlap.overlap_gate(cx, cy, tx, ty, r, -ty, tx, x, y, radius, wx, wy),
        overlap.overlap_circle(cx, cy, r, 0, x, y, radius, wx, wy),
        overlap.overlap_circle(cx, cy, r, 1, x, y, radius, wx, wy),
        overlap.overlap_arc(cx, cy, r, *arc_ends(cx, cy, r, 0.3, 0.3 + pi), x, y, radius, wx, wy),
        overlap.overlap_ball(cx, cy, r, x, y, radius, wx, wy),
    )
    for contact in contacts:
        assert contact is None or (all(map(isfinite, contact)) and hypot(*contact[2:4]) == pytest.approx(1.0))
