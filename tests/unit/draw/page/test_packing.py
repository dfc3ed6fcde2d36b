"""Columns of numbers as text: what a page reads out of them is what was put in."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from carom.draw.page.packing import measured, packed, sizes
from tests.unit.draw.page.unpacking import unpacked

WHOLE = st.integers(-(2**40), 2**40)


@given(arrays(np.int64, array_shapes(min_dims=2, max_dims=2, max_side=6), elements=WHOLE), st.integers(0, 3))
def test_whole_numbers_come_back(table: np.ndarray[Any, Any], order: int) -> None:
    assert np.array_equal(unpacked(packed(table, order)), table)


@pytest.mark.parametrize("number", [0, -1, 1, 63, 64, -64, -65, 8191, 8192, 2**52, -(2**52)])
def test_numbers_at_the_edges_of_bytes_come_back(number: int) -> None:
    assert unpacked(packed([number], 0)).tolist() == [[number]]


@pytest.mark.parametrize("shape", [(0, 0), (3, 0), (0, 5)])
def test_columns_of_nothing_are_columns(shape: tuple[int, int]) -> None:
    column = packed(np.zeros(shape, np.int64), 2)
    assert (column["rows"], column["length"]) == shape
    assert unpacked(column).shape == shape


def test_what_moves_evenly_takes_less_than_a_byte_for_each_place() -> None:
    places = np.round(np.outer([1.0, 3.7, -0.3], np.arange(10_000)) * 1234.567)
    assert len(packed(places, 2)["data"]) < 10_000


@given(arrays(np.float64, 5, elements=st.floats(-1e3, 1e3)), st.floats(-10.0, 10.0), st.floats(0.001, 10.0))
def test_measured_numbers_are_off_by_half_a_unit_at_most(
    values: np.ndarray[Any, Any], first: float, unit: float
) -> None:
    column = measured(values, first, unit, 1)
    back = column["first"] + column["unit"] * unpacked(column)[0]
    assert np.abs(back - values).max() <= 0.5000001 * unit


@given(arrays(np.float64, 6, elements=st.just(0.0) | st.floats(1e-6, 1e3)))
def test_sizes_come_back_to_a_thousandth_or_as_nothing(values: np.ndarray[Any, Any]) -> None:
    column = sizes(values)
    levels = unpacked(column)[0]
    assert levels.max() < 2**13
    back = np.where(levels > 0, column["largest"] * np.exp((levels - column["top"]) / column["fineness"]), 0.0)
    tiny = column["largest"] * np.exp(-column["top"] / column["fineness"])
    assert (np.abs(back - values) <= np.maximum(1.001e-3 * values, 1.001 * tiny)).all()


def test_sizes_of_nothing_are_nothing() -> None:
    assert unpacked(sizes(np.zeros(3))).tolist() == [[0, 0, 0]]
    assert unpacked(sizes(np.zeros(0))).size == 0
