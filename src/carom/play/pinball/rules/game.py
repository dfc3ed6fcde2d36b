"""The pinball game: balls, flippers, plunger, nudges and phases, one step of 1/480 s at a time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import sqrt
from random import Random
from typing import Any

import numpy as np

import carom
from carom.play.pinball.robot.player import Player
from carom.play.pinball.rules.balls import LOOK, Balls, BallState
from carom.play.pinball.rules.controls import NUDGES, Control, Phase
from carom.play.pinball.rules.entry import Entry
from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.rules.journal import Journal, message_of
from carom.play.pinball.rules.lamps import SAUCER, LampState
from carom.play.pinball.rules.ledger import Ledger
from carom.play.pinball.rules.rules import RATE, Rules
from carom.play.pinball.rules.scores import HighScores
from carom.play.pinball.rules.table import IDLE_SPIN, STEP, Flipper, Part, Table

BALLS = 3
#: Steps: until the plunger is drawn wholly, before a ball is launched by itself, between two steps of the bonus, and
#: how long the game's end and the choice of initials last when nobody presses anything.
PULL_TIME, AUTO_WAIT, BONUS_STEP, OVER_TIME, ENTRY_TIME = 720, 288, 24, 6 * RATE, 60 * RATE
#: Steps for which the game's end and the choice of initials heed nothing: what is pressed then was meant for the ball.
GUARD = RATE
#: The speed that the plunger gives: drawn wholly, and by itself, with so much of chance added.
PLUNGER_SPEED, AUTO_SPEED, AUTO_CHANCE = 66.0, 56.5, 6.5
#: Bonus points paid in a step of counting.
BONUS_POINTS = 250
#: A nudge adds unrest, which calms by the second; more unrest than that earns a warning, the third time a tilt.
UNREST, CALM, MOST_UNREST, MOST_WARNINGS = 1.0, 0.6, 2.0, 2
#: What is struck more gently is not told of, in units/s.
GENTLE = 1.5
#: Steps between two looks at where balls are, and at the spinner.
WATCH, SPIN_LOOK = 4, 24


class Pinball:
    """A game of pinball; the same seed and the same presses before the same steps make the same game, to the bit.

    It begins with a demonstration, which plays itself until `START` is pressed. `press` acts on the very next `tick`.

    Attributes:
        table: The table with its parts, and its `world`.
        high_scores: Where high scores go.
        ball_number: Which ball of the game is played, from 1.
        plunger_pull: How far the plunger is drawn, 0 to 1.
        warnings: Warnings before a tilt that this ball has had.
    """

    STEP = STEP

    def __init__(self, high_scores: HighScores | None = None, seed: int = 0) -> None:
        self.high_scores = HighScores() if high_scores is None else high_scores
        self._random = Random(seed)
        self.table = Table()
        self._balls = Balls(self.table, self._random)
        self._journal = Journal()
        self._rules = Rules(self.table, self._emit, self._random)
        self._presses: list[tuple[Control, bool]] = []
        self._entry = Entry(self.high_scores.last)
        self._stages: dict[Phase, Callable[[], None]] = {
            Phase.PLAY: self._tick_play,
            Phase.BONUS: self._tick_bonus,
            Phase.ENTRY: self._tick_entry,
            Phase.OVER: self._tick_over,
        }
        self._steps = 0
        self._kicking = False
        self._player = Player(self, seed, lambda control, down: self._presses.append((control, down)))
        self._demo: Player | None = None
        self._begin_demo()

    # -- what can be read --------------------------------------------------------------------------------------------

    @property
    def world(self) -> carom.World:
        """The world of the table."""
        return self.table.world

    @property
    def phase(self) -> Phase:
        """What the game is about; `ATTRACT` while the demonstration plays."""
        return Phase.ATTRACT if self._demo is not None else self._stage

    @property
    def score(self) -> int:
        """The points of the game, or of the demonstration."""
        return self._rules.score

    @property
    def balls_in_play(self) -> int:
        """How many balls are on the field."""
        return self.ledger.in_play

    @property
    def multiplier(self) -> int:
        """By what the bonus is multiplied, 1 to 5."""
        return self._rules.multiplier

    @property
    def bonus(self) -> int:
        """The bonus of the ball, before it is multiplied."""
        return self._rules.bonus

    @property
    def saver(self) -> float:
        """Seconds of ball save that are left."""
        return self._rules.saver_left / RATE

    @property
    def tilted(self) -> bool:
        """Whether the ball is lost to a tilt."""
        return self._rules.tilted

    @property
    def multiball(self) -> bool:
        """Whether more than one ball is played."""
        return self._rules.multiball

    @property
    def lamps(self) -> Mapping[str, LampState]:
        """Every lamp's state by its name."""
        return self._rules.lamps

    @property
    def ledger(self) -> Ledger:
        """Where the game's balls are."""
        return self._balls.ledger

    @property
    def flipper_angles(self) -> tuple[float, float]:
        """How far the left and the right flipper are from their rest, in radians."""
        return self.table.left.angle, self.table.right.angle

    @property
    def initials(self) -> str:
        """The initials that are being chosen."""
        return self._entry.initials

    @property
    def initial_place(self) -> int:
        """Which of the three letters is being chosen, from 0."""
        return self._entry.place

    @property
    def message(self) -> str:
        """What the score display says."""
        return message_of(self, self._journal.notice)

    @property
    def goal(self) -> str:
        """What to shoot and why, in a line."""
        return self._rules.goal

    def take_events(self) -> list[Event]:
        """What has happened since this was last asked, in order."""
        return self._journal.take()

    # -- what can be done --------------------------------------------------------------------------------------------

    def press(self, control: Control, down: bool) -> None:
        """Press a control or let it go, before the next step.

        While the demonstration plays, only `START` is heeded.
        """
        if self._demo is None:
            self._presses.append((control, down))
        elif control is Control.START and down:
            self._demo = None
            self._presses.clear()
            self._start_game()

    def tick(self) -> None:
        """Make one step of `STEP` seconds."""
        if self._demo is not None:
            self._demo.tick()
        self._steps += 1
        if self._presses:
            presses, self._presses = self._presses, []
            for control, down in presses:
                self._heed(control, down)
        self._stages[self._stage]()

    # -- games and balls ---------------------------------------------------------------------------------------------

    def _begin_demo(self) -> None:
        """Begin a game that plays itself."""
        self._demo = Player(
            self, self._random.randrange(2**32), lambda control, down: self._presses.append((control, down))
        )
        self._start_game()

    def _start_game(self) -> None:
        """Begin a game with its first ball."""
        self._balls.clear()
        self.table.reset()
        self._rules.start_game()
        self.ball_number = 1
        self._knocked = False
        self._start_ball()
        self._tell(EventKind.GAME_START)

    def _start_ball(self) -> None:
        """Serve the next ball of the game."""
        self._stage = Phase.PLAY
        self._wait = 0
        self.plunger_pull = 0.0
        self._pulling = False
        self.warnings, self._unrest = 0, 0.0
        self._journal.clear()
        self._owed = 0
        self._automatic = False
        self._rules.start_ball()
        self._serve()

    def _serve(self) -> None:
        """Put a ball on the plunger."""
        ball = self._balls.serve()
        self._tell(EventKind.SERVE, "plunger", ball.position)
        self._wait = 0

    def _emit(self, event: Event) -> None:
        """Note an event."""
        self._journal.note(event, self._rules.multiball)

    def _tell(self, kind: EventKind, part: str = "", place: tuple[float, float] = (0.0, 0.0), score: int = 0) -> None:
        """Note an event in which nothing was struck."""
        self._emit(Event(kind, part, place, 0.0, score))

    # -- controls ----------------------------------------------------------------------------------------------------

    def _heed(self, control: Control, down: bool) -> None:
        """Do what a press means in the phase that the game is in."""
        if self._stage is Phase.PLAY:
            self._heed_play(control, down)
        elif self._stage is Phase.ENTRY:
            self._heed_entry(control, down)
        elif self._stage is Phase.OVER and control is Control.START and down and self._wait >= 0:
            self._start_game()
        elif control in (Control.LEFT, Control.RIGHT) and not down:
            self._flipper(control).press(False)

    def _heed_play(self, control: Control, down: bool) -> None:
        """Move flippers and plunger, or nudge."""
        if control in (Control.LEFT, Control.RIGHT):
            self._flip(control, down)
        elif control is Control.PLUNGER:
            self._plunge(down)
        elif control in NUDGES and down:
            self._nudge(control)

    def _flipper(self, control: Control) -> Flipper:
        """The flipper that a control moves."""
        return self.table.left if control is Control.LEFT else self.table.right

    def _flip(self, control: Control, down: bool) -> None:
        """Raise a flipper, unless the table is tilted, and move the lit lanes; or let it fall."""
        flipper = self._flipper(control)
        if flipper.press(down and not self.tilted):
            self._rules.change_lanes(-1 if control is Control.LEFT else 1)
            self._tell(EventKind.FLIPPER, f"{control.value} flipper", flipper.shape.pivot)

    def _plunge(self, down: bool) -> None:
        """Begin to draw the plunger, or let it go."""
        if down:
            self._pulling = True
        elif self._pulling:
            self._launch(PLUNGER_SPEED * sqrt(self.plunger_pull))
            self._pulling = False
            self.plunger_pull = 0.0

    def _launch(self, speed: float) -> None:
        """Have the plunger kick with a speed in this step."""
        state = self._balls.on_plunger()
        self.table.plunger.kick = speed
        self._kicking = True
        if state is not None:
            self._emit(Event(EventKind.LAUNCH, "plunger", state.ball.position, speed))

    def _nudge(self, control: Control) -> None:
        """Push the table, which moves every ball on the field; too much of it brings warnings and tilt."""
        if self.tilted:
            return
        along, up = NUDGES[control]
        for state in self._balls.in_play:
            vx, vy = state.ball.velocity
            state.ball.velocity = (vx + along, vy + up)
        self._tell(EventKind.NUDGE, control.value)
        self._unrest += UNREST if self._balls.in_play else 0.0
        if self._unrest <= MOST_UNREST:
            return
        if self.warnings < MOST_WARNINGS:
            self.warnings += 1
            self._tell(EventKind.WARNING)
        else:
            self._tilt()

    def _tilt(self) -> None:
        """Let the flippers fall for the rest of the ball."""
        self._rules.tilt()
        self._owed = 0
        self.table.left.press(False)
        self.table.right.press(False)
        self._tell(EventKind.TILT)

    # -- play --------------------------------------------------------------------------------------------------------

    def _tick_play(self) -> None:
        """Make a step in which balls roll, but for one that the saucer holds."""
        let_go = self._balls.hold()
        if let_go is not None:
            self._tell(EventKind.KICKOUT, SAUCER, let_go.ball.position)
        hits = self.world.step(STEP)
        if self._kicking:
            self.table.plunger.kick = 0.0
            self._kicking = False
        if len(hits):
            self._hear(hits)
        if self._steps % WATCH == 0:
            self._watch()
        self._pass_time()
        self._settle()

    def _watch(self) -> None:
        """Look where balls are: some come onto the field, and one that strays is taken and owed."""
        entered, strays = self._balls.watch()
        for state in entered:
            self._enter(state)
        for state in strays:
            self._balls.take(state.ball.id or 0, stray=True)
            self._owed += 1

    def _pass_time(self) -> None:
        """Let a step's time pass for rules, plunger, spinner and what rests."""
        self._rules.tick()
        self._journal.tick()
        if self._pulling:
            self.plunger_pull = min(self.plunger_pull + 1.0 / PULL_TIME, 1.0)
        if self._unrest > 0.0:
            self._unrest = max(self._unrest - CALM * STEP, 0.0)
        if self._steps % SPIN_LOOK == 0:
            spin = abs(self.table.spinner.angular_velocity)
            if spin > IDLE_SPIN:
                self._rules.spin(spin * SPIN_LOOK * STEP)
                self.table.slow_spinner()
        if self._steps % LOOK == 0:
            if self._demo is None and not self._knocked and self.score > self.high_scores.best.score:
                self._knocked = True
                self._tell(EventKind.KNOCK)
            for state in self._balls.free():
                self._tell(EventKind.FREED, "", state.ball.position)
            self._rules.raise_bank([state.ball.position for state in self._balls.in_play])

    def _hear(self, hits: Any) -> None:
        """Tell the rules what was struck and crossed, and take the balls that drained."""
        for _, kind, ball, shape, point, normal, _, _, impulse, *_ in hits.view(np.ndarray).tolist():
            part = self.table.parts.get(shape)
            place = (float(point[0]), float(point[1]))
            if kind == carom.HitKind.BOUNCE:
                self._hear_bounce(part, place, normal, impulse)
            elif kind == carom.HitKind.ENTER and part is not None:
                self._hear_crossing(part, ball)

    def _hear_bounce(self, part: Part | None, place: tuple[float, float], normal: Any, impulse: float) -> None:
        """Tell the rules of a bounce off a part, or off another ball."""
        if impulse < GENTLE:
            return
        if part is None:
            self._emit(Event(EventKind.BOUNCE, "ball", place, impulse))
        elif part.kind is EventKind.SPINNER:
            self.table.strike_spinner(place, (-impulse * float(normal[0]), -impulse * float(normal[1])))
            self._emit(Event(EventKind.BOUNCE, part.name, place, impulse))
        else:
            self._rules.meet(part, place, impulse)

    def _hear_crossing(self, part: Part, ball: int) -> None:
        """Tell the rules of a rollover, an orbit only upward; a ball in the drain is taken."""
        if part.kind is EventKind.DRAIN:
            self._drain(ball)
            return
        state = self._balls.states.get(ball)
        if state is None or state.held or (part.kind is EventKind.ORBIT and state.ball.velocity[1] <= 0.0):
            return
        if part.kind is not EventKind.SAUCER or (not self.tilted and self._balls.catch(ball)):
            self._rules.meet(part, part.place, 0.0)

    def _enter(self, state: BallState) -> None:
        """Take note of a ball that comes through the launch gate onto the field."""
        self._tell(EventKind.GATE, "launch gate", state.ball.position)
        if self.ledger.in_play == 1 and not self._automatic:
            self._rules.enter()
        self._automatic = False

    # -- ends --------------------------------------------------------------------------------------------------------

    def _drain(self, ball: int) -> None:
        """Take a ball from the drain, and owe one for it where it is saved."""
        state = self._balls.take(ball)
        if state is None:
            return
        place = state.ball.position
        self._tell(EventKind.DRAIN, "drain", place)
        if state.held or (self._rules.saver_left and not self.tilted):
            self._owed += 1
            self._tell(EventKind.SAVE, "", place)

    def _settle(self) -> None:
        """Serve balls that are owed, launch those, and end multiball and the ball."""
        due = self._owed + self._rules.balls_due
        if due and not self.ledger.held:
            if self._owed:
                self._owed -= 1
            else:
                self._rules.balls_due -= 1
            self._serve()
            self._automatic = True
        if self._automatic:
            self._wait += 1
            if self._wait % AUTO_WAIT == 0 and self._balls.ready():
                self._launch(AUTO_SPEED + AUTO_CHANCE * self._random.random())
        if self._rules.multiball and not due and len(self._balls) < 2:
            self._rules.end_multiball()
        if not len(self._balls):
            self._end_ball()

    def _end_ball(self) -> None:
        """Begin to count the bonus up."""
        self._stage = Phase.BONUS
        self._wait = 0
        self.plunger_pull, self._pulling = 0.0, False
        self.table.left.press(False)
        self.table.right.press(False)

    def _tick_bonus(self) -> None:
        """Make a step of counting the bonus up, after which the next ball or the end comes."""
        self.world.step(STEP)
        self._wait += 1
        if self._wait % BONUS_STEP:
            return
        paid = self._rules.pay_bonus(BONUS_POINTS * (1 + self._wait // RATE))
        if paid:
            self._tell(EventKind.BONUS, "", (0.0, 0.0), paid)
        elif self._rules.extra_ball:
            self._rules.extra_ball = False
            self._start_ball()
        elif self.ball_number < BALLS:
            self.ball_number += 1
            self._start_ball()
        else:
            self._end_game()

    def _end_game(self) -> None:
        """End the game, with initials to choose where the score is high enough."""
        self._tell(EventKind.GAME_OVER)
        self._wait = -GUARD
        self._stage = Phase.OVER
        if self._demo is None and self.high_scores.place(self.score) is not None:
            self._stage = Phase.ENTRY
            self._entry = Entry(self.high_scores.last)
            self._tell(EventKind.KNOCK)

    def _heed_entry(self, control: Control, down: bool) -> None:
        """Change a letter, or accept it."""
        if down and self._wait >= 0:
            self._wait = 0
            if self._entry.heed(control):
                self._keep_score()

    def type_initial(self, letter: str) -> None:
        """Take a typed letter as an initial, while they are chosen; "" takes the last one back."""
        if self._stage is Phase.ENTRY and self._wait >= 0:
            self._wait = 0
            self._entry.type(letter)

    def _keep_score(self) -> None:
        """Keep the score under the initials."""
        self.high_scores.add(self._entry.initials, self.score)
        self._stage = Phase.OVER
        self._wait = -GUARD

    def _tick_entry(self) -> None:
        """Make a step of choosing initials, which are taken as they stand when nothing was pressed for long."""
        self.world.step(STEP)
        self._wait += 1
        if self._wait >= ENTRY_TIME:
            self._keep_score()

    def _tick_over(self) -> None:
        """Make a step after the end, until the demonstration begins."""
        self.world.step(STEP)
        self._wait += 1
        if self._wait >= OVER_TIME:
            self._begin_demo()
