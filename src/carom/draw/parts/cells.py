"""The cells into which the broad phase sorts the shapes at rest, as a world makes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.checks import instance
from carom.draw.paint.painter import Style
from carom.draw.parts.marks import box_mark
from carom.rows.index import NO_CHILD
from carom.rows.state import GRID, NEEDS_PAIRS, QUADTREE
from carom.scene.capture import described_world
from carom.scene.scene import Scene
from carom.shapes.aabb import Aabb
from carom.world.kernels.broad_phase.shape_index import FIXED, build_index
from carom.world.world import World

if TYPE_CHECKING:
    from collections.abc import Iterator

    from carom.draw.paint.painter import Painter
    from carom.rows.index import CellRow, IndexRow
    from carom.rows.tables import Table

#: The edge of a cell, and the opacities of the least and of the fullest cells' areas.
EDGE = Style("cell", width=0.8, opacity=0.45)
LEAST, MOST = 0.05, 0.3


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell of the broad phase: its box, and how many shapes are looked at for a ball in it."""

    box: Aabb
    shapes: int


@dataclass(frozen=True, slots=True)
class Partition:
    """How the broad phase divides the room among the shapes at rest.

    Attributes:
        nodes: How many nodes a quadtree has, leaves among them; 0 for a grid and for brute force.
        leaves: How many leaves, or cells of a grid, there are, empty ones among them.
        cells: Those that hold shapes.
    """

    nodes: int
    leaves: int
    cells: tuple[Cell, ...]


def partition_of(world: World) -> Partition:
    """How the broad phase of `world`, as it is set now, divides the room, for balls as large as the largest."""
    instance("world", world, World, "a World")
    scene = Scene(world=described_world(world), shapes=list(world.shapes))
    return partition(scene, float(world._arrays.balls.used["radius"].max(initial=0.0)))


def cells_of(scene: Scene, radius: float) -> tuple[Cell, ...]:
    """The cells that hold shapes, for balls of radius up to `radius`; none where the broad phase is brute force."""
    return partition(scene, radius).cells


def partition(scene: Scene, radius: float) -> Partition:
    """How the broad phase of a scene's world divides the room, for balls of radius up to `radius`."""
    arrays = scene.model_copy(update={"balls": ()}).build()._arrays
    arrays.prepare()
    state = arrays.states[0]
    state["reach"] = radius
    while not build_index(
        state, arrays.balls.rows, arrays.shapes.rows, arrays.order, (arrays.index, arrays.cells, arrays.members)
    ):
        arrays.extend(NEEDS_PAIRS)
    entry = arrays.index[FIXED]
    cells = arrays.cells[int(entry["cells_begin"]) : int(entry["cells_end"])]
    if state["broad_phase"] == GRID:
        return Partition(0, len(cells), tuple(grid_cells(entry, cells)))
    if state["broad_phase"] == QUADTREE:
        leaves = int((cells["child"] == NO_CHILD).sum())
        return Partition(len(cells), leaves, tuple(tree_cells(entry, cells)))
    return Partition(0, 0, ())


def grid_cells(entry: IndexRow, cells: Table[CellRow]) -> Iterator[Cell]:
    """The cells of a grid that hold shapes."""
    side, columns = float(entry["side"]), int(entry["columns"])
    for number in range(len(cells)):
        count = int(cells[number]["end"] - cells[number]["begin"])
        if count:
            left = float(entry["left"]) + side * (number % columns)
            bottom = float(entry["bottom"]) + side * (number // columns)
            yield Cell(Aabb(left, bottom, left + side, bottom + side), count)


def tree_cells(entry: IndexRow, cells: Table[CellRow]) -> Iterator[Cell]:
    """The leaves of a quadtree that hold shapes."""
    for number in range(len(cells)):
        cell = cells[number]
        count = int(cell["end"] - cell["begin"])
        if cell["child"] == NO_CHILD and count:
            x, y, parts = float(cell["x"]), float(cell["y"]), 0.5 ** int(cell["depth"])
            half_width = parts * (float(cells[0]["x"]) - float(entry["left"]))
            half_height = parts * (float(cells[0]["y"]) - float(entry["bottom"]))
            yield Cell(Aabb(x - half_width, y - half_height, x + half_width, y + half_height), count)


def draw_cells(painter: Painter, cells: tuple[Cell, ...], stage: Aabb) -> None:
    """Draw cells as far as they are on the stage, the darker the more shapes they hold."""
    most = max((cell.shapes for cell in cells), default=1)
    for cell in cells:
        box = cut(cell.box, stage)
        if box is not None:
            box_mark(painter, box, Style(fill="cell", opacity=LEAST + (MOST - LEAST) * cell.shapes / most))
            box_mark(painter, box, EDGE)


def cut(box: Aabb, stage: Aabb) -> Aabb | None:
    """The part of a box that is on the stage, or None."""
    left, right = max(box.left, stage.left), min(box.right, stage.right)
    bottom, top = max(box.bottom, stage.bottom), min(box.top, stage.top)
    return Aabb(left, bottom, right, top) if left < right and bottom < top else None
