"""The rows that say where a copy of a world is in the memory of many copies, and how far a call has come with them."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i8

# Where a call is with the copy that it deals with.
TAKE = 0
STEP = 1
PUT = 2
GIVE = 3

# Why a call came back, besides what a step's kernel says.
STEP_DUE = 100  # the step of the copy that is out is to be made by the caller: it cannot be called from here
LACKS_HITS = 101  # there is too little room for the hits of the copy that is out
LACKS_MEMORY = 102  # the copy that is out needs more room for its relations: `wanted`


class LayoutRow(TypedDict):
    """Where the parts of a copy begin, in words of 64 bits (or bytes, as said); its state stands at its beginning."""

    words: i8  # of a copy in all
    state_words: i8  # of each kind of row
    ball_words: i8
    saved_words: i8
    flight_words: i8
    queue_words: i8
    shape_words: i8
    relation_words: i8
    balls: i8  # of each copy, in play or not
    balls_at: i8
    saved_at: i8
    flights_at: i8  # 0: there are none, and no queue (discrete)
    queue_at: i8
    moving_at: i8  # the rows of its kinematic shapes
    relations_at: i8
    relations_room: i8  # rows
    high_word: i8  # the word of the state that says how many of them are in use
    switches_at: i8  # bytes: `can_collide` and `once` of the static shapes in which those may differ between copies
    in_play_at: i8  # bytes: whether each ball is in play


LAYOUT = dtype_of(LayoutRow)


class JobRow(TypedDict):
    """What is to be done, and how far it has come."""

    next: i8  # the copy that is dealt with
    last: i8  # one more than the last copy of this call
    end: i8  # one more than the last copy of all
    place: i8  # where it is with that: TAKE, STEP, PUT or GIVE
    status: i8  # what the step of that copy came back with
    steps: i8
    dt: f8
    function: i8  # the address of the compiled step, called with `block`; 0: the caller makes the steps
    block: i8
    keep_hits: i8
    written: i8  # hits given
    wanted: i8


JOB = dtype_of(JobRow)
