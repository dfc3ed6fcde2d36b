"""Ctrl-C: the first one asks, the second one insists, and afterwards everything is as before."""

import signal
from collections.abc import Callable
from pathlib import Path

import pytest

from carom.cli import files, outputs, running
from carom.cli.interrupt import Interrupt
from tests.unit.cli.saying import carom_says


def test_the_first_is_noted_and_the_second_interrupts() -> None:
    with Interrupt() as interrupt:
        assert not interrupt.asked
        signal.raise_signal(signal.SIGINT)
        assert interrupt.asked
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_the_handler_from_before_is_back_at_the_end() -> None:
    before = signal.getsignal(signal.SIGINT)
    with Interrupt():
        assert signal.getsignal(signal.SIGINT) != before
    assert signal.getsignal(signal.SIGINT) == before


def test_a_program_started_to_ignore_it_ignores_it() -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGINT)
        assert not interrupt.asked
    finally:
        signal.signal(signal.SIGINT, before)


#: The packages that the files of some endings need.
NEEDED = {
    ".png": ("pygame",),
    ".gif": ("pygame", "imageio_ffmpeg"),
    ".mp4": ("pygame", "imageio_ffmpeg"),
    ".parquet": ("pyarrow",),
}


@pytest.mark.compiled
@pytest.mark.parametrize("ending", files.OF_RUN)
@pytest.mark.parametrize("there", [True, False])
def test_whatever_is_being_written_what_is_left_is_told_and_no_half_file_stays(
    ending: str, there: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for package in NEEDED.get(ending, ()):
        pytest.importorskip(package, reason=f'no {package}: pip install "carom[draw,study]"')
    monkeypatch.chdir(tmp_path)
    write = outputs.write

    def half(path: Path) -> None:
        path.write_text("half")
        signal.raise_signal(signal.SIGINT)

    def interrupted(path: Path, writer: Callable[[Path], None]) -> int:
        return write(path, half if path.suffix == ending and path.stem == "b" else writer)

    monkeypatch.setattr(outputs, "write", interrupted)
    if there:
        Path(f"b{ending}").write_text("before")
    outs = [part for name in (f"a{ending}", f"b{ending}", "c.csv") for part in ("--out", name)]
    status, out, err = carom_says(capsys, "run", "toy", "--seconds", "0.1", "--size", "64", *outs)
    assert status == 130
    assert f"wrote a{ending}" in out
    assert err == f"carom: interrupted; not written: b{ending}, c.csv\n"
    assert {path.name for path in tmp_path.iterdir()} == {f"a{ending}", *([f"b{ending}"] if there else [])}
    assert not there or Path(f"b{ending}").read_text() == "before"


@pytest.mark.parametrize("outs", [[], ["a.svg", "b.csv"]])
def test_a_run_that_is_interrupted_at_once_says_what_is_not_written(
    outs: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)

    def insist(*_: object, **__: object) -> None:
        with Interrupt():
            signal.raise_signal(signal.SIGINT)
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(running, "run", insist)
    options = [part for name in outs for part in ("--out", name)]
    left = "; not written: a.svg, b.csv" if outs else ""
    assert carom_says(capsys, "run", "toy", *options) == (130, "", f"carom: interrupted{left}\n")
    assert list(tmp_path.iterdir()) == []
