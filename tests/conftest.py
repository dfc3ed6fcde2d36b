"""Profiles of hypothesis, tests that need the compiler, and the size of campaigns.

By default hypothesis takes the same examples in every run, and fewer when the compiler is switched off;
`HYPOTHESIS_PROFILE=explore` takes many fresh ones. `--campaign` launches a hundred times as many balls at closed rooms.
"""

import os
import signal
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

settings.register_profile(
    "repeatable", deadline=None, derandomize=True, max_examples=50, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("interpreted", settings.get_profile("repeatable"), max_examples=10)
settings.register_profile("explore", deadline=None, max_examples=2000, print_blob=True)

# What a test sees must not depend on when a compiler is done; tests of compiling in the background say so themselves.
os.environ.setdefault("CAROM_COMPILE", "wait")

INTERPRETED = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "interpreted" if INTERPRETED else "repeatable"))


TESTS = Path(__file__).resolve().parent
#: Where no test steps a world or asks it anything. Of two processes, one goes through these while the other, which
#: begins in the middle, waits for the compiler.
WITHOUT_KERNELS = ("conventions", "typing", "unit/geometry", "unit/shapes", "unit/scene", "unit/test_")
#: What in these does: the code of pages, a world that is described, one that has run, bricks that are hit.
WITH_KERNELS = (
    "conventions/test_texts",
    "unit/scene/drawings/test_reading",
    "unit/scene/test_capture",
    "unit/shapes/test_group",
)

# Tests of Ctrl-C, and the programs that they start, need it heeded even where the tests were started in the background.
signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the size of campaigns, and whether pictures are kept anew."""
    parser.addoption("--campaign", action="store_true", help="10,000,000 launches instead of 100,000")
    parser.addoption("--renew-pictures", action="store_true", help="keep the pictures as they look now")


@pytest.fixture(scope="session")
def launch_count(request: pytest.FixtureRequest) -> int:
    """How many balls are launched in closed rooms."""
    return 10_000_000 if request.config.getoption("--campaign") else 100_000


@pytest.fixture(scope="session")
def step_compiled() -> None:
    """For tests against the clock: a step of the continuous mode need not be compiled in them any more."""
    from tests.worlds import continuous_world

    continuous_world().step(1e-3)


def needs_kernels(item: pytest.Item) -> bool:
    """Whether a test may have to wait for a kernel to be compiled; doctests may."""
    if not item.path.is_relative_to(TESTS):
        return True
    path = item.path.relative_to(TESTS).as_posix()
    return not path.startswith(WITHOUT_KERNELS) or path.startswith(WITH_KERNELS)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put those first that need no compiled kernel; skip tests marked `compiled` where the compiler is switched off."""
    items.sort(key=needs_kernels)
    if INTERPRETED:
        for item in items:
            if item.get_closest_marker("compiled"):
                item.add_marker(pytest.mark.skip(reason="the compiler is switched off"))
