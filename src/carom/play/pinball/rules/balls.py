"""The balls of a game: served, drained, freed when they rest, taken when they stray, and booked in a ledger."""

from __future__ import annotations

from math import cos, hypot, sin
from random import Random

import carom
from carom.play.pinball.rules.ledger import Ledger
from carom.play.pinball.rules.table import BALL_RADIUS, SAUCER_PLACE, SERVE_PLACE, Table

#: Steps between two looks at which balls rest, and how many steps one may rest.
LOOK, PATIENCE = 48, 4 * 480
#: The speed of the first push that frees a ball, in units/s; each that follows is stronger by as much.
FREEING, MOST_FREEING = 8.0, 40.0
#: A ball that is nearer to the plunger than this is on it; one slower than that lies still.
NEAR, STILL = 0.05, 0.5
#: For how many steps the saucer holds a ball, which part of the way to its middle the ball sinks in each, and the
#: velocity that the ball is let go with, towards the left flipper, with so much of chance aside.
HOLD, SINK, KICKOUT, KICKOUT_CHANCE = 768, 0.08, (0.4, -9.0), 2.5


class BallState:
    """A ball, where it belongs, and since when it rests."""

    __slots__ = ("ball", "freed", "held", "place", "resting")

    def __init__(self, ball: carom.Ball) -> None:
        self.ball = ball
        self.held = True
        self.place = ball.position
        self.resting = 0
        self.freed = 0


class Balls:
    """The balls in the world of a table, each booked in the ledger."""

    def __init__(self, table: Table, random: Random) -> None:
        self.table = table
        self.ledger = Ledger()
        self.states: dict[int, BallState] = {}
        self._caught: BallState | None = None
        self._caught_left = 0
        self._random = random

    def __len__(self) -> int:
        return len(self.states)

    # -- coming and going --------------------------------------------------------------------------------------------

    def serve(self) -> carom.Ball:
        """A new ball on the plunger."""
        ball = self.table.world.add(carom.Ball(SERVE_PLACE, BALL_RADIUS, name="ball"))
        self.states[ball.id or 0] = BallState(ball)
        self.ledger.serve()
        return ball

    def take(self, ball: int, stray: bool = False) -> BallState | None:
        """The ball with an id, which is now out of the world; None where it was taken before."""
        state = self.states.pop(ball, None)
        if state is not None:
            self.table.world.remove(state.ball)
            self.ledger.take(state.held, stray)
            if state is self._caught:
                self._caught = None
        return state

    def clear(self) -> None:
        """Take all balls out, and begin a new ledger."""
        for ball in list(self.states):
            self.take(ball)
        self.ledger = Ledger()

    # -- the saucer --------------------------------------------------------------------------------------------------

    def catch(self, ball: int) -> bool:
        """Whether the saucer, which is empty, takes the ball with an id, and holds it from now on."""
        if self._caught is None:
            self._caught, self._caught_left = self.states.get(ball), HOLD
            return self._caught is not None
        return False

    def hold(self) -> BallState | None:
        """The ball that the saucer lets go in this step, if it does; until then it draws the ball to its middle."""
        state = self._caught
        if state is None:
            return None
        (x, y), (to_x, to_y) = state.ball.position, SAUCER_PLACE
        state.ball.position = (x + SINK * (to_x - x), y + SINK * (to_y - y))
        state.ball.velocity = (0.0, 0.0)
        self._caught_left -= 1
        if self._caught_left:
            return None
        self._caught = None
        along, up = KICKOUT
        state.ball.velocity = (along + KICKOUT_CHANCE * self._random.uniform(-1.0, 1.0), up)
        return state

    # -- where they are ----------------------------------------------------------------------------------------------

    @property
    def in_play(self) -> list[BallState]:
        """The balls on the field."""
        return [state for state in self.states.values() if not state.held]

    def on_plunger(self) -> BallState | None:
        """The ball that touches the plunger, or nearly, or None."""
        for state in self.states.values():
            if state.held and self.table.plunger.distance(state.ball.position) < BALL_RADIUS + NEAR:
                return state
        return None

    def ready(self) -> bool:
        """Whether a ball lies still on the plunger."""
        state = self.on_plunger()
        return state is not None and hypot(*state.ball.velocity) < STILL

    def watch(self) -> tuple[list[BallState], list[BallState]]:
        """The balls that have come onto the field in this step, and those that are where none can be."""
        entered: list[BallState] = []
        strays: list[BallState] = []
        table = self.table
        for state, (x, y) in zip(self.states.values(), table.world.balls.position.tolist(), strict=True):
            beyond = table.beyond_lane(x, y)
            if not table.holds(x, y) or (beyond < 0.0 and not state.held):
                strays.append(state)
            elif state.held and beyond >= BALL_RADIUS:
                state.held = False
                self.ledger.enter()
                entered.append(state)
        return entered, strays

    def free(self) -> list[BallState]:
        """The balls on the field that have rested too long, each pushed in some direction upward; called every `LOOK`.

        A ball rests while it stays within its own radius, unless a raised flipper holds it.
        """
        freed = []
        for state in self.in_play:
            x, y = state.ball.position
            moved = hypot(x - state.place[0], y - state.place[1]) > BALL_RADIUS
            if moved or self.table.cradled(x, y):
                state.place = (x, y)
                state.resting = 0
                state.freed = 0 if moved else state.freed
                continue
            state.resting += LOOK
            if state.resting >= PATIENCE:
                state.resting = 0
                state.freed += 1
                self._push(state.ball, min(FREEING * state.freed, MOST_FREEING))
                freed.append(state)
        self.ledger.freed += len(freed)
        return freed

    def _push(self, ball: carom.Ball, speed: float) -> None:
        """Give a ball a speed in some direction upward."""
        angle = self._random.uniform(0.6, 2.5)
        ball.velocity = (speed * cos(angle), speed * sin(angle))
