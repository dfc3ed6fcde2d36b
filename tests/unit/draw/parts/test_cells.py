"""The cells of the broad phase as they are drawn."""

import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.parts.cells import cells_of, cut, partition_of
from carom.shapes.aabb import Aabb
from carom.world.kernels.broad_phase.shape_index import FIXED
from tests.kernel_calls import found_shapes, prepare_index
from tests.unit.draw.svg_marks import SVG, marks_of, of_world, words_in
from tests.worlds import crowded


@pytest.mark.parametrize("broad_phase", ["grid", "quadtree"])
def test_every_shape_lies_in_cells(broad_phase: str) -> None:
    world = crowded(broad_phase=broad_phase)
    scene = carom.Scene.from_world(world)
    cells = cells_of(scene, 0.4)
    assert len(cells) > 10
    assert all(cell.shapes > 0 for cell in cells)
    for shape in scene.build().shapes:
        if not isinstance(shape, carom.Compound) and shape.motion == carom.Motion.STATIC:
            x, y = shape.position
            on_it = shape.p0 if isinstance(shape, carom.Arc) else (x, y)
            on_it = (x + shape.radius, y) if isinstance(shape, carom.Circle) else on_it
            assert any(holds(cell.box, on_it) for cell in cells), shape


def holds(box: Aabb, point: tuple[float, float]) -> bool:
    """Whether a point is in a box."""
    return box.left <= point[0] <= box.right and box.bottom <= point[1] <= box.top


def test_brute_force_has_no_cells_and_the_picture_says_so() -> None:
    marks = of_world(crowded(broad_phase="brute"), Layer.CELLS, Layer.SHAPES)
    assert marks["cells"] == []
    assert any("There are no cells" in line for line in words_in(marks["panel"]))
    assert "cell of the broad phase" not in words_in(marks["panel"])


def test_cells_end_at_the_stage() -> None:
    picture = draw.picture_of(crowded(), "name", layers=[Layer.CELLS])
    for mark in marks_of(picture)["cells"]:
        if mark.tag == f"{SVG}polygon":
            x = [float(number) for number in mark.get("points").split()[::2]]
            assert min(x) >= picture.frame.stage_left - 0.01
            assert max(x) <= picture.frame.panel_left


def test_drawing_cells_leaves_the_world_as_it_is() -> None:
    world = crowded()
    world.run(0.1)
    before = world.snapshot()
    of_world(world, *Layer)
    assert world.snapshot() == before


@pytest.mark.slow
@pytest.mark.parametrize("broad_phase", ["grid", "quadtree"])
def test_cells_are_those_in_which_a_step_finds_shapes(broad_phase: str) -> None:
    world = crowded(broad_phase=broad_phase)
    for cell in partition_of(world).cells:
        x, y = 0.5 * (cell.box.left + cell.box.right), 0.5 * (cell.box.bottom + cell.box.top)
        prepare_index(world, float(world.balls.radius.max()))
        assert len(found_shapes(world, FIXED, x, y)) == cell.shapes


def test_a_quadtree_has_leaves_and_nodes_and_a_grid_has_cells_alone() -> None:
    tree, grid = (partition_of(crowded(broad_phase=phase)) for phase in ("quadtree", "grid"))
    assert tree.nodes == 4 * (tree.leaves - 1) // 3 + 1  # each node has four children or none
    assert tree.leaves >= len(tree.cells) > 0
    assert (grid.nodes, grid.leaves >= len(grid.cells) > 0) == (0, True)


def test_a_cell_is_cut_at_the_stage_or_left_out() -> None:
    stage = Aabb(0.0, 0.0, 10.0, 10.0)
    assert cut(Aabb(-5.0, 2.0, 3.0, 4.0), stage) == Aabb(0.0, 2.0, 3.0, 4.0)
    assert cut(Aabb(-5.0, 2.0, 0.0, 4.0), stage) is None
    assert cut(Aabb(2.0, 11.0, 3.0, 12.0), stage) is None
