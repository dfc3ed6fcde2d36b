"""What happened in a step or a run: `Hits`, a structured array that also knows the objects that met."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import IntEnum
from struct import Struct
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.checks import refuse
from carom.extras import needed
from carom.rows.hit import BOUNCE, ENTER, EXIT, HIT, HIT_ROW
from carom.rows.tables import Rows
from carom.typing import Vector
from carom.world.boundary import Boundary, boundary_of
from carom.world.counts import Counter, Counts
from carom.world.plural import OfHits, Plural
from carom.world.touches import Touches

if TYPE_CHECKING:
    import pyarrow

    from carom.shapes.ball import Ball
    from carom.shapes.shape import Shape
    from carom.world.world import World


class HitKind(IntEnum):
    """What a hit is: a pair that approached and bounced, or a ball that came into a sensor or left it."""

    BOUNCE = BOUNCE
    ENTER = ENTER
    EXIT = EXIT


@dataclass(frozen=True, slots=True)
class Hit:
    """One impact, or one crossing of a sensor's edge.

    A crossing has no setback and no impulse. Point, normal and speed are those with which the ball crossed the edge;
    zeros at an `EXIT` in discrete mode, where it is over then, and where a switch or a removal has ended it.

    `ball` or `shape` is None only where it left the world long ago, or before that was restored, and nobody kept it.

    Attributes:
        time: The world's time in seconds; in discrete mode that of the end of the substep.
        kind: What it was.
        ball: The ball. Of two balls, the one that was added last.
        shape: The shape or ball that it met.
        point: Where, as (x, y).
        normal: Unit vector from the shape to the ball.
        setback: How far the ball was moved along the normal.
        speed: Length of the velocity of the ball relative to the surface, before.
        impulse: Momentum given to the ball along the normal.
        velocity: Of the ball, just before, as (x, y).
        position: Of the ball's centre, as (x, y): in discrete mode where the setback has put it.
    """

    time: float
    kind: HitKind
    ball: Ball
    shape: Shape | Ball
    point: Vector
    normal: Vector
    setback: float
    speed: float
    impulse: float
    velocity: Vector
    position: Vector


#: The kinds of hits by their numbers.
KINDS = tuple(HitKind)

#: The numbers of a row of hits: to unpack them takes less time than to have NumPy make objects of its fields.
NUMBERS = Struct("=" + "".join({"i": "q", "f": "d"}[HIT_ROW[field].kind] for field in HIT_ROW.names or ()))

#: What puts each attribute into a hit, past the refusal to change one, in far less time than its constructor does.
PUTS = tuple(vars(Hit)[field.name].__set__ for field in fields(Hit))


class Hits(OfHits[Hit]):
    """Every hit of a step or a run, in order of time: a structured array whose items are `Hit` objects.

    `hits["speed"]`, masks and slices work as with any structured array (the fields are those of `Hit`, with ids for
    `ball` and `shape`); iterating and single indices give `Hit` objects. It is false where there was no hit.
    Copied or pickled together with the world, these are hits of the new world; hits pickled alone raise `LostObject`
    where objects are asked for.
    """

    DTYPE = HIT

    def __repr__(self) -> str:
        return f"<{len(self)} hits>"

    __str__ = __repr__

    def _object(self, world: World, row: Any) -> Hit:
        time, kind, ball, shape, x, y, nx, ny, setback, speed, impulse, vx, vy, at_x, at_y = NUMBERS.unpack(row)
        values = (
            time,
            KINDS[kind],
            self._member(world, ball),
            self._member(world, shape),
            (x, y),
            (nx, ny),
            setback,
            speed,
            impulse,
            (vx, vy),
            (at_x, at_y),
        )
        hit = object.__new__(Hit)
        for put, value in zip(PUTS, values, strict=True):
            put(hit, value)
        return hit

    def touches(self) -> Touches:
        """The touches that these hits belong to: a bounce that begins before the ball has left is none of its own.

        A ball that rolls along an arc touches it once, and one that drops touches the floor as often as it has come up
        from there by more than a twentieth of its radius. A stay in a sensor is one touch. The hits are taken to be in
        order of time; an `EXIT` whose `ENTER` is not among them is left out.
        """
        return Touches.of_hits(self)

    def counts(self) -> Counts:
        """The hits counted by what was hit; the same that `World.run(..., keep="counts")` keeps."""
        counter = Counter()
        counter.add(self.view(np.ndarray))
        return Counts.of(self._world, counter.rows(), self._gone)

    def boundary(self, outline: Sequence[Shape]) -> Boundary:
        """Where along an outline the hits on it are, and from which direction the balls came; two arrays.

        Args:
            outline: Segments and arcs of the hits' world that join, in order: each begins where the one before ends,
                with either of its ends. Or one circle. It is taken as it stands now.

        Raises:
            InvalidArgument: They do not join, or one is of no world or another.
            LostObject: The hits do not know their world.

        >>> import carom
        >>> world = carom.World()
        >>> room = world.add(carom.Circle((0, 0), 2.0))
        >>> ball = world.add(carom.Ball((0, 0), 0.5, velocity=(0, 1)))
        >>> hits, arc_length, sine = world.run(2.0).boundary([room])
        >>> arc_length / room.length, sine
        (array([0.25]), array([0.]))
        """
        return boundary_of(self, outline)

    def table(self) -> pyarrow.Table:
        """The hits as a pyarrow table: the fields by name, vectors as `_x` and `_y` columns.

        Raises:
            MissingExtra: pyarrow is not installed; `pip install "carom[study]"` brings it.
        """
        module = needed("pyarrow", "pyarrow", "study", "tables of hits")
        rows = self.view(np.ndarray)
        columns: dict[str, Any] = {}
        for name in HIT.names or ():
            if rows[name].ndim == 2:
                columns[f"{name}_x"] = np.ascontiguousarray(rows[name][:, 0])
                columns[f"{name}_y"] = np.ascontiguousarray(rows[name][:, 1])
            else:
                columns[name] = np.ascontiguousarray(rows[name])
        table: pyarrow.Table = module.table(columns)
        return table


def rows_of(world: World, hits: Any) -> Rows:
    """The rows of hits of `world`, as such or as a plain array of them; raises `InvalidArgument` for anything else."""
    if not isinstance(hits, np.ndarray) or hits.dtype != HIT or hits.ndim != 1:
        raise refuse("hits", "must be those that a step or a run has returned", hits)
    if isinstance(hits, Plural) and hits._link is not None and hits._link.world not in (None, world):
        raise refuse("hits", f"must be those of {world!r}", hits._link.world)
    return hits.view(np.ndarray)


#: What a step without hits returns the rows of.
NO_ROWS: Rows = np.zeros(0, HIT)
