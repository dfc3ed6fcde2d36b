"""The child that compiles: one at a time, told of once, never a zombie, and no harm where it fails."""

import os
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from carom.compiler import child
from tests import fresh

#: A child that does what its first kernel is called.
HELPER = """
import sys, time
from pathlib import Path
name = sys.argv[1]
if name == "fails":
    sys.exit(3)
while name == "waits" and not Path(__file__).with_name("go").exists():
    time.sleep(0.005)
with Path(__file__).with_name("done").open("a") as file:
    file.write(" ".join(sys.argv[1:]) + "\\n")
"""

#: Asks for a kernel, and ends.
ASKS = """
import sys
sys.path.append(sys.argv[1])
from carom.compiler import child
child.MODULE = "helper"
def waits(): pass
print(child.ask(waits))
"""


def fails() -> None:
    """A kernel whose compiling fails."""


def waits() -> None:
    """A kernel whose compiling takes until the test says so."""


def step_one() -> None:
    """A kernel."""


def step_two() -> None:
    """Another kernel."""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The helper's folder; nothing has been asked for yet."""
    (tmp_path / "helper.py").write_text(HELPER, encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(child, "MODULE", "helper")
    monkeypatch.setattr(child, "_work", None)
    monkeypatch.setattr(child, "_failed", False)
    monkeypatch.setattr(child, "_waiting", [])
    monkeypatch.setattr(child, "_asked", set())
    return tmp_path


def until(done: Callable[[], bool]) -> None:
    """Wait until something is so, for some seconds at most."""
    end = time.monotonic() + 30.0
    while not done():
        assert time.monotonic() < end
        time.sleep(0.002)


def over() -> bool:
    """Whether nothing is being compiled any more."""
    return not child.compiling()


def test_a_kernel_is_compiled_once_and_its_begin_and_end_are_told(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert not child.compiling()
    assert child.ask(waits)
    assert child.busy_with(waits)
    assert child.compiling()
    (folder / "go").touch()
    until(over)
    assert not child.busy_with(waits)
    assert not child.ask(waits)
    first, last = capsys.readouterr().err.splitlines()
    assert first == "carom: compiling waits, once on this machine; until then it runs interpreted"
    assert last.startswith("carom: compiled waits in ")
    assert (folder / "done").read_text() == "waits\n"


def test_what_is_asked_for_meanwhile_comes_next_all_at_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert child.ask(waits)
    assert child.ask(step_one)
    assert child.ask(step_two)
    assert child.busy_with(step_two)
    (folder / "go").touch()
    until(over)
    assert (folder / "done").read_text() == "waits\nstep_one step_two\n"
    assert "compiled step one, step two in " in capsys.readouterr().err


def test_a_child_that_fails_is_told_of_once_and_there_is_no_other(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert child.ask(fails)
    assert child.ask(step_one)
    until(over)
    assert not child.busy_with(fails)
    assert not child.busy_with(step_one)
    assert not child.ask(step_two)
    told = [line for line in capsys.readouterr().err.splitlines() if "failed" in line]
    assert told == [
        "carom: compiling fails has failed (status 3); it stays interpreted."
        " `carom compile` compiles, or says what is wrong"
    ]


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_child_that_is_killed_has_failed_and_none_that_has_ended_is_a_zombie(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert child.ask(waits)
    work = child._work
    assert work is not None
    pid = work._process.pid
    assert os.getsid(pid) != os.getsid(0), "Ctrl-C in the terminal is not for it"
    os.kill(pid, signal.SIGKILL)
    until(lambda: work.status is not None)
    with pytest.raises(ChildProcessError):
        os.waitpid(pid, 0)
    assert not child.compiling()
    assert "has failed (status -9)" in capsys.readouterr().err


def test_where_no_process_can_be_started_it_is_said(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "executable", str(folder / "no-such-python"))
    assert not child.ask(step_one)
    assert not child.busy_with(step_one)
    assert capsys.readouterr().err.startswith("carom: no process can be started to compile (")


def test_a_packed_program_starts_itself_no_second_time(monkeypatch: pytest.MonkeyPatch) -> None:
    assert child.possible()
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert not child.possible()
    monkeypatch.undo()
    monkeypatch.setattr(sys, "executable", "")
    assert not child.possible()


def test_a_forked_process_asks_for_itself(folder: Path) -> None:
    assert child.ask(step_one)
    work = child._work
    assert work is not None
    child._forget()
    assert not child.busy_with(step_one)
    until(lambda: work.status is not None)
    assert child.ask(step_one)
    until(over)


@pytest.mark.slow
def test_a_process_ends_before_its_child_which_goes_on(folder: Path) -> None:
    done = fresh.run(ASKS, str(folder))
    assert done.returncode == 0, done.stderr.decode()
    assert done.stdout == b"True\n"
    assert done.stderr.startswith(b"carom: compiling waits")
    assert not (folder / "done").exists()
    (folder / "go").touch()
    until((folder / "done").exists)
