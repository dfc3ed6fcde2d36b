"""The launch lane: where balls come up, one after the other, so that none overlaps another."""

from __future__ import annotations

from collections.abc import Sequence

import carom
from carom.play.toy.table import Table

#: Room between the largest ball and the lane's walls, and between a new ball's lowest point and the lane's end.
GAP = 0.05
#: Of the launch speed: a ball at the foot of the lane that rises slower than this is shot up again.
SLACK = 0.5


class Lane:
    """The lane of one table or of several that are given the same launches.

    Attributes:
        waiting: Balls that are still to come.
        widest: The radius of the largest ball that fits.
    """

    def __init__(self, table: Table) -> None:
        shapes = table.world.shapes
        left = next(shape.aabb.right for shape in shapes if shape.name == "lane wall")
        walls = [shape.aabb for shape in shapes if shape.name == "wall"]
        right, self._floor = max(box.right for box in walls), min(box.bottom for box in walls)
        self._x = 0.5 * (left + right)
        self.widest = 0.5 * (right - left) - GAP
        self.waiting = 0

    def feed(self, tables: Sequence[Table], radius: float, speed: float) -> int:
        """How many balls were launched now, 0 or 1: one that waits, if the lane's foot is free in all tables."""
        if not self.waiting:
            return 0
        foot = self.foot(radius)
        found = [ball for table in tables for ball in table.world.overlapping(foot) if isinstance(ball, carom.Ball)]
        for ball in found:
            if abs(ball.velocity[1]) < SLACK * speed:
                ball.velocity = (0.0, speed)
        if found:
            return 0
        self.waiting -= 1
        for table in tables:
            table.launch((self._x, foot.bottom + radius), radius, speed)
        return 1

    def foot(self, radius: float) -> carom.Aabb:
        """The box of a ball that is about to be launched."""
        y = self._floor + radius + GAP
        return carom.Aabb(self._x - radius, y - radius, self._x + radius, y + radius)
