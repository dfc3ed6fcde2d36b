"""Where the parts of a scene go over into each other."""

from math import hypot

import carom


def distance_of_guard_points(scene: carom.Scene, arc: str) -> float:
    """How far the guard points of a scene are from the ends of one of its arcs."""
    (bow,) = [shape.build() for shape in scene.shapes if shape.name == arc]
    assert isinstance(bow, carom.Arc)
    points = [shape.position for shape in scene.build().shapes if isinstance(shape, carom.Point)]
    return min(hypot(x - end[0], y - end[1]) for x, y in points for end in (bow.p0, bow.p1))
