"""Arcs agree with the cases made in 50-digit arithmetic."""

import pytest

from carom.geometry.aabb import arc_box
from carom.geometry.angle import direction, normalize_angle
from carom.geometry.arc import arc_ends, arc_tangents, in_sector
from carom.geometry.vector import rotated_about
from tests.conformance.cases import flat, largest, load

CASES = load("arcs")
each_case = pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))


def ends(case: dict) -> tuple[float, float, float, float]:
    """The ends of a case's arc."""
    arc = case["arc"]
    return arc_ends(*arc["center"], arc["radius"], arc["start_angle"], arc["end_angle"])


@each_case
def test_ends_and_tangents(case: dict) -> None:
    tolerance = 1e-12 * largest(case)
    assert ends(case) == pytest.approx(flat([case["p0"], case["p1"]]), rel=0.0, abs=tolerance)
    found = arc_tangents(case["arc"]["start_angle"], case["arc"]["end_angle"])
    assert found == pytest.approx(flat([case["t0"], case["t1"]]), rel=0.0, abs=1e-15)


@each_case
def test_boxes(case: dict) -> None:
    found = arc_box(*case["arc"]["center"], case["arc"]["radius"], *ends(case))
    assert found == pytest.approx(tuple(case["aabb"]), rel=0.0, abs=1e-12 * largest(case))


@each_case
def test_sectors(case: dict) -> None:
    cx, cy = case["arc"]["center"]
    ax, ay, bx, by = ends(case)
    for (x, y), expected in case["in_sector"]:
        assert in_sector(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy) is expected


@each_case
def test_turns_about_a_pivot(case: dict) -> None:
    arc, turned = case["arc"], case["turned"]
    center = rotated_about(*arc["center"], *turned["pivot"], *direction(turned["angle"]))
    start = normalize_angle(arc["start_angle"] + turned["angle"])
    end = normalize_angle(arc["end_angle"] + turned["angle"])
    expected = (*turned["center"], turned["start_angle"], turned["end_angle"])
    assert (*center, start, end) == pytest.approx(expected, rel=0.0, abs=1e-10 * largest(case))
