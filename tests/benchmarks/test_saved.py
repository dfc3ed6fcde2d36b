"""Runs are saved and compared: medians with their spread, told beside those of an earlier run."""

from pathlib import Path

import pytest
from rich.console import Console

from benchmarks import __main__ as program
from benchmarks.common import Figure, Timing, compared, race, show
from benchmarks.saved import Run, load, save


def test_a_timing_is_the_median_and_half_of_what_the_middle_half_spans() -> None:
    assert Timing.of([9.0, 1.0, 2.0, 4.0, 3.0]) == Timing(3.0, 1.0)
    assert Timing.of([2.0]) == Timing(2.0, 0.0)
    figure = Timing(3.0, 1.0).figure("case", "engine", 1e3, "ms")
    assert (figure.value, figure.spread, figure.unit) == (3000.0, 1000.0, "ms")


def test_each_takes_its_turn() -> None:
    order: list[str] = []
    found = race({"a": lambda: order.append("a"), "b": lambda: order.append("b")}, rounds=2, calls_each=2)
    assert order == list("aabbaabb")
    assert all(timing.median >= 0.0 for timing in found.values())


FIGURES = [
    Figure("10 balls", "carom", 3.0, "ms", 1.0, {"more": "said"}, 0.5),
    Figure("10 balls", "peer", 6.0, "ms"),
]


def test_a_run_is_loaded_as_it_was_saved(tmp_path: Path) -> None:
    run = Run({"machine": "this"}, {"gas": FIGURES})
    save(tmp_path / "run.json", run)
    assert load(tmp_path / "run.json") == run
    assert run.of("gas")["10 balls", "peer"] is FIGURES[1]
    assert run.of("galton") == {}


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"on": {}, "figures": {"gas": [{"workload": "w"}]}}'])
def test_what_is_no_run_is_refused(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"other\.json is no run that --json has saved"):
        load(path)
    with pytest.raises(SystemExit):
        program.main(["--quick", "--only", "gas", "--compare", str(path)])
    assert "other.json is no run" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("now", "spread", "ratio"), [(6.0, 0.4, "2"), (3.6, 0.2, "~1.2"), (3.8, 0.2, "1.27"), (2.4, 0.2, "~0.8")]
)
def test_a_change_within_both_spreads_is_told_as_none(now: float, spread: float, ratio: str) -> None:
    before = Run({}, {"gas": FIGURES}).of("gas")
    then, times = compared(Figure("10 balls", "carom", now, "ms", spread=spread), before)
    assert (then, times) == ("3 ± 0.5 ms", ratio)


def test_what_was_not_measured_then_or_in_another_unit_is_left_empty() -> None:
    before = Run({}, {"gas": FIGURES}).of("gas")
    for figure in (Figure("11 balls", "carom", 3.0, "ms"), Figure("10 balls", "carom", 3.0, "µs")):
        assert compared(figure, before) == ("", "")


def test_the_table_shows_both_runs() -> None:
    console = Console(width=120, record=True)
    show("Gas", [Figure("10 balls", "carom", 6.0, "ms", spread=0.1)], console, Run({}, {"gas": FIGURES}).of("gas"))
    text = console.export_text()
    for told in ("median ± spread", "6 ± 0.1 ms", "3 ± 0.5 ms", "times then"):
        assert told in text
