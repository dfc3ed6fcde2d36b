"""What comes, is put or is switched on beside a ball in flight is met as if the flight had begun then."""

from collections.abc import Callable
from typing import Any

import pytest

from carom import Arc, Ball, Circle, Gate, Point, Segment, World

#: What stands across the way of a ball that flies along y = 0, with its middle at (x, 0).
ACROSS: dict[str, Callable[..., Any]] = {
    "segment": lambda x, **options: Segment((x, -3), (x, 3), **options),
    "arc": lambda x, **options: Arc((x - 2, 0), 2, 5.5, 0.8, **options),
    "point": lambda x, **options: Point((x, -0.1), **options),
    "circle": lambda x, **options: Circle((x - 0.3, 0), 0.3, **options),
    "gate": lambda x, **options: Gate((x, -3), (x, 3), direction=(-1, 0), **options),
    "travelling": lambda x, **options: Segment((x, -3), (x, 3), motion="kinematic", velocity=(-0.05, 0), **options),
    "turning": lambda x, **options: Arc(
        (x - 2, 0), 2, 5.5, 0.8, motion="kinematic", pivot=(x - 2, 0), angular_velocity=0.05, **options
    ),
}

PLACE = 5.0


def brought(world: World, how: str, make: Callable[..., Any], sensor: bool) -> Callable[[], Any]:
    """What lets a shape stand across the way from when it is called on."""
    shape = make(50.0 if how == "move" else PLACE, sensor=sensor)
    if how == "add":
        return lambda: world.add(shape)
    world.add(shape)
    if how == "move":
        return lambda: setattr(shape, "position", (shape.position[0] - 45.0, shape.position[1]))
    name, off, on = ("can_collide", False, True) if how == "switch" else ("layer", 2, 1)
    setattr(shape, name, off)
    return lambda: setattr(shape, name, on)


@pytest.mark.parametrize("sensor", [False, True])
@pytest.mark.parametrize("how", ["add", "move", "switch", "layer"])
@pytest.mark.parametrize("kind", ACROSS)
def test_what_a_ball_had_gone_by_before_it_was_there_is_not_met(kind: str, how: str, sensor: bool) -> None:
    for away in (0.02, 0.1, 0.4):
        for friction in (0.0, 0.2):
            world = World(friction=friction)
            ball = world.add(Ball((0, 0), 0.2, velocity=(3, 0), collides_with=1))
            bring = brought(world, how, ACROSS[kind], sensor)
            while ball.position[0] - 0.2 < PLACE + away:
                world.step(0.01)
            bring()
            assert not world.step(0.02)


@pytest.mark.parametrize("how", ["add", "move", "switch", "layer"])
def test_a_ball_in_a_ring_that_was_put_around_it_meets_the_ring_from_within(how: str) -> None:
    world = World()
    ball = world.add(Ball((0, 0), 0.2, velocity=(3, 0), collides_with=1))
    bring = brought(world, how, lambda x, **options: Circle((x, 0), 2.0, **options), False)
    while ball.position[0] < PLACE - 0.5:
        world.step(0.01)
    bring()
    (hit,) = world.run(1.0, 0.01)
    assert (hit.time, ball.velocity) == (pytest.approx((PLACE + 1.8) / 3, abs=1e-12), (-3, 0))
