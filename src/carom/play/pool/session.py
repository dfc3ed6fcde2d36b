"""A player at the table: the aim, the power, the modes, and game after game. Nothing here is drawn or heard."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from math import atan2, cos, dist, hypot, pi, radians, sin
from typing import TYPE_CHECKING

from carom.play.pool import setups
from carom.play.pool.actions import Action
from carom.play.pool.game import STEP, Phase, Pool, Vector
from carom.play.pool.preview import Preview, preview

if TYPE_CHECKING:
    from collections.abc import Callable

#: Radians: how far the aim turns at a press, and with Shift.
NOTCH, FINE_NOTCH = radians(0.25), radians(0.02)

#: Radians a second: how fast it turns while a key is held, and with Shift; after so many seconds.
TURN, FINE_TURN, TURN_AFTER = radians(24.0), radians(1.0), 0.25

#: How far the power goes at a press, and how fast a second while a key is held.
POWER_NOTCH, POWER_RATE = 0.02, 0.5

#: cm: how far the cue ball is put at a press, and how far a second while a key is held.
PLACE_NOTCH, PLACE_RATE = 0.5, 30.0

#: Seconds: what is held no longer than that is a click, which draws no cue; and how long the cue takes to be drawn back
#: wholly from then on, where it stays.
CLICK, DRAW_TIME = 0.25, 1.3

#: Steps in a frame of step mode, and how many times as fast balls roll for those who cannot wait.
FRAME_STEPS, HURRY = 2, 3

#: Where the power stands at first.
FIRST_POWER = 0.5

#: How many balls are to be potted in the games that follow each other at the press of a key.
GAMES = (1, 3, 5, 8)


class Mode(StrEnum):
    """What can be switched on and off."""

    STEPS = "steps"
    IMPACTS = "impacts"
    PAUSE = "pause"
    HELP = "help"
    RATE = "rate"
    MUTE = "mute"


SWITCHES = {
    Action.STEPS: Mode.STEPS,
    Action.IMPACTS: Mode.IMPACTS,
    Action.PAUSE: Mode.PAUSE,
    Action.HELP: Mode.HELP,
    Action.RATE: Mode.RATE,
    Action.MUTE: Mode.MUTE,
}


class Session:
    """One sitting; time goes on by `tick`, `STEP` seconds each.

    Args:
        seed: Which positions come after the first.
        balls: How many are to be potted, from 1, the eight, to 8.
    """

    def __init__(self, seed: int = 0, balls: int = 1) -> None:
        self.pool = Pool()
        self.seed = seed
        self.number = 0
        self.won = self.lost = 0
        self.running = True
        self.modes: set[Mode] = set()
        self.held: dict[Action, float] = {}
        self.power = FIRST_POWER
        self.draw: float | None = None
        self.dragging = False
        self.since_shot = self.since_end = 10.0
        self._pointer: Vector | None = None
        self._seen: tuple[tuple[float, Phase, int, Vector], Preview | None] | None = None
        self._aim_at_ball()
        if balls > 1:
            self.change_game(balls)

    # -- the aim -----------------------------------------------------------------------------------------------------

    @property
    def direction(self) -> Vector:
        """Where the cue points, as a unit vector."""
        return cos(self.angle), sin(self.angle)

    def point(self, place: Vector) -> None:
        """Aim at a place of the table, unless the cue is drawn already; put the cue ball there while it is dragged."""
        if self.dragging:
            self.pool.put_cue(place[1])
            return
        self._pointer = place
        if self.draw is None and self.pool.phase is Phase.AIM:
            self._aim(place)

    def grab(self, place: Vector) -> bool:
        """Whether the cue ball is dragged from now on: at a place on it, before the first shot."""
        x, y = self.pool.cue.position
        near = hypot(place[0] - x, place[1] - y) <= self.pool.cue.radius
        self.dragging = near and self.pool.base_line is not None and Mode.PAUSE not in self.modes
        return self.dragging

    def let_go(self) -> None:
        """Leave the cue ball where it was put, and aim at a ball from there."""
        self.dragging = False
        self._aim_at_ball()

    def _place(self, change: float) -> None:
        """Put the cue ball so much farther up its line, and go on aiming where the mouse is, or at a ball."""
        if self.pool.base_line is not None and Mode.PAUSE not in self.modes:
            self.pool.put_cue(self.pool.cue.position[1] + change)
            if self._pointer is not None:
                self._aim(self._pointer)
            else:
                self._aim_at_ball()

    def _aim(self, place: Vector) -> None:
        """Aim at a place that is not within the cue ball's middle."""
        x, y = place[0] - self.pool.cue.position[0], place[1] - self.pool.cue.position[1]
        if x * x + y * y > 1e-6:
            self.angle = atan2(y, x)

    def _aim_at_ball(self) -> None:
        """Aim full at the nearest ball that is to be potted."""
        self.angle = 0.0
        self._aim(min((ball.position for ball in self.pool.targets), key=partial(dist, self.pool.cue.position)))

    def _turn(self, angle: float) -> None:
        """Turn the aim; the mouse no longer says where it goes."""
        self._pointer = None
        self.angle = (self.angle + angle + pi) % (2.0 * pi) - pi

    @property
    def strength(self) -> float:
        """The power that a shot would have now: as far as the cue is drawn, or, where it is not, as it was set."""
        return self.draw or self.power

    def preview(self) -> Preview | None:
        """What the shot would do, while the player aims."""
        if self.pool.phase is not Phase.AIM:
            return None
        key = (self.angle, self.pool.phase, self.pool.shots, self.pool.cue.position)
        if self._seen is None or self._seen[0] != key:
            self._seen = key, preview(self.pool, self.direction)
        return self._seen[1]

    # -- what the player does ----------------------------------------------------------------------------------------

    def begin(self, action: Action) -> None:
        """Begin an action whose key or button goes down."""
        self.held[action] = 0.0
        if action in SWITCHES:
            self.modes ^= {SWITCHES[action]}
        else:
            self._doings()[action](action)

    def end(self, action: Action) -> None:
        """End an action whose key or button goes up."""
        self.held.pop(action, None)
        if action is Action.DRAW and self.draw is not None:
            self._shoot(self.strength)

    def _doings(self) -> dict[Action, Callable[[Action], None]]:
        """What each action does when it begins."""
        return {
            Action.TURN_LEFT: lambda _: self._turn(self._notch()),
            Action.TURN_RIGHT: lambda _: self._turn(-self._notch()),
            Action.STRONGER: lambda _: self.change_power(POWER_NOTCH),
            Action.WEAKER: lambda _: self.change_power(-POWER_NOTCH),
            Action.PLACE_UP: lambda _: self._place(PLACE_NOTCH),
            Action.PLACE_DOWN: lambda _: self._place(-PLACE_NOTCH),
            Action.DRAW: lambda _: self._draw_cue(),
            Action.SHOOT: lambda _: self._shoot_or_again(),
            Action.CANCEL: lambda _: self._put_down(),
            Action.FRAME: lambda _: self._steps(FRAME_STEPS),
            Action.TO_IMPACT: lambda _: self._to_impact(),
            Action.AGAIN: lambda _: self.again(),
            Action.SAME: lambda _: self._begin_game(self.number),
            Action.MORE: lambda _: self.change_game(self._next_game()),
            Action.FINE: lambda _: None,
            Action.QUIT: lambda _: self._quit(),
        }

    def _notch(self) -> float:
        """Radians that a press turns the aim by."""
        return FINE_NOTCH if Action.FINE in self.held else NOTCH

    def change_power(self, change: float) -> None:
        """Change the power, which stays between 0 and 1."""
        self.power = min(max(self.power + change, 0.0), 1.0)

    def _draw_cue(self) -> None:
        """Begin a click or the drawing of the cue, or another game where this one is over."""
        if self.pool.over:
            self.again()
        elif self.pool.phase is Phase.AIM and Mode.PAUSE not in self.modes:
            self.draw = 0.0

    def _put_down(self) -> None:
        """Put the cue down without a shot."""
        self.draw = None

    def _shoot_or_again(self) -> None:
        """Shoot with the power shown, or begin another game."""
        if self.pool.over:
            self.again()
        else:
            self._shoot(self.power)

    def _shoot(self, power: float) -> None:
        """Shoot, if it is the moment for that; the power that was set stays what it was."""
        self.draw = None
        if self.pool.phase is Phase.AIM and Mode.PAUSE not in self.modes:
            self.pool.shoot(self.direction, power)
            self.since_shot = 0.0

    def again(self) -> None:
        """Begin a game from the next position."""
        self._begin_game(self.number + 1)

    def _next_game(self) -> int:
        """How many balls there are in the game after this one."""
        balls = len(self.pool.balls) - 1
        return next((more for more in GAMES if more > balls), GAMES[0])

    def change_game(self, balls: int) -> None:
        """Begin the game with so many balls, from its first position."""
        self.pool = Pool.of(balls)
        self.won = self.lost = self.number = 0
        setups.setup(self.pool, 0, self.seed)
        self._begin()

    def _begin_game(self, number: int) -> None:
        """Begin a game from a position by its number."""
        if number == self.number:
            self.pool.place(self.pool.setup)
        else:
            self.number = number
            setups.setup(self.pool, number, self.seed)
        self._begin()

    def _begin(self) -> None:
        """Take the cue in hand for a game whose balls have been placed."""
        self.draw = None
        self.dragging = False
        self.since_shot = 10.0
        self._aim_at_ball()

    def _quit(self) -> None:
        """Close the help, or end the sitting."""
        if Mode.HELP in self.modes:
            self.modes.discard(Mode.HELP)
        else:
            self.running = False

    # -- time --------------------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Let `STEP` seconds go by: keys that are held go on, and the balls roll."""
        for action in self.held:
            self.held[action] += STEP
        if Mode.PAUSE in self.modes or Mode.HELP in self.modes:
            return
        self.since_shot += STEP
        self.since_end += STEP
        self._hold()
        if self.draw is not None:
            held = self.held.get(Action.DRAW, 0.0)
            self.draw = min(max(held - CLICK, 0.0) / DRAW_TIME, 1.0)
        if Mode.STEPS not in self.modes:
            self._steps(HURRY if Action.DRAW in self.held else 1)

    def _hold(self) -> None:
        """Go on with what the keys do that are held."""
        sides = ((Action.TURN_LEFT, 1.0), (Action.TURN_RIGHT, -1.0))
        turn = FINE_TURN if Action.FINE in self.held else TURN
        for action, side in sides:
            if self.held.get(action, 0.0) > TURN_AFTER:
                self._turn(side * turn * STEP)
        for action, side in ((Action.STRONGER, 1.0), (Action.WEAKER, -1.0)):
            if self.held.get(action, 0.0) > TURN_AFTER:
                self.change_power(side * POWER_RATE * STEP)
        for action, side in ((Action.PLACE_UP, 1.0), (Action.PLACE_DOWN, -1.0)):
            if self.held.get(action, 0.0) > TURN_AFTER:
                self._place(side * PLACE_RATE * STEP)

    def _steps(self, count: int) -> None:
        """Let the balls roll on for a number of steps."""
        self._roll(lambda: [self.pool.step() for _ in range(count)])

    def _to_impact(self) -> None:
        """Let the balls roll on to the next impact."""
        self._roll(self.pool.to_impact)

    def _roll(self, roll: Callable[[], object]) -> None:
        """Roll the balls on, and take note of what came of it."""
        if not self.pool.moving:
            return
        over = self.pool.over
        roll()
        if self.pool.over and not over:
            self.since_end = 0.0
            self.won += self.pool.phase is Phase.WON
            self.lost += self.pool.phase is Phase.LOST
        elif self.pool.phase is Phase.AIM and self._pointer is not None:
            self._aim(self._pointer)
        elif self.pool.phase is Phase.AIM:
            self._aim_at_ball()
