"""How Numba makes code of kernels and of what they call: as one program, gone through once.

By itself Numba optimises each function together with all that it calls, and makes machine code of that, as if Python
were to call it: a function that stands ten calls deep is gone through ten times. Only the kernel is called from Python,
so here its callees are linked into it as they are, as its private parts, and optimised with it. That takes three fifths
of the time, and what comes out is faster. Imported only where Numba is there. Source: Numba's pages "Customizing the
Compiler".
"""

# mypy: allow-untyped-calls

from __future__ import annotations

from typing import Any

from llvmlite.binding import Linkage
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.typed_passes import NativeLowering


class KernelLibrary(JITCodeLibrary):
    """The code of a kernel, with that of its callees."""

    def _optimize_final_module(self) -> None:
        """Let LLVM know first that no other code calls the callees: what has one caller becomes part of that."""
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.linkonce_odr:
                function.linkage = Linkage.private
        super()._optimize_final_module()


class CalleeLibrary(JITCodeLibrary):
    """The code of a function that no Python code calls."""

    def _optimize_final_module(self) -> None:
        """Leave that to the kernel's library."""

    def _finalize_final_module(self) -> None:
        """Make nothing of it that could run."""
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class KernelLowering(NativeLowering):
    """The pass that makes a kernel's code."""

    _name = "kernel_lowering"

    def run_pass(self, state: Any) -> bool:
        """Whether the state has changed: always."""
        state.library = KernelLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


@register_pass(mutates_CFG=True, analysis_only=False)
class CalleeLowering(NativeLowering):
    """The pass that makes a callee's code, which its callers find by a name."""

    _name = "callee_lowering"

    def run_pass(self, state: Any) -> bool:
        """Whether the state has changed: always."""
        state.library = CalleeLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        # Numba takes nothing but a built-in function for a name; each list's method is one of its own.
        name, made = [].append, state["cr"]  # type: ignore[var-annotated]
        state.targetctx.insert_user_function(name, made.fndesc, [state.library])
        state["cr"] = made._replace(cfunc=name)
        return True


class KernelPipeline(CompilerBase):
    """Numba's usual passes over a kernel but for the last."""

    lowering: type[NativeLowering] = KernelLowering

    def define_pipelines(self) -> list[Any]:
        """The one row of passes there is."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.passes = [(self.lowering if each is NativeLowering else each, why) for each, why in passes.passes]
        passes.finalize()
        return [passes]


class CalleePipeline(KernelPipeline):
    """The same over what a kernel calls."""

    lowering = CalleeLowering
