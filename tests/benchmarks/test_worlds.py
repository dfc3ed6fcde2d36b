"""Tables side by side in one world are each the table that was merged."""

import numpy as np
import pytest

from benchmarks.engines import Carom
from benchmarks.pinball import pinball
from benchmarks.worlds import merge


def test_each_of_the_tables_in_one_world_is_the_table_alone() -> None:
    one, many = Carom(pinball()), Carom(merge(pinball(), 5))
    assert len(many.world.shapes) == 5 * len(one.world.shapes)
    start = many.state()[0]
    for _ in range(20):
        one.step()
        many.step()
    away = many.state()[0] - start
    assert len(np.unique(start, axis=0)) == 5
    assert away == pytest.approx(np.tile(one.state()[0] - start[:1], (5, 1)), abs=1e-9)
