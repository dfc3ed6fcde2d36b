"""A player who plays by itself: in demonstrations, and in thousands of games that test the table."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from math import hypot, inf
from random import Random
from typing import TYPE_CHECKING

import carom
from carom.play.pinball.robot.foresight import Foresight, Presses, State, sweeps
from carom.play.pinball.rules.controls import NUDGES, Control, Phase
from carom.play.pinball.rules.lamps import LampState
from carom.play.pinball.rules.table import BALL_RADIUS

if TYPE_CHECKING:
    from carom.play.pinball.rules.game import Pinball

#: Steps: between two decisions; how far ahead a ball's way is looked at, from a cradle, and between two places on it.
DECIDE, AHEAD, CRADLE_AHEAD, EVERY = 6, 192, 336, 12
#: Steps: how long a flip lasts, and how far its outcome is looked at; how long before a ball comes a flipper is raised
#: to catch it; how much later than thought a flipper falls that held a ball; and how late a press comes at most.
FLIP, OUTCOME, RAISE, RELEASE, LATE = 60, 240, 40, 24, 22
#: A ball below this that does not rise faster than that is thought about.
LOW, RISING = 14.0, 8.0
#: A ball slower than this lies still, in units/s.
STILL = 4.0
#: A ball in the plunger lane below this lies on the plunger, or nearly.
FOOT = 2.0
#: For how many steps the plunger is drawn for a lane, with so much of chance.
PULLS, PULL_CHANCE = {"left lane": 541, "middle lane": 541, "right lane": 635}, 24
#: Where a ball is that may come into an outlane: in y, and how far from the field's middle; how far ahead its way is
#: looked at, in steps, and how bad it must be for a nudge; how long there is no other look, and no other nudge.
SIDE_LOW, SIDE_HIGH, SIDE, SIDE_AHEAD, LOST, SIDE_REST, NUDGE_REST = 13.8, 18.5, 5.7, 192, -2000.0, 36, 4800
#: How many moments of a flip are tried for each flipper.
TRIES = 6


class Player:
    """Presses the controls of a game as a good player would; call `tick` before each of the game's.

    When a ball comes near the flippers it tries flips and catches on a table of its own, one a step, and does the best
    of them, a little late, as people do.
    """

    def __init__(self, game: Pinball, seed: int = 0, press: Callable[[Control, bool], None] | None = None) -> None:
        self._game = game
        self._random = Random(seed)
        self._press = game.press if press is None else press
        self.begin()

    @cached_property
    def _foresight(self) -> Foresight:
        """The table of its own, made when it first thinks."""
        return Foresight()

    def begin(self) -> None:
        """Forget what was planned, for a new game."""
        self._step = 0
        self._due: list[tuple[int, Control, bool]] = []
        self._thought: Iterator[None] | None = None
        self._busy = self._wary = 0

    def tick(self) -> None:
        """Press what it thinks right before the next step."""
        self._step += 1
        if self._due:
            self._press_due()
        if self._thought is not None:
            self._think_on(self._thought)
        elif self._step % DECIDE == 0 and self._step >= self._busy:
            self._decide()

    def _press_due(self) -> None:
        """Press what is due now."""
        ripe = [entry for entry in self._due if entry[0] <= self._step]
        for entry in ripe:
            self._due.remove(entry)
            self._press(entry[1], entry[2])

    def _plan(self, wait: int, control: Control, down: bool) -> None:
        """Press a control, or let it go, so many steps from now."""
        self._due.append((self._step + wait, control, down))

    # -- what to think about -----------------------------------------------------------------------------------------

    def _decide(self) -> None:
        """Look at where balls are, and begin to think about the one that will be lost first."""
        if self._game.phase is Phase.ENTRY:
            self._tap(Control.PLUNGER, 60)
            return
        table, balls = self._game.table, self._game.world.balls
        # To look ahead interpreted would hold up the game.
        blind = carom.compiling()
        urgent: State | None = None
        for (x, y), (vx, vy) in zip(balls.position.tolist(), balls.velocity.tolist(), strict=True):
            if table.beyond_lane(x, y) < BALL_RADIUS:
                if y < FOOT and not self._due:
                    self._tap(Control.PLUNGER, self._pull() + self._random.randrange(PULL_CHANCE))
            elif blind:
                continue
            elif SIDE_LOW < y < SIDE_HIGH and abs(x - table.middle) > SIDE and self._step >= self._wary:
                self._keep_out((x, y, vx, vy))
            elif y < LOW and vy < RISING and (urgent is None or y < urgent[1]):
                urgent = (x, y, vx, vy)
        if urgent is not None:
            self._thought = self._think(urgent)
        else:
            self._let_go()

    def _pull(self) -> int:
        """For how many steps to draw the plunger, for the lane that blinks."""
        lamps = self._game.lamps
        return next((pull for name, pull in PULLS.items() if lamps[name] is LampState.BLINK), PULLS["middle lane"])

    def _keep_out(self, state: State) -> None:
        """Nudge the table, if that keeps a ball out of an outlane."""
        self._wary = self._step + SIDE_REST
        table, nothing = self._game.table, Presses()
        worth = self._foresight.worth(table, state, nothing, SIDE_AHEAD)
        if worth > LOST:
            return
        x, y, vx, vy = state
        for control, (along, up) in NUDGES.items():
            if self._foresight.worth(table, (x, y, vx + along, vy + up), nothing, SIDE_AHEAD) > LOST:
                self._wary = self._step + NUDGE_REST
                self._tap(control, 60)
                return

    def _tap(self, control: Control, steps: int) -> None:
        """Press a control now, and let it go after some steps."""
        self._plan(1, control, True)
        self._plan(1 + steps, control, False)

    def _let_go(self) -> None:
        """Let the flippers fall that are held."""
        for control, flipper in ((Control.LEFT, self._game.table.left), (Control.RIGHT, self._game.table.right)):
            if flipper.pressed and not any(due is control for _, due, _ in self._due):
                self._plan(1, control, False)

    # -- thinking ----------------------------------------------------------------------------------------------------

    def _think_on(self, thought: Iterator[None]) -> None:
        """Do a step of thinking."""
        try:
            next(thought)
        except StopIteration:
            self._thought = None

    def _think(self, state: State) -> Iterator[None]:
        """Try what can be done about a ball, something in each step, and plan the best."""
        began = self._step
        table = self._game.table
        held = (table.left.pressed, table.right.pressed)
        still = hypot(state[2], state[3]) < STILL and any(held)
        options = self._options(state, held, still)
        yield
        best, worth = Presses(), -inf
        if not still:
            worth = self._foresight.worth(table, state, best, OUTCOME)
            yield
        for presses in options:
            last = max((*presses.left, *presses.right))
            found = self._foresight.worth(table, state, presses, last - FLIP + OUTCOME)
            if found > worth:
                best, worth = presses, found
            yield
        self._carry_out(best, held, 0 if still else self._step - began)

    def _options(self, state: State, held: tuple[bool, bool], still: bool) -> list[Presses]:
        """What can be done: flips at several moments, and raising a flipper that is to catch the ball."""
        table = self._game.table
        after = RELEASE if any(held) and not still else 0
        let_go = tuple((after,) if side else () for side in held)
        track = self._foresight.track(table, state, Presses(*let_go), after + (CRADLE_AHEAD if still else AHEAD), EVERY)
        options: list[Presses] = []
        for left in (True, False):
            own = let_go[0 if left else 1]
            other = let_go[1 if left else 0]
            ripe = [index * EVERY for index in sweeps(table, track, left) if index * EVERY > after + 6]
            thinned = ripe[:: max(1, -(-len(ripe) // TRIES))]
            options += [_presses((*own, at, at + FLIP), other, left) for at in thinned]
            if ripe and not any(held):
                options.append(_presses((max(ripe[0] - RAISE, 24),), other, left))
        return options

    def _carry_out(self, presses: Presses, held: tuple[bool, bool], gone: int) -> None:
        """Plan presses that were thought out so many steps ago."""
        late = self._random.randrange(LATE)
        self._busy = self._step + 4 * DECIDE
        for control, ats, down in ((Control.LEFT, presses.left, held[0]), (Control.RIGHT, presses.right, held[1])):
            for at in ats:
                down = not down
                wait = max(at - gone, 0) + late
                self._plan(wait, control, down)
                self._busy = max(self._busy, self._step + wait + DECIDE)


def _presses(own: tuple[int, ...], other: tuple[int, ...], left: bool) -> Presses:
    """The presses of one flipper, left or right, and of the other."""
    return Presses(own, other) if left else Presses(other, own)
