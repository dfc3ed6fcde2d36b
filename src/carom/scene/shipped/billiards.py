"""Billiards of the textbooks: closed tables in which balls keep what they were given.

The balls of a billiard do not meet each other. They start from one place in directions that differ by little, and all
that is given back is what was taken: energy stays the same to the last digits. `carom.study` measures such tables.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, atan2, cos, pi, sin, sqrt, tan

from carom.checks import non_negative, positive, refuse, whole
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.scene import Scene
from carom.scene.shipped.outline import polar
from carom.shapes import outlines
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.typing import Vector

BALLS = 5
SPREAD = 1e-3  # radians between one ball's direction and the next one's
DIRECTION = 0.7
SPEED = 4.0
BALL_RADIUS = 0.08
BALL_SHARE = 0.2  # of what is free around the start: a ball is no larger
MARGIN = 1.0  # of the bounds around the table

BALL_LAYER, WALL_LAYER = 2, 1

GRAVITY = 9.8
FALL = 0.4  # of the wedge's height, from which its balls fall
MOST_PETALS = 1000


@spelled
def stadium(length: float = 4.0, radius: float = 2.0) -> Scene:
    """Bunimovich's stadium: two half circles joined by straight walls, and five balls that start almost alike.

    `length` is that of a straight wall, and may be 0, which is a circle. Source: L. A. Bunimovich, On the ergodic
    properties of nowhere dispersing billiards, 1979.
    """
    half, size = 0.5 * non_negative("length", length), positive("radius", radius)
    right = Arc((half, 0.0), size, -pi / 2.0, pi / 2.0, name="right half circle")
    left = Arc((-half, 0.0), size, pi / 2.0, -pi / 2.0, name="left half circle")
    straight = []
    if half > 0.0:
        low, high = -pi / 2.0, pi / 2.0
        straight = [
            Segment(polar((-half, 0.0), size, low), polar((half, 0.0), size, low), name="lower wall"),
            Segment(polar((half, 0.0), size, high), polar((-half, 0.0), size, high), name="upper wall"),
        ]
    return _billiard("stadium", [right, left, *straight], (-0.5 * half, 0.15 * size))


@spelled
def sinai(side: float = 4.0, radius: float = 1.0) -> Scene:
    """Sinai's billiard: a square room round a solid disc, and five balls that start almost alike.

    `radius` is the disc's, less than half the `side`. Source: Ya. G. Sinai, Dynamical systems with elastic
    reflections, 1970.
    """
    half = 0.5 * positive("side", side)
    disc = _below("radius", positive("radius", radius), half, "half the side")
    square = outlines.rectangle(-half, -half, half, half, guard=False, name="wall")
    walls = [*square, Circle((0.0, 0.0), disc, solid=True, name="disc")]
    start = (-0.75 * half, -0.6 * half) if disc < 0.8 * half else (-0.85 * half, -0.85 * half)
    return _billiard("sinai", walls, start, direction=0.9)


@spelled
def circle(radius: float = 2.0) -> Scene:
    """A round room, in which every ball keeps its angle of incidence, and five balls that start almost alike."""
    size = positive("radius", radius)
    return _billiard("circle", [Circle((0.0, 0.0), size, name="wall")], (-0.5 * size, 0.15 * size))


@spelled
def rectangle(width: float = 6.0, height: float = 4.0) -> Scene:
    """A rectangular room, in which every ball keeps four directions, and five balls that start almost alike."""
    wide, high = 0.5 * positive("width", width), 0.5 * positive("height", height)
    walls = outlines.rectangle(-wide, -high, wide, high, guard=False, name="wall")
    return _billiard("rectangle", walls, (-0.5 * wide, 0.15 * high))


@spelled
def ellipse(width: float = 6.0, height: float = 4.0, tolerance: float = 1e-9) -> Scene:
    """An ellipse of tangent arcs, in which all ways touch one conic, and five balls that start almost alike.

    No place of the ellipse is farther than `tolerance` from the arcs, in parts of its greater axis. Source: G. D.
    Birkhoff, Dynamical systems, 1927, chapter 8: the product of the angular momenta about the two foci is kept.
    """
    a, b = 0.5 * positive("width", width), 0.5 * positive("height", height)
    within = positive("tolerance", tolerance) * 2.0 * max(a, b)
    quarter = outlines.fit(
        lambda t: (a * cos(0.5 * pi * t), b * sin(0.5 * pi * t)),
        within,
        lambda t: (-0.5 * pi * a * sin(0.5 * pi * t), 0.5 * pi * b * cos(0.5 * pi * t)),
        guard=False,
    )
    bows = [(bow.center, bow.radius, bow.angles) for bow in quarter if isinstance(bow, Arc)]
    walls = [
        *(Arc((x, y), r, begin, end, name="wall") for (x, y), r, (begin, end) in bows),
        *(Arc((-x, y), r, pi - end, pi - begin, name="wall") for (x, y), r, (begin, end) in reversed(bows)),
        *(Arc((-x, -y), r, pi + begin, pi + end, name="wall") for (x, y), r, (begin, end) in bows),
        *(Arc((x, -y), r, -end, -begin, name="wall") for (x, y), r, (begin, end) in reversed(bows)),
    ]
    # Its arcs continue each other, so that no end needs a point, and looking for one would take as long as all else.
    return _billiard("ellipse", walls, (-0.5 * a, 0.15 * b)).model_copy(update={"guard": False})


@spelled
def annulus(outer: float = 2.0, inner: float = 0.8, offset: float = 0.6) -> Scene:
    """A round room round a solid disc that is not in its middle, and five balls that start almost alike.

    `outer` and `inner` are the radii, `offset` is how far the disc's centre is right of the room's, so far at most that
    the two do not touch. Source: N. Saitô and others, Order, chaos and quantum chaos in a billiard, 1982.
    """
    room, disc = positive("outer", outer), positive("inner", inner)
    _below("inner", disc, room, "the outer radius")
    aside = _below("offset", non_negative("offset", offset), room - disc, "the difference of the radii")
    walls = [
        Circle((0.0, 0.0), room, name="wall"),
        Circle((aside, 0.0), disc, solid=True, name="disc"),
    ]
    gap = room + aside - disc
    return _billiard("annulus", walls, (-room + 0.5 * gap, 0.1 * gap))


@spelled
def lemon(radius: float = 3.0, distance: float = 2.0) -> Scene:
    """A lemon: what two equal discs have in common, and five balls that start almost alike.

    `distance` is that of the two centres, less than twice the `radius`. Source: E. J. Heller and S. Tomsovic,
    Postmodern quantum mechanics, 1993.
    """
    size = positive("radius", radius)
    half = 0.5 * _below("distance", positive("distance", distance), 2.0 * size, "twice the radius")
    reach = acos(half / size)
    walls = [
        Arc((-half, 0.0), size, -reach, reach, name="right bow"),
        Arc((half, 0.0), size, pi - reach, pi + reach, name="left bow"),
    ]
    room = size - half
    return _billiard("lemon", walls, (-0.3 * room, 0.1 * room))


@spelled
def flower(petals: int = 5, radius: float = 1.0, distance: float = 1.2) -> Scene:
    """A flower: the outline of discs on a ring that overlap each other, and five balls that start almost alike.

    `petals` (3 to 1,000) discs of `radius`, their centres at the `distance` from the middle. Every arc's circle lies
    in the table, so that it is chaotic. Source: L. A. Bunimovich, On ergodic properties of certain billiards, 1974.
    """
    count, size, far = (
        whole("petals", petals, 3, MOST_PETALS),
        positive("radius", radius),
        positive("distance", distance),
    )
    turn = pi / count
    _below("distance", far, size / sin(turn), "what leaves no gap between two petals")
    corner = far * cos(turn) + sqrt(size * size - far * far * sin(turn) * sin(turn))
    # Seen from a petal's centre: the angle between the way out of the flower and the corner with the next petal.
    half = atan2(corner * sin(turn), corner * cos(turn) - far)
    angles = [2.0 * turn * place for place in range(count)]
    walls = [Arc(polar((0.0, 0.0), far, way), size, way - half, way + half, name="petal") for way in angles]
    return _billiard("flower", walls, (-0.25 * corner, 0.1 * corner))


@spelled
def mushroom(radius: float = 2.0, width: float = 1.6, height: float = 2.0) -> Scene:
    """Bunimovich's mushroom: a half disc on a stem, order beside chaos, and five balls that start almost alike.

    `radius` is the cap's, `width` (less than the cap's) and `height` are the stem's. Balls whose way stays farther
    from the middle of the cap than half the stem's width never leave it; all others are chaotic. Source: L. A.
    Bunimovich, Mushrooms and other billiards with divided phase space, 2001.
    """
    cap, deep = positive("radius", radius), positive("height", height)
    half = 0.5 * _below("width", positive("width", width), 2.0 * cap, "the cap's diameter")
    below = [(-cap, 0.0), (-half, 0.0), (-half, -deep), (half, -deep), (half, 0.0), (cap, 0.0)]
    walls = [
        *outlines.polyline(below, guard=False, name="stem"),
        Arc((0.0, 0.0), cap, 0.0, pi, name="cap"),
    ]
    return _billiard("mushroom", walls, (-0.3 * half, 0.3 * cap), direction=0.9)


@spelled
def wedge(angle: float = pi / 4.0, height: float = 4.0) -> Scene:
    """A wedge under gravity, its edge down, with a lid that nothing reaches, and five balls that start almost alike.

    `angle`, in radians, is that of each of the two walls with the upright, less than a right one: at 45 degrees all
    is order, at more all is chaos, at less there are both. The balls fall from two fifths of the `height`. Source:
    H. E. Lehtihet and B. N. Miller, Numerical study of a billiard in a gravitational field, 1986.
    """
    lean = _below("angle", positive("angle", angle), pi / 2.0, "a right angle")
    high = positive("height", height)
    wide = high * tan(lean)
    walls = [
        Segment((-wide, high), (0.0, 0.0), name="left wall"),
        Segment((0.0, 0.0), (wide, high), name="right wall"),
        Segment((wide, high), (-wide, high), name="lid"),
    ]
    fall = FALL * high
    start = (0.2 * fall * tan(lean), fall)
    return _billiard("wedge", walls, start, speed=0.5 * sqrt(2.0 * GRAVITY * fall), gravity=(0.0, -GRAVITY))


@spelled
def lorentz(radius: float = 1.0, gap: float = 0.3) -> Scene:
    """A cell of the triangular Lorentz gas: quarters of two scatterers between mirrors, and five balls almost alike.

    `radius` is that of the scatterers, `gap` the width of the gate between two of them. What goes on in the plane is
    reflected into the cell. Up to a gap of 4/√3 - 2, or .309, radii no way is free for ever. Source: J. Machta and R.
    Zwanzig, Diffusion in a periodic Lorentz gas, 1983.
    """
    size, gate = positive("radius", radius), positive("gap", gap)
    wide, high = size + 0.5 * gate, sqrt(3.0) * (size + 0.5 * gate)
    walls = [
        Segment((size, 0.0), (wide, 0.0), name="mirror"),
        Segment((wide, 0.0), (wide, high - size), name="mirror"),
        Arc((wide, high), size, pi, 1.5 * pi, name="upper scatterer"),
        Segment((wide - size, high), (0.0, high), name="mirror"),
        Segment((0.0, high), (0.0, size), name="mirror"),
        Arc((0.0, 0.0), size, 0.0, 0.5 * pi, name="lower scatterer"),
    ]
    return _billiard("lorentz", walls, (0.5 * wide, 0.5 * high))


def _below(name: str, value: float, most: float, what: str) -> float:
    """`value`, which must be less than what `what` says; raises otherwise."""
    if value >= most:
        raise refuse(name, f"must be less than {what}, {most!r}", value)
    return value


def _billiard(
    name: str,
    walls: Sequence[Shape],
    start: Vector,
    direction: float = DIRECTION,
    speed: float = SPEED,
    gravity: Vector = (0.0, 0.0),
) -> Scene:
    """A scene of balls that leave `start` in almost one direction and meet nothing but `walls`."""
    radius = min(BALL_RADIUS, BALL_SHARE * min(wall.distance(start) for wall in walls))
    balls = [
        BallDescriptor(
            position=start,
            velocity=polar((0.0, 0.0), speed, direction + SPREAD * place),
            radius=radius,
            layer=BALL_LAYER,
            collides_with=WALL_LAYER,
        )
        for place in range(BALLS)
    ]
    boxes = [wall.aabb for wall in walls]
    bounds = (
        min(box.left for box in boxes) - MARGIN,
        min(box.bottom for box in boxes) - MARGIN,
        max(box.right for box in boxes) + MARGIN,
        max(box.top for box in boxes) + MARGIN,
    )
    world = WorldDescriptor(detection="continuous", substeps=1, bounds=bounds, gravity=gravity)
    return Scene(name=name, world=world, guard=True, shapes=list(walls), balls=balls)
