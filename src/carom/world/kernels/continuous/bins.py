"""Cells for balls in flight: a ball is tested against those in the cells near it alone.

A ball is filed under the cell of its level that holds its centre, and filed anew before it is farther than its leash, a
part of the cell's width, from where it was filed. Cells of a level are at least twice as wide as its balls. So two
balls that touch are filed within the sum of their radii and leashes of each other. Numbers of cells wrap around.
"""

from __future__ import annotations

from math import sqrt

from carom.constants import BIN_LEASH, BIN_SIDE
from carom.rows.ball import BallRow
from carom.rows.flight import NO_BALL, FlightRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import cell_of, inverse_side_of, level_of, wrapped_size
from carom.world.kernels.broad_phase.pairs import measure_balls
from carom.world.kernels.continuous.flight import age_now, place_after


def open_bins(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], heads: Table[int]) -> bool:
    """True when all balls are filed; False if `heads` has no room, and `state["wanted_starts"]` says how much it needs.

    A few balls are not filed at all: then every ball is near every other.
    """
    count = int(state["balls"])
    size, stride, mask = wrapped_size(count)
    if size > len(heads):
        state["wanted_starts"] = size
        return False
    left, bottom, right, top, _, largest = measure_balls(state, balls)
    state["bin_left"] = left
    state["bin_bottom"] = bottom
    state["bin_side"] = max(2.0 * BIN_SIDE * largest, sqrt((right - left) / count) * sqrt(top - bottom))
    state["bin_stride"] = stride
    state["bin_mask"] = mask
    state["bin_levels"] = 0
    state["binned"] = 1
    for cell in range(size):
        heads[cell] = NO_BALL
    for i in range(count - 1, -1, -1):
        file_ball(state, balls, flights, heads, i, age_now(state, flights[i]))
    return True


def may_meet(state: StateRow, balls: Table[BallRow]) -> bool:
    """True unless the masks of the balls exclude that any two of them meet."""
    layers, masks = 0, 0
    for i in range(state["balls"]):
        layers |= int(balls[i]["layer"])
        masks |= int(balls[i]["collides_with"])
    return layers & masks != 0


def leash(state: StateRow, flight: FlightRow) -> float:
    """How far a ball may be from where it was filed."""
    return BIN_LEASH * float(state["bin_side"]) / float(1 << int(flight["level"]))


def file_ball(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], heads: Table[int], ball: int, age: float
) -> None:
    """File a ball, which is filed nowhere, under the cell that it is in at an age of its flight."""
    row, flight = balls[ball], flights[ball]
    side = float(state["bin_side"])
    level = level_of(BIN_SIDE * 2.0 * float(row["radius"]), side)
    x, y, _vx, _vy = place_after(row, flight, age)
    cell = bin_number(state, x, y, level)
    flight["bin_x"] = x
    flight["bin_y"] = y
    flight["level"] = level
    flight["cell"] = cell
    flight["next"] = heads[cell]
    heads[cell] = ball
    state["bin_levels"] |= 1 << level


def unfile_ball(flights: Table[FlightRow], heads: Table[int], ball: int) -> None:
    """Take a ball out of the cell that it is filed under."""
    cell = int(flights[ball]["cell"])
    other = int(heads[cell])
    if other == ball:
        heads[cell] = flights[ball]["next"]
        return
    while int(flights[other]["next"]) != ball:
        other = int(flights[other]["next"])
    flights[other]["next"] = flights[ball]["next"]


def bin_number(state: StateRow, x: float, y: float, level: int) -> int:
    """The number of the cell of a level that holds (x, y)."""
    inverse_side = inverse_side_of(float(state["bin_side"]), level)
    column = cell_of(x - float(state["bin_left"]), inverse_side)
    line = cell_of(y - float(state["bin_bottom"]), inverse_side)
    return (column + int(state["bin_stride"]) * line + level) & int(state["bin_mask"])
