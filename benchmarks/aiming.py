"""Shots of the pinball table: where a ball goes, and how fast, by the place of the bat that it is struck with."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, degrees, hypot, sin
from typing import NamedTuple

import carom
from benchmarks.common import Figure
from carom.play.pinball.rules.lamps import BANK, ORBITS, SAUCER, TARGETS
from carom.play.pinball.rules.table import BALL_RADIUS, STEP, Flipper, Table
from carom.scene.shipped.pinball_table import FLIPPER_REST

TITLE = "Aiming: a shot's direction by the place of the bat that strikes, from the pivot outwards"

#: What a player aims at.
AIMS = (*TARGETS, *BANK, *ORBITS, SAUCER, "spinner")
#: What a shot may touch, by the ends of names, and still meet by intent what it meets then.
GUIDING = ("wall", "guide", "gate", "dome", "shoulder", "guard point", "lane", "orbit")
#: Where a ball lies from which it comes to rest on the raised left flipper, and where it enters the left inlane at what
#: velocity; how many steps it is given for the first.
HELD, ENTERS, INWARD, SETTLE = (2.55, 12.0), (2.55, 14.5), (0.0, -5.0), 1680
#: Steps: the latest flip; how long a flip is looked at, which lasts 21; and how long the ball's way is.
LATEST, FLIP, WAY = 440, 30, 430
#: A shot is told of where it was struck so much farther out than the one before.
APART = 0.25
#: Degrees that a later shot's direction may be off by, of one that goes farther across, and still count as the same.
SAME = 0.3


class Feed(NamedTuple):
    """How a ball comes to a flipper: the flipper's side, and whether from a cradle, else from the inlane."""

    left: bool
    cradle: bool

    @property
    def name(self) -> str:
        """What it is called."""
        return f"{'left' if self.left else 'right'} {'cradle' if self.cradle else 'inlane'}"


class Shot(NamedTuple):
    """A shot.

    Attributes:
        wait: Steps that were waited before the flip.
        place: How far out from the pivot, along the bat, the ball lay when it was struck.
        angle: The direction in which it left, in degrees: 90 is up the table, less is farther across.
        speed: Its speed then.
        aims: Which of `AIMS` it met: orbits, and the first of the others, if nothing but what guides came before it.
    """

    wait: int
    place: float
    angle: float
    speed: float
    aims: tuple[str, ...]


class Range:
    """A table with one ball, on which shots are made."""

    def __init__(self, feed: Feed, bank_down: bool = False) -> None:
        self._table = Table()
        self._feed = feed
        self._flipper = self._table.left if feed.left else self._table.right
        self._bat = {shape.id for shape in self._flipper.shape.shapes}
        if bank_down:
            for name in BANK:
                self._table.lower(name)
        x, y = HELD if feed.cradle else ENTERS
        side = 1.0 if feed.left else -1.0
        place = (self._table.middle + side * (x - self._table.middle), y)
        self._ball = self._table.world.add(carom.Ball(place, BALL_RADIUS, (0.0, 0.0) if feed.cradle else INWARD))
        if feed.cradle:
            self._flipper.press(True)
            self._table.world.run(SETTLE * STEP, STEP)
        self._start = self._table.world.snapshot()

    def shots(self, every: int) -> Iterator[Shot]:
        """A shot after each `every` steps of waiting, those that strike the ball."""
        for wait in range(every, LATEST, every):
            shot = self._shot(wait)
            if shot is not None:
                yield shot

    def _shot(self, wait: int) -> Shot | None:
        """The shot of a flip after a wait, None where the bat misses."""
        table, flipper = self._table, self._flipper
        table.world.restore(self._start)
        flipper.pressed = self._feed.cradle
        flipper.press(False)
        table.world.run(wait * STEP, STEP)
        flipper.press(True)
        place = along(flipper, self._ball.position)
        left_with: tuple[float, float] | None = None
        for _ in range(FLIP):
            hits = table.world.step(STEP)
            if any(shape in self._bat for shape in hits["shape"].tolist()):
                left_with = self._ball.velocity
        if left_with is None:
            return None
        hits = table.world.run(WAY * STEP, STEP)
        side = 1.0 if self._feed.left else -1.0
        angle = degrees(atan2(left_with[1], side * left_with[0]))
        names = [table.parts[shape].name for shape in hits["shape"].tolist() if shape in table.parts]
        return Shot(wait, place, angle, hypot(*left_with), tuple(aims(names)))


def along(flipper: Flipper, place: tuple[float, float]) -> float:
    """How far out along a flipper's bat a place is, from the pivot."""
    x, y = flipper.shape.pivot
    angle = FLIPPER_REST + flipper.angle
    return flipper.up * (place[0] - x) * cos(angle) + (place[1] - y) * sin(angle)


def aims(names: list[str]) -> list[str]:
    """Which of `AIMS` a shot meets by intent, of the names of all that it meets."""
    met = []
    for name in names:
        if name in AIMS:
            met.append(name)
        if not name.endswith(GUIDING):
            break
    return list(dict.fromkeys(met))


def fan(shots: list[Shot]) -> list[Shot]:
    """The longest run of shots, each of which goes as far across as the one before, or farther."""
    best: list[Shot] = []
    run: list[Shot] = []
    for shot in shots:
        if run and (shot.angle > run[-1].angle + SAME or shot.place < run[-1].place):
            run = []
        run.append(shot)
        if not best or run[0].angle - run[-1].angle > best[0].angle - best[-1].angle:
            best = list(run)
    return best


def told(feed: Feed, shots: list[Shot]) -> list[Figure]:
    """The figures of a feed's fan: its span, and shots from the root to the tip."""
    found = fan(shots)
    first, last = found[0], found[-1]
    remarks = {"speed": f"{first.speed:.0f} to {last.speed:.0f}", "meets": f"{first.place:.2f} to {last.place:.2f} out"}
    figures = [Figure(f"{feed.name}: fan", "carom", first.angle - last.angle, "° wide", remarks=remarks)]
    place = -APART
    for shot in found:
        if shot.place >= place + APART or shot is last:
            place = shot.place
            remarks = {"speed": f"{shot.speed:.1f}", "meets": ", ".join(shot.aims)}
            figures.append(Figure(f"{feed.name}, {place:.2f} out", "carom", shot.angle, "°", remarks=remarks))
    return figures


def run(quick: bool) -> list[Figure]:
    """Degrees of shots by their place on the bat; then for how many milliseconds of a press each aim is met."""
    every = 8 if quick else 1
    figures = []
    windows: dict[str, dict[str, float]] = {name: {} for name in AIMS}
    for feed in (Feed(left, cradle) for left in (True, False) for cradle in (True, False)):
        shots = list(Range(feed).shots(every))
        figures += told(feed, shots)
        for name in AIMS:
            # The right target is the wall behind the bank.
            seen = shots if name != "right target" else list(Range(feed, bank_down=True).shots(every))
            count = sum(name in shot.aims for shot in fan(seen))
            if count:
                windows[name][feed.name] = 1e3 * STEP * every * count
    for name, window in windows.items():
        best = max(window.values(), default=0.0)
        remarks = {"meets": ", ".join(f"{feed} {time:.0f} ms" for feed, time in window.items()) or "nobody"}
        figures.append(Figure(f"{name}: time to press", "carom", best, "ms", remarks=remarks))
    return figures
