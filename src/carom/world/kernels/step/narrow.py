"""What happens when a ball and a shape, or two balls, are found close together in the discrete mode."""

from __future__ import annotations

from math import cos, sin

from carom.constants import (
    APPROACH_ROUNDING_SQUARED,
    CROWD_WAY,
    END_DEPTH_DISCRETE,
    END_SLOP,
    LEAST_SHARE,
    LIFT,
    PRESS_DEPTH,
    PRESS_ITERATIONS,
    SEPARATION_SLACK,
    SIDE_ROOM,
)
from carom.geometry.overlap import overlap_ball
from carom.geometry.response import approach_at_contact, exchanged, reflected, separated
from carom.geometry.vector import dot, length, length_squared, rotated
from carom.rows.ball import BallRow
from carom.rows.hit import ENTER, HitRow
from carom.rows.index import ShapeIndex
from carom.rows.kinds import depth_on_entry, find_contact, gap_at_rest, has_ends, in_reach, lets_pass
from carom.rows.masks import may_collide
from carom.rows.pose import is_moving, surface_velocity
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, PASSING, RelationRow
from carom.rows.saved import BUT_KEPT, COUNTED, CROWDED, KEPT, MET, PAIRS_DUE, SHAPES_DUE, SavedRow
from carom.rows.shape import KINEMATIC, ShapeRow
from carom.rows.state import CHANGED, DISCRETE, StateRow
from carom.rows.tables import Table
from carom.world.kernels.step.hits import cross_ball, record_hit, write_crossing
from carom.world.kernels.step.motion import rouse, unsoundness, wake
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.kernels.step.room import BY_BALL, FREE, NEAR, barrier, pressed_depth
from carom.world.kernels.step.spending import spend
from carom.world.kernels.step.times import hit_time, rest_speed

BOTH_DUE = SHAPES_DUE | PAIRS_DUE

#: The way of a ball in its own move of a substep: from x, y, to x, y.
Way = tuple[float, float, float, float]

#: How a ball touches something: the point, the unit normal towards the ball, and the setback.
Touch = tuple[float, float, float, float, float]


def boxes_apart(ball: BallRow, shape: ShapeRow) -> bool:
    """True if the boxes of a ball and a shape do not even touch."""
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    return bool(
        x + radius < shape["left"]
        or x - radius > shape["right"]
        or y + radius < shape["bottom"]
        or y - radius > shape["top"]
    )


def is_between_ends(shape: ShapeRow, x: float, y: float, radius: float) -> bool:
    """True if the centre of a ball at (x, y) is in the slab of a segment or the sector of an arc, or just past them."""
    return in_reach(shape, x, y) or gap_at_rest(shape, x, y, radius, 0.0, 0.0, END_SLOP * radius) is not None


def contact_past_end(shape: ShapeRow, x: float, y: float, radius: float, wx: float, wy: float) -> Touch | None:
    """What `find_contact` returns, or None, for a ball past an end of a segment or arc by no more than `END_SLOP`.

    So no ball gets between two that continue each other, where rounding or the least bend leaves a gap.
    """
    if not has_ends(shape["kind"]):
        return None
    found = gap_at_rest(shape, x, y, radius, wx, wy, END_SLOP * radius)
    if found is None:
        return None
    # Past the end by less than the slop counts as beside the end, with the normal of the side.
    gap, nx, ny = found
    if gap >= 0.0:
        return None
    return x - (radius + gap) * nx, y - (radius + gap) * ny, nx, ny, 0.0 - gap


def seen_from(shape: ShapeRow, x: float, y: float) -> tuple[float, float]:
    """Where (x, y), a place before the substep, lies as seen from a shape that may have moved since; exact if not."""
    turn = float(shape["orientation"]) - float(shape["orientation_before"])
    from_x, from_y = float(shape["pivot_before_x"]), float(shape["pivot_before_y"])
    to_x, to_y = float(shape["pivot_x"]), float(shape["pivot_y"])
    if shape["motion"] != KINEMATIC or (turn == 0.0 and from_x == to_x and from_y == to_y):
        return x, y
    # Where the shape was is turned and moved to where it is; the place goes along.
    dx, dy = rotated(x - from_x, y - from_y, cos(turn), sin(turn))
    return to_x + dx, to_y + dy


def starts_passing(shape: ShapeRow, ball: BallRow, setback: float, moved: bool, way: Way) -> bool:
    """True if a ball that overlaps a shape passes it from now on.

    `moved` is False in later iterations, when only pushes move balls, and a ball that was pushed onto a shape does not
    pass it. Nor does one that was clear of the shape before or when its centre came into the slab or sector: a ball
    that falls fast onto a joint has done nothing else.
    """
    if not moved:
        return lets_pass(shape, float(ball["x"]), float(ball["y"]))
    if not has_ends(shape["kind"]):
        return False
    from_x, from_y, to_x, to_y = way
    x, y = seen_from(shape, from_x, from_y)
    if lets_pass(shape, x, y):
        return True
    radius = float(ball["radius"])
    least = END_DEPTH_DISCRETE * radius
    # A shallow overlap is the landing of a ball that comes from the side; a deep one past the ends is no landing.
    if setback <= least or is_between_ends(shape, x, y, radius) or not is_between_ends(shape, to_x, to_y, radius):
        return False
    return depth_on_entry(shape, radius, x, y, to_x, to_y) > least


def overlap_with(state: StateRow, ball: BallRow, shape: ShapeRow) -> Touch | None:
    """The overlap of a ball with a shape whose box it meets, as `find_contact` gives it, or None.

    A little past a segment's or arc's ends too: see `contact_past_end`.
    """
    state["full_tests"] += 1
    x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
    ux, uy = surface_velocity(shape, float(shape["spin"]), x, y, 0.0)
    wx, wy = float(ball["vx"]) - ux, float(ball["vy"]) - uy
    contact = find_contact(shape, x, y, radius, wx, wy)
    if contact is None:
        contact = contact_past_end(shape, x, y, radius, wx, wy)
    if contact is None:
        return None
    _px, _py, _nx, _ny, setback = contact
    # In flight a ball may touch to rounding without being in need of a push.
    if state["detection"] != DISCRETE and setback <= SEPARATION_SLACK * radius:
        return None
    return contact


def meet_shape(
    state: StateRow,
    ball: BallRow,
    ball_row: int,
    shapes: Table[ShapeRow],
    shape_row: int,
    shape_index: ShapeIndex,
    hits: Table[HitRow],
    relations: Table[RelationRow],
    mark: SavedRow,
    moved: bool,
    way: Way,
    touch: Touch,
) -> bool:
    """True if a ball that overlaps a shape was moved out of it; responds. There must be room: a hit, a relation.

    `mark` is the ball's row of `SAVED`; the rest as in `starts_passing`. A ball that has no room to be moved to stays,
    and a shape that moves goes over it.
    """
    px, py, nx, ny, setback = touch
    shape = shapes[shape_row]
    if shape["sensor"] != 0 or ball["sensor"] != 0:
        if not find_relation(relations, ball, INSIDE_SHAPE, shape_row):
            add_relation(state, relations, ball, ball_row, INSIDE_SHAPE, shape_row)
            ux, uy = surface_velocity(shape, float(shape["spin"]), px, py, 0.0)
            speed = length(float(ball["vx"]) - ux, float(ball["vy"]) - uy)
            write_crossing(
                state, hits[state["hits"]], hit_time(state), ENTER, ball, int(shape["id"]), (px, py, nx, ny), speed
            )
        return False
    if find_relation(relations, ball, PASSING, shape_row):
        return False
    if mark["touched"] & KEPT and setback <= LIFT * float(ball["radius"]):
        return False
    if starts_passing(shape, ball, setback, moved, way):
        add_relation(state, relations, ball, ball_row, PASSING, shape_row)
        return False
    # From here on the shape holds the ball: it is moved out, and turned.
    share, pressed = room_for_push(state, ball, shapes, shape_row, shape_index, relations, nx, ny, setback)
    setback = share * setback
    if share == 0.0:
        count_squeezed(state, mark)
        if is_moving(shape):
            add_relation(state, relations, ball, ball_row, PASSING, shape_row)
            return False
    else:
        ball["x"] = float(ball["x"]) + setback * nx
        ball["y"] = float(ball["y"]) + setback * ny
    if mark["touched"] & MET or share < 1.0 or setback > CROWD_WAY * float(ball["radius"]):
        mark["touched"] |= CROWDED
    mark["touched"] = (mark["touched"] | BOTH_DUE | MET) & BUT_KEPT
    state["found"] += 1
    bounce_off_shape(state, ball, shapes, shape_row, hits[state["hits"]], (px, py, nx, ny, setback), pressed)
    limit_speed(state, ball)
    doubt(state, ball)
    return share > 0.0


def room_for_push(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    shape_row: int,
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    nx: float,
    ny: float,
    setback: float,
) -> tuple[float, bool]:
    """The share of its setback by which a shape moves a ball, and whether it moves and presses it onto one at rest.

    0 where the ball would cross another's side, or where the last iteration still presses it deep onto a shape at rest.
    What stands still moves it by less, rather than not at all, where it would come too near to another's side.
    """
    moving = is_moving(shapes[shape_row])
    share = 1.0
    found = barrier(state, ball, shapes, shape_index, relations, shape_row, setback * nx, setback * ny)
    # By halves: where a wedge is too narrow the ball comes out of it over several iterations and substeps.
    while found == NEAR and not moving and share > LEAST_SHARE:
        share *= 0.5
        dx, dy = share * setback * nx, share * setback * ny
        found = barrier(state, ball, shapes, shape_index, relations, shape_row, dx, dy)
    if found != FREE:
        return 0.0, False
    # Early iterations may still push the other way; what is pressed in the last one stays pressed.
    last = state["iteration"] + 1 == state["iterations"]
    if not last and (not moving or state["iteration"] < PRESS_ITERATIONS):
        return share, False
    depth = pressed_depth(ball, shapes, shape_index, relations, shape_row, nx, ny, setback)
    return 0.0 if last and depth > PRESS_DEPTH * float(ball["radius"]) else share, moving and depth > 0.0


def count_squeezed(state: StateRow, mark: SavedRow) -> None:
    """Count a ball that has no room to be pushed to, once a substep."""
    if mark["touched"] & COUNTED == 0:
        mark["touched"] |= COUNTED
        state["squeezed"] += 1


def bounce_off_shape(
    state: StateRow,
    ball: BallRow,
    shapes: Table[ShapeRow],
    shape_row: int,
    hit: HitRow,
    touch: Touch,
    pressed: bool,
) -> None:
    """Turn a ball's velocity at a static or kinematic shape, if it approaches, and record the hit in the next free row.

    One that is `pressed` onto something has no room to bounce: it goes with the surface.
    """
    shape = shapes[shape_row]
    px, py, nx, ny, setback = touch
    vx, vy = float(ball["vx"]), float(ball["vy"])
    ux, uy = surface_velocity(shape, float(shape["spin"]), px, py, 0.0)
    wx, wy = vx - ux, vy - uy
    s = dot(wx, wy, nx, ny)
    if not approaches(s, length_squared(vx, vy) + length_squared(ux, uy)):
        return
    # The speed that the ball had when it touched, not that which gravity has given it inside the shape since.
    g_n = dot(float(state["gravity_x"]), float(state["gravity_y"]), nx, ny)
    approach = approach_at_contact(s, g_n, setback)
    elasticity = float(ball["elasticity"]) * float(shape["elasticity"])
    kick = float(shape["kick"])
    # Too slow to leave again before gravity brings it back: it comes to rest on the shape.
    if pressed or (elasticity < 1.0 and kick == 0.0 and -approach < rest_speed(state, float(ball["radius"]))):
        ball["vx"] = vx - s * nx
        ball["vy"] = vy - s * ny
        return
    total = state["total_restitution"] != 0
    new_x, new_y, gain = reflected(vx, vy, ux, uy, nx, ny, elasticity, approach, kick, total)
    ball["vx"] = new_x
    ball["vy"] = new_y
    wake(state, ball)
    impulse = gain * float(ball["mass"])
    record_hit(state, hit, hit_time(state), ball, shape, touch, (vx, vy), length(wx, wy), impulse)
    if shape["once"] != 0:
        spend(state, shapes, shape)
        # What rested on it falls with the next step.
        state["wake"] = max(state["wake"], CHANGED)


def approaches(s: float, squares: float) -> bool:
    """True if the normal speed `s` is an approach, and not what rounding has left of one that a response has ended.

    `squares` is the sum of the squared speeds that `s` is the difference of.
    """
    return s < 0.0 and not s * s < APPROACH_ROUNDING_SQUARED * squares


def limit_speed(state: StateRow, ball: BallRow) -> None:
    """Slow a ball that is faster than the world's `max_speed` to it, and count it."""
    most = float(state["max_speed"])
    if most < 0.0:
        return
    vx, vy = float(ball["vx"]), float(ball["vy"])
    speed = length(vx, vy)
    if speed > most:
        share = most / speed
        ball["vx"] = vx * share
        ball["vy"] = vy * share
        state["slowed"] += 1


def doubt(state: StateRow, ball: BallRow) -> None:
    """Note where a ball that was pushed or turned is not where numbers reach; the step's end looks at all balls."""
    if unsoundness(float(ball["x"]), float(ball["y"]), float(ball["vx"]), float(ball["vy"])) != 0.0:
        state["doubtful"] = 1


def balls_overlap(state: StateRow, first: BallRow, second: BallRow) -> bool:
    """True if two balls overlap, may collide, and are not both asleep."""
    reach = first["radius"] + second["radius"]
    dx = second["x"] - first["x"]
    dy = second["y"] - first["y"]
    # The boxes first, without the absolute value: four comparisons that mostly end at the first.
    if dx > reach or -dx > reach or dy > reach or -dy > reach or not may_collide(first, second):
        return False
    # Sleepers keep what overlap they fell asleep with, or a pile would never rest.
    if first["asleep"] != 0 and second["asleep"] != 0:
        return False
    state["full_tests"] += 1
    return bool(dx * dx + dy * dy < reach * reach)


def meet_sensing_ball(
    state: StateRow,
    first: BallRow,
    i: int,
    second: BallRow,
    j: int,
    hits: Table[HitRow],
    relations: Table[RelationRow],
) -> None:
    """Let overlapping balls, of which one is a sensor, be inside each other. There must be room for a relation."""
    if not find_relation(relations, second, INSIDE_BALL, i):
        add_relation(state, relations, second, j, INSIDE_BALL, i)
        cross_ball(state, hits[state["hits"]], hit_time(state), ENTER, second, first)


def meet_ball(
    state: StateRow,
    first: BallRow,
    second: BallRow,
    mark: SavedRow,
    other_mark: SavedRow,
    hit: HitRow,
) -> bool:
    """True if two balls have been pushed apart and may have come to the side of a shape, which `keep_side` sees.

    They respond to each other; `mark` and `other_mark` are their rows of `SAVED`, `hit` is the next free row.
    """
    x1, y1, r1 = float(first["x"]), float(first["y"]), float(first["radius"])
    x2, y2, r2 = float(second["x"]), float(second["y"]), float(second["radius"])
    wx, wy = float(second["vx"]) - float(first["vx"]), float(second["vy"]) - float(first["vy"])
    contact = overlap_ball(x1, y1, r1, x2, y2, r2, wx, wy)
    if contact is None:
        return False
    px, py, nx, ny, setback = contact
    if state["detection"] != DISCRETE and setback <= SEPARATION_SLACK * (r1 + r2):
        return False
    if x1 == x2 and y1 == y2:
        state["overlaps"] += 1
    # In inverse proportion to the masses, which leaves their centre of mass where it was.
    push_apart(first, second, nx, ny, setback)
    mark["touched"] = (mark["touched"] | BOTH_DUE) & BUT_KEPT
    other_mark["touched"] = (other_mark["touched"] | BOTH_DUE) & BUT_KEPT
    state["found"] += 1
    bounce_pair(state, first, second, hit, (px, py, nx, ny, setback))
    limit_speed(state, first)
    limit_speed(state, second)
    doubt(state, first)
    doubt(state, second)
    # What only rests on a sleeping ball does not wake it, but it is in the way of shapes now; `finish_substep` puts it
    # back to sleep at once.
    rouse(state, first)
    rouse(state, second)
    return is_crowded(first, mark) or is_crowded(second, other_mark)


def is_crowded(ball: BallRow, mark: SavedRow) -> bool:
    """True if a ball that another has pushed may have come to the side of a shape.

    It is `CROWDED`, or far from where it met the shapes last, which left it clear of the one it overlapped, if any.
    """
    dx, dy = float(ball["x"]) - float(mark["met_x"]), float(ball["y"]) - float(mark["met_y"])
    near = (CROWD_WAY if mark["touched"] & MET else 1.0 - SIDE_ROOM) * float(ball["radius"])
    return mark["touched"] & CROWDED != 0 or dx * dx + dy * dy > near * near


def keep_side(
    state: StateRow,
    ball: BallRow,
    mark: SavedRow,
    shapes: Table[ShapeRow],
    shape_index: ShapeIndex,
    relations: Table[RelationRow],
    from_x: float,
    from_y: float,
) -> None:
    """Put a ball that another has pushed across the side of a shape back to (from_x, from_y)."""
    x, y = float(ball["x"]), float(ball["y"])
    ball["x"] = from_x
    ball["y"] = from_y
    if barrier(state, ball, shapes, shape_index, relations, BY_BALL, x - from_x, y - from_y) != FREE:
        count_squeezed(state, mark)
        return
    ball["x"] = x
    ball["y"] = y


def push_apart(first: BallRow, second: BallRow, nx: float, ny: float, setback: float) -> None:
    """Move two balls apart along the normal until they touch, in inverse proportion to their masses."""
    x1, y1, x2, y2 = separated(
        float(first["x"]),
        float(first["y"]),
        float(first["mass"]),
        float(second["x"]),
        float(second["y"]),
        float(second["mass"]),
        nx,
        ny,
        setback,
    )
    first["x"] = x1
    first["y"] = y1
    second["x"] = x2
    second["y"] = y2


def bounce_pair(
    state: StateRow,
    first: BallRow,
    second: BallRow,
    hit: HitRow,
    touch: Touch,
) -> None:
    """Exchange the normal speeds of two balls, if they approach, and record the hit."""
    _px, _py, nx, ny, _setback = touch
    vx, vy = float(first["vx"]), float(first["vy"])
    wx, wy = float(second["vx"]), float(second["vy"])
    u1, u2 = dot(vx, vy, nx, ny), dot(wx, wy, nx, ny)
    if not approaches(u2 - u1, length_squared(vx, vy) + length_squared(wx, wy)):
        return
    first_mass, second_mass = float(first["mass"]), float(second["mass"])
    elasticity = float(first["elasticity"]) * float(second["elasticity"])
    # Slow impacts of balls lose all of the approach, so that piles come to rest.
    radius = min(float(first["radius"]), float(second["radius"]))
    resting = elasticity < 1.0 and u1 - u2 < rest_speed(state, radius)
    new1, new2 = exchanged(u1, u2, first_mass, second_mass, 0.0 if resting else elasticity)
    first["vx"] = vx + (new1 - u1) * nx
    first["vy"] = vy + (new1 - u1) * ny
    second["vx"] = wx + (new2 - u2) * nx
    second["vy"] = wy + (new2 - u2) * ny
    if resting:
        return
    wake(state, first)
    wake(state, second)
    # Not from the change of either's speed: that of a far heavier ball is lost in the rounding of its speed.
    impulse = (1.0 + elasticity) * (first_mass / (first_mass + second_mass)) * second_mass * (u1 - u2)
    record_hit(state, hit, hit_time(state), second, first, touch, (wx, wy), length(wx - vx, wy - vy), impulse)
