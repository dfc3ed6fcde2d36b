"""The door to the compiler: opened when it is needed, and not needed at all."""

import os
import sys
import threading
import time
from pathlib import Path

import pytest

import carom
from carom.compiler import cache, child, door
from carom.world.kernels.broad_phase.grid import cell_of
from tests import fresh
from tests.forks import forked
from tests.unit.compiler.one_kernel import ONE_KERNEL, STEPS, one_kernel
from tests.worlds import crowded

WITHOUT_NUMBA = 'import sys; sys.modules["numba"] = None\n'


@pytest.mark.slow
def test_building_shapes_and_worlds_imports_no_compiler() -> None:
    code = """
import sys, carom
wall, ball = carom.Segment((0, 0), (1, 0)), carom.Ball((0.5, 0.4), 0.5)
ball.respond(wall.detect(ball))
world = carom.World(); world.add(wall); world.add(ball); world.snapshot(); world.restore(world.snapshot())
print(sorted(name for name in sys.modules if name.partition(".")[0] in ("numba", "llvmlite")))
"""
    assert fresh.printed(code) == "[]\n"


@pytest.mark.slow
def test_interpreted_and_without_numba_the_bits_are_the_same() -> None:
    world = crowded(balls=4)
    world.run(0.25)
    assert fresh.printed(STEPS, NUMBA_DISABLE_JIT="1").strip() == world.digest()
    assert fresh.printed(WITHOUT_NUMBA + STEPS).strip() == world.digest()


@pytest.mark.slow
def test_interpreted_nothing_is_said_or_kept(tmp_path: Path) -> None:
    assert one_kernel(tmp_path, NUMBA_DISABLE_JIT="1") == ("3\n", "")
    assert one_kernel(tmp_path, WITHOUT_NUMBA + ONE_KERNEL) == ("3\n", "")
    assert list(tmp_path.iterdir()) == []


def test_every_kernel_is_loaded_once() -> None:
    first = door.load(cell_of)
    first(1.0, 1.0)
    assert door.load(cell_of) is door.load(cell_of)
    assert door.load(cell_of)(7.5, 0.5) == 3
    assert carom.World().step(0.0).dtype.names


def reopened(monkeypatch: pytest.MonkeyPatch, way: str) -> None:
    """Forget what was loaded, and let `CAROM_COMPILE` say something."""
    monkeypatch.setattr(door, "_loaded", {})
    monkeypatch.setenv("CAROM_COMPILE", way)


def test_a_word_that_the_variable_does_not_know_is_refused_and_nothing_is_changed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    world = crowded(balls=4)
    before = world.digest()
    reopened(monkeypatch, "soon")
    for call in (lambda: world.step(0.1), lambda: world.nearest((0, 0)), lambda: carom.compile()):
        with pytest.raises(carom.InvalidArgument, match=r"^CAROM_COMPILE must be one of .*, not 'soon'$"):
            call()
    assert world.digest() == before


def test_switched_off_the_compiler_is_not_even_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    reopened(monkeypatch, "off")
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.setattr(door, "_numba", lambda: pytest.fail("the compiler is asked for"))
    assert door.load(cell_of)(7.5, 0.5) == 3
    with pytest.raises(carom.CompileError, match="nothing is compiled: CAROM_COMPILE is 'off'"):
        carom.compile()


def test_without_a_compiler_it_is_said_where_one_was_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    reopened(monkeypatch, "background")
    monkeypatch.setitem(sys.modules, "numba", None)
    assert door.load(cell_of)(7.5, 0.5) == 3
    assert not carom.compiling()
    with pytest.raises(carom.CompileError, match="Numba is not installed"):
        carom.compile()


@pytest.mark.compiled
def test_what_is_interpreted_at_first_does_not_wait_for_the_compiler_to_be_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reopened(monkeypatch, "background")
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(child, "ask", lambda function: True)
    monkeypatch.delitem(sys.modules, "numba", raising=False)
    imported: list[str] = []
    monkeypatch.setattr(door, "_numba", lambda: imported.append("numba"))
    kernel = door.load(cell_of)
    assert kernel(7.5, 0.5) == 3
    assert not imported
    # Once there is code to be read it is; where it turns out not to be of use, the kernel stays interpreted.
    (tmp_path / "made").mkdir()
    monkeypatch.setattr(cache, "cache_folder", lambda: tmp_path)
    (tmp_path / "made" / f"entered.{cell_of.__name__}-1.py311.nbi").touch()
    assert kernel(7.5, 0.5) == 3
    assert imported == ["numba"]


@pytest.mark.compiled
def test_where_nothing_can_be_kept_it_is_compiled_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reopened(monkeypatch, "background")
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "file"))
    made: list[tuple[object, ...]] = []
    monkeypatch.setattr(door.Entry, "made", lambda entry, arguments: made.append(arguments) or (lambda *_: 3, 0.0))
    assert door.load(cell_of)(7.5, 0.5) == 3
    assert made == [(7.5, 0.5)]
    with pytest.raises(carom.CompileError, match="cannot be written to"):
        carom.compile()


@pytest.mark.compiled
def test_what_is_kept_ahead_is_compiled_once_and_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    reopened(monkeypatch, "wait")
    door.keep(cell_of, (1.0, 1.0))
    assert door.keep(cell_of, (1.0, 1.0)) is None
    assert hasattr(door.load(cell_of), "signatures")
    assert door.load(cell_of)(7.5, 0.5) == 3


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no process is forked here")
@pytest.mark.parametrize("lock", ["_compiling", "_importing"])
def test_no_process_is_forked_while_a_thread_compiles(lock: str) -> None:
    held = threading.Event()

    def compiles() -> None:
        with getattr(door, lock):
            held.set()
            time.sleep(0.2)

    def goes_on() -> None:
        assert getattr(door, lock).acquire(blocking=False)

    thread = threading.Thread(target=compiles)
    thread.start()
    assert held.wait(5.0)
    try:
        assert forked(goes_on) == 0
    finally:
        thread.join()
