"""The outlines of SVG's basic shapes and paths, as pieces in the element's own coordinates."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import pi

from carom.scene.drawings.paths import points, subpaths
from carom.scene.drawings.pieces import Conic, Piece, Straight, Vector
from carom.scene.drawings.tree import Element
from carom.scene.drawings.view_boxes import pixels

Outlines = list[list[Piece]]


def length(element: Element, name: str, whole: float, default: float = 0.0) -> float:
    """A length that an element has, in pixels, where 100% are `whole`; raises `ValueError` that begins with `name`."""
    text = element.attributes.get(name)
    if text is None or text == "auto":
        return default
    try:
        return pixels(text, whole)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None


def outlines_of(element: Element, viewport: Vector) -> Outlines:
    """The outlines of an element that draws one; raises `ValueError`, which begins with the attribute."""
    return _OUTLINES[element.tag](element, viewport)


def _line(element: Element, viewport: Vector) -> Outlines:
    x, y = viewport
    start = length(element, "x1", x), length(element, "y1", y)
    end = length(element, "x2", x), length(element, "y2", y)
    return [[Straight(start, end)]]


def _polyline(element: Element, _: Vector) -> Outlines:
    places = _points_of(element)
    return [[Straight(a, b) for a, b in pairwise(places)]]


def _polygon(element: Element, _: Vector) -> Outlines:
    places = _points_of(element)
    return [[Straight(a, b) for a, b in zip(places, places[1:] + places[:1], strict=True) if a != b]]


def _points_of(element: Element) -> list[Vector]:
    """The points of a polyline or polygon."""
    try:
        return points(element.attributes.get("points", ""))
    except ValueError as error:
        raise ValueError(f"points: {error}") from None


def _path(element: Element, _: Vector) -> Outlines:
    try:
        return subpaths(element.attributes.get("d", ""))
    except ValueError as error:
        raise ValueError(f"d: {error}") from None


def _circle(element: Element, viewport: Vector) -> Outlines:
    across, along = viewport
    radius = _positive(element, "r", (0.5 * (across * across + along * along)) ** 0.5)
    center = length(element, "cx", across), length(element, "cy", along)
    return [[Conic(center, (radius, 0.0), (0.0, radius))]] if radius else []


def _ellipse(element: Element, viewport: Vector) -> Outlines:
    across, along = viewport
    rx, ry = _positive(element, "rx", across), _positive(element, "ry", along)
    rx, ry = (rx if "rx" in element.attributes else ry), (ry if "ry" in element.attributes else rx)
    center = length(element, "cx", across), length(element, "cy", along)
    return [[Conic(center, (rx, 0.0), (0.0, ry))]] if rx and ry else []


def _positive(element: Element, name: str, whole: float) -> float:
    """A length that an element has and that is not negative."""
    value = length(element, name, whole)
    if value < 0.0:
        raise ValueError(f"{name}: must not be negative, not {element.attributes[name]!r}")
    return value


def _rectangle(element: Element, viewport: Vector) -> Outlines:
    """The outline of a rectangle, counterclockwise as y points down, with quarters of ellipses for round corners."""
    across, along = viewport
    x, y = length(element, "x", across), length(element, "y", along)
    width, height = _positive(element, "width", across), _positive(element, "height", along)
    rx, ry = _positive(element, "rx", across), _positive(element, "ry", along)
    attributes = element.attributes
    rx, ry = (
        (rx if attributes.get("rx", "auto") != "auto" else ry),
        (ry if attributes.get("ry", "auto") != "auto" else rx),
    )
    rx, ry = min(rx, 0.5 * width), min(ry, 0.5 * height)
    if width == 0.0 or height == 0.0:
        return []
    right, bottom = x + width, y + height
    if rx == 0.0 or ry == 0.0:
        corners = [(x, y), (right, y), (right, bottom), (x, bottom)]
        return [[Straight(corners[k], corners[(k + 1) % 4]) for k in range(4)]]
    corner = [
        Conic((right - rx, y + ry), (rx, 0.0), (0.0, ry), -0.5 * pi, 0.5 * pi),
        Conic((right - rx, bottom - ry), (rx, 0.0), (0.0, ry), 0.0, 0.5 * pi),
        Conic((x + rx, bottom - ry), (rx, 0.0), (0.0, ry), 0.5 * pi, 0.5 * pi),
        Conic((x + rx, y + ry), (rx, 0.0), (0.0, ry), pi, 0.5 * pi),
    ]
    sides = [
        Straight((x + rx, y), (right - rx, y)),
        Straight((right, y + ry), (right, bottom - ry)),
        Straight((right - rx, bottom), (x + rx, bottom)),
        Straight((x, bottom - ry), (x, y + ry)),
    ]
    return [[piece for pair in zip(sides, corner, strict=True) for piece in pair]]


_OUTLINES: dict[str, Callable[[Element, Vector], Outlines]] = {
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "path": _path,
    "polygon": _polygon,
    "polyline": _polyline,
    "rect": _rectangle,
}

#: The elements that draw an outline.
DRAWS = frozenset(_OUTLINES)
#: What each needs to draw one.
NEEDS = {
    "circle": "r above 0",
    "ellipse": "rx and ry above 0",
    "line": "two ends apart",
    "path": "d with a line or a curve",
    "polygon": "points that are two or more",
    "polyline": "points that are two or more",
    "rect": "width and height above 0",
}
