"""A world that goes on, drawn into surfaces of pygame's frame by frame, as games and demonstrations need it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from carom.checks import instance, refuse, whole
from carom.draw.history.past import Past
from carom.draw.paint.raster import RasterPainter
from carom.draw.parts.cells import partition_of
from carom.draw.parts.frame import LEAST_SIDE, MOST_SIDE, Frame
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer, layers_of
from carom.draw.parts.looks import LOOKS, look_now, material_of
from carom.draw.parts.moment import Balls, Drawn, Measures, Moment
from carom.draw.parts.names import still_labels
from carom.draw.parts.outlines import ends_of
from carom.draw.parts.panel import Panel
from carom.draw.picture import Picture, weight_for
from carom.draw.theme import BALL_INKS, ThemeName
from carom.record.members import names_in, parts
from carom.rows.shape import Motion
from carom.shapes.aabb import Aabb
from carom.shapes.assembly import Assembly
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.world.world import World

if TYPE_CHECKING:
    from collections.abc import Collection

    from carom.draw.parts.looks import Look
    from carom.rows.tables import Rows

#: Seconds of tracks and of hits, and in how many bands tracks fade.
SPAN, LIVE_BANDS = 1.5, 4
#: The greatest zoom.
MOST_ZOOM = 8
#: The ink of balls that sleep.
ASLEEP = "off"
#: The greatest impulse and speeds, which sizes of marks are relative to, are looked at every so many frames; what is
#: left of them then.
LOOK, FADING = 10, 0.9


@spelled
class Live:
    """Draws a world as it stands, with the tracks and hits of the steps that it was told of.

    What stays is drawn once and kept, the rest anew each time: shapes that move, those in `changing`, which are
    switched on and off meanwhile, and balls; those that sleep are grey.

    Args:
        world: The world.
        box: The part of it to show, in its units.
        size: Width and height in pixels; the box is shown as large as fits, in the middle.
        layers: What to show; can be set at any time.
        theme: Its colours.
        changing: Shapes at rest that are switched on and off.
        zoom: How many pixels wide the thinnest lines are; marks and letters are as many times as large.

    Raises:
        MissingExtra: pygame is not installed.
        InvalidArgument: There is no such size, layer or zoom, or the box has no width or no height.

    >>> import carom, pygame
    >>> from carom import draw
    >>> world = carom.scenes.toy().build()
    >>> live = draw.Live(world, carom.Aabb(-1, -1, 33, 25), (680, 520))
    >>> surface = pygame.Surface((680, 520))
    >>> for _ in range(3):
    ...     live.note(world.step(1 / 60))
    ...     live.draw(surface)
    """

    def __init__(
        self,
        world: World,
        box: Aabb,
        size: tuple[int, int],
        *,
        layers: Collection[Layer] = DEFAULT_LAYERS,
        theme: ThemeName = ThemeName.DARK,
        changing: Collection[Shape] = (),
        zoom: int = 1,
    ) -> None:
        instance("world", world, World, "a World")
        instance("box", box, Aabb, "an Aabb")
        for side in _sides(size):
            whole("size", side, LEAST_SIDE, MOST_SIDE)
        whole("zoom", zoom, 1, MOST_ZOOM)
        if box.right <= box.left or box.top <= box.bottom:
            raise refuse("box", "must have a width and a height", box)
        self.frame = frame_around(box, size, zoom)
        self._world = world
        self._past = Past(world, SPAN)
        self._painter = RasterPainter(self.frame, theme)
        self._own = self._painter.surface
        self._changing = _ids_of(changing)
        self._layers = layers_of(layers)
        self._measures = Measures(1.0, 1.0, 1.0)
        self._frames = 0
        self.refresh()

    @property
    def layers(self) -> frozenset[Layer]:
        """What is shown."""
        return self._layers

    @layers.setter
    def layers(self, layers: Collection[Layer]) -> None:
        self._layers = layers_of(layers)
        self.refresh()

    def note(self, hits: Rows) -> None:
        """Remember the `hits` of a step that was just made, and where the balls are now.

        Raises `InvalidArgument` where these are none, or those of another world.
        """
        self._past.note(hits)

    def forget(self) -> None:
        """Forget tracks and hits."""
        self._past.forget()

    def refresh(self) -> None:
        """Look anew at what stays as it is. To be called when shapes or the broad phase were changed."""
        shapes = parts(self._world.shapes)
        ends = ends_of(shapes)
        materials = [(shape, material_of(shape, ends)) for shape in shapes]
        ordered = sorted(materials, key=lambda pair: LOOKS.index(pair[1]))
        self._moving = [(shape, material) for shape, material in ordered if self._changes(shape)]
        still = [drawn(shape, material) for shape, material in ordered if not self._changes(shape)]
        balls = Balls.of(self._world)
        names = names_in(self._world) if Layer.NAMES in self._layers else {}
        self._picture = Picture(
            Panel("", "", ()),
            self.frame,
            self._layers,
            tuple(still),
            Moment(self._world.time, balls),
            {},
            names,
            partition_of(self._world).cells if Layer.CELLS in self._layers else (),
            self._measures,
            weight_for(balls, self.frame),
            of_run=True,
            bands=LIVE_BANDS,
            labels=still_labels(self.frame, names, still, balls),
        )
        self._kept: Any = None

    def _changes(self, shape: Shape) -> bool:
        """Whether a shape is to be drawn anew each time."""
        return shape.motion == Motion.KINEMATIC or shape.id in self._changing

    def draw(self, surface: Any) -> None:
        """Draw the world into a surface of the size that was given."""
        if self._kept is None:
            self._kept = self._own.copy()
            self.draw_still(self._kept)
        surface.blit(self._kept, (0, 0))
        self.draw_moving(surface)

    @spelled
    def draw_still(self, surface: Any, *, ground: bool = True) -> None:
        """Draw what stays, over the paper, or over what is there where `ground` is False."""
        self._painter.surface, self._painter.quick = surface, False
        picture = self._picture
        if ground:
            picture.draw_still(self._painter)
        else:
            picture.draw_still_shapes(self._painter)

    def draw_moving(self, surface: Any) -> None:
        """Draw what moves, over what is there."""
        self._painter.surface, self._painter.quick = surface, True
        balls = Balls.of(self._world)
        tracks = self._past.tracks() if Layer.TRACKS in self._layers else ()
        hits, latest = self._past.hits, self._past.latest
        if self._frames % LOOK == 0:
            self._measures = slowly(self._measures, Measures.of(hits, balls.velocities))
        self._frames += 1
        moment = Moment(
            self._world.time,
            balls,
            tuple(drawn(shape, material) for shape, material in self._moving),
            tracks,
            max(0.0, self._past.since),
            hits,
            latest,
        )
        replace(self._picture, moment=moment, inks=self._inks(balls), measures=self._measures).draw_moving(
            self._painter
        )

    def _inks(self, balls: Balls) -> dict[int, str]:
        """The inks of balls that have one of their own."""
        followed = [ball for ball in self._past.followed or balls.ids.tolist() if ball]
        inks = {ball: BALL_INKS[ball % len(BALL_INKS)] for ball in followed}
        if self._world.statistics.sleeping:
            inks |= {ball.id or 0: ASLEEP for ball in self._world.balls if ball.asleep}
        return inks


def frame_around(box: Aabb, size: tuple[int, int], zoom: int) -> Frame:
    """The frame that shows `box` as large as fits in a picture of a size, and nothing else."""
    width, height = (side / zoom for side in size)
    scale = min(width / (box.right - box.left), height / (box.top - box.bottom))
    left = 0.5 * (width - (box.right - box.left) * scale)
    top = 0.5 * (height - (box.top - box.bottom) * scale)
    return Frame(width, height, box, scale, left, top, panel=False, zoom=zoom)


def drawn(shape: Shape, material: Look) -> Drawn:
    """A shape as it is to be drawn now."""
    return Drawn(shape, look_now(shape, material), shape.id or 0, shape._whole)


def slowly(before: Measures, now: Measures) -> Measures:
    """What sizes are relative to now, when they were relative to something else before."""
    return Measures(
        max(now.impulse, FADING * before.impulse),
        max(now.impact_speed, FADING * before.impact_speed),
        max(now.speed, FADING * before.speed),
    )


def _sides(size: Any) -> tuple[Any, Any]:
    """Width and height, whatever they are; raises `InvalidArgument` where there are no two."""
    try:
        width, height = size
    except (TypeError, ValueError):
        raise refuse("size", "must be width and height in pixels", size) from None
    return width, height


def _ids_of(shapes: Any) -> frozenset[int | None]:
    """The ids of shapes; raises `InvalidArgument` where they are none."""
    try:
        given = list(shapes)
    except TypeError:
        given = [None]
    if not all(isinstance(shape, (Shape, Assembly)) for shape in given):
        raise refuse("changing", "must be shapes", shapes)
    return frozenset(shape.id for shape in given)
