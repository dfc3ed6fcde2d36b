"""Many cubics followed by arcs at once, each as `follow` follows one: the same trials, with arrays in place of numbers.

A drawing may have a hundred thousand curves, and a trial costs Python some thousand steps. Here all curves make their
next trial together. Each number is reckoned by the operations of `following`, `bow`, `track` and `carom.geometry.biarc`
in their order, so that the arcs are the same to the last bit; what is rare is left to these.

Arrays of numbers have the curves along their last axis. Places and directions are of shape (2, n), the control points
of cubics of shape (4, 2, n).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from math import atan2, inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from carom.constants import BIARC_LEAST_DIVISOR, GREATEST_SQUARE, LARGEST_RADIUS, LEAST_SQUARE, TIP_RADIUS
from carom.shapes.outlines.bow import END_ROUNDING, HALVINGS, PAST_END, PLACE_ROUNDING, WIDEST, Bow
from carom.shapes.outlines.cubic import Cubic
from carom.shapes.outlines.following import LOOKS, NEAR_ENOUGH, TRIALS, USED_UP
from carom.shapes.outlines.track import HALVINGS as TIP_HALVINGS
from carom.shapes.outlines.track import MOST_SLANT, STILL, Track

#: Curves that are left to `follow` once there are no more of them.
FEW = 40

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Lanes = NDArray[np.intp]


class Bows(NamedTuple):
    """Arcs, as `Bow` describes one, with the angle that each turns by."""

    start: Floats
    out: Floats
    curvature: Floats
    end: Floats
    into: Floats
    turn: Floats


class Trial(NamedTuple):
    """Biarcs along stretches: the share of their room that looks found, whether it is kept to; `odd` are left out."""

    first: Bows
    last: Bows
    used: Floats
    sure: Flags
    odd: Flags


def follow_abreast(tracks: Sequence[Track], tolerances: Sequence[float]) -> list[list[Bow] | None]:
    """For each track, which must be one cubic, the arcs that `follow` finds along it; None where that must be asked.

    It must be where what is rare comes up, and for the last few curves, of which it takes less time.
    """
    if len(tracks) <= FEW:
        return [None for _ in tracks]
    with np.errstate(all="ignore"):
        return _Search(tracks, tolerances).arcs()


def are_brisk(cubics: Sequence[Cubic]) -> list[bool]:
    """Which cubics are sure to have no tip, as `tracks` looks for them: of what is not sure it must be asked."""
    if not cubics:
        return []
    controls = _controls(cubics)
    with np.errstate(all="ignore"):
        size = np.sum(np.hypot(*np.moveaxis(np.diff(controls, axis=0), 1, 0)), axis=0)
        sure: list[bool] = _are_brisk(controls, STILL * size, TIP_HALVINGS).tolist()
    return sure


class _Search:
    """Where each curve's search for its next two arcs stands, as `follow` and `_farthest` have it."""

    def __init__(self, tracks: Sequence[Track], tolerances: Sequence[float]) -> None:
        count = len(tracks)
        self.cubics = _controls([track.cubics[0] for track in tracks])
        self.tolerance = np.array(tolerances)
        self.out, self.into = _pairs([track.out for track in tracks]), _pairs([track.into for track in tracks])
        self.start, self.low, self.high, self.u = np.zeros(count), np.zeros(count), np.ones(count), np.ones(count)
        self.trials = np.zeros(count, np.intp)
        self.halving = np.zeros(count, np.bool_)
        #: Where the best stretch so far ends, 0 where there is none, and the numbers of its two arcs.
        self.best_end, self.best = np.zeros(count), np.zeros((2, 10, count))
        self.found: list[list[Bow] | None] = [[] for _ in tracks]

    def arcs(self) -> list[list[Bow] | None]:
        """The arcs along each curve."""
        lanes = np.arange(len(self.found))
        while len(lanes) > FEW:
            ends = self.u[lanes]
            trial = _try(
                self.cubics[:, :, lanes], self.start[lanes], self.out[:, lanes], ends, self.into[:, lanes],
                self.tolerance[lanes],
            )  # fmt: skip
            self.trials[lanes] += 1
            for lane in lanes[trial.odd].tolist():
                self.found[lane] = None
            kept = ~trial.odd
            self._take(lanes, trial)
            over = self._is_over(lanes, trial) | self.halving[lanes]
            self._go_on(lanes[~over], trial.used[~over])
            self._finish(lanes[over & kept])
            lanes = lanes[kept]
            lanes = lanes[self.start[lanes] < 1.0]
        for lane in lanes.tolist():
            self.found[lane] = None
        return self.found

    def _take(self, lanes: Lanes, trial: Trial) -> None:
        """Note which trials were good, each the best so far: the longest stretch is between these and the others."""
        good, bad = lanes[trial.sure], lanes[~trial.sure]
        self.low[good], self.best_end[good] = self.u[good], self.u[good]
        self.best[:, :, good] = np.stack([_numbers(trial.first), _numbers(trial.last)])[:, :, trial.sure]
        self.high[bad] = np.where(self.halving[bad], self.high[bad], self.u[bad])

    def _is_over(self, lanes: Lanes, trial: Trial) -> Flags:
        """Which searches are near enough to the longest stretch."""
        used_up = (trial.used > USED_UP) & (trial.used <= 1.0)
        whole = trial.sure & ((self.u[lanes] == 1.0) | used_up)
        low, high, start = self.low[lanes], self.high[lanes], self.start[lanes]
        near = (self.best_end[lanes] > 0.0) & (high - low <= NEAR_ENOUGH * (high - start))
        return np.asarray(whole | near | (self.trials[lanes] >= TRIALS))

    def _go_on(self, lanes: Lanes, used: Floats) -> None:
        """Choose where the next stretches to be tried end."""
        start, low, high = self.start[lanes], self.low[lanes], self.high[lanes]
        share = np.array([ratio ** (1.0 / 3.0) for ratio in (0.97 / np.maximum(used, 1e-9)).tolist()])
        wanted = start + (self.u[lanes] - start) * share
        margin = np.where(self.best_end[lanes] > 0.0, 0.15, 0.02) * (high - low)
        self.u[lanes] = np.minimum(np.maximum(wanted, low + margin), high - np.maximum(margin, 0.1 * (high - low)))

    def _finish(self, lanes: Lanes) -> None:
        """Keep the arcs of the best stretches, or first try half of the rest where that is shorter than they are."""
        for lane in lanes[self.best_end[lanes] == 0.0].tolist():
            self.found[lane] = None
        self.start[lanes[self.best_end[lanes] == 0.0]] = 1.0
        lanes = lanes[self.best_end[lanes] > 0.0]
        rest = 1.0 - self.best_end[lanes]
        parted = ~self.halving[lanes] & (rest > 0.0) & (rest < self.best_end[lanes] - self.start[lanes])
        half = lanes[parted]
        self.u[half], self.halving[half] = 0.5 * (self.start[half] + 1.0), True
        done = lanes[~parted]
        for lane, first, last in zip(done.tolist(), *_bows(self.best[:, :, done]), strict=True):
            mine = self.found[lane]
            assert mine is not None
            mine += (first, last)
        self.out[:, done] = self.best[1][7:9, done]
        self.start[done] = self.low[done] = self.best_end[done]
        self.high[done] = self.u[done] = 1.0
        self.best_end[done], self.trials[done], self.halving[done] = 0.0, 0, False


# -- a trial: what `_along` and `_is_sure` say -------------------------------------------------------------------------


def _try(cubics: Floats, start: Floats, out: Floats, end: Floats, into: Floats, tolerance: Floats) -> Trial:
    """Biarcs along stretches of cubics, which end with the tangents `into`, from one place on each to another."""
    first, last = _point(cubics, start), _point(cubics, end)
    heading, still = _heading(cubics, end, into, 0.5 * np.hypot(*(last - first)))
    bows, odd = _biarcs(first, out, last, heading)
    good = np.flatnonzero(~(odd | still | np.isnan(bows[0].curvature)))
    middle = _crossing(cubics, start, end, bows[1].start, bows[1].out)
    ways = ((bows[0], start, middle), (bows[1], middle, end))
    used = np.zeros(len(start))
    for bow, low, high in ways:
        off = np.max([abs(_side(bow, _point(cubics, low + share * (high - low)))) for share in LOOKS], axis=0)
        used = np.maximum(used, off / np.maximum(_room(bow, tolerance), 1e-3 * tolerance))
    none = np.isnan(bows[0].curvature)
    used[none] = inf
    sure = np.zeros(len(start), np.bool_)
    near = good[used[good] <= 1.0]
    for bow, low, high in ways:
        near = near[_keeps(_of(bow, near), cubics[:, :, near], low[near], high[near], tolerance[near])]
    sure[near] = True
    rest = good[~sure[good]]
    sure[rest] = _is_tiny(
        _of(bows[0], rest), _of(bows[1], rest), cubics[:, :, rest], start[rest], end[rest], tolerance[rest]
    )
    return Trial(*bows, used, sure, (odd | still) & ~none)


def _point(cubics: Floats, t: Floats) -> Floats:
    """`Cubic.point`."""
    (a, b, c, d), s = cubics, 1.0 - t
    found: Floats = s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d)
    return found


def _slope(cubics: Floats, t: Floats) -> Floats:
    """`Cubic.slope`."""
    (a, b, c, d), s = cubics, 1.0 - t
    found: Floats = 3.0 * (s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c))
    return found


def _part(cubics: Floats, start: Floats, end: Floats) -> Floats:
    """`Cubic.part`, but for what is all of it, which stays what it is."""
    third = (end - start) / 3.0
    first, last = _point(cubics, start), _point(cubics, end)
    inner = first + third * _slope(cubics, start), last - third * _slope(cubics, end)
    return np.where(end - start == 1.0, cubics, np.stack([first, *inner, last]))


def _heading(cubics: Floats, t: Floats, into: Floats, arc: Floats) -> tuple[Floats, Flags]:
    """`Track.heading`, and where the curve stands still, so that it is another."""
    (a, b, c, d), slope = cubics, _slope(cubics, t)
    speed = np.hypot(*slope)
    second = 6.0 * ((1.0 - t) * (a - 2.0 * b + c) + t * (b - 2.0 * c + d))
    third = 6.0 * (d - a + 3.0 * (b - c))
    turning = _cross(slope, second)
    sixth = np.array([one**6 for one in speed.tolist()])
    growth = (_cross(slope, third) * speed * speed - 3.0 * turning * _dot(slope, second)) / sixth
    slant = np.minimum(np.maximum(-MOST_SLANT, growth * arc * arc / 12.0), MOST_SLANT)
    along = np.stack([slope[0] + slope[1] * slant, slope[1] - slope[0] * slant])
    at_end = t >= 1.0
    size = np.hypot(*(b - a)) + np.hypot(*(c - b)) + np.hypot(*(d - c))
    return np.where(at_end, into, along / np.hypot(*along)), ~at_end & (speed <= STILL * size)


def _biarcs(start: Floats, out: Floats, end: Floats, into: Floats) -> tuple[tuple[Bows, Bows], Flags]:
    """`biarc`, with a curvature that is no number where there is none; and where a length needs more care."""
    way = end - start
    chord, odd = _length(way)
    along = way / chord
    forward = _dot(out, along) + _dot(into, along)
    sideways = _cross(along, out) + _cross(along, into)
    divisor = forward + np.sqrt(np.abs((2.0 - sideways) * (2.0 + sideways)))
    none = divisor < BIARC_LEAST_DIVISOR
    leg = chord / divisor
    between = way - leg * (out + into)
    size, short = _length(between)
    tangent = between / size
    joint = 0.5 * (start + leg * out) + 0.5 * (end - leg * into)
    first, near = _bend(start, out, joint)
    last, far = _bend(joint, tangent, end)
    first[none] = np.nan
    odd = odd | (~none & (short | near | far))
    return (
        Bows(start, out, first, joint, tangent, _turn(out, tangent)),
        Bows(joint, tangent, last, end, into, _turn(tangent, into)),
    ), odd


def _bend(start: Floats, out: Floats, end: Floats) -> tuple[Floats, Flags]:
    """`bend`, and where a length needs more care."""
    way = end - start
    chord, odd = _length(way)
    return 2.0 * _cross(out, way / chord) / chord, odd


def _length(way: Floats) -> tuple[Floats, Flags]:
    """The lengths of vectors, and where they are so small or large that `length` takes another way."""
    x, y = way
    squared = x * x + y * y
    return np.sqrt(squared), ~((squared > LEAST_SQUARE) & (squared < GREATEST_SQUARE))


def _turn(out: Floats, into: Floats) -> Floats:
    """`Bow.turn`."""
    (ox, oy), (ix, iy) = out, into
    return _each(atan2, iy * ox - ix * oy, ix * ox + iy * oy)


def _side(bow: Bows, place: Floats) -> Floats:
    """`Bow.side`."""
    away = place - bow.start
    lean = _cross(bow.out, away) - 0.5 * bow.curvature * _dot(away, away)
    rest = 1.0 - 2.0 * bow.curvature * lean
    found: Floats = np.where(rest <= 0.0, 2.0 * lean, 2.0 * lean / (1.0 + np.sqrt(rest)))
    return found


def _room(bow: Bows, tolerance: Floats) -> Floats:
    """`Bow.room`."""
    largest = np.minimum(LARGEST_RADIUS, 0.1 * tolerance / END_ROUNDING)
    straight, bending = np.hypot(*(bow.end - bow.start)), np.abs(bow.curvature)
    flat = tolerance - PLACE_ROUNDING - END_ROUNDING * largest - 0.125 * bending * straight * straight
    return np.where(bending * largest < 1.0, flat, tolerance - PLACE_ROUNDING - END_ROUNDING / bending)


def _crossing(cubics: Floats, start: Floats, end: Floats, place: Floats, along: Floats) -> Floats:
    """`Track.crossing`."""
    low, high, u = start, end, 0.5 * (start + end)
    for _ in range(8):
        off = _dot(_point(cubics, u) - place, along)
        low, high = np.where(off < 0.0, u, low), np.where(off < 0.0, high, u)
        rate = _dot(_slope(cubics, u), along)
        nearer = np.where(rate > 0.0, u - off / rate, u)
        inside = (nearer == u) | ((low <= nearer) & (nearer <= high))
        u = np.where(inside, nearer, 0.5 * (low + high))
    return u


def _keeps(bow: Bows, cubics: Floats, low: Floats, high: Floats, tolerance: Floats) -> Flags:
    """Which parts of cubics are sure to keep within the tolerance of their arcs."""
    room = _room(bow, tolerance)
    wide = (room <= 0.0) | (np.abs(bow.turn) > WIDEST) | (bow.turn * bow.curvature < 0.0)
    kept: Flags = ~wide
    # Of a stretch that ends where the curve begins there is no part.
    asked = np.flatnonzero(kept & (high > 0.0))
    kept[asked] = _follows(_of(bow, asked), _part(cubics, low, high)[:, :, asked], room[asked], HALVINGS)
    return kept


def _follows(bow: Bows, cubics: Floats, room: Floats, halvings: int) -> Flags:
    """`Bow.follows`."""
    half, slack = 0.5 * bow.curvature, -PAST_END * room
    inside, outside = _bounds(bow.curvature, room)
    away = cubics - bow.start[None]
    s0, s1, s2, s3 = (_cross(bow.out, place) for place in away)
    a, b, c, d = away
    first, last = s0 - half * _dot(a, a), s3 - half * _dot(d, d)
    near = (outside <= first) & (first <= inside) & (outside <= last) & (last <= inside)
    ahead = [_dot(bow.out, place) for place in away]
    behind = [_dot(bow.into, bow.end - place) for place in cubics]
    near &= ~((ahead[0] < slack) | (behind[3] < slack))
    inner = (
        (s0 + s1) / 2.0 - half * _dot(a, b),
        (s0 + 3.0 * s1 + s2) / 5.0 - half * ((2.0 * _dot(a, c) + 3.0 * _dot(b, b)) / 5.0),
        (s0 + 9.0 * s1 + 9.0 * s2 + s3) / 20.0 - half * ((_dot(a, d) + 9.0 * _dot(b, c)) / 10.0),
        (s1 + 3.0 * s2 + s3) / 5.0 - half * ((2.0 * _dot(b, d) + 3.0 * _dot(c, c)) / 5.0),
        (s2 + s3) / 2.0 - half * _dot(c, d),
    )
    sure: Flags = near & (outside <= np.min(inner, axis=0)) & (np.max(inner, axis=0) <= inside)
    sure &= (np.min(ahead, axis=0) >= slack) & (np.min(behind, axis=0) >= slack)
    open_yet = np.flatnonzero(near & ~sure) if halvings > 0 else np.array([], np.intp)
    for later in (False, True):
        if len(open_yet):
            halves = _halves(cubics[:, :, open_yet])[later]
            open_yet = open_yet[_follows(_of(bow, open_yet), halves, room[open_yet], halvings - 1)]
    sure[open_yet] = True
    return sure


def _bounds(curvature: Floats, room: Floats) -> tuple[Floats, Floats]:
    """The most and the least of what `Bow.follows` bounds."""
    half, bent = 0.5 * curvature * room * room, curvature * room
    return np.where(bent >= 1.0, inf, room - half), np.where(bent <= -1.0, -inf, -room - half)


def _halves(cubics: Floats) -> tuple[Floats, Floats]:
    """`Cubic.halves`."""
    a, b, c, d = cubics
    ab, bc, cd = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + d)
    abc, bcd = 0.5 * (ab + bc), 0.5 * (bc + cd)
    middle = 0.5 * (abc + bcd)
    return np.stack([a, ab, abc, middle]), np.stack([middle, bcd, cd, d])


def _is_tiny(first: Bows, last: Bows, cubics: Floats, start: Floats, end: Floats, tolerance: Floats) -> Flags:
    """Which stretches and their arcs are no larger than the tolerance."""
    room = np.minimum(_room(first, tolerance), _room(last, tolerance))
    far = np.maximum(_reach(first), np.hypot(*(first.end - first.start)) + _reach(last))
    away = _part(cubics, start, end) - first.start[None]
    return np.asarray((far <= room) & (np.hypot(away[:, 0], away[:, 1]) <= room).all(axis=0))


def _reach(bow: Bows) -> Floats:
    """`Bow.reach`."""
    straight = np.hypot(*(bow.end - bow.start))
    wide = np.minimum(2.0 / np.abs(bow.curvature), 10.0 * straight)
    found: Floats = np.where(bow.turn * bow.curvature >= 0.0, straight, wide)
    return found


# -- tips: what `_is_brisk` says ---------------------------------------------------------------------------------------


def _are_brisk(cubics: Floats, still: Floats, halvings: int) -> Flags:
    """Which cubics are sure to have no tip, and to be nowhere slower than `still`."""
    a, b, c, d = cubics
    legs, chord = (b - a, c - b, d - c), d - a
    along = np.min([_dot(leg, chord) for leg in legs], axis=0) / np.hypot(*chord)
    pairs = (legs[0], legs[1]), (legs[1], legs[2]), (legs[2], legs[0])
    turns = [_cross(*pair) for pair in pairs]
    apart = (np.min(turns, axis=0) < 0.0) & (np.max(turns, axis=0) > 0.0)
    least = np.where(along > 0.0, along, np.where(apart, np.min([_nearest(*pair) for pair in pairs], axis=0), 0.0))
    bend = 6.0 * np.maximum(np.hypot(*(legs[1] - legs[0])), np.hypot(*(legs[2] - legs[1])))
    speed = 2.9 * least
    sure: Flags = (speed > 0.0) & (speed > still) & (speed * speed > TIP_RADIUS * bend)
    open_yet = np.flatnonzero(~sure) if halvings > 0 else np.array([], np.intp)
    for later in (False, True):
        if len(open_yet):
            halves = _halves(cubics[:, :, open_yet])[later]
            open_yet = open_yet[_are_brisk(halves, 0.5 * still[open_yet], halvings - 1)]
    sure[open_yet] = True
    return sure


def _nearest(start: Floats, end: Floats) -> Floats:
    """How far the ways from places to others are from 0."""
    along = end - start
    square = _dot(along, along)
    share = np.where(square > 0.0, np.minimum(np.maximum(-_dot(start, along) / square, 0.0), 1.0), 0.0)
    return np.asarray(np.hypot(*(start + share * along)))


# -- arrays ------------------------------------------------------------------------------------------------------------


def _cross(a: Floats, b: Floats) -> Floats:
    """The cross products of vectors."""
    found: Floats = a[0] * b[1] - a[1] * b[0]
    return found


def _dot(a: Floats, b: Floats) -> Floats:
    """The dot products of vectors."""
    found: Floats = a[0] * b[0] + a[1] * b[1]
    return found


def _each(function: Callable[[float, float], float], a: Floats, b: Floats) -> Floats:
    """A function of two numbers for each pair: those of NumPy have other last digits on some processors."""
    return np.array(list(map(function, a.tolist(), b.tolist())))


def _controls(cubics: Sequence[Cubic]) -> Floats:
    """The control points of cubics as an array."""
    given = np.fromiter(chain.from_iterable(cubics), np.complex128, 4 * len(cubics)).reshape(-1, 4).T
    return np.stack([given.real, given.imag], axis=1)


def _pairs(places: Sequence[complex]) -> Floats:
    """Places as an array."""
    given = np.array(places)
    return np.stack([given.real, given.imag])


def _of(bow: Bows, lanes: Lanes) -> Bows:
    """Some of the arcs."""
    return Bows(*(part[..., lanes] for part in bow))


def _numbers(bow: Bows) -> Floats:
    """Arcs as an array of ten numbers each."""
    return np.concatenate([np.atleast_2d(part) for part in bow])


def _bows(numbers: Floats) -> tuple[list[Bow], list[Bow]]:
    """The first and the last arcs of stretches, as `Bow`s, from their numbers."""
    made = []
    for rows in numbers:
        sx, sy, ox, oy, curvature, ex, ey, ix, iy, _ = rows.tolist()
        parts = map(complex, sx, sy), map(complex, ox, oy), curvature, map(complex, ex, ey), map(complex, ix, iy)
        made.append(list(map(Bow, *parts)))
    return made[0], made[1]
