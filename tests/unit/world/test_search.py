"""The grids of queries: made when they are worth it, and right after every change."""

import numpy as np
import pytest

from carom import Ball, Segment
from tests.worlds import world_of


@pytest.mark.parametrize("times", [1, 100])
def test_every_change_is_seen_at_once(times: int) -> None:
    wall, vane, ball = Segment((5, -1), (5, 1)), Segment((7, -1), (7, 1), motion="kinematic"), Ball((9, 0), 0.5)
    world = world_of(wall, vane, ball)

    def first() -> float:
        """How far a ray gets, after having been asked often enough for grids to be made."""
        fractions = {world.ray_cast((0, 0), (10, 0)).fraction for _ in range(times)}
        fractions |= set(world.ray_cast(np.zeros((times, 2)), (10, 0))["fraction"])
        assert len(fractions) == 1
        return 10 * fractions.pop()

    assert first() == 5
    wall.position = (6, 0)
    assert first() == 6
    wall.can_collide = False
    assert first() == 7
    vane.position = (7.5, 0)
    assert first() == 7.5
    vane.velocity = (-1, 0)
    for place in (7, 6.5):
        world.step(0.5)
        assert first() == place
    world.remove(vane)
    assert first() == 8.5
    world.balls.position[0] = (9.25, 0)
    assert first() == 8.75
    ball.radius = 1
    assert first() == 8.25
    state = world.snapshot()
    world.add(Segment((1, -1), (1, 1)))
    assert first() == 1
    world.restore(state)
    assert first() == 8.25
    world.add_balls([(4, 0)], radius=1)
    assert first() == 3


def test_what_moves_by_itself_is_seen_where_it_is() -> None:
    vane = Segment((0, -1), (0, 1), motion="kinematic", velocity=(0, 100))
    world = world_of(vane, *(Segment((x, 0), (x, 90)) for x in range(10, 20)))
    starts = np.full((100, 2), (-1.0, 50.0))
    assert not world.ray_cast(starts, (1, 50)).found.any()
    world.step(0.5)
    assert world.ray_cast(starts, (1, 50)).found.all()
    world.step(0.5)
    assert not world.ray_cast(starts, (1, 50)).found.any()
