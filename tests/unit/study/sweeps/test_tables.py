"""Rows as Parquet, and tables of rows: the same bytes however the rows came together."""

import json
from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.study.sweeps.grid import Run
from carom.study.sweeps.job import Row
from carom.study.sweeps.tables import (
    failure_table,
    part_bytes,
    read_table,
    result_table,
    rows_of,
    table_bytes,
)

texts = st.none() | st.text()
rows = st.builds(Row, st.text(), texts, texts, texts, st.floats(allow_nan=False), st.just(False))


@settings(max_examples=15)
@given(st.lists(rows, max_size=5))
def test_rows_come_back_from_a_part_as_they_were(listed: list[Row]) -> None:
    assert rows_of(part_bytes(listed)) == listed


def row(name: str, measures: Any = None, error: str | None = None) -> Row:
    """A row of a run."""
    return Row(name, None if error else json.dumps(measures), None if error else f"d{name}", error, 0.5)


RUNS = [Run({"a": 1, "b": (0.5,)}, 7), Run({"a": 2.5, "b": (1.5,)}, None), Run({"a": 3, "b": ()}, 9)]
IDS = ["x", "y", "z"]


def test_the_table_has_the_runs_in_their_order_and_all_that_was_measured() -> None:
    found = {
        "z": row("z", {"n": 3, "only": "here"}),
        "x": row("x", {"n": 1, "list": [1, 2]}),
        "y": row("y", {"n": 2.5}),
    }
    assert result_table(RUNS, IDS, found).to_pydict() == {
        "run": IDS,
        "a": [1.0, 2.5, 3.0],
        "b": [[0.5], [1.5], []],
        "seed": [7, None, 9],
        "n": [1.0, 2.5, 3.0],
        "list": [[1, 2], None, None],
        "only": [None, None, "here"],
        "digest": ["dx", "dy", "dz"],
        "seconds": [0.5, 0.5, 0.5],
    }
    assert failure_table(RUNS, IDS, found).num_rows == 0


def test_runs_that_failed_are_in_the_other_table() -> None:
    found = {"x": row("x", {}), "y": row("y", error="E: why"), "z": row("z", {})}
    assert result_table(RUNS, IDS, found)["run"].to_pylist() == ["x", "z"]
    expected = {"run": ["y"], "a": [2.5], "b": [[1.5]], "seed": [None], "error": ["E: why"]}
    assert failure_table(RUNS, IDS, found).to_pydict() == expected


@pytest.mark.parametrize("values", [[1, "a"], [True, 2], [[1], 2], [0.5, 2**62 + 1]])
def test_values_that_no_type_holds_together_come_as_text(values: list[Any]) -> None:
    found = {name: row(name, {"n": value}) for name, value in zip(IDS, [*values, None], strict=True)}
    texts = [json.dumps(value, separators=(",", ":")) for value in values]
    assert result_table(RUNS, IDS, found)["n"].to_pylist() == [*texts, None]


def test_a_table_comes_back_from_its_bytes() -> None:
    table = pa.table({"a": [1, 2], "b": ["x", None]})
    assert read_table(table_bytes(table)).equals(table)
    assert table_bytes(read_table(table_bytes(table))) == table_bytes(table)
