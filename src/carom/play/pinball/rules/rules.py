"""The rules of the pinball game: points, lamps, the bonus, its multiplier, the bank, modes, multiball, the extra ball.

Rollovers of the top lanes light them, and the flippers rotate the lit ones; all three raise the bonus multiplier, and
the second time brings an extra ball, once a game. Drop targets make a bank; every second bank of a ball starts
multiball, in which orbits, banks and the saucer are jackpots. Inlanes light the orbits. Bumpers light, and all three
lit raise what they give and start a mode. So does the saucer, which in a mode gives more time for it; it closes with
each ball that it has held, and an orbit opens it again.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from random import Random

from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.rules.lamps import BANK, BUMPERS, INLANES, LANES, MULTIPLIERS, ORBITS, SAUCER, Lamps, LampState
from carom.play.pinball.rules.modes import Modes
from carom.play.pinball.rules.table import Part, Table

ON, OFF, BLINK = LampState.ON, LampState.OFF, LampState.BLINK

#: Steps in a second.
RATE = 480

BUMPER, BUMPER_MORE, BUMPER_MOST = 100, 100, 1_000
SLINGSHOT = 50
TARGET, DROP = 500, 1_000
BANK_FIRST, BANK_MORE = 10_000, 5_000
BANKS_FOR_MULTIBALL = 2
LANE, LANE_AGAIN, LANES_ALL, LANES_SPENT = 500, 100, 5_000, 25_000
SKILL = 10_000
ORBIT, ORBIT_LIT = 2_500, 10_000
INLANE, OUTLANE = 500, 2_000
SPINNER = 100
SAUCER_CATCH = 3_000
MULTIBALL, JACKPOT, JACKPOT_MORE = 10_000, 25_000, 5_000
MOST_MULTIPLIED, EXTRA_AT = 5, 3
BONUS_MOST = 50_000

#: Seconds: of the ball save at a ball's beginning and at that of multiball, of lit orbits, of a skill shot's chance,
#: from the bank's end until the targets rise again, and those that the saucer adds to a mode.
SAVER, MULTIBALL_SAVER, LIT_ORBITS, SKILL_TIME, BANK_REST, MORE_TIME = 12, 10, 10, 8, 1, 10


class Rules:
    """What is scored, and what burns; it hears of what balls strike and cross, and of time.

    Attributes:
        score: Of the game.
        bonus: Of the ball, before it is multiplied.
        multiplier: Of the bonus, 1 to 5.
        balls_due: Balls that multiball is to bring yet.
        extra_ball: Whether a ball was won that is to be played yet.
        multiball: Whether more than one ball is played.
    """

    def __init__(self, table: Table, emit: Callable[[Event], None], random: Random) -> None:
        self.table = table
        self.lamps = Lamps()
        self._emit = emit
        self._random = random
        self._ways: dict[EventKind, Callable[[Part], int]] = {
            EventKind.BUMPER: self._bumper,
            EventKind.SLINGSHOT: lambda _: SLINGSHOT,
            EventKind.TARGET: self._target,
            EventKind.LANE: self._lane,
            EventKind.ORBIT: lambda _: self._orbit(),
            EventKind.SAUCER: lambda _: self._saucer(),
            EventKind.INLANE: self._inlane,
            EventKind.OUTLANE: self._outlane,
        }
        self.start_game()

    # -- beginnings --------------------------------------------------------------------------------------------------

    def start_game(self) -> None:
        """Set all back for a new game."""
        self.score = 0
        self.extra_ball = self._extra_given = False
        self.modes = Modes()
        self.start_ball()

    def start_ball(self) -> None:
        """Set back what lasts for a ball: lamps, bonus, banks."""
        self.bonus, self.multiplier = 0, 1
        self.balls_due = 0
        self.multiball = self.tilted = self._mode_due = False
        self.modes.end()
        self._bumper_worth = BUMPER
        self._banks, self._jackpot = 0, JACKPOT
        self._orbits_left = self._bank_left = self._skill_left = 0
        self.saver_left = 0
        self._spun = 0.0
        self.table.raise_targets()
        self.lamps.put_out()
        self.lamps.put(ON, *self._shoot_again())
        self._open_saucer(True)
        self._skill = LANES[self._random.randrange(3)]
        self.lamps.put(BLINK, self._skill)

    def _shoot_again(self) -> tuple[str, ...]:
        """The lamp of the extra ball, where there is one."""
        return ("shoot again",) if self.extra_ball else ()

    def enter(self) -> None:
        """Begin the ball save and the chance of a skill shot, as the first ball comes onto the field."""
        if self.tilted:
            return
        self.saver_left = max(self.saver_left, SAVER * RATE)
        self._skill_left = SKILL_TIME * RATE
        self.lamps.put(BLINK, "shoot again")

    def tilt(self) -> None:
        """Take the bonus, the ball save and what was due, and put the lamps out until the next ball."""
        self.tilted, self.multiball = True, False
        self.modes.end()
        self.bonus = self.saver_left = self.balls_due = 0
        self.lamps.put_out()
        self.lamps.put(ON, "tilt", *self._shoot_again())

    # -- time --------------------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Let a step's time pass for what lasts a while."""
        if self.saver_left:
            self.saver_left -= 1
            if not self.saver_left:
                self.lamps.put(ON if self.extra_ball else OFF, "shoot again")
        if self._orbits_left:
            self._orbits_left -= 1
            if not self._orbits_left:
                self._put_out(*ORBITS)
        if self._skill_left:
            self._skill_left -= 1
            if not self._skill_left:
                self._end_skill()
        if self._bank_left:
            self._bank_left -= 1
        if self.modes.is_over():
            self._end_mode()

    def raise_bank(self, places: list[tuple[float, float]]) -> None:
        """Raise the targets of a finished bank, once it has rested and no ball at `places` is in the way."""
        if len(self.table.down) < len(BANK) or self._bank_left:
            return
        if all(self.table.clear_of_targets(x, y) for x, y in places):
            self.table.raise_targets()
            self.lamps.put(OFF, *BANK)

    def spin(self, angle: float) -> None:
        """Count what the spinner has turned faster than by itself, and give points by the half turn."""
        self._spun += angle
        if self._spun >= pi:
            self._spun -= pi
            self._give(EventKind.SPINNER, "spinner", self.table.spinner.pivot, 0.0, SPINNER, SPINNER // 10)
            self._shoot("spinner", self.table.spinner.pivot)

    # -- what balls meet ---------------------------------------------------------------------------------------------

    def meet(self, part: Part, place: tuple[float, float], speed: float) -> None:
        """Give what striking or crossing a part brings, and tell of it."""
        way = self._ways.get(part.kind)
        if self.tilted or way is None:
            self._emit(Event(part.kind, part.name, place, speed))
            return
        worth = way(part)
        self._give(part.kind, part.name, place, speed, worth, worth // 10)
        self._finish(part, place)
        self._shoot(part.name, place)
        if self._mode_due:
            self._start_mode(place)

    def _give(
        self, kind: EventKind, part: str, place: tuple[float, float], speed: float, worth: int, bonus: int = 0
    ) -> None:
        """Add points and bonus, and tell of it."""
        if self.tilted:
            worth = bonus = 0
        self.score += worth
        self.bonus = min(self.bonus + bonus, BONUS_MOST)
        self._emit(Event(kind, part, place, speed, worth))

    def _bumper(self, part: Part) -> int:
        """What a bumper gives, double if it was lit; lights it, and with all three lit raises what they give."""
        worth = self._bumper_worth * (2 if self.lamps[part.name] is ON else 1)
        self.lamps.put(ON, part.name)
        self._mode_due = self.lamps.all_on(BUMPERS) and not self.multiball and self.modes.mode is None
        if self.lamps.all_on(BUMPERS) and self._bumper_worth < BUMPER_MOST:
            self._bumper_worth += BUMPER_MORE
            self.lamps.put(OFF, *BUMPERS)
        return worth

    def _target(self, part: Part) -> int:
        """What a target gives; a drop target goes down."""
        if part.name not in BANK:
            self.lamps.put(ON, part.name)
            return TARGET
        if part.name in self.table.down:
            return 0
        self.table.lower(part.name)
        self.lamps.put(ON, part.name)
        return DROP

    def _lane(self, part: Part) -> int:
        """What a top lane gives, most as the skill shot; lights it."""
        if self._skill_left and part.name == self._skill:
            self._end_skill()
            self.lamps.put(ON, part.name)
            return SKILL
        self._end_skill()
        worth = LANE_AGAIN if self.lamps[part.name] is ON else LANE
        self.lamps.put(ON, part.name)
        return worth

    def _end_skill(self) -> None:
        """End the chance of a skill shot."""
        self._skill_left = 0
        if self.lamps[self._skill] is BLINK:
            self.lamps.put(OFF, self._skill)

    def _orbit(self) -> int:
        """What an orbit gives: more when it is lit, a jackpot in multiball; opens the saucer."""
        self._open_saucer(True)
        if self.multiball:
            return self._next_jackpot()
        return ORBIT_LIT if self._orbits_left else ORBIT

    def _next_jackpot(self) -> int:
        """What a jackpot gives; the next one gives more."""
        worth = self._jackpot
        self._jackpot += JACKPOT_MORE
        return worth

    def _saucer(self) -> int:
        """What the saucer gives, a jackpot in multiball; it closes."""
        self._open_saucer(False)
        return self._next_jackpot() if self.multiball else SAUCER_CATCH

    def _open_saucer(self, is_open: bool) -> None:
        """Open the saucer, or close it, and have its lamp say so."""
        self.table.saucer_open = is_open
        self.lamps.put(BLINK if is_open else OFF, SAUCER)

    def _inlane(self, part: Part) -> int:
        """What an inlane gives; lights the orbits for a while."""
        self.lamps.put(OFF, *INLANES)
        self.lamps.put(ON, part.name)
        self._orbits_left = LIT_ORBITS * RATE
        self.lamps.put(BLINK, *ORBITS)
        return INLANE

    def _outlane(self, part: Part) -> int:
        """What an outlane gives, for consolation."""
        self.lamps.put(ON, part.name)
        return OUTLANE

    # -- feats -------------------------------------------------------------------------------------------------------

    def _finish(self, part: Part, place: tuple[float, float]) -> None:
        """Reward a row of lanes or a bank that the part has made complete, or a ball in the saucer."""
        if part.kind is EventKind.LANE and self.lamps.all_on(LANES):
            self._all_lanes(place)
        elif part.name in BANK and len(self.table.down) == len(BANK) and not self._bank_left:
            self._bank_left = BANK_REST * RATE
            self._bank(place)
        elif part.kind is EventKind.SAUCER and not self.multiball:
            self._catch(place)

    def _catch(self, place: tuple[float, float]) -> None:
        """Reward a ball in the saucer: by more time for the mode, or by the next one where none goes on."""
        if self.modes.mode is None:
            self._mode_due = True
        else:
            self.modes.prolong(MORE_TIME * RATE)
            self._give(EventKind.MORE, f"{MORE_TIME} S MORE", place, 0.0, 0)

    def _all_lanes(self, place: tuple[float, float]) -> None:
        """Raise the multiplier, which brings an extra ball once; where it cannot rise it gives points."""
        self.lamps.put(OFF, *LANES)
        if self.multiplier < MOST_MULTIPLIED:
            self.multiplier += 1
            self.lamps.put(ON, MULTIPLIERS[self.multiplier - 2])
            self._give(EventKind.LANES, "", place, 0.0, LANES_ALL)
        else:
            self._give(EventKind.LANES, "", place, 0.0, LANES_SPENT)
        if self.multiplier >= EXTRA_AT and not self._extra_given:
            self._extra_given = self.extra_ball = True
            self.lamps.put(ON, "shoot again")
            self._give(EventKind.EXTRA, "", place, 0.0, 0)

    def _bank(self, place: tuple[float, float]) -> None:
        """Reward a bank; the second one starts multiball, and in multiball each is a jackpot."""
        self._banks += 1
        self.lamps.put(BLINK, *BANK)
        if self.multiball:
            self._give(EventKind.BANK, "jackpot", place, 0.0, 2 * self._next_jackpot())
            return
        self._give(EventKind.BANK, "", place, 0.0, BANK_FIRST + BANK_MORE * (self._banks - 1), TARGET)
        if self._banks % BANKS_FOR_MULTIBALL == 0:
            self._start_multiball(place)
        else:
            self.lamps.put(BLINK, "multiball")

    def _start_multiball(self, place: tuple[float, float]) -> None:
        """Call for two more balls and light the jackpots."""
        self._end_mode()
        self.multiball = True
        self.balls_due = 2
        self._jackpot = JACKPOT
        self._open_saucer(True)
        self.saver_left = MULTIBALL_SAVER * RATE
        self.lamps.put(ON, "multiball")
        self.lamps.put(BLINK, "jackpot", "shoot again", *ORBITS)
        self._give(EventKind.MULTIBALL, "", place, 0.0, MULTIBALL)

    def end_multiball(self) -> None:
        """End multiball, for one ball is left."""
        self.multiball = False
        self.lamps.put(OFF, "multiball", "jackpot", *ORBITS)
        self._orbits_left = 0

    # -- modes -------------------------------------------------------------------------------------------------------

    @property
    def goal(self) -> str:
        """What to shoot and why, in a line."""
        if self.multiball:
            return "ORBITS ARE JACKPOTS"
        if self.modes.mode is not None:
            return self.modes.line(RATE)
        if self._banks % BANKS_FOR_MULTIBALL:
            return "BANK FOR MULTIBALL"
        if self._orbits_left:
            return "LIT ORBITS 10,000"
        return "SAUCER FOR A MODE" if self.table.saucer_open else "BUMPERS FOR A MODE"

    def _start_mode(self, place: tuple[float, float]) -> None:
        """Begin the next mode, and light what it wants."""
        self._mode_due = False
        mode = self.modes.start(RATE)
        self.lamps.put(OFF, *BUMPERS)
        self.lamps.put(BLINK, *mode.lamps)
        self._give(EventKind.MODE, mode.name, place, 0.0, 0)

    def _shoot(self, part: str, place: tuple[float, float]) -> None:
        """Pay for a lit shot of the mode, and for the last one more."""
        worth, mode = self.modes.shoot(part), self.modes.mode
        if not worth or mode is None or self.tilted:
            return
        self._give(EventKind.SHOT, part, place, 0.0, worth)
        if self.modes.is_whole:
            self._end_mode()
            self._give(EventKind.FEAT, mode.name, place, 0.0, mode.reward)

    def _end_mode(self) -> None:
        """End the mode and put out what it had lit, unless that is lit for something else."""
        lit = self.modes.mode.lamps if self.modes.mode is not None else ()
        self.modes.end()
        self._put_out(*lit)

    def _put_out(self, *names: str) -> None:
        """Put lamps out that neither multiball nor a mode nor an inlane has lit."""
        wanted = self.modes.mode.lamps if self.modes.mode is not None else ()
        if self.multiball or self._orbits_left:
            wanted += ORBITS
        self.lamps.put(OFF, *(name for name in names if name not in wanted))

    def change_lanes(self, step: int) -> None:
        """Move the lit top lanes by one, to the left (-1) or to the right (1)."""
        states = [self.lamps[name] for name in LANES]
        for place, name in enumerate(LANES):
            self.lamps.put(states[(place - step) % len(LANES)], name)
        self._skill = LANES[(LANES.index(self._skill) + step) % len(LANES)]

    def pay_bonus(self, most: int) -> int:
        """The bonus points paid now: `most` at most of what is left, multiplied."""
        paid = min(self.bonus, most)
        self.bonus -= paid
        self.score += paid * self.multiplier
        return paid * self.multiplier
