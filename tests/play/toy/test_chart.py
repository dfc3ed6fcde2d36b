"""The chart of box tests against balls."""

from pathlib import Path
from typing import Any

import pytest

import carom
from carom.play.toy import chart

WALLS = 8  # four walls, and a point at each corner


@pytest.mark.parametrize("balls", [2, 5, 9])
def test_brute_force_tests_each_pair_once_and_each_ball_against_all_that_guards_the_room(balls: int) -> None:
    found = chart.count(balls, "brute", before=0, measured=1)
    assert found.pairs == balls * (balls - 1) / 2
    assert found.tests == found.pairs + WALLS * balls
    assert found.tests_a_ball == found.tests / balls


@pytest.mark.compiled
def test_the_tests_of_a_grid_and_of_a_quadtree_grow_as_the_balls_do() -> None:
    for name, most in (("grid", 3.0), ("quadtree", 7.0)):
        hundred, thousand = (chart.count(balls, name).tests_a_ball for balls in (100, 1000))
        assert thousand < most
        # A hundred are oftener at a wall than a thousand are.
        assert 0.4 < thousand / hundred < 1.5


def test_few_balls_and_many_are_measured() -> None:
    assert (chart.FEW[0], chart.FEW[-1], chart.MANY[0], chart.MANY[-1]) == (2, 32, 10, 10_000)
    assert chart.measured_of(100) > chart.measured_of(10_000) == 1


@pytest.mark.slow
@pytest.mark.parametrize("ending", [".svg", ".png"])
def test_a_chart_is_written_and_its_figures_are_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    pytest.importorskip("matplotlib", reason='no matplotlib: pip install "carom[study]"')
    for name, value in {"FEW": (2, 3), "MANY": (2, 4), "TOLD": (2, 4), "BEFORE": 0, "MEASURED": 1}.items():
        monkeypatch.setattr(chart, name, value)
    monkeypatch.setattr(chart, "count", lambda balls, name, measured: chart.Count(name, balls, 10.0 * balls, balls))
    told: list[str] = []
    path = tmp_path / f"chart{ending}"
    chart.write_chart(path, told.append)
    assert path.stat().st_size > 1000
    assert [line.split() for line in told[2:]] == [[number, *["10.0", "(1.0)"] * 3] for number in ("2", "4")]


def test_without_matplotlib_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str, *arguments: Any) -> Any:
        raise ImportError(name)

    monkeypatch.setattr(chart, "import_module", missing)
    with pytest.raises(carom.MissingExtra, match=r"carom\[study\]"):
        chart.empty_figure()
