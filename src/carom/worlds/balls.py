"""`worlds.balls`: the balls of all copies as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from carom.rows.ball import BALL
from carom.turns import having
from carom.worlds.keeping import lent_columns

if TYPE_CHECKING:
    from carom.worlds.worlds import Worlds


class CopiesOfBalls:
    """The balls of all copies, in the order in which they were added: arrays whose first axis is that of the copies.

    All are views, without a copy; what is written to them acts at once, and is checked when the next step begins. They
    are valid until a copy needs more room, so take them anew after each step. While copies are stepped nobody may write
    to them. What a ball has that is not in play means nothing.
    """

    __slots__ = ("_worlds",)

    def __init__(self, worlds: Worlds) -> None:
        self._worlds = worlds

    def __len__(self) -> int:
        """The number of balls of each copy."""
        return len(self._worlds._common.ids)

    def __repr__(self) -> str:
        return f"<{len(self)} balls in each of {len(self._worlds)} worlds>"

    def _pairs(self, field: str) -> NDArray[np.float64]:
        """Two columns that stand side by side."""
        rows = self._worlds._common.memory.balls
        first = BALL.fields[field][1]  # type: ignore[index]
        whole = rows.view(np.uint8).reshape(*rows.shape, BALL.itemsize)
        return whole[..., first : first + 16].view(np.float64)

    def _column(self, field: str, dtype: type[np.generic]) -> NDArray[Any]:
        """A column, noted as it is now, for it may be written to from now on."""
        return having(self._worlds, self._lent, field, dtype)

    def _lent(self, field: str, dtype: type[np.generic]) -> NDArray[Any]:
        """The column, with all copies to itself."""
        worlds = self._worlds
        if worlds._lent is None:
            worlds._lent = lent_columns(worlds._common.memory)
        column: NDArray[Any] = worlds._common.memory.balls[field].view(dtype)
        return column

    @property
    def position(self) -> NDArray[np.float64]:
        """Centres, of shape (copies, balls, 2)."""
        return self._pairs("x")

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities in length/s, of shape (copies, balls, 2)."""
        return self._pairs("vx")

    @property
    def radius(self) -> NDArray[np.float64]:
        """Radii, positive, of shape (copies, balls)."""
        return self._column("radius", np.float64)

    @property
    def mass(self) -> NDArray[np.float64]:
        """Masses, positive, of shape (copies, balls)."""
        return self._column("mass", np.float64)

    @property
    def elasticity(self) -> NDArray[np.float64]:
        """Elasticities, 0 or more, of shape (copies, balls)."""
        return self._column("elasticity", np.float64)

    @property
    def friction(self) -> NDArray[np.float64]:
        """Frictions in length/s², 0 or more, or -1 where it is the world's, of shape (copies, balls)."""
        return self._column("friction", np.float64)

    @property
    def layer(self) -> NDArray[np.uint32]:
        """The layers that each is on, masks of 32 bits, of shape (copies, balls)."""
        return self._column("layer", np.uint32)

    @property
    def collides_with(self) -> NDArray[np.uint32]:
        """The layers that each meets, masks of 32 bits, of shape (copies, balls)."""
        return self._column("collides_with", np.uint32)

    @property
    def sensor(self) -> NDArray[np.bool_]:
        """Whether each only reports what overlaps it, of shape (copies, balls)."""
        return self._column("sensor", np.bool_)

    @property
    def can_collide(self) -> NDArray[np.bool_]:
        """Whether each meets anything at all, of shape (copies, balls)."""
        return self._column("can_collide", np.bool_)

    @property
    def in_play(self) -> NDArray[np.bool_]:
        """Whether each takes part, of shape (copies, balls): one that does not is not moved, and met by nothing.

        To take one out is to remove it from its world: a sensor that it was inside of gives an `EXIT`. One that is put
        in is where its row says, awake. The change acts at the next step; it takes a copy some tenths of a millisecond.
        """
        return having(self._worlds, self._lent_mask)

    def _lent_mask(self) -> NDArray[np.bool_]:
        """The mask, with all copies to itself."""
        worlds = self._worlds
        if worlds._in_play is None:
            worlds._in_play = worlds._common.memory.in_play.copy()
        return worlds._common.memory.in_play

    @property
    def asleep(self) -> NDArray[np.bool_]:
        """Whether each sleeps, of shape (copies, balls); read-only."""
        column: NDArray[np.bool_] = self._worlds._common.memory.balls["asleep"].view(np.bool_)
        column.flags.writeable = False
        return column

    @property
    def id(self) -> NDArray[np.int64]:
        """Ids, the same in all copies, of shape (balls,), ascending; a copy."""
        return self._worlds._common.ids.copy()
