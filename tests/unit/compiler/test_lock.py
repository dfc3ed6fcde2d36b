"""A kernel is made by one process at a time; a lock that was left behind is none."""

import subprocess
import sys
import threading
from pathlib import Path

import pytest

from carom.compiler import lock
from tests import fresh
from tests.unit.compiler.one_kernel import ONE_KERNEL, kept

#: Has the making of a kernel to itself until it is killed.
HOLDS = """
import sys, time
from pathlib import Path
from carom.compiler.lock import claimed
with claimed(Path(sys.argv[1]), "kernel", print):
    print("mine", flush=True)
    time.sleep(60)
"""


def test_who_waits_sees_how_far_the_other_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lock, "LOOK", 0.02)
    seen: list[int] = []
    order: list[str] = []
    first_has_it = threading.Event()

    def first() -> None:
        with lock.claimed(tmp_path, "kernel", seen.append) as far:
            far.write(12)
            first_has_it.set()
            while 12 not in seen:
                pass
            order.append("first")

    thread = threading.Thread(target=first)
    thread.start()
    first_has_it.wait()
    with lock.claimed(tmp_path, "kernel", seen.append) as far:
        order.append("second")
        assert far.read() == 0, "what the first one wrote is gone"
    thread.join()
    assert order == ["first", "second"]
    assert set(seen) == {12}
    with lock.claimed(tmp_path, "other", seen.append):
        pass


def test_who_fails_leaves_no_lock(tmp_path: Path) -> None:
    def fail() -> None:
        with lock.claimed(tmp_path, "kernel", lambda _: None):
            raise KeyboardInterrupt

    def waits(count: int) -> None:
        raise AssertionError("nobody has it")

    with pytest.raises(KeyboardInterrupt):
        fail()
    with lock.claimed(tmp_path, "kernel", waits):
        pass


def test_where_there_are_no_locks_everybody_compiles(tmp_path: Path) -> None:
    (tmp_path / "kernel.lock").mkdir()
    with lock.claimed(tmp_path, "kernel", lambda _: None) as far:
        assert far.read() == 0


def test_a_count_that_cannot_be_read_or_written_is_none(tmp_path: Path) -> None:
    (tmp_path / "kernel.far").write_text("half")
    assert lock.Far(tmp_path, "kernel").read() == 0
    lost = lock.Far(tmp_path / "nowhere", "kernel")
    lost.write(3)
    lost.forget()
    assert lost.read() == 0


@pytest.mark.slow
def test_a_process_that_was_killed_holds_no_lock(tmp_path: Path) -> None:
    command = [sys.executable, "-c", HOLDS, str(tmp_path)]
    with subprocess.Popen(command, cwd=fresh.ROOT, stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "mine\n"
        waited: list[int] = []

        def waits(count: int) -> None:
            waited.append(count)
            holder.kill()

        with lock.claimed(tmp_path, "kernel", waits):
            assert waited


@pytest.mark.slow
@pytest.mark.compiled
def test_two_processes_at_once_compile_once(tmp_path: Path) -> None:
    command = [sys.executable, "-c", ONE_KERNEL]
    variables = fresh.variables(CAROM_CACHE_DIR=str(tmp_path), CAROM_COMPILE="wait")
    both = [
        subprocess.Popen(
            command, cwd=fresh.ROOT, env=variables, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        for _ in range(2)
    ]
    told = []
    for process in both:
        printed, said = process.communicate()
        assert (process.returncode, printed) == (0, "3\n")
        told.append(said)
    assert len(kept(tmp_path)) == 2
    assert sum("once on this machine" in said for said in told) == 1
