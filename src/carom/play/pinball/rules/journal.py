"""The journal of a game: its events, and what the display says of them for a while."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.play.pinball.rules.controls import Phase
from carom.play.pinball.rules.events import Event, EventKind

if TYPE_CHECKING:
    from carom.play.pinball.rules.game import Pinball
from carom.play.pinball.rules.rules import RATE

#: What the display says of events, of those that are jackpots in multiball, and for how many steps.
NOTICES = {
    EventKind.BANK: "BANK",
    EventKind.EXTRA: "EXTRA BALL",
    EventKind.KNOCK: "NEW HIGH SCORE",
    EventKind.LANES: "BONUS MULTIPLIER",
    EventKind.MULTIBALL: "MULTIBALL",
    EventKind.FEAT: "WELL SHOT",
    EventKind.SAVE: "BALL SAVED",
    EventKind.WARNING: "WARNING",
}
JACKPOTS = (EventKind.ORBIT, EventKind.BANK, EventKind.SAUCER)
NOTICE_TIME = 2 * RATE


class Journal:
    """Events that have not been taken yet, and the words about the last one that was worth some.

    >>> journal = Journal()
    >>> journal.note(Event(EventKind.SAVE))
    >>> journal.notice, len(journal.take()), len(journal.take())
    ('BALL SAVED', 1, 0)
    """

    def __init__(self) -> None:
        self._events: list[Event] = []
        self._words, self._left = "", 0

    def note(self, event: Event, multiball: bool = False) -> None:
        """Keep an event, and the words for it."""
        self._events.append(event)
        jackpot = multiball and event.kind in JACKPOTS and event.score > 0
        words = "JACKPOT" if jackpot else NOTICES.get(event.kind)
        if words is not None:
            self._words, self._left = words, NOTICE_TIME

    def take(self) -> list[Event]:
        """The events since this was last asked, in order."""
        events, self._events = self._events, []
        return events

    @property
    def notice(self) -> str:
        """The words that are to be seen now, or ""."""
        return self._words if self._left else ""

    def tick(self) -> None:
        """Let a step's time pass."""
        if self._left:
            self._left -= 1

    def clear(self) -> None:
        """Take the words away."""
        self._left = 0


def message_of(game: Pinball, notice: str) -> str:
    """What the score display of a game says, of which `notice` is the latest; "" where there is none."""
    if game.phase is Phase.ATTRACT:
        return "PRESS START"
    if game.phase is Phase.ENTRY:
        return f"HIGH SCORE  ENTER INITIALS  {game.initials}"
    if game.phase is Phase.OVER:
        return "GAME OVER"
    if game.phase is Phase.BONUS:
        return f"BONUS {game.bonus:,} x {game.multiplier}"
    if game.tilted:
        return "TILT"
    return notice or f"BALL {game.ball_number}"
