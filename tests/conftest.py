"""Profiles of hypothesis, and tests that need the compiler.

By default hypothesis takes the same examples in every run, and fewer when the compiler is switched off;
`HYPOTHESIS_PROFILE=explore` takes many fresh ones.
"""

import os

import pytest
from hypothesis import HealthCheck, settings

settings.register_profile("repeatable", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("interpreted", settings.get_profile("repeatable"), max_examples=20)
settings.register_profile("explore", deadline=None, max_examples=2000, print_blob=True)

INTERPRETED = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "interpreted" if INTERPRETED else "repeatable"))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Skip tests marked `compiled` where the compiler is switched off."""
    if INTERPRETED:
        for item in items:
            if item.get_closest_marker("compiled"):
                item.add_marker(pytest.mark.skip(reason="the compiler is switched off"))
