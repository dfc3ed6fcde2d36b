"""A game of pinball under scripted presses, without a window."""

from collections.abc import Callable

import carom
from carom.play.pinball import Control, Event, EventKind, HighScores, Pinball


class Desk:
    """A game whose steps are checked, with all its events."""

    def __init__(self, scores: HighScores | None = None) -> None:
        self.game = Pinball(HighScores([]) if scores is None else scores, seed=3)
        self.game.press(Control.START, True)
        self.events: list[Event] = self.game.take_events()

    def tick(self, times: int = 1) -> None:
        """Make steps, after each of which the ledger must balance."""
        for _ in range(times):
            self.game.tick()
            assert self.game.ledger.check(self.game.world)
        self.events += self.game.take_events()

    def until(self, done: Callable[[], object], most: int) -> None:
        """Make steps until something is so."""
        for _ in range(most):
            if done():
                return
            self.tick()
        raise AssertionError(f"not so after {most} steps")

    def press(self, *controls: Control) -> None:
        """Press and let go."""
        for control in controls:
            self.game.press(control, True)
            self.tick()
            self.game.press(control, False)
            self.tick()

    def put(self, x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> carom.Ball:
        """The last ball, now somewhere on the field."""
        ball = self.game.world.balls[len(self.game.world.balls) - 1]
        ball.position, ball.velocity = (x, y), (vx, vy)
        self.tick(4)
        return ball

    def drain(self) -> None:
        """Let the last ball drain."""
        self.put(9.3, 6.5, 0.0, -30.0)
        self.tick(4)

    def unsave(self) -> None:
        """Let the ball save run out."""
        self.game._rules.saver_left = 0

    def kinds(self) -> list[EventKind]:
        """The kinds of all events so far."""
        return [event.kind for event in self.events]
