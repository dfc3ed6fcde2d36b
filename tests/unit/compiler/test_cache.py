"""Compiled code is kept by the hash of the sources, and whatever happens to what is kept does no harm."""

import shutil
import sys
from pathlib import Path

import pytest

from carom.compiler import cache, kernels
from tests import fresh
from tests.unit.compiler.one_kernel import ONE_KERNEL, STEPS, kept, one_kernel
from tests.worlds import crowded

#: A clock that rings while a kernel is read, once; then the kernel is called again.
CLOCK = f"""
import numba.core.caching as caching

def ring(self, key, load=caching.IndexDataCacheFile.load):
    caching.IndexDataCacheFile.load = load
    raise TimeoutError

caching.IndexDataCacheFile.load = ring
try:
    exec({ONE_KERNEL!r})
except TimeoutError:
    print("it rang")
"""

#: The same while it is compiled.
CLOCK_MEANWHILE = f"""
from carom.compiler.teller import Teller

see = Teller.see

def ring(*arguments):
    Teller.see = see
    see(*arguments)
    raise TimeoutError

Teller.see = ring
try:
    exec({ONE_KERNEL!r})
except TimeoutError:
    print("it rang")
"""


@pytest.mark.slow
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


@pytest.mark.slow
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
def test_a_damaged_cache_does_no_harm_and_is_mended(tmp_path: Path, ending: str) -> None:
    one_kernel(tmp_path)
    for path in tmp_path.rglob(f"*.{ending}"):
        path.write_bytes(path.read_bytes()[:-20])
    assert one_kernel(tmp_path)[0] == "3\n"
    assert one_kernel(tmp_path) == ("3\n", ""), "it is made anew, and kept"


@pytest.mark.slow
@pytest.mark.compiled
def test_what_a_signal_breaks_off_while_it_is_read_is_not_taken_for_damaged(tmp_path: Path) -> None:
    one_kernel(tmp_path)
    files = kept(tmp_path)
    assert one_kernel(tmp_path, CLOCK + ONE_KERNEL) == ("it rang\n3\n", "")
    assert kept(tmp_path) == files


@pytest.mark.slow
@pytest.mark.compiled
def test_what_a_signal_breaks_off_while_it_is_compiled_is_heard_and_compiled_anew(tmp_path: Path) -> None:
    assert one_kernel(tmp_path, CLOCK_MEANWHILE + ONE_KERNEL)[0] == "it rang\n3\n"
    assert len(kept(tmp_path)) == 2
    assert one_kernel(tmp_path) == ("3\n", "")


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.skipif(sys.platform == "win32", reason="needs a limit on the size of files")
def test_a_full_disk_does_no_harm(tmp_path: Path) -> None:
    limit = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"
    assert one_kernel(tmp_path, limit + ONE_KERNEL)[0] == "3\n"


@pytest.mark.slow
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
