"""What is drawn: a world as it stands, and what happened to it; decided here once, for every painter."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from carom.draw.frame import MARGIN, Frame
from carom.draw.legend import facts, legend, remarks
from carom.draw.looks import GATE, LOOKS, MOVING, Look, look_of, rounded
from carom.draw.marks import arrow_mark, ball_mark, hit_mark, pivot_mark, shape_mark, track_style
from carom.draw.painter import Style
from carom.draw.panel import Panel
from carom.draw.svg import SvgPainter
from carom.draw.theme import BALL_INKS, ThemeName
from carom.draw.trace import MOST_FOLLOWED
from carom.draw.tracks import BANDS, bands, thinned
from carom.record.members import parts
from carom.shapes.aabb import Aabb
from carom.shapes.arc import Arc
from carom.shapes.gate import Gate
from carom.shapes.segment import Segment
from carom.world.layout import HIT

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from carom.draw.painter import Painter, Points, Vector
    from carom.draw.trace import Trace
    from carom.draw.tracks import Track
    from carom.rows import Rows
    from carom.shapes.compound import Compound
    from carom.shapes.shape import Shape
    from carom.world.world import World

#: How many shapes the panel names at most.
MOST_SHARES = 8
#: The hits weaker than the strongest have sizes relative to this quantile of the impulses, so that one blow in a
#: thousand does not make dust of all others.
STRONG = 0.95
#: Pixels: a track is drawn through the fewest points that keep it within this distance of its way.
TRACK_TOLERANCE = 0.25
#: A ball's radius in pixels at which lines have their full width; in pictures of smaller balls they are thinner.
FULL_WEIGHT_RADIUS = 6.0
THINNEST = 0.45


@dataclass(frozen=True, slots=True)
class Balls:
    """The balls as they stand: `centers` (n, 2), `radii` (n,), `ids` (n,)."""

    centers: Points
    radii: NDArray[np.float64]
    ids: NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Picture:
    """All that a picture shows; `draw` gives it to any painter that was made for its `frame`."""

    panel: Panel
    frame: Frame
    shapes: tuple[tuple[Shape, Look], ...]  # in the order in which they are drawn
    balls: Balls
    inks: Mapping[int, str]  # of the balls that have one of their own, by id
    tracks: tuple[Track, ...]
    hits: Rows  # the strongest first
    weight: float

    def draw(self, painter: Painter) -> None:
        """Draw everything, layer by layer."""
        painter.layer("ground")
        self._draw_ground(painter)
        painter.layer("tracks")
        self._draw_tracks(painter)
        painter.layer("shapes")
        self._draw_shapes(painter)
        painter.layer("hits")
        self._draw_hits(painter)
        painter.layer("balls")
        self._draw_balls(painter)
        painter.layer("panel")
        self.panel.draw(painter, self.frame, MARGIN)

    def _draw_ground(self, painter: Painter) -> None:
        """Draw the paper and the stage."""
        frame = self.frame
        paper = [frame.world(x, y) for x, y in corners(0.0, 0.0, frame.width, frame.height)]
        painter.polyline(np.array(paper), Style(fill="paper"))
        stage = frame.stage
        painter.polyline(
            np.array(list(corners(stage.left, stage.bottom, stage.right, stage.top))),
            Style("rule", fill="stage", width=1.0),
        )

    def _draw_tracks(self, painter: Painter) -> None:
        """Draw the tracks, the oldest parts of all of them first."""
        moving = [track for track in self.tracks if len(track.times) > 1]
        if not moving:
            return
        start = min(float(track.times[0]) for track in moving)
        end = max(float(track.times[-1]) for track in moving)
        pieces: list[list[tuple[str, Points]]] = [[] for _ in range(BANDS)]
        for track in moving:
            ink = self.inks.get(track.ball, "ball")
            for band, points in bands(thinned(track, self.frame.units(TRACK_TOLERANCE)), start, end):
                pieces[band].append((ink, points))
        for band, inked in enumerate(pieces):
            for ink, points in inked:
                for stretch in self._on_stage(points):
                    painter.polyline(stretch, track_style(ink, band))

    def _on_stage(self, points: Points) -> list[Points]:
        """The stretches of a line whose points are all on the stage; a lone point makes none."""
        shown = np.array([self.frame.shows(x, y) for x, y in points.tolist()])
        starts = np.flatnonzero(np.diff(shown, prepend=False)) if len(shown) else shown
        stretches = np.split(points, starts)
        return [stretch for stretch in stretches if len(stretch) > 1 and self.frame.shows(*stretch[0].tolist())]

    def _draw_shapes(self, painter: Painter) -> None:
        """Draw the shapes, then the arrows of gates and the pivots of moving parts."""
        for shape, look in self.shapes:
            shape_mark(painter, self.frame, shape, look, self.weight)
        for shape, _ in self.shapes:
            if isinstance(shape, Gate):
                arrow_mark(painter, self.frame, shape.position, open_way(shape), GATE.style)
        for pivot in dict.fromkeys(rounded(shape.pivot) for shape, look in self.shapes if look is MOVING):
            pivot_mark(painter, self.frame, pivot)

    def _draw_balls(self, painter: Painter) -> None:
        """Draw the balls that are on the stage."""
        balls = self.balls
        for (x, y), radius, ball in zip(balls.centers.tolist(), balls.radii.tolist(), balls.ids.tolist(), strict=True):
            if self.frame.shows(x, y):
                ball_mark(painter, self.frame, (x, y), radius, self.inks.get(ball, "ball"))

    def _draw_hits(self, painter: Painter) -> None:
        """Draw the hit points, the strongest first, so that none hides a weaker one."""
        if len(self.hits) == 0:
            return
        strong = float(np.quantile(self.hits["impulse"], STRONG)) or 1.0
        for (x, y), impulse in zip(self.hits["point"].tolist(), self.hits["impulse"].tolist(), strict=True):
            if self.frame.shows(x, y):
                hit_mark(painter, self.frame, (x, y), impulse / strong, self.weight)


def open_way(gate: Gate) -> Vector:
    """The unit normal of `gate` on the side that it lets balls pass to, however slanted its direction is."""
    (x, y), (dx, dy) = gate.normal, gate.direction
    return (x, y) if x * dx + y * dy > 0.0 else (-x, -y)


def corners(left: float, low: float, right: float, high: float) -> tuple[Vector, Vector, Vector, Vector]:
    """The four corners of a box, in turn."""
    return (left, low), (right, low), (right, high), (left, high)


def picture_of(
    world: World,
    name: str,
    *,
    caption: str = "",
    trace: Trace | None = None,
    shares: Sequence[tuple[str, int]] = (),
) -> Picture:
    """The picture of `world` as it stands, with the tracks and hits of the run that `trace` has followed, if any.

    `shares` are the numbers of hits by what was hit, the largest first; the panel shows the first `MOST_SHARES`.
    """
    shapes = looks_of(world.shapes)
    # Radii one by one: asking for the column of all of them would wake the balls that sleep.
    radii = np.array([ball.radius for ball in world.balls])
    balls = Balls(world.balls.position.copy(), radii, world.balls.id.copy())
    inks = dict(zip(singled_out(balls, trace), cycle(BALL_INKS), strict=False))
    tracks = trace.tracks() if trace is not None else ()
    hits = trace.hits if trace is not None else np.zeros(0, HIT)
    panel = Panel(
        name,
        caption,
        facts(world, trace),
        tuple(shares[:MOST_SHARES]),
        legend([look for _, look in shapes], samples_of(balls, inks), tracks=len(tracks) > 0, hits=len(hits) > 0),
        remarks(world, trace, tracks),
    )
    frame = Frame.around(box_around(shapes, balls), panel.height)
    return Picture(panel, frame, shapes, balls, inks, tracks, hits, weight_for(balls, frame))


def singled_out(balls: Balls, trace: Trace | None) -> list[int]:
    """The ids of the balls that have inks of their own: those followed, else all while they are few."""
    if trace is not None:
        return trace.followed
    return balls.ids.tolist() if len(balls.ids) <= MOST_FOLLOWED else []


def samples_of(balls: Balls, inks: Mapping[int, str]) -> tuple[str, ...]:
    """The inks of the balls that there are, the common one first."""
    own = [inks[ball] for ball in balls.ids.tolist() if ball in inks]
    return (*(["ball"] if len(own) < len(balls.ids) else []), *dict.fromkeys(own))


def svg(picture: Picture, theme: ThemeName = ThemeName.AUTO) -> str:
    """The text of an SVG file that shows `picture`."""
    painter = SvgPainter(picture.frame, theme, title=picture.panel.name)
    picture.draw(painter)
    return painter.finish()


def looks_of(shapes: Iterable[Shape | Compound]) -> tuple[tuple[Shape, Look], ...]:
    """Each shape with its look, in the order in which they are drawn; the parts of compounds in place of these."""
    listed = parts(shapes)
    ends = frozenset(
        rounded(end) for shape in listed if isinstance(shape, Segment | Arc) for end in (shape.p0, shape.p1)
    )
    pairs = [(shape, look_of(shape, ends)) for shape in listed]
    return tuple(sorted(pairs, key=lambda pair: LOOKS.index(pair[1])))


def box_around(shapes: Sequence[tuple[Shape, Look]], balls: Balls) -> Aabb:
    """The part of the world to show: what holds all shapes, or all balls where there are no shapes."""
    boxes = [shape.aabb for shape, _ in shapes]
    if boxes:
        lows = np.array([(box.left, box.bottom) for box in boxes])
        highs = np.array([(box.right, box.top) for box in boxes])
    elif len(balls.ids):
        lows, highs = balls.centers - balls.radii[:, None], balls.centers + balls.radii[:, None]
    else:
        return Aabb(-0.5, -0.5, 0.5, 0.5)
    (left, bottom), (right, top) = lows.min(axis=0).tolist(), highs.max(axis=0).tolist()
    return Aabb(left, bottom, right, top)


def weight_for(balls: Balls, frame: Frame) -> float:
    """What the widths of lines are multiplied by, so that they do not drown small balls."""
    if len(balls.ids) == 0:
        return 1.0
    pixels = float(np.median(balls.radii)) * frame.scale
    return min(1.0, max(THINNEST, pixels / FULL_WEIGHT_RADIUS))
