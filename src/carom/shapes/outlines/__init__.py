"""Outlines: lists of segments and arcs that join, with the points that their corners need."""

from carom.shapes.outlines.curves import bezier, biarcs, fit

__all__ = ["bezier", "biarcs", "fit"]
