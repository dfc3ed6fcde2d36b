"""Rows of a sweep as Parquet, and the tables that are made of them at its end."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from carom.extras import needed
from carom.study.sweeps.grid import SEED, Run
from carom.study.sweeps.job import Row
from carom.study.sweeps.values import text_of

if TYPE_CHECKING:
    import pyarrow

#: The columns of a part, with the names of their types in pyarrow.
PART = {"run": "string", "measures": "string", "digest": "string", "error": "string", "seconds": "float64"}


def arrow(module: str = "pyarrow") -> Any:
    """A module of pyarrow; raises `MissingExtra` where that is not installed."""
    return needed(module, "pyarrow", "sweep", "sweeps")


def part_bytes(rows: Iterable[Row]) -> bytes:
    """Rows as the bytes of a Parquet file."""
    module, listed = arrow(), list(rows)
    columns = {
        name: module.array([getattr(row, name) for row in listed], getattr(module, kind)())
        for name, kind in PART.items()
    }
    return table_bytes(module.table(columns))


def rows_of(data: bytes) -> list[Row]:
    """The rows of which `part_bytes` made bytes."""
    return [Row(**row) for row in read_table(data).to_pylist()]


def read_table(data: bytes) -> pyarrow.Table:
    """The table of which `table_bytes` made bytes; raises `ValueError` or `OSError` where they are damaged."""
    table: pyarrow.Table = arrow("pyarrow.parquet").read_table(arrow().BufferReader(data))
    return table


def table_bytes(table: pyarrow.Table) -> bytes:
    """A table as the bytes of a Parquet file."""
    sink = arrow().BufferOutputStream()
    arrow("pyarrow.parquet").write_table(table, sink)
    data: bytes = sink.getvalue().to_pybytes()
    return data


def result_table(runs: Sequence[Run], ids: Sequence[str], rows: Mapping[str, Row]) -> pyarrow.Table:
    """The table of the runs that came to their end, in the order of the sweep: what they were, measures, digests."""
    kept = [(run, rows[name]) for name, run in zip(ids, runs, strict=True) if rows[name].error is None]
    measured = [json.loads(row.measures or "{}") for _, row in kept]
    columns = _columns_of_runs([(run, row.run) for run, row in kept], runs[0])
    for name in dict.fromkeys(name for one in measured for name in one):
        columns[name] = _column([one.get(name) for one in measured])
    columns["digest"] = arrow().array([row.digest for _, row in kept], arrow().string())
    columns["seconds"] = arrow().array([row.seconds for _, row in kept], arrow().float64())
    return arrow().table(columns)


def failure_table(runs: Sequence[Run], ids: Sequence[str], rows: Mapping[str, Row]) -> pyarrow.Table:
    """The table of the runs that failed, in the order of the sweep: what they were, and why."""
    kept = [(run, rows[name]) for name, run in zip(ids, runs, strict=True) if rows[name].error is not None]
    columns = _columns_of_runs([(run, row.run) for run, row in kept], runs[0])
    columns["error"] = arrow().array([row.error for _, row in kept], arrow().string())
    return arrow().table(columns)


def _columns_of_runs(kept: Sequence[tuple[Run, str]], first: Run) -> dict[str, Any]:
    """The columns of ids, parameters and seeds; `first` is a run whose parameters have the names of all."""
    columns = {"run": arrow().array([name for _, name in kept], arrow().string())}
    for name in first.parameters:
        columns[name] = _column([run.parameters[name] for run, _ in kept])
    columns[SEED] = arrow().array([run.seed for run, _ in kept], arrow().int64())
    return columns


def _column(values: list[Any]) -> Any:
    """Values as a column; as the texts of their JSON where no type holds them all."""
    module = arrow()
    try:
        return module.array(values)
    except (module.ArrowInvalid, module.ArrowTypeError, OverflowError):
        return module.array([None if value is None else text_of(value) for value in values], module.string())
