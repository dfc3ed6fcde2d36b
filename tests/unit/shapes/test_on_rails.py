"""What moves on rails as one: all parts of a compound turn, travel and are put back, or none is."""

from math import pi

import pytest

from carom import Arc, Compound, InvalidArgument, Point, Segment
from tests.kernel_calls import advance_pose
from tests.unit.shapes.vane import vane
from tests.worlds import row_bits


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


def test_moving_it_moves_all() -> None:
    compound = vane(turn_limits=(0, 1))
    compound.rotate((0, 0), 0.5)
    before = [part.position for part in compound.shapes]
    compound.position = (10, 20)
    after = [part.position for part in compound.shapes]
    assert [(x + 10, y + 20) for x, y in before] == [pytest.approx(place) for place in after]
    assert (compound.pivot, compound.orientation) == ((10.0, 20.0), 0.0)
    compound.position = (11, 18)
    assert [part.position for part in compound.shapes] == [pytest.approx((x + 1, y - 2)) for x, y in after]
    assert (compound.pivot, compound.position) == ((11.0, 18.0), (11.0, 18.0))


def test_a_new_pivot_is_that_of_all() -> None:
    compound = vane()
    compound.pivot = (4, 0)
    assert [part.pivot for part in (compound.center_point, *compound.shapes)] == [(4.0, 0.0)] * 4
    assert compound.center_point.position == (4.0, 0.0)
    compound.rotate((4, 0), pi)
    assert compound.shapes[0].position == pytest.approx((6.0, 0.0))


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
        ("once", True),
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
