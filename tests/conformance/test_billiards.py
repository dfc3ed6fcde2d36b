"""A ball in a stadium or a Sinai table meets the same walls at the same times as in 50-digit arithmetic."""

from typing import Any

import pytest

import carom
from tests.conformance.cases import load

CASES = load("billiards")
MAKERS = {"segment": carom.Segment, "circle": carom.Circle, "arc": carom.Arc}

#: Length and seconds. An error of 1e-16 grows at every impact, and a table's longest chain of them makes 1e-9 of it.
TOLERANCE = 1e-6


@pytest.mark.parametrize("substeps", [1, 7])
@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_billiards(case: dict[str, Any], substeps: int) -> None:
    world = carom.World(detection="continuous", substeps=substeps)
    walls = []
    for description in case["shapes"]:
        arguments = dict(description)
        walls.append(world.add(MAKERS[arguments.pop("kind")](**arguments)))
    ball = world.add(carom.Ball(**case["ball"]))
    impacts = case["impacts"]
    for k, expected in enumerate(impacts):
        # A step that ends halfway to the next impact holds this one alone.
        follows = impacts[k + 1]["time"] if k + 1 < len(impacts) else expected["time"]
        (hit,) = world.step(0.5 * (expected["time"] + follows) + TOLERANCE - world.time)
        assert hit.shape is walls[expected["shape"]]
        assert hit.time == pytest.approx(expected["time"], abs=TOLERANCE)
        late = world.time - hit.time
        x, y = (p - v * late for p, v in zip(ball.position, ball.velocity, strict=True))
        assert (x, y) == pytest.approx(tuple(expected["position"]), abs=TOLERANCE)
        assert ball.velocity == pytest.approx(tuple(expected["velocity"]), abs=TOLERANCE)
