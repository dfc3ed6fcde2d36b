"""Continuous steps give the same bits run after run, compiled or interpreted, with little room or much."""

import numpy as np
import pytest

from carom import Ball
from tests.fresh import printed
from tests.worlds import bits, crowded, starve

STEPS = 12

PROGRAM = """
from hashlib import blake2b
from tests.worlds import bits, crowded
for seed in range(3):
    world = crowded(10, seed, detection="continuous")
    hits = b"".join(bits(world.step(0.05)) for _ in range(12))
    print(world.digest(), blake2b(hits).hexdigest())
"""


def test_the_same_bits_run_after_run() -> None:
    first, second = (crowded(10, 1, detection="continuous") for _ in range(2))
    for _ in range(STEPS):
        assert bits(first.step(0.05)) == bits(second.step(0.05))
    assert first.digest() == second.digest()


def test_the_same_bits_whatever_the_room() -> None:
    first, second = (crowded(10, 1, detection="continuous") for _ in range(2))
    for _ in range(STEPS):
        starve(second)
        assert bits(first.step(0.05)) == bits(second.step(0.05))
    assert first.digest() == second.digest()


@pytest.mark.slow
@pytest.mark.compiled
def test_the_same_bits_compiled_and_interpreted() -> None:
    assert printed(PROGRAM) == printed(PROGRAM, NUMBA_DISABLE_JIT="1")


@pytest.mark.parametrize("seed", range(4))
def test_how_pairs_are_found_changes_nothing(seed: int) -> None:
    first, second = (crowded(10, seed, detection="continuous") for _ in range(2))
    # Beside a ball that goes far in a step, pairs are looked for ball by ball; it meets none of them.
    slow = first.add(Ball((1e4, 0), 0.3, layer=1, collides_with=0))
    fast = second.add(Ball((1e4, 0), 0.3, layer=1, collides_with=0, velocity=(1e4, 0)))
    for _ in range(STEPS):
        assert bits(first.step(0.02)) == bits(second.step(0.02))
    first.remove(slow)
    second.remove(fast)
    assert np.array_equal(first.balls.position, second.balls.position)
