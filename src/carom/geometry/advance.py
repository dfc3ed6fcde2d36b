"""When a moving ball first touches a shape that moves and turns about a pivot: `advance_<kind>` for each kind.

The shape comes first, as it is at time 0, then its motion, then the path of the ball's centre, its `radius`, and the
`duration` to look ahead, within which none of these change. Each returns what `impact` returns: the first time from
which on a ball that touches goes on approaching, as seen from the shape, or None. A shape that does not turn is met in
closed form, as one at rest by a ball with the velocity relative to it, and `duration` only leaves out what is later.
What turns is met by the search of `turning`, which says how exact it is and how it ends. It steps by bounds of what the
ball does within the `duration`, which must be finite, so the last bits of its times depend on that; one who wants them
not to cuts time by a rule of its own. A search may go on from any time: the path and the shape then are as they are at
that time, and times are counted from there. Times that may be missing are made plain numbers by `0.0 + time`, for the
compiler.
"""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import END_DEPTH_CONTINUOUS, TURN_CROSSINGS, TURN_DEPTH
from carom.geometry.figures import ArcGeometry, CentredArc, CircleGeometry, SegmentGeometry, centred_arc
from carom.geometry.impact import impact_arc, impact_circle, impact_point, impact_segment
from carom.geometry.path import Path, Turning, path_beside, path_from
from carom.geometry.reach import in_arc, touches_arc
from carom.geometry.turning import INNER, LINE, OUTER, Edge, SeenPath, next_fall, seen_gap, seen_place, seen_start
from carom.geometry.vector import dot, smaller


def advance_point(qx: float, qy: float, turning: Turning, path: Path, radius: float, duration: float) -> float | None:
    """When the ball first touches the point q, or None."""
    path = path_beside(path, turning)
    kx, ky = qx - turning.pivot_x, qy - turning.pivot_y
    # A point that is the pivot does not turn.
    if turning.spin == 0.0 or (kx == 0.0 and ky == 0.0):
        return impact_point(qx, qy, path, radius, duration)
    return next_fall(0.0, True, TURN_DEPTH * radius, Edge(OUTER, kx, ky, radius), seen_path(path, turning), duration)


def seen_path(path: Path, turning: Turning) -> SeenPath:
    """The path, relative to the pivot's velocity, as the search for a touch with what turns about it takes it."""
    return SeenPath(path_from(path, turning.pivot_x, turning.pivot_y), turning.spin)


def advance_segment(
    segment: SegmentGeometry, turning: Turning, path: Path, radius: float, duration: float, slop: float
) -> float | None:
    """When the ball first touches the segment, on either side, or None."""
    path = path_beside(path, turning)
    if turning.spin == 0.0:
        return impact_segment(segment, path, radius, duration, slop)
    ax, ay, tx, ty, extent = segment
    ax, ay = ax - turning.pivot_x, ay - turning.pivot_y
    seen = seen_path(path, turning)
    px, py, wx, wy = seen_start(seen)
    nx, ny = -ty, tx
    # As in `impact_segment`: the normal points to the side that the ball is on or comes from.
    side, rate = nx * (px - ax) + ny * (py - ay), nx * wx + ny * wy
    if side < 0.0 or (side == 0.0 and rate > 0.0):
        nx, ny, side = ty, -tx, -side
    # A ball that overlaps by more than the end depth, and is not beside the segment, is about to pass its line.
    held = side - radius >= -END_DEPTH_CONTINUOUS * radius
    if not held:
        held = -slop <= dot(tx, ty, px, py) - dot(tx, ty, ax, ay) <= extent + slop
    level = dot(nx, ny, ax, ay)
    seen_segment = SegmentGeometry(ax, ay, tx, ty, extent)
    near = advance_on_side(held, Edge(LINE, nx, ny, level + radius), seen_segment, radius, slop, seen, duration)
    # It may get to the other side past an end, and then it has to come back to be touched from there.
    far = advance_on_side(False, Edge(LINE, -nx, -ny, radius - level), seen_segment, radius, slop, seen, duration)
    return sooner(near, far)


def advance_on_side(
    held: bool, edge: Edge, segment: SegmentGeometry, radius: float, slop: float, seen: SeenPath, duration: float
) -> float | None:
    """When the ball touches a segment on the side of its normal n, or None; all is seen from the pivot.

    The ball touches its line at n·q = level, and is beside it where 0 <= t·(q - a) <= extent.
    """
    ax, ay, tx, ty, extent = segment
    start, depth = dot(tx, ty, ax, ay), TURN_DEPTH * radius
    # Where the ball comes in past an end, its distance from that end's line, `slop` outside, falls through zero.
    before, after = Edge(LINE, -tx, -ty, slop - start), Edge(LINE, tx, ty, start + extent + slop)
    touch = next_fall(0.0, held, depth, edge, seen, duration)
    # Each round is a touch of the line, which most often is one of the segment too.
    for _ in range(TURN_CROSSINGS):
        if touch is None:
            return None
        time = 0.0 + touch
        qx, qy, _, _ = seen_place(time, seen)
        foot = tx * qx + ty * qy - start
        if foot < -slop:
            entry = next_fall(time, True, depth, before, seen, duration)
        elif foot > extent + slop:
            entry = next_fall(time, True, depth, after, seen, duration)
        else:
            return time
        if entry is not None:
            later = 0.0 + entry
            gap, rate = seen_gap(later, edge, seen)
            if fabs(gap) <= END_DEPTH_CONTINUOUS * radius and rate < 0.0:
                return later
        # It passes the line there; the next touch is when it has been clear of it.
        touch = next_fall(time, False, depth, edge, seen, duration)
    return touch


def advance_circle(
    circle: CircleGeometry, turning: Turning, path: Path, radius: float, duration: float
) -> float | None:
    """When the ball first touches the circle, from outside or, unless it is solid, from inside; or None."""
    path = path_beside(path, turning)
    cx, cy, r, solid = circle
    kx, ky = cx - turning.pivot_x, cy - turning.pivot_y
    if turning.spin == 0.0 or (kx == 0.0 and ky == 0.0):
        return impact_circle(circle, path, radius, duration)
    seen, depth = seen_path(path, turning), TURN_DEPTH * radius
    px, py, wx, wy = seen_start(seen)
    dx, dy = px - kx, py - ky
    away, outward = dx * dx + dy * dy - r * r, dx * wx + dy * wy
    if solid or away > 0.0 or (away == 0.0 and outward < 0.0):
        return next_fall(0.0, True, depth, Edge(OUTER, kx, ky, r + radius), seen, duration)
    if r > radius:
        return next_fall(0.0, True, depth, Edge(INNER, kx, ky, r - radius), seen, duration)
    # A ball that fills the circle touches wherever it is, and goes on into it unless it comes to the middle.
    if outward > 0.0:
        return 0.0
    return None


def advance_arc(
    arc: ArcGeometry, turning: Turning, path: Path, radius: float, duration: float, slop: float
) -> float | None:
    """When the ball first touches the arc, from outside or inside, or None."""
    path = path_beside(path, turning)
    if turning.spin == 0.0:
        return impact_arc(arc, path, radius, duration, slop)
    r, centred, seen = arc.r, centred_arc(arc, slop), seen_path(path, turning)
    kx, ky = arc.cx - turning.pivot_x, arc.cy - turning.pivot_y
    px, py, wx, wy = seen_start(seen)
    dx, dy = px - kx, py - ky
    away, outward = sqrt(dx * dx + dy * dy), dx * wx + dy * wy
    outside = away > r or (away == r and outward < 0.0)
    # Only the side that it is on holds a ball that overlaps; on the other it has to come from clear.
    held = touches_arc(dx, dy, radius, centred)
    outer = Edge(OUTER, kx, ky, r + radius)
    from_outside = advance_on_perimeter(held and outside, outer, centred, radius, seen, duration)
    if r > radius:
        inner = Edge(INNER, kx, ky, r - radius)
        from_inside = advance_on_perimeter(held and not outside, inner, centred, radius, seen, duration)
        return sooner(from_outside, from_inside)
    # As in a circle that the ball fills.
    if held and not outside and outward > 0.0:
        return 0.0
    return from_outside


def advance_on_perimeter(
    held: bool, edge: Edge, arc: CentredArc, radius: float, seen: SeenPath, duration: float
) -> float | None:
    """When the ball touches the arc from outside or inside, as `edge` says, or None."""
    depth = TURN_DEPTH * radius
    touch = next_fall(0.0, held, depth, edge, seen, duration)
    for _ in range(TURN_CROSSINGS):
        if touch is None:
            return None
        time = 0.0 + touch
        qx, qy, _, _ = seen_place(time, seen)
        if in_arc(arc, qx - edge.kx, qy - edge.ky, 1.0):
            return time
        after = sector_entry(time, edge, arc, radius, seen, duration)
        if after is not None:
            return after
        # It passes the circle there, as a ball does past a segment's end.
        touch = next_fall(time, False, depth, edge, seen, duration)
    return touch


def sector_entry(
    time: float, edge: Edge, arc: CentredArc, radius: float, seen: SeenPath, duration: float
) -> float | None:
    """When a ball that touches an arc's circle at `time` outside of the sector comes into it all but touching, or None.

    The rays' lines, `slop` outside of the sector, are crossed where the distance from a line falls through zero.
    """
    _, kx, ky, _ = edge
    r, ax, ay, bx, by, slop = arc
    depth = TURN_DEPTH * radius
    # The unit normals point out of the sector: clockwise from its start, counterclockwise from its end.
    nx, ny = ay / r, -ax / r
    first = next_fall(time, True, depth, Edge(LINE, nx, ny, dot(nx, ny, kx, ky) + slop), seen, duration)
    nx, ny = -by / r, bx / r
    second = next_fall(time, True, depth, Edge(LINE, nx, ny, dot(nx, ny, kx, ky) + slop), seen, duration)
    for entry in (first, second):
        if entry is not None:
            later = 0.0 + entry
            gap, rate = seen_gap(later, edge, seen)
            qx, qy, _, _ = seen_place(later, seen)
            # It is on a line of the sector, so rounding would decide unless the sector is wider here. The line goes on
            # past the centre, where it is not in the sector at all.
            inside = in_arc(arc, qx - kx, qy - ky, 2.0)
            if inside and fabs(gap) <= END_DEPTH_CONTINUOUS * radius and rate < 0.0:
                return later
    return None


def sooner(first: float | None, second: float | None) -> float | None:
    """The earlier of two times, of which either may be missing; None if both are."""
    if first is None:
        return second
    if second is None:
        return first
    return smaller(0.0 + first, 0.0 + second)
