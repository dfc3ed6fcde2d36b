"""Rounds of balls that meet shapes: grids laid ahead that a ball leaves, and what is looked at in the end."""

from copy import copy
from math import nan

import numpy as np
import pytest

import carom
from carom import Arc, Ball, Circle, Gate, Point, Segment
from carom.constants import FEW_TO_SORT
from carom.rows.index import SLOT
from carom.rows.saved import MET, PAIRS_DUE, SAVED, SHAPES_DUE
from carom.rows.state import DONE
from carom.world.kernels.step.rounds import launch_balls, list_balls_near, list_due
from tests.kernel_calls import ball_rows, begun, prepared, shape_index, state_row
from tests.worlds import bits, box, guarded, world_of

HUGE = 1.5e308


def crowd(first: float) -> list[Ball]:
    """So many balls, at rest and apart, that a world with them sorts its balls into a grid that is laid ahead."""
    return [Ball((first - 3.0 * k, 20), 1) for k in range(FEW_TO_SORT)]


@pytest.mark.parametrize("many", [False, True])
def test_balls_that_a_shape_pushes_far_out_of_their_grid_still_meet_each_other(many: bool) -> None:
    ways = {}
    for phase in ("grid", "brute"):
        world = world_of(
            Circle((0, 0), 50, solid=True), Ball((1, 0), 1), Ball((3, 0.05), 1), broad_phase=phase, substeps=1
        )
        world.add(*(crowd(-2.0) if many else ()))
        hits = world.step(0.01)
        ways[phase] = world.balls.position.tobytes(), bits(hits)
        assert world.statistics.full_tests > 2
        assert np.hypot(*np.subtract(*world.balls.position[:2])) > 1.9
    assert ways["grid"] == ways["brute"]


def test_the_grid_that_is_laid_ahead_holds_for_the_first_search_alone() -> None:
    positions = {}
    for phase in ("grid", "brute"):
        world = carom.World(detection="discrete", broad_phase=phase, substeps=3, iterations=4)
        world.add_balls(np.stack([1.7 * np.arange(9.0), np.zeros(9)], axis=1), (0.0, 0.0), radius=1.0)
        world.step(1 / 60)
        positions[phase] = world.balls.position
        assert world._arrays.states[0]["grid_size"] == 0
    assert np.allclose(positions["grid"], positions["brute"], atol=0.2)


@pytest.mark.parametrize(
    "members",
    [
        # Flies where numbers do not reach, alone and with others, by itself and by gravity.
        (Ball((0, 0), 1, velocity=(HUGE, 0)),),
        (Ball((0, 0), 1, velocity=(HUGE, 0)), Ball((9, 9), 1)),
        (Ball((0, 0), 1, velocity=(HUGE, 0)), Ball((9, 9), 1, velocity=(HUGE, 0))),
        # Is turned so fast by a shape, and by another ball.
        (Segment((-5, 0), (5, 0), elasticity=9), Ball((0, 0.9), 1, velocity=(0, -HUGE / 1e3), elasticity=1e3)),
        (Ball((0, 0), 1, velocity=(HUGE, 0), mass=1e3), Ball((1.9, 0), 1)),
    ],
)
@pytest.mark.parametrize("substeps", [1, 3])
@pytest.mark.parametrize("many", [False, True])
def test_a_step_that_takes_a_ball_where_numbers_do_not_reach_is_undone(
    members: tuple[carom.Shape, ...], many: bool, substeps: int
) -> None:
    flies = len(members) == 1 or (isinstance(members[1], Ball) and members[1].position == (9, 9))
    world = world_of(*map(copy, members), *(crowd(-9.0) if many else ()), substeps=substeps)
    before = world.snapshot()
    with pytest.raises(carom.NonFiniteState):
        world.step(3.0 if flies else 1e-310)
    assert world.snapshot() == before


def test_gravity_is_seen_to_take_a_ball_where_numbers_do_not_reach() -> None:
    falling = [Ball((5 * x, 0), 1, velocity=(0, -HUGE)) for x in range(FEW_TO_SORT + 1)]
    world = world_of(*falling, gravity=(0, -HUGE), substeps=1)
    before = world.snapshot()
    with pytest.raises(carom.NonFiniteState):
        world.step(0.5)
    assert world.snapshot() == before


def test_balls_are_moved_ahead_where_none_sleeps() -> None:
    balls = Ball((0, 0), 1, velocity=(2, 4)), *crowd(-2.0)
    arrays = prepared(world_of(Point((9, 9)), *balls, substeps=2))
    arrays.states[0]["dt"] = 1.0
    assert begun(arrays) == DONE
    assert arrays.states[0]["met_noted"] == 1
    assert arrays.states[0]["grid_size"] > 0
    assert [arrays.saved[name][0] for name in ("x", "y", "met_x", "met_y")] == [0, 0, 1, 2]
    assert arrays.balls.rows["x"][0] == 1.0
    assert arrays.slots[arrays.balls.count].tolist()[:4] == (1.0, 2.0, 1.0, 0)
    arrays.states[0]["sleeping"] = 1
    assert begun(arrays) == DONE
    assert (arrays.states[0]["met_noted"], arrays.states[0]["grid_size"]) == (0, 0)


@pytest.mark.parametrize("substeps", [1, 3])
def test_each_of_many_comes_to_a_shape_from_where_it_was_in_that_substep_as_it_does_alone(substeps: int) -> None:
    shapes = [
        *(*box(20, 10), Gate((6, 3), (6, 9), direction=(1, 0)), Arc((14, 5), 3, 0.5, 3.0)),
        *guarded([Segment((0, 6), (5, 6)), Segment((9, 2), (9, 8))]),
    ]
    random, count = np.random.default_rng(1), FEW_TO_SORT + 4
    place, speed = random.uniform(1, (19, 9), (count, 2)), random.uniform(-60, 60, (count, 2))

    def room(which: slice) -> carom.World:
        world = world_of(*map(copy, shapes), gravity=(0, -9), substeps=substeps)
        world.add_balls(place[which], speed[which], radius=0.4, layer=2, collides_with=1)
        return world

    many, alone = room(slice(None)), [room(slice(k, k + 1)) for k in range(count)]
    for _ in range(8):
        for world in (many, *alone):
            world.step(1 / 60)
        assert many.balls.position.tolist() == [world.balls.position[0].tolist() for world in alone]
        assert many.balls.velocity.tolist() == [world.balls.velocity[0].tolist() for world in alone]
    assert many.statistics.collisions > 5


def test_a_ball_that_a_shape_has_pushed_is_looked_for_where_it_was_pushed_to() -> None:
    world = world_of(Segment((-5, 0), (5, 0)), Ball((0, 0.7), 1), *crowd(-2.0), substeps=1, iterations=1)
    world.step(1 / 60)
    arrays, count = world._arrays, len(world.balls)
    assert world.balls.position[0].tolist() == [0.0, 1.0]
    assert arrays.slots["y"][count : 2 * count].tolist() == world.balls.position[:, 1].tolist()


def test_those_near_shapes_are_listed_with_the_places_that_they_come_from() -> None:
    balls = [Ball((x, 10), 1, velocity=(0, 8)) for x in (10.0, 0.5, 20.0, 80.0)]
    arrays = prepared(world_of(*box(80, 40), *balls, *crowd(60.0)))
    state, index, slots = arrays.states[0], shape_index(arrays), arrays.slots
    state["dt"], state["substeps"] = 0.5, 2
    assert begun(arrays) == DONE
    for substep in range(2):
        state["substep"], state["grid_size"] = substep, 0
        if substep > 0:
            launch_balls(state, arrays.balls.rows, slots, arrays.saved)
        list_balls_near(state, index, slots, arrays.starts, arrays.saved)
        assert slots["ball"][: state["near"]].tolist() == [1, 3]
        assert slots["x"][:2].tolist() == [0.5, 80.0]
        assert slots["y"][:2].tolist() == [10.0 + 2.0 * substep] * 2
        assert arrays.balls.used["y"][:4].tolist() == [12.0 + 2.0 * substep] * 4


def test_those_that_are_due_are_listed_in_the_order_of_their_rows() -> None:
    rows = ball_rows([(0, 0, 1)] * 6)
    saved, slots = np.zeros(6, SAVED), np.zeros(14, SLOT)
    saved["touched"] = SHAPES_DUE, PAIRS_DUE, MET, SHAPES_DUE | MET, 0, SHAPES_DUE | PAIRS_DUE
    slots["x"] = nan
    assert list_due(state_row(rows, "grid", 6), slots, saved) == 3
    assert slots["ball"][:3].tolist() == [0, 3, 5]


def test_a_ball_that_sleeps_has_met_the_shapes_where_it_lies() -> None:
    world = world_of(*box(8, 4), gravity=(0, -5), sleep_speed=0.2, sleep_time=0.1, detection="continuous")
    world.add(*[Ball((x, 1.0), 0.5, elasticity=0.0) for x in (1.0, 3.0, 5.0, 7.0)])
    for _ in range(120):
        world.step(1 / 60)
    assert world.statistics.sleeping == 4
    saved = world._arrays.saved
    saved["met_x"] = saved["met_y"] = 99.0
    # Balls meet shapes again where something was put onto others.
    world.add(Ball((3.5, 0.6), 0.5))
    world.step(1 / 60)
    for ball, mark in zip(world._arrays.balls.used[[0, 3]], saved[[0, 3]], strict=True):
        assert (mark["met_x"], mark["met_y"]) == (ball["x"], ball["y"])
