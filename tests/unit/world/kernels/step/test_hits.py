"""What a hit says: when, where, how hard, and of whom."""

from math import hypot

import numpy as np
import pytest

from carom import Ball, Circle, HitKind, Segment, World
from carom.rows.hit import BOUNCE, EXIT, HIT, HIT_ROW
from carom.rows.shape import SHAPE
from carom.world.kernels.step.hits import record_hit, write_hit
from tests.kernel_calls import ball_rows, state_row


def test_a_hit_on_a_shape_says_when_where_and_how() -> None:
    world = World(detection="discrete", substeps=4)
    world.step(1.0)
    wall = world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
    ball = world.add(Ball((1, 1.375), radius=1, velocity=(3, -4), mass=2))
    (hit,) = world.step(1.0)
    assert hit.kind is HitKind.BOUNCE
    assert hit.time == 1.25
    assert hit.shape is wall
    assert hit.ball is ball
    assert hit.point == (1.75, 0)
    assert hit.normal == (0, 1)
    assert hit.setback == 0.625
    assert hit.speed == 5
    assert hit.impulse == 2 * (4 + 2)


def test_a_hit_of_the_last_substep_has_the_time_that_the_step_ends_at() -> None:
    world = World(detection="discrete", substeps=3)
    world.run(0.5, dt=0.1)
    world.add(Segment((-9, 0), (9, 0)))
    world.add(Ball((0, 1.95), radius=1, velocity=(0, -10)))
    (hit,) = world.step(0.1)
    assert hit.time == world.time


def test_a_hit_of_two_balls_is_one_whose_shape_is_the_ball_added_first() -> None:
    world = World(detection="discrete", substeps=1)
    first = world.add(Ball((2, 0), radius=1, mass=2))
    second = world.add(Ball((0, 0), radius=1, velocity=(3, 4), mass=1))
    (hit,) = world.step(1 / 64)
    assert hit.shape is first
    assert hit.ball is second
    assert hit.normal[0] == pytest.approx(-1, abs=1e-2)
    assert hit.speed == 5
    # On the perimeter of the first ball, as it was before they moved apart.
    assert hypot(hit.point[0] - 2, hit.point[1]) == pytest.approx(1)
    nx, ny = hit.normal
    given = second.velocity[0] - 3, second.velocity[1] - 4
    assert given == (pytest.approx(hit.impulse * nx), pytest.approx(hit.impulse * ny))
    assert hit.impulse > 0


def test_hits_come_in_the_order_of_time() -> None:
    world = World(detection="discrete", gravity=(0, -10))
    world.add(Circle((0, 0), 10))
    for k in range(20):
        world.add(Ball((0.3 * k - 3, 0.2 * k), radius=0.5, velocity=(k, -k)))
    hits = world.run(2)
    assert len(hits) > 100
    assert (np.diff(hits["time"]) >= 0).all()
    assert set(hits["kind"].tolist()) == {HitKind.BOUNCE}


def test_every_field_of_a_row_is_written_and_counted() -> None:
    balls, shapes = ball_rows([(0.0, 0.0, 1.0)]), np.zeros(1, SHAPE)
    state, hits = state_row(balls, "grid", 1), np.full(2, 9, HIT).view(HIT_ROW)
    balls["id"], shapes["id"] = 4, 5
    balls["x"], balls["y"], balls["vx"], balls["vy"] = 1.5, 2.5, -3.0, 6.0
    record_hit(state, hits[0], 0.5, balls[0], shapes[0], (1.0, 2.0, 0.6, 0.8, 0.25), (8.0, 9.0), 3.0, 7.0)
    write_hit(state, hits[1], 0.75, EXIT, balls[0], 5)
    bounce, leave = hits.view(HIT).tolist()
    assert (state["hits"], state["collisions"]) == (2, 1)
    vectors = [np.asarray(part).tolist() for part in bounce]
    assert vectors == [0.5, BOUNCE, 4, 5, [1, 2], [0.6, 0.8], 0.25, 3, 7, [8, 9], [1.5, 2.5]]
    vectors = [np.asarray(part).tolist() for part in leave]
    assert vectors == [0.75, EXIT, 4, 5, [0, 0], [0, 0], 0, 0, 0, [-3, 6], [1.5, 2.5]]
