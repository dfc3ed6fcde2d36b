"""The request reaches the processor, and changes nothing."""

import numpy as np
import pytest

from carom.compiler import door
from carom.rows.prefetch import prefetch
from carom.rows.saved import SAVED


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
