"""How far a sweep is: lines now and then where there is no terminal."""

import pytest

from carom.study.sweeps import progress
from carom.study.sweeps.progress import Meter


def test_lines_are_written_now_and_then(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    clock = iter([0.0, *(moment for tick in range(1, 100) for moment in [tick * 6.0] * 3)])
    monkeypatch.setattr(progress, "perf_counter", lambda: next(clock))
    with Meter(1000, 10, shown=True) as meter:
        for done in (40, 70, 100):
            meter.tell(done, 2, workers=2)
        meter.tell(100, 2, workers=0)
    told = capsys.readouterr().err.splitlines()
    assert told[0].startswith("sweep: ")
    assert 0 < len(told) < 4
    assert all(" of 1,000 runs, 2 failed, " in line and line.endswith(" s left") for line in told)


def test_nothing_is_written_unless_it_is_asked_for(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress, "PAUSE", 0.0)
    with Meter(10, 0, shown=False) as meter:
        meter.tell(5, 0, workers=1)
    assert capsys.readouterr().err == ""


def test_no_workers_are_told_of(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "PAUSE", 0.0)
    with Meter(10, 0, shown=True) as meter:
        meter.tell(0, 0, workers=0)
    assert capsys.readouterr().err == "sweep: 0 of 10 runs, 0 failed, 0 a second, waiting for workers\n"
