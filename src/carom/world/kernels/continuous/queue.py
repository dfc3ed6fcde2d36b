"""The queue of coming events: a binary heap of balls, each with its next event; ties go to the ball added first.

A row of `queue` holds a ball and the time of its event, so that most are compared without a look at their flights; and,
for the ball whose row it is, where that stands in the queue, so that an event can be moved or taken out.

Of a crowd, whose balls are filed in cells, the queue holds no more than what comes up to a time: what is foreseen for
later is noted alone, as most of it will not come. When the queue is empty it is filled with what comes next.
"""

from __future__ import annotations

from math import inf

from carom.rows.flight import NO_BALL, NO_PLACE, FlightRow, QueueRow
from carom.rows.state import StateRow
from carom.rows.tables import Table

#: Part of the time for which the balls of a crowd wait for their next event on the whole: the queue is filled with what
#: comes in it. More means a longer queue, less means it is filled more often.
QUEUE_SHARE = 0.0625


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


def open_queue(state: StateRow, queue: Table[QueueRow]) -> None:
    """Let the queue be empty; nothing is to come for any ball."""
    state["queued"] = 0
    for i in range(state["balls"]):
        queue[i]["place"] = NO_PLACE
        queue[i]["due"] = inf
    queue[len(queue) - 1]["time"] = -inf


def front_of(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow]) -> int:
    """The ball whose event comes first; NO_BALL if none is to come."""
    if state["queued"] == 0 and state["binned"] != 0:
        fill_queue(state, flights, queue)
    return row_of(queue[0]["ball"]) if state["queued"] > 0 else NO_BALL


def fill_queue(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow]) -> None:
    """Put those into the queue of a crowd, which is empty, for whom something comes soon, if there are any."""
    last, count = len(queue) - 1, int(state["balls"])
    if queue[last]["time"] == inf:
        return
    now, least, wait, waiting = float(state["now"]), inf, 0.0, 0
    for i in range(count):
        due = float(queue[i]["due"])
        if due < inf:
            least = min(least, due)
            wait += due - now
            waiting += 1
    until = least + QUEUE_SHARE * (wait / waiting) if waiting > 0 else inf
    queue[last]["time"] = until
    for i in range(count):
        if queue[i]["due"] <= until and queue[i]["due"] < inf:
            put_event(state, flights, queue, i)


def put_event(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int) -> None:
    """Put a ball into the queue, or move it to where its event's time belongs; if that is far off, note it alone."""
    due = float(flights[ball]["due_time"])
    queue[ball]["due"] = due
    place = row_of(queue[ball]["place"])
    if state["binned"] != 0 and due > queue[len(queue) - 1]["time"]:
        leave(state, flights, queue, ball, place)
    elif place == NO_PLACE:
        place = int(state["queued"])
        state["queued"] = place + 1
        sift_up(flights, queue, ball, place)
    else:
        move_event(state, flights, queue, ball, place)


def take_event(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int) -> None:
    """Take a ball out of the queue, if it is there: nothing is to come for it."""
    queue[ball]["due"] = inf
    leave(state, flights, queue, ball, row_of(queue[ball]["place"]))


def leave(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, place: int) -> None:
    """Take a ball out of its place in the queue, if it has one."""
    if place == NO_PLACE:
        return
    queue[ball]["place"] = NO_PLACE
    last = int(state["queued"]) - 1
    state["queued"] = last
    if place < last:
        move_event(state, flights, queue, row_of(queue[last]["ball"]), place)


def move_event(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, place: int) -> None:
    """Put a ball where it belongs, which is above the free `place`, there or below it."""
    if sift_up(flights, queue, ball, place) == place and 2 * place + 1 < state["queued"]:
        sift_down(state, flights, queue, ball, place)


def sift_up(flights: Table[FlightRow], queue: Table[QueueRow], ball: int, place: int) -> int:
    """The place of a ball after it was moved up from the free `place` as far as it belongs, and written there."""
    time = float(flights[ball]["due_time"])
    while place > 0:
        parent = (place - 1) >> 1
        above, least = row_of(queue[parent]["ball"]), float(queue[parent]["time"])
        if not (time < least or (time == least and is_sooner(flights, ball, above))):
            break
        stand_at(queue, place, above, least)
        place = parent
    stand_at(queue, place, ball, time)
    return place


def sift_down(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, place: int) -> None:
    """Move a ball down from `place` as far as it belongs, which is no higher.

    Those below move up, the sooner of every two, down to the end, and the ball goes up from there: most belong low.
    """
    last = int(state["queued"]) - 1
    child = 2 * place + 1
    while child <= last:
        time = float(queue[child]["time"])
        if child < last:
            other = float(queue[child + 1]["time"])
            one, two = row_of(queue[child]["ball"]), row_of(queue[child + 1]["ball"])
            if other < time or (other == time and is_sooner(flights, two, one)):
                child += 1
                time = other
        stand_at(queue, place, row_of(queue[child]["ball"]), time)
        place = child
        child = 2 * place + 1
    sift_up(flights, queue, ball, place)


def stand_at(queue: Table[QueueRow], place: int, ball: int, time: float) -> None:
    """Let a ball stand at a place of the queue."""
    queue[place]["time"] = time
    queue[place]["ball"] = ball
    queue[ball]["place"] = place
