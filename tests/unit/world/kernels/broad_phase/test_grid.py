"""The grid of the broad phase: numbers of cells and levels."""

from math import inf, nan

from carom.constants import CELL_CLAMP, CELL_SIDE, FINEST_LEVEL
from carom.world.kernels.broad_phase.grid import cell_of, grid_size, level_of, wrapped_size


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
    size, stride, mask = grid_size(10.0, 6.0, 2.0, 100)
    assert (size, stride, mask) == (8 * 7, 8, -1)
    for width, height in ((1e9, 6.0), (6.0, 1e9), (inf, inf), (nan, nan)):
        size, stride, mask = grid_size(width, height, 2.0, 100)
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
