"""The one door to Numba: kernels are compiled when a world first needs them.

With `NUMBA_DISABLE_JIT=1`, or without Numba, the same functions run interpreted, bit for bit the same, slowly.
"""

from __future__ import annotations

import os
import threading
from typing import Any

import numpy as np

from carom.compiler.cache import cached, uncached
from carom.compiler.kernels import Kernel, kernel_functions
from carom.compiler.teller import Teller

_loaded: dict[Kernel, Kernel] = {}
_registered: list[Kernel] = []

#: Held by the thread that compiles; others, which may use other worlds, wait for it.
_compiling = threading.RLock()


def load(function: Kernel) -> Kernel:
    """The kernel `function`, compiled where Numba is there and not switched off."""
    if function not in _loaded:
        _loaded[function] = _compile(function)
    return _loaded[function]


def _compile(function: Kernel) -> Kernel:
    """The function compiled by Numba, or the function itself."""
    # SVML gives other last bits than the C library does, so it must be off before Numba is first imported.
    os.environ.setdefault("NUMBA_DISABLE_INTEL_SVML", "1")
    try:
        import numba
    except ImportError:
        return _quiet(function)
    config: Any = numba.config
    if config.DISABLE_JIT:
        return _quiet(function)
    _register_once(numba)
    return _told(numba, function)


def _quiet(function: Kernel) -> Kernel:
    """The function, interpreted without NumPy's warnings: a step that overflows is undone, whoever computes it."""

    def interpreted(*arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*arguments)

    return interpreted


def _register_once(numba: Any) -> None:
    """Tell Numba that it may compile the kernels' callees; the functions themselves stay plain Python."""
    if not _registered:
        _registered.extend(kernel_functions())
        for function in _registered:
            # No Python code calls the compiled callees, so there is no need of wrappers, which take long to compile.
            numba.extending.register_jitable(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)(
                function
            )


def _told(numba: Any, function: Kernel) -> Kernel:
    """The function, which on its first call is compiled, and tells on stderr how far that is and how long it took."""
    compiled: list[Kernel] = []

    def first_call(*arguments: Any) -> Any:
        with _compiling:
            if not compiled:
                return compiling_call(*arguments)
        return compiled[0](*arguments)

    def compiling_call(*arguments: Any) -> Any:
        kernel = cached(numba, function)
        with (
            Teller(function.__name__, len(_registered)) as teller,
            numba.core.event.install_listener("numba:compile", teller.listener(numba)),
        ):
            try:
                result = kernel(*arguments)
            except Exception:  # noqa: BLE001  # whatever reading and writing pickled code may raise
                # The disk is full, or what was kept there is damaged. Nothing has run yet: kernels raise nothing.
                kernel = uncached(numba, function)
                result = kernel(*arguments)
        compiled.append(kernel)
        _loaded.update({key: kernel for key, value in _loaded.items() if value is first_call})
        return result

    return first_call
