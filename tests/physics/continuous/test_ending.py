"""Steps end whatever happens in them, and everything stays finite."""

from math import hypot
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from tests.physics.continuous.rooms import exact_world, random_room
from tests.worlds import box, crowded, guarded


def test_a_ball_in_too_many_impacts_stands_still_and_is_counted() -> None:
    world = exact_world(*[carom.Segment((x, -1.0), (x, 1.0)) for x in (0.0, 1.0)], max_impacts=50)
    ball = world.add(carom.Ball((0.5, 0.0), 0.25, velocity=(1000.0, 0.0)))
    assert len(world.step(1.0)) == 50
    assert world.statistics.stalled == 1
    assert hypot(*ball.velocity) == pytest.approx(1000.0, rel=1e-12)
    assert len(world.step(1.0)) == 50


def test_inelastic_collapse_ends() -> None:
    world = exact_world(max_impacts=1000)
    for k, speed in enumerate((1.0, 0.0, -1.0)):
        world.add(carom.Ball((1.5 * k, 0.0), 0.5, velocity=(speed, 0.0), elasticity=0.1))
    for _ in range(3):
        world.step(1.0)
    x = world.balls.position[:, 0]
    assert (np.diff(x) >= 1.0 - 1e-9).all()
    assert world.balls.velocity.sum() == pytest.approx(0.0, abs=1e-12)


def test_balls_that_overlap_at_first_are_moved_apart() -> None:
    world = exact_world(*guarded(box(10.0, 10.0)))
    random = Random(1)
    for _ in range(30):
        world.add(carom.Ball((random.uniform(3.0, 7.0), random.uniform(3.0, 7.0)), 0.5))
    for _ in range(20):
        world.step(0.1)
    position = world.balls.position
    apart = np.hypot(*(position[:, None] - position[None, :]).transpose(2, 0, 1))[np.triu_indices(30, 1)]
    assert apart.min() > 1.0 - 1e-6
    assert ((position > 0.5 - 1e-6) & (position < 9.5 + 1e-6)).all()


@pytest.mark.compiled
@given(seed=st.integers(0, 2**32 - 1), dt=st.sampled_from((0.001, 1 / 60, 1.0)))
def test_worlds_of_everything_stay_finite(seed: int, dt: float) -> None:
    world = crowded(8, seed, detection="continuous")
    for _ in range(3):
        hits = np.asarray(world.step(dt))
        assert np.isfinite(world.balls.position).all()
        assert np.isfinite(world.balls.velocity).all()
        assert np.isfinite(hits["point"]).all()
        assert np.isfinite(hits["impulse"]).all()


@pytest.mark.parametrize("seed", range(8))
def test_many_substeps_find_the_impacts_of_few(seed: int) -> None:
    found = []
    for substeps in (1, 3, 40):
        random = Random(seed)
        world = exact_world(*random_room(random).shapes, substeps=substeps)
        for k in range(4):
            place = (2.0 * (k % 2) - 1.0, 2.0 * (k // 2) - 1.0)
            velocity = (random.gauss(0.0, 6.0), random.gauss(0.0, 6.0))
            world.add(carom.Ball(place, random.uniform(0.3, 0.9), velocity=velocity, mass=random.uniform(0.5, 2.0)))
        hits = np.asarray(world.step(2.0))
        found.append((hits, world.balls.position.copy()))
    for hits, position in found[1:]:
        assert (hits["shape"] == found[0][0]["shape"]).all()
        assert hits["time"] == pytest.approx(found[0][0]["time"], abs=1e-9)
        assert position == pytest.approx(found[0][1], abs=1e-9)
