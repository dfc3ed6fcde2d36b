"""How much work a call of a kernel is, by its arguments: a unit takes the interpreter about 0.1 ms."""

from __future__ import annotations

from typing import Any

import numpy as np

from carom.compiler.block import Block
from carom.rows.state import DISCRETE
from carom.rows.tables import Rows

#: Shapes and balls that a query looks at in a unit of work.
LOOKED_AT = 16


def step_size(block: Block) -> tuple[int, float]:
    """The steps of a call, and for each of them a unit for each ball and substep, and one for each shape."""
    state = block.arguments[0][0]
    substeps = int(state["substeps"]) if state["detection"] == DISCRETE else 1
    return int(state["steps_left"]), float(int(state["balls"]) * substeps + int(state["shapes"]))


def query_size(queries: Rows, shapes: Rows, balls: Rows, *_: Any) -> tuple[int, float]:
    """One step, in which every query may look at every shape and ball."""
    return 1, len(queries) * (1.0 + (len(shapes) + len(balls)) / LOOKED_AT)


def table_size(*tables: Any) -> tuple[int, float]:
    """One step, in which every row of some tables is looked at."""
    return 1, 1.0 + sum(len(table) for table in tables if isinstance(table, np.ndarray)) / LOOKED_AT
