"""Motion on rails: turning, travelling, resetting, and what is refused."""

from math import pi

import pytest

from carom import Arc, Circle, InvalidArgument, Motion, Point, Segment, Shape
from tests.worlds import row_bits

SHAPES: list[Shape] = [
    Point((1, 2), motion="kinematic"),
    Segment((1, 2), (4, 6), motion="kinematic"),
    Circle((1, 2), 3, motion="kinematic"),
    Arc((1, 2), 3, 1, 2, motion="kinematic"),
]
each_shape = pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.kind)


def test_a_quarter_turn_of_each_kind() -> None:
    point = Point((3, 1), motion=Motion.KINEMATIC)
    point.rotate((1, 1), pi / 2)
    assert point.position == pytest.approx((1.0, 3.0))
    segment = Segment((1, 1), (3, 1), motion="kinematic")
    segment.rotate((1, 1), pi / 2)
    assert (segment.p0, segment.p1) == (pytest.approx((1.0, 1.0)), pytest.approx((1.0, 3.0)))
    assert segment.normal == pytest.approx((-1.0, 0.0))
    arc = Arc((3, 1), 1, 0, 1, motion="kinematic")
    arc.rotate((1, 1), -pi / 2)
    assert (arc.center, arc.start_angle) == (pytest.approx((1.0, -1.0)), pytest.approx(1.5 * pi))
    assert arc.p0 == pytest.approx((1.0, -2.0))


@each_shape
def test_a_million_small_turns_are_one_turn(shape: Shape) -> None:
    for k in range(1000):  # always from the initial geometry, so the number of turns does not matter
        shape.rotate((5, 5), k * 0.001)
    many = row_bits(shape)
    shape.reset()
    shape.rotate((5, 5), 0.999)
    assert row_bits(shape) == many


@each_shape
def test_reset_restores_the_initial_geometry_bit_for_bit(shape: Shape) -> None:
    shape.reset()
    box, place = shape.aabb, shape.position
    shape.rotate((0.1, 0.7), 1.234)
    assert shape.position != place
    shape.reset()
    assert (shape.aabb, shape.position, shape.orientation) == (box, place, 0.0)


@each_shape
def test_setting_any_geometry_makes_it_the_initial_one(shape: Shape) -> None:
    shape.rotate((0, 0), 1.0)
    shape.position = (7, 7)
    place, box = shape.position, shape.aabb
    assert (place, shape.orientation) == (pytest.approx((7.0, 7.0)), 0.0)
    shape.rotate(shape.pivot, 2.0)
    shape.reset()
    assert (shape.position, shape.aabb) == (place, box)


def test_the_pivot_moves_with_the_shape() -> None:
    segment = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0))
    segment.position = (1, 5)
    assert (segment.p0, segment.pivot) == ((0.0, 5.0), (0.0, 5.0))
    circle = Circle((0.1, 0.1), 1)
    circle.position = (0.3, 0.7)
    assert circle.pivot == circle.position == (0.3, 0.7)
    wall = Segment((0.1, 0.1), (0.2, 7.3))
    wall.position = (0.3, 0.7)
    wall.p0 = (5, 5)
    assert wall.pivot == wall.position


def test_a_new_pivot_leaves_the_shape_where_it_is() -> None:
    segment = Segment((0, 0), (2, 0), motion="kinematic")
    segment.rotate((0, 0), 1.0)
    place = segment.p0, segment.p1
    segment.pivot = (9, 9)
    assert (segment.p0, segment.p1, segment.orientation, segment.pivot) == (*place, 0.0, (9.0, 9.0))


def test_a_static_shape_does_not_turn() -> None:
    with pytest.raises(InvalidArgument, match="motion must be 'kinematic' for a shape that is to turn, not 'static'"):
        Point((0, 0)).rotate((0, 0), 1.0)


def test_the_velocity_of_a_surface() -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=3, velocity=(1, -1))
    assert hand.surface_velocity((2, 0)) == (1.0, 5.0)
    assert hand.surface_velocity((0, 2)) == (-5.0, -1.0)
    hand.rotating = False
    assert hand.surface_velocity((2, 0)) == (1.0, -1.0)
    assert Segment((0, 0), (2, 0)).surface_velocity((2, 0)) == (0.0, 0.0)


def test_a_shape_that_is_pressed_against_its_stop_does_not_turn() -> None:
    hand = Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=-3, turn_limits=(0, 1))
    assert hand.surface_velocity((2, 0)) == (0.0, 0.0)
    hand.angular_velocity = 3
    assert hand.surface_velocity((2, 0)) == (0.0, 6.0)
