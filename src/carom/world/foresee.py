"""What comes next for a ball in flight: the first impact with a shape or a ball, or a look around before that."""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import BIN_REACH, FEW_SHAPES, FLIGHT_SLICES, LOOK_TRAVEL
from carom.geometry.impact import impact_ball
from carom.rows import CIRCLE, NO_RELATION, POINT, Row, Rows
from carom.world.bins import leash
from carom.world.flight import path_box, place_at, top_speed
from carom.world.grid import cell_of, inverse_side_of
from carom.world.layout import (
    FLYING,
    HIT_BALL,
    HIT_SHAPE,
    INSIDE_BALL,
    LASTING,
    LEAVE,
    LOOK,
    NO_BALL,
    NOTHING,
)
from carom.world.narrow import may_collide
from carom.world.queue import put_event, take_event
from carom.world.relations import find_relation
from carom.world.shape_index import FIXED, locate
from carom.world.support import quiet_speed, slide_time
from carom.world.surfaces import impact_at_rest, impact_in_motion, is_moving, span_box


def foresee(
    state: Row,
    balls: Rows,
    shapes: Rows,
    order: Rows,
    index: Rows,
    cells: Rows,
    members: Rows,
    heads: Rows,
    flights: Rows,
    queue: Rows,
    relations: Rows,
    i: int,
    all_balls: bool,
) -> None:
    """Find what comes next for ball `i` and put it into the queue, or take the ball out if nothing does.

    Unless `all_balls`, pairs with balls of lower rows are left to those.
    """
    ball, flight = balls[i], flights[i]
    flight["event"] = NOTHING
    flight["event_time"] = state["span"]
    if flight["kind"] == FLYING:
        foresee_look(state, ball, flight, shapes, relations)
        foresee_fixed(state, ball, flight, shapes, order, index, cells, members, relations)
        foresee_kinematic(state, ball, flight, shapes, order, relations)
        if state["bin_levels"] != 0:
            foresee_balls(state, balls, heads, flights, relations, i, all_balls)
    if flight["event"] == NOTHING:
        take_event(state, flights, queue, i)
    else:
        put_event(state, flights, queue, i)


def consider(flight: Row, delay: float, event: int, partner: int) -> None:
    """Make an event the next one if it comes sooner than what was to come."""
    time = float(flight["time"]) + delay
    if time < flight["event_time"]:
        flight["event_time"] = time
        flight["event"] = event
        flight["partner"] = partner


def foresee_look(state: Row, ball: Row, flight: Row, shapes: Rows, relations: Rows) -> None:
    """Foresee when a ball has to look around: for its relations, and before its leash is taut."""
    remaining = float(state["span"]) - float(flight["time"])
    speed = top_speed(ball, flight, remaining)
    if speed == 0.0:
        return
    if state["binned"] != 0:
        dx, dy = float(ball["x"]) - float(flight["bin_x"]), float(ball["y"]) - float(flight["bin_y"])
        consider(flight, (leash(state, flight) - sqrt(dx * dx + dy * dy)) / speed, LOOK, NO_BALL)
    place = int(ball["relation"])
    while place != NO_RELATION:
        relation = relations[place]
        if relation["kind"] == LASTING:
            substep = float(state["dt"]) / float(state["substeps"])
            delay, leaves = slide_time(ball, flight, shapes[relation["other"]], substep)
            consider(flight, delay, LEAVE if leaves else LOOK, int(relation["other"]))
        else:
            consider(flight, LOOK_TRAVEL * float(ball["radius"]) / speed, LOOK, NO_BALL)
        place = int(relation["next"])


def foresee_fixed(
    state: Row,
    ball: Row,
    flight: Row,
    shapes: Rows,
    order: Rows,
    index: Rows,
    cells: Rows,
    members: Rows,
    relations: Rows,
) -> None:
    """Foresee the first impact with a static shape: one of a few, or one near a slice of the ball's way."""
    entry = index[FIXED]
    if entry["cells_begin"] == entry["cells_end"]:
        return
    duration = float(flight["event_time"]) - float(flight["time"])
    speed = top_speed(ball, flight, duration)
    slice_time = duration
    if speed * duration > entry["side"]:
        slice_time = float(entry["side"]) / speed
    few = state["fixed"] <= FEW_SHAPES and slice_time < duration
    if few or slice_time * FLIGHT_SLICES < duration:
        foresee_members(state, ball, flight, shapes, order, relations, 0, int(state["fixed"]), 0.0, duration)
        return
    begin = 0.0
    while begin < duration:
        end = min(begin + slice_time, duration)
        foresee_slice(state, ball, flight, shapes, entry, cells, members, relations, begin, end)
        duration = float(flight["event_time"]) - float(flight["time"])
        begin = end


def foresee_slice(
    state: Row,
    ball: Row,
    flight: Row,
    shapes: Rows,
    entry: Row,
    cells: Rows,
    members: Rows,
    relations: Rows,
    begin: float,
    end: float,
) -> None:
    """Foresee impacts with the static shapes near a slice of a way that is no wider than a cell."""
    left, bottom, right, top = way_box(ball, flight, begin, end)
    first = locate(state, entry, cells, left, bottom)
    if locate(state, entry, cells, right, top) == first:
        if first >= 0 and cells[first]["begin"] < cells[first]["end"]:
            low, high = int(cells[first]["begin"]), int(cells[first]["end"])
            foresee_members(state, ball, flight, shapes, members, relations, low, high, begin, end)
        return
    second = locate(state, entry, cells, right, bottom)
    third = locate(state, entry, cells, left, top)
    fourth = locate(state, entry, cells, right, top)
    for corner in range(4):
        if corner == 0:
            cell = first
        elif corner == 1:
            cell = second if second != first else -1
        elif corner == 2:
            cell = third if third != first and third != second else -1
        else:
            cell = fourth if fourth != first and fourth != second and fourth != third else -1
        if cell >= 0:
            low, high = int(cells[cell]["begin"]), int(cells[cell]["end"])
            foresee_members(state, ball, flight, shapes, members, relations, low, high, begin, end)


def way_box(ball: Row, flight: Row, begin: float, end: float) -> tuple[float, float, float, float]:
    """The box of a ball's centre between two times from now."""
    return path_box(
        float(ball["x"]),
        float(ball["y"]),
        float(ball["vx"]),
        float(ball["vy"]),
        float(flight["ax"]),
        float(flight["ay"]),
        begin,
        end,
    )


def foresee_members(
    state: Row,
    ball: Row,
    flight: Row,
    shapes: Rows,
    members: Rows,
    relations: Rows,
    low: int,
    high: int,
    begin: float,
    end: float,
) -> None:
    """Foresee impacts with the shapes `members[low:high]` near a slice of a ball's way, none of which moves."""
    left, bottom, right, top = way_box(ball, flight, begin, end)
    radius = float(ball["radius"])
    state["box_tests"] += high - low
    for k in range(low, high):
        row = int(members[k])
        shape = shapes[row]
        if (
            right + radius >= shape["left"]
            and left - radius <= shape["right"]
            and top + radius >= shape["bottom"]
            and bottom - radius <= shape["top"]
            and may_collide(ball, shape)
            and not is_related(relations, ball, row)
        ):
            state["full_tests"] += 1
            duration = float(flight["event_time"]) - float(flight["time"])
            time = impact_at_rest(
                shape, float(ball["x"]), float(ball["y"]), radius, float(ball["vx"]), float(ball["vy"]),
                float(flight["ax"]), float(flight["ay"]), duration,
            )  # fmt: skip
            if time is not None:
                consider_shape(flight, shapes, 0.0 + time, row)
            if is_entered_past_ends(ball, shape):
                foresee_entry(flight, shape, ball, begin)


def is_entered_past_ends(ball: Row, shape: Row) -> bool:
    """True if a ball may come onto a shape past one of its ends, and it matters when: for sensors with ends."""
    if shape["sensor"] == 0 and ball["sensor"] == 0:
        return False
    return bool(shape["kind"] != POINT and shape["kind"] != CIRCLE)


def foresee_entry(flight: Row, shape: Row, ball: Row, begin: float) -> None:
    """Foresee a look around when a ball near a sensor with ends has gone a part of its radius, as seen from there.

    Not before it comes near it, at a time `begin` from now.
    """
    vx, vy = float(ball["vx"]), float(ball["vy"])
    speed = sqrt(vx * vx + vy * vy)
    if is_moving(shape):
        speed += top_surface_speed(shape)
    if speed > 0.0:
        consider(flight, begin + LOOK_TRAVEL * float(ball["radius"]) / speed, LOOK, NO_BALL)


def top_surface_speed(shape: Row) -> float:
    """The most that any place of a moving shape's box moves at."""
    ux, uy = float(shape["velocity_x"]), float(shape["velocity_y"])
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    dx = max(px - float(shape["left"]), float(shape["right"]) - px)
    dy = max(py - float(shape["bottom"]), float(shape["top"]) - py)
    return sqrt(ux * ux + uy * uy) + fabs(float(shape["spin"])) * sqrt(dx * dx + dy * dy)


def consider_shape(flight: Row, shapes: Rows, delay: float, row: int) -> None:
    """Make an impact with a shape the next event if it comes sooner; of impacts at one time points come first."""
    time = float(flight["time"]) + delay
    if time == flight["event_time"] and flight["event"] == HIT_SHAPE:
        if shapes[row]["kind"] < shapes[flight["partner"]]["kind"]:
            flight["partner"] = row
        return
    consider(flight, delay, HIT_SHAPE, row)


def is_related(relations: Rows, ball: Row, row: int) -> bool:
    """True if a ball passes a shape, is inside it as a sensor, or is held by it: no impact with it is to come."""
    place = int(ball["relation"])
    while place != NO_RELATION:
        if relations[place]["other"] == row and relations[place]["kind"] != INSIDE_BALL:
            return True
        place = int(relations[place]["next"])
    return False


def foresee_kinematic(state: Row, ball: Row, flight: Row, shapes: Rows, order: Rows, relations: Rows) -> None:
    """Foresee the first impact with a kinematic shape."""
    fixed, count = int(state["fixed"]), int(state["shapes"])
    for k in range(fixed, count):
        row = int(order[k])
        shape = shapes[row]
        duration = float(flight["event_time"]) - float(flight["time"])
        if not is_moving(shape):
            foresee_members(state, ball, flight, shapes, order, relations, k, k + 1, 0.0, duration)
            continue
        state["box_tests"] += 1
        radius = float(ball["radius"])
        left, bottom, right, top = way_box(ball, flight, 0.0, duration)
        box_left, box_bottom, box_right, box_top = span_box(shape, float(state["span"]))
        if (
            right + radius >= box_left
            and left - radius <= box_right
            and top + radius >= box_bottom
            and bottom - radius <= box_top
            and may_collide(ball, shape)
            and not is_related(relations, ball, row)
        ):
            state["full_tests"] += 1
            time = impact_in_motion(
                shape, float(flight["time"]), float(ball["x"]), float(ball["y"]), radius, float(ball["vx"]),
                float(ball["vy"]), float(flight["ax"]), float(flight["ay"]), duration, 1.0,
            )  # fmt: skip
            if time is not None:
                consider_shape(flight, shapes, 0.0 + time, row)
            if is_entered_past_ends(ball, shape):
                foresee_entry(flight, shape, ball, 0.0)


def foresee_balls(
    state: Row, balls: Rows, heads: Rows, flights: Rows, relations: Rows, i: int, all_balls: bool
) -> None:
    """Foresee the first impact with another ball."""
    if state["binned"] == 0:
        for j in range(0 if all_balls else i + 1, state["balls"]):
            if j != i:
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
    state: Row,
    balls: Rows,
    heads: Rows,
    flights: Rows,
    relations: Rows,
    i: int,
    level: int,
    left: int,
    right: int,
    bottom: int,
    top: int,
    all_balls: bool,
) -> None:
    """Foresee impacts with the balls of a level that are filed under cells from `left`, `bottom` to `right`, `top`.

    Most pairs are told apart here: those that fall alike and move apart, or come nearer too slowly to touch in time.
    """
    flight = flights[i]
    x, y, radius = balls[i]["x"], balls[i]["y"], balls[i]["radius"]
    vx, vy, time, ax, ay = balls[i]["vx"], balls[i]["vy"], flight["time"], flight["ax"], flight["ay"]
    patient = flight["patience"] > time
    stride, mask = int(state["bin_stride"]), int(state["bin_mask"])
    tests = 0
    for line in range(bottom, top + 1):
        for column in range(left, right + 1):
            j = int(heads[(column + stride * line + level) & mask])
            while j != NO_BALL:
                partner = flights[j]
                if (all_balls or j > i) and j != i and partner["level"] == level:
                    tests += 1
                    other = balls[j]
                    near = True
                    alike = partner["kind"] == FLYING and partner["ax"] == ax and partner["ay"] == ay
                    if alike and not (patient and partner["patience"] > time):
                        # Seen from the other, ball i moves straight: both have the same acceleration.
                        back = time - partner["time"]
                        wx = vx - (other["vx"] + ax * back)
                        wy = vy - (other["vy"] + ay * back)
                        dx = x - (other["x"] + (other["vx"] + 0.5 * ax * back) * back)
                        dy = y - (other["y"] + (other["vy"] + 0.5 * ay * back) * back)
                        reach = radius + other["radius"]
                        nearing = dx * wx + dy * wy
                        gap = (dx * dx + dy * dy) - reach * reach
                        near = nearing < 0.0 and gap + 2.0 * nearing * (flight["event_time"] - time) <= 0.0
                    if near:
                        foresee_pair(state, balls, flights, relations, i, j)
                j = int(partner["next"])
    state["box_tests"] += tests


def meeting_time(state: Row, ball: Row, flight: Row, other: Row, partner: Row) -> float:
    """From when on a ball looks for an impact with another: now, or later where both rest and hardly come nearer."""
    time = float(flight["time"])
    if flight["patience"] <= time or partner["patience"] <= time:
        return time
    x1, y1, vx1, vy1 = place_at(other, partner, time)
    dx, dy = float(ball["x"]) - x1, float(ball["y"]) - y1
    nearing = dx * (float(ball["vx"]) - vx1) + dy * (float(ball["vy"]) - vy1)
    if nearing < -2.0 * quiet_speed(state) * sqrt(dx * dx + dy * dy):
        return time
    return min(float(flight["patience"]), float(partner["patience"]))


def foresee_pair(state: Row, balls: Rows, flights: Rows, relations: Rows, i: int, j: int) -> None:
    """Foresee the impact of ball `i` with ball `j`."""
    ball, other, flight, partner = balls[i], balls[j], flights[i], flights[j]
    time = meeting_time(state, ball, flight, other, partner)
    duration = float(flight["event_time"]) - time
    if duration <= 0.0:
        return
    x1, y1, vx1, vy1 = place_at(other, partner, time)
    x2, y2, vx2, vy2 = place_at(ball, flight, time)
    ax, ay = float(flight["ax"]) - float(partner["ax"]), float(flight["ay"]) - float(partner["ay"])
    r1, r2 = float(other["radius"]), float(ball["radius"])
    delay = impact_ball(x1, y1, vx1, vy1, r1, x2, y2, vx2, vy2, r2, ax, ay, duration)
    if delay is None or not may_collide(ball, other):
        return
    state["full_tests"] += 1
    inside = find_relation(relations, balls[max(i, j)], INSIDE_BALL, min(i, j))
    found = time - float(flight["time"]) + (0.0 + delay)
    if not inside and float(flight["time"]) + found < flight["event_time"]:
        consider(flight, found, HIT_BALL, j)
        flight["partner_version"] = partner["version"]
