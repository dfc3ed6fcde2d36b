"""What stands on the playfield and does not move: cabinet, rails, rubbers, slingshots, shoulders, posts, apron.

Every outline is read from the world's shapes, so that what is seen is what the balls meet.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from math import hypot, pi

import carom
from carom.play.pinball.art.paint import (
    CORAL,
    CREAM,
    GOLD,
    INDIGO,
    NIGHT,
    TEAL,
    VIOLET,
    Canvas,
    Colour,
    Spot,
    bow,
    mixed,
    polar,
    ring,
    star,
)
from carom.play.pinball.rules.lamps import SAUCER
from carom.play.pinball.rules.table import BALL_RADIUS

AnyShape = carom.Shape | carom.Compound | carom.Group

STEEL: Colour = (196, 204, 222)
DARK_STEEL: Colour = (74, 80, 108)
LACQUER: Colour = (24, 16, 44)
RAILS = ("lane wall", "left orbit guide", "right orbit guide", "left inlane guide", "right inlane guide")
SHADOW: Spot = (0.16, -0.2)
LANE_WALL, WIDTH = 18.6, 20.0  # between which the plunger lane is painted
MIDDLE = 0.5 * LANE_WALL  # of the field
FLOOR = -0.72  # the cabinet's inner edge below the apron
#: Ends of shapes this close together are one place.
MEETS = 1e-6


def path_of(shape: AnyShape) -> list[Spot]:
    """The points along a shape from its start to its end."""
    if isinstance(shape, carom.Arc):
        end = shape.end_angle if shape.end_angle > shape.start_angle else shape.end_angle + 2.0 * pi
        return bow(shape.center, shape.radius, shape.start_angle, end)
    if isinstance(shape, carom.Circle):
        return ring(shape.center, shape.radius)
    if isinstance(shape, (carom.Segment, carom.Gate)):
        return [shape.p0, shape.p1]
    return []


def _near(first: Spot, second: Spot) -> bool:
    """Whether two ends are one place."""
    return hypot(first[0] - second[0], first[1] - second[1]) < MEETS


def _joined(path: list[Spot], piece: list[Spot]) -> bool:
    """Whether a piece meets one of the path's ends; it is then part of the path."""
    for run in (piece, piece[::-1]):
        if _near(path[-1], run[0]):
            path.extend(run[1:])
            return True
        if _near(path[0], run[-1]):
            path[:0] = run[:-1]
            return True
    return False


def outlines(shapes: Iterable[AnyShape], names: Collection[str]) -> list[list[Spot]]:
    """The paths that shapes of some names make, each shape joined to the one before where they meet."""
    paths: list[list[Spot]] = []
    for shape in shapes:
        if shape.name not in names or not (piece := path_of(shape)):
            continue
        if not (paths and _joined(paths[-1], piece)):
            paths.append(piece)
    return paths


def band_of(part: carom.Compound) -> list[Spot]:
    """The outline of a compound that is a band, in the table's units."""
    path: list[Spot] = []
    for shape in part.shapes:
        if not (path and _joined(path, path_of(shape))):
            path.extend(path_of(shape))
    return path


def paint_parts(canvas: Canvas, world: carom.World) -> None:
    """Paint all that stands still, with its shadow, and the cabinet round it."""
    shapes = world.shapes
    with canvas.layer(110, SHADOW):
        for path in outlines(shapes, RAILS):
            canvas.stroke(path, 0.3, (0, 0, 0))
        for path in [*outlines(shapes, ("lane guide",)), *_slingshots(shapes)]:
            canvas.fill(path, (0, 0, 0))
    _lane(canvas)
    for shape in shapes:
        if isinstance(shape, carom.Circle) and shape.name == SAUCER:
            saucer(canvas, shape.center, BALL_RADIUS)
    for path in _capsules(shapes):
        _lane_guide(canvas, path)
    for shape in shapes:
        if isinstance(shape, carom.Gate):
            _gate(canvas, shape)
    for side in ("left", "right"):
        paint_shoulder(canvas, shapes, side)
    for path in outlines(shapes, RAILS):
        rail(canvas, path)
    for path in _slingshots(shapes):
        _slingshot(canvas, path)
    _cabinet(canvas, shapes)
    for shape in shapes:
        if isinstance(shape, carom.Circle) and (shape.name or "").endswith("post"):
            post(canvas, shape.center, shape.radius)


def saucer(canvas: Canvas, center: Spot, radius: float) -> None:
    """Paint the saucer: a cup of steel as wide as a ball in a ring of brass, dark inside."""
    canvas.disc(center, radius + 0.3, (*NIGHT, 190))
    canvas.stroke(ring(center, radius + 0.2), 0.1, GOLD, closed=True)
    for share, colour in ((1.1, DARK_STEEL), (0.96, STEEL), (0.86, DARK_STEEL), (0.74, NIGHT), (0.5, (4, 4, 12))):
        canvas.disc(center, radius * share, colour)
    for number in range(8):
        spot = polar(center, radius + 0.2, (number + 0.5) * pi / 4.0)
        canvas.disc(spot, 0.09, CREAM if number % 2 else CORAL)


def rail(canvas: Canvas, path: list[Spot]) -> None:
    """Paint a rail of bent steel."""
    canvas.stroke(path, 0.3, DARK_STEEL)
    canvas.stroke(path, 0.17, STEEL)
    canvas.stroke([(x - 0.03, y + 0.03) for x, y in path], 0.06, (255, 255, 255))


def rubber(canvas: Canvas, path: list[Spot], colour: Colour = CREAM) -> None:
    """Paint a rubber ring."""
    canvas.stroke(path, 0.22, mixed(colour, NIGHT, 0.55), closed=True)
    canvas.stroke(path, 0.13, colour, closed=True)


def post(canvas: Canvas, center: Spot, radius: float) -> None:
    """Paint a post with a rubber and a cap of brass."""
    canvas.disc((center[0] + SHADOW[0], center[1] + SHADOW[1]), radius, (0, 0, 0, 110))
    canvas.disc(center, radius + 0.02, mixed(CREAM, NIGHT, 0.4))
    canvas.disc(center, radius * 0.86, CREAM)
    canvas.disc(center, radius * 0.55, mixed(GOLD, NIGHT, 0.45))
    canvas.disc((center[0] - 0.04, center[1] + 0.05), radius * 0.36, GOLD)


def _capsules(shapes: Iterable[AnyShape]) -> list[list[Spot]]:
    """The outlines of the lane guides, one after the other."""
    return outlines(shapes, ("lane guide",))


def _slingshots(shapes: Iterable[AnyShape]) -> list[list[Spot]]:
    """The outlines of the two slingshots."""
    shapes = list(shapes)
    return [
        path
        for side in ("left", "right")
        for path in outlines(shapes, (f"{side} slingshot", f"{side} slingshot's band"))
    ]


def _lane_guide(canvas: Canvas, path: list[Spot]) -> None:
    """Paint a guide between two lanes."""
    canvas.fill(path, CORAL)
    rubber(canvas, path)
    middle_x = sum(x for x, _ in path) / len(path)
    heights = [y for _, y in path]
    for y in (min(heights) + 0.28, max(heights) - 0.28):
        canvas.disc((middle_x, y), 0.13, GOLD)


def _slingshot(canvas: Canvas, path: list[Spot]) -> None:
    """Paint a slingshot: a plastic with rings inside its rubber."""
    x, y = sum(spot[0] for spot in path) / len(path), sum(spot[1] for spot in path) / len(path)
    for share, colour in ((1.0, INDIGO), (0.84, TEAL), (0.72, NIGHT), (0.6, CORAL), (0.4, GOLD), (0.2, CREAM)):
        canvas.fill([(x + (a - x) * share, y + (b - y) * share) for a, b in path], colour)
    rubber(canvas, path, (255, 255, 255))
    outer = max(path, key=lambda spot: (round(abs(spot[0] - MIDDLE), 2), -spot[1]))
    for corner in (outer, min(path, key=lambda spot: spot[1]), max(path, key=lambda spot: spot[1])):
        spot = (corner[0] + (x - corner[0]) * 0.17, corner[1] + (y - corner[1]) * 0.17)
        canvas.disc(spot, 0.2, mixed(GOLD, NIGHT, 0.5))
        canvas.disc((spot[0] - 0.03, spot[1] + 0.04), 0.12, CREAM)


def paint_shoulder(canvas: Canvas, shapes: Iterable[AnyShape], side: str) -> None:
    """Paint the bulge of one wall: a plastic in stripes, and the target on its face."""
    names = (f"{side} shoulder", f"{side} target")
    paths = outlines(shapes, names)
    if not paths:
        return
    path = max(paths, key=len)
    wall = path[0][0]
    for share, colour in ((1.0, VIOLET), (0.8, NIGHT), (0.66, INDIGO), (0.46, CORAL), (0.26, GOLD)):
        middle = sum(y for _, y in path) / len(path)
        canvas.fill([(wall + (x - wall) * share, middle + (y - middle) * (0.4 + 0.6 * share)) for x, y in path], colour)
    canvas.stroke(path, 0.22, mixed(CREAM, NIGHT, 0.55))
    canvas.stroke(path, 0.13, CREAM)
    for shape in shapes:
        if shape.name == f"{side} target":
            face = path_of(shape)
            canvas.stroke(face, 0.5, mixed(CORAL, NIGHT, 0.5))
            canvas.stroke(face, 0.32, CORAL)
            canvas.stroke(face, 0.1, CREAM)


def _gate(canvas: Canvas, gate: carom.Gate) -> None:
    """Paint a gate: a wire between two hinges, and the way it opens."""
    (x, y), (end_x, end_y) = gate.p0, gate.p1
    canvas.stroke([(x + SHADOW[0], y + SHADOW[1]), (end_x + SHADOW[0], end_y + SHADOW[1])], 0.1, (0, 0, 0, 110))
    canvas.stroke([gate.p0, gate.p1], 0.14, DARK_STEEL)
    canvas.stroke([gate.p0, gate.p1], 0.07, (255, 255, 255))
    for end in (gate.p0, gate.p1):
        canvas.disc(end, 0.17, mixed(GOLD, NIGHT, 0.4))
        canvas.disc(end, 0.1, GOLD)


def _lane(canvas: Canvas) -> None:
    """Paint the plunger lane: a dark channel with chevrons that climb."""
    canvas.fill([(LANE_WALL, -1.2), (WIDTH, -1.2), (WIDTH, 31.6), (LANE_WALL, 30.8)], (*NIGHT, 190))
    for number in range(13):
        y = 7.0 + number * 1.9
        colour = mixed(CORAL, TEAL, number / 12.0)
        x = 0.5 * (LANE_WALL + WIDTH)
        chevron = [(x - 0.4, y), (x, y + 0.42), (x + 0.4, y), (x + 0.4, y + 0.3), (x, y + 0.72), (x - 0.4, y + 0.3)]
        canvas.fill(chevron, (*colour, 190))


def _cabinet(canvas: Canvas, shapes: Iterable[AnyShape]) -> None:
    """Paint the lacquered cabinet round the field, with fans in its corners and a trim of brass."""
    box = canvas.box
    field = _field(shapes)
    frame = [(box.left, box.bottom), (box.left, box.top), (box.right, box.top), (box.right, box.bottom)]
    left = min(range(len(field)), key=lambda number: field[number])
    around = [*field[left:], *field[: left + 1]]
    canvas.fill([(box.left, around[0][1]), *around, (box.left, around[0][1]), *frame[1:], frame[0]], LACQUER)
    for corner, begin in (((box.left, box.top), -pi / 2.0), ((box.right, box.top), -pi)):
        _fan(canvas, corner, begin)
    canvas.stroke(field, 0.34, mixed(GOLD, NIGHT, 0.62), closed=True)
    canvas.stroke(field, 0.2, GOLD, closed=True)
    canvas.stroke(field, 0.07, CREAM, closed=True)


def _field(shapes: Iterable[AnyShape]) -> list[Spot]:
    """The outline of all that balls can reach, clockwise from the bottom on the left."""
    shapes = list(shapes)
    left, dome, right = (outlines(shapes, (name,))[0] for name in ("left wall", "dome", "right wall"))
    left, right = sorted(left, key=lambda spot: spot[1]), sorted(right, key=lambda spot: -spot[1])
    return [*left, *dome[-2:0:-1], *right, (right[-1][0], FLOOR), (left[0][0], FLOOR)]


def _fan(canvas: Canvas, corner: Spot, begin: float) -> None:
    """Paint a fan of rays and rings into a corner outside the dome."""
    for number in range(9):
        angle = begin + number * pi / 16.0
        canvas.fill(
            [corner, polar(corner, 4.2, angle - 0.045), polar(corner, 4.2, angle + 0.045)], mixed(VIOLET, NIGHT, 0.25)
        )
    for radius, colour in ((4.2, GOLD), (2.2, CORAL), (1.9, CORAL), (1.0, GOLD)):
        canvas.stroke(bow(corner, radius, begin, begin + pi / 2.0), 0.09, mixed(colour, NIGHT, 0.25))
    canvas.fill(star(corner, 1.0, 0.35, 8), GOLD)
