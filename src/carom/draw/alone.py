"""Shapes, balls and contacts on their own, in a world or in none, as pictures with their numbers beside them."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from carom.draw.paint.painter import Style
from carom.draw.parts.layers import Layer
from carom.draw.parts.looks import Look, look_of
from carom.draw.parts.moment import Balls, Drawn, Measures, Moment
from carom.draw.parts.outlines import part_near
from carom.draw.parts.panel import Panel
from carom.draw.picture import box_around, composed, drawn_of
from carom.draw.theme import BALL_INKS
from carom.record.members import parts
from carom.rows.hit import BOUNCE, HIT
from carom.shapes.aabb import Aabb
from carom.shapes.ball import Ball
from carom.shapes.circle import Circle
from carom.shapes.compound import Compound
from carom.shapes.detection import Contact
from carom.shapes.group import Group
from carom.shapes.label import name_of
from carom.shapes.shape import Shape

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from carom.draw.picture import Picture
    from carom.rows.tables import Rows

#: What has a place and can be seen.
Thing: TypeAlias = Shape | Compound | Group | Ball

#: Pixels: a picture with room for the panel's numbers beside a small stage.
SIZE = (640, 360)
#: In radii of a ball: what is shown around it, and how far from where they touch what it meets is drawn. That keeps it
#: on the stage, for √(1² + 2.2²) < 1 + 1.5.
AROUND, REACH = 1.5, 2.2
LAYERS = frozenset({Layer.SHAPES, Layer.SENSORS, Layer.BALLS, Layer.VELOCITIES})
OF_CONTACT = frozenset({Layer.SHAPES, Layer.SENSORS, Layer.VELOCITIES, Layer.NORMALS, Layer.TANGENTS})
#: The look of balls that others lie behind.
CLEAR = [Look("balls", Style(ink, width=1.8), fill_opacity=0.16) for ink in BALL_INKS]


def picture_alone(thing: Thing | Contact) -> Picture:
    """The picture of one shape, compound, group or ball, as it stands, or of a contact: what met, and where."""
    if isinstance(thing, Contact):
        return picture_of_contact(thing)
    balls = [thing] if isinstance(thing, Ball) else []
    shapes = [] if isinstance(thing, Ball) else parts([thing])
    panel = Panel(called(thing), facts=tuple(numbers_of(thing)))
    return picture(panel, drawn_of(shapes, range(len(shapes))), balls, None, np.zeros(0, HIT), LAYERS)


def picture_of_contact(contact: Contact) -> Picture:
    """A ball with what it meets, and the normal and the tangent where they touch."""
    met, ball = contact.shape, contact.ball
    row = np.zeros(1, HIT)
    row["kind"], row["ball"], row["shape"] = BOUNCE, 1, 2
    row["point"], row["normal"] = contact.point, contact.normal
    row["setback"], row["speed"] = contact.setback, contact.speed
    around = ball.aabb
    margin = AROUND * ball.radius
    box = Aabb(around.left - margin, around.bottom - margin, around.right + margin, around.top + margin)
    facts = (
        ("point", pair(contact.point)),
        ("normal", pair(contact.normal)),
        ("setback", f"{contact.setback:.4g}"),
        ("speed", f"{contact.speed:.4g}"),
    )
    panel = Panel(f"{called(ball)}, {called(met)}", facts=facts)
    balls = [ball, met] if isinstance(met, Ball) else [ball]
    still = [
        Drawn(Circle(one.position, one.radius, solid=True), look, number)
        for number, (one, look) in enumerate(zip(balls, CLEAR, strict=False))
    ]
    if isinstance(met, Shape):
        near = part_near(met, contact.point, REACH * ball.radius)
        still.insert(0, Drawn(near, look_of(met, frozenset()), len(still)))
    return picture(panel, tuple(still), balls, box, row, OF_CONTACT)


def picture(
    panel: Panel,
    still: tuple[Drawn, ...],
    balls: Sequence[Ball],
    box: Aabb | None,
    hits: Rows,
    layers: frozenset[Layer],
) -> Picture:
    """The picture of some shapes and balls, around a `box` of the world or around all of them."""
    columns = Balls(
        np.array([ball.position for ball in balls]).reshape(-1, 2),
        np.array([ball.radius for ball in balls]),
        np.arange(1, len(balls) + 1),
        np.array([ball.velocity for ball in balls]).reshape(-1, 2),
    )
    return composed(
        panel,
        still,
        Moment(0.0, columns, latest=hits),
        box or box_around([(one.shape, one.look) for one in still], columns),
        layers=layers,
        size=SIZE,
        inks=dict(enumerate(BALL_INKS[: len(balls)], 1)),
        names={},
        cells=(),
        measures=Measures.of(hits, columns.velocities),
        of_run=len(hits) > 0,
        empty=[Layer.TRACKS],
    )


def called(thing: Thing) -> str:
    """The name of a thing, or what it is."""
    name = name_of(thing) if isinstance(thing, Shape) else thing.name
    return name or type(thing).__name__


def numbers_of(thing: Thing) -> Iterable[tuple[str, str]]:
    """The numbers that tell one thing from another of its kind."""
    if isinstance(thing, Compound | Group):
        yield "parts", f"{len(thing.shapes):,}"
    if isinstance(thing, Compound):
        yield "pivot", pair(thing.pivot)
    if isinstance(thing, Shape | Ball):
        yield "position", pair(thing.position)
    for attribute in ("radius", "length"):
        if isinstance(thing, Shape | Ball) and hasattr(thing, attribute):
            yield attribute, f"{getattr(thing, attribute):.4g}"
    if isinstance(thing, Ball):
        yield "velocity", pair(thing.velocity)
        yield "mass", f"{thing.mass:.4g}"
    if isinstance(thing, Shape):
        yield "elasticity", f"{thing.elasticity:.4g}"
        if thing.kick:
            yield "kick", f"{thing.kick:.4g}"


def pair(vector: tuple[float, float]) -> str:
    """A vector in few digits."""
    return f"({vector[0]:.4g}, {vector[1]:.4g})"
