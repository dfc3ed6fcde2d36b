"""Kernels that came compiled: found beside the package alone, used where they fit, and told of where they do not."""

import json
from pathlib import Path

import numpy as np
import pytest

from carom.compiler import door, prebuilt
from carom.compiler.block import Block
from carom.compiler.cache import source_hash
from carom.compiler.kernels import Kernel
from carom.world import ahead
from carom.world.kernels.queries.search_grid import width_of_all
from tests.unit.compiler.test_block import seen, words_at


def written(folder: Path, sources: str, results: dict[str, str]) -> Path:
    """A folder with an index, and a library that is none."""
    index = {"sources": sources, "processor": "generic", "library": "kernels.so", "results": results}
    (folder / prebuilt.INDEX).write_text(json.dumps(index))
    (folder / "kernels.so").write_bytes(b"no library")
    return folder


def test_the_folder_is_in_the_package_and_a_checkout_has_none(capsys: pytest.CaptureFixture[str]) -> None:
    assert prebuilt.FOLDER.parent == Path(prebuilt.__file__).parent
    assert prebuilt.found(width_of_all) is None
    assert capsys.readouterr().err == ""


def test_what_was_made_from_other_sources_is_not_used_and_the_user_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(prebuilt, "FOLDER", written(tmp_path, "0" * 24, {}))
    assert [prebuilt.found(width_of_all) for _ in range(2)] == [None, None]
    told = "carom: the compiled code that came with it is not used: it was made from other sources\n"
    assert capsys.readouterr().err == told


def test_a_damaged_library_is_not_used_and_the_user_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(prebuilt, "FOLDER", written(tmp_path, source_hash(), {"name": "int64"}))
    assert prebuilt.found(width_of_all) is None
    assert "the compiled code that came with it is not used: " in capsys.readouterr().err


def test_no_two_kernels_have_one_name_in_the_library() -> None:
    assert len({prebuilt.symbol_of(function) for function in ahead.examples()}) == len(ahead.examples())


def told_apart(address: int) -> int:
    """The product of the lengths of two arrays of the block at an address, or `FAILED` if there are none."""
    (_, (first,)), (_, (second,)) = map(seen, words_at(address, 2))
    return first * second or prebuilt.FAILED


def test_a_kernel_that_takes_a_block_is_called_with_arrays_and_what_it_cannot_do_is_an_error() -> None:
    kernel = prebuilt.with_arguments(told_apart)
    assert kernel(np.zeros(3), np.zeros(5, "i4")) == 15
    with pytest.raises(RuntimeError, match="no answer"):
        kernel(np.zeros(0), np.zeros(5))


@pytest.fixture
def found(monkeypatch: pytest.MonkeyPatch) -> list[Kernel]:
    """The kernels that were looked for among those that came compiled, all of which did; and nothing is loaded yet."""
    looked_for: list[Kernel] = []
    monkeypatch.setattr(prebuilt, "found", lambda function: looked_for.append(function) or told_apart)
    monkeypatch.setattr(door, "_loaded", {})
    monkeypatch.setattr(door, "_numba", lambda: pytest.fail("the compiler is asked for"))
    monkeypatch.setenv("NUMBA_DISABLE_JIT", "0")
    return looked_for


@pytest.mark.parametrize("way", ["background", "wait"])
def test_the_door_takes_what_came_compiled_before_it_asks_the_compiler(
    way: str, found: list[Kernel], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAROM_COMPILE", way)
    block = Block((np.zeros(3), np.zeros(5)))
    kernel = door.enter(width_of_all)
    assert isinstance(kernel, door.At)
    assert kernel(block) == kernel.at(block.address) == 15
    monkeypatch.setattr(door, "_loaded", {})
    assert door.load(width_of_all)(*block.arguments) == 15
    assert found == [width_of_all, width_of_all]


def test_where_all_came_compiled_nothing_is_left_to_compile(
    found: list[Kernel], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAROM_COMPILE", "wait")
    done = ahead.compile()
    assert done.prebuilt == tuple(function.__name__ for function in ahead.examples())
    assert (done.seconds, done.kept) == ({}, ())


@pytest.mark.parametrize("variable", [("CAROM_COMPILE", "off"), ("NUMBA_DISABLE_JIT", "1")])
def test_where_everything_is_to_be_interpreted_it_is(
    variable: tuple[str, str], found: list[Kernel], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(door, "_numba", lambda: None)
    monkeypatch.setenv(*variable)
    tables = tuple(np.zeros(0, table.dtype) for table in ahead.examples()[width_of_all])
    assert door.enter(width_of_all)(Block(tables)) == width_of_all(*tables)
    monkeypatch.setattr(door, "_loaded", {})
    assert door.load(width_of_all)(*tables) == width_of_all(*tables)
    assert found == []
