"""A kernel that is interpreted until it is compiled: the change-over, when to wait for it, and when there is none."""

import threading
from collections.abc import Callable
from typing import Any

import pytest

import carom
from carom.compiler import behind, child, door
from carom.compiler.behind import Behind, NotKept
from carom.compiler.door import At
from carom.world.world import STEP_KERNELS
from tests import fresh
from tests.worlds import bits, crowded

#: Compiles a kernel behind, with an empty cache, and calls it until it is compiled and once more.
BEHIND = """
import time
from carom.compiler import door
from carom.compiler.child import compiling
from carom.world.ahead import examples
from carom.world.kernels.queries.search_grid import width_of_all
arguments = examples()[width_of_all]
results = {door.load(width_of_all)(*arguments)}
interpreted = door.load(width_of_all)
while compiling():
    results.add(door.load(width_of_all)(*arguments))
    time.sleep(0.01)
results.add(door.load(width_of_all)(*arguments))
print(results, door.load(width_of_all) is interpreted, hasattr(door.load(width_of_all), "signatures"))
"""


class Bench:
    """A kernel that doubles, as its parts are: interpreted, on disk, compiled, asked for.

    Attributes:
        on_disk: Whether the kernel is in the cache.
        busy: Whether the child is at work on it.
        said: What was done, in order.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.on_disk = self.busy = False
        self.will = True
        self.said: list[str] = []
        self.takes = 0.0
        self.now = 0.0
        monkeypatch.setattr(child, "look", lambda: None)
        monkeypatch.setattr(child, "busy_with", lambda function: self.busy)
        monkeypatch.setattr(child, "ask", self._ask)
        monkeypatch.setattr(behind.time, "perf_counter", lambda: self.now)
        self.kernel = Behind(abs, self._interpreted, lambda units: (1, units), self, threading.RLock())

    def _ask(self, function: Any) -> bool:
        self.said.append("asked")
        self.busy = self.will
        return self.will

    def _interpreted(self, units: float) -> float:
        self.now += self.takes
        self.said.append("interpreted")
        return 2 * units

    def _compiled(self, units: float) -> float:
        self.said.append("compiled")
        return 2 * units

    def kept(self, arguments: tuple[Any, ...]) -> Callable[..., float]:
        if not self.on_disk:
            raise NotKept
        return self._compiled

    def made(self, arguments: tuple[Any, ...]) -> tuple[Callable[..., float], float]:
        self.said.append("made")
        return self._compiled, 1.0


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch) -> Bench:
    """A kernel that has not been called yet."""
    return Bench(monkeypatch)


def test_what_is_on_disk_is_never_interpreted(bench: Bench) -> None:
    bench.on_disk = True
    assert bench.kernel(3) == 6
    assert bench.said == ["compiled"]


def test_it_is_interpreted_until_the_child_is_done(bench: Bench) -> None:
    assert [bench.kernel(k) for k in range(3)] == [0, 2, 4]
    bench.busy, bench.on_disk = False, True
    assert bench.kernel(3) == 6
    assert bench.said == ["asked", "interpreted", "interpreted", "interpreted", "compiled"]


def test_a_child_that_brought_nothing_leaves_it_interpreted(bench: Bench) -> None:
    bench.kernel(1)
    bench.busy = bench.will = False
    for _ in range(3):
        bench.kernel(1)
    assert bench.said == ["asked", "interpreted", "asked", "interpreted", "interpreted", "interpreted"]


def test_a_crowd_waits_whether_the_child_is_at_it_or_not(bench: Bench) -> None:
    bench.kernel(1)
    most = behind.LONGEST / behind.UNIT
    assert bench.kernel(2 * most) == 4 * most
    assert bench.said == ["asked", "interpreted", "made", "compiled"]


def test_steps_that_turn_out_slow_are_waited_for_and_one_that_was_held_up_is_not(bench: Bench) -> None:
    bench.takes = 0.01
    for _ in range(100):
        bench.kernel(100)
    bench.takes = 1.0
    bench.kernel(100)
    bench.takes = 0.01
    bench.kernel(100)
    assert "made" not in bench.said
    bench.takes = 1.0
    while "made" not in bench.said:
        bench.kernel(100)
    assert bench.said.count("interpreted") < 120


@pytest.fixture
def changing(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Both kinds of steps as they are where nothing is compiled yet; `compiled` in the list says that they are."""
    if door.way() == door.OFF or door._numba() is None:
        pytest.skip("the compiler is switched off")
    said: list[str] = []
    kept = door.Entry.kept

    def refuse_at_first(entry: door.Entry, arguments: tuple[Any, ...]) -> Any:
        if "compiled" not in said:
            raise NotKept
        return kept(entry, arguments)

    for detection in ("discrete", "continuous"):
        crowded(balls=4, detection=detection).step(0.1)  # so that both are on disk
    monkeypatch.setenv("CAROM_COMPILE", "background")
    monkeypatch.setattr(door, "_loaded", {})
    monkeypatch.setattr(door.Entry, "kept", refuse_at_first)
    monkeypatch.setattr(child, "ask", lambda function: True)
    monkeypatch.setattr(child, "busy_with", lambda function: "compiled" not in said)
    return said


@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_the_bits_are_those_of_a_world_that_was_never_interpreted(
    detection: carom.typing.Detection, changing: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    world = crowded(balls=4, detection=detection)
    parts = [bits(world.step(1 / 60)) for _ in range(4)]
    assert isinstance(door.enter(STEP_KERNELS[world._states[0]["detection"]]), Behind)
    changing.append("compiled")
    parts += [bits(world.step(1 / 60)) for _ in range(4)]
    assert isinstance(door.enter(STEP_KERNELS[world._states[0]["detection"]]), At)
    for way in ("wait", "off"):
        monkeypatch.setenv("CAROM_COMPILE", way)
        monkeypatch.setattr(door, "_loaded", {})
        pure = crowded(balls=4, detection=detection)
        assert [bits(pure.step(1 / 60)) for _ in range(8)] == parts
        assert pure.digest() == world.digest()


@pytest.mark.compiled
def test_a_run_changes_over_on_its_way(changing: list[str]) -> None:
    world = crowded(balls=4)

    def progress(done: float, total: float) -> None:
        changing.append("compiled")

    world.run(0.5, progress=progress)
    assert isinstance(door.enter(STEP_KERNELS[0]), At)
    pure = crowded(balls=4)
    pure.run(0.5)
    assert pure.digest() == world.digest()


@pytest.mark.slow
@pytest.mark.compiled
def test_from_an_empty_cache_a_child_compiles_and_the_process_changes_over(tmp_path: Any) -> None:
    done = fresh.run(BEHIND, CAROM_CACHE_DIR=str(tmp_path), CAROM_COMPILE="background")
    assert done.stdout.decode() == "{0.0} False True\n", done.stderr.decode()
    first, last = done.stderr.decode().splitlines()
    assert first.startswith("carom: compiling width of all, once on this machine; ")
    assert last.startswith("carom: compiled width of all in ")
    again = fresh.run(BEHIND, CAROM_CACHE_DIR=str(tmp_path), CAROM_COMPILE="background")
    assert (again.stdout.decode(), again.stderr) == ("{0.0} True True\n", b"")
