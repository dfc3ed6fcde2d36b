"""The row of a ball's flight: the path that it is on since its last event, and what comes next (continuous)."""

from typing import TypedDict

from carom.rows.tables import dtype_in_order, dtype_of, f8, i2, i4, i8

# What comes next in a ball's flight. Of its own events at one instant the greatest comes first.
NOTHING = 0
LOOK = 1  # it looks farther ahead; its path stays what it is
STRAY = 2  # it leaves the world's bounds, or comes back; its path stays what it is
TICK = 3  # it is put back onto the bent or moving shape along which it slides, or its island is solved
STOP = 4  # friction has taken its speed
SLEEP = 5
CLEAR = 6  # it has come off a shape that it passed; its path stays what it is
LEAVE = 7  # it comes to the end of the shape that it rests on
EXIT_SHAPE = 8  # it leaves a sensor
EXIT_BALL = 9
HIT_SHAPE = 10
HIT_BALL = 11

# How a ball takes part.
FLYING = 0
ASLEEP = 1

NO_PLACE = -1  # of a ball that is not in the queue of events
NO_BALL = -1
NO_SHAPE = -1
IN_PART = -1  # in place of impacts
NO_TICK = 1e300  # later than any instant of a world


class CourseRow(TypedDict):
    """What a flight is: where a ball was and how it moved at an instant, and its acceleration since.

    While a step is made, the rows of the balls hold place and velocity at that instant; between two steps these are
    here, and the balls' rows show where the balls are. Here they stand for those, too, that look for balls near them.
    """

    id: i8  # of the ball; below 0 where that was changed from outside, and is to begin a new flight
    time: f8  # the instant at which it began
    low: f8
    x: f8
    y: f8
    vx: f8
    vy: f8
    low_vx: f8  # what its doubles cannot hold of the velocity that its last impact left it
    low_vy: f8
    ax: f8
    ay: f8
    energy: f8  # per mass, of a ball of an island, as of its last solve
    surplus: f8  # per mass, what it has won since then
    tick_time: f8  # the instant at which its island is solved next; NO_TICK if it is in none
    tick_low: f8
    slow_for: f8  # seconds for which it had been slower than the sleep speed when it began
    met_time: f8  # the instant of its last impact
    met_low: f8
    at_once: i8  # how many impacts, up to it, each came at all but the instant of the one before
    # what was shown of it last; where the ball's row is otherwise, it was changed from outside
    shown_x: f8
    shown_y: f8
    shown_vx: f8
    shown_vy: f8
    short: i4  # impacts since then that came too soon after one another to be told apart
    quiet: i4  # ticks of its island, one after the other, in which it hardly moved
    kind: i4


class FlightRow(CourseRow):
    """A ball's flight, with what comes next in it, where the ball is filed, and what a step that fails goes back to."""

    # what comes next
    event_time: f8
    event_low: f8
    event_key: i8  # of events at one instant the least comes first
    # when it is filed anew at the latest; infinite if it stays where it is
    file_time: f8
    file_low: f8
    # the sooner of the two, by which it stands in the queue
    due_time: f8
    due_low: f8
    due_key: i8
    event: i4
    partner: i4
    partner_version: i4
    version: i4  # changes with the path
    row: i4
    # where it is filed
    column: i4
    line: i4
    level: i2
    filings: i2  # of late, one after the other with no event of its own in between
    next: i4  # in the same cell
    reach: f8  # its radius where it falls freely, as all do that nothing else pulls, and is no sensor; otherwise 0
    body: i4  # one more than its place in the island that is being solved; 0 if it is in none
    # what a step that fails goes back to
    impacts: i4  # in this step; of the copy IN_PART, or something else where all is copied
    kept: i8  # the step in which it was copied last
    still_time: f8
    relation: i4
    asleep: i2
    stray: i2
    # what was seen before the first step of a call
    seen_x: f8
    seen_y: f8
    seen_vx: f8
    seen_vy: f8
    seen_still: f8
    seen_relation: i4
    seen_asleep: i2
    seen_stray: i2


class QueueRow(TypedDict):
    """A place in the queue of coming events; and of the ball that has the same row when it is due, and where it stands.

    There is one more row than balls: its `time` is that up to which the queue of a crowd goes, its `due` how many
    seconds at once it is filled with.
    """

    time: f8  # of the event
    due: f8  # of the ball with this row; infinite if nothing is to come for it
    ball: i4
    place: i4  # of the ball with this row, or NO_PLACE


COURSE = dtype_of(CourseRow)

#: By lines of memory, each of 64 bytes: what is asked of a ball near another, the rest of a flight, and what an impact
#: looks at, which are what is copied; what comes next, and when; what is shown and was seen, which no event asks for.
FLIGHT = dtype_in_order(
    FlightRow,
    """
    time low x y vx vy reach next level filings
    low_vx low_vy ax ay slow_for tick_time tick_low kind impacts
    met_time met_low at_once energy surplus still_time short quiet relation asleep stray
    event_time event_low event_key file_time file_low event partner partner_version version row body
    due_time due_low due_key kept column line id seen_still seen_relation seen_asleep seen_stray
    shown_x shown_y shown_vx shown_vy seen_x seen_y seen_vx seen_vy
    """,
)
#: Lines of a flight of which a copy is kept, and which an event asks for.
COPIED_LINES, EVENT_LINES = 3, 5
QUEUE = dtype_of(QueueRow)
