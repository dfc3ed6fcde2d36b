"""Lyapunov exponents of a world as it runs: of one ball among walls that may move, or of several balls that meet."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from math import log, sqrt
from typing import TypeAlias

import numpy as np

from carom.checks import positive, refuse
from carom.rows.hit import BOUNCE
from carom.rows.tables import Rows
from carom.spelling import spelled
from carom.study.billiards.ensembles import Numbers
from carom.study.billiards.outline import Floats
from carom.study.billiards.tangents import Walls, bounce_maps, impact_maps, products, times, walls_of
from carom.world import World

#: Parts of a run, whose exponents tell the error, and how many of them go by until changes have settled.
PARTS, SETTLING = 40, 10
#: Impacts after which changes of many balls are scaled, so few that none overflows.
SCALED = 50
#: Velocities that are reckoned one by one, as operations on all of them at once would take longer.
FEW = 4
#: The planes of the four coordinates of a change.
PLANES = tuple(combinations(range(4), 2))

# Numbers of balls, and what is told of each of some hits, as lists: loops over these are quick.
Places: TypeAlias = list[int]
Column: TypeAlias = list[float]


@dataclass(frozen=True, slots=True, eq=False)
class RunLyapunov:
    """The Lyapunov exponents of a run, each the logarithm of a growth in a second.

    Attributes:
        spectrum: All four of one ball, the greatest first, as opposite pairs: volumes in phase space are kept. Of
            several balls the greatest alone.
        error: Their standard errors: how the parts of the run differ, and what changes grow by where there is no chaos.
        hits: How many hits there were while it was measured.
        seconds: How long that was: three quarters of the run.
    """

    spectrum: Floats
    error: Floats
    hits: int
    seconds: float


@spelled
def lyapunov_of(world: World, seconds: float) -> RunLyapunov:
    """The Lyapunov exponents of a world of the continuous mode, which runs on for so many seconds.

    Walls may travel and turn steadily, and balls may meet; all must be elastic and without friction. The exponents are
    those of the orbit that the world is on; `study.lyapunov` measures many orbits of a table.

    Raises:
        InvalidArgument: The world is not of the continuous mode, holds no balls, loses one, or has what is not elastic.

    Source: Ch. Dellago, H. A. Posch and W. G. Hoover, Lyapunov instability in a system of hard disks in equilibrium and
    nonequilibrium steady states, 1996.

    >>> import carom
    >>> from carom import study
    >>> world = carom.World()
    >>> _ = world.add(carom.Circle((0, 0), 2.0), carom.Ball((0.5, 0), 0.1, velocity=(0.3, 1.0)))
    >>> found = study.lyapunov_of(world, 100.0)  # has no chaos
    >>> bool((abs(found.spectrum) < 2.0 * found.error).all())
    True
    """
    part = positive("seconds", seconds) / PARTS
    _check(world)
    walls = walls_of(world, "world")
    run = _OneBall(part) if len(world.balls) == 1 else _ManyBalls(len(world.balls), part)
    grown, hits = [], 0
    for number in range(PARTS):
        more, met = run.carried(world, walls)
        if number >= SETTLING:
            grown.append(more)
            hits += met
    rates = np.array(grown) / part
    lasted = (PARTS - SETTLING) * part
    value = rates.mean(axis=0)
    floor = log(PARTS / SETTLING) / lasted
    error = np.sqrt(rates.var(axis=0, ddof=1) / len(rates) + floor * floor)
    if len(value) == 1:
        return RunLyapunov(value, error, hits, lasted)
    return RunLyapunov(np.concatenate((value, -value[::-1])), np.concatenate((error, error[::-1])), hits, lasted)


def _check(world: World) -> None:
    """Raise `InvalidArgument` where a world's run is none that tangent maps follow."""
    if not isinstance(world, World):
        raise refuse("world", "must be a World", world)
    balls = world.balls
    for must, holds in (
        ("must be of the continuous mode", world.detection == "continuous"),
        ("must hold a ball", len(balls) > 0),
        ("must have balls of elasticity 1", bool((balls.elasticity == 1.0).all())),
        ("must have no friction", world.friction == 0.0 and not (balls.friction > 0.0).any()),
        ("must have no sleep_speed", world.sleep_speed == 0.0),
        ("must have no max_speed", world.max_speed is None),
    ):
        if not holds:
            raise refuse("world", must, world)


def _bounces(world: World, seconds: float) -> Rows:
    """The bounces of so many seconds; raises where a ball leaves the world."""
    count = len(world.balls)
    hits: Rows = world.run(seconds, seconds).view(np.ndarray)
    if len(world.balls) != count:
        raise refuse("world", "must keep its balls within its bounds", world)
    bounced = hits["kind"] == BOUNCE
    bounces: Rows = hits if bounced.all() else hits[bounced]
    return bounces


class _OneBall:
    """A change of one ball, and where walls move an area that two changes span, carried part after part of a run.

    A part's length is the unit of time, so that changes of place and of velocity are alike. Where walls stand, energy
    is kept and time has no beginning, so that no area grows otherwise than a line.
    """

    def __init__(self, part: float) -> None:
        self._part = part
        self._change = np.array([0.5, 0.7, 0.6, -0.4])[:, None, None]
        self._area = _areas(np.column_stack(([0.5, 0.7, 0.6, -0.4], [0.3, -0.2, 0.5, 0.8]))[:, :, None])

    def carried(self, world: World, walls: Walls) -> tuple[Floats, int]:
        """By how much they grow in a part of the run, as the first two exponents, and how many hits there are."""
        began = world.time
        rows = _bounces(world, self._part)
        flights = np.diff(rows["time"], prepend=began)
        last = np.eye(4)[:, :, None]
        last[[0, 1], [2, 3]] = world.time - (rows["time"][-1] if len(rows) else began)
        maps = np.concatenate((impact_maps(walls, rows, flights, float(world.balls.radius[0])), last), axis=2)
        maps[:2, 2:] /= self._part
        maps[2:, :2] *= self._part
        self._change, line = _grown(maps, self._change)
        area = line
        if walls.move:
            self._area, area = _grown(_areas(maps), self._area)
        return np.array([line, area - line]), len(rows)


def _grown(maps: Floats, before: Floats) -> tuple[Floats, float]:
    """What maps make of a vector, one after the other, with a size of 1, and the logarithm of its growth."""
    product, scale = products(maps, np.array([maps.shape[2]]))
    after = times(product, before)
    size = float(np.sqrt(np.sum(after * after)))
    return after / size, float(scale[0]) + log(size)


def _areas(maps: Floats) -> Floats:
    """What matrices of shape (4, columns, n) do to the areas of planes, or the areas that two columns span."""
    columns = tuple(combinations(range(maps.shape[1]), 2))
    return np.array([[maps[i, k] * maps[j, m] - maps[i, m] * maps[j, k] for k, m in columns] for i, j in PLANES])


class _ManyBalls:
    """A change of several balls, of shape (balls, 4), carried impact after impact through parts of a run."""

    def __init__(self, balls: int, part: float) -> None:
        self._part = part
        change = np.random.default_rng(0).normal(size=(balls, 4)) * [1.0, 1.0, 1.0 / part, 1.0 / part]
        self._change = change
        self._change = change / self._size()

    def carried(self, world: World, walls: Walls) -> tuple[Floats, int]:
        """By how much it grows in a part of the run, and how many hits there are."""
        ids, mass, radius = np.array(world.balls.id), world.balls.mass.copy(), world.balls.radius.copy()
        velocity, began = world.balls.velocity.copy(), world.time
        rows = _bounces(world, self._part)
        first, second = np.searchsorted(ids, rows["ball"]), np.searchsorted(ids, rows["shape"])
        pairs = ids[np.minimum(second, len(ids) - 1)] == rows["shape"]
        second[~pairs] = -1
        apart, flights = _histories(rows, first, second, mass, velocity, began, walls.gravity)
        normal = np.ascontiguousarray(rows["normal"].T)
        bent = np.empty((2, 2, len(rows)))
        bent[:, :, ~pairs] = impact_maps(walls, rows[~pairs], 0.0, radius[first[~pairs]])[2:, :2]
        curvature = 1.0 / (radius[first] + radius[second])[pairs]
        bent[:, :, pairs] = bounce_maps(normal[:, pairs], apart, curvature)[2:, :2]
        share = np.where(pairs, mass[second] / (mass[first] + mass[second]), 1.0)
        columns = np.concatenate((flights, normal, bent.reshape(4, -1), [share]))
        grown = self._through(first.tolist(), second.tolist(), columns.tolist())
        last = np.full(len(ids), began)
        for balls in (first, second):
            np.maximum.at(last, balls[balls >= 0], rows["time"][balls >= 0])
        self._change[:, :2] += (world.time - last)[:, None] * self._change[:, 2:]
        size = self._size()
        self._change /= size
        return np.array([grown + log(size)]), len(rows)

    def _through(self, first: Places, second: Places, columns: list[Column]) -> float:
        """The logarithm of what changes are divided by in impacts of the first balls on walls or second balls.

        The columns have how long the flights of the first and the second ball before each took, the normal n, the four
        numbers of the matrix b, row after row, and the share of the first ball, by their masses, in what changes
        between them. There the change between the two, or of the first alone on a wall, becomes
        δr - 2 n (n·δr) and δv - 2 n (n·δv) + b δr. Lists in lists would cost as much again.
        """
        scale, changes = 0.0, [tuple(change) for change in self._change.tolist()]
        each = zip(first, second, *columns, strict=True)
        for number, (one, other, flown, its_flown, nx, ny, a, b, c, d, share) in enumerate(each):
            x, y, vx, vy = changes[one]
            x, y = x + flown * vx, y + flown * vy
            if other < 0:
                across, faster = -2.0 * (nx * x + ny * y), -2.0 * (nx * vx + ny * vy)
                changes[one] = (
                    x + nx * across,
                    y + ny * across,
                    vx + (nx * faster + a * x + b * y),
                    vy + (ny * faster + c * x + d * y),
                )
            else:
                ox, oy, ovx, ovy = changes[other]
                ox, oy = ox + its_flown * ovx, oy + its_flown * ovy
                dx, dy = x - ox, y - oy
                across, faster = -2.0 * (nx * dx + ny * dy), -2.0 * (nx * (vx - ovx) + ny * (vy - ovy))
                dvx, dvy = nx * faster + a * dx + b * dy, ny * faster + c * dx + d * dy
                dx, dy, its_share = nx * across, ny * across, share - 1.0
                changes[one] = (x + share * dx, y + share * dy, vx + share * dvx, vy + share * dvy)
                changes[other] = (
                    ox + its_share * dx,
                    oy + its_share * dy,
                    ovx + its_share * dvx,
                    ovy + its_share * dvy,
                )
            if number % SCALED == 0:
                size = max(abs(part) for part in changes[one])
                changes = [(x / size, y / size, vx / size, vy / size) for x, y, vx, vy in changes]
                scale += log(size)
        self._change = np.array(changes)
        return scale

    def _size(self) -> float:
        """The size of a change, a part's length being the unit of time."""
        change = self._change
        return sqrt(float(np.sum(change[:, :2] ** 2) + np.sum((self._part * change[:, 2:]) ** 2)))


def _histories(
    rows: Rows, first: Numbers, second: Numbers, mass: Floats, velocity: Floats, began: float, gravity: Floats
) -> tuple[Floats, tuple[Floats, Floats]]:
    """What balls did until they met.

    For two that meet, the velocity of the first one as the second has it, of shape (2, pairs); for all how long the
    flight of the first took, and that of the second. Rows tell the first ball's velocity alone; the other's is that
    after its impact before, which its impulse tells.
    """
    count, met = len(mass), second >= 0
    # How all balls begin, and then each impact twice: once for its first ball, and once for its second, if it has one.
    whose = np.concatenate((np.arange(count), np.column_stack((first, second)).ravel()))
    at = np.concatenate((np.full(count, began), np.repeat(rows["time"], 2)))
    there = np.flatnonzero(whose >= 0)
    # Numbers of 16 bits are sorted in a fraction of the time.
    short = np.int16 if count < 2**15 else np.int64
    order = there[np.argsort(whose[there].astype(short), kind="stable")]
    before = np.zeros(len(whose), np.int64)
    before[order[1:]] = order[:-1]
    flown = np.where(whose >= 0, at - at[before], 0.0)[count:]
    after = np.zeros((2, len(whose)))
    after[:, :count] = velocity.T
    after[:, count::2] = rows["velocity"].T + (rows["impulse"] / mass[first]) * rows["normal"].T
    falls = gravity[:, None] * flown[1::2][met]
    pushes = (rows["impulse"] / mass[second])[met] * rows["normal"][met].T
    places = count + 1 + 2 * np.flatnonzero(met)
    across = _before(after, before[places], places, falls, pushes)
    return rows["velocity"][met].T - across, (flown[::2], flown[1::2])


def _before(after: Floats, former: Numbers, places: Numbers, falls: Floats, pushes: Floats) -> Floats:
    """The velocities of second balls before impacts, of shape (2, impacts), whose own are noted at places of `after`.

    Each is that after its `former` impact, and what it falls. Where that is known it is reckoned for many at once, and
    then for those after them; the last few are cheaper one by one.
    """
    found = np.empty(falls.shape)
    known = np.ones(after.shape[1], np.bool_)
    known[places] = False
    rest = np.arange(len(places))
    while len(rest):
        ready = known[former[rest]]
        now = rest[ready]
        rest = rest[~ready]
        found[:, now] = after[:, former[now]] + falls[:, now]
        after[:, places[now]] = found[:, now] - pushes[:, now]
        known[places[now]] = True
        if len(now) < FEW:
            break
    made: dict[int, tuple[float, float]] = {}
    last: list[tuple[float, float]] = []
    columns = places[rest], former[rest], *after[:, former[rest]], *falls[:, rest], *pushes[:, rest]
    for place, earlier, x, y, fall_x, fall_y, push_x, push_y in zip(*(one.tolist() for one in columns), strict=True):
        x, y = made.get(earlier, (x, y))
        x, y = x + fall_x, y + fall_y
        made[place] = x - push_x, y - push_y
        last.append((x, y))
    found[:, rest] = np.array(last).reshape(-1, 2).T
    return found
