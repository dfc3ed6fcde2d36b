"""Times of impact under gravity agree with the cases made in 50-digit arithmetic."""

from typing import Any

import pytest

from tests.conformance.cases import load
from tests.conformance.impact_cases import first_touch

CASES = load("falls")


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_falls(case: dict[str, Any]) -> None:
    time, expected = first_touch(case["shape"], case["ball"], tuple(case["gravity"])), case["toi"]
    assert (time is None) == (expected is None)
    if time is not None:
        assert time == pytest.approx(expected, rel=1e-12, abs=1e-15)
