"""Cells for balls in flight: a ball is tested against those in the cells near it alone.

A ball is filed under the cell of its level that holds its centre, and filed anew when it is outside of that by a
margin, a part of the cell's width. Cells of a level are at least twice as wide as its balls. So two balls of a level
that touch are filed under the same cell or neighbouring ones. Numbers of cells wrap around.
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import BIN_MARGIN, BIN_SIDE, CELL_CLAMP
from carom.rows.ball import BallRow
from carom.rows.flight import NO_BALL, FlightRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import cell_of, inverse_side_of, level_of, wrapped_size
from carom.world.kernels.broad_phase.pairs import measure_balls
from carom.world.kernels.continuous.flight import age_now, place_after, time_to_go


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


def file_ball(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], heads: Table[int], ball: int, age: float
) -> None:
    """File a ball, which is filed nowhere, under the cell that it is in at an age of its flight."""
    row, flight = balls[ball], flights[ball]
    level = level_of(BIN_SIDE * 2.0 * float(row["radius"]), float(state["bin_side"]))
    x, y, _vx, _vy = place_after(row, flight, age)
    column, line = cell_at(state, x, y, level)
    cell = bin_number(state, column, line, level)
    flight["column"] = column
    flight["line"] = line
    flight["level"] = level
    flight["next"] = heads[cell]
    heads[cell] = ball
    state["bin_levels"] |= 1 << level


def unfile_ball(state: StateRow, flights: Table[FlightRow], heads: Table[int], ball: int) -> None:
    """Take a ball out of the cell that it is filed under."""
    flight = flights[ball]
    cell = bin_number(state, int(flight["column"]), int(flight["line"]), int(flight["level"]))
    other = int(heads[cell])
    if other == ball:
        heads[cell] = flight["next"]
        return
    while int(flights[other]["next"]) != ball:
        other = int(flights[other]["next"])
    flights[other]["next"] = flight["next"]


def cell_at(state: StateRow, x: float, y: float, level: int) -> tuple[int, int]:
    """Column and line of the cell of a level that holds (x, y)."""
    inverse_side = inverse_side_of(float(state["bin_side"]), level)
    return cell_of(x - float(state["bin_left"]), inverse_side), cell_of(y - float(state["bin_bottom"]), inverse_side)


def bin_number(state: StateRow, column: int, line: int, level: int) -> int:
    """The number of a cell of a level."""
    return (column + int(state["bin_stride"]) * line + level) & int(state["bin_mask"])


def stretch_of(cell: int, side: float) -> tuple[float, float]:
    """Where, along one axis from the corner of all cells, balls may be that are filed under a column or line."""
    low, high = (cell - BIN_MARGIN) * side, (cell + 1.0 + BIN_MARGIN) * side
    # The last ones have no end.
    return (low if cell > -CELL_CLAMP else -inf), (high if cell < CELL_CLAMP else inf)


def time_filed(state: StateRow, ball: BallRow, flight: FlightRow, age: float) -> float:
    """The seconds from an age of its flight for which a ball stays where it is filed, or somewhat less.

    Infinite if it does for ever; below 0 if it is outside already.
    """
    x, y, vx, vy = place_after(ball, flight, age)
    side = float(state["bin_side"]) / float(1 << int(flight["level"]))
    across = time_within(
        x - float(state["bin_left"]), vx, float(flight["ax"]), stretch_of(int(flight["column"]), side)
    )  # fmt: skip
    along = time_within(
        y - float(state["bin_bottom"]), vy, float(flight["ay"]), stretch_of(int(flight["line"]), side)
    )  # fmt: skip
    return min(across, along)


def time_within(place: float, speed: float, pull: float, stretch: tuple[float, float]) -> float:
    """The time for which what moves on a line stays in a stretch, or less where it is pulled; -1 if it is outside."""
    low, high = stretch
    if place < low or place > high:
        return -1.0
    if pull == 0.0:
        way = high - place if speed > 0.0 else place - low
        return way / fabs(speed) if speed != 0.0 else inf
    return time_to_go(fabs(speed), fabs(pull), min(place - low, high - place))
