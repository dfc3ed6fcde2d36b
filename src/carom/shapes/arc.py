"""Arcs: curved walls with bare ends."""

from __future__ import annotations

from math import atan2
from typing import Literal, TypeAlias, Unpack

from carom.checks import number, pair, positive, refuse
from carom.constants import TWO_PI
from carom.geometry.angle import normalize_angle
from carom.geometry.arc import arc_length, arc_tangents, closest_on_arc, in_sector
from carom.rows.kinds import arc_of
from carom.rows.pose import derive
from carom.rows.shape import ARC, ShapeRow
from carom.shapes.mover import Geometry
from carom.shapes.round import RoundShape
from carom.shapes.shape import ShapeOptions
from carom.spelling import spelled
from carom.turns import changing, setting
from carom.typing import Pair, Vector

AngleName: TypeAlias = Literal["start_angle", "end_angle"]


@spelled
class Arc(RoundShape):
    """The part of a circle counterclockwise from `start_angle` to `end_angle`; takes the options of every `Shape` too.

    Angles are in radians and kept in [0, 2π). Balls meet it from either side; its ends are bare, like a segment's.
    Raises `InvalidArgument` for a radius that is not positive, and for equal angles or angles so near each other that
    rounding makes both ends one point (a whole circle is a `Circle`).

    >>> bend = Arc((0, 0), 2, start_angle=0, end_angle=-1.5)
    >>> bend.acute, bend.in_sector((0, 5)), bend.in_sector((1, -1))
    (True, True, False)
    """

    __slots__ = ()

    _KIND = ARC

    def __init__(
        self,
        center: Pair,
        radius: float,
        start_angle: float,
        end_angle: float,
        **options: Unpack[ShapeOptions],
    ) -> None:
        x, y = pair("center", center)
        size = positive("radius", radius)
        start, end = _two_angles(("start_angle", start_angle), ("end_angle", end_angle))
        self._create("end_angle", end_angle, options, cx=x, cy=y, radius=size, start_angle=start, end_angle=end)

    def __repr__(self) -> str:
        return f"Arc({self.center}, {self.radius}, {self.start_angle}, {self.end_angle})"

    def _check(self, row: ShapeRow, name: str, value: object) -> None:
        super()._check(row, name, value)
        if row["ax"] == row["bx"] and row["ay"] == row["by"]:
            raise refuse(name, "must leave the two ends apart", value)

    # -- angles ------------------------------------------------------------------------------------------------------

    @property
    def start_angle(self) -> float:
        """The angle of `p0`, in [0, 2π); the arc goes counterclockwise from there."""
        return float(self._row["start_angle"])

    @start_angle.setter
    @setting
    def start_angle(self, value: float) -> None:
        self._set_angle("start_angle", value, "end_angle")

    @property
    def end_angle(self) -> float:
        """The angle of `p1`, in [0, 2π)."""
        return float(self._row["end_angle"])

    @end_angle.setter
    @setting
    def end_angle(self, value: float) -> None:
        self._set_angle("end_angle", value, "start_angle")

    def _set_angle(self, name: AngleName, value: float, other: AngleName) -> None:
        """Set the angle `name`, which must not become the `other` one."""
        angle, across = normalize_angle(number(name, value)), float(self._row[other])
        if angle == across:
            raise refuse(name, f"must point another way than {other}={across!r} (`angles` sets both at once)", value)
        geometry: Geometry = {}
        geometry[name] = angle
        self._set_geometry(name, value, **geometry)

    @property
    def angles(self) -> tuple[float, float]:
        """Both angles, `(start_angle, end_angle)`. Set together they need only differ from each other."""
        return self.start_angle, self.end_angle

    @angles.setter
    @setting
    def angles(self, value: Pair) -> None:
        start, end = pair("angles", value)
        self._set_angles(("angles[0]", start), ("angles[1]", end))

    @changing
    def set_angles(self, start_angle: float, end_angle: float) -> None:
        """Set both angles at once, as `arc.angles = (start_angle, end_angle)` does.

        Raises `InvalidArgument` where they are equal.
        """
        self._set_angles(("start_angle", start_angle), ("end_angle", end_angle))

    def _set_angles(self, first: tuple[str, float], second: tuple[str, float]) -> None:
        """Set both angles, each given with the name of the argument that it is."""
        start, end = _two_angles(first, second)
        self._set_geometry(*second, start_angle=start, end_angle=end)

    @property
    def acute(self) -> bool:
        """Whether the start angle is below the end angle, so that the arc does not go over the angle 0."""
        return self.start_angle < self.end_angle

    # -- what follows from them --------------------------------------------------------------------------------------

    @property
    def p0(self) -> Vector:
        """The end at `start_angle`."""
        row = self._row
        return float(row["ax"]), float(row["ay"])

    @property
    def p1(self) -> Vector:
        """The end at `end_angle`."""
        row = self._row
        return float(row["bx"]), float(row["by"])

    @property
    def t0(self) -> Vector:
        """The unit tangent at `p0`, clockwise: it points out of the arc."""
        x, y, _, _ = arc_tangents(self.start_angle, self.end_angle)
        return x, y

    @property
    def t1(self) -> Vector:
        """The unit tangent at `p1`, counterclockwise: it points out of the arc."""
        _, _, x, y = arc_tangents(self.start_angle, self.end_angle)
        return x, y

    @property
    def length(self) -> float:
        """How far it is along the arc from end to end."""
        return arc_length(self.radius, self.start_angle, self.end_angle)

    def in_sector(self, p: Pair) -> bool:
        """Whether the direction from the centre to `p` is one of the arc's; the bounding rays and the centre count."""
        x, y = pair("p", p)
        (cx, cy), (ax, ay), (bx, by) = self.center, self.p0, self.p1
        return in_sector(ax - cx, ay - cy, bx - cx, by - cy, x - cx, y - cy)

    def closest_point(self, p: Pair) -> Vector:
        """The point of it that is nearest to `p`: an end outside the sector, its middle where `p` is the centre."""
        x, y = pair("p", p)
        return closest_on_arc(arc_of(self._row), x, y)

    def parameter(self, point: Pair) -> float:
        """How far along it from `p0` the place is that is nearest to `point`; from 0 to its length."""
        (x, y), (cx, cy) = self.closest_point(pair("point", point)), self.center
        along = self.radius * normalize_angle(atan2(y - cy, x - cx) - self.start_angle)
        # At an end rounding may put it before the first or past the second; which, the rest of the circle tells.
        past = along - self.length
        return min(along, self.length) if past <= TWO_PI * self.radius - along else 0.0

    def complement(self) -> Arc:
        """The rest of the circle, as a new arc of the same surface and motion, in no world and no compound."""
        row = self._lone_row()
        row["start_angle"], row["end_angle"] = self.end_angle, self.start_angle
        start, end = float(row["initial_start_angle"]), float(row["initial_end_angle"])
        row["initial_start_angle"], row["initial_end_angle"] = end, start
        derive(row)
        rest = Arc.__new__(Arc)
        rest._begin(row, None, None)
        return rest


def _two_angles(first: tuple[str, float], second: tuple[str, float]) -> tuple[float, float]:
    """The two angles that a user gave under their names, normalized; raises for equal ones."""
    start, end = normalize_angle(number(*first)), normalize_angle(number(*second))
    if start == end:
        name, angle = first
        raise refuse(second[0], f"must point another way than {name}={angle!r} (a whole circle is a Circle)", second[1])
    return start, end
