"""The grid of the broad phase: numbers of cells and levels."""

from math import inf, nan

import numpy as np

from carom.constants import CELL_CLAMP, CELL_SIDE, FINEST_LEVEL, GRID_CELLS_PER_BALL
from carom.rows.index import SLOT
from carom.world.kernels.broad_phase.grid import (
    boxes_meet,
    cell_of,
    count_ball,
    gap_between,
    grid_ahead,
    grid_size,
    lay_grid,
    level_of,
    wrapped_size,
)
from tests.kernel_calls import ball_rows, pairs_found_ahead, state_row


def test_a_cell_holds_its_lower_border() -> None:
    assert [cell_of(offset, 0.5) for offset in (0.0, 1.999, 2.0, -0.001, -2.0)] == [0, 0, 1, -1, -1]


def test_cells_are_clamped_in_order() -> None:
    most = int(CELL_CLAMP)
    assert [cell_of(offset, 1.0) for offset in (-inf, -1e300, 1e300, inf)] == [-most, -most, most, most]
    assert cell_of(nan, 1.0) == -most


def test_a_level_s_cells_are_as_wide_as_its_balls() -> None:
    side = 2.0 * CELL_SIDE
    assert level_of(2.0, side) == 0
    assert level_of(1.001, side) == 0
    assert [level_of(2.0 * 0.5**k, side) for k in range(5)] == [0, 1, 2, 3, 4]
    assert level_of(1e-300, side) == FINEST_LEVEL


def test_a_small_box_is_numbered_densely_and_a_large_one_wraps() -> None:
    size, stride, mask = grid_size(10.0, 6.0, 2.0, 100, GRID_CELLS_PER_BALL)
    assert (size, stride, mask) == (8 * 7, 8, -1)
    for width, height in ((1e9, 6.0), (6.0, 1e9), (inf, inf), (nan, nan)):
        size, stride, mask = grid_size(width, height, 2.0, 100, GRID_CELLS_PER_BALL)
        assert size == mask + 1 == 256
        assert 3 <= stride < size - 3
    assert wrapped_size(1_000_000)[0] <= 64 + 4_000_000


def test_nine_cells_around_one_have_nine_numbers_however_they_wrap() -> None:
    for count in (2, 50, 1000):
        size, stride, mask = wrapped_size(count)
        for centre in range(0, size, 7):
            around = [(x + stride * y) & mask for x in (-1, 0, 1) for y in (-1, 0, 1)]
            assert len({(centre + step) & mask for step in around}) == 9
            # None of the four that follow is one of the four before, or a pair would be found twice.
            assert len({(-step) & mask for step in around[5:]} & set(around[5:])) == 0


def test_no_grid_is_laid_ahead_for_balls_of_very_different_sizes() -> None:
    assert pairs_found_ahead(ball_rows([(0, 0, 1.0), (1, 0, 0.6)])) == [(0, 1)]
    assert pairs_found_ahead(ball_rows([(0, 0, 1.0), (1, 0, 0.4)])) is None


def test_a_ball_may_leave_a_grid_laid_ahead_by_its_width_and_not_by_much_more() -> None:
    rows = ball_rows([(0, 0, 1.0), (10, 10, 1.0)])
    state = state_row(rows, "grid", 6)
    slot, starts = np.zeros(1, SLOT)[0], np.zeros(256, "i4")
    for width in (4.0, 1e9):
        lay_grid(state, 0.0, 0.0, width, width, 1.0, 1.0)
        assert (state["grid_mask"] == -1) == (width == 4.0)
        for off, is_in in ((1.9, True), (1e10, False), (inf, False), (nan, False)):
            for x, y in ((-off, 0.0), (width + off, 0.0), (0.0, -off), (0.0, width + off)):
                slot["x"], slot["y"] = x, y
                assert count_ball(grid_ahead(state), slot, starts) is is_in
    lay_grid(state, 0.0, 0.0, 4.0, 4.0, 1.0, 1.0)
    for slot["x"] in (-2.1, 6.1):
        slot["y"] = 1.0
        assert not count_ball(grid_ahead(state), slot, starts)


def test_boxes_that_meet_have_no_gap_between_them_to_the_last_bit() -> None:
    random = np.random.default_rng(3)
    slots = np.zeros(400, SLOT)
    slots["radius"] = random.choice([0.1, 0.3, 0.7, 1e-300], 400)
    for name in ("x", "y"):
        slots[name] = random.choice([0.0, 0.1 + 0.3, 0.4, 0.7 + 0.3, 1.0, np.nextafter(1.0, 2.0), -1.4, 1e-300], 400)
    found = {True: 0, False: 0}
    for slot in slots:
        x, y, radius = float(slots[0]["x"]), 0.4, 0.3
        meet = bool(boxes_meet(slot, x, y, radius))
        assert (gap_between(slot, x, y, radius) <= 0.0) == meet
        found[meet] += 1
    assert min(found.values()) > 20
