"""The queue of coming events: a binary heap of balls, each with its next event; ties go to the ball added first.

`queue` holds rows of balls; a ball's place in it stands in its flight, so an event can be moved or taken out.
"""

from __future__ import annotations

from carom.rows.flight import NO_PLACE, FlightRow
from carom.rows.state import StateRow
from carom.rows.tables import Table


def row_of(number: int) -> int:
    """A row's number as it is handed on: 64 bits wide, whatever it was kept in, so no function is compiled twice."""
    return int(number) + 0


def is_sooner(flights: Table[FlightRow], first: int, second: int) -> bool:
    """True if the event of ball `first` is to be dealt with before that of ball `second`."""
    one, other = flights[first], flights[second]
    if one["due_time"] != other["due_time"]:
        return bool(one["due_time"] < other["due_time"])
    if one["due_low"] != other["due_low"]:
        return bool(one["due_low"] < other["due_low"])
    if one["due_key"] != other["due_key"]:
        return bool(one["due_key"] < other["due_key"])
    return first < second


def put_event(state: StateRow, flights: Table[FlightRow], queue: Table[int], ball: int) -> None:
    """Put a ball into the queue, or move it to where its event's time belongs."""
    place = row_of(flights[ball]["place"])
    if place == NO_PLACE:
        place = int(state["queued"])
        state["queued"] = place + 1
    place = sift_up(flights, queue, ball, place)
    sift_down(state, flights, queue, ball, place)


def take_event(state: StateRow, flights: Table[FlightRow], queue: Table[int], ball: int) -> None:
    """Take a ball out of the queue, if it is there."""
    place = row_of(flights[ball]["place"])
    if place == NO_PLACE:
        return
    flights[ball]["place"] = NO_PLACE
    last = int(state["queued"]) - 1
    state["queued"] = last
    if place < last:
        moved = row_of(queue[last])
        sift_down(state, flights, queue, moved, sift_up(flights, queue, moved, place))


def sift_up(flights: Table[FlightRow], queue: Table[int], ball: int, place: int) -> int:
    """The place of a ball after it was moved up from the free `place` as far as it belongs, and written there."""
    while place > 0:
        parent = (place - 1) // 2
        above = row_of(queue[parent])
        if not is_sooner(flights, ball, above):
            break
        queue[place] = above
        flights[above]["place"] = place
        place = parent
    queue[place] = ball
    flights[ball]["place"] = place
    return place


def sift_down(state: StateRow, flights: Table[FlightRow], queue: Table[int], ball: int, place: int) -> None:
    """Move a ball down from `place` as far as it belongs."""
    count = int(state["queued"])
    while True:
        child = 2 * place + 1
        if child >= count:
            break
        if child + 1 < count and is_sooner(flights, row_of(queue[child + 1]), row_of(queue[child])):
            child += 1
        below = row_of(queue[child])
        if not is_sooner(flights, below, ball):
            break
        queue[place] = below
        flights[below]["place"] = place
        place = child
    queue[place] = ball
    flights[ball]["place"] = place
