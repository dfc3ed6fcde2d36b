"""Which functions are kernels: all that stand in a few rooms."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Callable
from functools import cache
from typing import Any

#: The rooms of kernels: all of their files, and no others. Plain functions of floats and rows, held to the house rules.
KERNEL_ROOMS = ("carom.geometry", "carom.rows", "carom.world.kernels")

Kernel = Callable[..., Any]


@cache
def kernel_modules() -> tuple[str, ...]:
    """Every module of the kernels' rooms, by name."""
    rooms = [importlib.import_module(room) for room in KERNEL_ROOMS]
    found = [module for room in rooms for module in pkgutil.walk_packages(room.__path__, f"{room.__name__}.")]
    return tuple(sorted(module.name for module in found if not module.ispkg))


def kernel_functions() -> list[Kernel]:
    """Every function that kernels may call, in the order of their modules."""
    found: list[Kernel] = []
    for module_name in kernel_modules():
        module = importlib.import_module(module_name)
        for _, function in inspect.getmembers(module, inspect.isfunction):
            if function.__module__ == module_name:
                found.append(function)
    return found
