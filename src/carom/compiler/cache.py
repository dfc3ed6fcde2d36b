"""Compiled code, kept on disk below a folder that is named by a hash of all kernel sources, or forgotten at the end.

Numba alone does not see that a callee in another file has changed. The folder is in the user's cache folder, or in
`CAROM_CACHE_DIR`, and may be deleted at any time.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
from pathlib import Path
from typing import Any

from carom.compiler.kernels import Kernel, kernel_modules

#: Modules whose text matters to the compiled code besides the kernels: constants are compiled in, and what arrays hold.
SOURCES_BESIDES = (
    "carom.constants",
    "carom.compiler.block",
    "carom.compiler.cache",
    "carom.compiler.door",
    "carom.compiler.entered",
    "carom.compiler.pipelines",
    "carom.world.tables",
)

#: What Numba is told: no checks that the interpreter does not make, and other threads may go on meanwhile.
OPTIONS = {"nogil": True, "error_model": "numpy"}


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


def cached(numba: Any, function: Kernel) -> Any:
    """The function, to be compiled when it is called and kept on disk; None where that cannot be written to."""
    folder = cache_folder()
    before = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        kernel: Any = numba.njit(cache=True, pipeline_class=_pipeline(), **OPTIONS)(function)
    except (OSError, RuntimeError):
        return None
    finally:
        numba.config.CACHE_DIR = before
    # Where the folder refuses, Numba turns to one beside the sources, where it would not see that a callee has changed.
    return kernel if Path(kernel.stats.cache_path).is_relative_to(folder) else None


def can_keep() -> bool:
    """Whether compiled code can be kept, as far as is seen without Numba."""
    folder = cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(folder, os.W_OK)


def may_be_kept(function: Kernel) -> bool:
    """False where no code of a kernel is kept for sure, which is seen without Numba."""
    return any(cache_folder().glob(f"*/*.{function.__name__}-*.nbi"))


def uncached(numba: Any, function: Kernel) -> Any:
    """The function, to be compiled when it is called and forgotten when the process ends."""
    return numba.njit(pipeline_class=_pipeline(), **OPTIONS)(function)


def forget(kernel: Any, function: Kernel) -> None:
    """Take what is kept of a kernel out of the cache folder, for it is damaged."""
    for file in Path(kernel.stats.cache_path).glob(f"*.{function.__name__}-*.nb[ic]"):
        try:
            file.unlink(missing_ok=True)
        except OSError:
            return


def _pipeline() -> Any:
    """How Numba compiles a kernel; Numba is imported here."""
    from carom.compiler.pipelines import KernelPipeline

    return KernelPipeline
