"""The outline of a table: loops of segments and arcs that join, each counterclockwise, or circles.

Areas and lengths are those of the segments and arcs themselves. A place is within a loop if it is within the polygon of
its ends or within the part of a disc between an arc and its chord, but not within two of these: what the loop encloses
is their sum modulo 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.checks import refuse
from carom.constants import JOINT_GAP
from carom.errors import InvalidArgument
from carom.rows.kinds import has_ends, is_straight
from carom.scene.scene import Scene
from carom.typing import Vector
from carom.world.boundary import Wall, ends_of, measures_of

Floats: TypeAlias = NDArray[np.float64]

#: Looks along each piece of an outline when it is seen whether two loops cross.
LOOKS = 32


class Piece(NamedTuple):
    """A wall of an outline: its place among the scene's shapes, and whether the loop goes along it forwards."""

    place: int
    wall: Wall
    forward: bool

    @property
    def ends(self) -> tuple[Vector, Vector]:
        """Where the loop comes to it and where it leaves it; of a circle, twice the place at angle 0."""
        first, second = ends_of(self.wall)
        return (first, second) if self.forward else (second, first)

    @property
    def area(self) -> float:
        """Its part of the loop's area by Green's theorem, half the integral of x dy - y dx along it."""
        wall = self.wall
        (ax, ay), (bx, by) = ends_of(wall)
        if is_straight(wall._row["kind"]):
            twice = ax * by - bx * ay
        else:
            x, y, radius, _first = measures_of(wall)
            twice = x * (by - ay) - y * (bx - ax) + radius * wall.length
        return 0.5 * twice if self.forward else -0.5 * twice

    def at(self, along: Floats) -> tuple[Floats, Floats]:
        """The places so far along it on the loop's way, and the loop's unit tangents there, each of shape (n, 2)."""
        wall = self.wall
        way = 1.0 if self.forward else -1.0
        from_first = along if self.forward else wall.length - along
        x, y, *rest = measures_of(wall)
        if is_straight(wall._row["kind"]):
            tangent = np.array(rest)
            return np.array((x, y)) + from_first[:, None] * tangent, np.tile(way * tangent, (len(along), 1))
        radius, first = rest
        angle = first + from_first / radius
        out = np.column_stack((np.cos(angle), np.sin(angle)))
        return np.array((x, y)) + radius * out, way * np.column_stack((-out[:, 1], out[:, 0]))


class Loop(NamedTuple):
    """Walls that join to a closed curve, in order; counterclockwise."""

    pieces: tuple[Piece, ...]

    @property
    def area(self) -> float:
        """What it encloses."""
        return sum(piece.area for piece in self.pieces)

    @property
    def length(self) -> float:
        """Its own."""
        return sum(piece.wall.length for piece in self.pieces)

    def contains(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Which places it encloses."""
        inside = np.zeros(np.shape(x), np.bool_)
        for piece in self.pieces:
            wall, ((ax, ay), (bx, by)) = piece.wall, piece.ends
            if ay != by:
                inside ^= ((ay > y) != (by > y)) & (x < ax + (bx - ax) / (by - ay) * (y - ay))
            if is_straight(wall._row["kind"]):
                continue
            cx, cy, radius, _first = measures_of(wall)
            disc = (x - cx) * (x - cx) + (y - cy) * (y - cy) < radius * radius
            if has_ends(wall._row["kind"]):
                (px, py), (qx, qy) = ends_of(wall)
                disc &= (qx - px) * (y - py) - (qy - py) * (x - px) < 0.0
            inside ^= disc
        return inside

    def looks(self) -> tuple[Floats, Floats]:
        """Places on it, x and y: some along each piece, with both ends."""
        found = [piece.at(np.linspace(0.0, piece.wall.length, LOOKS))[0] for piece in self.pieces]
        x, y = np.concatenate(found).T
        return x, y


def unfit(scene: Scene, must: str) -> InvalidArgument:
    """The error to raise for a scene that is no table, which says what it must do, and its name if it has one."""
    return InvalidArgument(f"scene {must}") if scene.name is None else refuse("scene", must, scene.name)


def loops_of(scene: Scene, walls: Sequence[tuple[int, Wall]]) -> tuple[Loop, ...]:
    """The loops that the walls of a table make, the outer one first; raises where they make no table."""
    circles = [Loop((Piece(place, wall, True),)) for place, wall in walls if not has_ends(wall._row["kind"])]
    bare = [(place, wall) for place, wall in walls if has_ends(wall._row["kind"])]
    loops = sorted([*circles, *_joined(scene, bare)], key=lambda loop: -loop.area)
    if not loops:
        raise unfit(scene, "must have walls that close a table")
    first = loops[0].pieces[0].wall
    if first._row["solid"]:
        raise unfit(scene, f"must be a closed table; {named(scene, loops[0].pieces[0].place)} is solid")
    for number, island in enumerate(loops[1:], 1):
        x, y = island.looks()
        apart = loops[0].contains(x, y).all() and not any(
            other.contains(x, y).any() or island.contains(*other.looks()).any()
            for other in loops[1:]
            if other is not island
        )
        if not apart or island.contains(*loops[0].looks()).any():
            what = named(scene, loops[number].pieces[0].place)
            raise unfit(scene, f"must be a table with islands apart; {what} crosses another wall")
    return tuple(loops)


def _joined(scene: Scene, walls: Sequence[tuple[int, Wall]]) -> list[Loop]:
    """The loops of segments and arcs, every end of which must meet one other."""
    partner = _partners(scene, walls)
    loops: list[Loop] = []
    left = dict.fromkeys(range(len(walls)))
    while left:
        end = 2 * next(iter(left))
        chain: list[Piece] = []
        while end // 2 in left:
            number = end // 2
            del left[number]
            place, wall = walls[number]
            chain.append(Piece(place, wall, end % 2 == 0))
            end = partner[end ^ 1]
        loops.append(_turned(chain))
    return loops


def _turned(chain: list[Piece]) -> Loop:
    """A closed chain as a loop: counterclockwise, and of two pieces the one first that is gone along forwards.

    `Hits.boundary` cannot tell from two pieces which way their outline goes, and takes the first forwards.
    """
    if sum(piece.area for piece in chain) < 0.0:
        chain = [piece._replace(forward=not piece.forward) for piece in reversed(chain)]
    if len(chain) == 2 and not chain[0].forward:
        chain.reverse()
    return Loop(tuple(chain))


def _partners(scene: Scene, walls: Sequence[tuple[int, Wall]]) -> list[int]:
    """For each end of the walls, two of each, the number of the end that it joins; raises unless that is one."""
    ends = [end for _, wall in walls for end in ends_of(wall)]
    gap = JOINT_GAP * sum(wall.length for _, wall in walls)
    order = sorted(range(len(ends)), key=lambda number: ends[number])
    found: list[list[int]] = [[] for _ in ends]
    for rank, number in enumerate(order):
        x, y = ends[number]
        for other in order[rank + 1 :]:
            if ends[other][0] - x > gap:
                break
            if hypot(ends[other][0] - x, ends[other][1] - y) <= gap:
                found[number].append(other)
                found[other].append(number)
    for number, others in enumerate(found):
        if len(others) != 1:
            wall = named(scene, walls[number // 2][0])
            joins = "no other wall" if not others else f"{len(others)} other walls"
            raise unfit(scene, f"must be a closed table; {wall} ends at {ends[number]}, at {joins}")
    return [others[0] for others in found]


def named(scene: Scene, place: int) -> str:
    """How a shape of a scene is called in a message: by its place in it, and its name."""
    name = scene.shapes[place].name
    return f"shapes[{place}]{f' ({name!r})' if name else ''}"
