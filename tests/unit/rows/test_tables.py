"""Rows: the dtype of a table follows from the class that says what a row holds, and has no padding."""

import importlib
import pkgutil
from typing import ForwardRef, TypedDict

import numpy as np

from carom import rows
from carom.rows.tables import dtype_of, f8, f8x2, i4, i8, u1, u4


class EveryRow(TypedDict):
    """A row with a field of every type."""

    a: f8
    b: i8
    c: i4
    d: u4
    e: u1
    f: f8x2


def dtypes() -> dict[str, np.dtype[np.void]]:
    """The dtypes of all rows, by the modules that they stand in."""
    modules = [importlib.import_module(f"carom.rows.{module.name}") for module in pkgutil.iter_modules(rows.__path__)]
    return {
        f"{module.__name__}.{name}": value
        for module in modules
        for name, value in vars(module).items()
        if isinstance(value, np.dtype)
    }


def test_a_field_has_the_name_and_the_type_that_its_class_says_in_the_same_order() -> None:
    expected = [("a", "f8"), ("b", "i8"), ("c", "i4"), ("d", "u4"), ("e", "u1"), ("f", "f8", (2,))]
    assert dtype_of(EveryRow) == np.dtype(expected)


def test_rows_name_their_types_outright_for_texts_would_be_compiled_and_evaluated_on_import() -> None:
    modules = [importlib.import_module(f"carom.rows.{module.name}") for module in pkgutil.iter_modules(rows.__path__)]
    found = [value for module in modules for name, value in vars(module).items() if name.endswith("Row")]
    assert len(found) > 10
    for row in found:
        assert not any(isinstance(kind, str | ForwardRef) for kind in row.__annotations__.values()), row


def test_no_row_has_padding() -> None:
    found = dtypes()
    assert {"carom.rows.ball.BALL", "carom.rows.shape.SHAPE", "carom.rows.hit.HIT_ROW"} <= found.keys()
    for name, dtype in found.items():
        assert dtype.itemsize == sum(dtype[field].itemsize for field in dtype.names or ()), name


def test_kernels_write_hits_into_the_very_bytes_that_users_read() -> None:
    hit, row = (dtypes()[f"carom.rows.hit.{name}"] for name in ("HIT", "HIT_ROW"))
    assert hit.itemsize == row.itemsize
    hits = np.arange(hit.itemsize // 8, dtype=float).view(hit)
    assert hits["point"].tolist() == [[hits.view(row)["point_x"][0], hits.view(row)["point_y"][0]]]
    assert hits["normal"].tolist() == [[hits.view(row)["normal_x"][0], hits.view(row)["normal_y"][0]]]
    assert hits["impulse"].tolist() == hits.view(row)["impulse"].tolist()
