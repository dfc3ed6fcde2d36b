"""The end of a game of pool: its rules, and what happened on the way. Nothing here is drawn or heard.

The cue ball and the eight lie at rest; the player shoots the cue ball. The game is won where the eight is potted and
the cue ball stays, lost where the cue ball is potted. Where neither falls, the player shoots again.

With more balls it is another game: all of them are to be potted, in any order, within so many shots. A potted cue ball
is a foul, which costs a shot more; then it is put on the base line again.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
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

#: The layers of the shapes and of the cue ball; those after it are the other balls', one each, so that questions to the
#: world can leave balls out. A ball that is potted meets shapes alone, so that the next one finds room in the pocket.
SHAPES, CUE, POTTED = 1, 2, 1 << 12

#: The names of the balls that are to be potted, in the order in which they come onto the table.
NAMES = ("eight", "one", "two", "three", "four", "five", "six", "seven")


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
    """Where the balls lie before the first shot; `more` are those besides the eight."""

    cue: Vector
    eight: Vector
    more: tuple[Vector, ...] = ()


#: The first position: the eight lies for the lower right pocket, at a comfortable angle.
FIRST = Setup(cue=(72.0, 78.0), eight=(196.0, 46.0))


class Pool:
    """One game: the world, whose turn of events it is, and the marks of the last shot.

    Attributes:
        balls: The cue ball, and those that are to be potted, the eight first.
        limit: Shots within which all are to be potted, or None where there is the eight alone.
        fouls: How often the cue ball was potted; each counts as a shot.
        gone: The names of the balls that were potted before the last shot.
    """

    def __init__(self, setup: Setup = FIRST) -> None:
        self.world = carom.scenes.pool().build()
        self.cue, self.eight = self.world.balls
        self._all = self.cue.collides_with
        self.balls = [self.cue, self.eight, *(self._like_eight(name) for name in NAMES[1 : 1 + len(setup.more)])]
        self.limit = shots_for(1 + len(setup.more)) if setup.more else None
        self.phase = Phase.AIM
        self.shots = self.fouls = 0
        self.marks: list[Mark] = []
        self.noises: list[tuple[Impact, float]] = []
        self.potted: dict[str, Fall] = {}
        self.gone: frozenset[str] = frozenset()
        self.moving = False
        self._shot_at = 0.0
        self.place(setup)

    @classmethod
    def of(cls, balls: int) -> Pool:
        """A game with so many balls to be potted, at most `len(NAMES)`, none of which has been placed yet."""
        setup = FIRST if balls == 1 else replace(FIRST, more=tuple((20.0 * ball, 20.0) for ball in range(1, balls)))
        return cls(setup)

    def _like_eight(self, name: str) -> carom.Ball:
        """Another ball of the eight's size and mass; where it lies is said by `place`."""
        eight = self.eight
        return self.world.add(
            carom.Ball((0.0, 0.0), eight.radius, mass=eight.mass, elasticity=eight.elasticity, name=name)
        )

    def place(self, setup: Setup) -> None:
        """Begin a game with as many balls at rest where `setup` has them."""
        places = (setup.cue, setup.eight, *setup.more)
        for number, (ball, place) in enumerate(zip(self.balls, places, strict=True)):
            ball.velocity, ball.position = (0.0, 0.0), place
            ball.layer, ball.collides_with = CUE << number, self._all
        self.setup = setup
        self.phase = Phase.AIM
        self.shots = self.fouls = 0
        self.marks.clear()
        self.noises.clear()
        self.potted.clear()
        self.gone = frozenset()
        self.moving = False
        self.in_hand = True
        self.shot_from = places

    @property
    def targets(self) -> list[carom.Ball]:
        """The balls that are still to be potted."""
        return [ball for ball in self.balls[1:] if ball.name not in self.potted]

    @property
    def used(self) -> int:
        """How many shots are used up: those made, and one for each foul."""
        return self.shots + self.fouls

    @property
    def cloth(self) -> Vector:
        """How wide and high the cloth is between the noses of the cushions, whose lower left corner is (0, 0)."""
        segments = [shape for shape in self.world.shapes if isinstance(shape, carom.Segment)]
        cushions = [shape for shape in segments if shape.name == "cushion"]
        longest = sorted(cushions, key=lambda shape: -shape.length)[:6]
        return max(shape.p0[0] for shape in longest), max(shape.p0[1] for shape in longest)

    @property
    def base_line(self) -> tuple[Vector, Vector] | None:
        """The ends of the line, a quarter along the table, where the cue ball may be put; None where it may not.

        It may before the first shot, and after a foul.
        """
        if not self.in_hand or self.phase is not Phase.AIM:
            return None
        return self._line()

    def _line(self) -> tuple[Vector, Vector]:
        """The ends of the base line, so far from the cushions that the cue ball has room."""
        (width, height), room = self.cloth, ROOM * self.cue.radius
        return (0.25 * width, room), (0.25 * width, height - room)

    def put_cue(self, height: float) -> None:
        """Put the cue ball on the base line, as high as that allows, not upon another; only where it may be put."""
        line = self.base_line
        if line is None:
            return
        (x, low), (_, high) = line
        place = x, min(max(height, low), high)
        if self._is_free(place):
            self.cue.position = place
            self.shot_from = (place, *self.shot_from[1:])
            if self.shots == 0:
                self.setup = replace(self.setup, cue=place)

    def _is_free(self, place: Vector) -> bool:
        """Whether the cue ball has room at a place, clear of the balls on the table."""
        ways = (hypot(place[0] - ball.position[0], place[1] - ball.position[1]) for ball in self.targets)
        return all(way >= ROOM * self.cue.radius for way in ways)

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
        self.shot_from = tuple(ball.position for ball in self.balls)
        self.gone = frozenset(self.potted)
        self.cue.velocity = (speed * direction[0] / length, speed * direction[1] / length)
        self.phase = Phase.ROLL
        self.moving, self.in_hand = True, False
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
                self._fall(hit)
            else:
                self._bounce(hit)
        if self.limit is None and self.cue.name in self.potted:
            self.phase = Phase.LOST
        if all(ball.asleep for ball in self.balls):
            self._rest()
        return hits

    def _fall(self, hit: Any) -> None:
        """Note that a ball was potted, and take it out of the way of others."""
        name = hit.ball.name or ""
        if name not in self.potted:
            self.potted[name] = Fall(hit.shape.name or "", hit.time)
            if self.limit is not None:
                hit.ball.layer, hit.ball.collides_with = POTTED, SHAPES

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
        """Judge the shot, now that all balls lie still."""
        self.moving = False
        if self.phase is not Phase.ROLL:
            return
        if self.limit is None:
            self.phase = Phase.WON if self.eight.name in self.potted else Phase.AIM
            return
        foul = self.cue.name in self.potted
        self.fouls += foul
        if not self.targets:
            self.phase = Phase.WON if self.used <= self.limit else Phase.LOST
        else:
            self.phase = Phase.AIM if self.used < self.limit else Phase.LOST
        if foul and self.phase is Phase.AIM:
            self._return_cue()

    def _return_cue(self) -> None:
        """Put the cue ball back onto the base line, near its middle, from where the player may move it."""
        del self.potted[self.cue.name or ""]
        (x, low), (_, high) = self._line()
        heights = np.linspace(low, high, 41)
        middle = 0.5 * (low + high)
        free = [float(height) for height in heights if self._is_free((x, float(height)))]
        self.cue.velocity, self.cue.position = (0.0, 0.0), (x, min(free, key=lambda height: abs(height - middle)))
        self.cue.layer, self.cue.collides_with = CUE, self._all
        self.in_hand = True

    def path(self, name: str) -> list[Vector]:
        """The corners of a ball's way since the shot: where it lay, where it was at each impact, and where it is."""
        number = [ball.name for ball in self.balls].index(name)
        corners = [place for mark in self.marks for who, place in mark.balls if who == name]
        end = [] if self._fell(self.balls[number]) else [self.balls[number].position]
        return [self.shot_from[number], *corners, *end]

    def digest(self) -> str:
        """A hash of the world and of the game's standing: equal where all went the same way, to the bit."""
        return f"{self.world.digest()}-{self.phase}-{self.used}-{len(self.marks)}"

    @contextmanager
    def trial(self) -> Iterator[None]:
        """Nothing to use; whatever is shot inside the `with` has not happened after it."""
        kept = self.world.snapshot()
        names = ("phase", "shots", "fouls", "moving", "in_hand", "shot_from", "gone", "setup", "_shot_at")
        values = {name: getattr(self, name) for name in names}
        marks, noises, potted = list(self.marks), list(self.noises), dict(self.potted)
        try:
            yield
        finally:
            self.world.restore(kept)
            for name, value in values.items():
                setattr(self, name, value)
            self.marks, self.noises, self.potted = marks, noises, potted


def shots_for(balls: int) -> int:
    """Within how many shots some balls are to be potted: three in 5, five in 8, eight in 13."""
    return balls + balls // 2 + 1


def speed_of(power: float) -> float:
    """The cue ball's speed in cm/s after a shot of a power from 0 to 1; soft shots are spread over more of it."""
    share = min(max(power, 0.0), 1.0)
    return SLOWEST + (FASTEST - SLOWEST) * share * share
