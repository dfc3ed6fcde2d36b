"""The regions of kinematic shapes as flights ask for them: how long they hold, and what is said where room runs out."""

from math import inf

import pytest

from carom import Circle, Point
from carom.rows.state import STALE
from carom.world.kernels.broad_phase.shape_index import QUARTERS, clear_towards, locate, quarter_of
from carom.world.kernels.continuous.regions import rebuild_regions
from tests.kernel_calls import fleet, found_moving, prepare_regions, shape_index
from tests.worlds import continuous_world


def test_regions_hold_longer_after_each_renewal_without_an_event() -> None:
    arrays = fleet(0)
    state = arrays.states[0]
    spans = []
    for renewals in range(4):
        state["renewals"], state["moving_stale"] = renewals, STALE
        prepare_regions(arrays)
        spans.append(float(state["valid"]) - 0.37)
    assert spans == pytest.approx([spans[0], 2 * spans[0], 4 * spans[0], 8 * spans[0]])
    state["renewals"], state["moving_stale"] = 5000, STALE
    prepare_regions(arrays)
    assert state["valid"] == inf


def test_regions_stand_until_they_hold_no_more_or_a_motion_changes() -> None:
    arrays = fleet(0)
    state = arrays.states[0]
    prepare_regions(arrays)
    now, valid = float(state["now"]), float(state["valid"])

    def valid_after(now: float, stale: int = 0) -> float:
        state["now"], state["moving_stale"] = now, stale
        prepare_regions(arrays)
        return float(state["valid"])

    assert valid_after(0.5 * (now + valid)) == valid
    assert valid_after(2.0 * valid) > 2.0 * valid
    assert valid_after(0.5 * (now + valid), STALE) not in (valid, inf)


def test_an_index_without_room_says_how_much_it_wants() -> None:
    arrays = fleet(1)
    everywhere = [found_moving(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)]
    arrays.states[0]["moving_stale"] = STALE
    arrays.cells, arrays.members = arrays.cells[:1].copy(), arrays.members[:1].copy()
    tables = arrays.balls.rows, arrays.shapes.rows, arrays.order
    assert not rebuild_regions(arrays.states[0], *tables, shape_index(arrays))
    assert arrays.states[0]["wanted_cells"] > 1
    prepare_regions(arrays)
    assert [found_moving(arrays, x, y) for x in range(-20, 21, 4) for y in range(-20, 21, 4)] == everywhere


def test_static_cells_are_measured_for_flights_and_again_where_a_shape_has_come() -> None:
    world = continuous_world(*(Circle((3.0 * k, 3.0 * j), 0.5) for k in (0, 1, 2, 3, 9, 10, 11) for j in range(12)))
    arrays = world._arrays
    arrays.prepare()
    prepare_regions(arrays)
    entry = arrays.index[0]
    assert entry["measured"]
    x, y = 18.0, 15.0
    cell = locate(entry, arrays.cells, x, y)
    assert min(clear_towards(arrays.cells[cell], quarter) for quarter in range(QUARTERS)) > 1
    world.add(Point((x, y)))
    arrays.prepare()
    prepare_regions(arrays)
    cell = locate(entry, arrays.cells, x, y)
    assert all(clear_towards(arrays.cells[cell], quarter) == 0 for quarter in range(QUARTERS))
    while arrays.cells[cell]["end"] > arrays.cells[cell]["begin"]:
        cell += 1
    assert clear_towards(arrays.cells[cell], quarter_of(rightwards=False, upwards=True)) == 1
