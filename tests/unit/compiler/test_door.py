"""The door to the compiler: opened when it is needed, and not needed at all."""

from pathlib import Path

import pytest

import carom
from carom.compiler import door
from carom.world.kernels.broad_phase.grid import cell_of
from tests import fresh
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
