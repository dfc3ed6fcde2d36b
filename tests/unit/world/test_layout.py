"""The layout of shapes: kept up as they come, go and move, it is what it would be if it were made anew."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import carom
from carom.rows.shape import KINEMATIC, STATIC
from carom.rows.state import STALE, STATE
from carom.world.layout import LEAST_SLACK, MOST_CHANGES, MOST_GONE, Layout

KINDS = (carom.Point((0, 0)), carom.Segment((0, 0), (1, 0)), carom.Circle((0, 0), 1), carom.Arc((0, 0), 1, 0, 1))


def rows_of(count: int, seed: int) -> Any:
    """Rows of shapes of any kind, some of them kinematic."""
    random = np.random.default_rng(seed)
    rows = np.array([KINDS[k]._row for k in random.integers(0, 4, count)])
    rows["motion"] = random.random(count) < 0.2
    rows["id"] = np.arange(1, count + 1)
    return rows


def laid(layout: Layout, rows: Any) -> tuple[list[int], Any]:
    """The order that a layout has, and what it tells of it."""
    state = np.zeros(1, STATE)[0]
    behind = layout.lay(rows, state)
    room = np.concatenate([rows, np.zeros(behind, rows.dtype)])
    layout.tell(room)
    # Behind the shapes there is room for the kinematic ones that move.
    order = layout.order.tolist()
    return order[: len(rows)] + order[len(rows) + len(layout.moving) :], state


def test_shapes_are_ordered_by_motion_and_kind_and_row() -> None:
    rows = rows_of(40, 1)
    order, state = laid(Layout(), rows)
    assert order == np.lexsort((rows["kind"], rows["motion"])).tolist()
    assert (state["dropped"], state["fixed"], state["index_stale"]) == (0, (rows["motion"] == 0).sum(), 1)


def assert_as_made_anew(layout: Layout, rows: Any, order: list[int]) -> None:
    """What is gone stands first in an order, and all others as they would in one that is made anew."""
    gone = sorted(layout.gone)
    alive = np.delete(np.arange(len(rows)), gone)
    expected = alive[np.lexsort((rows["kind"][alive], rows["motion"][alive]))]
    assert sorted(order[: len(gone)]) == gone
    assert order[len(gone) : len(rows)] == expected.tolist()


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("motion", [STATIC, KINEMATIC])
def test_what_comes_and_goes_leaves_the_order_of_one_that_is_made_anew(motion: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    rows, layout = rows_of(60, seed), Layout()
    rows["motion"][:20] = motion
    laid(layout, rows)
    # More than the room that there is before and behind what the order began with.
    for _ in range(2 * LEAST_SLACK // 3):
        there = [row for row in np.flatnonzero(rows["motion"] == motion).tolist() if row not in layout.gone]
        layout.note_gone(random.choice(there, 3, replace=False).tolist(), [motion] * 3)
        come = rows_of(5, seed + 100)
        come["motion"] = motion
        rows = np.concatenate([rows, come])
        layout.note_come(range(len(rows) - 5, len(rows)), [motion] * 5)
        order, state = laid(layout, rows)
        assert_as_made_anew(layout, rows, order)
        assert state["index_stale"] == 0
        told = (3, 5, 0) if motion == STATIC else (0, 0, STALE)
        assert (state["taken"], state["put"], state["moving_stale"]) == told
        assert (state["dropped"], state["fixed"]) == (len(layout.gone), len(rows) - len(layout.moving))


def test_what_moves_otherwise_goes_from_one_listing_to_the_other() -> None:
    rows, layout = rows_of(40, 4), Layout()
    rows["motion"] = np.arange(40) % 2
    before = rows.copy()
    laid(layout, rows)
    for row in (4, 7, 10, 7):
        rows["motion"][row] = 1 - rows["motion"][row]
        layout.note_other_motion(row, before[row], int(rows["motion"][row]))
        before[row] = rows[row]
    layout.note_gone([10], [KINEMATIC])
    order, state = laid(layout, rows)
    assert_as_made_anew(layout, rows, order)
    # The second time row 7 became kinematic again, which it was when the index was made.
    assert (state["taken"], state["put"], state["index_stale"], state["moving_stale"]) == (2, 0, 0, STALE)


def test_a_kinematic_shape_that_comes_or_goes_leaves_the_order_of_the_static_ones_where_it_is() -> None:
    rows, layout = rows_of(60, 5), Layout()
    rows["motion"][:30] = STATIC
    _, state = laid(layout, rows)
    static, mover = layout.order[: int(state["fixed"])], int(layout.moving[0])
    layout.note_gone([mover], [KINEMATIC])
    order, state = laid(layout, rows)
    assert_as_made_anew(layout, rows, order)
    kept = layout.order[1 : int(state["fixed"])]
    assert kept.ctypes.data == static.ctypes.data
    assert len(kept) == len(static)


def test_those_that_move_stay_listed_where_static_shapes_alone_change() -> None:
    rows, layout = rows_of(60, 6), Layout()
    state = np.zeros(1, STATE)[0]
    layout.lay(rows, state)
    layout.tell(rows)
    assert layout.has_other_movers
    movers = layout.moving[:3].tolist()
    state["movers"] = 3
    layout.order[60:63] = movers
    layout.note_gone(np.flatnonzero(rows["motion"] == STATIC)[:2].tolist(), [STATIC] * 2)
    layout.lay(rows, state)
    layout.tell(rows)
    assert not layout.has_other_movers
    assert (layout.order[60:63].tolist(), state["movers"]) == (movers, 3)
    new = (np.cumsum(~np.isin(np.arange(60), layout.gone)) - 1).astype("i4")
    order = layout.order
    assert layout.renumber(new, 3)
    assert layout.order.ctypes.data == order.ctypes.data
    assert layout.order[58:61].tolist() == new[movers].tolist()


def test_kernels_are_told_what_to_change_and_by_which_geometry() -> None:
    rows, layout = rows_of(10, 3), Layout()
    rows["motion"] = 0
    laid(layout, rows)
    before = rows[4].copy()
    before["cx"] = 77.0
    layout.note_moved(4, before)
    layout.note_moved(4, rows[4])  # moved again: what the index knows is the first place
    layout.note_gone([7], [STATIC])
    layout.note_moved(2, before)
    layout.note_gone([2], [STATIC])
    state = np.zeros(1, STATE)[0]
    behind = layout.lay(rows, state)
    room = np.concatenate([rows, np.zeros(behind, rows.dtype)])
    layout.tell(room)
    told = layout.order[10:].tolist()
    assert (state["taken"], state["put"]) == (3, 1)
    taken, geometries, put = told[:3], told[3:6], told[6:]
    assert (taken, put) == ([4, 7, 2], [4])
    assert [room[row]["cx"] for row in geometries] == [77.0, room[7]["cx"], 77.0]


def test_what_has_come_and_gone_between_two_steps_was_never_there() -> None:
    rows, layout = rows_of(10, 3), Layout()
    rows["motion"] = 0
    laid(layout, rows[:8])
    layout.note_come([8, 9], [STATIC] * 2)
    layout.note_gone([9], [STATIC])
    order, state = laid(layout, rows)
    assert (order[0], state["taken"], state["put"], state["dropped"]) == (9, 0, 1, 1)


def test_many_changes_are_forgotten_for_the_order_is_made_anew_then() -> None:
    layout = Layout()
    laid(layout, rows_of(10, 1))
    layout.note_come(range(10, 11 + MOST_CHANGES), [STATIC] * (MOST_CHANGES + 1))
    assert not layout.is_known
    assert not layout.is_full(10)
    layout.gone = list(range(MOST_GONE + 1))
    assert layout.is_full(10)
    assert not layout.is_full(10 * MOST_GONE)


def test_a_change_that_no_step_came_to_is_not_lost() -> None:
    worlds = []
    for refused in (True, False):
        world = carom.World(substeps=1)
        posts = world.add(*(carom.Point((x, y)) for x in range(5) for y in range(5)))
        ball = world.add(carom.Ball((1.5, 1.5), 0.3, velocity=(1, 0)))
        world.step(0.1)
        world.remove(posts[12])
        if refused:
            world.balls.velocity[0, 0] = np.nan
            with pytest.raises(carom.NonFiniteState):
                world.step(0.1)
            ball.velocity = (1, 0)
        world.run(0.5, 0.1)
        worlds.append(world)
    assert worlds[0].digest() == worlds[1].digest()
