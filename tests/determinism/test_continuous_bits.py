"""Continuous steps give the same bits run after run, compiled or interpreted, with little room or much."""

import pytest

from tests.fresh import printed
from tests.sample_worlds import bits, crowded, starve

STEPS = 12

PROGRAM = """
from hashlib import blake2b
from tests.sample_worlds import bits, crowded
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


@pytest.mark.compiled
def test_the_same_bits_compiled_and_interpreted() -> None:
    assert printed(PROGRAM) == printed(PROGRAM, NUMBA_DISABLE_JIT="1")
