"""`step` and `run`: the same thing, whole or not at all."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from random import Random
from types import FrameType
from typing import Any

import pytest

import carom
from carom.compiler import door, kernels
from tests.worlds import bits, crowded, quiet

INF = float("inf")


class Interrupt(KeyboardInterrupt):
    """Ctrl-C."""


@pytest.fixture
def interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kernels are interpreted, so that they can be interrupted."""
    monkeypatch.setattr(door, "enter", lambda kernel, size: door.BlockEntry.interpreted(kernel))


@contextmanager
def interrupted_at(place: int) -> Iterator[list[int]]:
    """The calls of kernels so far, while an `Interrupt` is raised at call number `place`."""
    calls = [0]

    def watch(frame: FrameType, event: str, argument: Any) -> None:
        if event == "call" and frame.f_globals.get("__name__") in kernels.kernel_modules():
            calls[0] += 1
            if calls[0] == place:
                sys.setprofile(None)
                raise Interrupt

    sys.setprofile(watch)
    try:
        yield calls
    finally:
        sys.setprofile(None)


def twin_of(world: carom.World) -> carom.World:
    """Another world in the same state."""
    twin = carom.World()
    twin.restore(world.snapshot())
    return twin


def joined(hits: list[Any]) -> bytes:
    """The bytes of the hits of several steps."""
    return b"".join(map(bits, hits))


@pytest.mark.compiled
@pytest.mark.parametrize("settings", [{}, {"bounds": (1, 1, 11, 11), "remove_strays": True}], ids=["stay", "stray"])
@pytest.mark.parametrize("broad_phase", ["grid", "quadtree", "brute"])
def test_a_run_is_so_many_steps(broad_phase: str, settings: dict[str, Any]) -> None:
    stepped = crowded(broad_phase=broad_phase, **settings)
    run = twin_of(stepped)
    hits = [stepped.step(1 / 60) for _ in range(120)]
    assert bits(run.run(2.0)) == joined(hits)
    assert run.snapshot() == stepped.snapshot()
    assert run.digest() == stepped.digest()


def test_a_run_makes_the_rounded_number_of_steps() -> None:
    for seconds, steps in ((1.0, 10), (0.96, 10), (1.04, 10), (0.04, 0), (0.0, 0), (0.3, 3)):
        world = carom.World()
        calls: list[float] = []
        world.run(seconds, dt=0.1, progress=lambda done, total, calls=calls: calls.append(total))
        assert world.time == pytest.approx(steps * 0.1)
        assert bool(calls) == (steps > 0)


def test_progress_is_told_how_far_the_run_is() -> None:
    told: list[tuple[float, float]] = []
    crowded().run(1.0, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (1.0, 1.0)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert {total for _, total in told} == {1.0}


def test_a_step_of_no_length_moves_nothing() -> None:
    world = quiet()
    before = world.balls.position.tolist()
    world.step(0.0)
    assert world.balls.position.tolist() == before
    assert world.time == 0.0


def test_what_progress_changes_acts_at_once() -> None:
    world = carom.World()
    ball = world.add(carom.Ball((0, 0), 1))

    def push(done: float, total: float) -> None:
        ball.velocity = (1, 0)

    world.run(1.0, dt=0.25, progress=push)
    assert ball.position[0] > 0.0


@pytest.mark.compiled
@pytest.mark.parametrize("call", [1, 3])
def test_an_exception_in_progress_leaves_whole_steps_and_loses_no_hit(call: int) -> None:
    world = crowded()
    straight = twin_of(world)
    calls: list[float] = []

    def progress(done: float, total: float) -> None:
        calls.append(done)
        if len(calls) == call:
            raise Interrupt

    with pytest.raises(Interrupt):
        world.run(2.0, progress=progress)
    assert world.time == pytest.approx(calls[-1])
    rest = world.run(2.0 - calls[-1])
    assert bits(rest) == bits(straight.run(2.0))
    assert world.digest() == straight.digest()


@pytest.mark.slow
def test_an_interrupt_anywhere_leaves_whole_steps_and_loses_no_hit(interpreted: None) -> None:
    start = crowded()
    start.run(0.5)
    start.bounds, start.remove_strays = (1, 1, 11, 11), True
    straight = twin_of(start)
    with interrupted_at(-1) as calls:
        hits = straight.run(0.1)
    assert len(hits) > 0
    for place in sorted(Random(0).sample(range(1, calls[0] + 1), 60)):
        world = twin_of(start)
        with pytest.raises(Interrupt), interrupted_at(place):
            world.run(0.1)
        steps = round((world.time - start.time) * 60)
        assert world.time == pytest.approx(start.time + steps / 60)
        assert bits(world.run(0.1 - steps / 60)) == bits(hits), place
        assert world.digest() == straight.digest(), place


def test_a_step_that_is_interrupted_has_not_begun(interpreted: None) -> None:
    world = crowded()
    world.run(0.5)
    before = world.digest()
    twin = twin_of(world)
    with interrupted_at(-1) as calls:
        twin.step(1 / 60)
    for place in (1, calls[0] // 3, calls[0] // 2, calls[0] * 9 // 10):
        twin = twin_of(world)
        with pytest.raises(Interrupt), interrupted_at(place):
            twin.step(1 / 60)
        assert twin.digest() == before
    # This one has its indices already, and makes fewer calls.
    for place in (1, 100, 500):
        with pytest.raises(Interrupt), interrupted_at(place):
            world.step(1 / 60)
        assert world.digest() == before


@pytest.mark.slow
def test_a_world_goes_on_after_an_interrupt_while_its_room_grows(
    interpreted: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    world = crowded(balls=30)
    straight = twin_of(world)
    serve = carom.World._serve

    def interrupted(world: carom.World, status: int) -> None:
        serve(world, status)
        raise Interrupt

    monkeypatch.setattr(carom.World, "_serve", interrupted)
    with pytest.raises(Interrupt):
        world.run(0.5)
    monkeypatch.setattr(carom.World, "_serve", serve)
    world.run(0.5 - world.time)
    straight.run(0.5)
    assert world.digest() == straight.digest()


@pytest.mark.parametrize("how", ["overflow", "view"])
def test_a_run_that_fails_has_made_the_steps_before_and_tells_their_hits(how: str) -> None:
    world = quiet()
    runaway = world.add(carom.Ball((50, 50), 1, (1e308, 0) if how == "overflow" else (0, 0)))
    straight = quiet()
    straight.add(carom.Ball((50, 50), 1))
    progress: Callable[[float, float], None] | None = None
    if how == "view":

        def progress(done: float, total: float) -> None:
            if done > 1.0:
                world.balls.position[2] = INF

    with pytest.raises(carom.NonFiniteState) as caught:
        world.run(10.0, progress=progress)
    assert 0.5 < world.time < 10.0
    hits = straight.run(world.time)
    assert bits(caught.value.hits) == bits(hits)
    assert [hit.ball.name for hit in caught.value.hits] == [hit.ball.name for hit in hits]
    assert len(hits) > 0
    assert runaway.world is world


def test_dt_may_change_from_step_to_step() -> None:
    world = carom.World(gravity=(0, -1))
    ball = world.add(carom.Ball((0, 0), 1))
    for dt in (0.5, 0.25, 0.0, 1.0):
        world.step(dt)
    assert world.time == 1.75
    assert ball.velocity == (0.0, -1.75)
