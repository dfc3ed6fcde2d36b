"""Calls of kernels as they stand, interpreted, with the rows and the room that they ask for."""

from collections.abc import Iterable
from math import inf
from random import Random

import numpy as np

import carom
from carom import Circle, Point, Segment, World
from carom.geometry.instants import later
from carom.rows.ball import ALL_LAYERS, BALL
from carom.rows.flight import NO_BALL, NO_PLACE, NOTHING
from carom.rows.hit import HIT_ROW
from carom.rows.index import CELL, SLOT, ShapeIndex
from carom.rows.island import BODY, ISLAND_CONTACT
from carom.rows.pose import STILL, UNPOSED, advance, pose
from carom.rows.relation import NO_RELATION
from carom.rows.shape import SHAPE, ShapeRow
from carom.rows.state import BRUTE, DONE, GRID, NEEDS_PAIRS, NOTE, QUADTREE, STALE, STATE
from carom.rows.tables import Rows
from carom.world.kernels.broad_phase.grid import (
    clear_grid,
    count_ball,
    grid_ahead,
    lay_grid,
    pairs_ahead,
    pairs_by_grid,
)
from carom.world.kernels.broad_phase.pairs import (
    measure_balls,
    pairs_by_brute_force,
    pairs_by_quadtree,
    plant_ball_tree,
)
from carom.world.kernels.broad_phase.regions import is_any_near, kinematic_near, next_near
from carom.world.kernels.broad_phase.shape_index import MOVING, cell_span, locate
from carom.world.kernels.continuous.flight import age_now
from carom.world.kernels.continuous.frames import begin_film_step, note_passed, take_up
from carom.world.kernels.continuous.predict import predict_all, predict_own
from carom.world.kernels.continuous.predict_shapes import predict_shapes
from carom.world.kernels.continuous.regions import rebuild_regions
from carom.world.kernels.step.beginning import begin_step
from carom.world.kernels.step.discrete import rebuild_index
from carom.world.tables import Arrays
from tests.worlds import continuous_world

Ball = tuple[float, float, float]
Pair = tuple[int, int]

#: Of the ball of a `fleet`.
RADIUS = 0.3

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
        count = pairs_by_grid(state, rows, (np.zeros(2 * len(rows) + 2, SLOT), starts, pairs), 0.0)
    else:
        cells, members = np.zeros(4096, CELL), np.zeros(65536, "i4")
        end = plant_ball_tree(state, rows, np.zeros(0, SHAPE), cells, members, 0, 0)
        assert end > 0
        count = pairs_by_quadtree(state, rows, cells, members, 0, end, pairs)
    assert count >= 0
    return [(min(i, j), max(i, j)) for i, j in pairs[:count].tolist()]


def pairs_found_ahead(rows: Rows, room: int = 4096) -> list[Pair] | None:
    """The pairs that a grid finds which was laid ahead, likewise; None where none is laid."""
    state = state_row(rows, "grid", 6)
    lay_grid(state, *measure_balls(state, rows))
    if state["grid_size"] == 0:
        return None
    slots, starts = np.zeros(2 * len(rows) + 2, SLOT), np.zeros(int(state["grid_size"]) + 1, "i4")
    assert not clear_grid(state, starts[:-1])
    assert state["wanted_starts"] == len(starts)
    assert clear_grid(state, starts)
    grid = grid_ahead(state)
    upper = slots[len(rows) : 2 * len(rows)]
    for field in ("x", "y", "radius"):
        upper[field] = rows[field]
    upper["ball"] = np.arange(len(rows))
    assert all(count_ball(grid, slot, starts) for slot in upper)
    pairs = np.full((0, 2), -1, "i4")
    # With more room it goes on from where it was.
    count = pairs_ahead(state, (slots, starts, pairs))
    if count < 0:
        pairs = np.full((room, 2), -1, "i4")
        count = pairs_ahead(state, (slots, starts, pairs))
    return [(min(i, j), max(i, j)) for i, j in pairs[:count].tolist()]


def prepare_index(world: World, reach: float) -> None:
    """Make the index of a world's shapes for balls up to a radius, as the next step would."""
    arrays = world._arrays
    arrays.prepare()
    state = arrays.states[0]
    state["reach"], state["index_stale"], state["moving_stale"] = reach, STALE, STALE
    while not rebuild_index(state, arrays.balls.rows, arrays.shapes.rows, arrays.order, shape_index(arrays)):
        arrays.extend(NEEDS_PAIRS)


def found_shapes(world: World, which: int, x: float, y: float) -> list[int]:
    """The rows of the shapes that the index gives for a place, in its order."""
    arrays = world._arrays
    if which == MOVING:
        return found_moving(arrays, x, y)
    begin, end = cell_span(arrays.cells, locate(arrays.index[which], arrays.cells, x, y))
    rows: list[int] = arrays.members[begin:end].tolist()
    return rows


def shape_index(arrays: Arrays) -> ShapeIndex:
    """Where kernels find the shapes near a place."""
    return arrays.index, arrays.cells, arrays.members


def prepared(world: World) -> Arrays:
    """The tables of a world as a step finds them that has made the index of its shapes."""
    prepare_index(world, float(world.balls.radius.max(initial=0.0)))
    return world._arrays


def in_flight(world: World, dt: float = 1.0) -> Arrays:
    """The tables of a continuous world in a step of `dt` seconds: its balls are on their flights, none is foreseen."""
    arrays = prepared(world)
    arrays.extend_relations(4 * (arrays.shapes.count + arrays.balls.count) + 16)
    state, balls, order, relations = arrays.states[0], arrays.balls.rows, arrays.order, arrays.relations
    state["dt"], state["steps_left"] = dt, 1
    rows = arrays.states, balls, arrays.shapes.rows, order, relations, arrays.flights
    assert begin_film_step(*rows) == DONE
    if state["stage"] == NOTE:
        tables = arrays.shapes.rows, order, *shape_index(arrays), relations, arrays.flights
        assert note_passed(state, balls, *tables) == DONE
    arrays.island = np.zeros(len(balls), BODY), np.zeros(len(relations), ISLAND_CONTACT)
    tables = arrays.hits.view(HIT_ROW), relations, arrays.flights, arrays.island[0]
    assert take_up(state, balls, arrays.shapes.rows, order, *tables) == DONE
    prepare_regions(arrays)
    state["binned"] = state["queued"] = state["bin_levels"] = 0
    arrays.queue["place"] = NO_PLACE
    arrays.flights["row"] = np.arange(len(arrays.flights))
    return arrays


def prepare_regions(arrays: Arrays) -> None:
    """Make the index of a world's shapes as flights ask for it."""
    state, balls, shapes = arrays.states[0], arrays.balls.rows, arrays.shapes.rows
    while not rebuild_regions(state, balls, shapes, arrays.order, shape_index(arrays)):
        arrays.extend(NEEDS_PAIRS)


def film_tables(arrays: Arrays) -> tuple[Rows, ...]:
    """The shapes and how they are found, as most kernels of the film ask for them."""
    return arrays.shapes.rows, arrays.order, *shape_index(arrays)


def near_tables(arrays: Arrays) -> tuple[Rows, ...]:
    """The shapes and how those near a place are found, as kernels of the film ask for them that need no more."""
    return arrays.shapes.rows, *shape_index(arrays)


def look_at(arrays: Arrays, seconds: float) -> None:
    """Let it be so many seconds after the beginning of the step that is made."""
    state = arrays.states[0]
    state["now"], state["now_low"] = later(float(state["time"]), float(state["time_low"]), seconds)


def foresee_own(arrays: Arrays, i: int = 0) -> tuple[int, float, float, int]:
    """What comes next for a ball but for other balls, from now on: the event, its instant, and with whom."""
    balls, flights, relations = arrays.balls.rows, arrays.flights, arrays.relations
    predict_own(arrays.states[0], balls, flights, arrays.shapes.rows, relations, i)
    if arrays.states[0]["shapes"] > 0:
        age = age_now(arrays.states[0], flights[i])
        predict_shapes(arrays.states[0], balls[i], flights[i], *film_tables(arrays), relations, age)
    return foreseen(arrays, i)


def foreseen(arrays: Arrays, i: int = 0) -> tuple[int, float, float, int]:
    """What comes next for a ball, as it was foreseen last: the event, its instant, and with whom."""
    flight = arrays.flights[i]
    if flight["event"] == NOTHING:
        return NOTHING, inf, 0.0, NO_BALL
    return int(flight["event"]), float(flight["event_time"]), float(flight["event_low"]), int(flight["partner"])


def foresee_all(arrays: Arrays) -> Rows:
    """The heads of the balls' cells, when what comes next was foreseen for every ball and stands in the queue."""
    heads = np.zeros(64 + 16 * arrays.balls.count, "i4")
    tables = *film_tables(arrays), heads, arrays.relations, arrays.flights, arrays.queue
    assert predict_all(arrays.states[0], arrays.balls.rows, *tables)
    return heads


def fleet(seed: int, count: int = 40, speed: float = 1.0) -> Arrays:
    """Shapes that rest, turn and travel, and a ball; a little after their motion began."""
    random = Random(seed)
    shapes = []
    for k in range(count):
        x, y = random.uniform(-20, 20), random.uniform(-20, 20)
        drift = random.uniform(-speed, speed), random.uniform(-speed, speed)
        options = ({}, {"angular_velocity": 2.0}, {"velocity": drift}, {"angular_velocity": -3.0, "velocity": drift})
        kind = random.randrange(3)
        if kind == 0:
            shapes.append(Point((x, y), motion="kinematic", pivot=(x + 1, y), **options[k % 4]))
        elif kind == 1:
            shapes.append(Segment((x, y), (x + 1, y + 1), motion="kinematic", pivot=(x, y), **options[k % 4]))
        else:
            shapes.append(Circle((x, y), 0.7, motion="kinematic", pivot=(x + 2, y), **options[k % 4]))
    arrays = roomy(continuous_world(*shapes, carom.Ball((0, 0), RADIUS)))
    look_at(arrays, 0.37)
    arrays.states[0]["moving_stale"] = STALE
    prepare_regions(arrays)
    return arrays


def roomy(world: World) -> Arrays:
    """The tables of a world in flight."""
    world._arrays.cells, world._arrays.members = np.zeros(4096, CELL), np.zeros(8192, "i4")
    return in_flight(world)


def found_moving(arrays: Arrays, x: float, y: float) -> list[int]:
    """The kinematic shapes that a ball at a place may overlap, in their order."""
    near, wide = kinematic_near(arrays.index, arrays.cells, x, y)
    rows = []
    while is_any_near(near, wide):
        row, near, wide = next_near(arrays.shapes.rows, arrays.members, near, wide)
        rows.append(row)
    return rows


def begun(arrays: Arrays) -> int:
    """The outcome of beginning a step."""
    shapes, kept = (arrays.shapes.rows, arrays.order), (arrays.saved, arrays.relations)
    return begin_step(arrays.states, arrays.balls.rows, *shapes, arrays.slots, *kept, arrays.index)


def contents(arrays: Arrays) -> list[bytes]:
    """The tables that a step may change, bit by bit."""
    used = int(arrays.states[0]["relations_high"])
    return [
        *(table.tobytes() for table in (arrays.states[0], arrays.balls.used, arrays.shapes.used)),
        arrays.relations[:used].tobytes(),
    ]


def advance_pose(shape: ShapeRow, h: float) -> bool:
    """Whether a shape moved in one substep of h seconds; moves it, and poses it where that is left to others."""
    how = advance(shape, h)
    if how == UNPOSED:
        pose(shape)
    return how != STILL
