"""One small kernel, compiled in a process of its own."""

from pathlib import Path

from tests import fresh

#: Compiles one small kernel and calls it.
ONE_KERNEL = """
from carom.compiler import door
from carom.world.kernels.broad_phase.grid import cell_of
print(door.load(cell_of)(7.5, 0.5))
"""

#: Steps a crowded world.
STEPS = """
from tests.worlds import crowded
world = crowded(balls=4)
world.run(0.25)
print(world.digest())
"""


def kept(folder: Path) -> list[str]:
    """The files of compiled code below a folder."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.nb[ic]"))


def one_kernel(folder: Path, code: str = ONE_KERNEL, **environment: str | None) -> tuple[str, str]:
    """What a fresh process that compiles a kernel, with its cache in a folder, prints on stdout and on stderr."""
    done = fresh.run(code, CAROM_CACHE_DIR=str(folder), **environment)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode(), done.stderr.decode()
