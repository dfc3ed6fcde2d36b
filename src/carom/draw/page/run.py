"""What the replay page is given of a run: what is drawn, the columns of what moves, and the words beside it."""

from __future__ import annotations

import json
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np

from carom.draw.history.trace import followed
from carom.draw.page.columns import Units, ball_columns, hit_columns, pose_columns
from carom.draw.page.drawing import (
    Cast,
    draw_cast,
    marks,
    names_of,
    pieces_of,
    samples_into,
    stamps_into,
)
from carom.draw.page.packing import Plain, deflated, measured
from carom.draw.page.painter import PagePainter, plain_style, record_into
from carom.draw.parts.frame import STAGE_SIZE, Frame, longer_side, widened
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer, layers_of
from carom.draw.parts.moment import Balls, Measures, bounces_of
from carom.draw.picture import box_around, weight_for
from carom.draw.theme import BALL_INKS, DARK, LIGHT, PRINT, ThemeName, theme_name
from carom.record.members import touches_by_label
from carom.shapes.aabb import Aabb
from carom.world.hits import HitKind
from carom.world.touches import touches_of

if TYPE_CHECKING:
    from collections.abc import Collection

    from carom.record import Recording

#: The layers in the order of their switches.
SWITCHES = (
    Layer.SHAPES,
    Layer.SENSORS,
    Layer.BALLS,
    Layer.TRACKS,
    Layer.HITS,
    Layer.LIGHTS,
    Layer.NAMES,
    Layer.VELOCITIES,
    Layer.RETICLES,
    Layer.NORMALS,
    Layer.TANGENTS,
    Layer.BOXES,
    Layer.SECTORS,
    Layer.CELLS,
)
#: What a page shows at first: a picture's layers, and what only makes sense while time goes on.
FIRST_LAYERS = DEFAULT_LAYERS | {Layer.LIGHTS}
#: Levels between no energy and the most.
ENERGIES = 2**14
#: How many of the counts of what was hit are listed.
MOST_SHARES = 30


def page_run(recording: Recording, theme: ThemeName, layers: Collection[Layer]) -> Plain:
    """All that the page is given, as JSON can hold it."""
    first = layers_of(layers)
    cast = Cast.of(recording)
    balls = balls_on_stage(recording)
    frame = Frame.around(stage_box(cast, balls), 0.0)
    weight = weight_for(balls, frame)
    painter = PagePainter()
    record_into(painter, frame, lambda painter, frame: draw_cast(painter, frame, cast, weight))
    pieces = pieces_of(painter, cast)
    inks = inks_of(recording)
    return {
        "name": recording.name,
        "about": recording.about,
        "theme": theme_name(theme).value,
        "themes": {named.name: dict(named.inks) for named in (LIGHT, DARK, PRINT)},
        "layers": [{"name": layer, "on": layer in first} for layer in SWITCHES],
        "size": STAGE_SIZE,
        "marks": marks(weight),
        "names": names_of(cast),
        "pieces": deflated(json.dumps(pieces, separators=(",", ":")).encode()),
        "stamps": stamps_into(painter, frame),
        "samples": samples_into(painter, cast, inks),
        "styles": [plain_style(style) for style in painter.styles],
        "shapes": [
            {"label": recording.label_of(int(shape)), "switched": switch}
            for shape, switch in zip(recording.shape_ids, cast.switches, strict=True)
        ],
        "ball_inks": inks,
        "ball_names": [recording.label_of(int(ball)) for ball in recording.ids],
        "named": np.flatnonzero([int(ball) in recording.names for ball in recording.ids]).tolist(),
        "radii": recording.radii.tolist(),
        "followed": np.flatnonzero(np.isin(recording.ids, followed(recording.ids))).tolist(),
        "switches": cast.switch_columns(),
        "energy": energy_column(recording),
        "shares": shares(recording),
        "facts": facts(recording),
        **columns(recording, frame.stage),
    }


def columns(recording: Recording, stage: Aabb) -> Plain:
    """What moves and what happens, and what its sizes are relative to."""
    units = Units.of(recording, stage)
    measures = Measures.of(bounces_of(recording.hits), recording.velocities)
    return {
        "stage": [stage.left, stage.bottom, stage.right, stage.top],
        "times": units.moments(recording.times, 2),
        "balls": ball_columns(recording, units),
        "moving": pose_columns(recording, units),
        "hits": hit_columns(recording, units),
        "strong": {"impulse": measures.impulse, "impact": measures.impact_speed, "speed": measures.speed},
    }


def balls_on_stage(recording: Recording) -> Balls:
    """The balls that the stage is chosen for: those of the first frame, or all of all frames where nothing else is."""
    if len(recording.shape_ids):
        centers, radii, ids = recording.positions[0], recording.radii, recording.ids
    else:
        count = len(recording)
        centers = recording.positions.reshape(-1, 2)
        radii, ids = np.tile(recording.radii, count), np.tile(recording.ids, count)
    there = np.isfinite(centers).all(axis=1)
    return Balls(centers[there], radii[there], ids[there])


def stage_box(cast: Cast, balls: Balls) -> Aabb:
    """The part of the world to show: the shapes, and the balls that begin no farther from them than they span.

    Where none begins so near, as over a short floor, all of them are shown.
    """
    box = box_around([(drawn.shape, drawn.look) for drawn in cast.drawn(colliding=True)], balls)
    wide = widened(box, longer_side(box))
    x, y, radii = *balls.centers.T, balls.radii
    near = (wide.left < x) & (x < wide.right) & (wide.bottom < y) & (y < wide.top)
    near |= not near.any()
    return Aabb(
        float((x - radii).min(where=near, initial=box.left)),
        float((y - radii).min(where=near, initial=box.bottom)),
        float((x + radii).max(where=near, initial=box.right)),
        float((y + radii).max(where=near, initial=box.top)),
    )


def inks_of(recording: Recording) -> list[str]:
    """The ink of each ball: those that are followed have their own."""
    own = dict(zip(followed(recording.ids).tolist(), cycle(BALL_INKS), strict=False))
    return [own.get(int(ball), "ball") for ball in recording.ids]


# -- numbers -----------------------------------------------------------------------------------------------------------


def energy_column(recording: Recording) -> Plain:
    """The kinetic energy at each frame."""
    energy = recording.kinetic_energy()
    return measured(energy, 0.0, float(energy.max()) / ENERGIES or 1.0, 1)


def shares(recording: Recording) -> list[tuple[str, int]]:
    """How many touches there were by what was touched, the most first; shapes of one name count together.

    After the first `MOST_SHARES` comes what is left, as one count without a label.
    """
    listed = touches_by_label(recording, recording.hits)
    rest = sum(count for _, count in listed[MOST_SHARES:])
    return listed[:MOST_SHARES] + ([("", rest)] if rest else [])


def facts(recording: Recording) -> dict[str, str]:
    """The numbers of the whole run: what there was, and the world's counters that are not 0."""
    kinds = recording.hits["kind"]
    counts = {
        "frames": len(recording),
        "balls": len(recording.ids),
        "shapes": len(recording.shape_ids),
        "touches": len(touches_of(recording.hits)),
        "bounces": np.count_nonzero(kinds == HitKind.BOUNCE),
        "sensors entered": np.count_nonzero(kinds == HitKind.ENTER),
    }
    shown = {label: count for label, count in counts.items() if count}
    counters = {name.replace("_", " "): count for name, count in recording.statistics.items() if count}
    return {label: f"{count:,}" for label, count in (shown | counters).items()}
