"""What a user is told while kernels are compiled, in a file, on a terminal and without a console."""

import io
import re
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from carom.compiler import teller
from carom.compiler.lock import Far
from tests.unit.compiler.one_kernel import ONE_KERNEL, one_kernel


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


@pytest.mark.slow
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


@pytest.mark.slow
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


def test_who_waits_for_another_process_is_told_how_far_that_is(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    with teller.Teller("step_discrete", 500) as telling:
        for count in (0, 0, 12):
            telling.waits(count)
    text = stream.getvalue()
    assert text.startswith("carom: compiling step discrete, by another process ...\n")
    assert "\rcarom: 12 of about 500 functions" in text
    assert text.splitlines()[-1].startswith("carom: compiled step discrete in ")


def test_how_far_it_is_is_written_down_for_others(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    with teller.Teller("step_discrete", 500) as telling:
        telling.far = Far(tmp_path, "step_discrete")
        for function in ("a", "b", "a"):
            telling.see(function)
    assert Far(tmp_path, "step_discrete").read() == 2
