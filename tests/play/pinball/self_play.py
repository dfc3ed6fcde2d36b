"""Games of pinball that play themselves, watched at every step.

`python -m tests.play.pinball.self_play 1000` says what became of so many, and of a tenth as many in which nobody flips.
"""

from __future__ import annotations

import sys
from collections import Counter
from math import hypot
from statistics import mean, median
from typing import NamedTuple

from carom.play.pinball import Control, EventKind, HighScores, Phase, Pinball, Player

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
    """Begin a game, whatever the last one left to do."""
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


def main(count: int) -> None:
    """Play games and say what became of them."""
    game = Pinball(HighScores([]), seed=5)
    player = Player(game, seed=5)
    told("played", [play(game, player) for _ in range(count)])
    told("nobody flips", [play(game, None) for _ in range(max(1, count // 10))])


def told(name: str, games: list[Played]) -> None:
    """Say what became of some games."""
    scores = [game.score for game in games]
    seconds = sum(game.steps_in_play for game in games) / (3 * 480 * len(games))
    sys.stdout.write(
        f"{name}: {len(games)} games, score {mean(scores):,.0f} in the mean and {median(scores):,.0f} in the median, "
        f"a ball lasts {seconds:.0f} s, {sum(game.freed for game in games)} balls freed, "
        f"{sum(game.strays for game in games)} strays\n"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]))
