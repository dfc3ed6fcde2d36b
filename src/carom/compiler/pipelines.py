"""How Numba makes code of kernels and of what they call: as one program, gone through once.

By itself Numba optimises each function together with all that it calls, and makes machine code of that, as if Python
were to call it: a function that stands ten calls deep is gone through ten times. Only the kernel is called from Python,
so here its callees are linked into it as they are, as its private parts, and optimised with it. That takes less time,
and what comes out is faster. Most of what is left is Numba's own work on each function, so no pass goes through them
that finds nothing to do. Imported only where Numba is there. Source: Numba's pages "Customizing the Compiler".
"""

# mypy: allow-untyped-calls

from __future__ import annotations

from typing import Any

from llvmlite.binding import Linkage
from numba.core import cgutils, typed_passes, untyped_passes
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeLowering

#: Passes that find nothing to do in functions without closures, `with`, comprehensions and sums of whole arrays, and
#: one that tells people of types. Each would go through a function, and all that is known of it is found out anew then.
IDLE = {
    typed_passes.AnnotateTypes,
    typed_passes.DumpParforDiagnostics,
    typed_passes.InlineOverloads,
    typed_passes.NopythonRewrites,
    untyped_passes.FindLiterallyCalls,
    untyped_passes.InlineClosureLikes,
    untyped_passes.InlineInlinables,
    untyped_passes.LiteralPropagationSubPipelinePass,
    untyped_passes.LiteralUnroll,
    untyped_passes.MakeFunctionToJitFunction,
    untyped_passes.RewriteDynamicRaises,
    untyped_passes.WithLifting,
}


class KernelLibrary(JITCodeLibrary):
    """The code of a kernel, with that of its callees."""

    def _optimize_final_module(self) -> None:
        """Let LLVM know first that no other code calls the callees: what has one caller becomes part of that."""
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.linkonce_odr:
                function.linkage = Linkage.private
        super()._optimize_final_module()


class CalleeLibrary(JITCodeLibrary):
    """The code of a function that no Python code calls, without that of its callees."""

    def finalize(self) -> None:
        """Leave it as it is: it is linked, checked and optimised with the kernel, and nothing of it could run alone."""
        for function in self._final_module.functions:
            if not function.is_declaration:
                function.linkage = Linkage.linkonce_odr
        self._finalize_dynamic_globals()
        self._finalized = True


class PartLower(Lower):
    """How the code of a function is made: without telling a debugger of its variables and their sizes."""

    def alloca_lltype(self, name: str, lltype: Any, datamodel: Any = None) -> Any:  # noqa: ARG002  # Numba's signature
        """The place of a variable."""
        return cgutils.alloca_once(self.builder, lltype, name=name, zfill=False)


@register_pass(mutates_CFG=True, analysis_only=False)
class KernelLowering(NativeLowering):
    """The pass that makes a kernel's code."""

    _name = "kernel_lowering"
    lowering_class = PartLower

    def run_pass(self, state: Any) -> bool:
        """Whether the state has changed: always."""
        state.library = KernelLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


@register_pass(mutates_CFG=True, analysis_only=False)
class CalleeLowering(NativeLowering):
    """The pass that makes a callee's code, which its callers find by a name."""

    _name = "callee_lowering"
    lowering_class = PartLower

    def run_pass(self, state: Any) -> bool:
        """Whether the state has changed: always."""
        state.library = CalleeLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        # Numba takes nothing but a built-in function for a name; each list's method is one of its own.
        name, made = [].append, state["cr"]  # type: ignore[var-annotated]
        # Who calls it needs what it calls, too.
        libraries = list(dict.fromkeys([state.library, *state.library._linking_libraries]))
        state.targetctx.insert_user_function(name, made.fndesc, libraries)
        state["cr"] = made._replace(cfunc=name)
        return True


class KernelPipeline(CompilerBase):
    """Numba's usual passes over a kernel but for the idle ones and the last."""

    lowering: type[NativeLowering] = KernelLowering

    def define_pipelines(self) -> list[Any]:
        """The one row of passes there is."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        wanted = [(each, why) for each, why in passes.passes if each not in IDLE]
        passes.passes = [(self.lowering if each is NativeLowering else each, why) for each, why in wanted]
        passes.finalize()
        return [passes]


class CalleePipeline(KernelPipeline):
    """The same over what a kernel calls."""

    lowering = CalleeLowering
