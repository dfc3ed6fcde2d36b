"""Outlines: lists of segments and arcs that join, with the points that their corners need."""

from carom.shapes.outlines.curves import bezier, biarcs, fit
from carom.shapes.outlines.figures import capsule, polygon, polyline, rectangle, regular_polygon, stadium
from carom.shapes.outlines.path import path

__all__ = [
    "bezier",
    "biarcs",
    "capsule",
    "fit",
    "path",
    "polygon",
    "polyline",
    "rectangle",
    "regular_polygon",
    "stadium",
]
