"""The first touch, within a second, of a case's ball with its shape."""

from typing import Any

from carom.constants import END_SLOP
from tests.naive_impact import Figure, Flight, carom_impact


def figure_of(shape: dict[str, Any]) -> Figure:
    """A case's shape as the geometry's tests take it."""
    kind = shape["kind"]
    if kind == "point":
        return kind, tuple(shape["position"])
    if kind == "segment":
        ends = sorted([shape["start"], shape["end"]])
        return kind, (*ends[0], *ends[1])
    given = (*shape["center"], shape["radius"])
    if kind == "arc":
        return kind, (*given, shape["start_angle"], shape["end_angle"])
    return "disc" if shape.get("solid", False) else "circle", given


def first_touch(shape: dict[str, Any], ball: dict[str, Any], gravity: tuple[float, float]) -> float | None:
    """When the ball first touches the shape, or None."""
    radius = ball["radius"]
    flight = Flight(*ball["position"], radius, *ball["velocity"], *gravity, 1.0)
    return carom_impact(figure_of(shape), flight, END_SLOP * radius)
