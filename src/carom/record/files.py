"""Recordings as files.

A file is a ZIP archive: `recording.json` with the scene, names, counts and lengths, and each array as the bytes of its
numbers. Frames follow each other closely, so numbers over frames are written as differences of their bits, as 64-bit
integers, and where what they tell moves steadily, as differences of these. All numbers of 8 bytes stand with first
bytes before second bytes: what is small then is a row of zeros, which ZIP's own compression makes vanish. Every bit
comes back. ZIP's check sums tell damage.
"""

from __future__ import annotations

import io
import json
import os
import zlib
from math import prod
from typing import TYPE_CHECKING, Any, TypeVar
from zipfile import ZIP_DEFLATED, BadZipFile, ZipFile, ZipInfo

import numpy as np

from carom import checks
from carom.checks import LONGEST_VALUE, written
from carom.errors import CaromError, InvalidArgument, RecordingError
from carom.limits import LARGEST_RECORDING, LONGEST_FILE, LONGEST_LISTING
from carom.record.check import ARRAYS, COUNTED
from carom.rows.hit import HIT
from carom.scene.files import write_whole
from carom.scene.scanning import check_json
from carom.scene.scene import Scene

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.record.recording import Recording

    R = TypeVar("R", bound=Recording)

#: The form of the files; a library that does not know it refuses them.
FORMAT = 2
HEAD = "recording.json"
#: How often differences are taken along the frames; in between the hits, velocities stay and places move steadily.
DIFFERENCES = {"times": 2, "positions": 2, "velocities": 1, "poses": 2}
#: Numbers of hits, 8 bytes each.
HIT_WORDS = HIT.itemsize // 8
#: ZIP wants a date in each entry; one that is always the same makes the same bytes of the same recording.
NO_DATE = (1980, 1, 1, 0, 0, 0)


def write_recording(recording: Recording, path: str | os.PathLike[str]) -> None:
    """Write a recording to a file, whole or not at all; raise `RecordingError`."""
    file_name = _checked(path)
    try:
        write_whole(path, recording_bytes(recording))
    except RecordingError as error:
        raise RecordingError(f"{file_name}: cannot be written: {error}") from None
    except OSError as error:
        raise RecordingError(f"{file_name}: cannot be written: {error.strerror}") from None


def recording_bytes(recording: Recording) -> bytes:
    """The bytes of the file of a recording."""
    memory = io.BytesIO()
    head = json.dumps(_head(recording), ensure_ascii=False).encode("utf-8", "surrogatepass")
    _check_size("in words", len(head), LONGEST_FILE)
    _check_size("in numbers", _size(_head(recording)["lengths"]), LARGEST_RECORDING)
    with ZipFile(memory, "w") as archive:
        _add(archive, HEAD, head)
        for field, (dtype, _) in ARRAYS.items():
            _add(archive, field, _packed(getattr(recording, field), dtype, DIFFERENCES.get(field, 0)))
        rows = np.ascontiguousarray(recording.hits).view("u8").reshape(-1, HIT_WORDS)
        _add(archive, "hits", _planes(rows.T))
    return memory.getvalue()


def read_recording(kind: type[R], path: str | os.PathLike[str]) -> R:
    """The recording in a file, of class `kind`; raises `RecordingError`, with the file's name."""
    file_name = _checked(path)
    try:
        with _Archive(file_name) as file, ZipFile(file) as archive:
            file.listing = False
            return kind(**_fields(archive))
    except OSError as error:
        raise RecordingError(f"{file_name}: cannot be read: {error.strerror or error}") from None
    except (BadZipFile, zlib.error, EOFError, NotImplementedError) as error:
        raise RecordingError(f"{file_name}: is damaged or no recording: {error}") from None
    except CaromError as error:
        raise RecordingError(f"{file_name}: {error}") from None
    except (ValueError, TypeError, LookupError, RuntimeError, MemoryError, RecursionError, OverflowError) as error:
        brief = f"{type(error).__name__}: {error}"[:LONGEST_VALUE]
        raise RecordingError(f"{file_name}: is no recording: {brief}") from None


class _Archive(io.FileIO):
    """A file whose list of what is in it is read only if it is about as long as that of a recording."""

    listing = True

    def read(self, size: int | None = -1, /) -> bytes:
        if self.listing:
            wanted = os.fstat(self.fileno()).st_size - self.tell() if size is None or size < 0 else size
            if wanted > LONGEST_LISTING:
                raise BadZipFile("too much is in it")
        return super().read(-1 if size is None else size)


def _checked(path: Any) -> str:
    """A path as text; raises where it is none."""
    try:
        return checks.path("path", path)
    except InvalidArgument as error:
        raise RecordingError(str(error)) from None


def _add(archive: ZipFile, name: str, data: bytes) -> None:
    """Put an entry into an archive."""
    entry = ZipInfo(name, NO_DATE)
    entry.compress_type = ZIP_DEFLATED
    archive.writestr(entry, data)


def _head(recording: Recording) -> dict[str, Any]:
    """What stands in words in a file."""
    return {
        "format": FORMAT,
        "name": recording.name,
        "about": recording.about,
        "lengths": {field: len(getattr(recording, field)) for field in (*COUNTED.values(), "hits")},
        "statistics": dict(recording.statistics),
        "names": {str(key): name for key, name in recording.names.items()},
        "scene": recording.scene.plain(),
    }


def _fields(archive: ZipFile) -> dict[str, Any]:
    """The arguments of a recording, from an archive."""
    _check_size("in words", archive.getinfo(HEAD).file_size, LONGEST_FILE)
    text = archive.read(HEAD).decode("utf-8", "surrogatepass")
    check_json(text)
    head = json.loads(text)
    if head["format"] != FORMAT:
        raise RecordingError(f"has format {written(head['format'], 60)[:60]}; this version of carom reads {FORMAT}")
    _check_size("in numbers", _size(head["lengths"]), LARGEST_RECORDING)
    fields: dict[str, Any] = {key: head[key] for key in ("name", "about", "statistics")}
    fields["names"] = {int(key): name for key, name in head["names"].items()}
    fields["scene"] = Scene(**head["scene"])
    for field, (dtype, _) in ARRAYS.items():
        shape, size = _shape(field, head["lengths"])
        fields[field] = _unpacked(_entry(archive, field, size), dtype, shape, DIFFERENCES.get(field, 0))
    words = _entry(archive, "hits", HIT.itemsize * head["lengths"]["hits"])
    fields["hits"] = np.ascontiguousarray(_unplaned(words).reshape(HIT_WORDS, -1).T).reshape(-1).view(HIT)
    return fields


def _shape(field: str, lengths: dict[str, int]) -> tuple[tuple[int, ...], int]:
    """The shape of an array, and its size in bytes."""
    dtype, axes = ARRAYS[field]
    shape = tuple(axis if isinstance(axis, int) else lengths[COUNTED[axis]] for axis in axes)
    return shape, np.dtype(dtype).itemsize * prod(shape)


def _size(lengths: dict[str, int]) -> int:
    """The size in bytes of all arrays and of the hits."""
    return sum(_shape(field, lengths)[1] for field in ARRAYS) + HIT.itemsize * lengths["hits"]


def _check_size(what: str, size: int, most: int) -> None:
    """Raise `RecordingError` where a recording takes more than it may."""
    if size > most:
        raise RecordingError(f"takes {size} bytes {what}, more than {most}")


def _entry(archive: ZipFile, name: str, size: int) -> bytes:
    """The bytes of an entry, as many as `size`; asked first, so that no false one fills the memory."""
    if archive.getinfo(name).file_size != size:
        raise RecordingError(f"{name} must have {size} bytes, not {archive.getinfo(name).file_size}")
    return archive.read(name)


def _packed(values: NDArray[Any], dtype: str, differences: int) -> bytes:
    """An array as the bytes that a file holds."""
    if dtype == "?":
        return values.tobytes()
    words = np.ascontiguousarray(values).view("u8")
    for order in range(differences):
        # Integers wrap around, there and back.
        words = np.concatenate([words[: order + 1], np.diff(words[order:], axis=0)])
    return _planes(words)


def _unpacked(data: bytes, dtype: str, shape: tuple[int, ...], differences: int) -> NDArray[Any]:
    """The array of which `_packed` has made bytes."""
    if dtype == "?":
        flags = np.frombuffer(data, "u1").reshape(shape)
        if (flags > 1).any():
            raise RecordingError("a flag must be 0 or 1")
        return flags.view("?")
    words = _unplaned(data).reshape(shape)
    for order in reversed(range(differences)):
        words[order:] = np.cumsum(words[order:], axis=0, dtype="u8")
    return words.view(dtype)


def _planes(words: NDArray[np.uint64]) -> bytes:
    """Numbers of 8 bytes as bytes: the first bytes of all, then the second bytes, and so on."""
    return words.reshape(-1).astype("<u8").view("u1").reshape(-1, 8).T.tobytes()


def _unplaned(data: bytes) -> NDArray[np.uint64]:
    """The numbers that `_planes` has made bytes of."""
    planes = np.frombuffer(data, "u1").reshape(8, -1)
    return np.ascontiguousarray(planes.T).view("<u8").reshape(-1).astype("u8")
