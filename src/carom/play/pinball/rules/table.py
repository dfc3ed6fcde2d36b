"""The pinball table that a game is played on: the world of the shipped scene, and its parts found by name."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot
from typing import NamedTuple, TypeVar

import carom
from carom.play.pinball.rules.events import EventKind
from carom.play.pinball.rules.lamps import BANK, BUMPERS, INLANES, LANES, ORBITS, OUTLANES, SAUCER, TARGETS

#: Seconds of a step, which is one substep: what is pressed acts on the very next one.
STEP = 1.0 / 480.0
#: How fast flippers swing up and fall back, in rad/s.
UP_SPEED, DOWN_SPEED = 22.0, 16.0
#: How fast the spinner turns by itself, and at most, in rad/s.
IDLE_SPIN, MOST_SPIN = 2.5, 11.0

BALL_RADIUS = 0.6
#: A ball is put here, and rolls into the corner of the plunger.
SERVE_PLACE = (19.3, 1.3)
#: The saucer, which holds a ball: before the left post, on the side of the right flipper. What rolls past the post
#: rolls past it too; what would strike the post from below rolls into it.
SAUCER_PLACE, SAUCER_RADIUS = (6.1, 20.57), 0.2

_KINDS = {
    **dict.fromkeys(BUMPERS, EventKind.BUMPER),
    **dict.fromkeys(LANES, EventKind.LANE),
    **dict.fromkeys(INLANES, EventKind.INLANE),
    **dict.fromkeys(OUTLANES, EventKind.OUTLANE),
    **dict.fromkeys(ORBITS, EventKind.ORBIT),
    **dict.fromkeys((*TARGETS, *BANK), EventKind.TARGET),
    **dict.fromkeys(("left slingshot's band", "right slingshot's band"), EventKind.SLINGSHOT),
    **dict.fromkeys(("left flipper", "right flipper"), EventKind.FLIPPER_HIT),
    **dict.fromkeys(("launch gate", "orbit gate"), EventKind.GATE),
    "spinner": EventKind.SPINNER,
    SAUCER: EventKind.SAUCER,
    "drain": EventKind.DRAIN,
}

T = TypeVar("T", bound=carom.Shape | carom.Compound)


class Part(NamedTuple):
    """A part of the table: its name, the kind of event that striking it makes, and its place."""

    name: str
    kind: EventKind
    place: tuple[float, float]


class Flipper:
    """A flipper with its button."""

    def __init__(self, shape: carom.Compound) -> None:
        self.shape = shape
        low, high = shape.turn_limits or (0.0, 0.0)
        self.up = 1.0 if high > -low else -1.0
        self.reach = high if self.up > 0.0 else -low
        self.pressed = False

    @property
    def angle(self) -> float:
        """How far it is from its rest, in radians; never negative."""
        return self.up * self.shape.orientation

    @property
    def raised(self) -> bool:
        """Whether it stands on its upper stop."""
        return self.angle >= self.reach - 1e-9

    def put(self, angle: float, pressed: bool) -> None:
        """Have it stand at an angle from its rest, moving as its button says."""
        if self.angle != angle:
            self.shape.rotate(self.shape.pivot, self.up * angle)
        elif self.pressed == pressed:
            return
        self.pressed = not pressed
        self.press(pressed)

    def press(self, down: bool) -> bool:
        """Whether it starts up; sets it swinging up, or back."""
        if down == self.pressed:
            return False
        self.pressed = down
        self.shape.angular_velocity = self.up * (UP_SPEED if down else -DOWN_SPEED)
        return down


class Table:
    """The world of the shipped scene without its balls, with a saucer, and the parts that a game moves and hears of."""

    def __init__(self) -> None:
        self.world = carom.scenes.pinball().build()
        self.world.substeps = 1
        self.world.remove(*self.world.balls)
        self._saucer = self.world.add(carom.Circle(SAUCER_PLACE, SAUCER_RADIUS, sensor=True, name=SAUCER))
        #: Every part by the id of its shape, as hits name it.
        self.parts: dict[int, Part] = {}
        #: Where parts are, by their names; those of parts with lamps are the lamps' names too.
        self.places: dict[str, tuple[float, float]] = {}
        named: dict[str, list[carom.Shape]] = {}
        for name, shape in self._shapes():
            named.setdefault(name, []).append(shape)
        for name, shapes in named.items():
            self._note(name, shapes)
        self.left, self.right = (
            Flipper(self._one("left flipper", carom.Compound)),
            Flipper(self._one("right flipper", carom.Compound)),
        )
        self.spinner = self._one("spinner", carom.Compound)
        self.plunger = self._one("plunger", carom.Segment)
        self.plunger.kick = 0.0
        self._gate, self._dome = self._one("launch gate", carom.Gate), self._one("dome", carom.Arc)
        self._wall, self._drain = self.places["lane wall"][0], self.places["drain"][1]
        self.targets = {name: named[name] for name in BANK}
        #: The middle of the field, in x.
        self.middle = 0.5 * (self.left.shape.pivot[0] + self.right.shape.pivot[0])
        self.down: set[str] = set()

    def _shapes(self) -> Iterator[tuple[str, carom.Shape]]:
        """Every shape with its name; of a compound's part, that of the compound."""
        for shape in self.world.shapes:
            if isinstance(shape, (carom.Compound, carom.Group)):
                yield from ((shape.name or "", part) for part in shape.shapes)
            else:
                yield shape.name or "", shape

    def _note(self, name: str, shapes: list[carom.Shape]) -> None:
        """Note the parts and the place of shapes of one name."""
        boxes = [shape.aabb for shape in shapes]
        x = 0.5 * (min(box.left for box in boxes) + max(box.right for box in boxes))
        y = 0.5 * (min(box.bottom for box in boxes) + max(box.top for box in boxes))
        part = Part(name, _KINDS.get(name, EventKind.BOUNCE), (x, y))
        for shape in shapes:
            self.parts[shape.id or 0] = part
        self.places[name] = part.place

    def _one(self, name: str, kind: type[T]) -> T:
        """The shape of a kind with a name."""
        (found,) = [shape for shape in self.world.shapes if shape.name == name and isinstance(shape, kind)]
        return found

    # -- what moves --------------------------------------------------------------------------------------------------

    def reset(self) -> None:
        """Let the flippers fall, raise the drop targets, open the saucer and slow the spinner."""
        self.left.press(False)
        self.right.press(False)
        self.raise_targets()
        self.saucer_open = True
        self.spinner.angular_velocity = IDLE_SPIN

    def lower(self, name: str) -> None:
        """Drop a target."""
        self.down.add(name)
        for shape in self.targets[name]:
            shape.can_collide = False

    def raise_targets(self) -> None:
        """Raise all drop targets."""
        for name in sorted(self.down):
            for shape in self.targets[name]:
                shape.can_collide = True
        self.down.clear()

    @property
    def saucer_open(self) -> bool:
        """Whether the saucer holds what rolls into it; closed, it lets balls roll over it."""
        return self._saucer.can_collide

    @saucer_open.setter
    def saucer_open(self, is_open: bool) -> None:
        if self._saucer.can_collide != is_open:
            self._saucer.can_collide = is_open

    def clear_of_targets(self, x: float, y: float) -> bool:
        """Whether a ball at (x, y) would overlap no drop target that is raised now."""
        return all(
            shape.distance((x, y)) > BALL_RADIUS + 0.05 for name in self.down for shape in self.targets[name][:1]
        )

    def strike_spinner(self, place: tuple[float, float], push: tuple[float, float]) -> None:
        """Turn the spinner faster, by the moment about its hub of a push at `place`."""
        x, y = self.spinner.pivot
        moment = (place[0] - x) * push[1] - (place[1] - y) * push[0]
        spin = self.spinner.angular_velocity + 0.4 * moment
        self.spinner.angular_velocity = min(max(spin, -MOST_SPIN), MOST_SPIN)

    def slow_spinner(self) -> None:
        """Bring the spinner nearer to the speed that it has by itself."""
        spin = self.spinner.angular_velocity
        idle = IDLE_SPIN if spin > 0.0 else -IDLE_SPIN
        if spin != idle:
            self.spinner.angular_velocity = idle if abs(spin - idle) < 0.1 else spin + 0.08 * (idle - spin)

    # -- where balls are ---------------------------------------------------------------------------------------------

    def beyond_lane(self, x: float, y: float) -> float:
        """How far the centre of a ball at (x, y) is out of the plunger lane and the trough: past the launch gate."""
        if x <= self._wall:
            return y - self._drain
        (gate_x, gate_y), (along, up) = self._gate.p0, self._gate.direction
        return along * (x - gate_x) + up * (y - gate_y)

    def holds(self, x: float, y: float) -> bool:
        """Whether a ball at (x, y) is within the cabinet, where alone it can be."""
        (center_x, center_y), radius = self._dome.center, self._dome.radius
        if y > center_y:
            return hypot(x - center_x, y - center_y) < radius
        return center_x - radius < x < center_x + radius and y > 0.0

    def cradled(self, x: float, y: float) -> bool:
        """Whether a ball at (x, y) touches a raised flipper whose button is held."""
        return any(
            flipper.pressed and flipper.raised and flipper.shape.distance((x, y)) < BALL_RADIUS + 0.15
            for flipper in (self.left, self.right)
        )
