"""What is drawn of shapes and balls, layer by layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.draw.history.tracks import BANDS, bands
from carom.draw.parts.frame import MARGIN
from carom.draw.parts.looks import MOVING, SENSOR, rounded
from carom.draw.parts.marks import (
    BOX,
    VELOCITY,
    ball_mark,
    box_mark,
    long_arrow_mark,
    pivot_mark,
    track_style,
)
from carom.draw.parts.outlines import sector_mark, shape_mark, sign_mark

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.typing import NDArray

    from carom.draw.paint.painter import Painter, Points, Vector
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.moment import Drawn
    from carom.draw.picture import Picture

#: Pixels: the arrow of a ball as fast as few are; shorter ones than the second are left out.
FAST_ARROW, SHORTEST_ARROW = 44.0, 4.0


def draw_shapes(painter: Painter, picture: Picture, shapes: Iterable[Drawn], *, sensors: bool) -> None:
    """Draw the sensors among some shapes, or all others; then the arrows of gates and the pivots of moving parts."""
    chosen = [drawn for drawn in shapes if (drawn.look == SENSOR) == sensors]
    for drawn in chosen:
        shape_mark(painter, picture.frame, drawn.shape, drawn.look, picture.weight)
    for drawn in chosen:
        sign_mark(painter, picture.frame, drawn.shape)
    for pivot in dict.fromkeys(rounded(drawn.shape.pivot) for drawn in chosen if drawn.look == MOVING):
        pivot_mark(painter, picture.frame, pivot)


def draw_boxes(painter: Painter, shapes: Iterable[Drawn]) -> None:
    """Draw the boxes of some shapes that have an extent."""
    for drawn in shapes:
        box = drawn.shape.aabb
        if box.right > box.left or box.top > box.bottom:
            box_mark(painter, box)


def draw_ball_boxes(painter: Painter, picture: Picture) -> None:
    """Draw the boxes of the balls."""
    balls = picture.moment.balls
    for (x, y), radius in zip(balls.centers.tolist(), balls.radii.tolist(), strict=True):
        if picture.frame.shows(x, y):
            painter.box((x - radius, y - radius), (x + radius, y + radius), BOX)


def draw_sectors(painter: Painter, shapes: Iterable[Drawn]) -> None:
    """Draw the sectors of the arcs among some shapes."""
    for drawn in shapes:
        sector_mark(painter, drawn.shape)


def draw_balls(painter: Painter, picture: Picture) -> None:
    """Draw the balls that are on the stage."""
    balls = picture.moment.balls
    for (x, y), radius, ball in zip(balls.centers.tolist(), balls.radii.tolist(), balls.ids.tolist(), strict=True):
        if picture.frame.shows(x, y):
            ball_mark(painter, picture.frame, (x, y), radius, picture.inks.get(ball, "ball"))


def draw_velocities(painter: Painter, picture: Picture) -> None:
    """Draw an arrow from the centre of each ball that moves."""
    balls = picture.moment.balls
    for (x, y), (vx, vy) in zip(balls.centers.tolist(), balls.velocities.tolist(), strict=True):
        speed = (vx * vx + vy * vy) ** 0.5
        pixels = FAST_ARROW * min(2.0, speed / picture.measures.speed)
        if pixels >= SHORTEST_ARROW and picture.frame.shows(x, y):
            direction = vx / speed, vy / speed
            pixels = min(pixels, room_for(picture.frame, (x, y), direction))
            long_arrow_mark(painter, picture.frame, (x, y), direction, pixels, VELOCITY)


def room_for(frame: Frame, place: Vector, direction: Vector) -> float:
    """How many pixels an arrow from a place on the stage may have before it is over the panel or off the picture."""
    stage, beyond = frame.stage, frame.units(0.75 * MARGIN)
    (x, y), (dx, dy) = place, direction
    across = (stage.right + beyond - x) / dx if dx > 0.0 else (stage.left - beyond - x) / (dx or -1e-300)
    along = (stage.top + beyond - y) / dy if dy > 0.0 else (stage.bottom - beyond - y) / (dy or -1e-300)
    return min(across, along) * frame.scale


def draw_tracks(painter: Painter, picture: Picture, count: int = BANDS) -> None:
    """Draw the tracks in `count` bands of age, the oldest parts of all of them first."""
    moment = picture.moment
    pieces: list[list[tuple[str, Points]]] = [[] for _ in range(count)]
    for track in moment.tracks:
        if len(track.times) > 1:
            ink = picture.inks.get(track.ball, "ball")
            # A way between two points that are on the stage is on it too, so most tracks need be looked at once.
            first, last = track.times.searchsorted([moment.since, moment.time]).tolist()
            whole = bool(shown(picture, track.points[max(0, first - 1) : last + 1]).all())
            for band, points in bands(track, moment.since, moment.time, count):
                pieces[band] += [(ink, stretch) for stretch in ([points] if whole else on_stage(picture, points))]
    for band, inked in enumerate(pieces):
        for ink, points in inked:
            painter.polyline(points, track_style(ink, band, count))


def shown(picture: Picture, points: Points) -> NDArray[np.bool_]:
    """Which of some points are on the stage."""
    stage = picture.frame.stage
    x, y = points[:, 0], points[:, 1]
    inside: NDArray[np.bool_] = (stage.left <= x) & (x <= stage.right) & (stage.bottom <= y) & (y <= stage.top)
    return inside


def on_stage(picture: Picture, points: Points) -> list[Points]:
    """The stretches of a line whose points are all on the stage; a lone point makes none."""
    there = shown(picture, points)
    starts = ((there[1:] != there[:-1]).nonzero()[0] + 1).tolist()
    pairs = zip([0, *starts], [*starts, len(points)], strict=True)
    return [points[begin:end] for begin, end in pairs if there[begin] and end - begin > 1]
