"""The clock of the tests rings for what does not return, and for nothing that others keep waiting."""

import signal
import time

import pytest

from tests import clock
from tests.clock import within


def work_on() -> None:
    """Keep the processor busy without end."""
    while True:
        pass


def test_what_works_on_is_rung() -> None:
    with pytest.raises(TimeoutError, match=r"no end within 0\.05 s"), within(0.05):
        work_on()


def test_what_waits_is_given_more_time_but_not_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clock, "process_time", lambda: 0.0)  # as if it never got the processor
    monkeypatch.setattr(clock, "PATIENCE", 1000.0)
    with within(0.05):
        time.sleep(0.2)
    monkeypatch.setattr(clock, "PATIENCE", 2.0)
    with pytest.raises(TimeoutError), within(0.05):
        time.sleep(3.0)


def test_when_it_is_over_it_rings_no_more_and_who_listened_before_does() -> None:
    before = signal.getsignal(signal.SIGALRM)
    with within(0.05):
        pass
    time.sleep(0.1)
    assert signal.getsignal(signal.SIGALRM) is before
