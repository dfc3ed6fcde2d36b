"""The one place that knows Numba: compiles the kernels when a world first needs them, and keeps the result on disk.

The cache is keyed by a hash of all kernel sources, because Numba alone does not see that a callee in another file has
changed. It lives in the user's cache folder (or in `CAROM_CACHE_DIR`) and may be deleted at any time. With
`NUMBA_DISABLE_JIT=1`, or without Numba, the same functions run interpreted, bit for bit the same, slowly.
"""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import inspect
import os
import pkgutil
import sys
import threading
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, Self

import numpy as np

#: The rooms of kernels: all of their files, and no others. Plain functions of floats and rows, held to the house rules.
KERNEL_ROOMS = ("carom.geometry", "carom.rows", "carom.world.kernels")

#: Modules whose text matters to the compiled code besides the kernels: constants are compiled in.
SOURCES_BESIDES = ("carom.constants", "carom.compiler.kernels")

Kernel = Callable[..., Any]

#: What Numba is told: no checks that the interpreter does not make, and other threads may go on meanwhile.
_OPTIONS = {"nogil": True, "error_model": "numpy"}

#: Seconds between two lines about compiling where stderr is no terminal.
INTERVAL = 5.0

_loaded: dict[Kernel, Kernel] = {}

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


def _cached(numba: Any, function: Kernel) -> Kernel:
    """The function, to be compiled when it is called and kept in the cache folder, if that can be written to."""
    folder = cache_folder()
    before = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        kernel: Any = numba.njit(cache=True, **_OPTIONS)(function)
    except (OSError, RuntimeError):
        return _uncached(numba, function)
    finally:
        numba.config.CACHE_DIR = before
    # Where the folder refuses, Numba turns to one beside the sources, where it would not see that a callee has changed.
    kept_there = Path(kernel.stats.cache_path).is_relative_to(folder)
    return kernel if kept_there else _uncached(numba, function)


def _uncached(numba: Any, function: Kernel) -> Kernel:
    """The function, to be compiled when it is called and forgotten when the process ends."""
    kernel: Kernel = numba.njit(**_OPTIONS)(function)
    return kernel


def _quiet(function: Kernel) -> Kernel:
    """The function, interpreted without NumPy's warnings: a step that overflows is undone, whoever computes it."""

    def interpreted(*arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*arguments)

    return interpreted


_registered: list[Kernel] = []


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


def _register_once(numba: Any) -> None:
    """Tell Numba that it may compile the kernels' callees; the functions themselves stay plain Python."""
    if not _registered:
        _registered.extend(kernel_functions())
        for function in _registered:
            # No Python code calls the compiled callees, so there is no need of wrappers, which take long to compile.
            numba.extending.register_jitable(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)(
                function
            )


def source_hash() -> str:
    """A hash of the text of all kernel sources."""
    digest = hashlib.blake2b(digest_size=12)
    for module_name in kernel_modules() + SOURCES_BESIDES:
        spec = importlib.util.find_spec(module_name)
        if spec is not None and spec.origin is not None:
            digest.update(Path(spec.origin).read_bytes())
    return digest.hexdigest()


def cache_folder() -> Path:
    """The folder of compiled code for these sources: below `CAROM_CACHE_DIR`, or below the user's cache folder."""
    chosen = os.environ.get("CAROM_CACHE_DIR")
    if chosen:
        return Path(chosen) / source_hash()
    import platformdirs

    return Path(platformdirs.user_cache_dir("carom")) / source_hash()


def _told(numba: Any, function: Kernel) -> Kernel:
    """The function, which on its first call is compiled, and tells on stderr how far that is and how long it took."""
    compiled: list[Kernel] = []

    def first_call(*arguments: Any) -> Any:
        with _compiling:
            if not compiled:
                return compiling_call(*arguments)
        return compiled[0](*arguments)

    def compiling_call(*arguments: Any) -> Any:
        kernel = _cached(numba, function)
        with (
            _Teller(function.__name__) as teller,
            numba.core.event.install_listener("numba:compile", teller.listener(numba)),
        ):
            try:
                result = kernel(*arguments)
            except Exception:  # noqa: BLE001  # whatever reading and writing pickled code may raise
                # The disk is full, or what was kept there is damaged. Nothing has run yet: kernels raise nothing.
                kernel = _uncached(numba, function)
                result = kernel(*arguments)
        compiled.append(kernel)
        _loaded.update({key: kernel for key, value in _loaded.items() if value is first_call})
        return result

    return first_call


class _Teller:
    """While entered, counts the functions that Numba compiles and tells of it, if it has to compile at all.

    On a terminal one line says how far it is. Anywhere else that would be nothing but control characters, so there a
    line of its own says it every `INTERVAL` seconds: a log that stands still looks like a program that does.
    """

    def __init__(self, name: str) -> None:
        self._name = name.replace("_", " ")
        self._seen: set[str] = set()
        self._over = threading.Event()
        self._terminal = sys.stderr is not None and sys.stderr.isatty()

    def __enter__(self) -> Self:
        self._began = time.perf_counter()
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        self._over.set()
        if not self._seen:
            return
        if kind is None:
            seconds = time.perf_counter() - self._began
            self._say(f"{self._start}carom: compiled {self._name} in {seconds:.1f} s")
        elif self._terminal:
            self._say("")

    @property
    def _start(self) -> str:
        """What a line begins with that takes the place of the one before, where it can."""
        return "\r" if self._terminal else ""

    def _far(self) -> str:
        """How far it is."""
        return f"{len(self._seen)} of about {len(_registered)} functions"

    def _say(self, text: str, end: str = "\n") -> None:
        """Write to stderr, which a program without a console has not."""
        if sys.stderr is not None:
            print(text, end=end, file=sys.stderr, flush=True)

    def listener(self, numba: Any) -> Any:
        """A Numba listener that reports to this teller."""
        teller = self

        class Listener(numba.core.event.Listener):  # type: ignore[misc]
            def on_start(self, event: Any) -> None:
                teller.see(str(getattr(event.data.get("dispatcher"), "__name__", "")))

            def on_end(self, event: Any) -> None:
                pass

        return Listener()

    def see(self, function: str) -> None:
        """Take note of one more function being compiled."""
        first = not self._seen
        self._seen.add(function)
        if first:
            self._say(f"carom: compiling {self._name}, once on this machine ...")
        if self._terminal:
            self._say(f"\rcarom: {self._far()}", end="")
        elif first:
            # A thread of its own: the last and longest part of the work is a single call.
            threading.Thread(target=self._tell_on, name="carom-compiling", daemon=True).start()

    def _tell_on(self) -> None:
        """Say that it goes on, every few seconds until it is over."""
        while not self._over.wait(INTERVAL):
            seconds = time.perf_counter() - self._began
            self._say(f"carom: compiling {self._name}: {self._far()}, {seconds:.0f} s")
