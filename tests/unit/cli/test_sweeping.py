"""`carom sweep`: how values are written, what it prints, what it refuses."""

from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from carom.cli.mistakes import Mistake
from carom.cli.sweeping import varied
from tests.unit.cli.saying import carom_says


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("shapes.left bumper.kick=0,2,4", ("shapes.left bumper.kick", [0, 2, 4])),
        ("seed=0:1000", ("seed", range(1000))),
        ("seed=3:10:3", ("seed", range(3, 10, 3))),
        ("world.gravity=(0,-30),(0,-4e1)", ("world.gravity", [[0, -30], [0, -40.0]])),
        ("a = [1, [2, x]] , true,None, .5 ", ("a", [[1, [2, "x"]], True, None, 0.5])),
        ("world.detection=discrete,continuous", ("world.detection", ["discrete", "continuous"])),
    ],
)
def test_what_varies_is_written_as_a_name_and_values(text: str, expected: Any) -> None:
    name, values = varied(text)
    assert name == expected[0]
    assert repr(values) == repr(expected[1])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("seed", "must be a name and values"),
        ("=3", "must be a name and values"),
        ("seed=", "must be a name and values"),
        ("seed=5:5", "has 0 values"),
        ("seed=0:9:0", "steps by 0"),
        ("seed=0:99999999999", "has 99,999,999,999 values"),
        ("a=(1,2", "its brackets do not match"),
        ("a=1),(2", "its brackets do not match"),
        ("a=1,,2", "a value is missing"),
    ],
)
def test_what_cannot_be_read_is_a_mistake(text: str, words: str) -> None:
    with pytest.raises(Mistake, match=words) as caught:
        varied(text)
    assert str(caught.value).startswith(f"--vary {text}: ")


def test_a_sweep_says_where_its_tables_are(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    asked = ["sweep", "newtons_cradle", "--vary", "balls=2,3", "--vary", "seed=0:2", "--measure", "energy"]
    asked += ["--seconds", "0.1", "--out", str(out), "--cluster", "serial"]
    assert carom_says(capsys, *asked) == (0, f"4 runs: {out}/table.parquet\n", "")
    assert pq.read_table(out / "table.parquet")["balls"].to_pylist() == [2, 2, 3, 3]
    status, _, told = carom_says(capsys, *asked)
    assert (status, told) == (
        2,
        f"carom: out {out}: holds this sweep already, 4 of its 4 runs are done; --resume goes on with it\n",
    )
    assert carom_says(capsys, *asked, "--resume") == (0, f"4 runs: {out}/table.parquet\n", "")


def test_runs_that_failed_are_told_of(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    asked = ["sweep", "tests.sweeping:drop", "--vary", "raises=true,false", "--measure", "tests.sweeping:told"]
    status, told, _ = carom_says(capsys, *asked, "--seconds", "0.1", "--out", str(out), "--cluster", "serial")
    assert (status, told.splitlines()[1]) == (0, f"1 of them failed: {out}/failures.parquet")


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ([], "carom: --vary: is missing"),
        (["--vary", "seed=1", "--vary", "seed=2"], "carom: --vary: one name is given twice"),
        (["--vary", "ball=1"], "carom: parameters: ball: is unknown; did you mean balls?"),
        (["--vary", "seed=1", "--measure", "energi"], "did you mean energy?"),
        (["--vary", "seed=1", "--seconds", "-1"], "carom: --seconds -1: must not be below 0"),
    ],
)
def test_a_mistake_is_one_line(more: list[str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = ["sweep", "newtons_cradle", "--seconds", "1", "--out", str(tmp_path / "out"), "--cluster", "serial"]
    status, out, told = carom_says(capsys, *asked, *more)
    assert (status, out) == (2, "")
    assert words in told
    assert told.count("\n") == 1


def test_ctrl_c_says_how_to_go_on(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("carom.study.sweep", interrupted)
    told = carom_says(capsys, "sweep", "gas", "--vary", "seed=0:2", "--seconds", "1", "--out", "kept")
    assert told == (130, "", "carom: interrupted; kept keeps what is done, --resume goes on with it\n")


@pytest.mark.parametrize("option", ["--out", "--seconds", "--vary"])
def test_what_must_be_given_is_asked_for(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    given = {"--out": "kept", "--seconds": "1", "--vary": "seed=0:2"}
    asked = [word for name, value in given.items() if name != option for word in (name, value)]
    status, out, told = carom_says(capsys, "sweep", "gas", *asked)
    assert (status, out) == (2, "")
    assert told.startswith(f"carom: {option}: is missing; say ")
    assert told.count("\n") == 1
