"""Balls that meet keep their momentum at every elasticity, and their energy at elasticity 1."""

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Segment, World, scenes
from tests.strategies import elasticities, masses, unit_vectors, vectors
from tests.worlds import energy

Vector = tuple[float, float]


def momentum(world: World) -> np.ndarray:
    """The sum of the balls' momenta."""
    return (world.balls.velocity * world.balls.mass[:, None]).sum(axis=0)


@given(vectors, vectors, masses, masses, unit_vectors, elasticities, st.sampled_from((0.0, 0.3, 0.99)))
def test_a_pair_keeps_its_momentum_and_never_gains_energy(
    v1: Vector, v2: Vector, m1: float, m2: float, n: Vector, e: float, deep: float
) -> None:
    world = World(detection="discrete", substeps=1, iterations=1, rest_speed=0.5)
    reach = 3.0 * (1.0 - deep)
    world.add(Ball((1, -2), 1, v1, m1, elasticity=min(e, 1.0)))
    world.add(Ball((1 + reach * n[0], -2 + reach * n[1]), 2, v2, m2))
    before, total = momentum(world), energy(world)
    world.step(0.0)
    scale = m1 * hypot(*v1) + m2 * hypot(*v2)
    assert momentum(world) == pytest.approx(before, rel=0.0, abs=1e-12 * scale)
    assert energy(world) <= total * (1.0 + 1e-12)
    if e == 1.0:
        assert energy(world) == pytest.approx(total, rel=1e-12)


@given(masses, masses, unit_vectors, elasticities)
def test_the_common_centre_of_mass_does_not_move(m1: float, m2: float, n: Vector, e: float) -> None:
    world = World(detection="discrete", substeps=1, iterations=1)
    world.add(Ball((0, 0), 1, mass=m1))
    world.add(Ball((1.5 * n[0], 1.5 * n[1]), 1, mass=m2, elasticity=e))
    before = (world.balls.position * world.balls.mass[:, None]).sum(axis=0)
    world.step(0.0)
    after = (world.balls.position * world.balls.mass[:, None]).sum(axis=0)
    assert after == pytest.approx(before, rel=0.0, abs=1e-14 * (m1 + m2))
    apart = world.balls.position[1] - world.balls.position[0]
    assert hypot(*apart) == pytest.approx(2, rel=1e-14)


@pytest.mark.compiled
@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_crowd_keeps_its_momentum_and_energy(phase: str) -> None:
    rng = np.random.default_rng(11)
    world = World(detection="discrete", broad_phase=phase)
    grid = np.stack(np.meshgrid(np.arange(7.0), np.arange(7.0)), -1).reshape(-1, 2)
    world.add_balls(grid, rng.normal(0, 3, (49, 2)), radius=rng.uniform(0.2, 0.5, 49), mass=rng.uniform(0.1, 9, 49))
    before, total = momentum(world), energy(world)
    hits = world.run(1)
    assert len(hits) > 40
    assert momentum(world) == pytest.approx(before, abs=1e-12 * np.abs(before).sum())
    assert energy(world) == pytest.approx(total, rel=1e-12)


def test_an_inelastic_crowd_loses_energy_and_no_momentum() -> None:
    rng = np.random.default_rng(12)
    world = World(detection="discrete")
    grid = np.stack(np.meshgrid(np.arange(7.0), np.arange(7.0)), -1).reshape(-1, 2)
    world.add_balls(grid, rng.normal(0, 3, (49, 2)), radius=0.45, mass=rng.uniform(0.1, 9, 49), elasticity=0.8)
    before, last = momentum(world), energy(world)
    for _ in range(40):
        world.step(1 / 60)
        assert energy(world) <= last * (1 + 1e-12)
        last = energy(world)
    assert momentum(world) == pytest.approx(before, abs=1e-11)


def test_every_hit_of_a_crowd_gives_what_it_says() -> None:
    rng = np.random.default_rng(13)
    world = World(detection="discrete", substeps=1, iterations=1)
    for _ in range(40):
        world.add(Ball(tuple(rng.uniform(-3, 3, 2)), 0.4, tuple(rng.normal(0, 3, 2)), rng.uniform(0.5, 3)))
    expected = world.balls.velocity.copy() * world.balls.mass[:, None]
    for hit in world.step(1 / 60):
        given = hit.impulse * np.array(hit.normal)
        expected[list(world.balls).index(hit.ball)] += given
        expected[list(world.balls).index(hit.shape)] -= given
    assert world.balls.velocity * world.balls.mass[:, None] == pytest.approx(expected, abs=1e-12)


def test_newton_s_cradle_passes_a_swing_on_whole() -> None:
    world = World(detection="discrete", substeps=1)
    balls = [world.add(Ball((2 * k, 0), radius=1)) for k in range(5)]
    striker = world.add(Ball((-5, 0), radius=1, velocity=(2, 0)))
    world.run(3)
    assert striker.velocity == (0, 0)
    assert [ball.velocity for ball in balls] == [(0, 0)] * 4 + [(2, 0)]


@pytest.mark.compiled
def test_the_gas_keeps_its_energy() -> None:
    world = scenes.gas(balls=200).build()
    total = energy(world)
    world.run(5)
    assert energy(world) == pytest.approx(total, rel=1e-12)


def test_a_light_ball_on_a_heavy_one_is_thrown_up_threefold() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((-9, 0), (9, 0)))
    world.add(Ball((0, 1), radius=1, velocity=(0, -1), mass=1e9))
    light = world.add(Ball((0, 2.5), radius=0.5, velocity=(0, -1)))
    world.step(1e-9)
    assert light.velocity[1] == pytest.approx(3, rel=1e-6)
