"""The hits of a run as a file: a line each, with all digits, and the same in both forms of it."""

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from carom.cli.hits_file import COLUMNS, write_hits, write_hits_table
from carom.rows.hit import HIT
from carom.world.hits import HitKind


@pytest.fixture
def hits() -> Any:
    """A hit of each kind, with numbers of many digits."""
    rows = np.zeros(len(HitKind), HIT)
    for number, (row, kind) in enumerate(zip(rows, HitKind, strict=True)):
        row["time"], row["kind"] = number / 3.0, kind.value
        row["ball"], row["shape"] = 7, number
        row["point"], row["normal"] = (0.1 + number, -1e-300), (0.6, -0.8)
        row["setback"], row["speed"], row["impulse"] = 1 / 7, 2 / 7, -0.0
        row["velocity"], row["position"] = (1 / 3, -number), (number / 9, 1e300)
    return rows


#: What some of the balls and shapes are called.
NAMES = {7: 'a "ball", red', 1: "ä\nline"}


def lines_of(path: Path) -> list[list[str]]:
    """The lines of a CSV file, without its heading."""
    with path.open(encoding="utf-8", newline="") as file:
        heading, *lines = csv.reader(file)
    assert tuple(heading) == COLUMNS
    return lines


def test_every_hit_is_a_line_with_all_of_its_digits(tmp_path: Path, hits: Any) -> None:
    write_hits(tmp_path / "run.csv", hits, NAMES)
    lines = lines_of(tmp_path / "run.csv")
    assert len(lines) == len(hits)
    for line, row in zip(lines, hits, strict=True):
        told = dict(zip(COLUMNS, line, strict=True))
        assert told["kind"] == HitKind(row["kind"]).name.lower()
        assert (int(told["ball"]), int(told["shape"])) == (row["ball"], row["shape"])
        assert told["ball_name"] == NAMES[7]
        assert told["shape_name"] == NAMES.get(int(row["shape"]), "")
        for name in ("time", "setback", "speed", "impulse"):
            assert repr(float(told[name])) == repr(float(row[name])), name
        assert (float(told["x"]), float(told["y"])) == tuple(row["point"])
        for name in ("normal", "velocity", "position"):
            assert (float(told[f"{name}_x"]), float(told[f"{name}_y"])) == tuple(row[name])


@pytest.mark.parametrize("count", [0, 3])
def test_a_table_of_hits_holds_what_the_csv_file_does(tmp_path: Path, hits: Any, count: int) -> None:
    parquet = pytest.importorskip("pyarrow.parquet", reason='no pyarrow: pip install "carom[study]"')
    write_hits(tmp_path / "run.csv", hits[:count], NAMES)
    write_hits_table(tmp_path / "run.parquet", hits[:count], NAMES)
    table = parquet.read_table(tmp_path / "run.parquet")
    assert tuple(table.column_names) == COLUMNS
    told = [["" if value is None else str(value) for value in row.values()] for row in table.to_pylist()]
    assert told == lines_of(tmp_path / "run.csv")
    assert len(told) == count


def test_a_run_of_no_hits_is_a_heading(tmp_path: Path) -> None:
    hits = carom.World().run(0.1)
    write_hits(tmp_path / "run.csv", np.asarray(hits), {})
    assert (tmp_path / "run.csv").read_text() == ",".join(COLUMNS) + "\n"
