"""Kernels that came compiled with carom: a shared library in the package, made when its wheel was built.

It is looked for beside this file and nowhere else, and used where it was made from these very sources. It holds
nothing of Python, NumPy or Numba: see `carom.compiler.building`, which makes it.
"""

from __future__ import annotations

import ctypes
import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from carom.compiler.block import Block
from carom.compiler.cache import source_hash
from carom.compiler.kernels import Kernel
from carom.compiler.teller import say

#: The folder of the library, and in it the file that says what the library holds.
FOLDER = Path(__file__).with_name("machine_code")
INDEX = "index.json"

#: What kernels return, by Numba's name of it.
RESULTS: Mapping[str, Any] = {"int64": ctypes.c_int64, "float64": ctypes.c_double}

#: What a kernel of whole numbers returns that came upon something it has no answer to, and no other number it returns.
FAILED = -(2**63)


def symbol_of(function: Kernel) -> str:
    """The name of a kernel in the library."""
    return f"{function.__module__}.{function.__name__}".replace(".", "_")


def found(function: Kernel) -> Kernel | None:
    """A kernel, to be called with the address of a `Block`; None where it did not come compiled, or does not fit."""
    kernels = _kernels(FOLDER)
    return kernels.get(symbol_of(function))


def with_arguments(kernel: Kernel) -> Kernel:
    """A kernel that is called with the address of a `Block`, to be called with its arguments."""

    def call(*arguments: Any) -> Any:
        block = Block(arguments)
        result = kernel(block.address)
        if result == FAILED:
            raise RuntimeError("a compiled kernel came upon what it has no answer to")
        return result

    return call


@cache
def _kernels(folder: Path) -> dict[str, Kernel]:
    """All kernels of the library in a folder, by their names in it; the user is told where it cannot be used."""
    try:
        index = json.loads((folder / INDEX).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    if index["sources"] != source_hash():
        return _refused("it was made from other sources")
    try:
        library = ctypes.CDLL(str(folder / index["library"]))
    except OSError as error:
        return _refused(str(error))
    kernels: dict[str, Kernel] = {}
    for name, result in index["results"].items():
        kernel = getattr(library, name)
        kernel.argtypes, kernel.restype = (ctypes.c_int64,), RESULTS[result]
        kernels[name] = kernel
    return kernels


def _refused(reason: str) -> dict[str, Kernel]:
    """No kernels; the user is told why."""
    say(f"carom: the compiled code that came with it is not used: {reason}")
    return {}
