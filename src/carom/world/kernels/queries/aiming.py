"""What follows from the first impact of a ball that is shot: where both go afterwards."""

from __future__ import annotations

from carom.constants import STILL_SHARE
from carom.geometry.response import exchanged, reflected
from carom.geometry.vector import dot, length, unit
from carom.rows.ball import BallRow
from carom.rows.query import AimRow, CastRow, QueryRow
from carom.rows.shape import ShapeRow
from carom.rows.tables import Rows, Table


def aim_many(
    queries: Table[QueryRow],
    casts: Table[CastRow],
    found: Table[int],
    places: Rows,
    ways: Rows,
    shapes: Table[ShapeRow],
    balls: Table[BallRow],
    total: bool,
    aims: Table[AimRow],
) -> int:
    """How many shots meet something; `aims` gets what follows from each one's cast, which `cast_many` has made.

    `places` holds the rows of the balls, `ways` the velocities with which they come; all else is at rest. `total` says
    whether walls scale the whole velocity.
    """
    hits = 0
    for k in range(len(queries)):
        query, cast, aim = queries[k], casts[k], aims[k]
        ball = balls[places[k]]
        aim["ball"] = ball["id"]
        aim["shape"] = cast["shape"]
        aim["start"][0] = query["x"]
        aim["start"][1] = query["y"]
        if cast["shape"] != 0:
            hits += 1
            write_path(query, cast, aim)
            item = int(found[k])
            if item < 0:
                leave_ball(ball, balls[-1 - item], float(ways[k, 0]), float(ways[k, 1]), aim)
            else:
                leave_shape(ball, shapes[item], float(ways[k, 0]), float(ways[k, 1]), total, aim)
    return hits


def write_path(query: QueryRow, cast: CastRow, aim: AimRow) -> None:
    """Write how far the ball gets, and where and how it touches."""
    dx, dy = float(query["to_x"]) - float(query["x"]), float(query["to_y"]) - float(query["y"])
    fraction = float(cast["fraction"])
    aim["distance"] = fraction * length(dx, dy)
    aim["ghost"][0] = float(query["x"]) + fraction * dx
    aim["ghost"][1] = float(query["y"]) + fraction * dy
    aim["point"][0] = cast["point"][0]
    aim["point"][1] = cast["point"][1]
    aim["normal"][0] = cast["normal"][0]
    aim["normal"][1] = cast["normal"][1]


def leave_shape(ball: BallRow, shape: ShapeRow, vx: float, vy: float, total: bool, aim: AimRow) -> None:
    """Write how the ball leaves a shape, which has no direction of its own afterwards."""
    nx, ny = float(aim["normal"][0]), float(aim["normal"][1])
    s = dot(vx, vy, nx, ny)
    elasticity = float(ball["elasticity"]) * float(shape["elasticity"])
    kick = float(shape["kick"])
    new_x, new_y, _ = reflected(vx, vy, 0.0, 0.0, nx, ny, elasticity, s, kick, total)
    # A speed that is rounding has no direction worth telling.
    least = STILL_SHARE * length(vx, vy)
    aim["speed"] = write_direction(aim["direction"], new_x, new_y, least)
    aim["other_speed"] = write_direction(aim["other_direction"], 0.0, 0.0, least)


def leave_ball(ball: BallRow, other: BallRow, vx: float, vy: float, aim: AimRow) -> None:
    """Write how the ball and another, which was at rest, leave each other."""
    nx, ny = float(aim["normal"][0]), float(aim["normal"][1])
    u = dot(vx, vy, nx, ny)
    elasticity = float(ball["elasticity"]) * float(other["elasticity"])
    after, other_after = exchanged(u, 0.0, float(ball["mass"]), float(other["mass"]), elasticity)
    least = STILL_SHARE * length(vx, vy)
    aim["speed"] = write_direction(aim["direction"], vx + (after - u) * nx, vy + (after - u) * ny, least)
    aim["other_speed"] = write_direction(aim["other_direction"], other_after * nx, other_after * ny, least)


def write_direction(direction: Table[float], vx: float, vy: float, least: float) -> float:
    """The speed of a velocity, and its direction to write; both 0 where it is `least` at most, which is rounding."""
    speed = length(vx, vy)
    direction[0] = 0.0
    direction[1] = 0.0
    if speed <= least:
        return 0.0
    along = unit(vx, vy)
    if along is not None:
        ux, uy = along
        direction[0] = ux + 0.0  # no negative zeros
        direction[1] = uy + 0.0
    return speed
