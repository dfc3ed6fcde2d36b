"""A patched index of shapes has the cells and members of one that is made anew; what it cannot patch it says."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import carom
from carom.rows.state import QUADTREE
from carom.typing import Detection
from carom.world.kernels.broad_phase.patching import is_met_later, patch_index
from carom.world.kernels.broad_phase.shape_index import (
    QUARTERS,
    cell_span,
    clear_towards,
    comes_near,
    measure_clear,
    reach_of_cell,
)
from tests.kernel_calls import prepare_index
from tests.property.test_changes import cells_of, made_anew

RADIUS = 0.5


def field(detection: Detection = "discrete") -> carom.World:
    """Posts, walls and rings within a frame, in cells as wide as a ball, whatever their number."""
    world = carom.World(detection=detection)
    world.add(carom.Segment((-2, -2), (8, -2)), carom.Segment((-2, 8), (8, 8)))
    for k in range(12):
        x, y = 1.5 * (k % 4), 1.5 * (k // 4)
        world.add((carom.Point((x, y)), carom.Circle((x, y), 0.4), carom.Segment((x, y), (x + 1, y + 0.5)))[k % 3])
    world.add(carom.Ball((-1, -1), RADIUS))
    prepare_index(world, RADIUS)
    state = world._arrays.states[0]
    state["index_stale"], state["reach"] = 0, RADIUS
    return world


def patched(world: carom.World) -> bool:
    """Whether the index of a world could be patched."""
    arrays = world._arrays
    arrays.prepare()
    state = arrays.states[0]
    done = patch_index(
        state, arrays.shape_table.rows, arrays.order, arrays.index, arrays.cells, arrays.members
    )  # fmt: skip
    state["taken"] = state["put"] = 0
    return bool(done)


def test_what_comes_goes_and_moves_is_where_it_would_be() -> None:
    world = field()
    inner = list(world.shapes)[2:]
    world.remove(inner[3], inner[5])
    assert patched(world)
    measure_clear(world._arrays.index[0], world._arrays.cells)
    inner[0].position = (4.2, 3.1)
    inner[7].position = (0.2, 0.1)
    inner[7].position = (0.3, 0.1)
    world.add(carom.Point((2, 2)), carom.Arc((3, 3), 1.0, 0.0, 4.0))
    assert patched(world)
    found = cells_of(world._arrays)
    assert found == made_anew(world._arrays)
    assert sum(map(len, found[1])) > 50


def clear_of(world: carom.World) -> NDArray[np.int64]:
    """How wide squares without members are from each cell of the static shapes on, as it is written there."""
    entry = world._arrays.index[0]
    cells = world._arrays.cells[: int(entry["columns"]) * int(entry["lines"])]
    return np.array([[clear_towards(cell, quarter) for quarter in range(QUARTERS)] for cell in cells])


@pytest.mark.parametrize("gone", [0, 4])
def test_cells_know_how_near_what_has_come_is_and_never_say_more(gone: int) -> None:
    world = carom.World(detection="discrete")
    world.add(*(carom.Point((2.0 * k, 2.0 * j)) for k in (0, 1, 2, 3, 9, 10, 11, 12) for j in (0, 1, 2, 8, 9, 10)))
    world.add(carom.Ball((-1, -1), RADIUS))
    prepare_index(world, RADIUS)
    state, entry, cells = world._arrays.states[0], world._arrays.index[0], world._arrays.cells
    state["index_stale"], state["reach"] = 0, RADIUS
    measure_clear(entry, cells)
    before = clear_of(world)
    world.remove(*list(world.shapes)[20 : 20 + gone])
    world.add(carom.Point((12.0, 10.0)), carom.Segment((4.0, 12.0), (6.0, 8.0)), carom.Point((22.3, 8.7)))
    assert patched(world)
    now = clear_of(world)
    measure_clear(world._arrays.index[0], world._arrays.cells)
    exact = clear_of(world)
    assert (now <= exact).all()
    assert (now == exact).all() == (gone == 0)
    assert (now < before).sum() > 100


def test_one_of_many_at_the_edge_goes_and_comes_like_any_other() -> None:
    world = field()
    world.add(*(carom.Segment((-2, y), (-2, y + 1)) for y in range(-2, 8)), carom.Segment((8, -2), (8, 8)))
    prepare_index(world, RADIUS)
    world._arrays.states[0]["index_stale"] = 0
    patched(world)
    for change in (
        lambda: world.remove(world.shapes[0]),
        lambda: world.remove(world.shapes[-4]),
        lambda: world.add(carom.Segment((3, 8), (4, 8))),
    ):
        change()
        assert patched(world)
        assert cells_of(world._arrays) == made_anew(world._arrays)


def test_the_cells_are_laid_anew_where_the_outermost_goes_or_comes() -> None:
    for change in (
        lambda world: world.remove(world.shapes[0]),
        lambda world: world.add(carom.Point((9, 0))),
        lambda world: setattr(world.shapes[1], "position", (3, 7)),
        lambda world: world._arrays.states[0].__setitem__("broad_phase", QUADTREE) or world.remove(world.shapes[4]),
    ):
        world = field()
        change(world)
        assert not patched(world)


def test_flights_keep_their_cells_where_the_outermost_goes() -> None:
    world = field("continuous")
    measure_clear(world._arrays.index[0], world._arrays.cells)
    world.remove(world.shapes[0], world.shapes[1])
    assert patched(world)
    arrays, entry = world._arrays, world._arrays.index[0]
    rows, near = arrays.shapes.rows, reach_of_cell(entry)
    columns = int(entry["columns"])
    for place in range(columns * int(entry["lines"])):
        begin, end = cell_span(arrays.cells, place)
        line, column = divmod(place, columns)
        expected = [k for k in range(arrays.shapes.count) if comes_near(rows[k], entry, column, line, near)]
        assert sorted(arrays.members[begin:end].tolist()) == expected
    world.add(carom.Point((9, 0)))
    assert not patched(world)


def test_flights_have_other_cells_where_most_shapes_have_gone() -> None:
    world = carom.World(detection="continuous")
    world.add(*(carom.Point((k, k % 7)) for k in range(400)), carom.Ball((-1, -1), 1e-3))
    prepare_index(world, 1e-3)
    world._arrays.states[0]["index_stale"], world._arrays.states[0]["reach"] = 0, 1e-3
    world.remove(*list(world.shapes)[:100])
    assert patched(world)
    world.remove(*list(world.shapes)[:270])
    assert not patched(world)


def test_a_ball_goes_its_way_to_the_bit_in_the_cells_that_are_kept() -> None:
    world = carom.World(detection="continuous")
    posts = [carom.Circle((1.0 * k, 1.0 * j), 0.2) for k in range(12) for j in range(12)]
    far = [carom.Circle((-30, 5), 1), carom.Circle((40, 5), 1), carom.Circle((5, 40), 1), carom.Circle((5, -30), 1)]
    world.add(*posts, *far, carom.Ball((0.5, 0.5), 0.1, velocity=(1.0, 0.3)))
    world.run(5.0)
    met = 0
    for gone in far:
        other = carom.World()
        other.restore(world.snapshot())
        other.remove(other.object(gone.id))
        world.remove(gone)
        left = float(world._arrays.index[0]["left"])
        hits, same = world.run(5.0), other.run(5.0)
        assert world._arrays.index[0]["left"] == left
        assert hits.tobytes() == same.tobytes()
        assert world.digest() == other.digest()
        met += len(hits)
    assert met > 12


def test_so_they_are_where_there_is_no_room_for_more_members() -> None:
    world = field()
    arrays = world._arrays
    arrays.members = arrays.members[: int(arrays.index[0]["members_end"]) + 3].copy()
    world.add(carom.Circle((2, 2), 1.5))
    assert not patched(world)


@pytest.mark.parametrize(("row", "other", "later"), [(0, 1, False), (1, 0, True), (2, 1, True), (1, 2, False)])
def test_a_shape_is_met_after_those_of_lower_kinds_and_rows(row: int, other: int, later: bool) -> None:
    world = carom.World(detection="discrete")
    world.add(carom.Point((0, 0)), carom.Point((1, 0)), carom.Circle((0, 0), 1))
    assert is_met_later(world._arrays.shapes.rows, row, other) is later


def test_what_comes_moves_the_members_of_its_own_cells_alone() -> None:
    world = field()
    arrays = world._arrays
    cells = arrays.cells[: int(arrays.index[0]["cells_end"])]
    before = cells["begin"].copy()
    world.add(carom.Point((2, 2)))
    assert patched(world)
    row = arrays.shape_table.count - 1
    moved = cells[cells["begin"] != before]
    assert len(moved) > 0
    assert all(row in arrays.members[cell["begin"] : cell["end"]] for cell in moved)
