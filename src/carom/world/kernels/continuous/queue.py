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

#: Part of the time for which the balls of a crowd wait for their next event on the whole: at first the queue is filled
#: with what comes in it. More means a longer queue, less means it is filled more often.
QUEUE_SHARE = 0.0625

#: Of a crowd, the part that the queue holds when it was filled, at least and at most; where it is less or more, it is
#: filled for twice or half as long the next time.
QUEUE_LEAST, QUEUE_MOST = 0.03125, 0.125


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
    """Put those into the queue of a crowd, which is empty, for whom something comes soon, if there are any.

    How far it goes follows from how many the last time found: a pass over all balls that looks for it is saved.
    """
    last, count = len(queue) - 1, int(state["balls"])
    known = float(queue[last]["time"])
    if known == inf:
        return
    now = float(state["now"])
    span = float(queue[last]["due"]) if known > -inf else QUEUE_SHARE * mean_wait(state, queue)
    until = max(now, known) + span
    least = enter_due(state, flights, queue, until)
    if state["queued"] == 0:
        until = least + span
        enter_due(state, flights, queue, until)
    if state["queued"] > QUEUE_MOST * count:
        span *= 0.5
    elif state["queued"] < QUEUE_LEAST * count:
        span = max(2.0 * span, QUEUE_SHARE * mean_wait(state, queue))
    queue[last]["time"] = until
    queue[last]["due"] = span


def mean_wait(state: StateRow, queue: Table[QueueRow]) -> float:
    """The seconds for which balls wait for their next event on the whole, of those that do; infinite if none does.

    What was to come before now, of a flight that has lasted longer, has not to be waited for.
    """
    now, wait, waiting = float(state["now"]), 0.0, 0
    for i in range(state["balls"]):
        due = float(queue[i]["due"])
        if due < inf:
            wait += max(due - now, 0.0)
            waiting += 1
    return wait / waiting if waiting > 0 else inf


def enter_due(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], until: float) -> float:
    """Put those into the queue, which is empty, who are due up to a time; the least time at which another one is."""
    least = inf
    for i in range(state["balls"]):
        due = float(queue[i]["due"])
        if due > until:
            least = min(least, due)
        elif due < inf:
            enter(state, flights, queue, i, due)
    return least


def put_event(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int) -> None:
    """Put a ball into the queue, or move it to where its event's time belongs; if that is far off, note it alone."""
    due = float(flights[ball]["due_time"])
    queue[ball]["due"] = due
    place = row_of(queue[ball]["place"])
    if state["binned"] != 0 and due > queue[len(queue) - 1]["time"]:
        leave(state, flights, queue, ball, place)
    elif place == NO_PLACE:
        enter(state, flights, queue, ball, due)
    else:
        move_event(state, flights, queue, ball, due, place)


def enter(state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, due: float) -> None:
    """Put a ball into the queue that is not in it and is due at a time."""
    place = int(state["queued"])
    state["queued"] = place + 1
    sift_up(flights, queue, ball, due, place)


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
        move_event(state, flights, queue, row_of(queue[last]["ball"]), float(queue[last]["time"]), place)


def move_event(
    state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, due: float, place: int
) -> None:  # fmt: skip
    """Put a ball that is due at a time where it belongs, which is above the free `place`, there or below it."""
    if sift_up(flights, queue, ball, due, place) == place and 2 * place + 1 < state["queued"]:
        sift_down(state, flights, queue, ball, due, place)


def sift_up(flights: Table[FlightRow], queue: Table[QueueRow], ball: int, due: float, place: int) -> int:
    """The place of a ball after it was moved up from the free `place` as far as it belongs, and written there."""
    while place > 0:
        parent = (place - 1) >> 1
        above, least = row_of(queue[parent]["ball"]), float(queue[parent]["time"])
        if not (due < least or (due == least and is_sooner(flights, ball, above))):
            break
        stand_at(queue, place, above, least)
        place = parent
    stand_at(queue, place, ball, due)
    return place


def sift_down(
    state: StateRow, flights: Table[FlightRow], queue: Table[QueueRow], ball: int, due: float, place: int
) -> None:  # fmt: skip
    """Move a ball down from `place` as far as it belongs, which is no higher.

    Those below move up, the sooner of every two, down to the end, and the ball goes up from there: most belong low.
    """
    last = int(state["queued"]) - 1
    child = 2 * place + 1
    while child <= last:
        if child < last:
            child += second_is_sooner(flights, queue, child)
        stand_at(queue, place, row_of(queue[child]["ball"]), float(queue[child]["time"]))
        place = child
        child = 2 * place + 1
    sift_up(flights, queue, ball, due, place)


def second_is_sooner(flights: Table[FlightRow], queue: Table[QueueRow], place: int) -> int:
    """1 if who stands behind a place is to be dealt with before who stands there, else 0.

    A number, as which of the two it is no processor foresees.
    """
    time, other = float(queue[place]["time"]), float(queue[place + 1]["time"])
    if other == time:
        return int(is_sooner(flights, row_of(queue[place + 1]["ball"]), row_of(queue[place]["ball"])))
    return int(other < time)


def stand_at(queue: Table[QueueRow], place: int, ball: int, time: float) -> None:
    """Let a ball stand at a place of the queue."""
    queue[place]["time"] = time
    queue[place]["ball"] = ball
    queue[ball]["place"] = place
