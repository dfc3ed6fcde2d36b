"""The end of a game of pool: its rules, and what happened on the way. Nothing here is drawn or heard.

The cue ball and the eight lie at rest; the player shoots the cue ball. The game is won where the eight is potted and
the cue ball stays, lost where the cue ball is potted. Where neither falls, the player shoots again.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from math import hypot
from typing import Any, TypeAlias

import numpy as np

import carom

Vector: TypeAlias = tuple[float, float]

#: Seconds: the length of a step. Impacts are exact whatever it is; this is two steps in a frame.
STEP = 1.0 / 120.0

#: cm/s: the softest shot and the hardest.
SLOWEST, FASTEST = 12.0, 420.0

#: kg·cm/s: impacts weaker than this are touches that nobody sees or hears.
LEAST_IMPULSE = 0.02

#: Radii between the cue ball's centre and a cushion, and between those of both balls, where it is put by hand.
ROOM = 2.1

#: The layers of the shapes and of the two balls, so that a question to the world can leave balls out.
SHAPES, CUE, EIGHT = 1, 2, 4


class Phase(StrEnum):
    """What the player can do now."""

    AIM = "aim"
    ROLL = "roll"
    WON = "won"
    LOST = "lost"


class Impact(StrEnum):
    """What met: the cue and the cue ball, two balls, a ball and a cushion, a ball and the inside of a pocket."""

    STRIKE = "strike"
    BALLS = "balls"
    CUSHION = "cushion"
    POCKET = "pocket"


@dataclass(frozen=True, slots=True)
class Mark:
    """An impact: where the balls that took part were.

    Attributes:
        number: Its place among the impacts of the shot, from 1.
        impact: What met.
        time: Seconds since the shot.
        balls: The name of each ball that took part, and where its centre was.
        point: Where they touched.
        impulse: How hard, in kg·cm/s.
    """

    number: int
    impact: Impact
    time: float
    balls: tuple[tuple[str, Vector], ...]
    point: Vector
    impulse: float


@dataclass(frozen=True, slots=True)
class Fall:
    """A ball's fall: into which pocket, and the world's time."""

    pocket: str
    time: float


@dataclass(frozen=True, slots=True)
class Setup:
    """Where the two balls lie before the first shot."""

    cue: Vector
    eight: Vector


#: The first position: the eight lies for the lower right pocket, at a comfortable angle.
FIRST = Setup(cue=(72.0, 78.0), eight=(196.0, 46.0))


class Pool:
    """One game: the world, whose turn of events it is, and the marks of the last shot."""

    def __init__(self, setup: Setup = FIRST) -> None:
        self.world = carom.scenes.pool().build()
        self.cue, self.eight = self.world.balls
        self.cue.layer, self.eight.layer = CUE, EIGHT
        self.phase = Phase.AIM
        self.shots = 0
        self.marks: list[Mark] = []
        self.noises: list[tuple[Impact, float]] = []
        self.potted: dict[str, Fall] = {}
        self.moving = False
        self._shot_at = 0.0
        self.place(setup)

    def place(self, setup: Setup) -> None:
        """Begin a game with the balls at rest where `setup` has them."""
        for ball, place in ((self.cue, setup.cue), (self.eight, setup.eight)):
            ball.velocity, ball.position = (0.0, 0.0), place
        self.setup = setup
        self.phase = Phase.AIM
        self.shots = 0
        self.marks.clear()
        self.noises.clear()
        self.potted.clear()
        self.moving = False
        self.shot_from = (setup.cue, setup.eight)

    @property
    def cloth(self) -> Vector:
        """How wide and high the cloth is between the noses of the cushions, whose lower left corner is (0, 0)."""
        segments = [shape for shape in self.world.shapes if isinstance(shape, carom.Segment)]
        cushions = [shape for shape in segments if shape.name == "cushion"]
        longest = sorted(cushions, key=lambda shape: -shape.length)[:6]
        return max(shape.p0[0] for shape in longest), max(shape.p0[1] for shape in longest)

    @property
    def base_line(self) -> tuple[Vector, Vector] | None:
        """The ends of the line, a quarter along the table, on which the cue ball may be put; None after a shot."""
        if self.shots > 0 or self.phase is not Phase.AIM:
            return None
        (width, height), room = self.cloth, ROOM * self.cue.radius
        return (0.25 * width, room), (0.25 * width, height - room)

    def put_cue(self, height: float) -> None:
        """Put the cue ball on the base line, as high as that allows, not upon the eight; not after a shot."""
        line = self.base_line
        if line is None:
            return
        (x, low), (_, high) = line
        place = x, min(max(height, low), high)
        if hypot(place[0] - self.eight.position[0], place[1] - self.eight.position[1]) >= ROOM * self.cue.radius:
            self.cue.position = place
            self.setup = Setup(place, self.setup.eight)
            self.shot_from = (place, self.setup.eight)

    @property
    def over(self) -> bool:
        """Whether the game is won or lost."""
        return self.phase in (Phase.WON, Phase.LOST)

    @property
    def age(self) -> float:
        """Seconds since the last shot."""
        return self.world.time - self._shot_at

    def shoot(self, direction: Vector, power: float) -> None:
        """Shoot the cue ball. `power` goes from 0, the softest shot, to 1; only while aiming."""
        length = hypot(*direction)
        if self.phase is not Phase.AIM or length == 0.0:
            return
        speed = speed_of(power)
        self.shot_from = (self.cue.position, self.eight.position)
        self.cue.velocity = (speed * direction[0] / length, speed * direction[1] / length)
        self.phase = Phase.ROLL
        self.moving = True
        self.shots += 1
        self.marks.clear()
        self.noises.append((Impact.STRIKE, speed * self.cue.mass))
        self._shot_at = self.world.time

    def step(self) -> carom.Hits | None:
        """The hits of one step of `STEP` seconds, or None where everything lies still."""
        if not self.moving:
            return None
        hits = self.world.step(STEP)
        # A ball that comes to rest in a pocket touches it hundreds of times; what is too faint is left out all at once.
        entered = hits["kind"] == carom.HitKind.ENTER
        seen = (hits["kind"] == carom.HitKind.BOUNCE) & (np.abs(hits["impulse"]) >= LEAST_IMPULSE)
        for place in np.flatnonzero(entered | seen):
            hit = hits[int(place)]
            if hit.kind is carom.HitKind.ENTER:
                self.potted.setdefault(hit.ball.name or "", Fall(hit.shape.name or "", hit.time))
            else:
                self._bounce(hit)
        if self.cue.name in self.potted:
            self.phase = Phase.LOST
        if self.cue.asleep and self.eight.asleep:
            self._rest()
        return hits

    def to_impact(self, most: int = 12_000) -> int:
        """How many steps were made: up to the next impact, or to rest."""
        marks = len(self.marks)
        for made in range(1, most + 1):
            self.step()
            if not self.moving or len(self.marks) > marks:
                return made
        return most

    def _bounce(self, hit: Any) -> None:
        """Mark an impact, unless it is hidden: one inside a pocket after the first."""
        if self._fell(hit.ball):
            return
        (x, y), (nx, ny), radius = hit.point, hit.normal, hit.ball.radius
        balls = [(hit.ball.name or "", (x + radius * nx, y + radius * ny))]
        impact = Impact.CUSHION
        if isinstance(hit.shape, carom.Ball):
            if self._fell(hit.shape):
                return
            other = hit.shape.radius
            balls.append((hit.shape.name or "", (x - other * nx, y - other * ny)))
            impact = Impact.BALLS
        elif hit.shape.name == "pocket":
            impact = Impact.POCKET
        self.noises.append((impact, abs(hit.impulse)))
        time = hit.time - self._shot_at
        self.marks.append(Mark(len(self.marks) + 1, impact, time, tuple(balls), (x, y), abs(hit.impulse)))

    def _fell(self, ball: carom.Ball) -> bool:
        """Whether a ball lies in a pocket whose inside it has met since the shot."""
        met = any(mark.impact is Impact.POCKET and mark.balls[0][0] == ball.name for mark in self.marks)
        return met and ball.name in self.potted

    def _rest(self) -> None:
        """Judge the shot, now that both balls lie still."""
        self.moving = False
        if self.phase is Phase.ROLL:
            self.phase = Phase.WON if self.eight.name in self.potted else Phase.AIM

    def path(self, name: str) -> list[Vector]:
        """The corners of a ball's way since the shot: where it lay, where it was at each impact, and where it is."""
        ball, start = (self.cue, self.shot_from[0]) if name == self.cue.name else (self.eight, self.shot_from[1])
        corners = [place for mark in self.marks for who, place in mark.balls if who == name]
        end = [] if self._fell(ball) else [ball.position]
        return [start, *corners, *end]

    def digest(self) -> str:
        """A hash of the world and of the game's standing: equal where all went the same way, to the bit."""
        return f"{self.world.digest()}-{self.phase}-{self.shots}-{len(self.marks)}"

    @contextmanager
    def trial(self) -> Iterator[None]:
        """Nothing to use; whatever is shot inside the `with` has not happened after it."""
        kept = self.world.snapshot()
        names = ("phase", "shots", "moving", "shot_from", "_shot_at")
        values = {name: getattr(self, name) for name in names}
        marks, noises, potted = list(self.marks), list(self.noises), dict(self.potted)
        try:
            yield
        finally:
            self.world.restore(kept)
            for name, value in values.items():
                setattr(self, name, value)
            self.marks, self.noises, self.potted = marks, noises, potted


def speed_of(power: float) -> float:
    """The cue ball's speed in cm/s after a shot of a power from 0 to 1; soft shots are spread over more of it."""
    share = min(max(power, 0.0), 1.0)
    return SLOWEST + (FASTEST - SLOWEST) * share * share
