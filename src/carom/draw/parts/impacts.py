"""What is drawn of hits: dots, lights, tangents, normals, reticles."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from carom.draw.parts.marks import NORMAL, TANGENT, faded, hit_mark, long_arrow_mark, reticle_mark
from carom.draw.parts.moment import LATEST
from carom.draw.parts.outlines import glow_mark, middle_of, tangents_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.picture import Picture
    from carom.shapes.shape import Shape

#: Seconds for which a shape that was hit glows.
GLOW_TIME = 0.35
#: Radians a second: how fast the reticle of a hit turns whose speed few exceed; and its angle at the hit itself.
TURN, FIRST_ANGLE = 2.0 * pi, pi / 4.0
#: Pixels: half a tangent's length, a normal's length; and how large a shape must be for its own to be drawn.
HALF_TANGENT, NORMAL_LENGTH, LEAST_EXTENT = 32.0, 28.0, 30.0


def draw_hits(painter: Painter, picture: Picture) -> None:
    """Draw the hit points, the strongest first, so that none hides a weaker one."""
    hits, strong = picture.moment.hits, picture.measures.impulse
    for (x, y), impulse in zip(hits["point"].tolist(), hits["impulse"].tolist(), strict=True):
        if picture.frame.shows(x, y):
            hit_mark(painter, picture.frame, (x, y), impulse / strong, picture.weight)


def draw_lights(painter: Painter, picture: Picture) -> None:
    """Draw the glow of the shapes that were hit a moment ago."""
    time, latest = picture.moment.time, picture.moment.latest
    last = dict(zip(latest["shape"].tolist(), latest["time"].tolist(), strict=True))
    for drawn in (*picture.still, *picture.moment.moving):
        age = time - last.get(drawn.id, -1e300)
        if age < GLOW_TIME:
            glow_mark(painter, picture.frame, drawn.shape, 1.0 - max(0.0, age) / GLOW_TIME, picture.weight)


def impacts(picture: Picture) -> Iterator[tuple[Vector, Vector, float, float, float]]:
    """The latest hits on the stage: where, the normal, the speed, how many seconds ago, and how fresh (1 to 0)."""
    latest = picture.moment.latest
    columns = (latest[field].tolist() for field in ("point", "normal", "speed", "time"))
    for (x, y), (nx, ny), speed, time in zip(*columns, strict=True):
        if picture.frame.shows(x, y):
            age = max(0.0, picture.moment.time - time)
            yield (x, y), (nx, ny), speed, age, max(0.15, 1.0 - age / LATEST)


def draw_reticles(painter: Painter, picture: Picture) -> None:
    """Draw a ring around each of the latest hits, which turns the faster the faster the impact was."""
    for place, _, speed, age, fresh in impacts(picture):
        angle = FIRST_ANGLE + TURN * age * speed / picture.measures.impact_speed
        reticle_mark(painter, picture.frame, place, angle, fresh)


def draw_tangents(painter: Painter, picture: Picture) -> None:
    """Draw the lines along the surface at the latest hits, or at the ends of shapes where no run is shown."""
    half = picture.frame.units(HALF_TANGENT)
    if not picture.of_run:
        for shape in large_shapes(picture):
            for place, (dx, dy) in tangents_of(shape):
                painter.segment(place, (place[0] + half * dx, place[1] + half * dy), TANGENT)
        return
    for (x, y), (nx, ny), _, _, fresh in impacts(picture):
        painter.segment((x - half * ny, y + half * nx), (x + half * ny, y - half * nx), faded(TANGENT, fresh))


def draw_normals(painter: Painter, picture: Picture) -> None:
    """Draw arrows from the surface to the ball at the latest hits, or the normals of shapes where no run is shown."""
    if not picture.of_run:
        for place, normal in filter(None, map(middle_of, large_shapes(picture))):
            long_arrow_mark(painter, picture.frame, place, normal, NORMAL_LENGTH, NORMAL)
        return
    for place, normal, _, _, fresh in impacts(picture):
        long_arrow_mark(painter, picture.frame, place, normal, NORMAL_LENGTH, faded(NORMAL, fresh))


def large_shapes(picture: Picture) -> Iterator[Shape]:
    """The shapes that are large enough for marks of their own."""
    for drawn in (*picture.still, *picture.moment.moving):
        box = drawn.shape.aabb
        if max(box.right - box.left, box.top - box.bottom) >= picture.frame.units(LEAST_EXTENT):
            yield drawn.shape
