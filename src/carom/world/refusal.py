"""Why a step was refused, as the exception that says so."""

from __future__ import annotations

from carom.errors import ImpactLimit, InvalidArgument, NonFiniteState
from carom.rows.ball import OF_WORLD
from carom.rows.state import NOT_FINITE, REFUSED, TOO_MANY_IMPACTS
from carom.rows.tables import Rows
from carom.world.kernels.step.soundness import is_measured, is_sound
from carom.world.tables import Arrays


def refusal(status: int, arrays: Arrays) -> InvalidArgument | NonFiniteState | ImpactLimit:
    """The exception for a step that came back with `status`.

    Everything is as it was before the step, but where a ball had too many impacts: there the step has ended.
    """
    balls = arrays.balls.used
    if status == TOO_MANY_IMPACTS:
        return _too_many_impacts(arrays)
    if status == REFUSED:
        return _not_allowed(balls)
    assert status == NOT_FINITE
    bad = balls[[not (is_sound(row) and is_measured(row)) for row in balls]]
    which = f"balls {_ids(bad)} are not finite" if len(bad) else _overflowed(arrays)
    return NonFiniteState(f"{which}; the world is as it was before the step")


def _too_many_impacts(arrays: Arrays) -> ImpactLimit:
    """The exception that names the balls that have reached `max_impacts`, and when."""
    state, flights = arrays.states[0], arrays.flights[: arrays.balls.count]
    most, time = int(state["max_impacts"]), float(state["time"])
    reached = arrays.balls.used[(flights["kept"] == state["step_number"]) & (flights["impacts"] >= most)]
    message = f"balls {_ids(reached)} have had max_impacts={most} impacts in a step, which ended at {time!r} s"
    return ImpactLimit(message, reached["id"].tolist(), time)


def _not_allowed(balls: Rows) -> InvalidArgument:
    """The exception that names the first column with values that it may not have, and the balls that have them."""
    friction = balls["friction"]
    rules = {
        "radius": ("must be positive", balls["radius"] <= 0.0),
        "mass": ("must be positive", balls["mass"] <= 0.0),
        "elasticity": ("must not be negative", balls["elasticity"] < 0.0),
        "friction": (f"must be 0 or more, or {OF_WORLD:g} for the world's", (friction < 0.0) & (friction != OF_WORLD)),
    }
    name, must, bad = next((name, must, bad) for name, (must, bad) in rules.items() if bad.any())
    return InvalidArgument(f"{name} {must}, not {float(balls[name][bad][0])} as for balls {_ids(balls[bad])}")


def _overflowed(arrays: Arrays) -> str:
    """What was not finite any more when a step was undone, in words."""
    balls = arrays.balls.used[arrays.saved[: arrays.balls.count]["overflowed"] != 0]
    count, fixed = arrays.shape_table.count, int(arrays.states[0]["fixed"])
    copies = arrays.shape_table.rows[count : count + count - fixed]
    shapes = copies[copies["once"] != 0]
    names = [f"{kind} {_ids(rows)}" for kind, rows in (("balls", balls), ("shapes", shapes)) if len(rows)]
    return " and ".join(names) + " became infinite in the step"


def _ids(rows: Rows) -> str:
    """The first few ids of rows, for a message."""
    ids = [str(int(ball)) for ball in rows["id"][:10]]
    return ", ".join(ids) + (f" and {len(rows) - 10} more" if len(rows) > 10 else "")
