"""Exact, fast 2D collisions: a library of shapes, and worlds that step them."""

__version__ = "0.1.0"
