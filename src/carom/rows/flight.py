"""The row of a ball's flight in a span of a substep (continuous)."""

from __future__ import annotations

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4

# What comes next in a ball's flight.
NOTHING = 0
LOOK = 1  # it is filed anew and looks around anew
LEAVE = 2  # it comes to the end of the segment that it rests on
HIT_SHAPE = 3
HIT_BALL = 4

# How a ball takes part in a span.
FLYING = 0
ASLEEP = 1
STALLED = 2  # it has reached `max_impacts` and stands still for the rest of the substep

NO_PLACE = -1  # of a ball that is not in the queue of events
NO_BALL = -1


class FlightRow(TypedDict):
    """A ball's flight in a span of a substep (continuous)."""

    time: f8  # of the span, at which the ball is where its row says
    ax: f8
    ay: f8
    energy: f8  # per mass, while it slides along shapes at rest
    patience: f8  # until when it does not look for impacts with balls that are patient too
    event_time: f8
    bin_x: f8
    bin_y: f8
    event: i4
    partner: i4
    partner_version: i4
    version: i4  # changes with the path
    place: i4  # in the queue
    kind: i4
    impacts: i4
    level: i4
    cell: i4
    next: i4  # in the same cell


FLIGHT = dtype_of(FlightRow)
