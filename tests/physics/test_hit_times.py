"""Hits have times within their step, in order, whatever the balls are like when it begins."""

from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Circle, Hits, ImpactLimit, Segment, World
from carom.world.hits import NO_ROWS


def heap(random: Random, detection: Any) -> World:
    """Balls that overlap each other and the walls of a box, sensors among them."""
    side = random.choice((1, 2, 4))
    world = World(
        detection=detection,
        substeps=random.choice((1, 2, 4)),
        gravity=random.choice(((0, 0), (0, -10), (0, -100))),
        max_impacts=500,
    )
    corners = [(0, 0), (side, 0), (side, side), (0, side)]
    for k in range(4):
        world.add(Segment(corners[k - 1], corners[k], elasticity=random.choice((1, 0.5, 0))))
    if random.random() < 0.5:
        world.add(Circle((0.5 * side, 0.5 * side), 0.2 * side, sensor=True))
    places = [(random.uniform(0, side), random.uniform(0, side)) for _ in range(3)]
    for _ in range(random.randint(2, 12)):
        x, y = random.choice(places)
        spread = random.choice((0.0, 0.05, 0.05, 0.05))
        world.add(
            Ball(
                (x + random.gauss(0, spread), y + random.gauss(0, spread)),
                random.uniform(0.05, 0.4),
                random.choice(((0.0, 0.0), (random.gauss(0, 2), random.gauss(0, 2)))),
                mass=random.choice((1.0, 10 ** random.uniform(-2, 2))),
                elasticity=random.choice((1.0, 0.5, 0.0)),
                sensor=random.random() < 0.1,
            )
        )
    return world


def step_of(world: World, dt: float) -> Hits:
    """The hits of a step, or of as much of it as `max_impacts` allows."""
    try:
        return world.step(dt)
    except ImpactLimit as limit:
        return Hits.of(world, NO_ROWS) if limit.hits is None else limit.hits


@pytest.mark.slow
@pytest.mark.compiled
@given(st.integers(0, 2**32 - 1), st.sampled_from(["discrete", "continuous"]))
def test_times_of_hits_lie_within_their_step_and_in_order(seed: int, detection: Any) -> None:
    random = Random(seed)
    world = heap(random, detection)
    for _ in range(4):
        before = world.time
        times = step_of(world, random.choice((1 / 60, 0.1, 1.0)))["time"]
        assert (times >= before).all()
        assert (times <= world.time).all()
        assert (np.diff(times) >= 0.0).all()


@pytest.mark.compiled
def test_a_ball_that_is_pushed_far_off_does_not_fly_back_in_time() -> None:
    """Pushed farther than the margin of its cell, it was filed anew at a time that was past."""
    for seed in (22, 45, 70, 89, 91):
        world = heap(Random(seed), "continuous")
        for _ in range(2):
            before = world.time
            assert (step_of(world, 0.1)["time"] >= before).all()
