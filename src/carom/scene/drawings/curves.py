"""Curves as arcs that join without a bend, as `carom.shapes.outlines` makes them, as geometry for a scene."""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, sin
from typing import Any

from carom.geometry.arc import arc_ends
from carom.scene.drawings.joints import OF_HANDLE
from carom.scene.drawings.pieces import Conic, Course, Cubic, Piece, Vector
from carom.shapes.arc import Arc
from carom.shapes.outlines.curves import Chain, bezier_chain, bezier_chains, fit_chain
from carom.shapes.outlines.walls import figures


def chains_of(pieces: Iterable[Piece], tolerance: float) -> dict[int, Chain]:
    """What `fitted` takes as a chain, by the ids of those pieces that have one: many at once take less time."""
    cubics = [piece for piece in pieces if isinstance(piece, Cubic)]
    chains = bezier_chains([cubic.points() for cubic in cubics], (1.0 - OF_HANDLE) * tolerance)
    return {id(cubic): chain for cubic, chain in zip(cubics, chains, strict=True) if chain is not None}


def fitted(
    piece: Conic | Cubic | Course, tolerance: float, chain: Chain | None = None
) -> list[tuple[str, dict[str, Any]]]:
    """The kind and the geometry of the arcs and segments that stand for a curve, no farther off than `tolerance`.

    `chain` are the arcs where they are known. Raises `InvalidArgument` where the tolerance is finer than the rounding
    of the curve's coordinates.
    """
    if chain is not None:
        pass
    elif isinstance(piece, Cubic):
        chain = bezier_chain(piece.points(), (1.0 - OF_HANDLE) * tolerance)
    elif isinstance(piece, Conic):
        chain = fit_chain(
            lambda t: piece.at(piece.begin + t * piece.sweep),
            tolerance,
            lambda t: _speed(piece, piece.begin + t * piece.sweep),
        )
    else:
        chain = fit_chain(piece.at, tolerance)
    made: list[tuple[str, dict[str, Any]]] = [*figures(*chain)]
    for kind, geometry in made:
        if kind == "arc":
            _check(**geometry)
    return made


def _speed(piece: Conic, t: float) -> Vector:
    """The derivative of the place on an ellipse by the share of the way."""
    (ux, uy), (vx, vy) = piece.u, piece.v
    c, s = piece.sweep * cos(t), piece.sweep * sin(t)
    return vx * c - ux * s, vy * c - uy * s


def _check(center: Vector, radius: float, start_angle: float, end_angle: float) -> None:
    """Raise `InvalidArgument` where rounding has made an arc a point; all arcs made into shapes would take long."""
    ax, ay, bx, by = arc_ends(*center, radius, start_angle, end_angle)
    if ax == bx and ay == by:
        Arc(center, radius, start_angle, end_angle)
