"""The compiler's door: loaded when needed, told about, cached by the sources' hash, and not needed at all."""

import io
import re
import shutil
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

import carom
from carom.compiler import cache, door, kernels, teller
from carom.world.kernels.broad_phase.grid import cell_of
from tests import fresh
from tests.worlds import crowded

#: Compiles one small kernel and calls it.
ONE_KERNEL = """
from carom.compiler import door
from carom.world.kernels.broad_phase.grid import cell_of
print(door.load(cell_of)(7.5, 0.5))
"""

#: Steps a crowded world.
STEPS = """
from tests.worlds import crowded
world = crowded(balls=4)
world.run(0.25)
print(world.digest())
"""

WITHOUT_NUMBA = 'import sys; sys.modules["numba"] = None\n'


def kept(folder: Path) -> list[str]:
    """The files of compiled code below a folder."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.nb[ic]"))


def one_kernel(folder: Path, code: str = ONE_KERNEL, **environment: str | None) -> tuple[str, str]:
    """What a fresh process that compiles a kernel, with its cache in a folder, prints on stdout and on stderr."""
    done = fresh.run(code, CAROM_CACHE_DIR=str(folder), **environment)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode(), done.stderr.decode()


# -- what needs no compiler --------------------------------------------------------------------------------------------


def test_building_shapes_and_worlds_imports_no_compiler() -> None:
    code = """
import sys, carom
wall, ball = carom.Segment((0, 0), (1, 0)), carom.Ball((0.5, 0.4), 0.5)
ball.respond(wall.detect(ball))
world = carom.World(); world.add(wall); world.add(ball); world.snapshot(); world.restore(world.snapshot())
print(sorted(name for name in sys.modules if name.partition(".")[0] in ("numba", "llvmlite")))
"""
    assert fresh.printed(code) == "[]\n"


def test_interpreted_and_without_numba_the_bits_are_the_same() -> None:
    world = crowded(balls=4)
    world.run(0.25)
    assert fresh.printed(STEPS, NUMBA_DISABLE_JIT="1").strip() == world.digest()
    assert fresh.printed(WITHOUT_NUMBA + STEPS).strip() == world.digest()


def test_interpreted_nothing_is_said_or_kept(tmp_path: Path) -> None:
    assert one_kernel(tmp_path, NUMBA_DISABLE_JIT="1") == ("3\n", "")
    assert one_kernel(tmp_path, WITHOUT_NUMBA + ONE_KERNEL) == ("3\n", "")
    assert list(tmp_path.iterdir()) == []


# -- the cache ---------------------------------------------------------------------------------------------------------


@pytest.mark.compiled
def test_the_first_process_says_that_it_compiles_and_the_second_starts_at_once(tmp_path: Path) -> None:
    printed, told = one_kernel(tmp_path)
    assert printed == "3\n"
    first, *_, last = told.splitlines()
    assert first == "carom: compiling cell of, once on this machine ..."
    assert last.startswith("carom: compiled cell of in ")
    files = kept(tmp_path)
    assert len(files) == 2
    assert all(file.startswith(cache.source_hash()) for file in files)
    assert one_kernel(tmp_path) == ("3\n", "")
    assert kept(tmp_path) == files


@pytest.mark.compiled
def test_a_step_that_was_compiled_before_starts_at_once_and_says_nothing(tmp_path: Path) -> None:
    crowded(balls=4).step(0.1)
    done = fresh.run(STEPS)
    assert done.stderr == b""
    assert len(done.stdout) == 33


@pytest.mark.slow
@pytest.mark.compiled
def test_a_cache_that_is_deleted_is_made_again(tmp_path: Path) -> None:
    one_kernel(tmp_path)
    files = kept(tmp_path)
    shutil.rmtree(tmp_path)
    assert one_kernel(tmp_path)[0] == "3\n"
    assert kept(tmp_path) == files


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("ending", ["nbi", "nbc"])
def test_a_damaged_cache_does_no_harm(tmp_path: Path, ending: str) -> None:
    one_kernel(tmp_path)
    for path in tmp_path.rglob(f"*.{ending}"):
        path.write_bytes(path.read_bytes()[:-20])
    assert one_kernel(tmp_path)[0] == "3\n"


@pytest.mark.compiled
def test_a_cache_folder_that_cannot_be_made_does_no_harm(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    printed, told = one_kernel(tmp_path / "file" / "cache")
    assert printed == "3\n"
    assert "compiled" in told


@pytest.mark.slow
@pytest.mark.compiled
def test_a_cache_folder_that_cannot_be_written_to_does_no_harm_and_nothing_is_kept_elsewhere(tmp_path: Path) -> None:
    one_kernel(tmp_path)
    (inner,) = {path.parent for path in tmp_path.rglob("*.nbi")}
    shutil.rmtree(inner)
    inner.write_text("in the way")
    before = kept(fresh.ROOT / "src")
    assert one_kernel(tmp_path)[0] == "3\n"
    assert kept(fresh.ROOT / "src") == before
    assert kept(tmp_path) == []


@pytest.mark.compiled
@pytest.mark.skipif(sys.platform == "win32", reason="needs a limit on the size of files")
def test_a_full_disk_does_no_harm(tmp_path: Path) -> None:
    limit = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"
    assert one_kernel(tmp_path, limit + ONE_KERNEL)[0] == "3\n"


@pytest.mark.compiled
def test_a_changed_callee_is_seen(tmp_path: Path) -> None:
    package = tmp_path / "package"
    shutil.copytree(fresh.ROOT / "src" / "carom", package / "carom", ignore=shutil.ignore_patterns("__pycache__"))
    cache, places = tmp_path / "cache", {"PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}
    code = "import carom; print(carom.__file__)\n" + ONE_KERNEL.replace("7.5, 0.5", "1e300, 1.0")
    before, _ = one_kernel(cache, code, **places)
    constants = package / "carom" / "constants.py"
    text = constants.read_text(encoding="utf-8")
    constants.write_text(text.replace("CELL_CLAMP = 1073741824.0", "CELL_CLAMP = 4096.0"), encoding="utf-8")
    after, told = one_kernel(cache, code, **places)
    assert before.split() == [str(package / "carom" / "__init__.py"), "1073741824"]
    assert after.split()[1] == "4096"
    assert "compiling" in told
    assert len({file.partition("/")[0] for file in kept(cache)}) == 2


def test_the_cache_is_in_the_users_folder_unless_told_otherwise(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path))
    assert cache.cache_folder() == tmp_path / cache.source_hash()
    monkeypatch.setenv("CAROM_CACHE_DIR", "")
    import platformdirs

    assert cache.cache_folder() == Path(platformdirs.user_cache_dir("carom")) / cache.source_hash()


def test_the_hash_is_of_all_kernel_sources(monkeypatch: pytest.MonkeyPatch) -> None:
    everything = cache.source_hash()
    assert cache.source_hash() == everything
    modules = kernels.kernel_modules()
    for module in modules:
        rest = tuple(name for name in modules if name != module)
        monkeypatch.setattr(cache, "kernel_modules", lambda rest=rest: rest)
        assert cache.source_hash() != everything
        monkeypatch.undo()


# -- what the user is told ---------------------------------------------------------------------------------------------


class Terminal(io.StringIO):
    """A terminal."""

    def isatty(self) -> bool:
        return True


def tell(stream: Any, monkeypatch: pytest.MonkeyPatch, functions: list[str], wait: float = 0.0) -> str:
    """What a teller writes to a stream while functions are compiled, each of which takes some seconds."""
    monkeypatch.setattr(sys, "stderr", stream)
    with teller.Teller("step_discrete", 500) as telling:
        for function in functions:
            telling.see(function)
            time.sleep(wait)
    return str(stream.getvalue())


def test_a_file_is_told_in_lines_and_a_terminal_how_far_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    begin = "carom: compiling step discrete, once on this machine ...\n"
    text = tell(io.StringIO(), monkeypatch, ["a", "b", "a"])
    assert text.startswith(begin + "carom: compiled step discrete in ")
    text = tell(Terminal(), monkeypatch, ["a", "b", "a"])
    assert text.startswith(begin + "\rcarom: 1 of about ")
    assert "\rcarom: 2 of about " in text
    assert text.splitlines()[-1].startswith("carom: compiled step discrete in ")


def test_a_file_is_told_every_few_seconds_that_it_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(teller, "INTERVAL", 0.05)
    text = tell(io.StringIO(), monkeypatch, ["a", "b"], wait=0.6)
    assert all(character.isprintable() or character == "\n" for character in text)
    assert text.endswith(" s\n")
    _, *lines, last = text.splitlines()
    assert last.startswith("carom: compiled step discrete in ")
    told = [
        re.fullmatch(r"carom: compiling step discrete: (\d) of about \d+ functions, (\d) s", line) for line in lines
    ]
    assert len(told) >= 4
    figures = [(int(match[1]), int(match[2])) for match in told if match is not None]
    assert len(figures) == len(told)
    assert figures == sorted(figures)
    assert {functions for functions, _ in figures} == {1, 2}


def interrupted() -> None:
    """Be interrupted while the first function is compiled."""
    with teller.Teller("step_discrete", 500) as telling:
        telling.see("a")
        raise KeyboardInterrupt


def test_once_it_is_over_or_was_interrupted_nothing_more_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(teller, "INTERVAL", 0.01)
    for stream in (io.StringIO(), Terminal()):
        monkeypatch.setattr(sys, "stderr", stream)
        with pytest.raises(KeyboardInterrupt):
            interrupted()
        for thread in threading.enumerate():
            if thread.name == "carom-compiling":
                thread.join()
        assert "compiled" not in stream.getvalue()
        assert stream.getvalue().endswith("\n")


@pytest.mark.compiled
def test_a_kernel_that_takes_long_says_so_in_the_meantime(tmp_path: Path) -> None:
    code = "from carom.compiler import teller; teller.INTERVAL = 0.02\n" + ONE_KERNEL
    _, told = one_kernel(tmp_path, code)
    assert re.search(r"^carom: compiling cell of: \d+ of about \d+ functions, \d+ s$", told, re.MULTILINE)


def test_a_program_without_a_console_is_told_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    with teller.Teller("step_discrete", 500) as telling:
        telling.see("a")
    assert telling._over.is_set()


def test_nothing_is_told_where_nothing_is_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    assert tell(Terminal(), monkeypatch, []) == ""


def test_every_kernel_is_loaded_once() -> None:
    first = door.load(cell_of)
    first(1.0, 1.0)
    assert door.load(cell_of) is door.load(cell_of)
    assert door.load(cell_of)(7.5, 0.5) == 3
    assert carom.World().step(0.0).dtype.names
