"""What balls and shapes must be for a step to be made."""

from math import inf, nan

import pytest

from carom import Segment
from carom.world.kernels.step.soundness import (
    is_good,
    is_in_reach,
    is_measured,
    is_sound,
    shapes_are_sound,
)
from tests.kernel_calls import ball_rows
from tests.worlds import world_of


@pytest.mark.parametrize(
    ("field", "value", "expected"),
    [
        ("x", 1e300, (True, True, True)),
        ("y", inf, (False, True, False)),
        ("vx", nan, (False, True, False)),
        ("mass", nan, (True, False, False)),
        ("radius", -1.0, (True, True, False)),
        ("friction", -1.0, (True, True, True)),
        ("friction", -2.0, (True, True, False)),
    ],
)
def test_a_ball_is_sound_measured_and_good(field: str, value: float, expected: tuple[bool, bool, bool]) -> None:
    ball = ball_rows([(0.0, 0.0, 1.0)])[0]
    ball[field] = value
    assert (is_sound(ball), is_measured(ball), is_good(ball)) == expected


@pytest.mark.parametrize("side", ["left", "bottom", "right", "top"])
def test_a_shape_is_where_numbers_reach_if_all_of_its_box_is(side: str) -> None:
    rows = world_of(Segment((0, 0), (1, 1)), Segment((2, 0), (3, 1)))._arrays.shapes.rows
    assert is_in_reach(rows[1])
    rows[1][side] = inf
    assert not is_in_reach(rows[1])
    assert [shapes_are_sound(rows, [0, 1], *span) for span in ((0, 1), (0, 2), (2, 2))] == [True, False, True]
