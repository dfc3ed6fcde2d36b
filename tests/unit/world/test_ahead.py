"""What is compiled ahead is what worlds call: every kernel, for arguments of the very types."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import carom
from carom.compiler import door
from carom.compiler.block import Block
from carom.compiler.kernels import Kernel
from carom.world import ahead
from tests.worlds import crowded

Called = list[tuple[Kernel, tuple[Any, ...]]]


@pytest.fixture
def called(monkeypatch: pytest.MonkeyPatch) -> Called:
    """The calls of kernels that worlds make, which are interpreted."""
    calls: Called = []

    def noting(interpreted: Callable[[Kernel], Kernel]) -> Callable[[Kernel, Any], Kernel]:
        def load(kernel: Kernel, size: Any) -> Kernel:
            def noted(*arguments: Any) -> Any:
                calls.append((kernel, arguments))
                return interpreted(kernel)(*arguments)

            return noted

        return load

    monkeypatch.setattr(door, "load", noting(door.Entry.interpreted))
    monkeypatch.setattr(door, "enter", noting(door.BlockEntry.interpreted))
    return calls


def type_of(argument: Any) -> Any:
    """What the compiler sees of an argument."""
    if isinstance(argument, tuple):
        return tuple(map(type_of, argument))
    if isinstance(argument, Block):
        return Block, type_of(argument.arguments)
    if isinstance(argument, np.ndarray):
        return argument.dtype, argument.ndim, argument.flags.c_contiguous, argument.flags.writeable
    return type(argument)


def every_call(world: carom.World) -> None:
    """Step a world, and ask it everything, once and many times at once."""
    many = np.linspace(0.0, 10.0, 400).reshape(200, 2)
    world.step(1 / 60)
    world.run(0.1)
    for places in ((1.0, 1.0), many):
        world.ray_cast(places, (9.0, 9.0))
        world.circle_cast(places, 0.1, (9.0, 9.0))
        world.nearest(places)
    world.overlapping(carom.Aabb(0, 0, 5, 5))
    world.contacts()
    world.aim(world.balls[0], (1, 0))
    world.aim(list(world.balls), (1, 0))
    if world.detection == "continuous":
        world.aim(world.balls[0])


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_every_kernel_that_a_world_calls_is_compiled_for_the_types_of_that_call(
    detection: carom.typing.Detection, called: Called
) -> None:
    world = crowded(balls=4)
    world.detection = detection
    every_call(world)
    examples = ahead.examples()
    steps = {"step_discrete", "step_continuous", "step_copies"}
    names = {kernel.__name__ for kernel, _ in called}
    assert names == {kernel.__name__ for kernel in examples} - steps | {f"step_{detection}"}
    for kernel, arguments in called:
        assert type_of(arguments) == type_of(examples[kernel]), kernel.__name__


def test_names_tell_kernels_apart() -> None:
    names = [kernel.__name__ for kernel in ahead.examples()]
    assert len(set(names)) == len(names)


def test_what_is_compiled_is_told_by_name(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def keep(function: Kernel, arguments: tuple[Any, ...]) -> float | None:
        asked.append(function.__name__)
        return 1.5 if function.__name__ == "aim_many" else None

    monkeypatch.setattr(door, "keep", keep)
    done = carom.compile()
    assert done.seconds == {"aim_many": 1.5}
    assert {*done.kept, "aim_many"} == set(asked) == {kernel.__name__ for kernel in ahead.examples()}
    asked.clear()
    assert ahead.compile_kernels(["nearest_many"]).kept == ("nearest_many",)
    assert asked == ["nearest_many"]


def test_a_child_that_cannot_compile_says_so_by_its_status(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("os.nice", lambda niceness: niceness, raising=False)
    monkeypatch.setenv("CAROM_COMPILE", "off")
    with pytest.raises(SystemExit, match="nothing is compiled: CAROM_COMPILE is 'off'"):
        ahead.main(["step_discrete"])
    assert ahead.main([]) == 0
