"""The library of compiled kernels: nothing of Numba in it, nothing that only new processors have, and the same bits."""

import ctypes
import json
import platform
import shutil
import subprocess
from pathlib import Path

import pytest

from carom.compiler.cache import source_hash
from carom.compiler.prebuilt import FAILED, INDEX, RESULTS
from carom.errors import CompileError
from carom.world import ahead
from tests import fresh

pytestmark = [pytest.mark.compiled, pytest.mark.skipif(shutil.which("cc") is None, reason="needs a C compiler")]

#: A function as Numba makes it: it returns a number, with the status that it was given, and notes what went wrong.
FUNCTION = """
@.const.picklebuf.0 = internal constant i64 0
define i32 @made(ptr %result, ptr %error, i64 %address) {{
  store {kind} {value}, ptr %result
  store ptr @.const.picklebuf.0, ptr %error, align 8
  call void @NRT_MemInfo_call_dtor(ptr null)
  %status = trunc i64 %address to i32
  ret i32 %status
}}
declare void @NRT_MemInfo_call_dtor(ptr)
"""


@pytest.mark.parametrize(
    ("result", "kind", "value", "number"), [("int64", "i64", "42", 42), ("float64", "double", "1.5", 1.5)]
)
def test_an_entry_returns_the_result_or_what_says_that_there_is_none(
    result: str, kind: str, value: str, number: float, tmp_path: Path
) -> None:
    building = pytest.importorskip("carom.compiler.building")
    text = building.NOTE_OF_ERROR.sub("", FUNCTION.format(kind=kind, value=value))
    assert "%error, align" not in text
    texts = [building.RUNTIME, text, building._entry("shown", "made", result)]
    (tmp_path / "made.o").write_bytes(building._machine_code(texts, {"shown"}, "generic"))
    building._link(tmp_path / "made.o", tmp_path / "made.so")
    library = ctypes.CDLL(str(tmp_path / "made.so"))
    library.shown.argtypes, library.shown.restype = (ctypes.c_int64,), RESULTS[result]
    assert library.shown(0) == number
    for status in (-1, 1, 5):
        failed = library.shown(status)
        assert failed != failed if result == "float64" else failed == FAILED
    assert not hasattr(library, "made"), "it is private"


BUILD = "import sys; from carom.world.ahead import prebuild; prebuild(*sys.argv[1:])"

#: Builds a grid of queries, and prints what became of it.
ASK = """
import sys
from pathlib import Path
import numpy as np
from carom.compiler import door, prebuilt
if len(sys.argv) > 1:
    sys.modules["numba"] = None
    prebuilt.FOLDER = Path(sys.argv[1])
from carom.compiler.block import Block
from carom.rows.query import SEARCH_GRID
from carom.world.kernels.queries.search_grid import build_search_grid, width_of_all
from tests.worlds import crowded
arrays = crowded(balls=30)._arrays
tables = arrays.shapes.used, arrays.balls.used
items = np.arange(-1, -31, -1, dtype="i4")
grid, starts, members = np.zeros(1, SEARCH_GRID), np.zeros(400, "i4"), np.zeros(400, "i4")
print(door.load(build_search_grid)(grid, *tables, items, starts, members))
print(door.enter(width_of_all)(Block(tables)).hex(), grid.tobytes().hex(), starts.tolist(), members.tolist())
print(isinstance(door.enter(width_of_all), door.At))
"""


@pytest.mark.slow
def test_a_library_gives_the_bits_of_the_interpreter_where_there_is_no_numba(tmp_path: Path) -> None:
    fresh.printed(BUILD, str(tmp_path), "width_of_all", "build_search_grid")
    index = json.loads((tmp_path / INDEX).read_text())
    assert index["sources"] == source_hash()
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([INDEX, index["library"]])
    compiled = fresh.printed(ASK, str(tmp_path), CAROM_COMPILE="background", NUMBA_DISABLE_JIT=None)
    interpreted = fresh.printed(ASK, NUMBA_DISABLE_JIT="1")
    assert compiled.endswith("True\n")
    assert interpreted.endswith("False\n")
    assert compiled.removesuffix("True\n") == interpreted.removesuffix("False\n")
    library = (tmp_path / index["library"]).read_bytes()
    assert not any(word in library for word in (b"numba", b"NRT_", b"PyErr", str(fresh.ROOT).encode()))
    if platform.machine() == "x86_64" and shutil.which("objdump"):
        listing = subprocess.run(["objdump", "-d", tmp_path / index["library"]], capture_output=True, check=True).stdout
        assert b"%xmm" in listing
        assert not any(wide in listing for wide in (b"%ymm", b"%zmm", b"vfmadd", b"vmov"))


def test_a_kernel_that_there_is_none_of_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CompileError, match=r"no kernels called \['step_sideways'\]; there are \['step_discrete', "):
        ahead.prebuild(str(tmp_path), "step_discrete", "step_sideways")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_in_a_process_that_has_compiled_none_is_made(tmp_path: Path) -> None:
    compiling = "import numba; numba.njit(lambda x: x)(1)\n"
    done = fresh.run(compiling + BUILD, str(tmp_path), "width_of_all")
    assert done.returncode == 1
    assert b"RuntimeError: Numba has compiled in this process already" in done.stderr
    assert list(tmp_path.iterdir()) == []
