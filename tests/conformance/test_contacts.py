"""Contacts of balls with shapes, and the responses, agree with the cases made in 50-digit arithmetic."""

from typing import Any

import pytest

import carom
from tests.conformance.cases import flat, largest, load

CASES = load("contacts")
CLASSES = {"point": carom.Point, "segment": carom.Segment, "circle": carom.Circle, "arc": carom.Arc}
each_case = pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))


def made(case: dict[str, Any]) -> tuple[carom.Shape, carom.Ball]:
    """The shape and the ball of a case."""
    options = dict(case["shape"])
    return CLASSES[options.pop("kind")](**options), carom.Ball(**case["ball"])


@each_case
def test_contacts_and_responses(case: dict[str, Any]) -> None:
    shape, ball = made(case)
    tolerance = 1e-12 * largest(case)
    contact, hit = shape.detect(ball), case["hit"]
    assert (contact is None) == (hit is None)
    if contact is None:
        return
    found = (*contact.point, *contact.normal, contact.setback, contact.speed)
    expected = flat([hit["point"], hit["normal"], hit["setback"], hit["speed"]])
    assert found == pytest.approx(expected, rel=0.0, abs=tolerance)
    ball.respond(contact)
    after = flat([case["after"]["position"], case["after"]["velocity"]])
    assert (*ball.position, *ball.velocity) == pytest.approx(after, rel=0.0, abs=tolerance)


def test_the_cases_are_of_all_kinds() -> None:
    seen = {(case["shape"]["kind"], case["shape"].get("motion", "static")) for case in CASES if case["hit"]}
    assert seen == {(kind, motion) for kind in CLASSES for motion in ("static", "kinematic")}
