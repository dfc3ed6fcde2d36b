"""Curves as arcs that join without a bend, as `carom.shapes.outlines` makes them, as geometry for a scene."""

from __future__ import annotations

from math import cos, sin
from typing import Any

from carom.scene.drawings.joints import OF_HANDLE
from carom.scene.drawings.pieces import Conic, Course, Cubic, Vector
from carom.shapes.arc import Arc
from carom.shapes.outlines import bezier, fit
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape


def fitted(piece: Conic | Cubic | Course, tolerance: float) -> list[tuple[str, dict[str, Any]]]:
    """The kind and the geometry of the arcs and segments that stand for a curve, no farther off than `tolerance`.

    Raises `InvalidArgument` where the tolerance is finer than the rounding of the curve's coordinates.
    """
    if isinstance(piece, Cubic):
        shapes = bezier(piece.points(), (1.0 - OF_HANDLE) * tolerance, guard=False)
    elif isinstance(piece, Conic):
        shapes = fit(
            lambda t: piece.at(piece.begin + t * piece.sweep),
            tolerance,
            derivative=lambda t: _speed(piece, piece.begin + t * piece.sweep),
            guard=False,
        )
    else:
        shapes = fit(piece.at, tolerance, guard=False)
    return [_geometry(shape) for shape in shapes]


def _speed(piece: Conic, t: float) -> Vector:
    """The derivative of the place on an ellipse by the share of the way."""
    (ux, uy), (vx, vy) = piece.u, piece.v
    c, s = piece.sweep * cos(t), piece.sweep * sin(t)
    return vx * c - ux * s, vy * c - uy * s


def _geometry(shape: Shape) -> tuple[str, dict[str, Any]]:
    """The kind and the geometry of a segment or an arc."""
    if isinstance(shape, Arc):
        angles = {"start_angle": shape.start_angle, "end_angle": shape.end_angle}
        return "arc", {"center": shape.center, "radius": shape.radius, **angles}
    if isinstance(shape, Segment):
        return "segment", {"start": shape.p0, "end": shape.p1}
    raise TypeError(f"an outline is of arcs and segments, not of {shape.kind}s")
