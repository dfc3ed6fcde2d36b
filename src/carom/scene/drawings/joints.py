"""Where outlines meet: ends that are nearly in one place are brought together, joints that are nearly smooth made so.

Programs write coordinates with few digits. So two pieces that were drawn end to end may be a little apart, and a curve
that was drawn smooth may be bent a little where its pieces meet; a ball would feel both. All is decided by the order of
the drawing, and moves nothing by more than the tolerance.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import chain
from math import atan2, cos, floor, hypot, inf, pi, sin, tan

import numpy as np

from carom.scene.drawings.ellipses import bulged
from carom.scene.drawings.pieces import Conic, Course, Cubic, Piece, Straight, Vector

#: The share of its length by which an end of a piece may be moved: short pieces stay what they are.
OF_LENGTH = 0.25
#: Radians by which a joint may be bent and be meant to be smooth: what three digits leave of a handle ten units long.
SMOOTH = 0.01
#: The share of the tolerance by which a handle may be turned aside for that; the rest is for the fit.
OF_HANDLE = 0.25

#: The share of the drawing's size below which a tolerance joins nothing, for it is no more than rounding.
TOO_FINE = 1e-12
#: What tells columns of cells apart.
PRIME = 2_654_435_761

Outline = list[Piece]


def joined(outlines: list[Outline], tolerance: float) -> list[Outline]:
    """`outlines` with ends nearer than `tolerance` to each other brought together."""
    limits: dict[Vector, float] = {}
    firm: set[Vector] = set()
    for piece in (piece for outline in outlines for piece in outline):
        if isinstance(piece, Conic) and piece.whole:
            continue
        start, end = piece.start, piece.end
        limit = min(tolerance, OF_LENGTH * hypot(end[0] - start[0], end[1] - start[1]))
        for place in (start, end):
            limits[place] = min(limit, limits.get(place, limit))
            if not isinstance(piece, Straight):
                firm.add(place)
    moves = _moves(limits, firm, tolerance)
    if not moves:
        return outlines
    return [[_with_ends(piece, moves) for piece in outline] for outline in outlines]


def _moves(limits: dict[Vector, float], firm: set[Vector], tolerance: float) -> dict[Vector, Vector]:
    """Where each place goes that goes anywhere: to the first one that it is near to, to an end of a curve if it can."""
    moves: dict[Vector, Vector] = {}
    places = sorted(_crowded(list(limits), tolerance), key=lambda place: place not in firm)  # else in their order
    cells: dict[tuple[int, int], list[Vector]] = {}
    for x, y in places:
        # Cells are twice as wide as the tolerance, so what is near is in this one or the next on the nearer side.
        across, along = x / (2.0 * tolerance), y / (2.0 * tolerance)
        column, line = floor(across), floor(along)
        limit, nearest, least = limits[x, y], None, inf
        for i in (column, column + (1 if across - column > 0.5 else -1)):
            for j in (line, line + (1 if along - line > 0.5 else -1)):
                for other in cells.get((i, j), ()):
                    gap = hypot(other[0] - x, other[1] - y)
                    if gap <= limit and gap <= limits[other] and gap < least:
                        nearest, least = other, gap
        if nearest is None:
            cells.setdefault((column, line), []).append((x, y))
        else:
            moves[x, y] = nearest
    return moves


def _crowded(places: list[Vector], tolerance: float) -> list[Vector]:
    """The places that may have another one within `tolerance`, in their order.

    Two such places share a cell of twice that width in at least one of four grids that are half a cell apart.
    """
    if len(places) < 2:
        return []
    points = np.fromiter(chain.from_iterable(places), np.float64, 2 * len(places)).reshape(-1, 2)
    points -= points.min(axis=0)
    if not tolerance > TOO_FINE * points.max():
        return []
    crowded = np.zeros(len(points), np.bool_)
    for shift in ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)):
        cells = np.floor(points / (2.0 * tolerance) + np.array(shift)).astype(np.int64)
        # Cells that share a number are looked at in vain, no more.
        _, inverse, counts = np.unique(cells[:, 0] * PRIME + cells[:, 1], return_inverse=True, return_counts=True)
        crowded |= counts[inverse] > 1
    return [places[k] for k in np.flatnonzero(crowded).tolist()]


def _with_ends(piece: Piece, moves: dict[Vector, Vector]) -> Piece:
    """A piece whose ends have moved; ellipses and free curves stay."""
    if isinstance(piece, Course) or (isinstance(piece, Conic) and (piece.whole or not piece.round)):
        return piece
    start, end = moves.get(piece.start, piece.start), moves.get(piece.end, piece.end)
    if (start, end) == (piece.start, piece.end):
        return piece
    if isinstance(piece, Straight):
        return Straight(start, end)
    if isinstance(piece, Cubic):
        first = _shifted(piece.first, piece.start, start)
        return Cubic(start, first, _shifted(piece.second, piece.end, end), end)
    (ux, uy), (vx, vy) = piece.u, piece.v
    turn = piece.sweep if ux * vy - uy * vx > 0.0 else -piece.sweep
    return bulged(start, end, tan(0.25 * turn)) or piece


def _shifted(point: Vector, before: Vector, after: Vector) -> Vector:
    """A handle that goes with its end."""
    return point[0] + after[0] - before[0], point[1] + after[1] - before[1]


# -- smooth joints -----------------------------------------------------------------------------------------------------


def smoothed(outlines: list[Outline], tolerance: float) -> list[Outline]:
    """`outlines` with the handles of curves turned so that joints which are nearly smooth are smooth.

    A curve takes the direction of the straight piece or arc that it continues; two curves meet half way.
    """
    curves = [piece for outline in outlines for piece in outline if isinstance(piece, Cubic)]
    bent = {curve.start for curve in curves} | {curve.end for curve in curves}
    if not bent:
        return outlines
    done = [list(outline) for outline in outlines]
    ends: dict[Vector, list[tuple[int, int, bool]]] = {}
    for row, outline in enumerate(done):
        for place, piece in enumerate(outline):
            if not (isinstance(piece, Conic) and piece.whole) and not bent.isdisjoint((piece.start, piece.end)):
                ends.setdefault(piece.start, []).append((row, place, True))
                ends.setdefault(piece.end, []).append((row, place, False))
    for meeting in ends.values():
        if len(meeting) == 2:
            _smooth(done, meeting[0], meeting[1], OF_HANDLE * tolerance)
    return done


def _smooth(outlines: list[Outline], one: tuple[int, int, bool], other: tuple[int, int, bool], most: float) -> None:
    """Turn the handles at one joint, if it is nearly smooth and they would move by no more than `most`."""
    pieces = [outlines[row][place] for row, place, _ in (one, other)]
    curves = [isinstance(piece, Cubic) for piece in pieces]
    if not any(curves):
        return
    directions = [_outward(piece, start) for piece, (_, _, start) in zip(pieces, (one, other), strict=True)]
    if directions[0] is None or directions[1] is None:
        return
    bend = (directions[1] - directions[0]) % (2.0 * pi) - pi
    if bend == 0.0 or abs(bend) > SMOOTH:
        return
    shares = (0.5, -0.5) if all(curves) else (1.0 if curves[0] else 0.0, -1.0 if curves[1] else 0.0)
    turned: list[Cubic | None] = []
    for piece, (_, _, start), share in zip(pieces, (one, other), shares, strict=True):
        turned.append(_turned(piece, share * bend, most, start=start) if isinstance(piece, Cubic) else None)
    if any(curve is None for curve, is_curve in zip(turned, curves, strict=True) if is_curve):
        return
    for curve, (row, place, _) in zip(turned, (one, other), strict=True):
        if curve is not None:
            outlines[row][place] = curve


def _outward(piece: Piece, start: bool) -> float | None:
    """The direction in which a piece would go on past one of its ends; None where it has no handle to tell."""
    if isinstance(piece, Course):
        return None
    if isinstance(piece, Conic):
        t = piece.begin if start else piece.begin + piece.sweep
        x, y = piece.v[0] * cos(t) - piece.u[0] * sin(t), piece.v[1] * cos(t) - piece.u[1] * sin(t)
        back = start == (piece.sweep > 0.0)
        return atan2(-y, -x) if back else atan2(y, x)
    if isinstance(piece, Cubic):
        here, there = (piece.start, piece.first) if start else (piece.end, piece.second)
    else:
        here, there = (piece.start, piece.end) if start else (piece.end, piece.start)
    return None if here == there else atan2(here[1] - there[1], here[0] - there[0])


def _turned(curve: Cubic, angle: float, most: float, *, start: bool) -> Cubic | None:
    """A curve with the handle at one end turned; None where it would move too far."""
    end, handle = (curve.start, curve.first) if start else (curve.end, curve.second)
    x, y = handle[0] - end[0], handle[1] - end[1]
    if hypot(x, y) * abs(angle) > most:
        return None
    c, s = cos(angle), sin(angle)
    place = end[0] + c * x - s * y, end[1] + s * x + c * y
    return replace(curve, first=place) if start else replace(curve, second=place)


def size_of(outlines: Iterable[Outline]) -> float:
    """The longer side of what holds all outlines; 0 for none."""
    points = chain.from_iterable(piece.points() for outline in outlines for piece in outline)
    table = np.fromiter(chain.from_iterable(points), np.float64).reshape(-1, 2)
    if len(table) == 0:
        return 0.0
    with np.errstate(over="ignore", invalid="ignore"):
        return float((table.max(axis=0) - table.min(axis=0)).max())
