"""Hits gathered into touches: a ball that rolls along a wall has met it once, however many hits that makes.

A bounce belongs to the touch of the bounce before, of the same ball at the same shape, where the ball has not left the
surface between the two. How far it had left it follows from the later one: what comes back with a normal speed s after
t seconds was s t / 4 away at most, be it thrown up and pulled back (u²/2g, t being 2u/g) or flown along the chord of an
arc (the sagitta). Where that is less than `LOWEST_HOP` radii of the ball, it has not left.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.constants import LOWEST_HOP
from carom.rows.hit import BOUNCE, ENTER, EXIT
from carom.rows.tables import Rows
from carom.world.plural import OfHits, vector

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape
    from carom.typing import Vector
    from carom.world.hits import HitKind
    from carom.world.world import World

TOUCH = np.dtype(
    [
        ("time", "f8"),
        ("end", "f8"),
        ("kind", "i8"),
        ("ball", "i8"),
        ("shape", "i8"),
        ("count", "i8"),
        ("point", "f8", (2,)),
        ("normal", "f8", (2,)),
        ("speed", "f8"),
        ("impulse", "f8"),
    ]
)


@dataclass(frozen=True, slots=True)
class Touch:
    """A contact of a ball and a shape, from the first hit to the last one before the ball left.

    Attributes:
        time: The time of its first hit.
        end: The time of its last one; of a ball in a sensor, that of the `EXIT`, if it has left.
        kind: `BOUNCE`, or `ENTER` where one of the two is a sensor.
        ball: The ball. Of two balls, the one that was added last.
        shape: The shape or ball that it touched.
        count: How many hits it was.
        point: Where the first one was, as (x, y).
        normal: Unit vector from the shape to the ball, at the first one.
        speed: The greatest of its hits.
        impulse: The strongest of its hits.
    """

    time: float
    end: float
    kind: HitKind
    ball: Ball
    shape: Shape | Ball
    count: int
    point: Vector
    normal: Vector
    speed: float
    impulse: float


class Touches(OfHits[Touch]):
    """The touches that hits belong to, in order of their first times; `Hits.touches` gives them.

    Like hits they are a structured array, whose fields are those of `Touch`, and whose items are `Touch` objects.
    """

    DTYPE = TOUCH

    @classmethod
    def of_hits(cls, hits: Any) -> Touches:
        """The touches of `Hits`."""
        touches = touches_of(hits.view(np.ndarray)).view(cls)
        touches._link, touches._gone = hits._link, hits._gone
        return touches

    def __repr__(self) -> str:
        return f"<{len(self)} touches>"

    __str__ = __repr__

    def _object(self, world: World, row: Any) -> Touch:
        from carom.world.hits import HitKind

        time, end, kind, ball, shape, count, point, normal, speed, impulse = row.item()
        return Touch(
            time,
            end,
            HitKind(kind),
            self._member(world, ball),
            self._member(world, shape),
            count,
            vector(point),
            vector(normal),
            speed,
            impulse,
        )


def touches_of(hits: Rows) -> Rows:
    """Rows of `TOUCH` from rows of hits in order of time, in order of their first times.

    An `EXIT` whose `ENTER` is not among the hits ends what began before them, and belongs to no touch of theirs.
    """
    order, begins = Touching().begins_in_order(hits)
    rows = hits[order]
    numbers = np.cumsum(begins) - 1
    # What stands before the first beginning of its pair belongs to none: an EXIT, for every other hit begins one.
    kept = ~_ends_nothing(rows)
    rows, numbers, begins = rows[kept], numbers[kept], begins[kept]
    touches = np.zeros(int(np.count_nonzero(begins)), TOUCH)
    firsts = rows[begins]
    for name in ("time", "kind", "ball", "shape", "point", "normal"):
        touches[name] = firsts[name]
    touches["count"] = np.bincount(numbers, minlength=len(touches))
    for name, field in (("end", "time"), ("speed", "speed"), ("impulse", "impulse")):
        touches[name] = firsts[field]
        np.maximum.at(touches[name], numbers, rows[field])
    return touches[np.argsort(order[kept][begins], kind="stable")]


def _ends_nothing(rows: Rows) -> NDArray[np.bool_]:
    """Which rows, sorted by pair, are an `EXIT` that follows no `ENTER` of the same pair."""
    follows = np.zeros(len(rows), np.bool_)
    follows[1:] = _is_as_before(rows) & (rows["kind"][:-1] == ENTER)
    return np.asarray((rows["kind"] == EXIT) & ~follows)


def _is_as_before(rows: Rows) -> NDArray[np.bool_]:
    """Whether each row but the first is of the same ball and shape as the one before."""
    return np.asarray((rows["ball"][1:] == rows["ball"][:-1]) & (rows["shape"][1:] == rows["shape"][:-1]))


class Touching:
    """Tells which hits begin a touch, in parts of a run one after the other; it keeps the last hit of each pair."""

    def __init__(self) -> None:
        self._last: Rows | None = None

    def begins(self, hits: Rows) -> NDArray[np.bool_]:
        """Which of the next hits, in order of time, begin a touch."""
        before = hits[:0] if self._last is None else self._last
        rows = np.concatenate([before, hits])
        order, begins = self.begins_in_order(rows)
        ends = np.ones(len(rows), np.bool_)
        ends[:-1] = ~_is_as_before(rows[order])
        self._last = rows[order[ends]]
        told = np.empty(len(rows), np.bool_)
        told[order] = begins
        return told[len(before) :]

    def begins_in_order(self, rows: Rows) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """The order of the rows by ball and shape, each pair's in order of time, and which begin a touch, so sorted."""
        order = np.lexsort((rows["shape"], rows["ball"]))
        rows = rows[order]
        begins = rows["kind"] != EXIT
        as_before = _is_as_before(rows) & (rows["kind"][1:] == BOUNCE) & (rows["kind"][:-1] == BOUNCE)
        begins[1:][as_before & ~_has_left(rows[:-1], rows[1:])] = False
        return order, begins


def _has_left(before: Rows, after: Rows) -> NDArray[np.bool_]:
    """Whether the balls of hits had left what they were at in hits before."""
    velocity, normal, away = after["velocity"], after["normal"], after["position"] - after["point"]
    approach = np.abs(velocity[:, 0] * normal[:, 0] + velocity[:, 1] * normal[:, 1])
    radius = np.sqrt(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1])
    # Over a surface that moves the speed tells more: it is that relative to the surface, of which this is a part.
    normal_speed = np.minimum(approach, after["speed"])
    return np.asarray(0.25 * normal_speed * (after["time"] - before["time"]) > LOWEST_HOP * radius)
