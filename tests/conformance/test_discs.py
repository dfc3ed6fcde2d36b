"""Discs of unequal mass in a box meet each other and the walls in the same order as in 50-digit arithmetic."""

from typing import Any

import numpy as np
import pytest

import carom
from carom.world.hits import Hit
from tests.conformance.cases import load

CASES = load("discs")

#: Length and seconds, as for billiards.
TOLERANCE = 1e-6


def closed_box(case: dict[str, Any]) -> tuple[carom.World, list[carom.Ball]]:
    """A world of a case's box and discs."""
    world = carom.World(detection="continuous")
    width, height = case["box"]
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    for k in range(4):
        world.add(carom.Segment(corners[k - 1], corners[k]))
    return world, [world.add(carom.Ball(**ball)) for ball in case["balls"]]


def who(hit: Hit, balls: list[carom.Ball]) -> list[int]:
    """A hit as the cases name it: a ball and the axis of a wall's normal, or two balls in order."""
    if isinstance(hit.shape, carom.Ball):
        return sorted((balls.index(hit.shape), balls.index(hit.ball)))
    return [balls.index(hit.ball), int(abs(hit.normal[1]) > 0.5)]


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_discs(case: dict[str, Any]) -> None:
    world, balls = closed_box(case)
    impacts = case["impacts"]
    for k, expected in enumerate(impacts):
        # A step that ends halfway to the next impact holds this one alone.
        follows = impacts[k + 1]["time"] if k + 1 < len(impacts) else expected["time"]
        hits = world.step(0.5 * (expected["time"] + follows) + TOLERANCE - world.time)
        assert [who(hit, balls) for hit in hits] == [
            sorted(expected["who"]) if expected["kind"] == "pair" else expected["who"]
        ]
        assert hits[0].time == pytest.approx(expected["time"], abs=TOLERANCE)
        velocity = world.balls.velocity
        position = world.balls.position - velocity * (world.time - hits[0].time)
        assert velocity == pytest.approx(np.array(expected["velocities"]), abs=TOLERANCE)
        assert position == pytest.approx(np.array(expected["positions"]), abs=TOLERANCE)
