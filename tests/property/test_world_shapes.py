"""The index of shapes never hides a shape that a ball overlaps, and one ball runs alike under all broad phases."""

from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Gate, Point, Segment, World
from carom.rows.kinds_near import distance_to_shape
from carom.shapes.shape import Shape
from carom.world.kernels.broad_phase.shape_index import FIXED, MOVING
from tests import strategies
from tests.kernel_calls import found_shapes, prepare_index
from tests.strategies import Figure

PHASES = ("brute", "grid", "quadtree")


def shape_of(figure: Figure, **options: object) -> Shape:
    """The shape for a figure."""
    kind, given = figure
    if kind == "point":
        return Point((given[0], given[1]), **options)
    if kind == "segment":
        return Segment((given[0], given[1]), (given[2], given[3]), **options)
    if kind == "arc":
        return Arc((given[0], given[1]), given[2], given[3], given[4], **options)
    return Circle((given[0], given[1]), given[2], solid=kind == "disc", **options)


@pytest.mark.slow
@given(
    st.lists(st.tuples(strategies.figures, st.booleans()), min_size=1, max_size=12),
    st.lists(st.tuples(st.integers(0, 11), strategies.angles, strategies.fractions), min_size=1, max_size=8),
    strategies.numbers(0.01, 20.0),
    st.sampled_from(PHASES),
    st.data(),
)
def test_the_index_gives_every_shape_that_a_ball_overlaps_in_the_order_of_meeting(
    figures: list[tuple[Figure, bool]],
    near: list[tuple[int, float, float]],
    radius: float,
    phase: str,
    data: st.DataObject,
) -> None:
    world = World(detection="discrete", broad_phase=phase, levels=data.draw(st.integers(1, 8)))
    for figure, moving in figures:
        world.add(shape_of(figure, motion="kinematic" if moving else "static"))
    prepare_index(world, radius)
    arrays = world._arrays
    ranks = {int(row): rank for rank, row in enumerate(arrays.order[: arrays.shapes.count])}
    for k, angle, share in near:
        x, y = data.draw(strategies.places_on(figures[k % len(figures)][0]))
        x, y = x + share * radius * cos(angle), y + share * radius * sin(angle)
        for which, moving in ((FIXED, False), (MOVING, True)):
            found = found_shapes(world, which, x, y)
            assert [ranks[row] for row in found] == sorted(ranks[row] for row in found)
            for row in range(len(figures)):
                if figures[row][1] is moving and distance_to_shape(arrays.shapes.rows[row], x, y) < radius:
                    assert row in found


@pytest.mark.parametrize("phase", PHASES)
def test_shapes_as_far_apart_as_numbers_reach_are_found(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase)
    places = [(1.7e308, 1.7e308), (-1.7e308, -1.7e308), (0, 0), (0, -1.7e308)]
    for place in places:
        world.add(Point(place))
    prepare_index(world, 1.0)
    for row, (x, y) in enumerate(places):
        assert row in found_shapes(world, FIXED, x, y)


@pytest.mark.parametrize("phase", PHASES)
def test_far_from_the_origin_no_shape_is_hidden(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase)
    rng = np.random.default_rng(2)
    places = 1e12 + rng.uniform(-50, 50, (40, 2))
    for place in places.tolist():
        world.add(Point(place))
    prepare_index(world, 1.0)
    for x, y in (1e12 + rng.uniform(-50, 50, (500, 2))).tolist():
        found = found_shapes(world, FIXED, x, y)
        for row in np.flatnonzero(np.hypot(*(places - (x, y)).T) < 0.999):
            assert row in found


def room_of_shapes(phase: str, seed: int) -> World:
    """A closed room crowded with shapes of all kinds, some of which move, and one ball."""
    rng = np.random.default_rng(seed)
    world = World(detection="discrete", gravity=(0.3, -9), broad_phase=phase, iterations=5, substeps=2)
    world.add(Circle((0, 0), 12))
    for k in range(30):
        x, y = rng.uniform(-9, 9, 2)
        turn, size = rng.uniform(0, 2 * pi), rng.uniform(0.3, 2.5)
        options = {"elasticity": rng.uniform(0.5, 1.1)}
        if k % 3 == 0:
            options |= {"motion": "kinematic", "angular_velocity": rng.normal(), "velocity": tuple(rng.normal(size=2))}
        if k % 5 == 0:
            world.add(Point((x, y), **options))
        elif k % 5 == 1:
            world.add(Segment((x, y), (x + size * cos(turn), y + size * sin(turn)), **options))
        elif k % 5 == 2:
            world.add(Circle((x, y), 0.4 * size, solid=True, **options))
        elif k % 5 == 3:
            world.add(Arc((x, y), size, turn, turn + 2, **options))
        else:
            world.add(Gate((x, y), (x + size * cos(turn), y + size * sin(turn)), **options))
    world.add(Ball((0, 0), radius=rng.uniform(0.1, 1.5), velocity=(15, 8), elasticity=0.95))
    return world


@pytest.mark.slow
@given(st.integers(0, 10_000))
def test_one_ball_runs_to_the_same_bits_under_all_broad_phases(seed: int) -> None:
    ends = []
    for phase in PHASES:
        world = room_of_shapes(phase, seed)
        hits = world.run(1)
        ends.append((hits.tobytes(), world.balls.position.tobytes(), world.balls.velocity.tobytes()))
    assert len(hits) > 0
    assert ends[0] == ends[1] == ends[2]


def test_a_ball_that_one_shape_throws_far_meets_what_is_there_at_once() -> None:
    ends = []
    for phase in PHASES:
        world = World(detection="discrete", broad_phase=phase, substeps=1, iterations=1)
        for k in range(40):
            world.add(Point((-30 + k, -30)))
        world.add(Circle((0, 0), 10, solid=True))
        arc = world.add(Arc((0, 0), 11.5, 0, 1))
        ball = world.add(Ball((9, 3), radius=1, velocity=(-1, -1)))
        hits = world.step(0.01)
        assert [hit.shape.kind for hit in hits] == ["circle", "arc"]
        assert hits[1].shape is arc
        ends.append((ball.position, ball.velocity))
    assert ends[0] == ends[1] == ends[2]
