"""Calls of kernels as they stand, interpreted, with the rows and the room that they ask for."""

from collections.abc import Iterable

import numpy as np

from carom import World
from carom.rows.ball import ALL_LAYERS, BALL
from carom.rows.index import CELL, SLOT, ShapeIndex
from carom.rows.relation import NO_RELATION
from carom.rows.shape import SHAPE
from carom.rows.state import BRUTE, GRID, QUADTREE, STATE
from carom.rows.tables import Rows
from carom.world.kernels.broad_phase.grid import pairs_by_grid
from carom.world.kernels.broad_phase.pairs import pairs_by_brute_force, pairs_by_quadtree, plant_ball_tree
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING, build_index, cell_span, locate
from carom.world.kernels.continuous.flight import begin_flight, new_flights
from carom.world.kernels.continuous.spans import set_shapes_going
from carom.world.tables import Arrays

Ball = tuple[float, float, float]
Pair = tuple[int, int]

PHASES = {"brute": BRUTE, "grid": GRID, "quadtree": QUADTREE}


def ball_rows(balls: Iterable[Ball]) -> Rows:
    """Rows of balls at rest from places and radii."""
    places = np.array(list(balls), np.float64).reshape(-1, 3)
    rows = np.zeros(len(places), BALL)
    rows["x"], rows["y"], rows["radius"] = places.T
    rows["mass"] = rows["elasticity"] = rows["layer"] = rows["can_collide"] = 1
    rows["collides_with"], rows["relation"] = ALL_LAYERS, NO_RELATION
    rows["id"] = np.arange(1, len(rows) + 1)
    return rows


def state_row(balls: Rows, phase: str, levels: int) -> Rows:
    """The state of a world of so many balls."""
    state = np.zeros(1, STATE)[0]
    state["balls"], state["broad_phase"], state["levels"] = len(balls), PHASES[phase], levels
    return state


def found_pairs(rows: Rows, phase: str, levels: int = 6, room: int = 4096) -> list[Pair]:
    """The pairs that a broad phase finds, each from the lower to the higher row, in its order."""
    state = state_row(rows, phase, levels)
    pairs = np.full((room, 2), -1, "i4")
    if phase == "brute":
        count = pairs_by_brute_force(state, rows, pairs)
    elif phase == "grid":
        starts = np.zeros(256 + 8 * len(rows), "i4")
        count = pairs_by_grid(state, rows, (np.zeros(len(rows), SLOT), starts, pairs), 0.0)
    else:
        cells, members = np.zeros(4096, CELL), np.zeros(65536, "i4")
        end = plant_ball_tree(state, rows, np.zeros(0, SHAPE), cells, members, 0, 0)
        assert end > 0
        count = pairs_by_quadtree(state, rows, cells, members, 0, end, pairs)
    assert count >= 0
    return [(min(i, j), max(i, j)) for i, j in pairs[:count].tolist()]


def prepare_index(world: World, reach: float) -> None:
    """Make the index of a world's shapes for balls up to a radius, as the next step would."""
    arrays = world._arrays
    arrays.prepare()
    state = arrays.states[0]
    for which in (FIXED, MOVING):
        while not build_index(
            state,
            arrays.balls.rows,
            arrays.shapes.rows,
            arrays.order,
            arrays.index,
            which,
            reach,
            arrays.cells,
            arrays.members,
        ):
            arrays.extend(2)


def found_shapes(world: World, which: int, x: float, y: float) -> list[int]:
    """The rows of the shapes that the index gives for a place, in its order."""
    arrays = world._arrays
    begin, end = cell_span(arrays.cells, locate(arrays.states[0], arrays.index[which], arrays.cells, x, y))
    rows: list[int] = arrays.members[begin:end].tolist()
    return rows


def shape_index(arrays: Arrays) -> ShapeIndex:
    """Where kernels find the shapes near a place."""
    return arrays.index, arrays.cells, arrays.members


def prepared(world: World) -> Arrays:
    """The tables of a world as a step finds them that has made the index of its shapes."""
    prepare_index(world, float(world.balls.radius.max(initial=0.0)))
    return world._arrays


def in_flight(world: World, span: float) -> Arrays:
    """The tables of a continuous world whose balls begin a span, which is a whole step of so many seconds."""
    arrays = world._arrays
    arrays.prepare()
    state = arrays.states[0]
    state["dt"] = state["span"] = span
    set_shapes_going(state, arrays.balls.rows, arrays.shapes.rows, arrays.order)
    prepare_index(world, float(world.balls.radius.max(initial=0.0)))
    state["substeps"] = state["steps_left"] = 1
    state["binned"] = state["swept"] = state["queued"] = 0
    state["bin_levels"] = 1
    new_flights(state, arrays.flights)
    for ball, flight in zip(arrays.balls.used, arrays.flights, strict=False):
        begin_flight(state, ball, flight)
    return arrays
