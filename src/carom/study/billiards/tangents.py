"""Tangent maps: what a small change of a ball's place and velocity becomes through flights and impacts.

A change is (δr, δv). In a flight of length τ, under gravity too, δr grows by τ·δv. At an elastic impact a ball that is
beside another meets the wall δτ later, and elsewhere, where the normal n is another. With s = n·v, the tangent t,
gravity g and the curvature K of what the ball's centre meets, positive where it scatters:

    δτ = a·δr, a = -n/s        δn = t (c·δr), c = K (t + (t·v) a)
    δr' = δr - 2 n (n·δr)      δv' = δv - 2 n (n·δv) - 2 (n d + s t c)·δr, d = (n·g) a + (t·v) c

Source: Ch. Dellago, H. A. Posch and W. G. Hoover, Lyapunov instability in a system of hard disks in equilibrium and
nonequilibrium steady states, 1996, for walls in place of a second disc; N. Chernov and R. Markarian, Chaotic billiards,
2006, section 3.4. Arrays are of shape (4, 4, ...), so that many maps are multiplied by few operations on all of them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from carom.checks import refuse
from carom.rows.tables import Rows
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.point import Point
from carom.study.billiards.ensembles import Numbers
from carom.study.billiards.outline import Floats
from carom.study.billiards.tables import BALL_LAYER, OTHER_LAYERS

if TYPE_CHECKING:
    from carom.world import World


class Walls(NamedTuple):
    """What balls of one radius meet in a world, as columns, in the order of ids.

    `outside` is the curvature of what their centres meet on the outer side of a curve, `inside` that on the other.
    """

    ids: Numbers
    center: Floats
    outside: Floats
    inside: Floats
    gravity: Floats


def walls_of(world: World) -> Walls:
    """The walls of an ensemble's world; raises `InvalidArgument` for one that is not elastic."""
    radius = float(world.balls.radius[0])
    met = [
        shape
        for shape in world.shapes
        if shape.can_collide and not shape.sensor and shape.layer & OTHER_LAYERS and shape.collides_with & BALL_LAYER
    ]
    met.sort(key=lambda shape: shape.id or 0)
    columns = []
    for shape in met:
        if shape.elasticity != 1.0 or shape.kick != 0.0:
            raise refuse("scene", "must have walls of elasticity 1 without a kick", shape)
        if isinstance(shape, (Arc, Circle)):
            hollow = -1.0 / (shape.radius - radius) if shape.radius > radius else 0.0
            columns.append((*shape.center, 1.0 / (shape.radius + radius), hollow))
        else:
            bend = 1.0 / radius if isinstance(shape, Point) else 0.0
            columns.append((0.0, 0.0, bend, bend))
    x, y, outside, inside = np.array(columns).T
    ids = np.array([shape.id for shape in met], np.int64)
    return Walls(ids, np.stack((x, y)), outside, inside, np.array(world.gravity))


def impact_maps(walls: Walls, hits: Rows, flights: Floats) -> Floats:
    """The tangent maps of impacts, each with the flight of a given time before it: of shape (4, 4, number of hits)."""
    place = np.searchsorted(walls.ids, hits["shape"])
    normal, v, point = (np.ascontiguousarray(hits[name].T) for name in ("normal", "velocity", "point"))
    tangent = np.stack((-normal[1], normal[0]))
    s = normal[0] * v[0] + normal[1] * v[1]
    along = tangent[0] * v[0] + tangent[1] * v[1]
    out = point - walls.center[:, place]
    outside = out[0] * normal[0] + out[1] * normal[1] >= 0.0
    curvature = np.where(outside, walls.outside[place], walls.inside[place])
    a = -normal / s
    c = curvature * (tangent + along * a)
    d = (normal[0] * walls.gravity[0] + normal[1] * walls.gravity[1]) * a + along * c
    maps = np.empty((4, 4, len(hits)))
    for i in range(2):
        for j in range(2):
            mirror = (1.0 if i == j else 0.0) - 2.0 * normal[i] * normal[j]
            bent = -2.0 * (normal[i] * d[j] + s * tangent[i] * c[j])
            maps[i, j], maps[i, 2 + j] = mirror, flights * mirror
            maps[2 + i, j], maps[2 + i, 2 + j] = bent, flights * bent + mirror
    return maps


def products(maps: Floats, counts: Numbers) -> tuple[Floats, Floats]:
    """The products of the maps of each orbit, later ones on the left, and the logarithms of what they are scaled by.

    `maps` has the shape (4, 4, hits), orbit after orbit; `counts` says how many each has. The products are of shape
    (4, 4, orbits) and have a greatest entry of about 1; that of none is the identity. They are made in pairs, then in
    pairs of pairs, so that all orbits together need as many operations as the longest has halvings.
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
    all_maps, all_logs = np.zeros((4, 4, len(counts))), np.zeros(len(counts))
    all_maps[range(4), range(4)] = 1.0
    all_maps[:, :, there], all_logs[there] = maps, logs
    return all_maps, all_logs


def times(later: Floats, earlier: Floats) -> Floats:
    """The products of matrices of shape (4, 4, n) with matrices of shape (4, columns, n)."""
    made = np.empty((4, earlier.shape[1], later.shape[2]))
    part = np.empty(later.shape[2])
    for i in range(4):
        for k in range(earlier.shape[1]):
            np.multiply(later[i, 0], earlier[0, k], out=made[i, k])
            for j in range(1, 4):
                np.multiply(later[i, j], earlier[j, k], out=part)
                made[i, k] += part
    return made


def scaled(maps: Floats) -> tuple[Floats, Floats]:
    """Maps with a greatest entry of 1, and the logarithms of what they were divided by."""
    greatest = np.abs(maps).max(axis=(0, 1))
    maps /= greatest
    return maps, np.log(greatest)
