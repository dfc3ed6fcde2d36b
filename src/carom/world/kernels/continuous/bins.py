"""Cells for balls in flight: a ball is tested against those in the cells near it alone.

A ball is filed under the cell of its level that holds its centre, and filed anew when it is outside of that by a
margin, a part of the cell's width. Cells of a level are at least twice as wide as its balls. So two balls of a level
that touch are filed under the same cell or neighbouring ones. Numbers of cells wrap around.

How wide cells are changes the speed alone. Where balls fly through many cells from one event to the next, as those of a
thin gas do, `fit_bins` makes the cells of all wider; a single ball that flies far, fast or where nobody is, is filed
under a level with cells that are far wider than the others', and in the end under one that it hardly ever leaves.
"""

from __future__ import annotations

from math import fabs, inf, sqrt

from carom.constants import BIN_MARGIN, BIN_SIDE, CELL_CLAMP, FINEST_LEVEL
from carom.rows.ball import BallRow
from carom.rows.flight import NO_BALL, FlightRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import cell_of, level_of, wrapped_size
from carom.world.kernels.broad_phase.pairs import measure_balls
from carom.world.kernels.continuous.flight import age_now, place_after, time_to_go

#: Levels for balls that fly far: cells of each are 2^10 times as wide as those of the one before, the first one's so
#: much wider than those of the largest ball; but for the last one's, which nothing leaves that has a place.
WIDENING, WIDEST_LEVEL, WIDEST = 10, FINEST_LEVEL + 4, 1e300

#: A ball is filed under a wider level after this many times in a row with no event of its own, and this many more for
#: each ball, each of which it then asks; at most the third.
FILINGS_IN_A_ROW, FILINGS_PER_BALL, MOST_IN_A_ROW = 16, 0.125, 30_000

#: Cells are fitted when this many filings, predictions, and parts of as many tests of pairs were made for each ball,
#: which is asked once in so many events.
FITTING_AFTER, FITTING_TESTS, FITTING_EVENTS = 8, 32, 1024

#: Cells become wider where filings are more than this many times the predictions, and tests of pairs fewer than this
#: many times the filings; narrower where tests are more than this many times either. So many times as wide at once:
#: where balls meet hardly any in a cell, how many they would in much wider ones is not known.
FILINGS_MOST, TESTS_LEAST, TESTS_MOST, WIDER_AT_ONCE = 2, 10, 160, 8.0


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
    width = max(2.0 * BIN_SIDE * largest, sqrt((right - left) / count) * sqrt(top - bottom))
    state["bin_side"] = max(width, float(state["bin_least"]))
    state["bin_stride"] = stride
    state["bin_mask"] = mask
    state["bin_levels"] = 0
    # All are to be predicted now.
    state["bin_predictions"] += count
    state["binned"] = 1
    for cell in range(size):
        heads[cell] = NO_BALL
    for i in range(count - 1, -1, -1):
        file_ball(state, balls, flights, heads, i, age_now(state, flights[i]), own_level(state, balls[i]))
    return True


def fit_bins(state: StateRow) -> bool:
    """True if other cells than those that there are would save work, as far as was seen: all is to be filed anew.

    That is asked after the first event of a call, and after so many more each time.
    """
    if state["binned"] == 0 or state["events"] % FITTING_EVENTS != 1:
        return False
    filings, predictions, tests = int(state["bin_filings"]), int(state["bin_predictions"]), int(state["bin_tests"])
    if filings + predictions + tests // FITTING_TESTS < FITTING_AFTER * int(state["balls"]):
        return False
    state["bin_filings"] = 0
    state["bin_predictions"] = 0
    state["bin_tests"] = 0
    least, wider = float(state["bin_least"]), 1.0
    # Twice as wide, a ball comes to half as many cells, each of which holds four times as many.
    while wider < WIDER_AT_ONCE and filings > FILINGS_MOST * predictions and tests < TESTS_LEAST * filings:
        filings, tests, wider = filings // 2, 4 * tests, 2.0 * wider
    if wider > 1.0:
        state["bin_least"] = min(wider * max(least, side_of(state, finest_level(state))), WIDEST)
        return True
    if least > 0.0 and tests > TESTS_MOST * max(filings, predictions):
        state["bin_least"] = 0.5 * least
        return True
    return False


def finest_level(state: StateRow) -> int:
    """The finest level under which balls were filed, but for those for balls that fly far."""
    level = FINEST_LEVEL
    while level > 0 and not (state["bin_levels"] >> level) & 1:
        level -= 1
    return level


def may_meet(state: StateRow, balls: Table[BallRow]) -> bool:
    """True unless the masks of the balls exclude that any two of them meet."""
    layers, masks = 0, 0
    for i in range(state["balls"]):
        layers |= int(balls[i]["layer"])
        masks |= int(balls[i]["collides_with"])
    return layers & masks != 0


def own_level(state: StateRow, ball: BallRow) -> int:
    """The finest level whose cells are wide enough for a ball."""
    return level_of(max(BIN_SIDE * 2.0 * float(ball["radius"]), float(state["bin_least"])), float(state["bin_side"]))


def level_after(state: StateRow, flight: FlightRow) -> int:
    """The level for a ball that comes to another cell, after so many in a row; a wider one where it flies far."""
    level, filings = int(flight["level"]), int(flight["filings"]) + 1
    flight["filings"] = filings
    if level == WIDEST_LEVEL or filings < FILINGS_IN_A_ROW + min(FILINGS_PER_BALL * state["balls"], MOST_IN_A_ROW):
        return level
    flight["filings"] = 0
    return max(level, FINEST_LEVEL) + 1


def file_ball(
    state: StateRow,
    balls: Table[BallRow],
    flights: Table[FlightRow],
    heads: Table[int],
    ball: int,
    age: float,
    level: int,
) -> None:
    """File a ball, which is filed nowhere, under the cell of a level that it is in at an age of its flight."""
    row, flight = balls[ball], flights[ball]
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


def side_of(state: StateRow, level: int) -> float:
    """The width of the cells of a level."""
    side = float(state["bin_side"])
    if level <= FINEST_LEVEL:
        return side / float(1 << level)
    if level == WIDEST_LEVEL:
        return WIDEST
    return side * float(1 << WIDENING * (level - FINEST_LEVEL))


def cell_at(state: StateRow, x: float, y: float, level: int) -> tuple[int, int]:
    """Column and line of the cell of a level that holds (x, y)."""
    inverse_side = 1.0 / side_of(state, level)
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
    side = side_of(state, int(flight["level"]))
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
