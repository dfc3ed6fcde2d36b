"""Arcs and circles as users hold them agree with the cases made in 50-digit arithmetic."""

from typing import Any

import pytest

import carom
from tests.conformance.cases import flat, largest, load

ARCS = load("arcs")
TANGENTS = load("tangents")


@pytest.mark.parametrize("case", ARCS, ids=range(len(ARCS)))
def test_arcs(case: dict[str, Any]) -> None:
    options = {name: value for name, value in case["arc"].items() if name != "kind"}
    arc = carom.Arc(**options, motion="kinematic")
    found = (*arc.p0, *arc.p1, *arc.t0, *arc.t1, *arc.aabb)
    expected = flat([case["p0"], case["p1"], case["t0"], case["t1"], case["aabb"]])
    assert found == pytest.approx(expected, rel=0.0, abs=1e-12 * largest(case))
    assert [arc.in_sector(p) for p, _ in case["in_sector"]] == [inside for _, inside in case["in_sector"]]
    turned = case["turned"]
    arc.rotate(turned["pivot"], turned["angle"])
    expected = flat([turned["center"], turned["start_angle"], turned["end_angle"]])
    tolerance = 1e-10 * largest(case)
    assert (*arc.center, arc.start_angle, arc.end_angle) == pytest.approx(expected, rel=0.0, abs=tolerance)


@pytest.mark.parametrize("case", TANGENTS, ids=range(len(TANGENTS)))
def test_tangents(case: dict[str, Any]) -> None:
    tolerance = 1e-11 * largest(case)
    circle, other = carom.Circle(case["center"], case["radius"]), carom.Circle(**case["other"])
    points = circle.tangent_points(case["point"])
    assert (points is None) == (case["tangent_points"] is None)
    if points is not None:
        assert flat([list(p) for p in points]) == pytest.approx(flat(case["tangent_points"]), rel=0.0, abs=tolerance)
    tangents = circle.common_tangents(other)
    assert (tangents is None) == (case["common_tangents"] is None)
    for tangent, expected in zip(tangents or (), case["common_tangents"] or (), strict=True):
        ends = flat(sorted(expected))  # a segment orders its own ends
        assert (*tangent.p0, *tangent.p1) == pytest.approx(ends, rel=0.0, abs=tolerance)
    first = circle.common_tangent(other)
    assert repr(first) == repr(tangents and tangents[0])
