"""Profiles of hypothesis: the same examples in every run by default, fresh ones on request, fewer when interpreted."""

import os

from hypothesis import HealthCheck, settings

settings.register_profile("repeatable", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("interpreted", settings.get_profile("repeatable"), max_examples=20)
settings.register_profile("explore", deadline=None, max_examples=2000, print_blob=True)

INTERPRETED = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "interpreted" if INTERPRETED else "repeatable"))
