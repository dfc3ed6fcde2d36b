"""What `world.balls` and `world.shapes` are: sequences of objects, and the balls' columns as NumPy views."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from carom.rows import BALL

if TYPE_CHECKING:
    from carom.shapes.ball import Ball
    from carom.shapes.compound import Compound
    from carom.shapes.shape import Shape
    from carom.world.world import World


class Balls(Sequence["Ball"]):
    """The balls of a world in the order in which they were added.

    Columns are views of the world's own rows, without a copy: writing to them acts at once (and is checked when the
    next step begins). They are valid until balls are added or removed.
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return self._world._room.balls.count

    @overload
    def __getitem__(self, index: int) -> Ball: ...
    @overload
    def __getitem__(self, index: slice) -> list[Ball]: ...
    def __getitem__(self, index: int | slice) -> Ball | list[Ball]:
        ids = self.id
        if isinstance(index, slice):
            return [self._world._ball_of(int(ball)) for ball in ids[index]]
        return self._world._ball_of(int(ids[index]))

    def __iter__(self) -> Iterator[Ball]:
        for ball in self.id.copy():
            yield self._world._ball_of(int(ball))

    def __contains__(self, ball: object) -> bool:
        return getattr(ball, "world", None) is self._world and getattr(ball, "kind", "") == "ball"

    def __repr__(self) -> str:
        return f"<{len(self)} balls>"

    def _pairs(self, field: str) -> NDArray[np.float64]:
        """Two columns that stand side by side, as an (n, 2) view."""
        rows = self._world._room.balls.used
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

    @property
    def radius(self) -> NDArray[np.float64]:
        """Radii, a writable view of shape (n,)."""
        lend(self._world)
        column: NDArray[np.float64] = self._world._room.balls.used["radius"]
        return column

    @property
    def mass(self) -> NDArray[np.float64]:
        """Masses, a writable view of shape (n,)."""
        lend(self._world)
        column: NDArray[np.float64] = self._world._room.balls.used["mass"]
        return column

    @property
    def id(self) -> NDArray[np.int64]:
        """Ids, a read-only view of shape (n,), ascending."""
        column: NDArray[np.int64] = self._world._room.balls.used["id"]
        column.flags.writeable = False
        return column


def lend(world: World) -> None:
    """Nothing; notes radii and masses as they are now, for they may be written to from now on."""
    see_lent(world)
    world._lent = world._room.balls.used[["radius", "mass"]].copy()


def see_lent(world: World) -> None:
    """Nothing; wakes all balls if radii or masses that were lent have been written to."""
    lent, rows = world._lent, world._room.balls.used
    if lent is None:
        return
    if len(lent) != len(rows):
        world._lent = None
    elif not np.array_equal(lent, rows[["radius", "mass"]]):
        world._states[0]["wake"] = 1
        world._lent = rows[["radius", "mass"]].copy()


class Shapes(Sequence["Shape | Compound"]):
    """The shapes of a world in the order in which they were added; a compound is one of them, its parts are not."""

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def _all(self) -> list[Shape | Compound]:
        """What was added; a shape that has become part of a compound since is not one of them."""
        return [shape for shape in self._world._added.values() if getattr(shape, "compound", None) is None]

    def __len__(self) -> int:
        return len(self._all())

    @overload
    def __getitem__(self, index: int) -> Shape | Compound: ...
    @overload
    def __getitem__(self, index: slice) -> list[Shape | Compound]: ...
    def __getitem__(self, index: int | slice) -> Shape | Compound | list[Shape | Compound]:
        return self._all()[index]

    def __iter__(self) -> Iterator[Shape | Compound]:
        return iter(self._all())

    def __contains__(self, shape: object) -> bool:
        return any(shape is member for member in self._all())

    def __repr__(self) -> str:
        return f"<{len(self)} shapes>"
