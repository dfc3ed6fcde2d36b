"""What the panel says of a picture: the legend with a sample of each mark, the numbers, and what is left out."""

from __future__ import annotations

from functools import partial
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.trace import MOST_HITS
from carom.draw.history.tracks import BANDS
from carom.draw.paint.painter import Style
from carom.draw.parts.cells import EDGE
from carom.draw.parts.layers import Layer
from carom.draw.parts.looks import GATE, GUARD, LOOKS, MOVING, POST, SENSOR, Look
from carom.draw.parts.marks import (
    NORMAL,
    TANGENT,
    VELOCITY,
    arrow_mark,
    ball_mark,
    box_mark,
    hit_mark,
    long_arrow_mark,
    pivot_mark,
    reticle_mark,
    track_style,
)
from carom.draw.parts.outlines import glow_mark, sector_mark
from carom.draw.parts.panel import GLYPH_WIDTH
from carom.shapes.aabb import Aabb
from carom.shapes.arc import Arc
from carom.shapes.segment import Segment

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from carom.draw.history.trace import Trace
    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.cells import Cell
    from carom.draw.parts.frame import Frame
    from carom.draw.parts.panel import Glyph
    from carom.world.world import World

#: How many balls of different inks the sample of balls shows.
SAMPLE_BALLS = 3
HALF = 0.5 * GLYPH_WIDTH
#: Pixels: the radius of a sample ball; where a sample gate stands left of the middle, and half of its length.
BALL = 6.0
GATE_OFFSET, HALF_GATE = 6.0, 7.0


def look_sample(look: Look) -> Glyph:
    """The sample of a material: a line of it, or its dot, with the pivot or the arrow that belongs to it."""
    return partial(_draw_look, look)  # what is drawn can be pickled, as a function within this one could not


def _draw_look(look: Look, painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of a material."""
    x, y = middle
    if look in (POST, GUARD):
        painter.circle(frame.world(x, y), frame.units(look.dot), look.spot())
        return
    if look == GATE:
        painter.segment(
            frame.world(x - GATE_OFFSET, y - HALF_GATE), frame.world(x - GATE_OFFSET, y + HALF_GATE), look.style
        )
        arrow_mark(painter, frame, frame.world(x - GATE_OFFSET, y), (1.0, 0.0), look.style)
        return
    painter.segment(frame.world(x - HALF, y), frame.world(x + HALF, y), look.style)
    if look == MOVING:
        pivot_mark(painter, frame, frame.world(x - HALF, y))


def ball_sample(inks: Sequence[str]) -> Glyph:
    """The sample of balls: one to three of them, by the inks in use."""
    return partial(_draw_balls, inks)


def _draw_balls(inks: Sequence[str], painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of balls."""
    for number, ink in enumerate(inks):
        x = middle[0] + 1.2 * BALL * (number - 0.5 * (len(inks) - 1))
        ball_mark(painter, frame, frame.world(x, middle[1]), frame.units(BALL), ink)


def track_sample(ink: str) -> Glyph:
    """The sample of a track: a line that fades to the left."""
    return partial(_draw_track, ink)


def _draw_track(ink: str, painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of a track."""
    edges = np.linspace(middle[0] - HALF, middle[0] + HALF, BANDS + 1)
    for band in range(BANDS):
        ends = [frame.world(float(x), middle[1]) for x in edges[band : band + 2]]
        painter.polyline(np.array(ends), track_style(ink, band))


def hit_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of hit points: weak, middling, strong."""
    for strength, offset in ((0.0, -8.0), (0.3, 0.0), (1.0, 10.0)):
        hit_mark(painter, frame, frame.world(middle[0] + offset, middle[1]), strength, 1.0)


def box_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of boxes."""
    box_mark(painter, pixel_box(frame, middle, 10.0, 6.0))


def cell_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of cells: three beside each other, that hold more and more."""
    for place, opacity in enumerate((0.08, 0.17, 0.3)):
        box = pixel_box(frame, (middle[0] + 9.0 * (place - 1), middle[1]), 4.5, 6.0)
        box_mark(painter, box, Style(fill="cell", opacity=opacity))
        box_mark(painter, box, EDGE)


def pixel_box(frame: Frame, middle: Vector, half_width: float, half_height: float) -> Aabb:
    """The box that is so many pixels wide and high, as a box of the world."""
    left, bottom = frame.world(middle[0] - half_width, middle[1] + half_height)
    return Aabb(left, bottom, left + frame.units(2.0 * half_width), bottom + frame.units(2.0 * half_height))


def sector_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of sectors."""
    sector_mark(painter, Arc(frame.world(middle[0], middle[1] + 9.0), frame.units(18.0), 0.2 * pi, 0.8 * pi))


def glow_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of what was just hit."""
    ends = (frame.world(middle[0] + x, middle[1]) for x in (-0.8 * HALF, 0.8 * HALF))
    glow_mark(painter, frame, Segment(next(ends), next(ends)), 1.0, 0.6)


def tangent_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of tangents."""
    painter.segment(frame.world(middle[0] - HALF, middle[1]), frame.world(middle[0] + HALF, middle[1]), TANGENT)


def arrow_sample(style: Style) -> Glyph:
    """The sample of normals or of velocities: an arrow."""
    return partial(_draw_arrow, style)


def _draw_arrow(style: Style, painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of an arrow."""
    long_arrow_mark(painter, frame, frame.world(middle[0] - 0.9 * HALF, middle[1]), (1.0, 0.0), 1.8 * HALF, style)


def reticle_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of reticles."""
    reticle_mark(painter, frame, frame.world(*middle), 0.25 * pi, 1.0)


#: What is said of a layer whose marks look alike everywhere, and its sample.
ENTRIES: dict[Layer, tuple[str, Glyph]] = {
    Layer.HITS: ("hit, sized by its impulse", hit_sample),
    Layer.LIGHTS: ("was just hit", glow_sample),
    Layer.RETICLES: ("turns by speed of impact", reticle_sample),
    Layer.NORMALS: ("normal", arrow_sample(NORMAL)),
    Layer.TANGENTS: ("tangent", tangent_sample),
    Layer.VELOCITIES: ("velocity", arrow_sample(VELOCITY)),
    Layer.SECTORS: ("sector of an arc", sector_sample),
    Layer.BOXES: ("box", box_sample),
    Layer.CELLS: ("cell of the broad phase", cell_sample),
}


def legend(looks: Collection[Look], inks: Sequence[str], shown: Collection[Layer]) -> tuple[tuple[str, Glyph], ...]:
    """The entries for the `looks` that occur, for balls of some `inks`, and for what else is `shown`."""
    layer_of = {look: Layer.SENSORS if look == SENSOR else Layer.SHAPES for look in LOOKS}
    entries = [(look.label, look_sample(look)) for look in LOOKS if look in looks and layer_of[look] in shown]
    if inks and Layer.BALLS in shown:
        entries.append(("balls", ball_sample(inks[:SAMPLE_BALLS])))
    if inks and Layer.TRACKS in shown:
        entries.append(("track, fading with age", track_sample(inks[-1])))
    return (*entries, *(entry for layer, entry in ENTRIES.items() if layer in shown))


def facts(world: World, trace: Trace | None) -> tuple[tuple[str, str], ...]:
    """The panel's numbers: what there is, or what happened in the run that was followed."""
    balls = ("balls", f"{len(world.balls):,}")
    if trace is None:
        return ("shapes", f"{len(world.shapes):,}"), balls
    lines = [("time", seconds(world.time)), balls, ("hits", f"{trace.bounces:,}")]
    strays = world.statistics.strays
    return (*lines, ("strays", f"{strays:,}")) if strays else tuple(lines)


def remarks(
    layers: Collection[Layer], tracked: int, balls: int, span: float, bounces: int, cells: Collection[Cell]
) -> tuple[str, ...]:
    """What a picture leaves out, in words.

    Args:
        layers: What it shows.
        tracked: How many balls have tracks.
        balls: Of how many.
        span: Over how many seconds.
        bounces: How many hits there are to show.
        cells: The cells of the broad phase.
    """
    lines = []
    if tracked and Layer.TRACKS in layers:
        whose = "all balls" if tracked == balls else f"{tracked} of {balls:,} balls"
        lines.append(f"Tracks of {whose}, over the last {seconds(span)}.")
    if bounces > MOST_HITS and Layer.HITS in layers:
        lines.append(f"Of the hits, the {MOST_HITS:,} strongest are shown.")
    if Layer.CELLS in layers and not cells:
        lines.append("There are no cells: every ball is tested against every shape.")
    return tuple(lines)


def unnamed(left_out: int) -> tuple[str, ...]:
    """The line on names that found no room, if there are such; it is short enough for the panel."""
    return (f"{left_out:,} {'name has' if left_out == 1 else 'names have'} no room.",) if left_out else ()


def seconds(time: float) -> str:
    """A time to the hundredth of a second, in one word."""
    return f"{time:,.2f}".rstrip("0").rstrip(".") + "\N{NO-BREAK SPACE}s"
