"""What the shapes and balls of a world are called, how often they were touched, and what those of many parts are."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from carom.rows.pose import pose
from carom.scene.guarding import guarded
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.label import name_of
from carom.world.touches import touches_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from carom.record.recording import Recording
    from carom.rows.tables import Rows
    from carom.scene.scene import Scene
    from carom.shapes.shape import Shape
    from carom.world.world import World

#: What balls that were hit are called together.
BALLS = "ball against ball"


def parts(shapes: Iterable[Shape | Compound | Group]) -> list[Shape]:
    """The single shapes among `shapes`, in order, the parts of compounds and groups in place of these."""
    return [part for shape in shapes for part in (shape.shapes if isinstance(shape, Compound | Group) else (shape,))]


def shapes_of(scene: Scene) -> list[Shape]:
    """New shapes, of no world, as `scene` describes them: single ones, in the order of a world built from it."""
    shapes = [descriptor.build() for descriptor in scene.shapes]
    return parts(guarded(shapes) if scene.guard else shapes)


def put(shape: Shape, x: float, y: float, orientation: float) -> None:
    """Put a shape of no world where its pivot is at (x, y) and it has turned to `orientation`."""
    row = shape._row
    row["pivot_x"], row["pivot_y"], row["orientation"] = x, y, orientation
    pose(row)


def names_in(world: World) -> dict[int, str]:
    """The names of the shapes and balls that have one, by id; an empty one is none."""
    named = [(shape.id, name_of(shape)) for shape in parts(world.shapes)]
    # Balls whose objects nobody has asked for have no names.
    named += [(key, member.name) for key, member in sorted(world._objects.items()) if isinstance(member, Ball)]
    return {member: name for member, name in named if member is not None and name}


def touches_by_label(recording: Recording, hits: Rows) -> list[tuple[str, int]]:
    """How many touches `hits` of a recording were at what, by label, the most first; those of balls count together."""
    return _by_label(recording, touches_of(hits))


def hits_by_label(recording: Recording, hits: Rows) -> list[tuple[str, int]]:
    """The same of the hits themselves."""
    return _by_label(recording, hits)


def _by_label(recording: Recording, rows: Rows) -> list[tuple[str, int]]:
    """How many rows name what as their `shape`, by label, the most first."""
    found: Counter[str] = Counter()
    for member, count in zip(*np.unique(rows["shape"], return_counts=True), strict=True):
        found[BALLS if int(member) in recording.ball_ids else recording.label_of(int(member))] += int(count)
    return sorted(found.items(), key=lambda share: (-share[1], share[0]))
