"""A kernel and its callees become one program that answers as the interpreter does."""

from typing import Any

import pytest


def deepest(x: float) -> float:
    """What stands at the end of a chain of calls."""
    return x * x + 0.1


def deeper(x: float) -> float:
    """What stands in the middle, and calls the end twice."""
    return deepest(x) - deepest(0.5 * x)


def kernel(x: float) -> float:
    """The kernel."""
    return deeper(x) / deepest(3.0)


@pytest.mark.compiled
def test_callees_are_private_parts_of_their_kernel() -> None:
    numba = pytest.importorskip("numba")
    from carom.compiler.cache import uncached
    from carom.compiler.pipelines import CalleePipeline

    for callee in (deepest, deeper):
        numba.extending.register_jitable(pipeline_class=CalleePipeline)(callee)
    made: Any = uncached(numba, kernel)
    made.compile("f8(f8)")
    assert [made(x) for x in (-1.5, 0.0, 0.7, 1e150)] == [kernel(x) for x in (-1.5, 0.0, 0.7, 1e150)]
    (compiled,) = made.overloads.values()
    shown = [part.name for part in compiled.library.get_defined_functions() if part.linkage.name != "internal"]
    assert shown
    assert not [name for name in shown if "deep" in name]
