"""Structured arrays that name shapes and balls by ids.

What hits, of a world or of a recording, and the answers to many queries have in common.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from copy import deepcopy
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Self, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from carom.errors import LostObject
from carom.pictured import Tabled
from carom.rows.tables import Rows, Table
from carom.shapes.label import label_of
from carom.typing import Vector
from carom.world.link import Link

if TYPE_CHECKING:
    from carom.world.world import World

T = TypeVar("T")


class MemberRows(np.ndarray[Any, np.dtype[Any]], Tabled):
    """Rows of dtype `DTYPE`, and what those are called whose ids stand in them. Columns are plain arrays."""

    DTYPE: ClassVar[np.dtype[Any]]

    def _are_rows(self) -> bool:
        """Whether these are rows still, and not what a view or `astype` made of them."""
        return self.dtype == self.DTYPE

    def __getitem__(self, key: Any) -> Any:
        item = super().__getitem__(key)
        return item if isinstance(item, np.void) or getattr(item, "dtype", None) == self.DTYPE else np.asarray(item)

    def _label(self, member_id: int) -> str:
        """What to call the shape or ball with an id; the id where it is not known any more."""
        raise NotImplementedError


class Plural(MemberRows, Generic[T]):
    """Rows whose items are objects: a single index and iteration give those.

    It is false where it has no rows. Whatever NumPy computes of rows is a plain array. Copied or pickled together with
    its world it speaks of the new world; pickled alone it is an array, whose items raise `LostObject`.
    """

    _link: Link | None = None

    @classmethod
    def of(cls, world: World, rows: Rows) -> Self:
        """What `world` says, from rows of dtype `DTYPE`."""
        plural = rows.view(cls)
        plural._link = world._link
        return plural

    def __array_finalize__(self, source: Any) -> None:
        if source is not None:
            self._link = getattr(source, "_link", None)

    @property
    def _world(self) -> World:
        """The world that the rows are of; raises `LostObject` where it is not known."""
        world = None if self._link is None else self._link.world
        if world is None:
            raise LostObject(
                f"these {type(self).__name__} do not know their world: pickle both in one, as (world, hits), or read"
                " them as an array, where shapes and balls are ids"
            )
        return world

    def __reduce__(self) -> Any:
        make, arguments, state, *_ = tuple(super().__reduce__())
        return make, arguments, (state, self.__dict__)

    def __setstate__(self, state: Any) -> None:
        """Make this what was pickled."""
        rows, attributes = state
        super().__setstate__(rows)
        self.__dict__.update(attributes)

    def __deepcopy__(self, memo: dict[int, Any] | None = None) -> Any:
        memo = {} if memo is None else memo
        twin = super().__deepcopy__(memo)
        memo[id(self)] = twin
        twin.__dict__.update(deepcopy(self.__dict__, memo))
        return twin

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        """A result of NumPy's, no longer rows: `hits == hits` is an array of booleans."""
        return array[()] if return_scalar else array

    def __bool__(self) -> bool:
        return self.size > 0 if self._are_rows() else super().__bool__()

    def __iter__(self) -> Iterator[T]:  # type: ignore[override]
        rows = self.view(np.ndarray)
        return map(self._item, rows) if self._are_rows() and self.ndim == 1 else iter(rows)

    @overload  # type: ignore[override]
    def __getitem__(self, key: int | np.integer[Any]) -> T: ...
    @overload
    def __getitem__(self, key: str | list[str]) -> NDArray[Any]: ...
    @overload
    def __getitem__(
        self, key: slice | NDArray[np.bool_] | NDArray[np.integer[Any]] | Sequence[bool] | Sequence[int]
    ) -> Self: ...
    def __getitem__(self, key: Any) -> Any:
        item = super().__getitem__(key)
        return self._item(item) if isinstance(item, np.void) else item

    def _item(self, row: Any) -> T:
        """The object for a row."""
        return self._object(self._world, row)

    def _object(self, world: World, row: Any) -> T:
        """The object for a row of a world's; None for one that says that nothing was found."""
        raise NotImplementedError

    def _member(self, world: World, member_id: int) -> Any:
        """The shape or ball with an id; None where there is none."""
        return world._object_of_hit(member_id, None)

    def _label(self, member_id: int) -> str:
        found = None
        with suppress(LostObject):
            found = self._member(self._world, member_id)
        return f"{member_id}" if found is None else label_of(found)


class OfHits(Plural[T]):
    """Rows that name balls which may have left the world since: they are found among the rows `gone`."""

    _gone: Rows | None = None

    @classmethod
    def of(cls, world: World, rows: Rows, gone: Rows | None = None) -> Self:
        """What `world` says, from rows of dtype `DTYPE`; `gone` holds the rows of balls that were removed meanwhile."""
        plural = super().of(world, rows)
        plural._gone = gone
        return plural

    def __array_finalize__(self, source: Any) -> None:
        if source is not None:
            super().__array_finalize__(source)
            self._gone = getattr(source, "_gone", None)

    def _member(self, world: World, member_id: int) -> Any:
        """The shape or ball with an id; None where it left long ago and nobody kept it."""
        return world._object_of_hit(member_id, self._gone)


def vector(pair: Table[float]) -> Vector:
    """A pair of a row as a tuple of floats."""
    return float(pair[0]), float(pair[1])
