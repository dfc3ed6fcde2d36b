"""Compounds: parts that turn and travel as one, and what is set on all of them."""

import copy
import pickle
from typing import Any

import pytest

from carom import Ball, Circle, Compound, InvalidArgument, Motion, Point, Segment, Shape
from tests.kernel_calls import advance_pose
from tests.unit.shapes.vane import vane
from tests.worlds import row_bits


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
