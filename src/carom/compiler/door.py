"""The one door to Numba: kernels are compiled when a world first needs them, where they did not come compiled.

By default they run interpreted, bit for bit the same, until a child process has compiled them into the cache on disk.
`CAROM_COMPILE` says otherwise: with `wait` the caller waits for them, with `off` they are always interpreted, as they
are with `NUMBA_DISABLE_JIT=1` and without Numba.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import sys
import threading
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from carom import checks
from carom.compiler import child, prebuilt
from carom.compiler.behind import Behind, NotKept, Size
from carom.compiler.block import Block
from carom.compiler.cache import cache_folder, cached, can_keep, forget, may_be_kept, uncached
from carom.compiler.kernels import Kernel, kernel_functions
from carom.compiler.lock import claimed
from carom.compiler.teller import Teller
from carom.errors import CompileError

#: The variable that says who waits for the compiler, and what it may say.
VARIABLE = "CAROM_COMPILE"
BACKGROUND, WAIT, OFF = WAYS = ("background", "wait", "off")

#: Kernels that stand for what Python cannot say, and what makes code of each, in `carom.compiler.entered`.
STAND_INS = {"call_at": "called", "prefetch": "prefetched", "prefetch_lines": "lines_prefetched"}

_loaded: dict[Kernel, Kernel] = {}
_registered: list[Kernel] = []

#: Held by the thread that compiles; others, which may use other worlds, wait for it.
_compiling = threading.RLock()
#: Held by the thread that imports Numba.
_importing = threading.RLock()


def one(*_: Any) -> tuple[int, float]:
    """The size of a call that is always small: see `Size`."""
    return 1, 1.0


def load(function: Kernel, size: Size = one) -> Kernel:
    """The kernel `function`, compiled where it is, or will be by and by; `size` says how much work a call of it is."""
    if function not in _loaded:
        _loaded[function] = _opened(function, size, Entry)
    return _loaded[function]


def enter(function: Kernel, size: Size = one) -> Kernel:
    """As `load`, of a kernel that is called with a `Block` of its arguments, which costs less.

    Where it is compiled, what comes back is an `At`.
    """
    if function not in _loaded:
        _loaded[function] = _opened(function, size, BlockEntry)
    return _loaded[function]


def keep(function: Kernel, arguments: tuple[Any, ...]) -> float | None:
    """Seconds that it took to compile the kernel `function` for `arguments` and keep it; None if it was there.

    One `Block` is what a kernel is given that is entered.

    Raises:
        CompileError: There is no compiler, it is switched off, or nothing can be kept.
    """
    if way() == OFF:
        raise CompileError(f"nothing is compiled: {VARIABLE} is {OFF!r}")
    numba = _numba()
    if numba is None:
        raise CompileError(
            'nothing is compiled: Numba is not installed (`pip install "carom[compile]"`), or switched off by'
            " NUMBA_DISABLE_JIT"
        )
    entry = (BlockEntry if isinstance(arguments[0], Block) else Entry)(numba, function)
    if not entry.lasting:
        raise CompileError(f"compiled code cannot be kept: {cache_folder()} cannot be written to")
    with _compiling:
        try:
            _loaded[function], seconds = entry.kept(arguments), None
        except NotKept:
            _loaded[function], seconds = entry.made(arguments)
    if not entry.lasting:
        raise CompileError(f"compiled code cannot be kept: {cache_folder()} is full")
    return seconds


def way() -> str:
    """What `CAROM_COMPILE` says; raises `InvalidArgument` where that is nothing it may say."""
    return checks.one_of(VARIABLE, os.environ.get(VARIABLE) or BACKGROUND, WAYS)


def ready_made(function: Kernel) -> Kernel | None:
    """A kernel that came compiled with carom, to be called with the address of a `Block`.

    None where it did not, or where everything is to be interpreted.
    """
    if way() == OFF or os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return None
    return prebuilt.found(function)


def _opened(function: Kernel, size: Size, way_in: type[Entry]) -> Kernel:
    """The function as it is to be called from now on, until it replaces that by something better."""
    chosen = way()
    kernel = ready_made(function)
    if kernel is not None:
        return way_in.ready_made(kernel)
    interpreted = way_in.interpreted(function)
    if chosen == BACKGROUND and child.possible() and _is_at_hand() and can_keep():
        return Behind(function, interpreted, size, Later(function, interpreted, way_in), _compiling)
    numba = None if chosen == OFF else _numba()
    if numba is None:
        return interpreted
    entry = way_in(numba, function)
    if chosen == BACKGROUND and entry.lasting and child.possible():
        return Behind(function, interpreted, size, entry, _compiling)
    return _first_call(entry)


def _is_at_hand() -> bool:
    """Whether Numba is there, is not switched off, and was not imported yet."""
    if "numba" in sys.modules or os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return False
    return importlib.util.find_spec("numba") is not None


def warm() -> None:
    """Import Numba where nobody waits for it."""
    _numba()


def _numba() -> Any:
    """Numba, which knows of all kernels; None where it is missing or switched off."""
    # SVML gives other last bits than the C library does, so it must be off before Numba is first imported.
    os.environ.setdefault("NUMBA_DISABLE_INTEL_SVML", "1")
    try:
        with _importing:
            import numba
    except ImportError:
        return None
    config: Any = numba.config
    if config.DISABLE_JIT:
        return None
    register_once(numba)
    return numba


def _quiet(function: Kernel) -> Kernel:
    """The function, interpreted without NumPy's warnings: a step that overflows is undone, whoever computes it."""

    def interpreted(*arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return function(*arguments)

    return interpreted


def register_once(numba: Any) -> None:
    """Tell Numba that it may compile the kernels' callees; the functions themselves stay plain Python."""
    with _compiling:
        if _registered:
            return
        _registered.extend(kernel_functions())
        from carom.compiler import entered
        from carom.compiler.pipelines import CalleePipeline

        # No Python code calls the compiled callees, so there is no need of wrappers, which take long to compile.
        options = {
            "error_model": "numpy",
            "no_cpython_wrapper": True,
            "no_cfunc_wrapper": True,
            "pipeline_class": CalleePipeline,
        }
        for function in _registered:
            if function.__name__ in STAND_INS:
                meaning = getattr(entered, STAND_INS[function.__name__])
                numba.extending.overload(function, jit_options=options)(meaning)
            else:
                numba.extending.register_jitable(**options)(function)


def _first_call(entry: Entry) -> Kernel:
    """The kernel, which is compiled on its first call, for which the caller waits."""
    compiled: list[Kernel] = []

    def first_call(*arguments: Any) -> Any:
        with _compiling:
            if not compiled:
                try:
                    compiled.append(entry.kept(arguments))
                except NotKept:
                    compiled.append(entry.made(arguments)[0])
        return compiled[0](*arguments)

    return first_call


class Entry:
    """How a kernel comes out of the cache on disk, or into it. From then on, `load` returns it compiled.

    Attributes:
        lasting: Whether what is compiled can be kept.
    """

    #: The kernel as the interpreter runs it.
    interpreted = staticmethod(_quiet)
    #: The kernel as it came with carom, given the function of an address.
    ready_made: Callable[[Kernel], Kernel] = staticmethod(prebuilt.with_arguments)

    def __init__(self, numba: Any, function: Kernel) -> None:
        self._numba = numba
        self._function = function
        self._source = self.source()
        self._kernel = cached(numba, self._source)
        self.lasting = self._kernel is not None

    def kept(self, arguments: tuple[Any, ...]) -> Kernel:
        """The kernel for some arguments as it is kept on disk; raises `NotKept` where it is not."""
        if not self.lasting:
            raise NotKept
        kernel = self._kernel

        class Refusal(self._numba.core.event.Listener):  # type: ignore[misc, name-defined]
            def on_start(self, event: Any) -> None:
                if event.data.get("dispatcher") is kernel:
                    raise NotKept

            def on_end(self, event: Any) -> None:
                pass

        with self._numba.core.event.install_listener("numba:compile", Refusal()):
            try:
                kernel.compile(self._signature(arguments))
            except NotKept:
                raise
            except Exception:  # whatever reading pickled code may raise
                self._forget_damaged(arguments)
                raise  # it came from elsewhere, as from a signal's handler
        return self._settled(kernel)

    def _forget_damaged(self, arguments: tuple[Any, ...]) -> None:
        """Take out of the cache, and raise `NotKept`, what cannot be read a second time either."""
        try:
            self._kernel.compile(self._signature(arguments))
        except Exception:  # noqa: BLE001  # as above
            forget(self._kernel, self._function)
            raise NotKept from None

    def made(self, arguments: tuple[Any, ...]) -> tuple[Kernel, float]:
        """The kernel compiled for some arguments, and how many seconds that took; the user is told of it.

        Where another process compiles it, this waits and takes what that has made.
        """
        teller = Teller(self._function.__name__, len(_registered))
        with teller, self._numba.core.event.install_listener("numba:compile", teller.listener(self._numba)):
            return self._settled(self._made(arguments, teller)), teller.seconds

    def _made(self, arguments: tuple[Any, ...], teller: Teller) -> Any:
        """The kernel, kept on disk where that can be."""
        signature = self._signature(arguments)
        if self.lasting:
            kept: Any = self._kernel
            with claimed(cache_folder(), self._function.__name__, teller.waits) as teller.far:
                try:
                    kept.compile(signature)
                except Exception:  # whatever reading and writing pickled code may raise
                    if teller.compiles and signature not in kept.overloads:
                        raise  # neither: it came from elsewhere, as from a signal's handler
                    # The disk is full, or what was kept there is damaged and cannot be taken away.
                    self.lasting = False
            if self.lasting:
                return kept
        kernel: Any = uncached(self._numba, self._source)
        kernel.compile(signature)
        return kernel

    def source(self) -> Kernel:
        """The function that is compiled."""
        return self._function

    def _signature(self, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
        """What Numba takes the types of arguments to be."""
        return tuple(map(self._numba.typeof, arguments))

    def _settled(self, kernel: Kernel) -> Kernel:
        """The kernel, which `load` returns from now on."""
        _loaded[self._function] = kernel
        return kernel


class Later:
    """Where a kernel comes from as in an `Entry`, for which Numba is imported once it has something to do.

    That takes longer than the first steps do, interpreted.
    """

    def __init__(self, function: Kernel, interpreted: Kernel, way_in: type[Entry]) -> None:
        self._function = function
        self._interpreted = interpreted
        self._way_in = way_in

    @cached_property
    def _entry(self) -> Entry | None:
        """The entry; None where Numba turns out not to be of use."""
        numba = _numba()
        return None if numba is None else self._way_in(numba, self._function)

    def kept(self, arguments: tuple[Any, ...]) -> Kernel:
        """The kernel for some arguments as it is kept on disk; raises `NotKept` where it is not."""
        if not may_be_kept(self._function) or self._entry is None:
            raise NotKept
        return self._entry.kept(arguments)

    def made(self, arguments: tuple[Any, ...]) -> tuple[Kernel, float]:
        """The kernel compiled for some arguments, and how many seconds that took."""
        return (self._interpreted, 0.0) if self._entry is None else self._entry.made(arguments)


class At:
    """A compiled kernel that is called with a `Block`.

    Attributes:
        at: The same, called with the block's address alone.
    """

    def __init__(self, at: Kernel) -> None:
        self.at = at

    @cached_property
    def address(self) -> int:
        """Where its code is, which other compiled code calls likewise, as C does."""
        kernel: Any = self.at
        if not hasattr(kernel, "overloads"):
            return ctypes.cast(kernel, ctypes.c_void_p).value or 0
        (compiled,) = kernel.overloads.values()
        return int(compiled.library.get_pointer_to_function(compiled.fndesc.llvm_cfunc_wrapper_name))

    def __call__(self, block: Block) -> Any:
        """What the kernel returns."""
        return self.at(block.address)


class BlockEntry(Entry):
    """That of a kernel which is called with a `Block`."""

    ready_made = At

    @staticmethod
    def interpreted(function: Kernel) -> Kernel:
        """The kernel, interpreted with the arrays of the block."""
        called = _quiet(function)
        return lambda block: called(*block.arguments)

    def source(self) -> Kernel:
        """The function of an address that calls the kernel."""
        from carom.compiler.entered import entered

        return entered(self._function)

    def _signature(self, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
        """An address; the types of what lies there are noted."""
        from carom.compiler.entered import SIGNATURE, note_kinds

        (block,) = arguments
        note_kinds(self._function, self._numba.typeof(block.arguments))
        return SIGNATURE

    def _settled(self, kernel: Kernel) -> Kernel:
        """The kernel, which `enter` returns from now on."""
        return super()._settled(At(kernel))


def _hold() -> None:
    """Wait until nothing is compiled, and let nobody begin: a process that is forked now could not finish it."""
    _compiling.acquire()
    _importing.acquire()


def _let_go() -> None:
    """Let them begin again."""
    _importing.release()
    _compiling.release()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_let_go, after_in_child=_let_go)
