"""Compiled, every function of geometry gives the same bits as interpreted."""

import inspect
from collections.abc import Callable
from random import Random
from typing import Any

import pytest

from carom.geometry import aabb, angle, arc, circle, entry, line, overlap, response, vector
from tests.determinism.both_ways import functions, numba, register, result_bits

CASES = 300
#: In the order of their imports, so that what a function calls is known to the compiler before it.
MODULES = (vector, angle, circle, line, arc, aabb, overlap, response, entry)
#: Values that coincide, cancel, touch and overflow more often than random ones would.
TELLING = (
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    4.0,
    5.0,
    0.6,
    0.8,
    1e-17,
    -1e-17,
    1e-160,
    1e160,
    1e-9,
    6.283185307179586,
)


FUNCTIONS = [function for module in MODULES for function in functions(module)]


@pytest.fixture(scope="module", autouse=True)
def registered() -> None:
    """Make every function known to the compiler, for when another calls it."""
    register(MODULES)


def arguments(function: Callable[..., Any], random: Random) -> tuple[float, ...]:
    """Arguments for one call: random, telling, or a mixture."""
    names = list(inspect.signature(function).parameters)
    telling = random.choice((0.0, 0.5, 1.0))
    values = [random.choice(TELLING) if random.random() < telling else random.uniform(-10.0, 10.0) for _ in names]
    radii = {"radius", "r", "r1", "r2", "m1", "m2", "extent", "setback"}
    values = [abs(value) + 1e-200 if name in radii else value for name, value in zip(names, values, strict=True)]
    return tuple(int(value > 1.0) if name == "solid" else value for name, value in zip(names, values, strict=True))


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: f"{function.__module__}.{function.__name__}")
def test_compiled_and_interpreted_bits_are_equal(function: Callable[..., Any]) -> None:
    random = Random(function.__qualname__)
    compiled = numba.njit(function)
    for _ in range(CASES):
        given = arguments(function, random)
        assert list(result_bits(compiled(*given))) == list(result_bits(function(*given))), given
