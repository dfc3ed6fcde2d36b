"""Where sweeps are kept: whole files, ends that are whole, one sweep at a time."""

import errno
import os
from pathlib import Path

import fsspec
import pytest

import carom
from carom.study.sweeps.store import Address, Folder, Store, store_of


@pytest.fixture(params=["folder", "address"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Store:
    """A store of each kind."""
    if request.param == "folder":
        return store_of(tmp_path / "deep" / "out")
    fsspec.filesystem("memory").store.clear()
    return store_of("memory://deep/out")


def test_what_is_written_is_read(store: Store) -> None:
    with store.claimed():
        assert store.read("a") is None
        store.write("a", b"one")
        store.append("b", b"1\n")
        store.append("b", b"2\n")
        store.write("a", b"two")
        assert (store.read("a"), store.read("b")) == (b"two", b"1\n2\n")
        assert [name for name in store.names() if name != "lock"] == ["a", "b"]
        store.remove("a")
        assert store.read("a") is None


def test_a_write_that_fails_leaves_what_was_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = Folder(tmp_path)
    store.write("a", b"old")
    store.append("b", b"old\n")

    def full(_file: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    for write in (store.write, store.append):
        with pytest.raises(OSError, match="No space left"):
            write("a" if write == store.write else "b", b"new")
    assert (store.read("a"), store.read("b")) == (b"old", b"old\n")
    assert store.names() == ["a", "b"]


def test_a_second_sweep_is_refused_and_a_later_one_is_not(tmp_path: Path) -> None:
    told = f"{tmp_path}: another process is at work on the sweep in this folder"
    with Folder(tmp_path).claimed(), pytest.raises(carom.SweepError, match=told), Folder(tmp_path).claimed():
        pytest.fail("it is claimed")
    with Folder(tmp_path).claimed():
        assert Folder(tmp_path).names() == ["lock"]


def test_paths_are_folders_and_addresses_are_fsspec_s() -> None:
    assert isinstance(store_of("results"), Folder)
    assert isinstance(store_of("memory://results"), Address)
    with pytest.raises(carom.InvalidArgument, match="out must be an address that fsspec knows"):
        store_of("nosuchthing://results")
    for wrong in (3, "", None, "a\0b"):
        with pytest.raises(carom.InvalidArgument, match="out must be a folder"):
            store_of(wrong)
