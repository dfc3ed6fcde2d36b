"""The beginning of a step: what is refused."""

from math import inf, nan

import pytest

from carom import Ball
from carom.rows.state import DONE, NOT_FINITE, REFUSED
from carom.world.kernels.step.beginning import begin_step
from carom.world.tables import Arrays
from tests.kernel_calls import prepared
from tests.worlds import world_of


def begun(arrays: Arrays) -> int:
    """The outcome of beginning a step."""
    return begin_step(
        arrays.states, arrays.balls.rows, arrays.shapes.rows, arrays.order, arrays.saved, arrays.relations
    )


def contents(arrays: Arrays) -> list[bytes]:
    """The tables that a step may change, bit by bit."""
    used = int(arrays.states[0]["relations_high"])
    return [
        *(table.tobytes() for table in (arrays.states[0], arrays.balls.used, arrays.shapes.used)),
        arrays.relations[:used].tobytes(),
    ]


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
def test_a_step_does_not_begin_with_a_ball_that_cannot_be(field: str, value: float, status: int) -> None:
    arrays = prepared(world_of(*(Ball((3.0 * k, 0), 1) for k in range(3))))
    arrays.balls.rows[field][1] = value
    before = contents(arrays)
    assert begun(arrays) == status
    assert (contents(arrays) == before) == (status != DONE)
