"""The request reaches the processor, and changes nothing."""

import re

import numpy as np
import pytest

from carom.compiler import door
from carom.rows.flight import FLIGHT
from carom.rows.prefetch import prefetch, prefetch_lines
from carom.rows.saved import SAVED
from carom.rows.tables import LINE


@pytest.mark.compiled
def test_prefetch_tells_the_processor_and_changes_nothing() -> None:
    numba = pytest.importorskip("numba")
    door.register_once(numba)
    kernel = numba.njit(lambda table, place: prefetch(table, place))
    table = np.arange(5)
    kernel(table, 3)
    kernel(table, 5000)
    assert "prefetch" in next(iter(kernel.inspect_asm().values()))
    assert table.tolist() == [0, 1, 2, 3, 4]
    assert prefetch(table, 5000) is None  # type: ignore[func-returns-value]
    rows = np.zeros(3, SAVED)
    kernel(rows, 2)
    assert rows.tobytes() == np.zeros(3, SAVED).tobytes()


@pytest.mark.compiled
@pytest.mark.parametrize("count", [1, 3, FLIGHT.itemsize // LINE])
def test_of_a_row_so_many_lines_are_told(count: int) -> None:
    numba = pytest.importorskip("numba")
    door.register_once(numba)
    kernel = numba.njit(lambda table, place: prefetch_lines(table, place, count))
    rows = np.zeros(3, FLIGHT)
    kernel(rows, 2)
    kernel(rows, 5000)
    told = re.findall(r"prefetch\w*\s+(-?\d*)\(", next(iter(kernel.inspect_asm().values())))
    begin = int(told[0] or 0)
    assert [int(place or 0) - begin for place in told] == [LINE * line for line in range(count)]
    assert rows.tobytes() == np.zeros(3, FLIGHT).tobytes()
    assert prefetch_lines(rows, 5000, count) is None  # type: ignore[func-returns-value]
