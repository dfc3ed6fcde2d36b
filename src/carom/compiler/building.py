"""Making the shared library of compiled kernels that a wheel brings along: see `carom.compiler.prebuilt`.

Each kernel is compiled to be called with the address of a `Block`, for a plain processor, so that the library runs on
all that are not very old. Kernels allocate nothing, so nothing of Numba is needed when they run: what is left of its
counting of references never finds an array that it owns, and what becomes of errors, which kernels do not raise, is
one number. Imported only where wheels are built.
"""

from __future__ import annotations

import json
import os
import platform
import re
import shlex
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numba
from numba.core.registry import cpu_target

from carom.compiler.block import Block
from carom.compiler.cache import OPTIONS, source_hash
from carom.compiler.door import register_once
from carom.compiler.entered import SIGNATURE, entered, note_kinds
from carom.compiler.kernels import Kernel
from carom.compiler.prebuilt import FAILED, INDEX, RESULTS, symbol_of

#: Numba, whose types do not know all that it takes.
compiler: Any = numba

#: The processors that the library is made for, by the machine's name; "generic", the plainest, for all others.
PROCESSORS = {"x86_64": "x86-64-v2", "AMD64": "x86-64-v2"}

#: How a linker is told to make a shared library with no loose ends, by `sys.platform`, and what that is called.
LINKING = {"darwin": ("-dynamiclib", "-lm"), "win32": ("-shared",)}
LINKING_ELSEWHERE = ("-shared", "-s", "-Wl,--no-undefined", "-lm")
NAMES = {"darwin": "kernels.dylib", "win32": "kernels.dll"}

#: Where a function of Numba's notes an error, with the text of a traceback, which nobody reads.
NOTE_OF_ERROR = re.compile(r"^.*\bstore ptr @\.const\.picklebuf\..*\n", re.MULTILINE)

#: What Numba's runtime would do with an array whose last reference is gone.
RUNTIME = "define void @NRT_MemInfo_call_dtor(ptr %info) {\n ret void\n}\n"

#: A function of an address. Numba's own gives a status, writes its result to one place and its errors to another.
ENTRY = """
declare i32 @{function}(ptr, ptr, i64)
define {export} {result} @{symbol}(i64 %address) {{
 %result = alloca {result}
 %error = alloca ptr
 %status = call i32 @{function}(ptr %result, ptr %error, i64 %address)
 %fine = icmp eq i32 %status, 0
 %value = load {result}, ptr %result
 %answer = select i1 %fine, {result} %value, {result} {failed}
 ret {result} %answer
}}
"""

#: LLVM's name of what a kernel returns, and what that is after an error, by Numba's name of it.
KINDS = {"int64": ("i64", str(FAILED)), "float64": ("double", "0x7FF8000000000000")}


def build(kernels: Mapping[Kernel, tuple[Any, ...]], folder: Path) -> None:
    """Make the library of some kernels, for arguments of the types of those given, and its index, in a folder.

    Raises:
        RuntimeError: Numba has compiled for this very processor already, so a fresh process is needed.
        subprocess.CalledProcessError: The linker, `cc` or what `CC` says, has refused.
    """
    processor = PROCESSORS.get(platform.machine(), "generic")
    _choose(processor)
    texts, results = [RUNTIME], {}
    for function, arguments in kernels.items():
        symbol = symbol_of(function)
        text, name, results[symbol] = _compiled(function, arguments)
        texts += [text, _entry(symbol, name, results[symbol])]
    library = NAMES.get(sys.platform, "kernels.so")
    made = folder / "kernels.o"
    made.write_bytes(_machine_code(texts, set(results), processor))
    _link(made, folder / library)
    made.unlink()
    index = {"sources": source_hash(), "processor": processor, "library": library, "results": results}
    (folder / INDEX).write_text(json.dumps(index, indent=1), encoding="utf-8")


def _choose(processor: str) -> None:
    """Have Numba compile for a processor, and with the C library's own sine and cosine."""
    config = compiler.config
    config.CPU_NAME, config.CPU_FEATURES, config.DISABLE_INTEL_SVML = processor, "", 1
    if cpu_target.target_context.codegen().magic_tuple()[1:] != (processor, ""):
        raise RuntimeError("Numba has compiled in this process already: a library is made in a fresh one")
    register_once(compiler)


def _compiled(function: Kernel, arguments: tuple[Any, ...]) -> tuple[str, str, str]:
    """LLVM's text of a kernel that is called with an address, the function's name there, and what it returns."""
    block = arguments[0] if isinstance(arguments[0], Block) else Block(arguments)
    note_kinds(function, compiler.typeof(block.arguments))
    kernel = compiler.njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, **OPTIONS)(entered(function))
    kernel.compile(SIGNATURE)
    (made,) = kernel.overloads.values()
    text = NOTE_OF_ERROR.sub("", str(made.library._final_module))
    return text, made.fndesc.llvm_func_name, str(made.signature.return_type)


def _entry(symbol: str, function: str, result: str) -> str:
    """LLVM's text of the function that the library shows for a kernel."""
    assert result in RESULTS
    kind, failed = KINDS[result]
    export = "dllexport" if sys.platform == "win32" else ""
    return ENTRY.format(symbol=symbol, function=function, export=export, result=kind, failed=failed)


def _machine_code(texts: list[str], shown: set[str], processor: str) -> bytes:
    """The object file of LLVM's texts, in which all is private but the functions shown."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_triple(llvm.get_process_triple())
    machine = target.create_target_machine(cpu=processor, features="", opt=3, reloc="pic", codemodel="default")
    module = llvm.parse_assembly(texts[0])
    for text in texts[1:]:
        module.link_in(llvm.parse_assembly(text))
    module.triple, module.data_layout = target.triple, str(machine.target_data)
    for part in (*module.functions, *module.global_variables):
        if not part.is_declaration and part.name not in shown:
            part.linkage = "internal"
    # Callees see each other only now, and what counts references turns out to have nothing to do.
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=3))
    passes.getModulePassManager().run(module, passes)
    return bytes(machine.emit_object(module))


def _link(made: Path, library: Path) -> None:
    """Make a shared library of an object file with the platform's C compiler."""
    compiler = shlex.split(os.environ.get("CC") or ("clang" if sys.platform == "win32" else "cc"))
    options = LINKING.get(sys.platform, LINKING_ELSEWHERE)
    subprocess.run([*compiler, str(made), "-o", str(library), *options], check=True)
