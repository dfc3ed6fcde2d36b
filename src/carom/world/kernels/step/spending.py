"""Shapes that switch themselves off at their first bounce, and on again where the step is undone."""

from __future__ import annotations

from carom.rows.shape import ONCE, SPENT, ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def spend(state: StateRow, shapes: Table[ShapeRow], shape: ShapeRow) -> None:
    """Switch a shape off that a ball has bounced off, and may bounce off once, and with it all of its ring."""
    switch_off(state, shape)
    following = int(shape["drops_with"])
    while following != 0 and following != shape["id"]:
        other = shapes[row_called(state, shapes, following)]
        if other["once"] != 0 and other["can_collide"] != 0:
            switch_off(state, other)
        following = int(other["drops_with"])


def switch_off(state: StateRow, shape: ShapeRow) -> None:
    """Switch a shape off, and note that it was this step which did."""
    shape["can_collide"] = 0
    shape["once"] = SPENT
    state["spent"] += 1


def row_called(state: StateRow, shapes: Table[ShapeRow], wanted: int) -> int:
    """The row of the shape with an id, which there must be; ids ascend."""
    low, high = 0, int(state["shapes"]) - 1
    while low < high:
        middle = (low + high) // 2
        if shapes[middle]["id"] < wanted:
            low = middle + 1
        else:
            high = middle
    return low


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
