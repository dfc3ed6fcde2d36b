"""Recordings as files: every bit comes back, the same run makes the same bytes, and what is damaged is refused."""

import io
import json
import zlib
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from random import Random
from typing import Any
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

import numpy as np
import pytest

import carom
from carom.record import files
from tests.worlds import quiet


def same(one: carom.Recording, other: carom.Recording) -> bool:
    """Whether two recordings agree in every bit."""
    for field in fields(one):
        first, second = getattr(one, field.name), getattr(other, field.name)
        if isinstance(first, np.ndarray):
            if (first.dtype, first.shape, first.tobytes()) != (second.dtype, second.shape, second.tobytes()):
                return False
        elif first != second:
            return False
    return True


def test_every_bit_comes_back(tmp_path: Path, recording: carom.Recording) -> None:
    recording.save(tmp_path / "run.carom")
    assert same(carom.Recording.load(tmp_path / "run.carom"), recording)
    assert [path.name for path in tmp_path.iterdir()] == ["run.carom"]


@pytest.mark.parametrize("seconds", [0.0, 1 / 60, 2 / 60])
def test_runs_of_few_frames_come_back_too(tmp_path: Path, seconds: float) -> None:
    for number, world in enumerate((carom.World(), quiet())):
        recording = carom.Recording.of(world, seconds)
        recording.save(tmp_path / f"{number}")
        assert same(carom.Recording.load(tmp_path / f"{number}"), recording)


def test_the_same_run_makes_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "two"):
        carom.Recording.of(quiet(), 0.5).save(tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


def test_files_are_compact(tmp_path: Path) -> None:
    recording = carom.Recording.of(carom.scenes.toy().build(), 2.0)
    recording.save(tmp_path / "run.carom")
    with ZipFile(tmp_path / "run.carom") as archive:
        for name, part in (("positions", 0.5), ("velocities", 0.8), ("hits", 1.2), ("poses", 0.5)):
            plain = zlib.compress(np.ascontiguousarray(getattr(recording, name)).tobytes())
            assert archive.getinfo(name).compress_size < part * len(plain), name


def refusal(path: Path) -> str:
    """What is said of a file that is refused: one line that begins with its name."""
    with pytest.raises(carom.RecordingError) as caught:
        carom.Recording.load(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    assert "\n" not in text
    return text


def test_a_file_that_is_cut_anywhere_is_refused(tmp_path: Path, recording: carom.Recording) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    data = path.read_bytes()
    for length in {0, 1, 10, len(data) // 4, len(data) // 2, len(data) - 30, len(data) - 1}:
        path.write_bytes(data[:length])
        assert "is damaged or no recording" in refusal(path)


@pytest.mark.slow
def test_a_file_with_a_flipped_bit_is_refused_or_the_same(tmp_path: Path, recording: carom.Recording) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    data = path.read_bytes()
    random = Random(1)
    told = []
    for _ in range(60):
        damaged = bytearray(data)
        damaged[random.randrange(len(data))] ^= 1 << random.randrange(8)
        path.write_bytes(bytes(damaged))
        try:
            assert same(carom.Recording.load(path), recording)
        except carom.RecordingError as error:
            told.append(str(error))
    assert len(told) > 40
    assert [text for text in told if not text.startswith(f"{path}: ")] == []


def test_what_is_no_recording_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "run.carom"
    assert "cannot be read: No such file" in refusal(path)
    path.write_text("version = 1\n")
    assert "is damaged or no recording" in refusal(path)
    with ZipFile(path, "w") as archive:
        archive.writestr("x", "y")
    assert "is no recording: KeyError" in refusal(path)
    for name in (5, "a\0b"):
        with pytest.raises(carom.RecordingError, match="path must be a file's name"):
            carom.Recording.load(name)


def changed(data: bytes, name: str, change: Callable[[bytes], bytes]) -> bytes:
    """An archive in which one entry is another, with check sums that fit."""
    memory = io.BytesIO()
    with ZipFile(io.BytesIO(data)) as old, ZipFile(memory, "w", ZIP_STORED) as new:
        for entry in old.namelist():
            new.writestr(entry, change(old.read(entry)) if entry == name else old.read(entry))
    return memory.getvalue()


def head(**values: Any) -> Callable[[bytes], bytes]:
    """A change of the head."""

    def change(data: bytes) -> bytes:
        table = json.loads(data)
        for key, value in values.items():
            table[key] = table[key] | value if isinstance(table[key], dict) and isinstance(value, dict) else value
        return json.dumps(table).encode()

    return change


@pytest.mark.parametrize(
    ("entry", "change", "told"),
    [
        (files.HEAD, lambda data: b"{", "JSONDecodeError"),
        (files.HEAD, lambda data: b"\xff", "UnicodeDecodeError"),
        (files.HEAD, lambda data: b"[" * 100_000, "nested too deeply"),
        (files.HEAD, lambda data: b"[]", "TypeError"),
        (files.HEAD, head(format=1), "has format 1; this version of carom reads 2"),
        (files.HEAD, head(scene={"world": {"gravity": "down"}}), "world.gravity"),
        (files.HEAD, head(scene={"shapes": []}), "shape_ids must name the 0 shapes of the scene"),
        (files.HEAD, head(lengths={"times": 10**6}), "times must have 8000000 bytes"),
        (files.HEAD, head(lengths={"times": -1}), "times must have -8 bytes"),
        (files.HEAD, head(lengths={"times": "x"}), "is no recording"),
        (files.HEAD, head(names={"x": "y"}), "ValueError"),
        (files.HEAD, head(names={"1": 5}), "names must map int to str"),
        (files.HEAD, head(statistics={"collisions": 0.5}), "statistics must map str to int"),
        (files.HEAD, head(name=None), "name must be a string"),
        ("asleep", lambda data: b"\x02" + data[1:], "a flag must be 0 or 1"),
        ("radii", lambda data: data[:-8], "radii must have"),
        ("radii", lambda data: bytes(len(data)), "radii must be positive and finite"),
    ],
)
def test_what_is_wrong_in_a_file_is_named(
    tmp_path: Path, recording: carom.Recording, entry: str, change: Callable[[bytes], bytes], told: str
) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    path.write_bytes(changed(path.read_bytes(), entry, change))
    assert told in refusal(path)


def test_a_file_that_cannot_be_written_leaves_what_was_there(
    tmp_path: Path, recording: carom.Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "run.carom"
    path.write_text("old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(carom.RecordingError, match=r"run\.carom: cannot be written: No space left on device"):
        recording.save(path)
    assert path.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["run.carom"]
    with pytest.raises(carom.RecordingError, match="cannot be written: No such file"):
        recording.save(tmp_path / "missing" / "run.carom")


# -- limits ------------------------------------------------------------------------------------------------------------


def with_head(path: Path, change: Callable[[dict[str, Any]], object]) -> None:
    """Change what a file says in words."""
    with ZipFile(path) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    head = json.loads(entries[files.HEAD].decode("utf-8", "surrogatepass"))
    change(head)
    entries[files.HEAD] = json.dumps(head).encode()
    with ZipFile(path, "w") as archive:
        for name, data in entries.items():
            archive.writestr(name, data)


@pytest.mark.parametrize(("limit", "what"), [("LARGEST_RECORDING", "in numbers"), ("LONGEST_FILE", "in words")])
def test_a_recording_of_the_largest_size_is_kept_and_a_larger_one_refused(
    tmp_path: Path, recording: carom.Recording, monkeypatch: pytest.MonkeyPatch, limit: str, what: str
) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    with ZipFile(path) as archive:
        words = archive.getinfo(files.HEAD).file_size
        numbers = sum(entry.file_size for entry in archive.infolist()) - words
    size = words if limit == "LONGEST_FILE" else numbers
    monkeypatch.setattr(files, limit, size)
    recording.save(path)
    assert same(carom.Recording.load(path), recording)
    monkeypatch.setattr(files, limit, size - 1)
    assert refusal(path) == f"{path}: takes {size} bytes {what}, more than {size - 1}"
    with pytest.raises(carom.RecordingError, match=rf"cannot be written: takes {size} bytes {what}"):
        recording.save(tmp_path / "other.carom")
    assert not (tmp_path / "other.carom").exists()


@pytest.mark.parametrize("name", ["times", "ids", "shape_ids", "moving", "hits"])
@pytest.mark.parametrize("count", [10**9, 10**18, 10**4000, -1, 1.5, True, None, "many", [1]])
def test_a_count_that_is_not_that_of_the_numbers_is_refused(
    tmp_path: Path, recording: carom.Recording, name: str, count: object
) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    with_head(path, lambda head: head["lengths"].update({name: count}))
    assert len(refusal(path)) < 6000


@pytest.mark.parametrize("levels", [16, 17, 100_000])
def test_words_that_are_nested_too_deeply_are_refused(tmp_path: Path, recording: carom.Recording, levels: int) -> None:
    path = tmp_path / "run.carom"
    recording.save(path)
    with ZipFile(path, "w") as archive:
        archive.writestr(files.HEAD, "[" * levels + "]" * levels)
    assert ("nested too deeply" in refusal(path)) == (levels > 16)


@pytest.mark.slow
def test_a_bomb_is_not_set_off(tmp_path: Path) -> None:
    """Words that pack to a thousandth, entries by the hundred thousand: refused before they are unpacked."""
    words, entries = tmp_path / "words.carom", tmp_path / "entries.carom"
    with ZipFile(words, "w", ZIP_DEFLATED) as archive, archive.open(files.HEAD, "w") as file:
        for _ in range(100):
            file.write(b" " * 2**20)
    assert "bytes in words, more than" in refusal(words)
    with ZipFile(entries, "w") as archive:
        for number in range(5000):
            archive.writestr(str(number), b"")
    assert "too much is in it" in refusal(entries)
