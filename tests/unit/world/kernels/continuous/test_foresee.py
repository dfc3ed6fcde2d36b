"""What comes next for a ball among shapes: the first impact of all, however the shapes are found."""

from math import inf, pi
from random import Random

import numpy as np
import pytest

import carom
from carom.rows.flight import HIT_SHAPE, LEAVE, LOOK, NOTHING
from carom.rows.kinds_in_motion import impact_at_rest
from carom.rows.relation import LASTING, PASSING
from carom.rows.tables import Rows
from carom.world.kernels.continuous.flight import path_of
from carom.world.kernels.continuous.foresee import foresee, foresee_all, foresee_shapes
from carom.world.kernels.continuous.surfaces import impact_in_motion
from carom.world.kernels.step.relations import add_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, shape_index
from tests.worlds import continuous_world


def furnished(seed: int, few: bool, broad_phase: str) -> Arrays:
    """Shapes all over the place, some of which move, and balls that fly among them."""
    random = Random(seed)

    def place(size: float = 9.0) -> tuple[float, float]:
        return random.uniform(-size, size), random.uniform(-size, size)

    world = carom.World(detection="continuous", gravity=(1, -4), broad_phase=broad_phase)
    for _ in range(3 if few else 15):
        world.add(carom.Segment(place(), place()))
        world.add(carom.Circle(place(), random.uniform(0.1, 1)))
        world.add(carom.Point(place()))
        start = random.uniform(0, 6)
        world.add(carom.Arc(place(), random.uniform(0.5, 3), start, (start + 2) % (2 * pi)))
    for _ in range(2 if few else 20):
        world.add(carom.Segment(place(), place(), motion="kinematic", velocity=place(1), angular_velocity=0.5))
    for _ in range(12):
        world.add(carom.Ball(place(), random.uniform(0.05, 0.3), velocity=place(20)))
    arrays = in_flight(world, 1.5)
    arrays.states[0]["bin_levels"] = 0
    return arrays


def earliest(arrays: Arrays, i: int) -> float:
    """When a ball first touches any shape, each asked in turn."""
    ball, flight, first = arrays.balls.rows[i], arrays.flights[i], inf
    path, radius = path_of(ball, flight), float(ball["radius"])
    for shape in arrays.shapes.used:
        found = (
            impact_in_motion(shape, 0.0, path, radius, 1.5, 1.0)
            if shape["motion"]
            else impact_at_rest(shape, path, radius, 1.5)
        )
        first = min(first, inf if found is None else found)
    return first


def tables(arrays: Arrays) -> tuple[Rows, ...]:
    """The shapes, and how they are found."""
    return arrays.shapes.rows, arrays.order, *shape_index(arrays)


@pytest.mark.parametrize(
    ("few", "broad_phase"), [(True, "grid"), (False, "grid"), (False, "brute"), (False, "quadtree")]
)
@pytest.mark.parametrize("seed", range(2))
def test_the_impact_that_is_foreseen_is_the_first_of_all(seed: int, few: bool, broad_phase: str) -> None:
    arrays, seen = furnished(seed, few, broad_phase), 0
    for i in range(12):
        flight = arrays.flights[i]
        foresee_shapes(arrays.states[0], arrays.balls.rows[i], flight, *tables(arrays), arrays.relations)
        time = earliest(arrays, i)
        seen += time < inf
        assert flight["event"] == (HIT_SHAPE if time < inf else NOTHING)
        assert flight["event_time"] == pytest.approx(min(time, 1.5), abs=1e-12)
    assert seen >= 6


@pytest.mark.parametrize("seed", range(2))
def test_the_front_of_the_queue_is_the_first_event_of_all_balls(seed: int) -> None:
    arrays = furnished(seed, False, "grid")
    state, queue, nothing = arrays.states[0], arrays.queue, np.zeros((0, 2), "i4")
    rest = nothing, nothing, arrays.relations, arrays.flights, queue
    foresee_all(state, arrays.balls.rows, *tables(arrays), *rest)
    times = [earliest(arrays, i) for i in range(12)]
    assert state["queued"] == sum(time < inf for time in times)
    assert queue[0] == int(np.argmin(times))
    # Where nothing is to come any more, a ball leaves the queue.
    first = int(queue[0])
    arrays.balls.rows["can_collide"][first] = 0
    foresee(state, arrays.balls.rows, *tables(arrays), nothing, arrays.flights, queue, arrays.relations, first)
    assert state["queued"] == sum(time < inf for time in times) - 1
    times[first] = inf
    assert queue[0] == int(np.argmin(times))


@pytest.mark.parametrize(("kind", "event"), [(PASSING, LOOK), (LASTING, LEAVE)])
def test_what_a_ball_passes_or_rests_on_is_no_impact_but_looked_at(kind: int, event: int) -> None:
    arrays = in_flight(
        continuous_world(carom.Segment((-5, 0), (5, 0)), carom.Ball((4.5, 1), 1, velocity=(2, 0))), 100.0
    )
    arrays.states[0]["free_relation"] = -1
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, kind, 0)
    foresee_shapes(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], *tables(arrays), arrays.relations)
    assert arrays.flights[0]["event"] == event
    # A ball at its end leaves it when its centre is past it.
    assert arrays.flights[0]["event_time"] == (pytest.approx(0.25) if event == LEAVE else pytest.approx(0.125))
