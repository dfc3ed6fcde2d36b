"""The hits of a run as a CSV or a Parquet file."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.extras import needed
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from numpy.typing import NDArray

#: The columns: seconds; "bounce", "enter" or "exit"; id and name (empty where there is none) of ball and shape; the
#: point; the unit normal from shape to ball; the depth of the overlap; the speed of the impact; the momentum given; the
#: ball's velocity before; its centre.
COLUMNS = (
    "time",
    "kind",
    "ball",
    "ball_name",
    "shape",
    "shape_name",
    "x",
    "y",
    "normal_x",
    "normal_y",
    "setback",
    "speed",
    "impulse",
    "velocity_x",
    "velocity_y",
    "position_x",
    "position_y",
)


def write_hits(path: Path, hits: NDArray[Any], names: Mapping[int, str]) -> None:
    """Write one line for each of `hits`, in order of time, every number with all of its digits.

    `names` are those of shapes and balls that have one, by id.
    """
    kinds = {kind.value: kind.name.lower() for kind in HitKind}
    with path.open("w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(COLUMNS)
        for time, kind, ball, shape, point, normal, *rest, velocity, position in hits.tolist():
            whose = (ball, names.get(ball, ""), shape, names.get(shape, ""))
            vectors = (*velocity.tolist(), *position.tolist())
            lines.writerow((time, kinds[kind], *whose, *point.tolist(), *normal.tolist(), *rest, *vectors))


def write_hits_table(path: Path, hits: NDArray[Any], names: Mapping[int, str]) -> None:
    """Write the same columns as a table that can be read by column, names as null where there is none."""
    arrow = needed("pyarrow", "pyarrow", "study", "Parquet files")
    parquet = needed("pyarrow.parquet", "pyarrow", "study", "Parquet files")
    kinds = {kind.value: kind.name.lower() for kind in HitKind}
    columns: dict[str, Any] = {name: np.ascontiguousarray(hits[name]) for name in hits.dtype.names or ()}
    for axis, letter in enumerate("xy"):
        columns[letter] = np.ascontiguousarray(hits["point"][:, axis])
        for field in ("normal", "velocity", "position"):
            columns[f"{field}_{letter}"] = np.ascontiguousarray(hits[field][:, axis])
    columns["kind"] = arrow.array([kinds[kind] for kind in hits["kind"].tolist()], arrow.string()).dictionary_encode()
    for whose in ("ball", "shape"):
        called = [names.get(member) for member in hits[whose].tolist()]
        columns[f"{whose}_name"] = arrow.array(called, arrow.string()).dictionary_encode()
    parquet.write_table(arrow.table({name: columns[name] for name in COLUMNS}), path)
