"""A patched index of shapes has the cells and members of one that is made anew; what it cannot patch it says."""

from __future__ import annotations

import pytest

import carom
from carom.rows.state import QUADTREE
from carom.world.kernels.broad_phase.patching import is_met_later, patch_index
from tests.kernel_calls import prepare_index
from tests.property.test_changes import cells_of, made_anew

RADIUS = 0.5


def field() -> carom.World:
    """Posts, walls and rings within a frame, in cells as wide as a ball, whatever their number."""
    world = carom.World()
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
    inner[0].position = (4.2, 3.1)
    inner[7].position = (0.2, 0.1)
    inner[7].position = (0.3, 0.1)
    world.add(carom.Point((2, 2)), carom.Arc((3, 3), 1.0, 0.0, 4.0))
    assert patched(world)
    found = cells_of(world._arrays)
    assert found == made_anew(world._arrays)
    assert sum(map(len, found[1])) > 50


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


def test_so_they_are_where_there_is_no_room_for_more_members() -> None:
    world = field()
    arrays = world._arrays
    arrays.members = arrays.members[: int(arrays.index[0]["members_end"]) + 3].copy()
    world.add(carom.Circle((2, 2), 1.5))
    assert not patched(world)


@pytest.mark.parametrize(("row", "other", "later"), [(0, 1, False), (1, 0, True), (2, 1, True), (1, 2, False)])
def test_a_shape_is_met_after_those_of_lower_kinds_and_rows(row: int, other: int, later: bool) -> None:
    world = carom.World()
    world.add(carom.Point((0, 0)), carom.Point((1, 0)), carom.Circle((0, 0), 1))
    assert is_met_later(world._arrays.shapes.rows, row, other) is later
