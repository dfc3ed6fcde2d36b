"""A kernel and its callees become one program that answers as the interpreter does."""

import ctypes
import re
from typing import Any

import numpy as np
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


#: A module in which one function calls another, which LLVM must not make part of it.
MODULE = """
define linkonce_odr i64 @callee(i64 %x) noinline {
 %y = mul i64 %x, 3
 ret i64 %y
}
define i64 @caller(i64 %x) {
 %y = call i64 @callee(i64 %x)
 ret i64 %y
}
"""


@pytest.mark.compiled
def test_a_kernel_and_its_callees_answer_as_the_interpreter_does() -> None:
    numba = pytest.importorskip("numba")
    from carom.compiler.cache import uncached
    from carom.compiler.pipelines import CalleeLibrary, CalleePipeline, KernelLibrary

    for callee in (deepest, deeper):
        numba.extending.register_jitable(pipeline_class=CalleePipeline)(callee)
    made: Any = uncached(numba, kernel)
    made.compile("f8(f8)")
    assert [made(x) for x in (-1.5, 0.0, 0.7, 1e150)] == [kernel(x) for x in (-1.5, 0.0, 0.7, 1e150)]
    (compiled,) = made.overloads.values()
    assert isinstance(compiled.library, KernelLibrary)
    parts = {part for part in compiled.library._linking_libraries if isinstance(part, CalleeLibrary)}
    assert {part.name for part in parts} == {"deeper", "deepest"}
    held = [(part.name, function.name) for part in parts for function in part.get_defined_functions()]
    assert all(f"{len(name)}{name}" in function for name, function in held), "none holds what another one is"


def sum_of_ends(table: Any, flag: bool) -> float:
    """What has a loop, a record's fields, a pair, and an answer that may be missing."""
    total = 0.0
    for row in range(len(table)):
        found = (table[row]["x"], table[row]["y"]) if flag or row > 2 else None
        if found is not None:
            x, y = found
            while x < y and not flag:
                x += 1.0
            total += x
    return total


@pytest.mark.compiled
def test_a_pass_that_is_left_out_would_have_changed_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    numba = pytest.importorskip("numba")
    from carom.compiler import pipelines
    from carom.compiler.cache import uncached

    table = numba.typeof(np.zeros(1, [("x", "f8"), ("y", "f8")]))
    counts, texts = [], []
    for idle in (pipelines.IDLE, set()):
        monkeypatch.setattr(pipelines, "IDLE", idle)
        made: Any = uncached(numba, sum_of_ends)
        made.compile((table, numba.types.boolean))
        (compiled,) = made.overloads.values()
        counts.append(len(compiled.metadata["pipeline_times"]["nopython"]))
        # Numba numbers what it compiles, by which its names have other lengths too.
        texts.append(re.sub(r"B\d+v\d+|\[\d+ x i8\]", "", compiled.library.get_llvm_str()))
    assert counts[0] <= counts[1] - 12
    assert texts[0] == texts[1]


def library_of(kind: Any, name: str, module: str) -> Any:
    """A library of some kind that holds a module, and has its code."""
    from llvmlite import binding
    from numba.core.compiler_lock import global_compiler_lock
    from numba.core.registry import cpu_target

    library: Any = kind(cpu_target.target_context.codegen(), name)
    library.add_llvm_module(binding.parse_assembly(module))
    with global_compiler_lock:
        library.finalize()
    return library


@pytest.mark.compiled
def test_callees_are_private_parts_of_a_kernel_and_have_no_code_of_their_own() -> None:
    pytest.importorskip("numba")
    from carom.compiler.pipelines import CalleeLibrary, KernelLibrary

    callee = library_of(CalleeLibrary, "Callee", MODULE.replace("@c", "@Callee_c"))
    caller = library_of(KernelLibrary, "Kernel", MODULE.replace("@c", "@Kernel_c"))
    linkages = {part.name: part.linkage.name for part in caller.get_defined_functions()}
    assert linkages == {"Kernel_callee": "private", "Kernel_caller": "external"}
    assert caller.get_pointer_to_function("Kernel_caller")
    assert not callee.get_pointer_to_function("Callee_caller")


@pytest.mark.compiled
def test_what_else_is_compiled_does_not_call_a_kernels_private_parts() -> None:
    pytest.importorskip("numba")
    from numba.core.codegen import JITCodeLibrary

    from carom.compiler.pipelines import KernelLibrary

    # A function of one name in both; by itself Numba makes no difference between such.
    kernel = library_of(KernelLibrary, "Mine", MODULE.replace("@callee", "@shared").replace("@caller", "@mine"))
    assert kernel.get_pointer_to_function("mine")
    text = MODULE.replace("@callee", "@shared").replace("@caller", "@other").replace("%x, 3", "%x, 5")
    other = library_of(JITCodeLibrary, "Other", text)
    call = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64)
    assert call(other.get_pointer_to_function("other"))(2) == 10
    assert call(kernel.get_pointer_to_function("mine"))(2) == 6
