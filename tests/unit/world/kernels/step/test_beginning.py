"""The beginning of a step: what is refused."""

from math import inf, nan

import pytest

from carom import Ball
from carom.constants import FEW_TO_SORT
from carom.rows.state import DONE, NOT_FINITE, REFUSED
from tests.kernel_calls import begun, contents, prepared
from tests.worlds import world_of


@pytest.mark.parametrize(
    ("field", "value", "status"),
    [
        *[(field, nan, NOT_FINITE) for field in ("x", "y", "vx", "vy", "radius", "mass", "elasticity", "friction")],
        *[("x", inf, NOT_FINITE), ("mass", inf, NOT_FINITE)],
        *[
            ("radius", 0.0, REFUSED),
            ("mass", -1.0, REFUSED),
            ("elasticity", -0.5, REFUSED),
            ("friction", -2.0, REFUSED),
        ],
        *[("elasticity", 0.0, DONE), ("friction", -1.0, DONE), ("x", -1e300, DONE)],
    ],
)
@pytest.mark.parametrize("balls", [3, FEW_TO_SORT + 2])
def test_a_step_does_not_begin_with_a_ball_that_cannot_be(field: str, value: float, status: int, balls: int) -> None:
    arrays = prepared(world_of(*(Ball((3.0 * k, 0), 1, (1, 2)) for k in range(balls)), gravity=(0, -1)))
    arrays.states[0]["dt"] = 0.1
    arrays.balls.rows[field][balls - 2] = value
    before = contents(arrays)
    assert begun(arrays) == status
    assert (contents(arrays) == before) == (status != DONE)
