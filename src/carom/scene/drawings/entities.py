"""The outlines of DXF entities, as pieces seen from above."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import hypot, pi, radians
from typing import Any

from carom.scene.drawings.ellipses import bulged
from carom.scene.drawings.pieces import Conic, Course, Cubic, Matrix, Piece, Straight, Vector

Outlines = list[list[Piece]]


def outlines_of(entity: Any) -> Outlines | None:
    """The outlines of an entity that draws one; None for a mesh, which is a thing in space."""
    return _OUTLINES[entity.dxftype()](entity)


def _flat(entity: Any) -> Matrix:
    """How the plane of an entity lies in that of the drawing, seen from above."""
    ocs = entity.ocs()
    if not ocs.transform:
        return Matrix()
    across, along = ocs.to_wcs((1.0, 0.0, 0.0)), ocs.to_wcs((0.0, 1.0, 0.0))
    return Matrix(across.x, across.y, along.x, along.y)


def _pair(point: Any) -> Vector:
    """A point's place, seen from above."""
    return float(point[0]), float(point[1])


def _line(entity: Any) -> Outlines:
    return [[Straight(_pair(entity.dxf.start), _pair(entity.dxf.end))]]


def _point(entity: Any) -> Outlines:
    return [[Conic(_pair(entity.dxf.location), (1.0, 0.0), (0.0, 1.0))]]


def _circle(entity: Any) -> Outlines:
    radius = float(entity.dxf.radius)
    return [[Conic(_pair(entity.dxf.center), (radius, 0.0), (0.0, radius)).moved(_flat(entity))]]


def _arc(entity: Any) -> Outlines:
    radius, begin = float(entity.dxf.radius), radians(entity.dxf.start_angle)
    sweep = (radians(entity.dxf.end_angle) - begin) % (2.0 * pi) or 2.0 * pi
    return [[Conic(_pair(entity.dxf.center), (radius, 0.0), (0.0, radius), begin, sweep).moved(_flat(entity))]]


def _ellipse(entity: Any) -> Outlines:
    begin = float(entity.dxf.start_param)
    sweep = (float(entity.dxf.end_param) - begin) % (2.0 * pi) or 2.0 * pi
    return [[Conic(_pair(entity.dxf.center), _pair(entity.dxf.major_axis), _pair(entity.minor_axis), begin, sweep)]]


def _light_polyline(entity: Any) -> Outlines:
    points = [(float(x), float(y), float(bulge)) for x, y, bulge in entity.get_points("xyb")]
    return _bulged(points, entity, closed=entity.closed)


def _polyline(entity: Any) -> Outlines | None:
    """The outline of an old polyline; None for a mesh, which is a thing in space."""
    if entity.is_polygon_mesh or entity.is_poly_face_mesh:
        return None
    points = [(*_pair(vertex.dxf.location), float(vertex.dxf.get("bulge", 0.0))) for vertex in entity.vertices]
    return _bulged(points, entity, closed=entity.is_closed)


def _bulged(points: list[tuple[float, float, float]], entity: Any, *, closed: bool) -> Outlines:
    """The pieces between points, each with the bulge of its first one."""
    around = [*points, points[0]] if closed and points else points
    pieces = [bulged((x, y), (u, v), bulge) for (x, y, bulge), (u, v, _) in pairwise(around)]
    matrix = _flat(entity)
    return [[piece.moved(matrix) for piece in pieces if piece is not None]]


def _spline(entity: Any) -> Outlines:
    """The pieces of a spline: Bézier curves where it is made of cubic ones, else smooth curves between its knots."""
    spline = entity.construction_tool()
    if spline.degree <= 3 and not spline.is_rational and spline.is_clamped:
        return [[_bezier([_pair(point) for point in curve]) for curve in spline.bezier_decomposition()]]
    knots, degree = spline.knots(), spline.degree
    weights = spline.weights() or [1.0] * spline.count
    points = [
        (weight * point.x, weight * point.y, weight)
        for point, weight in zip(spline.control_points, weights, strict=True)
    ]
    courses: list[Piece] = []
    for last in range(degree, len(points)):
        if knots[last] < knots[last + 1]:
            # A stretch between two knots is shaped by the points and knots around it alone.
            first = last - degree
            courses.append(_course(points[first : last + 1], knots[first : last + degree + 2]))
    return [courses]


def _bezier(points: list[Vector]) -> Piece:
    """A Bézier curve of degree one to three, as what it is or a cubic one."""
    if len(points) == 2:
        return Straight(*points)
    if len(points) == 3:
        (x0, y0), (x1, y1), (x2, y2) = points
        first = x0 + 2.0 * (x1 - x0) / 3.0, y0 + 2.0 * (y1 - y0) / 3.0
        return Cubic(points[0], first, (x2 + 2.0 * (x1 - x2) / 3.0, y2 + 2.0 * (y1 - y2) / 3.0), points[2])
    return Cubic(*points)


def _course(points: list[tuple[float, float, float]], knots: list[float]) -> Course:
    """The stretch of a spline between the two middle ones of some knots; each point is (x·weight, y·weight, weight).

    Source: C. de Boor, A practical guide to splines, 2001, chapter X.
    """
    degree = len(points) - 1
    begin, end = knots[degree], knots[degree + 1]

    def place(share: float) -> Vector:
        t = begin + (end - begin) * share
        mixed = list(points)
        for level in range(1, degree + 1):
            for k in range(degree, level - 1, -1):
                part = (t - knots[k]) / (knots[k + 1 + degree - level] - knots[k])
                (x, y, w), (u, v, z) = mixed[k - 1], mixed[k]
                mixed[k] = (x + part * (u - x), y + part * (v - y), w + part * (z - w))
        x, y, w = mixed[degree]
        return x / w, y / w

    return Course(place)


_OUTLINES: dict[str, Callable[[Any], Outlines | None]] = {
    "ARC": _arc,
    "CIRCLE": _circle,
    "ELLIPSE": _ellipse,
    "LINE": _line,
    "LWPOLYLINE": _light_polyline,
    "POINT": _point,
    "POLYLINE": _polyline,
    "SPLINE": _spline,
}

#: The entities that draw an outline.
DRAWS = frozenset(_OUTLINES)


# -- filled circles ----------------------------------------------------------------------------------------------------


def disc(piece: Any) -> tuple[float, float, float]:
    """A circle as a key: centre and radius to six digits of the radius."""
    digits = 6 - int(f"{piece.radius or 1.0:e}".partition("e")[2])
    return round(piece.center[0], digits), round(piece.center[1], digits), round(piece.radius, digits)


def discs_of(hatch: Any) -> list[tuple[float, float, float]]:
    """The circles that a hatch fills, as keys."""
    found = []
    for path in hatch.paths:
        edges = getattr(path, "edges", None)
        if edges is not None and len(edges) == 1 and hasattr(edges[0], "radius"):
            center, radius = _pair(edges[0].center), float(edges[0].radius)
            found.append(disc(Conic(center, (radius, 0.0), (0.0, radius))))
        vertices = getattr(path, "vertices", None)
        if vertices is not None and len(vertices) == 2 and all(abs(abs(v[2]) - 1.0) < 1e-9 for v in vertices):
            (x, y, _), (u, v, _) = vertices
            radius = 0.5 * hypot(u - x, v - y)
            found.append(disc(Conic((0.5 * (x + u), 0.5 * (y + v)), (radius, 0.0), (0.0, radius))))
    return found
