"""What is drawn: a world as it stands, and what happened to it; decided here once, for every painter."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.checks import instance, refuse, text, whole
from carom.draw.history.trace import MOST_FOLLOWED, Trace
from carom.draw.history.tracks import BANDS, thinned
from carom.draw.paint.painter import Style
from carom.draw.paint.svg import SvgPainter
from carom.draw.parts.cells import draw_cells, partition_of
from carom.draw.parts.frame import MARGIN, Frame
from carom.draw.parts.impacts import draw_hits, draw_lights, draw_normals, draw_reticles, draw_tangents
from carom.draw.parts.labels import Labels
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer, layers_of
from carom.draw.parts.legend import facts, legend, remarks, unnamed
from carom.draw.parts.looks import LOOKS, Look, look_of
from carom.draw.parts.moment import STRONG, Balls, Drawn, Measures, Moment
from carom.draw.parts.names import draw_names, moving_labels, still_labels
from carom.draw.parts.outlines import ends_of, has_sector, open_way
from carom.draw.parts.panel import Panel
from carom.draw.parts.scenery import (
    draw_ball_boxes,
    draw_balls,
    draw_boxes,
    draw_sectors,
    draw_shapes,
    draw_tracks,
    draw_velocities,
)
from carom.draw.theme import BALL_INKS, ThemeName
from carom.record.members import names_in, parts
from carom.scene.drawings.keeping import with_scene
from carom.scene.scene import Scene
from carom.shapes.aabb import Aabb
from carom.spelling import spelled
from carom.world.world import World

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Mapping, Sequence

    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.cells import Cell
    from carom.draw.parts.frame import Size
    from carom.shapes.compound import Compound
    from carom.shapes.group import Group
    from carom.shapes.shape import Shape

__all__ = ["STRONG", "Balls", "Picture", "box_around", "looks_of", "open_way", "picture_of", "svg", "weight_for"]

#: How many shapes the panel names at most.
MOST_SHARES = 8
#: Pixels: a track is drawn through the fewest points that keep it within this distance of its way.
TRACK_TOLERANCE = 0.25
#: A ball's radius in pixels at which lines have their full width; in pictures of smaller balls they are thinner.
FULL_WEIGHT_RADIUS = 6.0
THINNEST = 0.45
UNLABELLED = Labels()


@spelled
@dataclass(frozen=True, slots=True)
class Picture:
    """All that a picture shows; `draw` gives it to any painter that was made for its `frame`.

    `draw_still` draws what is the same throughout a run, `draw_moving` what lies above that and is of one moment.
    """

    panel: Panel
    frame: Frame
    layers: frozenset[Layer]
    still: tuple[Drawn, ...]  # in the order in which they are drawn
    moment: Moment
    inks: Mapping[int, str]  # of the balls that have one of their own, by id
    names: Mapping[int, str]  # of shapes and balls, by id
    cells: tuple[Cell, ...]
    measures: Measures
    weight: float
    of_run: bool  # whether hits belong to it, shown or not
    bands: int = BANDS  # of tracks
    labels: Labels = UNLABELLED  # of what stays

    def draw(self, painter: Painter) -> None:
        """Draw everything, layer by layer."""
        self.draw_still(painter)
        self.draw_moving(painter)

    def draw_still(self, painter: Painter) -> None:
        """Draw the paper, the stage, and all that stays as it is."""
        painter.layer("ground")
        self._draw_ground(painter)
        self.draw_still_shapes(painter)
        painter.layer("panel")
        if self.frame.panel:
            self.panel.draw_still(painter, self.frame, MARGIN)

    def draw_still_shapes(self, painter: Painter) -> None:
        """Draw what stays of the world itself."""
        if self._begun(painter, Layer.CELLS):
            draw_cells(painter, self.cells, self.frame.stage)
        if self._begun(painter, Layer.BOXES):
            draw_boxes(painter, self.still)
        if self._begun(painter, Layer.SECTORS):
            draw_sectors(painter, self.still)
        if self._begun(painter, Layer.SENSORS):
            draw_shapes(painter, self, self.still, sensors=True)
        if self._begun(painter, Layer.SHAPES):
            draw_shapes(painter, self, self.still, sensors=False)

    def draw_moving(self, painter: Painter) -> None:
        """Draw the moment."""
        if self._begun(painter, Layer.TRACKS):
            draw_tracks(painter, self, self.bands)
        if self._begun(painter, Layer.LIGHTS):
            draw_lights(painter, self)
        self._draw_moving_shapes(painter)
        if self._begun(painter, Layer.HITS):
            draw_hits(painter, self)
        if self._begun(painter, Layer.TANGENTS):
            draw_tangents(painter, self)
        if self._begun(painter, Layer.NORMALS):
            draw_normals(painter, self)
        if self._begun(painter, Layer.BALLS):
            draw_balls(painter, self)
        if self._begun(painter, Layer.VELOCITIES):
            draw_velocities(painter, self)
        if self._begun(painter, Layer.RETICLES):
            draw_reticles(painter, self)
        if self._begun(painter, Layer.NAMES):
            draw_names(painter, self)
        painter.layer("facts")
        if self.frame.panel:
            self.panel.draw_facts(painter, self.frame, MARGIN)

    def _draw_moving_shapes(self, painter: Painter) -> None:
        """Draw what there is of shapes that move or are switched on and off."""
        moving = self.moment.moving
        if self._begun(painter, Layer.BOXES, "-moving"):
            draw_boxes(painter, moving)
            if Layer.BALLS in self.layers:
                draw_ball_boxes(painter, self)
        if not moving:
            return
        if self._begun(painter, Layer.SECTORS, "-moving"):
            draw_sectors(painter, moving)
        if self._begun(painter, Layer.SENSORS, "-moving"):
            draw_shapes(painter, self, moving, sensors=True)
        if self._begun(painter, Layer.SHAPES, "-moving"):
            draw_shapes(painter, self, moving, sensors=False)

    def _begun(self, painter: Painter, layer: Layer, part: str = "") -> bool:
        """Whether a layer is shown; begins it, or a part of it, if so."""
        if layer in self.layers:
            painter.layer(f"{layer}{part}")
        return layer in self.layers

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


def corners(left: float, low: float, right: float, high: float) -> tuple[Vector, Vector, Vector, Vector]:
    """The four corners of a box, in turn."""
    return (left, low), (right, low), (right, high), (left, high)


@spelled
def picture_of(
    world: World,
    name: str = "World",
    *,
    caption: str = "",
    trace: Trace | None = None,
    shares: Sequence[tuple[str, int]] = (),
    layers: Collection[Layer] = DEFAULT_LAYERS,
    size: Size = None,
) -> Picture:
    """The picture of `world` as it stands, with the tracks and hits of the run that `trace` has followed, if any.

    `name` stands over the panel. `shares` are the numbers of touches by what was touched, the largest first; the panel
    shows the first `MOST_SHARES`. What `layers` there are says `Layer`; `size` is in pixels.
    """
    instance("world", world, World, "a World")
    shown, shares = layers_of(layers), checked_shares(shares)
    if trace is not None:
        instance("trace", trace, Trace, "a Trace or None")
    balls = Balls.of(world)
    moment = Moment(world.time, balls) if trace is None else traced(world.time, balls, trace)
    shapes = parts(world.shapes)
    cells: tuple[Cell, ...] = ()
    if Layer.CELLS in shown:
        cells = partition_of(world).cells
    still = drawn_of(shapes, [shape.id or 0 for shape in shapes])
    bounces, tracks = (trace.bounces if trace is not None else 0), moment.tracks
    picture = composed(
        Panel(
            text("name", name),
            text("caption", caption),
            facts(world, trace),
            shares,
            notes=remarks(shown, len(tracks), len(balls.ids), world.time - moment.since, bounces, cells),
        ),
        still,
        moment,
        box_around([(one.shape, one.look) for one in still], balls),
        layers=shown,
        size=size,
        inks=dict(zip(singled_out(balls, trace), cycle(BALL_INKS), strict=False)),
        names=names_in(world),
        cells=cells,
        measures=Measures.of(moment.hits, balls.velocities),
        of_run=trace is not None,
        empty=[layer for layer, there in ((Layer.TRACKS, tracks), (Layer.HITS, moment.hits)) if not len(there)],
    )
    tolerance = picture.frame.units(TRACK_TOLERANCE)
    return replace(picture, moment=replace(moment, tracks=tuple(thinned(track, tolerance) for track in tracks)))


def checked_shares(shares: Any) -> tuple[tuple[str, int], ...]:
    """The shares that a panel shows, pairs of words and a number; raises `InvalidArgument` for anything else."""
    try:
        pairs = [(text("", label), whole("", count)) for label, count in shares]
    except (TypeError, ValueError):
        raise refuse("shares", "must be pairs of words and a number of touches", shares) from None
    return tuple(pairs[:MOST_SHARES])


def traced(time: float, balls: Balls, trace: Trace) -> Moment:
    """The moment at the end of a run that was followed."""
    tracks = tuple(track for track in trace.tracks() if len(track.times) > 1)
    since = min((float(track.times[0]) for track in tracks), default=time)
    return Moment(time, balls, (), tracks, since, trace.hits, trace.latest)


def composed(
    panel: Panel,
    still: tuple[Drawn, ...],
    moment: Moment,
    box: Aabb,
    *,
    layers: frozenset[Layer],
    size: Size,
    inks: Mapping[int, str],
    names: Mapping[int, str],
    cells: tuple[Cell, ...],
    measures: Measures,
    of_run: bool,
    empty: Collection[Layer],
) -> Picture:
    """The picture that shows a `box` of the world; its panel gets a legend, without the layers that are `empty`."""
    drawn, balls = (*still, *moment.moving), moment.balls
    bare = len(drawn) == 0
    unhit = bare if not of_run else Layer.HITS in empty
    absent = {
        Layer.LIGHTS: Layer.HITS in empty,
        Layer.RETICLES: Layer.HITS in empty,
        Layer.NORMALS: unhit,
        Layer.TANGENTS: unhit,
        Layer.BOXES: bare and len(balls.ids) == 0,
        Layer.VELOCITIES: len(balls.ids) == 0,
        Layer.SECTORS: not any(has_sector(one.shape) for one in drawn),
        Layer.CELLS: len(cells) == 0,
    }
    shown = [layer for layer in layers if layer not in empty and not absent.get(layer)]
    panel = replace(panel, entries=legend({one.look for one in drawn}, samples_of(balls, inks), shown))
    frame = Frame.fit(box, panel.height, size)
    weight = weight_for(balls, frame)
    picture = Picture(panel, frame, layers, still, moment, inks, names, cells, measures, weight, of_run)
    if Layer.NAMES not in layers:
        return picture
    picture, left_out = labelled(picture)
    if left_out:
        # The note on it makes the panel higher, which the frame is to have room for.
        frame = Frame.fit(box, noted(panel, left_out).height, size)
        picture, left_out = labelled(replace(picture, frame=frame, weight=weight_for(balls, frame)))
    return replace(picture, panel=noted(panel, left_out))


def labelled(picture: Picture) -> tuple[Picture, int]:
    """The same picture with the labels of what stays, and how many names of all find no room in it."""
    labels = still_labels(picture.frame, picture.names, picture.still, picture.moment.balls)
    picture = replace(picture, labels=labels)
    return picture, labels.left_out + moving_labels(picture).left_out


def noted(panel: Panel, left_out: int) -> Panel:
    """A panel with a note on the names that found no room."""
    return replace(panel, notes=(*panel.notes, *unnamed(left_out)))


def drawn_of(shapes: Sequence[Shape], ids: Iterable[int]) -> tuple[Drawn, ...]:
    """Single shapes with their looks and ids, in the order in which they are drawn."""
    ends = ends_of(shapes)
    drawn = [Drawn(shape, look_of(shape, ends), key, shape._whole) for shape, key in zip(shapes, ids, strict=True)]
    return tuple(sorted(drawn, key=lambda one: LOOKS.index(one.look)))


def singled_out(balls: Balls, trace: Trace | None) -> list[int]:
    """The ids of the balls that have inks of their own: those followed, else all while they are few."""
    if trace is not None:
        return trace.followed
    return balls.ids.tolist() if len(balls.ids) <= MOST_FOLLOWED else []


def samples_of(balls: Balls, inks: Mapping[int, str]) -> tuple[str, ...]:
    """The inks of the balls that there are, the common one first."""
    own = [inks[ball] for ball in balls.ids.tolist() if ball in inks]
    return (*(["ball"] if len(own) < len(balls.ids) else []), *dict.fromkeys(own))


@spelled
def svg(picture: Picture, theme: ThemeName = ThemeName.AUTO, scene: Scene | None = None) -> str:
    """The text of an SVG file that shows `picture`.

    With the `scene` that the picture shows it is kept in the file, which `Scene.load` then reads back as that scene.
    """
    instance("picture", picture, Picture, "a Picture")
    if scene is not None:
        instance("scene", scene, Scene, "a Scene or None")
    painter = SvgPainter(picture.frame, theme, title=picture.panel.name)
    picture.draw(painter)
    words = painter.finish()
    return words if scene is None else with_scene(words, scene.plain())


def looks_of(shapes: Iterable[Shape | Compound | Group]) -> tuple[tuple[Shape, Look], ...]:
    """Each shape with its look, in the order in which they are drawn; parts in place of compounds and groups."""
    listed = parts(shapes)
    return tuple((drawn.shape, drawn.look) for drawn in drawn_of(listed, range(len(listed))))


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
