"""How each shape looks, by what it does."""

import pytest

import carom
from carom.draw.parts.looks import (
    BUMPER,
    GATE,
    GUARD,
    LOOKS,
    MOVING,
    OFF,
    POST,
    SENSOR,
    WALL,
    Look,
    look_now,
    look_of,
    rounded,
)


@pytest.mark.parametrize(
    ("shape", "look"),
    [
        (carom.Segment((0, 0), (1, 0)), WALL),
        (carom.Segment((0, 0), (1, 0), elasticity=1.5), BUMPER),
        (carom.Circle((0, 0), 1, solid=True, kick=2.0), BUMPER),
        (carom.Arc((0, 0), 1, 0, 1, motion="kinematic"), MOVING),
        (carom.Circle((0, 0), 1, sensor=True), SENSOR),
        (carom.Circle((0, 0), 1, can_collide=False), OFF),
        (carom.Gate((0, 0), (1, 0)), GATE),
        (carom.Point((9, 9)), POST),
        (carom.Point((1, 0)), GUARD),
    ],
)
def test_a_shape_looks_like_what_it_does(shape: carom.Shape, look: Look) -> None:
    assert look_of(shape, frozenset({(0.0, 0.0), (1.0, 0.0)})) is look


def test_a_guard_point_stands_where_lines_end_to_rounding() -> None:
    ends = frozenset({rounded((0.1 + 0.2, 1e9 / 3))})
    assert look_of(carom.Point((0.3, 1e9 / 3 * (1 + 1e-12))), ends) is GUARD
    assert look_of(carom.Point((0.3001, 1e9 / 3)), ends) is POST


def test_a_sensor_that_is_switched_off_is_a_sensor_still_and_a_wall_is_not() -> None:
    for shape, material, off in (
        (carom.Circle((0, 0), 1, sensor=True), SENSOR, SENSOR),
        (carom.Circle((0, 0), 1), WALL, OFF),
        (carom.Gate((0, 0), (1, 0)), GATE, OFF),
    ):
        assert look_now(shape, material) is material
        shape.can_collide = False
        assert look_now(shape, material) is off


def test_lines_grow_with_the_weight_and_areas_have_the_ink_of_their_line() -> None:
    for look in LOOKS:
        assert look.line(2.0).width == 2.0 * look.style.width
        assert (look.area(1.0).fill, look.area(1.0).stroke) == (look.style.stroke, look.style.stroke)
        assert (look.spot().fill, look.spot().stroke) == (look.style.stroke, None)
