"""What tests of geometry's functions, compiled and interpreted, have in common."""

import inspect
import struct
from collections.abc import Callable, Iterable, Iterator
from types import ModuleType
from typing import Any


def functions(module: ModuleType) -> list[Callable[..., Any]]:
    """The functions that a module defines itself."""
    found = [part for _, part in inspect.getmembers(module, inspect.isfunction) if part.__module__ == module.__name__]
    return sorted(found, key=lambda function: function.__code__.co_firstlineno)


def register(modules: Iterable[ModuleType]) -> None:
    """Make every function of some modules known to the compiler, for when another calls it."""
    import numba

    for module in modules:
        for function in functions(module):
            numba.extending.register_jitable(function)


def result_bits(result: Any) -> Iterator[bytes]:
    """The bits of a result: of a number, of numbers, of a truth, or of a miss."""
    if result is None or isinstance(result, bool):
        yield repr(result).encode()
    elif isinstance(result, tuple):
        for part in result:
            yield from result_bits(part)
    else:
        yield struct.pack("<d", result)
