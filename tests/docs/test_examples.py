"""Every example runs, is short, and shows what its text says."""

import runpy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

from docs.extensions.reading_order import EXAMPLES
from tests.conventions.source_trees import ROOT

FOLDER = ROOT / "examples"
LONGEST = 60

#: What each example claims, of the names in it at its end and of what it printed.
CLAIMS: dict[str, Callable[[dict[str, Any], str], bool]] = {
    "arc_room": lambda names, _: np.abs(np.subtract(names["momenta"](), names["before"]))[0] < 1e-12 < 1.0,
    "boundary_map": lambda names, _: len(names["sine"]) >= 2000 and np.ptp(names["sine"]) < 1e-9,
    "bowl": lambda names, printed: "less by 0.000000" in printed and 0 < len(names["run"].hits) < 60,
    "breakout": lambda names, _: names["standing"] < 20 and names["score"] == 10 * (20 - names["standing"]),
    "classroom": lambda names, printed: (
        "45 degrees it lands after 10.40 m" in printed and "<svg" in names["stage"].value
    ),
    "common_tangents": lambda names, _: len(names["belt"]) == 6,
    "drawn_table": lambda names, printed: (
        "11 lines are 17 shapes, 8 of them arcs" in printed and names["met"] >= {"frame", "left", "ramp"}
    ),
    "flipper": lambda names, _: np.allclose(names["speeds"], names["expected"], rtol=0.02),
    "galperin_pi": lambda _, printed: [line.split()[2] for line in printed.splitlines()] == ["3", "31", "314", "3141"],
    "galton_board": lambda names, _: abs(names["bins"].mean() - 5) < 0.3 and abs(names["bins"].std() - 1.58) < 0.3,
    "guard_points": lambda _, printed: "by 2 of 3 balls, the guarded one by 3" in printed,
    "layers": lambda names, printed: len(names["shown"]) == len(printed.splitlines()) > 10,
    "learning_pinball": lambda names, printed: len(names["means"]) == 3 and printed.count("points a game") == 6,
    "lidar": lambda names, _: names["hits"].found.all(),
    "maxwell_gas": lambda names, _: np.ptp(names["energy"]) < 1e-12 * names["energy"][0],
    "newtons_cradle": lambda names, _: np.ptp(names["energy"]) == 0.0 and len(names["run"].hits) > 15,
    "phase_portrait": lambda names, _: abs(names["order"] - names["cap"]) < 0.05,
    "pinball_hits": lambda names, _: len(names["run"].hits) > 100,
    "pool_line": lambda _, printed: "in the pocket" in printed,
    "rounded_room": lambda names, _: np.allclose(names["speeds"], 9.16**0.5, rtol=1e-12) and len(names["ellipse"]) < 40,
    "sinai_billiard": lambda names, _: names["run"].kinetic_energy()[-1] == pytest.approx(40.0, rel=1e-12),
    "snapshots": lambda names, printed: "the same end: True" in printed and names["apart"].max() > 1.0,
    "stadium_chaos": lambda names, _: names["apart"][0] < 2e-12 and names["apart"].max() > 1.0,
    "two_modes": lambda _, printed: "discrete: at most 8" in printed and "continuous: at most 0%" in printed,
}
#: Those that take longer than five seconds with the compiler off.
LONG = {
    "boundary_map",
    "bowl",
    "breakout",
    "layers",
    "learning_pinball",
    "galton_board",
    "maxwell_gas",
    "phase_portrait",
    "pinball_hits",
    "pool_line",
    "sinai_billiard",
    "rounded_room",
    "snapshots",
} | {
    "stadium_chaos",
    "two_modes",
}
#: What those need that are of no extra but that for the docs.
NEEDS = {"classroom": "ipywidgets"}
CASES = [pytest.param(name, marks=[pytest.mark.compiled] if name in LONG else []) for name in sorted(CLAIMS)]


def test_the_gallery_is_all_examples_and_each_is_tested() -> None:
    names = {path.stem for path in FOLDER.glob("*.py")}
    assert set(EXAMPLES) == set(CLAIMS) == names
    assert len(names) >= 12


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_an_example_shows_what_it_says(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    mpl.use("Agg")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(plt, "show", lambda: None)
    names = runpy.run_path(str(FOLDER / f"{name}.py"))
    shown = len(plt.get_fignums()) + len(list(tmp_path.glob("*.svg")))
    plt.close("all")
    assert shown >= 1
    printed = capsys.readouterr().out
    assert printed
    assert CLAIMS[name](names, printed)


@pytest.mark.parametrize("name", sorted(CLAIMS))
def test_an_example_is_short(name: str) -> None:
    assert len((FOLDER / f"{name}.py").read_text(encoding="utf-8").splitlines()) < LONGEST


@pytest.mark.slow
@pytest.mark.compiled
def test_the_lesson_follows_its_sliders_and_its_player(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("ipywidgets")
    monkeypatch.chdir(tmp_path)
    names = runpy.run_path(str(FOLDER / "classroom.py"))
    stage, player = names["stage"], names["frame"]
    seen = [stage.value]
    for name, value in (("speed", 5.0), ("elasticity", 0.0), ("gravity", 2.0)):
        names["sliders"][name].value = value
        seen.append(stage.value)
    assert "At 5 m/s and 75 degrees." in seen[-1]
    for frame in (0, 60, 240):
        player.value = frame
        seen.append(stage.value)
    assert len(set(seen)) == len(seen) - 1, "all differ, but for the last, which is what was shown before frame 0"
    assert stage.value == seen[3]
