"""Tables of rows, as kernels see them: arrays of one of the dtypes of this package."""

from __future__ import annotations

from typing import Annotated, Any, Protocol, TypedDict, TypeVar, get_type_hints

import numpy as np
from numpy.typing import NDArray

#: Tables and rows where Python handles them as NumPy does; NumPy's typing cannot say which fields they have.
Rows = NDArray[Any]
Row = Any

#: Bytes of a line of memory, all of which comes near at once, on most processors.
LINE = 64

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


# The types of fields: what a kernel sees, and what NumPy stores.
f8 = Annotated[float, "f8"]
i8 = Annotated[int, "i8"]
i4 = Annotated[int, "i4"]
i2 = Annotated[int, "i2"]
u4 = Annotated[int, "u4"]
u1 = Annotated[int, "u1"]
f8x2 = Annotated[Table[float], "f8", (2,)]


def dtype_of(row: type) -> np.dtype[Any]:
    """The dtype of tables whose rows are as a class says, all of whose fields are of the types above."""
    fields = get_type_hints(row, include_extras=True)
    return np.dtype([(name, *field.__metadata__) for name, field in fields.items()])


def dtype_in_order(row: type, order: str) -> np.dtype[Any]:
    """The same with its fields in another order, whose names stand between spaces."""
    found = dtype_of(row)
    return np.dtype([(name, found[name]) for name in order.split()])


class Numbered(TypedDict):
    """What the rows of shapes and balls have in common."""

    id: int
    elasticity: float
    can_collide: int
    sensor: int
    layer: int
    collides_with: int
