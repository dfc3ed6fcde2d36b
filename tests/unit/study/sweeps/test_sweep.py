"""`study.sweep`: the table of many runs, what is refused, and how it goes on."""

import sys
from pathlib import Path
from typing import Any

import fsspec
import pyarrow.parquet as pq
import pytest

import carom
from carom import study
from carom.study.sweeps.store import Folder
from tests import sweeping


def test_the_table_says_what_each_world_alone_says(tmp_path: Path) -> None:
    table = study.sweep(
        "newtons_cradle",
        {"balls": [2, 3], "world.gravity": [(0, 0), (0, -9)], "seed": [4, 5]},
        measure=study.measures.energy,
        seconds=0.2,
        out=tmp_path / "out",
        cluster="serial",
        progress=False,
    )
    names = ["run", "balls", "world.gravity", "seed", "kinetic energy", "energy", "digest", "seconds"]
    assert table.column_names == names
    assert table.num_rows == 8
    assert len(set(table["run"].to_pylist())) == len(set(table["digest"].to_pylist())) == 8
    for row in table.to_pylist():
        scene = carom.scenes.newtons_cradle(balls=row["balls"])
        from carom.study.sweeps.sources import spread

        moved = spread(scene, row["seed"])
        world = moved.model_copy(
            update={"world": type(scene.world)(**dict(scene.world) | {"gravity": row["world.gravity"]})}
        ).build()
        world.run(0.2)
        assert row["digest"] == world.digest()
    assert pq.read_table(tmp_path / "out" / "table.parquet").equals(table)


def test_runs_that_raise_are_rows_of_failures(tmp_path: Path) -> None:
    table = sweeping.swept(tmp_path, sweeping.runs(12, raises=3))
    failures = pq.read_table(tmp_path / "failures.parquet")
    assert table.num_rows == 9
    assert failures.column_names == ["run", "number", "deadly", "raises", "seed", "error"]
    assert failures["error"].to_pylist() == ["RuntimeError: as it was told"] * 3
    assert failures["raises"].to_pylist() == [True] * 3


def test_it_goes_on_where_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    quiet = sweeping.swept(tmp_path / "quiet", sweeping.runs(8))
    written: list[str] = []
    append = Folder.append

    def interrupted(folder: Folder, name: str, data: bytes) -> None:
        if len(written) == 2:
            raise KeyboardInterrupt
        append(folder, name, data)
        written.append(name)

    monkeypatch.setattr(Folder, "append", interrupted)
    monkeypatch.setattr("carom.study.sweeps.chunks.CHUNK_SECONDS", 0.0)
    monkeypatch.setattr("carom.study.sweeps.chunks.Chunks._size", lambda _: 2)
    with pytest.raises(KeyboardInterrupt):
        sweeping.swept(tmp_path / "out", sweeping.runs(8))
    monkeypatch.setattr(Folder, "append", append)
    with pytest.raises(carom.InvalidArgument, match="holds this sweep already, 4 of its 8 runs are done"):
        sweeping.swept(tmp_path / "out", sweeping.runs(8), resume=False)
    again: list[str] = []
    row = carom.study.sweeps.job.Job.row

    def counted(job: Any, name: str, run: Any) -> Any:
        again.append(name)
        return row(job, name, run)

    monkeypatch.setattr("carom.study.sweeps.job.Job.row", counted)
    table = sweeping.swept(tmp_path / "out", sweeping.runs(8))
    assert again == quiet["run"].to_pylist()[4:]
    assert sweeping.without_seconds(table) == sweeping.without_seconds(quiet)
    assert sweeping.swept(tmp_path / "out", sweeping.runs(8)).equals(table)
    assert len(again) == 4


def test_it_is_kept_where_fsspec_can(tmp_path: Path) -> None:
    fsspec.filesystem("memory").store.clear()
    table = sweeping.swept("memory://sweeps/one", sweeping.runs(4))
    assert sweeping.without_seconds(table) == sweeping.without_seconds(sweeping.swept(tmp_path, sweeping.runs(4)))
    assert fsspec.filesystem("memory").exists("/sweeps/one/table.parquet")


def test_a_measure_that_returns_nonsense_is_refused_at_its_first_answer(tmp_path: Path) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"^measure's 'world' must be a number"):
        sweeping.swept(tmp_path, sweeping.runs(4), measure="tests.sweeping:nonsense")
    assert not (tmp_path / "ledger.jsonl").exists()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"measure": "hits-by-shap"}, "did you mean hits-by-shape"),
        ({"measure": "no.such:f"}, "measure no.such:f cannot be imported"),
        ({"measure": 3}, "measure must be a function"),
        ({"seconds": -1}, "seconds must not be negative, not -1"),
        ({"dt": 0}, "dt must be positive, not 0"),
        ({"cluster": 3}, "cluster must be None"),
        ({"resume": 3}, "resume must be True or False"),
        ({"out": ""}, "out must be a folder"),
        ({"parameters": []}, "parameters must list at least one run"),
        ({"scene": "pinbal"}, "did you mean pinball"),
        ({"scene": "stadium", "parameters": {"world.gravty": [1]}}, "did you mean gravity"),
    ],
)
def test_bad_input_is_refused_before_anything_is_made(tmp_path: Path, options: dict[str, Any], words: str) -> None:
    given = {
        "scene": "tests.sweeping:drop",
        "parameters": {"number": [1]},
        "measure": "tests.sweeping:told",
        "seconds": 0.1,
        "out": tmp_path / "out",
        "cluster": "serial",
    }
    with pytest.raises(carom.InvalidArgument, match=words):
        study.sweep(**given | options)
    assert not (tmp_path / "out").exists()


def test_a_place_that_cannot_be_written_is_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(carom.SweepError, match=r"file/out: cannot be written: Not a directory"):
        sweeping.swept(tmp_path / "file" / "out", sweeping.runs(2))

    def read_only(*_: object) -> None:
        raise OSError(30, "Read-only file system")

    monkeypatch.setattr(Folder, "write", read_only)
    with pytest.raises(carom.SweepError, match="out: cannot be written: Read-only file system"):
        sweeping.swept(tmp_path / "out", sweeping.runs(2))


@pytest.mark.parametrize(
    ("module", "cluster", "told"),
    [
        ("pyarrow", "serial", 'sweeps need pyarrow: pip install "carom[sweep]"'),
        ("distributed", None, 'sweeps by several processes need dask[distributed]: pip install "carom[sweep]"'),
    ],
)
def test_a_missing_extra_is_named(
    module: str, cluster: str | None, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(carom.MissingExtra) as caught:
        sweeping.swept(tmp_path / "out", sweeping.runs(2), cluster)
    assert str(caught.value) == told
    assert not (tmp_path / "out").exists()
