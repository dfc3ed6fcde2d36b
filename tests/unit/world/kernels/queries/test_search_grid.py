"""The grid of queries: every item stands in each cell that it comes into, and in few others."""

from itertools import product
from math import hypot, inf, nan
from random import Random

import numpy as np
import pytest

import carom
from carom.constants import SEARCH_CELLS_PER_ITEM, SEARCH_MARKS_PER_ITEM
from carom.world.kernels.queries.search_grid import cell_width, cells_around, column_of, item_box, width_of_all
from carom.world.search import Grid, grid_of
from tests.kernel_calls import prepared
from tests.worlds import world_of


def scattered(seed: int, long: float) -> carom.World:
    """Shapes and balls all over the place, with sizes up to `long`."""
    random = Random(seed)

    def place() -> tuple[float, float]:
        return random.uniform(-20, 20), random.uniform(-5, 5)

    world = carom.World()
    for _ in range(12):
        (x, y), size = place(), long * random.random() + 0.01
        turn = random.uniform(0, 6)
        world.add(carom.Segment((x, y), (x + size, y + random.uniform(-size, size))))
        world.add(carom.Circle(place(), size, solid=random.random() < 0.5))
        world.add(carom.Arc(place(), size, turn, (turn + random.uniform(0.1, 6)) % 6.28))
        world.add(carom.Point(place()))
        world.add(carom.Ball(place(), size))
    return world


def grid_over(world: carom.World) -> Grid:
    """A grid over all that is in a world."""
    arrays = prepared(world)
    items = np.append(np.arange(arrays.shapes.count), np.arange(-1, -1 - arrays.balls.count, -1)).astype("i4")
    return grid_of(arrays, items)


def outline_of(member: carom.Shape | carom.Ball, count: int = 200) -> list[tuple[float, float]]:
    """Places of a shape or a ball, inside of what is solid too."""
    box = member.aabb
    places = product(np.linspace(box.left, box.right, count), np.linspace(box.bottom, box.top, count // 4))
    if isinstance(member, carom.Ball):
        (x, y), radius = member.position, member.radius
        return [place for place in places if hypot(place[0] - x, place[1] - y) <= radius]
    return [member.closest_point(place) for place in places]


@pytest.mark.parametrize(("seed", "long"), [(1, 0.5), (2, 5.0), (3, 30.0)])
def test_an_item_stands_in_every_cell_that_it_comes_into(seed: int, long: float) -> None:
    world = scattered(seed, long)
    grids, starts, members = grid_over(world)
    grid, arrays = grids[0], world._arrays
    columns, lines, side = int(grid["columns"]), int(grid["lines"]), float(grid["side"])
    everyone = [*enumerate(world.shapes), *((-1 - k, ball) for k, ball in enumerate(world.balls))]
    for item, member in everyone:
        for x, y in outline_of(member, 40):
            column, line = int((x - grid["left"]) / side), int((y - grid["bottom"]) / side)
            cell = min(line, lines - 1) * columns + min(column, columns - 1)
            assert item in members[starts[cell] : starts[cell + 1]]
        left, bottom, right, top = item_box(arrays.shapes.rows, arrays.balls.rows, item)
        assert (left, bottom, right, top) == tuple(member.aabb)
    count = len(everyone)
    assert columns * lines <= 3 * SEARCH_CELLS_PER_ITEM * count + 1
    assert starts[columns * lines] <= (SEARCH_MARKS_PER_ITEM + 1) * count


def test_what_has_no_finite_box_is_in_no_cell() -> None:
    world = world_of(*(carom.Ball((float(k), 0), 0.1) for k in range(5)))
    world.balls.position[1:3] = [(nan, 0), (0, inf)]
    _, starts, members = grid_over(world)
    assert set(members[: starts[starts > 0].max()].tolist()) == {-1, -4, -5}
    assert width_of_all(world._arrays.shapes.used, world._arrays.balls.used) == pytest.approx(4.2 + 0.2)


def test_cells_are_as_narrow_as_they_may_be() -> None:
    # Many small boxes: as many cells as there may be. Large ones: no more marks than there is room for.
    assert cell_width(100.0, 1.0, 100, 0.0, 0.0) == pytest.approx(0.5)
    side = cell_width(1.0, 1.0, 100, 100 * 2.0, 100 * 1.0)
    assert 100 * (1 / side + 2) ** 2 <= SEARCH_MARKS_PER_ITEM * 100 * (1 + 1e-12)
    assert (cell_width(0.0, 0.0, 0, 0.0, 0.0), cell_width(0.0, 0.0, 1, 0.0, 0.0)) == (1.0, 1e300)


def test_a_box_beside_the_grid_comes_into_no_cell_and_one_across_it_into_all() -> None:
    grid = grid_over(scattered(1, 1.0))[0][0]
    columns, lines = int(grid["columns"]), int(grid["lines"])
    assert cells_around(grid, -1e9, -1e9, 1e9, 1e9, 0.0) == (0, columns - 1, 0, lines - 1)
    assert cells_around(grid, 1e3, -1e9, 1e9, 1e9, 0.0) == (0, -1, 0, -1)
    assert [column_of(offset, 2.0, 9) for offset in (-1.0, 0.0, 1.9, 2.0, 1e300)] == [0, 0, 0, 1, 9]
