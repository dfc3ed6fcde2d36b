"""What `world.balls` and `world.shapes` are: sequences of objects, and the balls' columns as NumPy views."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from carom.checks import refuse
from carom.pictured import Tabled
from carom.rows.ball import BALL, BallRow
from carom.rows.state import DISCRETE
from carom.shapes.assembly import Assembly
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.spelling import hint
from carom.world.waking import begin_anew

if TYPE_CHECKING:
    from carom.world.world import World


class Balls(Sequence["Ball"], Tabled):
    """The balls of a world in the order in which they were added.

    `world.balls[3]` is by its place, `world.balls["cue"]` the first one with that name; where nothing bears it, that
    raises `InvalidArgument`.

    Columns are views of the world's own rows, without a copy: writing to them acts at once, as setting the balls' own
    attributes does, and is checked when the next step begins. They are valid until balls are added or removed. While
    the world is stepped none is handed out, and nobody may write to one that was: NumPy cannot be told to refuse it
    (docs/threads.md).
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return self._world._arrays.balls.count

    @overload
    def __getitem__(self, index: int | str) -> Ball: ...
    @overload
    def __getitem__(self, index: slice) -> list[Ball]: ...
    def __getitem__(self, index: int | str | slice) -> Ball | list[Ball]:
        world = self._world
        if isinstance(index, str):
            members = sorted(world._objects.items())
            found: Ball = _called(index, [member for _, member in members if isinstance(member, Ball)], "ball")
            return found
        if isinstance(index, slice):
            return [world._ball_of(ball) for ball in self.id[index].tolist()]
        table = world._arrays.balls
        count = table.count
        if type(index) is int and -count <= index < count:
            return world._ball_of(table.id_at(index if index >= 0 else index + count))
        return world._ball_of(int(self.id[index]))

    def _glance(self, place: int) -> tuple[BallRow, str | None]:
        """The row of a ball, and its name; no object is made for it."""
        row: BallRow = self._world._arrays.balls.used[place]
        known = self._world._objects.get(int(row["id"]))
        return row, None if known is None else known.name

    def __iter__(self) -> Iterator[Ball]:
        for ball in self.id.copy():
            yield self._world._ball_of(int(ball))

    def __contains__(self, ball: object) -> bool:
        return getattr(ball, "world", None) is self._world and getattr(ball, "kind", "") == "ball"

    def __repr__(self) -> str:
        return f"<{len(self)} balls>"

    def _pairs(self, field: str) -> NDArray[np.float64]:
        """Two columns that stand side by side, as an (n, 2) view, between two steps."""
        return self._world._look(self._two_columns, field)

    def _two_columns(self, field: str) -> NDArray[np.float64]:
        """The view, with the world to itself."""
        rows = self._world._arrays.balls.used
        columns: Any = BALL.fields
        first = columns[field][1] // 8
        pairs: NDArray[np.float64] = rows.view(np.float64).reshape(len(rows), BALL.itemsize // 8)[:, first : first + 2]
        return pairs

    @property
    def position(self) -> NDArray[np.float64]:
        """Centres, a writable view of shape (n, 2)."""
        return self._pairs("x")

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities in length/s, a writable view of shape (n, 2)."""
        return self._pairs("vx")

    def _lent(self, field: str, dtype: type[np.generic]) -> NDArray[Any]:
        """A column, noted as it is now, for it may be written to from now on."""
        return self._world._look(self._lent_column, field, dtype)

    def _lent_column(self, field: str, dtype: type[np.generic]) -> NDArray[Any]:
        """The column, with the world to itself."""
        lend(self._world)
        column: NDArray[Any] = self._world._arrays.balls.used[field].view(dtype)
        return column

    def _shown(self, field: str, dtype: type[np.generic]) -> NDArray[Any]:
        """A column that cannot be written to."""
        column: NDArray[Any] = self._world._arrays.balls.used[field].view(dtype)
        column.flags.writeable = False
        return column

    @property
    def radius(self) -> NDArray[np.float64]:
        """Radii, positive: a writable view of shape (n,)."""
        return self._lent("radius", np.float64)

    @property
    def mass(self) -> NDArray[np.float64]:
        """Masses, positive: a writable view of shape (n,)."""
        return self._lent("mass", np.float64)

    @property
    def elasticity(self) -> NDArray[np.float64]:
        """Elasticities, 0 or more: a writable view of shape (n,)."""
        return self._lent("elasticity", np.float64)

    @property
    def friction(self) -> NDArray[np.float64]:
        """Frictions in length/s², 0 or more, or -1 where it is the world's: a writable view of shape (n,).

        A ball's own `friction` is None there.
        """
        return self._lent("friction", np.float64)

    @property
    def layer(self) -> NDArray[np.uint32]:
        """The layers that each is on, masks of 32 bits: a writable view of shape (n,)."""
        return self._lent("layer", np.uint32)

    @property
    def collides_with(self) -> NDArray[np.uint32]:
        """The layers that each meets, masks of 32 bits: a writable view of shape (n,)."""
        return self._lent("collides_with", np.uint32)

    @property
    def sensor(self) -> NDArray[np.bool_]:
        """Whether each only reports what overlaps it: a writable view of shape (n,)."""
        return self._lent("sensor", np.bool_)

    @property
    def can_collide(self) -> NDArray[np.bool_]:
        """Whether each meets anything at all: a writable view of shape (n,)."""
        return self._lent("can_collide", np.bool_)

    @property
    def asleep(self) -> NDArray[np.bool_]:
        """Whether each sleeps: a read-only view of shape (n,)."""
        return self._shown("asleep", np.bool_)

    @property
    def id(self) -> NDArray[np.int64]:
        """Ids, a read-only view of shape (n,), ascending."""
        return self._shown("id", np.int64)


#: The columns that may be written to, but for places and velocities, which a step itself compares.
LENT = ["radius", "mass", "elasticity", "friction", "layer", "collides_with", "sensor", "can_collide"]


def lend(world: World) -> None:
    """Note the columns as they are now, for they may be written to from now on."""
    world._quick = None
    note_lent(world)


def note_lent(world: World) -> None:
    """Note the lent columns where a change of them has to be seen; a step itself changes none of them."""
    rows = world._arrays.balls.used
    if not _matters(world):
        world._lent = rows[LENT][:0]
    elif world._lent is None or len(world._lent) != len(rows):
        world._lent = rows[LENT].copy()


def see_lent(world: World) -> None:
    """Take note of it if columns that were lent have been written to."""
    lent, rows = world._lent, world._arrays.balls.used
    if lent is None or not _matters(world):
        return
    if len(lent) != len(rows):
        world._lent = None
    elif (changed := lent != rows[LENT]).any():
        begin_anew(world._arrays, changed)
        world._note_change()
        world._lent = rows[LENT].copy()


def _matters(world: World) -> bool:
    """Whether a change of a column has to be seen: it wakes who sleeps, and changes what is foreseen in flights."""
    state = world._states[0]
    return bool(state["sleeping"] or state["detection"] != DISCRETE)


class Shapes(Sequence["Shape | Compound | Group"], Tabled):
    """The shapes of a world in the order in which they were added; a compound or group is one, its parts are not.

    `world.shapes[3]` is by its place, `world.shapes["floor"]` the first one with that name; where nothing bears it,
    that raises `InvalidArgument`.
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return len(self._world._added)

    @overload
    def __getitem__(self, index: int | str) -> Shape | Compound | Group: ...
    @overload
    def __getitem__(self, index: slice) -> list[Shape | Compound | Group]: ...
    def __getitem__(self, index: int | str | slice) -> Shape | Compound | Group | list[Shape | Compound | Group]:
        return _called(index, self._world._list(), "shape") if isinstance(index, str) else self._world._list()[index]

    def __iter__(self) -> Iterator[Shape | Compound | Group]:
        return iter(self._world._list()[:])

    def __contains__(self, shape: object) -> bool:
        if isinstance(shape, Shape):
            return shape._world is self._world and shape._whole is None
        return isinstance(shape, Assembly) and shape._world is self._world

    def __repr__(self) -> str:
        return f"<{len(self)} shapes>"


def _called(name: str, members: Sequence[Any], what: str) -> Any:
    """The first of some members with a name; raises `InvalidArgument` where there is none."""
    found = next((member for member in members if member.name == name), None)
    if found is None:
        said = hint(name, sorted({member.name for member in members if member.name is not None}))
        raise refuse("name", f"must be that of a {what} in the world{f' ({said})' if said else ''}", name)
    return found
