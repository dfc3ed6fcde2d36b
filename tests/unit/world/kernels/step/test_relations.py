"""Relations: kept in lists of a pool; and passing: bare ends let balls by, joints do not, pushes go out."""

from math import pi
from random import Random

import numpy as np
import pytest

from carom import Arc, Ball, Gate, Segment, World
from carom.constants import END_DEPTH_DISCRETE
from carom.rows import relation
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LYING, NO_RELATION, PASSING, RELATION
from carom.world.kernels.step.relations import (
    add_relation,
    drop_all,
    drop_kind,
    find_relation,
    has_kind,
    is_of_balls,
    relations_room,
)
from tests.kernel_calls import ball_rows, state_row


def is_passing(world: World, ball: Ball, shape: Segment | Arc) -> bool:
    """Whether the world holds that a ball passes a shape."""
    arrays = world._arrays
    return find_relation(arrays.relations, ball._row, PASSING, arrays.shapes.index(shape))


def test_a_ball_that_comes_round_a_bare_end_passes_it_and_meets_nothing() -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0)))
    ball = world.add(Ball((-1, 0.5), radius=1, velocity=(1, 0)))
    hits = world.run(12, dt=0.1)
    assert len(hits) == 0
    assert ball.velocity == (1, 0)
    assert ball.position == (pytest.approx(11), 0.5)
    assert not is_passing(world, ball, wall)


def test_a_passing_ball_may_leave_on_either_side_and_turn_back() -> None:
    for turn in ((0.0, 1.0), (0.0, -1.0), (-1.0, 0.0)):
        world = World(detection="discrete", substeps=1)
        wall = world.add(Segment((0, 0), (10, 0)))
        ball = world.add(Ball((-1, 0.5), radius=1, velocity=(1, 0)))
        world.run(3, dt=0.1)
        assert is_passing(world, ball, wall)
        ball.velocity = turn
        assert len(world.run(4, dt=0.1)) == 0
        assert ball.velocity == turn
        assert not is_passing(world, ball, wall)


def test_a_ball_that_has_passed_meets_the_segment_again() -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0)))
    ball = world.add(Ball((-1, 0.5), radius=1, velocity=(1, 0)))
    world.run(3, dt=0.1)
    ball.velocity = (0, 1)
    world.run(1, dt=0.1)
    ball.velocity = (0, -1)
    hits = world.run(1, dt=0.1)
    assert [hit.shape for hit in hits] == [wall]


def test_a_ball_that_overlaps_a_bare_end_a_little_is_pushed_out() -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0)))
    ball = world.add(Ball((-0.05, 0.8), radius=1, velocity=(1, 0)))
    world.step(0.1)
    assert not is_passing(world, ball, wall)
    assert ball.position == (pytest.approx(0.05), 1.0)


def test_passing_begins_beyond_a_quarter_of_the_radius() -> None:
    for share, passes in ((0.999, False), (1.001, True)):
        world = World(detection="discrete", substeps=1)
        wall = world.add(Segment((0, 0), (10, 0)))
        ball = world.add(Ball((-0.05, 2 - 2 * share * END_DEPTH_DISCRETE), radius=2, velocity=(1, 0)))
        world.step(0.1)
        assert is_passing(world, ball, wall) is passes


@pytest.mark.parametrize("start", [(3, 0.1), (0.01, 0.1), (9.99, -0.1)])
def test_a_ball_that_was_placed_onto_a_segment_is_pushed_out(start: tuple[float, float]) -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0)))
    ball = world.add(Ball(start, radius=1))
    world.step(0.1)
    assert not is_passing(world, ball, wall)
    assert abs(ball.position[1]) == pytest.approx(1)


def test_a_ball_that_was_pushed_onto_a_segment_is_pushed_out() -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0)))
    ball = world.add(Ball((-0.1, 0.5), radius=1))
    world.add(Ball((-1.5, 0.5), radius=1, mass=1e9))
    world.step(0.1)
    assert not is_passing(world, ball, wall)
    assert ball.position[0] > 0
    assert ball.position[1] == pytest.approx(1)


def test_an_arc_is_passed_round_its_bare_end() -> None:
    world = World(detection="discrete", substeps=1)
    bowl = world.add(Arc((0, 0), 5, pi, 2 * pi))
    ball = world.add(Ball((-5.3, 1), radius=1, velocity=(0, -1)))
    assert len(world.run(2, dt=0.05)) == 0
    assert is_passing(world, ball, bowl)
    assert ball.velocity == (0, -1)


@pytest.mark.parametrize("speed", [1, 30, 100])
def test_a_ball_that_falls_onto_a_joint_bounces_however_fast(speed: float) -> None:
    whole, cut = World(detection="discrete", substeps=1), World(detection="discrete", substeps=1)
    whole.add(Segment((-5, 0), (5, 0)))
    cut.add(Segment((-5, 0), (0, 0)))
    cut.add(Segment((0, 0), (5, 0)))
    for world in (whole, cut):
        world.add(Ball((-0.003, 2), radius=1, velocity=(0.003 * speed, -speed)))
        world.run(4 / speed, dt=1.8 / speed)
    assert cut.balls[0].velocity == whole.balls[0].velocity == (0.003 * speed, speed)
    assert cut.balls[0].position == whole.balls[0].position


@pytest.mark.parametrize("inside", [True, False])
def test_a_ball_that_falls_onto_a_joint_of_arcs_bounces(inside: bool) -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Arc((0, 0), 5, pi, 1.5 * pi))
    world.add(Arc((0, 0), 5, 1.5 * pi, 2 * pi))
    y, vy = (-3.5, -10) if inside else (-6.5, 10)
    ball = world.add(Ball((-0.01, y), radius=1, velocity=(0.2, vy)))
    hits = world.step(0.12)
    assert len(hits) == 1
    assert ball.velocity[1] == pytest.approx(-vy, rel=0.05)


def test_a_segment_that_sweeps_over_a_ball_from_its_end_passes_it() -> None:
    world = World(detection="discrete", substeps=1)
    paddle = world.add(Segment((0, 0), (10, 0), motion="kinematic", velocity=(-1, 0)))
    ball = world.add(Ball((-1, 0.5), radius=1))
    assert len(world.run(5, dt=0.1)) == 0
    assert is_passing(world, ball, paddle)
    assert ball.position == (-1, 0.5)


def test_passing_pairs_are_state() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((0, 0), (10, 0)))
    world.add(Ball((-1, 0.5), radius=1, velocity=(1, -0.02)))
    world.run(3, dt=0.1)
    twin = World()
    twin.restore(world.snapshot())
    assert len(twin.run(2, dt=0.1)) == len(world.run(2, dt=0.1)) == 0
    assert twin.digest() == world.digest()


def test_a_sensor_is_not_passed() -> None:
    world = World(detection="discrete", substeps=1)
    wall = world.add(Segment((0, 0), (10, 0), sensor=True))
    ball = world.add(Ball((-1, 0.5), radius=1, velocity=(1, 0)))
    world.run(3, dt=0.1)
    assert not is_passing(world, ball, wall)


def test_a_gate_is_passed_round_its_bare_end_on_its_closed_side_too() -> None:
    world = World(detection="discrete", substeps=1)
    gate = world.add(Gate((0, 0), (10, 0), direction=(0, -1)))
    ball = world.add(Ball((-1, -0.5), radius=1, velocity=(1, 0)))
    assert len(world.run(4, dt=0.1)) == 0
    assert is_passing(world, ball, gate)
    assert ball.velocity == (1, 0)


@pytest.mark.parametrize("seed", range(4))
def test_relations_are_found_and_dropped_as_in_a_plain_set(seed: int) -> None:
    random = Random(seed)
    rows = ball_rows([(0.0, 0.0, 1.0)] * 3)
    state, pool = state_row(rows, "grid", 1), np.zeros(200, RELATION)
    state["free_relation"] = NO_RELATION
    twin: set[tuple[int, int, int]] = set()
    for _ in range(300):
        ball, kind, other = random.randrange(3), random.choice((PASSING, INSIDE_SHAPE)), random.randrange(9)
        do = random.choice(("add", "add", "drop", "drop", "drop all"))
        if do == "add" and (ball, kind, other) not in twin:
            add_relation(state, pool, rows[ball], ball, kind, other)
            twin.add((ball, kind, other))
        elif do == "drop":
            drop_kind(state, pool, rows[ball], kind, other)
            twin.discard((ball, kind, other))
        elif do == "drop all" and random.random() < 0.1:
            drop_all(state, pool, rows[ball], kind)
            twin = {relation for relation in twin if relation[:2] != (ball, kind)}
        held = {each for each in twin if find_relation(pool, rows[each[0]], *each[1:])}
        assert held == twin
        assert find_relation(pool, rows[ball], kind, other) == ((ball, kind, other) in twin)
        assert has_kind(pool, rows[ball], kind) == any(each[:2] == (ball, kind) for each in twin)
        assert (state["relations"], relations_room(state, pool)) == (len(twin), 100 - len(twin))
    # Places that were given back are taken again.
    assert state["relations_high"] <= 3 * 2 * 9


def test_two_of_all_kinds_are_of_two_balls() -> None:
    kinds = [value for name, value in vars(relation).items() if name.isupper() and isinstance(value, int)]
    kinds.remove(relation.NO_RELATION)
    assert len(set(kinds)) == len(kinds) == 5
    assert [kind for kind in sorted(kinds) if is_of_balls(kind)] == [INSIDE_BALL, LYING]
