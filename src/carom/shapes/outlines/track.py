"""Smooth runs of cubics, to be followed by arcs: where they are, which way they go, how they bend."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from carom.constants import TIP_RADIUS
from carom.shapes.outlines.cubic import Cubic, cross, dot, slowest

#: Share of a cubic's size: a slope or second derivative below it is none, for what it turns is far below any tolerance.
STILL, UNBENT = 1e-8, 1e-4

#: Radians by which the directions of two cubics may differ where they meet, so that they are one smooth run.
SMOOTH = 1e-9

#: Times that a cubic is halved to tell that it has no tip.
HALVINGS = 3

#: Share of a cubic's parameter within which two tips are one.
ONE_TIP = 1e-5

#: Radians by which arcs are slanted against the curve at most.
MOST_SLANT = 0.2


class Track:
    """Cubics that continue each other smoothly; a place on it is a number u from 0 to their count, `end`.

    `out` and `into` are the unit tangents with which it begins and ends.
    """

    def __init__(self, cubics: Sequence[Cubic], out: complex, into: complex) -> None:
        """Take cubics, and the unit tangents."""
        self.cubics = cubics
        self.out = out
        self.into = into
        self.end = float(len(cubics))

    def _at(self, u: float) -> tuple[Cubic, float]:
        """The cubic that u lies on, and the place there."""
        index = min(int(u), len(self.cubics) - 1)
        return self.cubics[index], u - index

    def point(self, u: float) -> complex:
        """The place at u."""
        cubic, t = self._at(u)
        return cubic.point(t)

    def points(self, start: float, end: float, shares: Sequence[float]) -> list[complex]:
        """The places at shares of the way from one u to a later one; what `Cubic.point` says stands here again."""
        cubics = self.cubics
        last = len(cubics) - 1
        found = []
        for share in shares:
            u = start + share * (end - start)
            index = int(u) if u < last else last
            a, b, c, d = cubics[index]
            t = u - index
            s = 1.0 - t
            found.append(s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d))
        return found

    def slope(self, u: float) -> complex:
        """The derivative by u."""
        cubic, t = self._at(u)
        return cubic.slope(t)

    def heading(self, u: float, arc: float) -> complex:
        """The direction in which arcs about as long as `arc` best pass u, a unit vector; at the ends that of the curve.

        A curve whose curvature grows steadily is best followed by arcs that meet on it, at a slant: they deviate by a
        third of what arcs along its tangents do. With curvatures that are its own at their middles the deviation is a
        Bernoulli polynomial of degree 3 along each arc, and the slant a²/12 times the slope of the curvature.
        """
        if u <= 0.0 or u >= self.end:
            return self.out if u <= 0.0 else self.into
        cubic, t = self._at(u)
        slope = cubic.slope(t)
        speed = abs(slope)
        if speed <= STILL * cubic.size():
            return _directions(cubic, t)[1]
        second = cubic.second(t)
        turning = cross(slope, second)
        growth = (cross(slope, cubic.third()) * speed * speed - 3.0 * turning * dot(slope, second)) / speed**6
        slant = min(max(-MOST_SLANT, growth * arc * arc / 12.0), MOST_SLANT)
        along = slope * complex(1.0, -slant)
        return along / abs(along)

    def crossing(self, start: float, end: float, place: complex, along: complex) -> float:
        """A u from `start` to `end` at which the track crosses the line through a place, at right angles to `along`.

        What `Cubic.point` and `Cubic.slope` say stands here again: calls of them would be half of the time of a fit.
        """
        x, y, cubics = along.real, along.imag, self.cubics
        last = len(cubics) - 1
        low, high = start, end
        u = 0.5 * (low + high)
        for _ in range(8):
            index = int(u) if u < last else last
            a, b, c, d = cubics[index]
            t = u - index
            s = 1.0 - t
            away = s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d) - place
            off = away.real * x + away.imag * y
            if off < 0.0:
                low = u
            else:
                high = u
            slope = 3.0 * (s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c))
            rate = slope.real * x + slope.imag * y
            nearer = u - off / rate if rate > 0.0 else u
            if nearer == u:
                break
            u = nearer if low <= nearer <= high else 0.5 * (low + high)
        return u

    def parts(self, start: float, end: float) -> Iterator[Cubic]:
        """The cubics from one u to a later one, the first and the last of them cut there."""
        for index in range(min(int(start), len(self.cubics) - 1), len(self.cubics)):
            if index >= end:
                return
            low, high = max(start - index, 0.0), min(end - index, 1.0)
            cubic = self.cubics[index]
            yield cubic if high - low == 1.0 else cubic.part(low, high)


def tracks(cubics: Sequence[Cubic]) -> list[Track]:
    """The smooth runs of cubics that continue each other: to corners, and cusps, where the way turns back."""
    runs: list[Track] = []
    run: list[Cubic] = []
    start = last = 0j
    for cubic in cubics:
        for part, out, into in _smooth_parts(cubic):
            if run and (dot(last, out) < 0.0 or abs(cross(last, out)) > SMOOTH):
                runs.append(Track(run, start, last))
                run = []
            start = start if run else out
            run.append(part)
            last = into
    return [*runs, Track(run, start, last)] if run else runs


def brisk_track(cubic: Cubic) -> Track:
    """The only track of a cubic without a tip."""
    return Track([cubic], _directions(cubic, 0.0, tip=False)[1], _directions(cubic, 1.0, tip=False)[0])


def _smooth_parts(cubic: Cubic) -> Iterator[tuple[Cubic, complex, complex]]:
    """The parts of a cubic between its cusps, with the directions at their ends; none of one that is a point."""
    if cubic.size() == 0.0:
        return
    tips = [] if _is_brisk(cubic, STILL * cubic.size()) else _tips(cubic)
    before, out = 0.0, _directions(cubic, 0.0, 0.0 in tips)[1]
    for t in [*(t for t in tips if 0.0 < t < 1.0), 1.0]:
        back, forth = _directions(cubic, t, t in tips)
        if t == 1.0 or dot(back, forth) < 0.0:
            yield cubic.part(before, t) if t - before < 1.0 else cubic, out, back
            before, out = t, forth


def _is_brisk(cubic: Cubic, still: float, halvings: int = HALVINGS) -> bool:
    """Whether a cubic is sure to have no tip: its slope, thrice a mean of its legs, is far from 0 wherever it is.

    It has none slower than `still`. What the whole does not tell its halves may, whose slopes are half as steep.
    """
    a, b, c, d = cubic
    first, second, third, chord = b - a, c - b, d - c, d - a
    long = abs(chord)
    # Of a curve that goes on along its chord it is quick to tell.
    least = min(dot(first, chord), dot(second, chord), dot(third, chord)) / long if long > 0.0 else 0.0
    if least <= 0.0:
        turns = cross(first, second), cross(second, third), cross(third, first)
        if min(turns) < 0.0 < max(turns):  # else 0 may be a mean of them
            least = min(_nearest(first, second), _nearest(second, third), _nearest(third, first))
    speed = 2.9 * least
    bend = 6.0 * max(abs(second - first), abs(third - second))
    if least > 0.0 and speed > still and speed * speed > TIP_RADIUS * bend:
        return True
    return halvings > 0 and all(_is_brisk(half, 0.5 * still, halvings - 1) for half in cubic.halves())


def _nearest(start: complex, end: complex) -> float:
    """How far the way from one place to another is from 0."""
    along = end - start
    square = dot(along, along)
    share = min(max(-dot(start, along) / square, 0.0), 1.0) if square > 0.0 else 0.0
    return abs(start + share * along)


def _tips(cubic: Cubic) -> list[float]:
    """The places t where the cubic has a tip, ascending; of several that are one but for rounding, the slowest."""
    tips: list[float] = []
    for t in slowest(cubic):
        spot = 0.0 if t < ONE_TIP else 1.0 if t > 1.0 - ONE_TIP else t
        if not _is_tip(cubic, spot):
            continue
        if tips and spot - tips[-1] < ONE_TIP:
            if spot < 1.0 and abs(cubic.slope(spot)) >= abs(cubic.slope(tips[-1])):
                continue
            tips.pop()
        tips.append(spot)
    return tips


def _is_tip(cubic: Cubic, t: float) -> bool:
    """Whether the cubic turns about within no radius to speak of at t, or stands still there."""
    speed = abs(cubic.slope(t))
    return speed <= STILL * cubic.size() or speed * speed <= TIP_RADIUS * abs(cubic.second(t))


def _directions(cubic: Cubic, t: float, tip: bool = True) -> tuple[complex, complex]:
    """The unit vectors in which the cubic comes to t and leaves it."""
    if not tip:
        slope = cubic.slope(t)
        along = slope / abs(slope)
        return along, along
    second = cubic.second(t)
    if abs(second) > UNBENT * cubic.size():
        along = second / abs(second)
        return -along, along
    along = cubic.third() / abs(cubic.third())
    return along, along
