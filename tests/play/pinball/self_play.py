"""Games of pinball that play themselves, watched at every step."""

from __future__ import annotations

from collections import Counter
from math import hypot
from typing import NamedTuple

from carom.play.pinball import Control, EventKind, Phase, Pinball, Player

#: Steps: the most that a game may take, between two looks at whether balls move, and how long one may not.
LONGEST, LOOK, REST = 480 * 3600, 60, 480 * 6


class Played(NamedTuple):
    """What became of a game."""

    score: int
    steps: int
    steps_in_play: int
    freed: int
    strays: int
    events: Counter[EventKind]


class Watch:
    """Where each ball was last seen to move, and for how many steps it has not."""

    def __init__(self) -> None:
        self._places: dict[int, tuple[float, float, int]] = {}

    def look(self, game: Pinball) -> int:
        """The most steps that any ball on the field has stayed within its radius, unless a flipper holds it."""
        seen: dict[int, tuple[float, float, int]] = {}
        for ball in game.world.balls:
            x, y = ball.position
            old_x, old_y, still = self._places.get(ball.id, (x, y, 0))
            moved = hypot(x - old_x, y - old_y) > ball.radius
            away = game.table.beyond_lane(x, y) < ball.radius or game.table.cradled(x, y)
            seen[ball.id] = (x, y, 0) if moved or away else (old_x, old_y, still + LOOK)
        self._places = seen
        return max((still for _, _, still in seen.values()), default=0)


def start(game: Pinball) -> None:
    """Nothing; begins a game, whatever the last one left to do."""
    while game.phase is not Phase.PLAY:
        game.press(Control.START, True)
        game.tick()
    game.take_events()


def play(game: Pinball, player: Player | None) -> Played:
    """A whole game played by `player`, or by nobody, who only launches; asserts what must hold at each step."""
    start(game)
    watch, events = Watch(), Counter[EventKind]()
    steps = in_play = 0
    while game.phase in (Phase.PLAY, Phase.BONUS):
        if player is not None:
            player.tick()
        elif steps % 1200 in (10, 560):
            game.press(Control.PLUNGER, steps % 1200 == 10)
        game.tick()
        steps += 1
        in_play += game.balls_in_play > 0
        assert game.ledger.check(game.world), game.ledger
        if steps % LOOK == 0:
            assert watch.look(game) <= REST
            events.update(event.kind for event in game.take_events())
            assert steps < LONGEST
    ledger = game.ledger
    assert ledger.in_play == ledger.held == 0
    return Played(game.score, steps, in_play, ledger.freed, ledger.stray, events)
