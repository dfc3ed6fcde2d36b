"""Where a sweep is kept: a folder of this machine, or an address that fsspec knows.

In a folder, what is written is whole or not there, and on the disk when the call returns. Addresses go as far as fsspec
does: a file is put there in one go, and nobody keeps two sweeps apart.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Protocol

from carom import checks
from carom.checks import refuse
from carom.errors import InvalidArgument, SweepError
from carom.extras import needed
from carom.scene.files import write_whole

LOCK = "lock"


class Store(Protocol):
    """Where the files of a sweep are."""

    name: str

    def claimed(self) -> Any:
        """A context in which nobody else works here; raises `SweepError` where someone does."""

    def names(self) -> list[str]:
        """The names of the files."""

    def read(self, name: str) -> bytes | None:
        """What is in a file; None where there is none."""

    def write(self, name: str, data: bytes) -> None:
        """Make `data` the contents of a file."""

    def append(self, name: str, data: bytes) -> None:
        """Add `data` to a file's end."""

    def remove(self, name: str) -> None:
        """Take a file away."""


class Folder:
    """A folder of this machine."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.name = os.fspath(path)
        self._path = Path(path).absolute()

    @contextmanager
    def claimed(self) -> Iterator[None]:
        """The folder, made if it is not there, for one sweep at a time."""
        from filelock import FileLock, Timeout

        self._path.mkdir(parents=True, exist_ok=True)
        lock = FileLock(self._path / LOCK)
        try:
            lock.acquire(timeout=0)
        except Timeout:
            raise SweepError(f"{self.name}: another process is at work on the sweep in this folder") from None
        try:
            yield
        finally:
            lock.release()

    def names(self) -> list[str]:
        """The names of the files."""
        return sorted(path.name for path in self._path.iterdir())

    def read(self, name: str) -> bytes | None:
        """What is in a file; None where there is none."""
        try:
            return (self._path / name).read_bytes()
        except FileNotFoundError:
            return None

    def write(self, name: str, data: bytes) -> None:
        """Make `data` the contents of a file, on the disk, whole or not at all."""
        write_whole(self._path / name, data)
        self._sync()

    def append(self, name: str, data: bytes) -> None:
        """Add `data` to a file's end, on the disk; where that fails, take away what was written of it."""
        path = self._path / name
        is_new = not path.exists()
        with path.open("ab") as file:
            size = file.tell()
            try:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            except OSError:
                with suppress(OSError):
                    os.ftruncate(file.fileno(), size)
                raise
        if is_new:
            self._sync()

    def remove(self, name: str) -> None:
        """Take a file away."""
        (self._path / name).unlink(missing_ok=True)

    def _sync(self) -> None:
        """Put the names of the files on the disk, where the system lets one."""
        if os.name == "posix":
            folder = os.open(self._path, os.O_RDONLY)
            try:
                os.fsync(folder)
            finally:
                os.close(folder)


class Address:
    """An address that fsspec knows, like `s3://bucket/results`."""

    def __init__(self, address: str) -> None:
        self.name = address
        fsspec = needed("fsspec", "fsspec", "sweep", "sweeps that are kept at an address")
        try:
            self._files, self._root = fsspec.core.url_to_fs(address)
        except (ImportError, ValueError) as error:
            raise refuse("out", f"must be an address that fsspec knows ({error})", address) from None

    @contextmanager
    def claimed(self) -> Iterator[None]:
        """The place, made if it is not there."""
        self._files.makedirs(self._root, exist_ok=True)
        yield

    def names(self) -> list[str]:
        """The names of the files."""
        self._files.invalidate_cache()
        return sorted(path.rpartition("/")[2] for path in self._files.ls(self._root, detail=False))

    def read(self, name: str) -> bytes | None:
        """What is in a file; None where there is none."""
        try:
            data: bytes = self._files.cat_file(f"{self._root}/{name}")
        except FileNotFoundError:
            return None
        return data

    def write(self, name: str, data: bytes) -> None:
        """Make `data` the contents of a file."""
        self._files.pipe_file(f"{self._root}/{name}", data)

    def append(self, name: str, data: bytes) -> None:
        """Add `data` to a file's end, by writing all of it anew."""
        self.write(name, (self.read(name) or b"") + data)

    def remove(self, name: str) -> None:
        """Take a file away."""
        self._files.rm_file(f"{self._root}/{name}")


def store_of(out: Any) -> Store:
    """The place that the argument `out` of a sweep means; raises `InvalidArgument` where it means none."""
    if isinstance(out, str) and "://" in out:
        return Address(out)
    try:
        return Folder(checks.path("out", out))
    except InvalidArgument:
        raise refuse("out", "must be a folder, or an address that fsspec knows", out) from None
