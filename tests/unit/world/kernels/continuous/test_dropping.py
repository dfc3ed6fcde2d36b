"""At the instant at which a target drops nothing meets it any more, and what it held falls, in whatever steps."""

from random import Random

import numpy as np
import pytest

import carom
from carom import Ball, Circle, Compound, HitKind, Point, Segment, World


def targets(seed: int) -> tuple[World, list[carom.Shape]]:
    """A room with balls, one of which is a sensor, and with targets at rest, that travel and that turn."""
    random = Random(seed)
    gravity = (0, -6) if seed % 2 else (0, 0)
    world = World(gravity=gravity, detection="continuous", sleep_speed=0.05 if seed % 3 == 0 else 0)
    corners = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
    world.add(*(Segment(a, b, elasticity=0.9) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)))
    made: list[carom.Shape] = []
    for number in range(8):
        x, y = random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6)
        if number % 4 == 0:
            shape = Circle((x, y), 0.25, solid=True, once=True, elasticity=0.5)
        elif number % 4 == 1:
            shape = Segment((x - 0.3, y), (x + 0.3, y + 0.05), once=True, elasticity=0.6)
        elif number % 4 == 2:
            shape = Circle((x, y), 0.2, once=True, motion="kinematic", velocity=(0.1, 0.05))
        else:
            parts = [Segment((x, y), (x + 0.4, y)), Point((x, y)), Point((x + 0.4, y))]
            world.add(Compound(parts, (x, y), angular_velocity=0.7, once=True, elasticity=0.3))
            made += parts
            continue
        made.append(world.add(shape))
    for number in range(5):
        place, velocity = ((random.uniform(-size, size), random.uniform(-size, size)) for size in (1.8, 3.0))
        world.add(Ball(place, 0.1, velocity, elasticity=0.95, sensor=number == 4))
    return world, made


@pytest.mark.parametrize("seed", range(4))
def test_each_target_is_bounced_off_once_and_the_same_in_any_steps(seed: int) -> None:
    told, dropped = [], 0
    for steps in (1, 8):
        world, made = targets(seed)
        hits = world.run(1.5, dt=1.5 / steps)
        bounces = hits[hits["kind"] == HitKind.BOUNCE]
        for shape in made:
            assert np.count_nonzero(bounces["shape"] == shape.id) == (0 if shape.can_collide else 1)
        dropped += sum(not shape.can_collide for shape in made)
        told.append((np.asarray(hits).tobytes(), world.balls.position.tobytes(), world.balls.velocity.tobytes()))
    assert told[0] == told[1]
    assert dropped > 0


def test_a_ball_that_was_foreseen_to_bounce_flies_on() -> None:
    world = World(detection="continuous")
    world.add(Segment((0, -2), (0, 2), once=True), Segment((1, -2), (1, 2)))
    fast, slow = world.add(Ball((-2, 1), 0.1, (2, 0)), Ball((-2, -1), 0.1, (1, 0)))
    hits = world.step(4.0)
    assert [(hit.ball, hit.time) for hit in hits] == [(fast, pytest.approx(0.95)), (slow, pytest.approx(2.9))]
    assert hits[1].point == pytest.approx((1.0, -1.0))


def test_a_heap_on_a_target_falls_together() -> None:
    world = World(gravity=(0, -10), detection="continuous")
    shelf = world.add(Segment((-1, 2), (1, 2), once=True, elasticity=0.4))
    heap = [world.add(Ball((-0.6 + 0.2 * number, 2.1), 0.1, elasticity=0.5)) for number in range(3)]
    world.run(0.3)
    world.add(Ball((0.7, 2.4), 0.1))
    hits = world.run(5.0, dt=1 / 50, until=shelf)
    dropped = hits[hits["shape"] == shelf.id]["time"][-1]
    assert not shelf.can_collide
    world.run(0.2, dt=1 / 50)
    fallen = 5 * (world.time - dropped) ** 2
    assert [ball.position[1] for ball in heap] == pytest.approx([2.1 - fallen] * 3, abs=1e-3)


def test_a_sensor_ball_leaves_a_target_that_drops_under_it() -> None:
    world = World(detection="continuous")
    disc = world.add(Circle((0, 0), 1, solid=True, once=True))
    world.add(Ball((0, 0), 0.1, sensor=True), Ball((-3, 0), 0.1, (2, 0)))
    hits = world.run(2.0)
    assert [(hit.kind.name, hit.shape) for hit in hits] == [("ENTER", disc), ("BOUNCE", disc), ("EXIT", disc)]
    assert hits[2].time == hits[1].time
