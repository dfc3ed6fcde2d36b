"""Compounds: parts that turn and travel as one, and what is set on all of them."""

import copy
import pickle
from math import pi
from typing import Any

import pytest

from carom import Arc, Ball, Circle, Compound, InvalidArgument, Motion, Point, Segment, Shape
from carom.rows.pose import advance_pose
from tests.worlds import row_bits


def vane(**options: Any) -> Compound:
    """A compound of three kinds of parts."""
    return Compound([Segment((1, 0), (3, 0)), Circle((4, 0), 1), Arc((0, 2), 1, 0, 1)], pivot=(0, 0), **options)


def test_parts_become_kinematic_about_its_pivot() -> None:
    compound = vane()
    assert [part.motion for part in compound.shapes] == [Motion.KINEMATIC] * 3
    assert [part.pivot for part in compound.shapes] == [(0.0, 0.0)] * 3
    assert (compound.kind, compound.motion, compound.pivot, compound.position) == (
        "compound",
        Motion.KINEMATIC,
        (0.0, 0.0),
        (0.0, 0.0),
    )
    assert all(part.compound is compound and part in compound for part in compound.shapes)


def test_the_center_point_is_a_part_that_meets_nothing() -> None:
    compound = vane()
    center = compound.center_point
    assert (center.kind, center.position, center.can_collide, center.compound) == ("point", (0.0, 0.0), False, compound)
    assert center not in compound.shapes
    compound.can_collide = True
    assert not center.can_collide
    assert compound.detect(Ball((0, 0), 0.5)) is None


def test_it_turns_as_one() -> None:
    compound = vane()
    compound.rotate((0, 0), pi / 2)
    segment, circle, arc = compound.shapes
    assert isinstance(segment, Segment)
    assert isinstance(arc, Arc)
    assert segment.p1 == pytest.approx((0.0, 3.0))
    assert circle.position == pytest.approx((0.0, 4.0))
    assert arc.start_angle == pytest.approx(pi / 2)
    assert [part.orientation for part in compound.shapes] == [compound.orientation] * 3 == [pi / 2] * 3
    compound.orientation = 0.0
    assert row_bits(compound) == row_bits(vane())


def test_reset_restores_all() -> None:
    compound = vane(velocity=(1, 2), angular_velocity=1)
    for part in (compound.center_point, *compound.shapes):
        advance_pose(part._row, 0.3)
    assert compound.position == (0.3, 0.6)
    assert compound.shapes[1].position != (4.0, 0.0)
    compound.reset()
    assert row_bits(compound) == row_bits(vane(velocity=(1, 2), angular_velocity=1))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("angular_velocity", 2.0),
        ("rotating", False),
        ("turn_limits", (-1.0, 1.0)),
        ("velocity", (1.0, 2.0)),
        ("elasticity", 0.5),
        ("kick", 3.0),
        ("sensor", True),
        ("can_collide", False),
        ("layer", 4),
        ("collides_with", 5),
    ],
)
def test_what_is_set_holds_for_all_parts_also_later_ones(name: str, value: object) -> None:
    compound = vane()
    setattr(compound, name, value)
    late = compound.add(Point((9, 9)))
    assert getattr(compound, name) == value
    assert [getattr(part, name) for part in compound.shapes] == [value] * 4
    assert late.compound is compound
    assert [getattr(part, name) for part in vane(**{name: value}).shapes] == [value] * 3


def test_a_surface_that_is_not_set_is_each_parts_own() -> None:
    compound = Compound([Point((0, 0), elasticity=0.5), Point((1, 0), elasticity=0.25)], (0, 0))
    assert compound.elasticity is None
    assert [part.elasticity for part in compound.shapes] == [0.5, 0.25]
    compound.elasticity = 0.75
    compound.elasticity = None
    compound.add(Point((2, 0), elasticity=0.125))
    assert [part.elasticity for part in compound.shapes] == [0.75, 0.75, 0.125]


def test_a_part_added_later_is_where_it_would_be_had_it_been_there_from_the_start() -> None:
    early, late = vane(velocity=(1, 0), angular_velocity=1), vane(velocity=(1, 0), angular_velocity=1)
    early.add(Point((5, 5)))
    for compound in (early, late):
        for part in (compound.center_point, *compound.shapes):
            advance_pose(part._row, 0.5)
    late.add(Point((5, 5)))
    assert early.shapes[3].position == late.shapes[3].position
    assert (late.shapes[3].orientation, late.shapes[3].pivot) == (0.5, (0.5, 0.0))
    late.reset()
    assert late.shapes[3].position == (5.0, 5.0)


def test_moving_it_moves_all() -> None:
    compound = vane(turn_limits=(0, 1))
    compound.rotate((0, 0), 0.5)
    before = [part.position for part in compound.shapes]
    compound.position = (10, 20)
    after = [part.position for part in compound.shapes]
    assert [(x + 10, y + 20) for x, y in before] == [pytest.approx(place) for place in after]
    assert (compound.pivot, compound.orientation) == ((10.0, 20.0), 0.0)


def test_a_new_pivot_is_that_of_all() -> None:
    compound = vane()
    compound.pivot = (4, 0)
    assert [part.pivot for part in (compound.center_point, *compound.shapes)] == [(4.0, 0.0)] * 4
    assert compound.center_point.position == (4.0, 0.0)
    compound.rotate((4, 0), pi)
    assert compound.shapes[0].position == pytest.approx((6.0, 0.0))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("position", (1, 1)),
        ("pivot", (1, 1)),
        ("velocity", (1, 1)),
        ("angular_velocity", 1),
        ("rotating", False),
        ("turn_limits", None),
        ("motion", "static"),
        ("radius", 2),
        ("center", (1, 1)),
    ],
)
def test_where_parts_are_is_left_to_the_compound(name: str, value: object) -> None:
    compound = vane()
    with pytest.raises(InvalidArgument, match=f"{name} must be left to the compound"):
        setattr(compound.shapes[1], name, value)
    assert row_bits(compound) == row_bits(vane())


def test_a_part_does_not_turn_alone() -> None:
    part = vane().shapes[0]
    with pytest.raises(InvalidArgument, match="angle must be left to the compound"):
        part.rotate((0, 0), 1)
    with pytest.raises(InvalidArgument, match="reset must be left to the compound"):
        part.reset()


def test_a_shape_is_part_of_one_compound_once() -> None:
    compound, free = vane(), Point((0, 0))
    with pytest.raises(InvalidArgument, match="shape must not be part of a compound already"):
        vane().add(compound.shapes[0])
    with pytest.raises(InvalidArgument, match=r"shapes\[1\] must not be part of a compound already"):
        Compound([free, compound.shapes[0]], (0, 0))
    with pytest.raises(InvalidArgument, match="shapes must not hold a shape twice"):
        Compound([free, free], (0, 0))
    assert (free.compound, free.motion) == (None, Motion.STATIC)


def test_an_angle_beyond_the_limits_is_refused_and_nothing_turns() -> None:
    compound = vane(turn_limits=(0, 1))
    with pytest.raises(InvalidArgument, match="angle must be within turn_limits"):
        compound.rotate((0, 0), 1.5)
    with pytest.raises(InvalidArgument, match="orientation must be within turn_limits"):
        compound.orientation = -0.1
    assert row_bits(compound) == row_bits(vane(turn_limits=(0, 1)))


def test_what_fails_on_one_part_changes_none() -> None:
    compound = Compound([Point((0, 0)), Point((1.7e308, 0))], (0, 0))
    before = row_bits(compound)
    with pytest.raises(InvalidArgument, match="position must leave"):
        compound.position = (1.7e308, 0)
    assert row_bits(compound) == before


def test_a_contact_is_with_the_part_and_points_come_first() -> None:
    compound = Compound([Segment((0, 0), (4, 0)), Point((4, 0))], (0, 0), angular_velocity=2)
    contact = compound.detect(Ball((4, 0.5), 1))
    assert contact is not None
    assert contact.shape is compound.shapes[1]
    assert contact.speed == 8.0
    contact = compound.detect(Ball((2, 0.5), 1))
    assert contact is not None
    assert contact.shape is compound.shapes[0]


def test_its_box_and_distances_are_those_of_its_parts() -> None:
    compound = Compound([Segment((0, 0), (4, 0)), Circle((9, 1), 1)], (5, 5))
    assert tuple(compound.aabb) == (0.0, 0.0, 10.0, 2.0)
    assert (compound.closest_point((4.5, 0)), compound.distance((4, -3))) == ((4.0, 0.0), 3.0)
    empty = Compound([], (5, 5))
    assert (tuple(empty.aabb), empty.closest_point((0, 0))) == ((5.0, 5.0, 5.0, 5.0), (5.0, 5.0))


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda compound: pickle.loads(pickle.dumps(compound))])
def test_copies_have_parts_of_their_own(copied: Any) -> None:
    compound = vane(name="vane", user=[1], elasticity=0.5)
    compound.rotate((0, 0), 1)
    twin = copied(compound)
    assert row_bits(twin) == row_bits(compound)
    assert (twin.name, twin.user, twin.elasticity) == ("vane", [1], 0.5)
    assert all(part.compound is twin for part in twin.shapes)
    assert all(part.compound is compound for part in compound.shapes)
    twin.rotate((0, 0), 2)
    assert (compound.orientation, twin.orientation) == (1.0, 2.0)


def test_a_copy_of_a_part_is_free() -> None:
    part = vane().shapes[0]
    twin: Shape = copy.deepcopy(part)
    assert twin.compound is None
    twin.position = (9, 9)
    assert part.position == (2.0, 0.0)
