"""Contacts of two balls, and the responses, agree with the cases made in 50-digit arithmetic."""

from typing import Any

import pytest

import carom
from tests.conformance.cases import flat, largest, load

CASES = load("pairs")


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_pairs(case: dict[str, Any]) -> None:
    first, second = carom.Ball(**case["first"]), carom.Ball(**case["second"])
    tolerance = 1e-12 * largest(case)
    contact, after = first.detect(second), case["after"]
    assert (contact is None) == (after is None)
    if contact is None:
        return
    expected = flat([after["normal"], after["setback"]])
    assert (*contact.normal, contact.setback) == pytest.approx(expected, rel=0.0, abs=tolerance)
    second.respond(contact)
    for ball, name in ((first, "first"), (second, "second")):
        expected = flat([after[f"{name}_position"], after[f"{name}_velocity"]])
        assert (*ball.position, *ball.velocity) == pytest.approx(expected, rel=0.0, abs=tolerance)
