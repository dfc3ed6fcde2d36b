"""Tangent maps: what a small change of a ball's place and velocity becomes through flights and impacts.

A change is (δr, δv). In a flight of length τ, under gravity too, δr grows by τ·δv. At an elastic impact a ball that is
beside another meets the wall δτ later, and elsewhere, where the normal n is another. With gravity g, the tangent t, the
curvature K of what the ball's centre meets, positive where it scatters, the wall's travel u, its turn ω about a pivot
and its velocity W = u + ω t' r' at the ball's centre, r' from the pivot, t' a quarter turn, and s = n·(v - W):

    δτ = a·δr, a = -n/s        δn = t (c·δr), c = K (t + (t·(v - W)) a) + ω a
    δr' = δr - 2 n (n·δr)      δv' = δv - 2 n (n·δv) - 2 (n d + s t c)·δr,
                               d = (n·g) a + (t·(v - W)) c + ω (t + (t·(v - u)) a)

Of two balls, r and v are those of one as the other has them, whose curvature is that of a circle of both radii. Source:
Ch. Dellago, H. A. Posch and W. G. Hoover, Lyapunov instability in a system of hard disks in equilibrium and
nonequilibrium steady states, 1996; N. Chernov and R. Markarian, Chaotic billiards, 2006, section 3.4; walls that move
are derived here likewise. Arrays are of shape (4, 4, ...), so that many maps are multiplied by few operations on all
of them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from carom.checks import refuse
from carom.record.members import parts
from carom.rows.kinds import is_round, is_straight
from carom.rows.shape import Motion
from carom.rows.tables import Rows
from carom.shapes.shape import Shape
from carom.study.billiards.ensembles import Numbers
from carom.study.billiards.outline import Floats

if TYPE_CHECKING:
    from carom.world import World


#: Matrices that are multiplied one by one, as more operations on all of them at once would take longer.
FEW = 256


class Walls(NamedTuple):
    """What balls meet in a world, as columns, in the order of ids, as it stood at the time `since`.

    `radius` is 0 for a point and infinite for a segment. A wall travels, and turns about a pivot that travels with it.
    """

    ids: Numbers
    radius: Floats
    center: Floats
    pivot: Floats
    travel: Floats
    turn: Floats
    since: float
    gravity: Floats

    @property
    def move(self) -> bool:
        """Whether one does."""
        return bool(self.travel.any() or self.turn.any())


def walls_of(world: World, name: str) -> Walls:
    """The walls of a world; raises `InvalidArgument`, of the argument `name`, for one that is not elastic."""
    layers, met = (int(np.bitwise_or.reduce(masks)) for masks in (world.balls.layer, world.balls.collides_with))
    walls = sorted(parts(world.shapes), key=lambda wall: wall.id or 0)
    rows = [
        _row_of(wall, name)
        for wall in walls
        if wall.can_collide and not wall.sensor and wall.layer & met and wall.collides_with & layers
    ]
    table = np.array(rows).reshape(-1, 9).T
    ids = table[0].astype(np.int64)
    return Walls(ids, table[1], table[2:4], table[4:6], table[6:8], table[8], world.time, np.array(world.gravity))


def _row_of(wall: Shape, name: str) -> tuple[float, ...]:
    """The numbers of a wall: its id, radius, centre, pivot, travel and turn; raises as `walls_of` does."""
    row = wall._row
    if not (is_straight(row["kind"]) or is_round(row["kind"])):
        raise refuse(name, "must have walls that are points, segments, arcs and circles", wall)
    if wall.elasticity != 1.0 or wall.kick != 0.0 or wall.once:
        raise refuse(name, "must have walls of elasticity 1 that stay and do not kick", wall)
    radius = np.inf if is_straight(row["kind"]) else float(row["radius"])
    stands = (float(wall.id or 0), radius, *wall.position, *wall.pivot)
    if wall.motion != Motion.KINEMATIC:
        return (*stands, 0.0, 0.0, 0.0)
    turn = wall.angular_velocity if wall.rotating else 0.0
    if turn != 0.0 and wall.turn_limits is not None:
        raise refuse(name, "must have no wall that stops turning", wall)
    return (*stands, *wall.velocity, turn)


def impact_maps(walls: Walls, hits: Rows, flights: Floats | float, ball: Floats | float) -> Floats:
    """The tangent maps of impacts on walls, each with the flight of a given time before it: of shape (4, 4, hits).

    `ball` is the radius of the balls that hit.
    """
    place = np.searchsorted(walls.ids, hits["shape"])
    normal, velocity, point = (np.ascontiguousarray(hits[name].T) for name in ("normal", "velocity", "point"))
    pull = normal[0] * walls.gravity[0] + normal[1] * walls.gravity[1]
    if not walls.move:
        curvature = _curvature(walls.radius[place], point - walls.center[:, place], normal, ball)
        return bounce_maps(normal, velocity, curvature, pull, flights)
    turn, travel, passed = walls.turn[place], walls.travel[:, place], hits["time"] - walls.since
    pivot = walls.pivot[:, place] + travel * passed
    cos, sin = np.cos(turn * passed), np.sin(turn * passed)
    x, y = (walls.center - walls.pivot)[:, place]
    center = pivot + np.stack((cos * x - sin * y, sin * x + cos * y))
    away = np.ascontiguousarray(hits["position"].T) - pivot
    frame = travel + turn * np.stack((-away[1], away[0]))
    curvature = _curvature(walls.radius[place], point - center, normal, ball)
    return bounce_maps(normal, velocity - frame, curvature, pull, flights, turn, velocity - travel)


def _curvature(radius: Floats, out: Floats, normal: Floats, ball: Floats | float) -> Floats:
    """The curvature of what balls' centres meet at a place `out` from a wall's centre, positive where it scatters."""
    outside = out[0] * normal[0] + out[1] * normal[1] >= 0.0
    bent: Floats = 1.0 / np.where(outside, radius + ball, ball - radius)
    return bent


def bounce_maps(
    normal: Floats,
    velocity: Floats,
    curvature: Floats,
    pull: Floats | float = 0.0,
    flights: Floats | float = 0.0,
    turn: Floats | float = 0.0,
    past: Floats | None = None,
) -> Floats:
    """The tangent maps of elastic impacts, each with a flight before it: of shape (4, 4, impacts).

    In the letters of the module: `normal` n, `velocity` v - W, `curvature` K, `pull` n·g, `flights` τ, `turn` ω and
    `past` v - u; what turns not needs no `past`.
    """
    tangent = np.stack((-normal[1], normal[0]))
    s = normal[0] * velocity[0] + normal[1] * velocity[1]
    along = tangent[0] * velocity[0] + tangent[1] * velocity[1]
    a = -normal / s
    c = curvature * (tangent + along * a)
    if past is not None:
        c += turn * a
    d = pull * a + along * c
    if past is not None:
        d += turn * (tangent + (tangent[0] * past[0] + tangent[1] * past[1]) * a)
    maps = np.empty((4, 4, normal.shape[1]))
    for i in range(2):
        for j in range(2):
            mirror = (1.0 if i == j else 0.0) - 2.0 * normal[i] * normal[j]
            bent = -2.0 * (normal[i] * d[j] + s * tangent[i] * c[j])
            maps[i, j], maps[i, 2 + j] = mirror, flights * mirror
            maps[2 + i, j], maps[2 + i, 2 + j] = bent, flights * bent + mirror
    return maps


def products(maps: Floats, counts: Numbers) -> tuple[Floats, Floats]:
    """The products of the maps of each orbit, later ones on the left, and the logarithms of what they are scaled by.

    `maps` has the shape (size, size, hits), orbit after orbit; `counts` says how many each has. The products are of
    shape (size, size, orbits) and have a greatest entry of about 1; that of none is the identity. They are made in
    pairs, then in pairs of pairs, so that all orbits need as many operations as the longest has halvings.
    """
    there = np.flatnonzero(counts)
    left = counts[there]
    logs = np.zeros(maps.shape[2])
    while len(left) < maps.shape[2]:
        begins = np.cumsum(left) - left
        rank = np.arange(maps.shape[2]) - np.repeat(begins, left)
        first = np.flatnonzero(rank % 2 == 0)
        paired = np.flatnonzero(rank[first] + 1 < np.repeat(left, (left + 1) // 2))
        earlier = first[paired]
        made, scale = scaled(times(maps[:, :, earlier + 1], maps[:, :, earlier]))
        sums = logs[first]
        sums[paired] += logs[earlier + 1] + scale
        maps = maps[:, :, first]
        maps[:, :, paired] = made
        left, logs = (left + 1) // 2, sums
    size = maps.shape[0]
    all_maps, all_logs = np.zeros((size, size, len(counts))), np.zeros(len(counts))
    all_maps[range(size), range(size)] = 1.0
    all_maps[:, :, there], all_logs[there] = maps, logs
    return all_maps, all_logs


def times(later: Floats, earlier: Floats) -> Floats:
    """The products of matrices of shape (size, size, n) with matrices of shape (size, columns, n)."""
    size, columns = later.shape[0], earlier.shape[1]
    if later.shape[2] <= FEW:
        few: Floats = np.matmul(later.transpose(2, 0, 1), earlier.transpose(2, 0, 1)).transpose(1, 2, 0)
        return few
    made = np.empty((size, columns, later.shape[2]))
    part = np.empty(later.shape[2])
    for i in range(size):
        for k in range(columns):
            np.multiply(later[i, 0], earlier[0, k], out=made[i, k])
            for j in range(1, size):
                np.multiply(later[i, j], earlier[j, k], out=part)
                made[i, k] += part
    return made


def scaled(maps: Floats) -> tuple[Floats, Floats]:
    """Maps with a greatest entry of 1, and the logarithms of what they were divided by."""
    greatest = np.abs(maps).max(axis=(0, 1))
    maps /= greatest
    return maps, np.log(greatest)
