"""The rows of an island: the balls that lie on each other while their contacts are solved, and these contacts."""

from typing import TypedDict

from carom.rows.tables import dtype_of, f8, i4

NO_BODY = -1  # second body of a contact with a shape
NO_CONTACT = -1  # end of a body's list of contacts
WANTED = 2  # of a body that is to be taken into the core
NOT_QUEUED = -2  # of a body that waits for no visit; the last one that waits has NO_BODY after it


class BodyRow(TypedDict):
    """A ball of an island."""

    # what every sweep and search reads, side by side
    wx: f8  # the velocity that is being solved
    wy: f8
    sx: f8  # how it changes along the direction of a search, per unit of step
    sy: f8
    zx: f8  # the same for the direction of steepest descent
    zy: f8
    inverse_mass: f8
    mass: f8
    free_x: f8  # the velocity without impulses
    free_y: f8
    vx: f8
    vy: f8
    contacts: i4  # first of its list
    after: i4  # who is visited next
    visits: i4  # in the spreading of one impact
    reached: i4  # 1 if its velocity has changed by that
    ball: i4  # its row
    core: i4  # 1 if all of its contacts are among those that are being solved, or WANTED
    x: f8
    y: f8
    ax: f8
    ay: f8
    gx: f8  # the acceleration that it would have without contacts: gravity and friction
    gy: f8
    radius: f8
    from_x: f8  # the place before overlaps were taken back
    from_y: f8


class IslandContactRow(TypedDict):
    """A contact of a ball with another or a shape; its speed is `(w_first - w_second)·n + bias`, below 0 in approach.

    `start_...`, `gap` and `bend` of a shape are given for where the ball is, `mean_...` for the condition on the mean
    velocity of a tick; of a pair, all are worked out from places.
    """

    # what every sweep and search reads, side by side
    nx: f8  # unit normal in use, to the first body
    ny: f8
    bias: f8  # in use
    impulse: f8
    effective_mass: f8
    mobility: f8  # the velocity that a unit of impulse makes: one over the effective mass, or 0 with it
    residual: f8
    descent: f8  # impulses along the direction of steepest descent, and along that of the search
    search: f8
    first: i4
    second: i4  # NO_BODY if the other is a shape
    loaded: i4  # 1 while a search may change its impulse
    holds: i4  # 1 while the contact may pull as well as press
    next_of_first: i4  # in the lists of contacts of its bodies
    next_of_second: i4
    shape: i4  # its row, if it is one
    lasting: i4  # 0 of a shape that is only near: places heed it, forces do not
    acted: i4  # 1 if it has given an impulse while an impact spread
    rest_speed: f8  # an impact that spreads does not let it rebound more slowly
    gap: f8  # below 0 in an overlap
    start_nx: f8
    start_ny: f8
    start_bias: f8  # minus the surface's velocity along the normal
    mean_nx: f8
    mean_ny: f8
    mean_bias: f8
    bend: f8  # along the normal from the ball's centre to the surface's centre of curvature; 0 where it is straight
    elasticity: f8
    force: f8  # over the last tick; where the next solve begins
    force_x: f8  # as it was solved last, on the first body, whose acceleration it is a part of
    force_y: f8


BODY = dtype_of(BodyRow)
ISLAND_CONTACT = dtype_of(IslandContactRow)
