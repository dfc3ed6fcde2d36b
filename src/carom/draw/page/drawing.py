"""What the replay page draws, as recorded calls of painters: shapes that stand or move, stamps for what happens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.tracks import BANDS
from carom.draw.page.packing import Plain, packed
from carom.draw.page.painter import PagePainter, record_into
from carom.draw.parts.cells import cells_of, draw_cells
from carom.draw.parts.frame import Frame
from carom.draw.parts.impacts import FIRST_ANGLE, GLOW_TIME, HALF_TANGENT, NORMAL_LENGTH, TURN
from carom.draw.parts.labels import FARTHER, GAP, SIDES, SLANT
from carom.draw.parts.layers import Layer
from carom.draw.parts.legend import (
    SAMPLE_BALLS,
    arrow_sample,
    ball_sample,
    box_sample,
    cell_sample,
    glow_sample,
    hit_sample,
    look_sample,
    reticle_sample,
    sector_sample,
    tangent_sample,
    track_sample,
)
from carom.draw.parts.looks import LOOKS, MOVING, SENSOR, rounded
from carom.draw.parts.marks import (
    BOX,
    LARGEST_HIT,
    NORMAL,
    SMALLEST_HIT,
    TANGENT,
    TRACK_WIDTH,
    VELOCITY,
    long_arrow_mark,
    pivot_mark,
    reticle_mark,
    track_style,
)
from carom.draw.parts.moment import LATEST
from carom.draw.parts.names import AROUND, CLEAR, GROUND, LABEL, LEADER, MOST_BALLS, MOST_PLACES, shared_label
from carom.draw.parts.outlines import GLOW, anchor, has_sector, sector_mark, shape_mark, sign_mark
from carom.draw.parts.panel import GLYPH_WIDTH
from carom.draw.parts.scenery import FAST_ARROW, SHORTEST_ARROW, draw_boxes
from carom.draw.picture import drawn_of
from carom.shapes.aabb import Aabb

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.draw.paint.painter import Painter
    from carom.draw.parts.moment import Drawn
    from carom.draw.parts.panel import Glyph
    from carom.record import Recording
    from carom.shapes.shape import Shape

#: Pixels: the height of a sample of the legend.
SAMPLE_HEIGHT = 24.0
#: Pixels by which the arrows differ that stand for velocities.
ARROW_STEP = 2.0


@dataclass(frozen=True, slots=True)
class Cast:
    """Who plays: the shapes as they stood at frame 0, and for each its mover and its switch, or -1."""

    recording: Recording
    shapes: list[Shape]
    movers: list[int]
    switches: list[int]

    @classmethod
    def of(cls, recording: Recording) -> Cast:
        """The shapes of a recording; those that begin or cease to collide are switched."""
        movers = {int(shape): place for place, shape in enumerate(recording.moving)}
        changes = recording.colliding.any(axis=0) & ~recording.colliding.all(axis=0)
        switches = np.where(changes, np.cumsum(changes) - 1, -1).tolist()
        listed = [movers.get(int(shape), -1) for shape in recording.shape_ids]
        return cls(recording, recording.shapes_at(0), listed, switches)

    def drawn(self, *, colliding: bool) -> list[Drawn]:
        """The shapes in the order in which they are drawn, numbered; those that are switched are all on, or all off."""
        for shape, switch in zip(self.shapes, self.switches, strict=True):
            if switch >= 0:
                shape.can_collide = colliding
        return list(drawn_of(self.shapes, range(len(self.shapes))))

    def switch_columns(self) -> Plain:
        """Whether the switched shapes collide at each frame: a row for each of them."""
        switched = [place for place, switch in enumerate(self.switches) if switch >= 0]
        return packed(self.recording.colliding[:, switched].T, 1)


def draw_cast(painter: Painter, frame: Frame, cast: Cast, weight: float) -> None:
    """Draw all that stands still or moves as a whole, each shape in layers of its own.

    A layer's name says the page's layer, the number of the shape or -1, and `on`, or `off` for how a shape looks while
    it does not collide.
    """
    shapes = cast.drawn(colliding=True)
    painter.layer(f"{Layer.CELLS} -1 on")
    largest = float(cast.recording.radii.max(initial=0.0))
    draw_cells(painter, cells_of(cast.recording.scene, largest), frame.stage)
    painter.layer(f"{Layer.BOXES} -1 on")
    draw_boxes(painter, [drawn for drawn in shapes if cast.movers[drawn.id] < 0])
    for drawn in shapes:
        if has_sector(drawn.shape):
            painter.layer(f"{Layer.SECTORS} {drawn.id} on")
            sector_mark(painter, drawn.shape)
    draw_shapes(painter, frame, shapes, weight, "on")
    off = [drawn for drawn in cast.drawn(colliding=False) if cast.switches[drawn.id] >= 0]
    draw_shapes(painter, frame, off, weight, "off")


def draw_shapes(painter: Painter, frame: Frame, shapes: Sequence[Drawn], weight: float, state: str) -> None:
    """Draw shapes, then their signs: the arrows of gates, and the pivots of moving parts, each of these once."""
    for drawn in shapes:
        painter.layer(f"{layer_of(drawn)} {drawn.id} {state}")
        shape_mark(painter, frame, drawn.shape, drawn.look, weight)
    pivots = set()
    for drawn in shapes:
        painter.layer(f"{layer_of(drawn)} {drawn.id} {state} sign")
        sign_mark(painter, frame, drawn.shape)
        if drawn.look == MOVING and rounded(drawn.shape.pivot) not in pivots:
            pivots.add(rounded(drawn.shape.pivot))
            pivot_mark(painter, frame, drawn.shape.pivot)


def layer_of(drawn: Drawn) -> Layer:
    """The layer that a shape belongs to."""
    return Layer.SENSORS if drawn.look == SENSOR else Layer.SHAPES


def pieces_of(painter: PagePainter, cast: Cast) -> list[Plain]:
    """What `draw_cast` drew, piece by piece in order: calls, their layer, the shape that they show and its mover."""
    pieces = []
    for name, calls in painter.layers.items():
        layer, number, state, *sign = name.split()
        if state == "on" and calls:
            shape = int(number)
            off = painter.layers.get(" ".join([layer, number, "off", *sign]), [])
            mover = cast.movers[shape] if shape >= 0 else -1
            pieces.append({"layer": layer, "shape": shape, "mover": mover, "on": calls, "off": off})
    return pieces


# -- marks -------------------------------------------------------------------------------------------------------------


def stamps_into(painter: PagePainter, frame: Frame) -> Plain:
    """Marks of what happens, drawn at (0, 0) and along +x, for the page to set anywhere; styles go to `painter`."""
    arrows = np.arange(SHORTEST_ARROW, 2.0 * FAST_ARROW + ARROW_STEP, ARROW_STEP).tolist()

    def draw(painter: Painter, frame: Frame) -> None:
        half = frame.units(HALF_TANGENT)
        painter.layer("reticle")
        reticle_mark(painter, frame, (0.0, 0.0), 0.0, 1.0)
        painter.layer("normal")
        long_arrow_mark(painter, frame, (0.0, 0.0), (1.0, 0.0), NORMAL_LENGTH, NORMAL)
        painter.layer("tangent")
        painter.segment((0.0, -half), (0.0, half), TANGENT)
        for pixels in arrows:
            painter.layer(f"arrow {pixels}")
            long_arrow_mark(painter, frame, (0.0, 0.0), (1.0, 0.0), pixels, VELOCITY)

    record_into(painter, frame, draw)
    return {
        **{name: painter.layers[name] for name in ("reticle", "normal", "tangent")},
        "arrows": [painter.layers[f"arrow {pixels}"] for pixels in arrows],
        "arrow_step": ARROW_STEP,
        "shortest_arrow": SHORTEST_ARROW,
        "fast_arrow": FAST_ARROW,
        "latest": LATEST,
        "turn": TURN,
        "first_angle": FIRST_ANGLE,
    }


def marks(weight: float) -> Plain:
    """How large and how strong the marks are whose number or form changes in every frame."""
    return {
        "hit": {"smallest": SMALLEST_HIT * weight, "largest": LARGEST_HIT * weight},
        "track": {"width": TRACK_WIDTH, "bands": [track_style("ball", band).opacity for band in range(BANDS)]},
        "glow": {"strokes": GLOW, "seconds": GLOW_TIME, "weight": max(weight, 0.6)},
        "box": {"ink": BOX.stroke, "width": BOX.width, "dash": BOX.dash},
        "label": {
            "ink": LABEL.ink, "size": LABEL.size, "around": AROUND, "gap": GAP,
            "ground": GROUND.fill, "opacity": GROUND.opacity, "clear": CLEAR, "most_balls": MOST_BALLS,
            "farther": [0.0, *FARTHER], "sides": SIDES, "slant": SLANT,
            "leader": LEADER.stroke, "leader_width": LEADER.width,
        },
    }  # fmt: skip


def names_of(cast: Cast) -> list[Plain]:
    """The names of shapes, each once: where the shapes stand that have it, or one of them if they move."""
    groups: dict[tuple[str, bool], list[int]] = {}
    for number, key in enumerate(cast.recording.shape_ids.tolist()):
        if key in cast.recording.names:
            groups.setdefault((cast.recording.names[key], cast.movers[number] >= 0), []).append(number)
    return [
        {
            "words": shared_label(name, [shape._whole or shape for shape in map(cast.shapes.__getitem__, members)]),
            "mover": cast.movers[members[0]],
            "places": [list(anchor(cast.shapes[member])) for member in members[: 1 if moves else MOST_PLACES]],
        }
        for (name, moves), members in groups.items()
    ]


def samples_into(painter: PagePainter, cast: Cast, inks: Sequence[str]) -> Plain:
    """Samples of what each layer shows; styles go to `painter`."""
    looks = {drawn.look for drawn in cast.drawn(colliding=True)} | {drawn.look for drawn in cast.drawn(colliding=False)}
    glyphs: dict[Layer, list[tuple[str, Glyph]]] = {
        Layer.SHAPES: [(look.label, look_sample(look)) for look in LOOKS if look in looks and look != SENSOR],
        Layer.SENSORS: [("", look_sample(SENSOR))],
        Layer.BALLS: [("", ball_sample(list(dict.fromkeys(inks or ["ball"]))[:SAMPLE_BALLS]))],
        Layer.TRACKS: [("", track_sample(inks[0] if inks else "ball"))],
        Layer.HITS: [("", hit_sample)],
        Layer.LIGHTS: [("", glow_sample)],
        Layer.VELOCITIES: [("", arrow_sample(VELOCITY))],
        Layer.NORMALS: [("", arrow_sample(NORMAL))],
        Layer.TANGENTS: [("", tangent_sample)],
        Layer.RETICLES: [("", reticle_sample)],
        Layer.BOXES: [("", box_sample)],
        Layer.SECTORS: [("", sector_sample)],
        Layer.CELLS: [("", cell_sample)],
    }
    half_width, half_height = 0.5 * GLYPH_WIDTH, 0.5 * SAMPLE_HEIGHT
    stage = Aabb(-half_width, -half_height, half_width, half_height)
    frame = Frame(GLYPH_WIDTH, SAMPLE_HEIGHT, stage, 1.0, 0.0, 0.0)
    samples: Plain = {}
    for layer, entries in glyphs.items():
        samples[layer] = []
        for label, glyph in entries:
            painter.layer(f"{layer} {label} sample")
            glyph(painter, frame, (half_width, half_height))
            samples[layer].append({"label": label, "calls": painter.layers[f"{layer} {label} sample"]})
    return samples
