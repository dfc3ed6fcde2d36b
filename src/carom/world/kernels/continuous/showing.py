"""What users see of the balls between two steps: it is shown, looked at, and taken back when the film goes on."""

from __future__ import annotations

from carom.rows.ball import BallRow
from carom.rows.flight import FLYING, FlightRow
from carom.rows.relation import NO_RELATION, RelationRow
from carom.rows.shape import ShapeRow
from carom.rows.state import DONE, NOT_FINITE, OTHER_REACH, REFUSED, StateRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.flight import age_now, place_after
from carom.world.kernels.continuous.rest import slow_since
from carom.world.kernels.continuous.sliding import slid_place, slides_along
from carom.world.kernels.continuous.straying import is_out
from carom.world.kernels.step.motion import unsoundness
from carom.world.kernels.step.soundness import is_good, is_measured, is_sound


def look_at_balls(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow]) -> tuple[int, bool]:
    """DONE where the balls are what balls may be, and whether one is not as it was shown last, or was not there.

    Keeps them as they are seen, for a step that fails to go back to; notes where the index of shapes does not serve
    their size. In the same go, where nothing was changed, the balls' rows come to be where their flights began.
    """
    largest, changed = 0.0, state["wake"] != 0
    state["cursor"] = 0
    for i in range(state["balls"]):
        ball, flight = balls[i], flights[i]
        if not is_good(ball):
            call_back_flown(state, balls, flights)
            return (REFUSED if is_sound(ball) and is_measured(ball) else NOT_FINITE), False
        largest = max(largest, float(ball["radius"]))
        keep_seen(ball, flight)
        if not changed:
            if is_as_shown(ball, flight):
                state["cursor"] = i + 1
                take_back_ball(ball, flight)
            else:
                changed = True
                call_back_flown(state, balls, flights)
    if largest > state["reach"] or largest * 4.0 < state["reach"]:
        state["reach"] = largest
        if state["index_stale"] == 0:
            state["index_stale"] = OTHER_REACH
        state["foreseen"] = 0
    return DONE, changed


def call_back_flown(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow]) -> None:
    """Let the balls' rows be as they were seen, as many as `state["cursor"]` says, which are on their flights again."""
    show_as_seen(balls, flights, int(state["cursor"]))
    state["cursor"] = 0


def keep_seen(ball: BallRow, flight: FlightRow) -> None:
    """Keep a ball as it is seen."""
    flight["seen_x"] = ball["x"]
    flight["seen_y"] = ball["y"]
    flight["seen_vx"] = ball["vx"]
    flight["seen_vy"] = ball["vy"]
    flight["seen_still"] = ball["still_time"]
    flight["seen_relation"] = ball["relation"]
    flight["seen_asleep"] = ball["asleep"]
    flight["seen_stray"] = ball["stray"]


def is_any_changed(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow]) -> bool:
    """True if a ball is not as it was shown last, or was not there."""
    changed = False
    for i in range(state["balls"]):
        changed = changed or not is_as_shown(balls[i], flights[i])
    return changed


def is_as_shown(ball: BallRow, flight: FlightRow) -> bool:
    """True if a ball's row is as it was shown last, and nothing else of it was changed."""
    return bool(flight["id"] == ball["id"]) and is_where_shown(ball, flight)


def is_where_shown(ball: BallRow, flight: FlightRow) -> bool:
    """True if a ball is where it was shown last, and moves as it did then."""
    return bool(
        abs(flight["id"]) == ball["id"]
        and ball["x"] == flight["shown_x"]
        and ball["y"] == flight["shown_y"]
        and ball["vx"] == flight["shown_vx"]
        and ball["vy"] == flight["shown_vy"]
    )


def is_shown_sound(state: StateRow, balls: Table[BallRow], flights: Table[FlightRow]) -> bool:
    """True if all balls are at finite places now, with finite velocities."""
    for i in range(state["balls"]):
        if unsoundness(*place_after(balls[i], flights[i], age_shown(state, balls[i], flights[i]))) != 0.0:
            return False
    return True


def age_shown(state: StateRow, ball: BallRow, flight: FlightRow) -> float:
    """The age of a flight at which it is shown: now, or for one that is out, where it was when it left."""
    return 0.0 if is_out(state, ball) else age_now(state, flight)


def show(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    relations: Table[RelationRow],
    flights: Table[FlightRow],
) -> bool:
    """True when the balls' rows show where they are now, and their flights keep where those began.

    False if one is at no finite place, or has no finite velocity: then none is shown.
    """
    # Those of a crowd note it whenever it changes: a line of memory that is not written need not be written back.
    noted = state["binned"] != 0 and state["foreseen"] != 0
    for i in range(state["balls"]):
        ball, flight = balls[i], flights[i]
        age = age_shown(state, ball, flight)
        x, y, vx, vy = place_after(ball, flight, age)
        if unsoundness(x, y, vx, vy) != 0.0:
            for k in range(i):
                take_back_ball(balls[k], flights[k])
            return False
        held = slides_along(ball, flight, shapes, relations) if ball["relation"] != NO_RELATION else NO_RELATION
        if held != NO_RELATION:
            x, y, vx, vy = slid_place(state, ball, flight, shapes[held], age)
        still = age - slow_since(state, ball, flight, age)
        if not noted:
            flight["x"] = ball["x"]
            flight["y"] = ball["y"]
            flight["vx"] = ball["vx"]
            flight["vy"] = ball["vy"]
        ball["x"] = x
        ball["y"] = y
        ball["vx"] = vx
        ball["vy"] = vy
        if flight["kind"] == FLYING:
            ball["still_time"] = still
        flight["shown_x"] = x
        flight["shown_y"] = y
        flight["shown_vx"] = vx
        flight["shown_vy"] = vy
    return True


def take_back_ball(ball: BallRow, flight: FlightRow) -> None:
    """Let a ball's row be where its flight began, after it has shown where the ball is."""
    ball["x"] = flight["x"]
    ball["y"] = flight["y"]
    ball["vx"] = flight["vx"]
    ball["vy"] = flight["vy"]


def show_as_seen(balls: Table[BallRow], flights: Table[FlightRow], count: int) -> None:
    """Let the rows of the first balls, so many of them, be what they were before the call."""
    for i in range(count):
        ball, flight = balls[i], flights[i]
        ball["x"] = flight["seen_x"]
        ball["y"] = flight["seen_y"]
        ball["vx"] = flight["seen_vx"]
        ball["vy"] = flight["seen_vy"]
        ball["still_time"] = flight["seen_still"]
        ball["relation"] = flight["seen_relation"]
        ball["asleep"] = flight["seen_asleep"]
        ball["stray"] = flight["seen_stray"]
