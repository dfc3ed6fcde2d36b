"""What a ball costs that flies far, fast or where nobody is, and what is found there: who is near is told by cells."""

import numpy as np
import pytest

from carom import Ball, World
from carom.constants import FEW_FLIGHTS
from carom.world.kernels.continuous.bins import FILINGS_MOST, TESTS_LEAST
from tests.clock import within
from tests.worlds import box, continuous_world

#: A ball is filed at most so often in a step, and for each ball of the world, if nothing happens to it.
FILINGS, FILINGS_PER_BALL = 150, 2


def others(count: int, seed: int) -> list[Ball]:
    """Balls of several sizes at rest, far enough from each other."""
    random = np.random.default_rng(seed)
    return [Ball((4.0 * k, float(random.uniform(-1, 1))), float(random.choice([1.0, 0.5, 0.02]))) for k in range(count)]


@pytest.mark.parametrize("seed", range(40))
def test_a_step_takes_no_longer_however_far_a_ball_flies_where_nobody_is(seed: int) -> None:
    random = np.random.default_rng(seed)
    count, speed, dt = (
        int(random.integers(FEW_FLIGHTS, 60)),
        10.0 ** random.uniform(2, 300),
        10.0 ** random.uniform(-4, 0),
    )
    velocity = -speed, float(random.uniform(-1, 1)) * speed
    fast = Ball((-3.0, 0.0), float(random.choice([1.0, 0.05])), velocity=velocity)
    world = continuous_world(fast, *others(count, seed))
    for step in range(1, 4):
        with within(60.0):
            assert len(world.step(dt)) == 0
        np.testing.assert_allclose(fast.position, np.array([-3.0, 0.0]) + step * dt * np.array(velocity), rtol=1e-15)
        assert world._arrays.states[0]["bin_filings"] <= FILINGS + FILINGS_PER_BALL * count


def distant_pair(seed: int) -> list[Ball]:
    """Two balls of which one flies at the other, far away; in a second it would be where that was."""
    random = np.random.default_rng(seed)
    away, angle, radius = 10.0 ** random.uniform(0, 12), random.uniform(0, 2 * np.pi), 10.0 ** random.uniform(-2, 0)
    towards = np.array([np.cos(angle), np.sin(angle)])
    place, velocity = (100.0 + 2.0 * radius) * towards, away * towards
    other_radius, other_velocity = float(random.choice([1.0, radius])), random.uniform(-0.5, 0.5) * velocity
    other_place = place + (away + radius + other_radius) * towards
    return [
        Ball(place.tolist(), radius, velocity=velocity.tolist()),
        Ball(other_place.tolist(), other_radius, velocity=other_velocity.tolist()),
    ]


@pytest.mark.parametrize("seed", range(60))
def test_what_meets_far_away_meets_to_the_bit_as_if_there_were_nobody_else(seed: int) -> None:
    alone, among = continuous_world(*distant_pair(seed)), continuous_world(*distant_pair(seed), *others(20, seed))
    found: list[object] = []
    while not found:
        assert alone.time < 4.0
        expected, found = alone.step(0.5).tolist(), among.step(0.5).tolist()
        assert repr(expected) == repr(found)
    assert len(found) == 1
    assert alone.balls.position.tolist() == among.balls.position[:2].tolist()


def thin_gas(seed: int, radius: float) -> World:
    """Two hundred small balls, and a large one, in a room: from one impact to the next they fly far."""
    random = np.random.default_rng(seed)
    world = continuous_world(*box(40.0, 40.0), Ball((38.0, 38.0), 1.0))
    cells = np.stack(np.meshgrid(np.arange(14), np.arange(14)), -1).reshape(-1, 2)
    angles = random.uniform(0, 2 * np.pi, len(cells))
    velocity = 10.0 * np.stack([np.cos(angles), np.sin(angles)], 1)
    world.add_balls(2.0 + 2.5 * cells, velocity, radius=radius)
    return world


@pytest.mark.compiled
@pytest.mark.parametrize("radius", [0.1, 0.01])
def test_cells_become_as_wide_as_pays_in_a_thin_gas(radius: float) -> None:
    world = thin_gas(1, radius)
    state = world._arrays.states[0]
    for _ in range(40):
        world.step(1.0)
    # Since it was asked last whether they are.
    filings, predictions, tests = (int(state[name]) for name in ("bin_filings", "bin_predictions", "bin_tests"))
    assert predictions > 0
    assert filings < 2 * FILINGS_MOST * predictions or tests > 0.5 * TESTS_LEAST * filings
