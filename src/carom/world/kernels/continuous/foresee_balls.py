"""What comes next for a ball in flight among the other balls: the first impact with one of them."""

from __future__ import annotations

from math import sqrt

from carom.constants import BIN_REACH
from carom.geometry.impact import impact_ball
from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, HIT_BALL, NO_BALL, FlightRow
from carom.rows.masks import may_collide
from carom.rows.relation import INSIDE_BALL, RelationRow
from carom.rows.state import StateRow
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.grid import cell_of, inverse_side_of
from carom.world.kernels.continuous.bins import leash
from carom.world.kernels.continuous.flight import consider, path_at, place_at
from carom.world.kernels.continuous.queue import row_of
from carom.world.kernels.continuous.support import patience
from carom.world.kernels.step.relations import find_relation


def foresee_balls(
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
                foresee_pair(state, balls, flights, relations, i, j)
        return
    flight = flights[i]
    reach = float(balls[i]["radius"]) + leash(state, flight)
    x, y = float(flight["bin_x"]) - float(state["bin_left"]), float(flight["bin_y"]) - float(state["bin_bottom"])
    levels, mask = int(state["bin_levels"]), int(state["bin_mask"])
    level = 0
    while levels >> level:
        if (levels >> level) & 1:
            inverse_side = inverse_side_of(float(state["bin_side"]), level)
            half = reach + BIN_REACH / inverse_side
            left, right = cell_of(x - half, inverse_side), cell_of(x + half, inverse_side)
            bottom, top = cell_of(y - half, inverse_side), cell_of(y + half, inverse_side)
            if (right - left + 1) * (top - bottom + 1) > mask:
                left, right, bottom, top = 0, mask, 0, 0
            foresee_cells(state, balls, heads, flights, relations, i, level, left, right, bottom, top, all_balls)
        level += 1


def foresee_cells(
    state: StateRow,
    balls: Table[BallRow],
    heads: Table[int],
    flights: Table[FlightRow],
    relations: Table[RelationRow],
    i: int,
    level: int,
    left: int,
    right: int,
    bottom: int,
    top: int,
    all_balls: bool,
) -> None:
    """Foresee impacts with the balls of a level that are filed under cells from `left`, `bottom` to `right`, `top`."""
    flight = flights[i]
    stride, mask = int(state["bin_stride"]), int(state["bin_mask"])
    tests = 0
    for line in range(bottom, top + 1):
        for column in range(left, right + 1):
            j = row_of(heads[(column + stride * line + level) & mask])
            while j != NO_BALL:
                partner = flights[j]
                wanted = all_balls or j > i or partner["kind"] != FLYING
                if wanted and j != i and partner["level"] == level:
                    tests += 1
                    if may_near(balls[i], flight, balls[j], partner):
                        foresee_pair(state, balls, flights, relations, i, j)
                j = row_of(partner["next"])
    state["box_tests"] += tests


def foresee_pairs(
    state: StateRow, balls: Table[BallRow], pairs: Pairs, flights: Table[FlightRow], relations: Table[RelationRow]
) -> None:
    """Foresee the first impacts of all balls with each other, at a span's beginning, from the pairs that may meet."""
    for k in range(state["pairs"]):
        first, second = row_of(pairs[k, 0]), row_of(pairs[k, 1])
        i, j = min(first, second), max(first, second)
        if flights[i]["kind"] != FLYING:
            i, j = j, i
        if flights[i]["kind"] == FLYING and may_near(balls[i], flights[i], balls[j], flights[j]):
            foresee_pair(state, balls, flights, relations, i, j)


def may_near(ball: BallRow, flight: FlightRow, other: BallRow, partner: FlightRow) -> bool:
    """False for most pairs that do not meet: those that fall alike, and part or near too slowly to touch in time."""
    time, ax, ay = flight["time"], flight["ax"], flight["ay"]
    if partner["kind"] != FLYING or partner["ax"] != ax or partner["ay"] != ay:
        return True
    if flight["patience"] > time and partner["patience"] > time:
        return True
    # Seen from the other, the ball moves straight: both have the same acceleration.
    back = time - partner["time"]
    wx = ball["vx"] - (other["vx"] + ax * back)
    wy = ball["vy"] - (other["vy"] + ay * back)
    dx = ball["x"] - (other["x"] + (other["vx"] + 0.5 * ax * back) * back)
    dy = ball["y"] - (other["y"] + (other["vy"] + 0.5 * ay * back) * back)
    reach = ball["radius"] + other["radius"]
    nearing = dx * wx + dy * wy
    gap = (dx * dx + dy * dy) - reach * reach
    return bool(nearing < 0.0 and gap + 2.0 * nearing * (flight["event_time"] - time) <= 0.0)


def meeting_time(state: StateRow, ball: BallRow, flight: FlightRow, other: BallRow, partner: FlightRow) -> float:
    """From when on a ball looks for an impact with another: now, or later where both rest and hardly come nearer."""
    time = float(flight["time"])
    if flight["patience"] <= time or partner["patience"] <= time:
        return time
    x1, y1, vx1, vy1 = place_at(other, partner, time)
    dx, dy = float(ball["x"]) - x1, float(ball["y"]) - y1
    nearing = dx * (float(ball["vx"]) - vx1) + dy * (float(ball["vy"]) - vy1)
    _wait, quiet = patience(state, ball, flight, other, partner)
    if nearing < -2.0 * quiet * sqrt(dx * dx + dy * dy):
        return time
    return min(float(flight["patience"]), float(partner["patience"]))


def foresee_pair(
    state: StateRow, balls: Table[BallRow], flights: Table[FlightRow], relations: Table[RelationRow], i: int, j: int
) -> None:
    """Foresee the impact of ball `i` with ball `j`."""
    ball, other, flight, partner = balls[i], balls[j], flights[i], flights[j]
    time = meeting_time(state, ball, flight, other, partner)
    duration = float(flight["event_time"]) - time
    if duration <= 0.0:
        return
    reach = float(other["radius"]) + float(ball["radius"])
    delay = impact_ball(path_at(other, partner, time), path_at(ball, flight, time), reach, duration)
    if delay is None or not may_collide(ball, other):
        return
    state["full_tests"] += 1
    inside = find_relation(relations, balls[max(i, j)], INSIDE_BALL, min(i, j))
    found = time - float(flight["time"]) + (0.0 + delay)
    if not inside and float(flight["time"]) + found < flight["event_time"]:
        consider(flight, found, HIT_BALL, j)
        flight["partner_version"] = partner["version"]
