"""Guard points: which ends need one, and which do not."""

from math import pi

import pytest

from carom import Arc, Circle, Compound, Gate, Motion, Point, Segment, Shape, guard_points


def places(shapes: list[Shape | Compound], **tolerances: float) -> list[tuple[float, float]]:
    """Where guard points stand."""
    return [point.position for point in guard_points(shapes, **tolerances)]


FLOOR = Segment((0, 0), (4, 0))


def test_a_lone_segment_or_arc_needs_two() -> None:
    assert places([FLOOR]) == [(0.0, 0.0), (4.0, 0.0)]
    assert places([Arc((0, 0), 1, 0, 1)]) == [Arc((0, 0), 1, 0, 1).p0, Arc((0, 0), 1, 0, 1).p1]


def test_a_corner_needs_one() -> None:
    assert places([FLOOR, Segment((4, 0), (6, 3))]) == [(0.0, 0.0), (4.0, 0.0), (6.0, 3.0)]
    square = [Segment(a, b) for a, b in [((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0))]]
    assert sorted(places(square)) == [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)]


def test_a_smooth_joint_needs_none() -> None:
    assert places([FLOOR, Segment((4, 0), (9, 0))]) == [(0.0, 0.0), (9.0, 0.0)]
    bend = Arc((4, 1), 1, -pi / 2, 0)
    assert places([FLOOR, bend]) == [(0.0, 0.0), bend.p1]
    stadium = [FLOOR, Segment((0, 2), (4, 2)), Arc((4, 1), 1, -pi / 2, pi / 2), Arc((0, 1), 1, pi / 2, -pi / 2)]
    assert places(stadium) == []


def test_a_cusp_needs_one() -> None:
    assert (0.0, 0.0) in places([Segment((0, 0), (-4, 0)), Segment((0, 0), (-9, 0))])
    below, above = Arc((0, -1), 1, pi / 2, pi), Arc((0, 1), 1, -pi, -pi / 2)
    assert below.p0 == pytest.approx((0, 0), abs=1e-15)
    assert len([place for place in places([below, above]) if place == pytest.approx((0, 0), abs=1e-15)]) == 1


def test_how_smooth_a_joint_must_be() -> None:
    bent = [FLOOR, Segment((4, 0), (8, 4e-3))]
    assert places(bent) == [(0.0, 0.0), (4.0, 0.0), (8.0, 4e-3)]
    assert places(bent, angle_tolerance=2e-3) == [(0.0, 0.0), (8.0, 4e-3)]


def test_how_near_ends_are_one_place() -> None:
    apart = [FLOOR, Segment((4 + 1e-6, 0), (4 + 1e-6, 3))]
    assert len(places(apart)) == 4
    assert places(apart, tolerance=1e-5) == [(0.0, 0.0), (4.0, 0.0), (4 + 1e-6, 3.0)]
    assert places([FLOOR, Segment((4, 0), (6, 3))], tolerance=0) == [(0.0, 0.0), (4.0, 0.0), (6.0, 3.0)]


@pytest.mark.parametrize(
    "cover",
    [
        Segment((4, -1), (4, 2)),
        Arc((5, 0), 1, pi / 2, -pi / 2),
        Circle((4.5, 0), 1, solid=True),
        Circle((5, 0), 1),
        Point((4, 0)),
    ],
    ids=repr,
)
def test_an_end_within_another_shape_needs_none(cover: Shape) -> None:
    found = places([FLOOR, cover])
    assert (0.0, 0.0) in found
    assert (4.0, 0.0) not in found


def test_the_inside_of_an_arena_covers_nothing() -> None:
    assert places([FLOOR, Circle((2, 0), 9)]) == [(0.0, 0.0), (4.0, 0.0)]


@pytest.mark.parametrize(
    "shape", [Gate((4, -1), (4, 2)), Segment((4, -1), (4, 2), sensor=True), Segment((4, -1), (4, 2), can_collide=False)]
)
def test_what_does_not_stop_every_ball_neither_needs_points_nor_covers_ends(shape: Shape) -> None:
    assert places([FLOOR, shape]) == [(0.0, 0.0), (4.0, 0.0)]


def test_a_guarded_scene_needs_no_more() -> None:
    walls: list[Shape | Compound] = [FLOOR, Segment((4, 0), (6, 3)), Arc((0, 1), 1, pi / 2, 2)]
    assert places([*walls, *guard_points(walls)]) == []


def test_a_point_has_the_surface_of_the_first_shape_that_ends_there() -> None:
    wall = Segment((4, 0), (6, 3), elasticity=0.5, kick=2, layer=4, collides_with=6)
    point = guard_points([wall, FLOOR])[0]
    assert (point.elasticity, point.kick, point.layer, point.collides_with) == (0.5, 2.0, 4, 6)
    assert point.motion is Motion.STATIC


def test_shapes_that_move_differently_part() -> None:
    hand = Segment((4, 0), (8, 0), motion="kinematic", pivot=(4, 0), angular_velocity=3, turn_limits=(-1, 1))
    hand.rotate((4, 0), 0.25)
    found = guard_points([FLOOR, hand])
    assert [point.position for point in found] == [(0.0, 0.0), (4.0, 0.0), (4.0, 0.0), hand.p1]
    assert [point.motion for point in found] == [Motion.STATIC] * 2 + [Motion.KINEMATIC] * 2
    tip = found[3]
    assert (tip.pivot, tip.angular_velocity, tip.turn_limits) == ((4.0, 0.0), 3.0, (-1.25, 0.75))


def test_the_points_of_a_moving_shape_stay_at_its_ends() -> None:
    hand = Segment((4, 0), (8, 0), motion="kinematic", pivot=(4, 0), turn_limits=(-1, 1))
    hand.rotate((4, 0), 0.25)
    tip = guard_points([hand])[1]
    hand.rotate((4, 0), 0.75)
    tip.rotate((4, 0), 0.5)
    assert tip.position == pytest.approx(hand.p1)


def test_the_parts_of_a_compound_are_looked_at_together() -> None:
    corner = Compound([Segment((0, 0), (4, 0)), Segment((4, 0), (4, 4))], pivot=(0, 0), velocity=(1, 0))
    found = guard_points([corner])
    assert [point.position for point in found] == [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)]
    assert found[0].velocity == (1.0, 0.0)
    assert corner.shapes[0].compound is corner


def test_a_segment_shorter_than_the_tolerance_does_not_continue_itself() -> None:
    assert places([Segment((0, 0), (1e-12, 0))], tolerance=1e-9) == [(0.0, 0.0)]
    assert len(places([Segment((0, 0), (1e-12, 0))])) == 2


def test_shapes_of_every_size_are_told_apart() -> None:
    tiny = [Segment((0, 0), (1e-9, 0)), Segment((1e-9, 0), (1e-9, -1e-9))]
    assert places(tiny) == [(0.0, 0.0), (1e-9, 0.0), (1e-9, -1e-9)]
    assert places(tiny, tolerance=1e-8) == [(0.0, 0.0)]
    huge = [Segment((0, 0), (1e12, 0)), Segment((1e12 + 1e2, 0), (1e12, 1e12))]
    assert places(huge) == [(0.0, 0.0), (1e12, 0.0), (1e12, 1e12)]


def test_a_tolerance_of_any_length_is_taken() -> None:
    corner = [FLOOR, Segment((4, 0), (6, 3))]
    for tolerance in (0, 5e-324, 1e-300):
        assert places(corner, tolerance=tolerance) == [(0.0, 0.0), (4.0, 0.0), (6.0, 3.0)]
    for tolerance in (1e300, 1.7e308):
        assert places(corner, tolerance=tolerance) == [(0.0, 0.0)]
    assert places(corner, angle_tolerance=1e308) == [(0.0, 0.0), (6.0, 3.0)]


def test_an_arc_that_all_but_closes_continues_itself() -> None:
    assert places([Arc((0, 0), 1, 1, 1 - 1e-12)]) == []
    assert len(places([Arc((0, 0), 1, 1, 1 - 1e-3)])) == 2
