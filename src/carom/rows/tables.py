"""Tables of rows, as kernels see them: arrays of one of the dtypes of this package."""

from __future__ import annotations

from typing import Any, Protocol, TypedDict, TypeVar

from numpy.typing import NDArray

#: Tables and rows where Python handles them as NumPy does; NumPy's typing cannot say which fields they have.
Rows = NDArray[Any]
Row = Any

T = TypeVar("T")


class Table(Protocol[T]):
    """A table whose rows have known fields."""

    def __getitem__(self, row: int, /) -> T: ...

    def __setitem__(self, row: int, value: T, /) -> None: ...

    def __len__(self) -> int: ...


class Pairs(Protocol):
    """A table of two whole numbers a row."""

    def __getitem__(self, place: tuple[int, int], /) -> int: ...

    def __setitem__(self, place: tuple[int, int], value: int, /) -> None: ...

    def __len__(self) -> int: ...


class Numbered(TypedDict):
    """What the rows of shapes and balls have in common."""

    id: int
    can_collide: int
    sensor: int
    layer: int
    collides_with: int
