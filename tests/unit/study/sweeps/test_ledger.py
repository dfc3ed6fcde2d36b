"""The ledger: what it does not say did not happen, whatever is left of it."""

import errno
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom.study.sweeps.job import Row
from carom.study.sweeps.ledger import LEDGER, PART, SWEEP, Ledger, hash_of
from carom.study.sweeps.store import Folder

IDS = ["a", "b", "c", "d"]
KIND = {"scene": "s", "seconds": 60.0, "runs": 4}


def row(name: str, error: str | None = None) -> Row:
    """A row of a run."""
    return Row(name, None if error else "{}", "d", error, 0.25)


def opened(out: Path, sweep: dict[str, Any] = KIND) -> Ledger:
    """The ledger of a folder."""
    out.mkdir(exist_ok=True)
    ledger = Ledger(Folder(out), sweep, IDS)
    ledger.open()
    return ledger


def filled(out: Path) -> Ledger:
    """A ledger with two parts."""
    ledger = opened(out)
    ledger.add([row("b"), row("a")], 1, "me")
    ledger.add([row("c", "why")], 2, "you")
    return ledger


def test_what_was_added_counts_when_it_is_opened_again(tmp_path: Path) -> None:
    filled(tmp_path)
    again = opened(tmp_path)
    assert (again.done, again.failed) == ({"a", "b", "c"}, 1)
    again.add([row("d")], 1, "me")
    assert again.rows() == {name: row(name, "why" if name == "c" else None) for name in IDS}


def test_a_run_is_counted_once(tmp_path: Path) -> None:
    ledger = filled(tmp_path)
    ledger.add([row("b", "another time"), row("d")], 1, "me")
    ledger.add([row("d", "another time")], 1, "me")
    assert len((tmp_path / LEDGER).read_text().splitlines()) == 3
    again = opened(tmp_path)
    assert (again.rows()["b"], again.failed) == (row("b"), 1)


def test_a_run_that_two_parts_hold_counts_as_the_first_says(tmp_path: Path) -> None:
    """As at an address, where nobody keeps two sweeps apart."""
    one, two = opened(tmp_path), opened(tmp_path)
    one.add([row("a"), row("b")], 1, "one")
    two.add([row("b", "why"), row("c"), row("d")], 1, "two")
    again = opened(tmp_path)
    assert (again.done, again.failed) == (set(IDS), 0)
    assert again.rows() == {name: row(name) for name in IDS}


@settings(max_examples=15)
@given(cut=st.integers(0, 10_000))
def test_a_ledger_that_is_torn_anywhere_counts_its_whole_lines(
    cut: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    out = tmp_path_factory.mktemp("torn")
    filled(out)
    data = (out / LEDGER).read_bytes()
    torn = data[: cut % (len(data) + 1)]
    (out / LEDGER).write_bytes(torn)
    ledger = opened(out)
    whole = torn.count(b"\n") + (torn in (data[: data.index(b"\n")], data[:-1]))
    assert ledger.done == [set(), {"a", "b"}, {"a", "b", "c"}][whole]
    assert sum(name.startswith(PART) for name in Folder(out).names()) == whole
    ledger.add([row(name) for name in IDS], 1, "me")
    assert opened(out).rows().keys() == set(IDS)


@pytest.mark.parametrize("damage", [b"", b"PAR1", None])
def test_a_part_that_is_damaged_or_gone_is_done_again(tmp_path: Path, damage: bytes | None) -> None:
    filled(tmp_path)
    part = next(path for path in tmp_path.glob(f"{PART}*") if len(path.read_bytes()) > 0)
    if damage is None:
        part.unlink()
    else:
        part.write_bytes(damage)
    ledger = opened(tmp_path)
    assert ledger.done in ({"a", "b"}, {"c"})
    assert len((tmp_path / LEDGER).read_text().splitlines()) == 1


def test_what_no_line_names_is_taken_away(tmp_path: Path) -> None:
    filled(tmp_path)
    for stray in ("part-stray.parquet", ".part-1.parquet.0123.part"):
        (tmp_path / stray).write_bytes(b"x")
    (tmp_path / "notes.txt").write_bytes(b"mine")
    opened(tmp_path)
    names = Folder(tmp_path).names()
    assert "notes.txt" in names
    assert not {"part-stray.parquet", ".part-1.parquet.0123.part"} & set(names)


@pytest.mark.parametrize("line", ["[]", "3", '{"part": "../x", "hash": "0"}', '{"part": 3, "hash": 3}', "\0\0", "{}"])
def test_a_line_of_another_kind_does_not_count(tmp_path: Path, line: str) -> None:
    filled(tmp_path)
    with (tmp_path / LEDGER).open("a") as file:
        file.write(f"{line}\n")
    assert opened(tmp_path).done == {"a", "b", "c"}


@pytest.mark.parametrize(
    ("other", "words"),
    [
        ({"seconds": 30.0}, "holds another sweep, which differs in its seconds: 60.0, not 30.0"),
        ({"scene": "t"}, "holds another sweep, which differs in its scene"),
    ],
)
def test_another_sweep_is_refused_and_nothing_is_changed(tmp_path: Path, other: dict[str, Any], words: str) -> None:
    filled(tmp_path)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    with pytest.raises(carom.InvalidArgument, match=words):
        opened(tmp_path, KIND | other)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_a_folder_that_says_of_no_sweep_is_refused(tmp_path: Path) -> None:
    filled(tmp_path)
    (tmp_path / SWEEP).write_text("[")
    with pytest.raises(carom.InvalidArgument, match=r"holds a sweep.json that is no sweep's"):
        opened(tmp_path)
    (tmp_path / SWEEP).unlink()
    with pytest.raises(carom.InvalidArgument, match=r"holds a ledger, but no sweep.json"):
        opened(tmp_path)


def test_a_full_disk_is_told_with_what_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ledger = filled(tmp_path)

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Folder, "append", full)
    with pytest.raises(carom.SweepError) as caught:
        ledger.add([row("d")], 1, "me")
    kept = "3 of 4 runs are kept, and the same sweep goes on with the rest"
    assert str(caught.value) == f"{tmp_path}: cannot be written: No space left on device; {kept}"
    monkeypatch.undo()
    assert opened(tmp_path).done == {"a", "b", "c"}


def test_the_hash_is_blake2(tmp_path: Path) -> None:
    assert hash_of(b"") == "cae66941d9efbd404e4d88758ea67670"
