"""Shapes that switch themselves off at their first bounce, and on again where the step is undone."""

from __future__ import annotations

from carom.rows.shape import ONCE, SPENT, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def spend(state: StateRow, shape: ShapeRow) -> None:
    """Switch a shape off that a ball has bounced off, and may bounce off once."""
    shape["can_collide"] = 0
    shape["once"] = SPENT
    state["spent"] += 1


def keep_spent(state: StateRow, shapes: Table[ShapeRow]) -> None:
    """Let the shapes that have switched themselves off in a step which is complete stay so until a user says else."""
    if state["spent"] == 0:
        return
    for i in range(state["shapes"]):
        if shapes[i]["once"] == SPENT:
            shapes[i]["once"] = ONCE
    state["spent"] = 0


def unspend(shapes: Table[ShapeRow], count: int) -> None:
    """Switch those of the first `count` shapes on again that have switched themselves off in a step that is undone."""
    for i in range(count):
        if shapes[i]["once"] == SPENT:
            shapes[i]["once"] = ONCE
            shapes[i]["can_collide"] = 1
