"""The regions of kinematic shapes as flights ask for them: how long they hold, and what is said where room runs out."""

from math import inf

import pytest

from carom.world.kernels.continuous.regions import rebuild_regions
from tests.kernel_calls import fleet, found_moving, prepare_regions, shape_index


def test_regions_hold_longer_after_each_renewal_without_an_event() -> None:
    arrays = fleet(0)
    state = arrays.states[0]
    spans = []
    for renewals in range(4):
        state["renewals"] = renewals
        prepare_regions(arrays)
        spans.append(float(state["valid"]) - 0.37)
    assert spans == pytest.approx([spans[0], 2 * spans[0], 4 * spans[0], 8 * spans[0]])
    state["renewals"] = 5000
    prepare_regions(arrays)
    assert state["valid"] == inf


def test_an_index_without_room_says_how_much_it_wants() -> None:
    arrays = fleet(1)
    everywhere = [found_moving(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)]
    arrays.cells, arrays.members = arrays.cells[:1].copy(), arrays.members[:1].copy()
    tables = arrays.balls.rows, arrays.shapes.rows, arrays.order
    assert not rebuild_regions(arrays.states[0], *tables, shape_index(arrays))
    assert arrays.states[0]["wanted_cells"] > 1
    prepare_regions(arrays)
    assert [found_moving(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)] == everywhere
