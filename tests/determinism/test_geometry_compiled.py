"""Compiled, every function of geometry gives the same bits as interpreted."""

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

import pytest

from carom.geometry import (
    aabb,
    angle,
    arc,
    boxes,
    circle,
    exact,
    figures,
    gap,
    line,
    overlap,
    path,
    ray,
    reach,
    response,
    roots,
    vector,
)
from tests.determinism.both_ways import functions, register, result_bits
from tests.flat import arguments, fields

numba = pytest.importorskip("numba")

pytestmark = pytest.mark.slow

CASES = 300
#: In the order of their imports, so that what a function calls is known to the compiler before it.
MODULES = (
    vector,
    angle,
    path,
    figures,
    exact,
    circle,
    line,
    arc,
    aabb,
    boxes,
    overlap,
    gap,
    response,
    roots,
    reach,
)
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


#: And what crosses sides, but not the rays of its module, which need the times of impact.
CROSSINGS = [function for function in functions(ray) if function.__name__.startswith("crosses_")]
FUNCTIONS = [*(function for module in MODULES for function in functions(module)), *CROSSINGS]


@pytest.fixture(scope="module", autouse=True)
def registered() -> None:
    """Make every function known to the compiler, for when another calls it."""
    register(MODULES)


def numbers(function: Callable[..., Any], random: Random) -> Iterator[float]:
    """Numbers for one call: random, telling, or a mixture."""
    telling = random.choice((0.0, 0.5, 1.0))
    for name, kind in fields(function).items():
        value = random.choice(TELLING) if random.random() < telling else random.uniform(-10.0, 10.0)
        if name.rpartition(".")[2] in {"radius", "r", "r1", "r2", "m1", "m2", "extent", "setback"}:
            value = abs(value) + 1e-200
        yield value > 1.0 if kind is bool else value


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: f"{function.__module__}.{function.__name__}")
def test_compiled_and_interpreted_bits_are_equal(function: Callable[..., Any]) -> None:
    random = Random(function.__qualname__)
    compiled = numba.njit(function)
    for _ in range(CASES):
        given = arguments(function, numbers(function, random))
        assert list(result_bits(compiled(*given))) == list(result_bits(function(*given))), given
