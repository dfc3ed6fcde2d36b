"""Times of impact of straight motion agree with the cases made in 50-digit arithmetic."""

from typing import Any

import pytest

from tests.conformance.cases import load
from tests.conformance.impact_cases import first_touch

CASES = load("impacts")
STILL = (0.0, 0.0)
#: No gravity to speak of: it moves nothing by a bit, but has the quartics solved instead of the quadratics.
HINT = (1e-100, -1e-100)


@pytest.mark.parametrize("gravity", [STILL, HINT], ids=["straight", "as if falling"])
@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_impacts(case: dict[str, Any], gravity: tuple[float, float]) -> None:
    time, expected = first_touch(case["shape"], case["ball"], gravity), case["toi"]
    assert (time is None) == (expected is None)
    if time is not None:
        assert time == pytest.approx(expected, rel=1e-12, abs=1e-15)
