"""What flashes and floats for a moment after something happened: sparks, points, kicks, shows of lamps, nudges."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import NamedTuple

from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.rules.lamps import LANES

#: Seconds that each lasts.
KICK, SPARK, POINTS, SHAKE, SHOW, NEWS = 0.12, 0.18, 0.8, 0.22, 1.4, 2.05
#: The least speed of an impact that makes a spark, and of sparks and points the most at once.
SPARKS_FROM, MOST = 24.0, 12
#: Points worth floating over the table.
WORTH = 500
PUSHES = {"nudge left": (-6.0, 0.0), "nudge right": (6.0, 0.0), "nudge up": (0.0, -6.0)}
SHOWS = {
    EventKind.MULTIBALL,
    EventKind.BANK,
    EventKind.LANES,
    EventKind.EXTRA,
    EventKind.KNOCK,
    EventKind.GAME_START,
    EventKind.MODE,
    EventKind.FEAT,
}
#: What the display announces, with the points; of a lane only a skill shot, which brings so much at least.
ANNOUNCED = {
    EventKind.BANK: "TARGETS",
    EventKind.LANES: "S-K-Y",
    EventKind.ORBIT: "ORBIT",
    EventKind.SAUCER: "SAUCER",
    EventKind.EXTRA: "EXTRA BALL",
    EventKind.KNOCK: "HIGH SCORE",
}
SKILL = 5_000
JACKPOT = 20_000
STRIKES = {EventKind.BUMPER, EventKind.SLINGSHOT, EventKind.TARGET, EventKind.FLIPPER_HIT, EventKind.BOUNCE}

#: What makes its part flash.
KICKS = {EventKind.BUMPER, EventKind.SLINGSHOT, EventKind.SAUCER, EventKind.KICKOUT}


class News(NamedTuple):
    """What the display announces for a moment: words, and the points that they brought."""

    words: str
    points: int


NOTHING = News("", 0)


class Spark(NamedTuple):
    """Something at a place of the table, from a moment on: words, or a flash where there are none."""

    place: tuple[float, float]
    since: float
    words: str = ""


@dataclass
class Effects:
    """Follows the events of a game.

    Attributes:
        time: Seconds since the beginning.
        sparks: Flashes of impacts.
        points: Points that float upward.
    """

    time: float = 0.0
    sparks: list[Spark] = field(default_factory=list)
    points: list[Spark] = field(default_factory=list)
    _kicks: dict[str, float] = field(default_factory=dict)
    _show: float = -SHOW
    _news: News = NOTHING
    _told: float = -NEWS
    _push: tuple[float, float] = (0.0, 0.0)
    _pushed: float = -SHAKE

    def note(self, events: Iterable[Event]) -> None:
        """Take what happened."""
        for event in events:
            if event.kind in KICKS:
                self._kicks[event.part] = self.time
            if event.kind in STRIKES and event.speed >= SPARKS_FROM:
                self.sparks = [*self.sparks, Spark(event.place, self.time)][-MOST:]
            if event.score >= WORTH:
                self.points = [*self.points, Spark(event.place, self.time, f"{event.score:,}")][-MOST:]
            if event.kind in SHOWS:
                self._show = self.time
            words = announced(event)
            if words:
                self._news, self._told = News(words, event.score), self.time
            if event.kind is EventKind.NUDGE:
                self._push, self._pushed = PUSHES.get(event.part, (0.0, 0.0)), self.time

    def advance(self, seconds: float) -> None:
        """Let time go by."""
        self.time += seconds
        self.sparks = [spark for spark in self.sparks if self.time - spark.since < SPARK]
        self.points = [spark for spark in self.points if self.time - spark.since < POINTS]

    def kicks(self, part: str) -> bool:
        """Whether a bumper or a slingshot has just kicked."""
        return self.time - self._kicks.get(part, -KICK) < KICK

    @property
    def show(self) -> float | None:
        """Seconds since a show of lamps began; None where there is none."""
        since = self.time - self._show
        return since if since < SHOW else None

    @property
    def news(self) -> News | None:
        """What is announced now; None where nothing is."""
        return self._news if self.time - self._told < NEWS else None

    @property
    def shift(self) -> tuple[int, int]:
        """Pixels by which the table is moved, as it is nudged."""
        since = (self.time - self._pushed) / SHAKE
        if since >= 1.0:
            return 0, 0
        part = (1.0 - since) * (1.0 - 2.0 * since)
        return round(self._push[0] * part), round(self._push[1] * part)


def announced(event: Event) -> str:
    """The words by which an event is announced; none for what happens often."""
    if event.kind is EventKind.LANE and event.part in LANES and event.score >= SKILL:
        return "SKILL SHOT"
    if event.part == "jackpot" or (event.kind in (EventKind.ORBIT, EventKind.SAUCER) and event.score >= JACKPOT):
        return "JACKPOT"
    if event.kind in (EventKind.MODE, EventKind.MORE, EventKind.FEAT):
        return event.part
    return ANNOUNCED.get(event.kind, "")
