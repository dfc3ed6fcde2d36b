"""Where a shape's row stands: its derived fields, its turns about a pivot, and one substep of its motion.

These functions read and write one row of dtype `carom.rows.SHAPE`, in place. Numba compiles them as they stand; in the
interpreter the numbers are made Python floats when read, so that both give the same bits and neither warns.
"""

from __future__ import annotations

from math import cos, fabs, inf, sin

from carom.constants import STOP_MARGIN
from carom.geometry.aabb import arc_box, circle_box, segment_box
from carom.geometry.angle import normalize_angle
from carom.geometry.arc import arc_ends
from carom.geometry.vector import length, rotated, unit
from carom.rows.kinds import is_round, is_straight
from carom.rows.shape import ARC, ARRIVED, CIRCLE, GATE, KINEMATIC, POINT, SEGMENT, STATIC, ShapeRow

# What `advance` has done to a shape.
STILL = 0
POSED = 1
UNPOSED = 2


def derive(shape: ShapeRow) -> None:
    """Make the fields that follow from the current geometry agree with it: ends, tangent, middle, box.

    The current geometry is `cx, cy` of a point or circle, `ax, ay, bx, by` of a segment or gate in either order, and
    `cx, cy, radius, start_angle, end_angle` (normalized) of an arc. A segment whose ends rounding has made one keeps
    the tangent that it had. A shape of an unknown kind may be anywhere: its box is infinite, by which a world sees it.
    Source: docs/shapes-and-responses.md.
    """
    kind = shape["kind"]
    if kind == POINT:
        x, y = float(shape["cx"]), float(shape["cy"])
        _set_box(shape, x, y, x, y)
    elif is_straight(kind):
        _derive_segment(shape)
    elif kind == CIRCLE:
        left, bottom, right, top = circle_box(float(shape["cx"]), float(shape["cy"]), float(shape["radius"]))
        _set_box(shape, left, bottom, right, top)
    elif kind == ARC:
        _derive_arc(shape)
    else:
        _set_box(shape, -inf, -inf, inf, inf)


def _set_box(shape: ShapeRow, left: float, bottom: float, right: float, top: float) -> None:
    """Store the four sides of the box."""
    shape["left"] = left
    shape["bottom"] = bottom
    shape["right"] = right
    shape["top"] = top


def _derive_segment(shape: ShapeRow) -> None:
    """Order the ends (smaller x first, then smaller y) and derive middle, tangent, length and box."""
    ax, ay = float(shape["ax"]), float(shape["ay"])
    bx, by = float(shape["bx"]), float(shape["by"])
    if bx < ax or (bx == ax and by < ay):
        ax, ay, bx, by = bx, by, ax, ay
        shape["ax"] = ax
        shape["ay"] = ay
        shape["bx"] = bx
        shape["by"] = by
    # Halves are added, not a sum halved: the sum of two large coordinates may overflow.
    shape["cx"] = 0.5 * ax + 0.5 * bx
    shape["cy"] = 0.5 * ay + 0.5 * by
    shape["length"] = length(bx - ax, by - ay)
    tangent = unit(bx - ax, by - ay)
    if tangent is not None:
        tx, ty = tangent
        shape["tx"] = tx
        shape["ty"] = ty
    left, bottom, right, top = segment_box(ax, ay, bx, by)
    _set_box(shape, left, bottom, right, top)


def _derive_arc(shape: ShapeRow) -> None:
    """Derive the ends and the box of an arc from its centre, radius and angles."""
    cx, cy, radius = float(shape["cx"]), float(shape["cy"]), float(shape["radius"])
    start, end = float(shape["start_angle"]), float(shape["end_angle"])
    ax, ay, bx, by = arc_ends(cx, cy, radius, start, end)
    shape["ax"] = ax
    shape["ay"] = ay
    shape["bx"] = bx
    shape["by"] = by
    left, bottom, right, top = arc_box(cx, cy, radius, ax, ay, bx, by)
    _set_box(shape, left, bottom, right, top)


def set_initial(shape: ShapeRow) -> None:
    """Make the current geometry and pivot the initial ones, with orientation 0 and no motion behind it."""
    shape["initial_cx"] = shape["cx"]
    shape["initial_cy"] = shape["cy"]
    shape["initial_ax"] = shape["ax"]
    shape["initial_ay"] = shape["ay"]
    shape["initial_bx"] = shape["bx"]
    shape["initial_by"] = shape["by"]
    shape["initial_dx"] = shape["dx"]
    shape["initial_dy"] = shape["dy"]
    shape["initial_start_angle"] = shape["start_angle"]
    shape["initial_end_angle"] = shape["end_angle"]
    shape["initial_pivot_x"] = shape["pivot_x"]
    shape["initial_pivot_y"] = shape["pivot_y"]
    shape["hinge_x"] = shape["pivot_x"]
    shape["hinge_y"] = shape["pivot_y"]
    shape["orientation"] = 0.0
    set_before(shape)
    shape["spin"] = 0.0


def set_before(shape: ShapeRow) -> None:
    """Remember orientation and pivot as those that a substep begins with."""
    shape["orientation_before"] = shape["orientation"]
    shape["pivot_before_x"] = shape["pivot_x"]
    shape["pivot_before_y"] = shape["pivot_y"]


def pose(shape: ShapeRow) -> None:
    """Put the shape where orientation and pivot say: pivot + R(orientation)·(initial - hinge).

    Always from the initial geometry, so turns accumulate no drift. At orientation 0 the shape is its initial geometry
    moved by the way from hinge to pivot, which is that geometry bit for bit where the pivot is at the hinge. An
    orientation that has overflowed, whose sine nobody knows, makes the box infinite, by which a world sees it.
    """
    c, s = cosine_and_sine(float(shape["orientation"]))
    pose_by(shape, c, s)


def cosine_and_sine(turn: float) -> tuple[float, float]:
    """The cosine and the sine of an orientation; (1, 0) for one that has overflowed."""
    if turn - turn != 0.0:
        return 1.0, 0.0
    return cos(turn), sin(turn)


def pose_by(shape: ShapeRow, c: float, s: float) -> None:
    """The same, given what `cosine_and_sine` says of the orientation: parts of a compound turn alike."""
    turn = float(shape["orientation"])
    if turn - turn != 0.0:
        _set_box(shape, turn, turn, turn, turn)
        return
    if turn == 0.0:
        _shift(shape)
    else:
        _turn(shape, c, s)
    if shape["kind"] == ARC:
        shape["start_angle"] = normalize_angle(float(shape["initial_start_angle"]) + turn)
        shape["end_angle"] = normalize_angle(float(shape["initial_end_angle"]) + turn)
    derive(shape)


def _shift(shape: ShapeRow) -> None:
    """Move the initial geometry as far as the pivot has moved from the hinge."""
    x = float(shape["pivot_x"]) - float(shape["hinge_x"])
    y = float(shape["pivot_y"]) - float(shape["hinge_y"])
    if is_straight(shape["kind"]):
        shape["ax"] = float(shape["initial_ax"]) + x
        shape["ay"] = float(shape["initial_ay"]) + y
        shape["bx"] = float(shape["initial_bx"]) + x
        shape["by"] = float(shape["initial_by"]) + y
        shape["dx"] = shape["initial_dx"]
        shape["dy"] = shape["initial_dy"]
    elif is_round(shape["kind"]):
        shape["cx"] = float(shape["initial_cx"]) + x
        shape["cy"] = float(shape["initial_cy"]) + y


def _turn(shape: ShapeRow, c: float, s: float) -> None:
    """Turn the initial geometry by the angle of cosine c and sine s, and move it with the pivot."""
    from_x, from_y = float(shape["hinge_x"]), float(shape["hinge_y"])
    to_x, to_y = float(shape["pivot_x"]), float(shape["pivot_y"])
    if is_straight(shape["kind"]):
        x, y = rotated(float(shape["initial_ax"]) - from_x, float(shape["initial_ay"]) - from_y, c, s)
        shape["ax"] = to_x + x
        shape["ay"] = to_y + y
        x, y = rotated(float(shape["initial_bx"]) - from_x, float(shape["initial_by"]) - from_y, c, s)
        shape["bx"] = to_x + x
        shape["by"] = to_y + y
        if shape["kind"] == GATE:
            x, y = rotated(float(shape["initial_dx"]), float(shape["initial_dy"]), c, s)
            shape["dx"] = x
            shape["dy"] = y
    elif is_round(shape["kind"]):
        x, y = rotated(float(shape["initial_cx"]) - from_x, float(shape["initial_cy"]) - from_y, c, s)
        shape["cx"] = to_x + x
        shape["cy"] = to_y + y


def is_moving(shape: ShapeRow) -> bool:
    """True if the shape moves in this substep or span."""
    if shape["motion"] != KINEMATIC:
        return False
    return bool(shape["spin"] != 0.0 or shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0)


def moves_with(shape: ShapeRow, other: ShapeRow) -> bool:
    """True of two shapes that move, and as one, such as the parts of a compound."""
    if not is_moving(shape) or shape["spin"] != other["spin"]:
        return False
    if shape["velocity_x"] != other["velocity_x"] or shape["velocity_y"] != other["velocity_y"]:
        return False
    same_pivot = shape["pivot_x"] == other["pivot_x"] and shape["pivot_y"] == other["pivot_y"]
    return bool(shape["spin"] == 0.0 or same_pivot)


def is_at_rest(shape: ShapeRow) -> bool:
    """True if a substep would leave a kinematic shape as it is, bit for bit."""
    x, y = float(shape["pivot_x"]), float(shape["pivot_y"])
    turns = shape["spin"] != 0.0 or (shape["rotating"] != 0 and shape["angular_velocity"] != 0.0)
    travels = shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0 or shape["time_left"] != 0.0
    stands = shape["orientation"] == shape["orientation_before"]
    stays = x == shape["pivot_before_x"] and y == shape["pivot_before_y"]
    return bool(not turns and not travels and stands and stays)


def acting_spin(shape: ShapeRow) -> float:
    """The angular velocity that acts now, in rad/s: 0 unless kinematic and rotating, 0 when pressed against a stop."""
    if shape["motion"] != KINEMATIC or not shape["rotating"]:
        return 0.0
    spin = float(shape["angular_velocity"])
    if shape["turn_limited"]:
        orientation = float(shape["orientation"])
        if spin > 0.0 and orientation >= shape["turn_high"]:
            return 0.0
        if spin < 0.0 and orientation <= shape["turn_low"]:
            return 0.0
    return spin


def advance(shape: ShapeRow, h: float) -> int:
    """Whether the shape is STILL in one substep of h seconds, is POSED after it, or has moved and is to be posed yet.

    Stores what the substep began with (orientation_before, pivot_before) and the spin that acted in it. A stop is met
    exactly, and then angular_velocity is 0, while spin stays what it was on the way. So is the place where `move_to`
    sends it; its velocity stays what it was until `rest` takes it away. A shape that neither turns nor travels is left
    as it is, bit for bit.
    """
    set_before(shape)
    spin = acting_spin(shape)
    shape["spin"] = spin
    if shape["motion"] != KINEMATIC:
        return STILL
    left = float(shape["time_left"])
    if left > 0.0:
        if left <= h * STOP_MARGIN:
            _arrive(shape)
            return POSED
        shape["time_left"] = left - h
    if shape["rotating"]:
        _advance_orientation(shape, spin, h)
    x, y = float(shape["velocity_x"]), float(shape["velocity_y"])
    if spin == 0.0 and x == 0.0 and y == 0.0:
        return STILL
    shape["pivot_x"] = float(shape["pivot_x"]) + x * h
    shape["pivot_y"] = float(shape["pivot_y"]) + y * h
    return UNPOSED


def _advance_orientation(shape: ShapeRow, spin: float, h: float) -> None:
    """Turn by spin·h, up to a stop, where angular_velocity becomes 0."""
    if spin == 0.0:
        shape["angular_velocity"] = 0.0
        return
    orientation = float(shape["orientation"]) + spin * h
    if shape["turn_limited"]:
        low, high = float(shape["turn_low"]), float(shape["turn_high"])
        if spin > 0.0 and orientation >= high:
            orientation = high
            shape["angular_velocity"] = 0.0
        elif spin < 0.0 and orientation <= low:
            orientation = low
            shape["angular_velocity"] = 0.0
    shape["orientation"] = orientation


def turns_only(shape: ShapeRow, h: float) -> bool:
    """True if all that a shape does in a substep of h seconds is to turn, and it comes to no stop."""
    if not shape["rotating"] or shape["time_left"] != 0.0:
        return False
    spin = float(shape["angular_velocity"])
    if spin == 0.0 or shape["velocity_x"] != 0.0 or shape["velocity_y"] != 0.0:
        return False
    orientation = float(shape["orientation"]) + spin * h
    if not shape["turn_limited"]:
        return True
    return bool(shape["turn_low"] < orientation < shape["turn_high"])


def turn_unposed(shape: ShapeRow, h: float) -> None:
    """Turn a shape that only turns for a substep of h seconds; ends and box stay where they were until it is posed."""
    set_before(shape)
    shape["spin"] = shape["angular_velocity"]
    shape["orientation"] = float(shape["orientation"]) + float(shape["spin"]) * h


def reach_of(shape: ShapeRow) -> float:
    """How far from its pivot a shape reaches."""
    dx, dy = reach_along_axes(shape)
    return length(dx, dy)


def reach_along_axes(shape: ShapeRow) -> tuple[float, float]:
    """How far from its pivot the box of a shape reaches along x, and along y."""
    px, py = float(shape["pivot_x"]), float(shape["pivot_y"])
    dx = max(fabs(float(shape["left"]) - px), fabs(float(shape["right"]) - px))
    dy = max(fabs(float(shape["bottom"]) - py), fabs(float(shape["top"]) - py))
    return dx, dy


def _arrive(shape: ShapeRow) -> None:
    """Put a shape where `move_to` sent it, to the bit."""
    shape["pivot_x"] = shape["target_pivot_x"]
    shape["pivot_y"] = shape["target_pivot_y"]
    shape["orientation"] = shape["target_orientation"]
    shape["angular_velocity"] = 0.0
    shape["time_left"] = ARRIVED
    pose(shape)
    shape["cx"] = shape["target_x"]
    shape["cy"] = shape["target_y"]
    if shape["kind"] != SEGMENT and shape["kind"] != GATE:
        derive(shape)


def rest(shape: ShapeRow) -> None:
    """Let a shape rest that has come where `move_to` sent it."""
    if shape["time_left"] < 0.0:
        shape["velocity_x"] = 0.0
        shape["velocity_y"] = 0.0
        shape["time_left"] = 0.0


def surface_velocity(shape: ShapeRow, spin: float, px: float, py: float, time: float) -> tuple[float, float]:
    """The velocity (x, y) of the shape's surface at (px, py): velocity + spin·perp(p - pivot); (0, 0) if static.

    `spin` is the angular velocity to reckon with: the row's `spin` in a world, `acting_spin(shape)` outside one. So
    many seconds from now the pivot has gone on by velocity·time.
    """
    if shape["motion"] == STATIC:
        return 0.0, 0.0
    ux, uy = float(shape["velocity_x"]), float(shape["velocity_y"])
    dx = px - (float(shape["pivot_x"]) + ux * time)
    dy = py - (float(shape["pivot_y"]) + uy * time)
    return ux - spin * dy, uy + spin * dx
