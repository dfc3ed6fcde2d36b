"""What comes next for a ball in flight among the other balls: the first impact with one of them."""

from __future__ import annotations

from math import fabs, inf

from carom.constants import BIN_REACH, FINEST_LEVEL, GAP_ROUNDING, SWEEP_ROUNDING
from carom.geometry.impact import impact_ball
from carom.geometry.instants import is_before, later
from carom.geometry.path import Path
from carom.geometry.vector import dot, length, length_squared
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, HIT_BALL, NO_BALL, FlightRow
from carom.rows.masks import may_collide
from carom.rows.prefetch import prefetch
from carom.rows.relation import INSIDE_BALL, LYING, NO_RELATION, RelationRow
from carom.rows.state import StateRow
from carom.rows.tables import Table
from carom.world.kernels.broad_phase.grid import cell_of
from carom.world.kernels.continuous.bins import side_of, stretch_of
from carom.world.kernels.continuous.flight import age_at, consider_at, event_age, path_at, place_after
from carom.world.kernels.continuous.predict_sensors import predict_parting
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.straying import is_out
from carom.world.kernels.step.narrow import approaches
from carom.world.kernels.step.relations import find_relation

#: In place of a column or line: there was none.
NO_CELL = -1 << 40

#: Square of a distance, relative to that of two balls' radii: farther off than this, whether two that fly towards each
#: other pass by is not told before their time of impact is computed. Larger, and rounding (1e-16 of it) may decide.
FAR_AWAY = 1e8

#: As many cells around another are asked at most for those who are filed there before the first of them is looked at.
CELLS_AHEAD = 16


def predict_balls(
    state: StateRow,
    balls: Table[BallRow],
    heads: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
    all_balls: bool,
) -> None:
    """Foresee the first impact with another ball.

    Unless `all_balls`, pairs with flying balls of lower rows are left to those.
    """
    if state["binned"] == 0:
        for j in range(state["balls"]):
            if j != i and (all_balls or j > i or flights[j]["kind"] != FLYING):
                predict_pair(state, balls, flights, relations, i, j)
        return
    predict_balls_beyond(state, balls, heads, flights, relations, i, NO_CELL, NO_CELL, all_balls)


def predict_balls_beyond(
    state: StateRow,
    balls: Table[BallRow],
    heads: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
    column: int,
    line: int,
    all_balls: bool,
) -> None:
    """The same for balls that were not near the cell at `column` and `line` of the ball's level, where it was filed.

    Balls of other levels are all asked. Who is near whom is the same for both within a level: so of two that come near
    each other the one that is filed anew asks.
    """
    flight = flights[i]
    levels, own = int(state["bin_levels"]), int(flight["level"])
    level = 0
    while levels >> level:
        if (levels >> level) & 1:
            if level == own:
                x, y = int(flight["column"]), int(flight["line"])
                box = (x - 1, x + 1, y - 1, y + 1)
                predict_cells(state, balls, heads, flights, relations, i, level, box, column, line, all_balls)
            else:
                box = cells_near(state, balls[i], flight, level)
                predict_cells(state, balls, heads, flights, relations, i, level, box, NO_CELL, NO_CELL, all_balls)
        level += 1


def cells_near(state: StateRow, ball: BallRow, flight: FlightRow, level: int) -> tuple[int, int, int, int]:
    """The cells of another level, from left to right and bottom to top, under which a ball's partners may be filed."""
    inverse_side = 1.0 / side_of(state, level)
    side = side_of(state, int(flight["level"]))
    reach = float(ball["radius"]) + BIN_REACH / inverse_side
    begin, end = stretch_of(int(flight["column"]), side)
    left, right = cell_of(begin - reach, inverse_side), cell_of(end + reach, inverse_side)
    begin, end = stretch_of(int(flight["line"]), side)
    bottom, top = cell_of(begin - reach, inverse_side), cell_of(end + reach, inverse_side)
    if (right - left + 1) * (top - bottom + 1) > state["bin_mask"]:
        return 0, int(state["bin_mask"]), 0, 0
    return left, right, bottom, top


def predict_cells(
    state: StateRow,
    balls: Table[BallRow],
    heads: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
    level: int,
    box: tuple[int, int, int, int],
    column: int,
    line: int,
    all_balls: bool,
) -> None:
    """Foresee impacts with the balls of a level that are filed under the cells of a box (left, right, bottom, top).

    But for those around the cell at `column` and `line`, which need not be asked.
    """
    flight = flights[i]
    left, right, bottom, top = box
    stride, mask = int(state["bin_stride"]), int(state["bin_mask"])
    gx, gy = float(state["gravity_x"]), float(state["gravity_y"])
    falls = flight["reach"] > 0.0
    until = event_age(flight) * SWEEP_ROUNDING
    tests = 0
    if (right - left) * (top - bottom) <= CELLS_AHEAD:
        # All at once, or each would be waited for in turn.
        for row in range(bottom, top + 1):
            for place in range(left, right + 1):
                prefetch(flights, row_of(heads[(place + stride * row + level) & mask]))
    for row in range(bottom, top + 1):
        known = -1 <= row - line <= 1
        for place in range(left, right + 1):
            if known and -1 <= place - column <= 1:
                continue
            j = row_of(heads[(place + stride * row + level) & mask])
            while j != NO_BALL:
                partner = flights[j]
                alike = falls and partner["reach"] > 0.0
                wanted = all_balls or j > i or (not alike and partner["kind"] != FLYING)
                if wanted and j != i and partner["level"] == level:
                    tests += 1
                    if (
                        may_touch(flight, partner, until, gx, gy)
                        if alike
                        else may_near(balls[i], flight, balls[j], partner)
                    ):
                        predict_pair(state, balls, flights, relations, i, j)
                        until = event_age(flight) * SWEEP_ROUNDING
                j = row_of(partner["next"])
    state["box_tests"] += tests
    if max(level, int(flight["level"])) <= FINEST_LEVEL:
        state["bin_tests"] += tests


def may_touch(flight: FlightRow, partner: FlightRow, until: float, gx: float, gy: float) -> bool:
    """False for most pairs of balls which fall freely that do not touch `until` an age of the first one's flight.

    Seen from each other they move straight. Asked is their state at the instant at which the later flight began, and
    what touches all but is kept, for who is left out must not depend on what else was found before.
    """
    x, y, vx, vy = float(flight["x"]), float(flight["y"]), float(flight["vx"]), float(flight["vy"])
    other_x, other_y = float(partner["x"]), float(partner["y"])
    other_vx, other_vy = float(partner["vx"]), float(partner["vy"])
    seconds = age_at(partner, float(flight["time"]), float(flight["low"]))
    pull_x, pull_y = gx * seconds, gy * seconds
    if seconds >= 0.0:
        other_x += (other_vx + 0.5 * pull_x) * seconds
        other_y += (other_vy + 0.5 * pull_y) * seconds
        other_vx += pull_x
        other_vy += pull_y
    else:
        x -= (vx - 0.5 * pull_x) * seconds
        y -= (vy - 0.5 * pull_y) * seconds
        vx -= pull_x
        vy -= pull_y
        until += seconds
    dx, dy, wx, wy = x - other_x, y - other_y, vx - other_vx, vy - other_vy
    slack = GAP_ROUNDING * ((fabs(x) + fabs(y)) + (fabs(other_x) + fabs(other_y)))
    reach = SWEEP_ROUNDING * (float(flight["reach"]) + float(partner["reach"])) + slack
    away, nearing, speed = dx * dx + dy * dy, dx * wx + dy * wy, wx * wx + wy * wy
    gap = away - reach * reach
    # Of what comes from very far rounding leaves too little to tell whether it passes by.
    hits = (not nearing * nearing < speed * gap) | (away > FAR_AWAY * (reach * reach))
    # All at once: which of them says no is up to chance, and most pairs get one.
    return bool((gap < 0.0) | ((nearing < 0.0) & (not gap + 2.0 * nearing * until > 0.0) & hits))


def may_near(ball: BallRow, flight: FlightRow, other: BallRow, partner: FlightRow) -> bool:
    """False for most pairs that do not meet before what is to come for the ball: too far, or parting; no sensors."""
    if ball["sensor"] != 0 or other["sensor"] != 0:
        return True
    back = age_at(partner, float(flight["time"]), float(flight["low"]))
    x, y, vx, vy = place_after(other, partner, back)
    dx, dy, wx, wy = ball["x"] - x, ball["y"] - y, ball["vx"] - vx, ball["vy"] - vy
    gx, gy = flight["ax"], flight["ay"]
    if partner["kind"] == FLYING:
        gx, gy = gx - partner["ax"], gy - partner["ay"]
    # The margins are for rounding: who is left out must not depend on what else was found before.
    slack = GAP_ROUNDING * ((fabs(ball["x"]) + fabs(ball["y"])) + (fabs(x) + fabs(y)))
    reach = SWEEP_ROUNDING * (ball["radius"] + other["radius"]) + slack
    duration = event_age(flight) * SWEEP_ROUNDING
    if gx == 0.0 and gy == 0.0:
        # Seen from the other, the ball moves straight.
        gap = (dx * dx + dy * dy) - reach * reach
        nearing = dx * wx + dy * wy
        return bool(gap < 0.0 or (nearing < 0.0 and gap + 2.0 * nearing * duration <= 0.0))
    way = ((fabs(wx) + fabs(wy)) + 0.5 * (fabs(gx) + fabs(gy)) * duration) * duration
    return not dx * dx + dy * dy > (reach + way) * (reach + way)


def pair_begin(flight: FlightRow, partner: FlightRow) -> tuple[float, float]:
    """The instant from which on two balls are looked at: when the later of their flights began."""
    time, low = float(flight["time"]), float(flight["low"])
    if is_before(time, low, float(partner["time"]), float(partner["low"])):
        return float(partner["time"]), float(partner["low"])
    return time, low


def predict_pair(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], relations: Table[RelationRow], i: int, j: int
) -> None:
    """Foresee the impact of ball `i` with ball `j`, or that they part where one of them is a sensor."""
    ball, other, flight, partner = balls[i], balls[j], flights[i], flights[j]
    if not may_collide(ball, other) or is_out(state, other):
        return
    low, high = min(i, j), max(i, j)
    if find_relation(relations, balls[high], INSIDE_BALL, low):
        if i == low:  # the other one has asked, wherever they are
            predict_leaving(state, balls, flights, i, j)
        return
    if ball["relation"] != NO_RELATION and find_relation(relations, ball, LYING, j):
        return
    begin, begin_low = pair_begin(flights[low], flights[high])
    first = path_at(balls[low], flights[low], age_at(flights[low], begin, begin_low))
    second = path_at(balls[high], flights[high], age_at(flights[high], begin, begin_low))
    state["full_tests"] += 1
    delay = impact_ball(first, second, float(balls[low]["radius"]) + float(balls[high]["radius"]), inf)
    if delay is not None and not (delay == 0.0 and only_slide(first, second)):
        time, time_low = later(begin, begin_low, 0.0 + delay)
        if consider_at(flight, time, time_low, HIT_BALL, j):
            flight["partner_version"] = partner["version"]


def predict_leaving(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], i: int, j: int
) -> None:  # fmt: skip
    """Foresee that ball `i` parts from ball `j`, one of which is a sensor that has the other inside."""
    flight, partner = flights[i], flights[j]
    if predict_parting(balls[i], flight, balls[j], partner, j, float(state["now"]), float(state["now_low"])):
        flight["partner_version"] = partner["version"]


def only_slide(first: Path, second: Path) -> bool:
    """True if two touching balls that are pulled alike approach by no more than the rounding of their velocities.

    An impact leaves that much; met again, they would meet for ever.
    """
    x1, y1, vx1, vy1, ax1, ay1 = first
    x2, y2, vx2, vy2, ax2, ay2 = second
    if ax1 != ax2 or ay1 != ay2:
        return False
    dx, dy = x2 - x1, y2 - y1
    away = length(dx, dy)
    if away == 0.0:
        return False
    s = dot(vx2 - vx1, vy2 - vy1, dx, dy) / away
    return not approaches(s, length_squared(vx1, vy1) + length_squared(vx2, vy2))
