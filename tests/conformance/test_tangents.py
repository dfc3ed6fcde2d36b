"""Tangents agree with the cases made in 50-digit arithmetic."""

import pytest

from carom.geometry.circle import common_tangents, tangent_points
from tests.conformance.cases import flat, largest, load

CASES = load("tangents")


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_tangent_points(case: dict) -> None:
    found = tangent_points(*case["center"], case["radius"], *case["point"])
    expected = case["tangent_points"]
    assert (found is None) == (expected is None)
    if expected is not None:
        assert found == pytest.approx(flat(expected), rel=0.0, abs=1e-11 * largest(case))


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_common_tangents(case: dict) -> None:
    other = case["other"]
    found = common_tangents(*case["center"], case["radius"], *other["center"], other["radius"])
    expected = case["common_tangents"]
    assert (found is None) == (expected is None)
    if expected is not None:
        assert found == pytest.approx(flat(expected), rel=0.0, abs=1e-11 * largest(case))
