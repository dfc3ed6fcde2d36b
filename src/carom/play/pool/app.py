"""The pool end game as a game of the window: events, sounds, frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from carom.play.controls import Controls
from carom.play.meter import FrameMeter
from carom.play.pool import sounds
from carom.play.pool.actions import BUTTONS, KEYS, Action
from carom.play.pool.game import STEP, Phase
from carom.play.pool.layout import SIZE
from carom.play.pool.session import POWER_NOTCH, Mode, Session
from carom.play.pool.view import View
from carom.play.sound import Speaker
from carom.play.window import RATE, Ticker, play

if TYPE_CHECKING:
    from collections.abc import Callable

#: The mouse's buttons that draw the cue and put it down.
LEFT_BUTTON, RIGHT_BUTTON = 1, 3

MOUSE = {LEFT_BUTTON: Action.DRAW, RIGHT_BUTTON: Action.CANCEL}


class PoolApp:
    """The game as a window shows it: `seed` says which positions come, `balls` how many are to be potted."""

    title = "carom: the pool end game"
    size = SIZE

    def __init__(self, tell: Callable[[str], None], seed: int = 0, balls: int = 1) -> None:
        self.session = Session(seed, balls)
        self.controls: Controls[Action] = Controls(KEYS, BUTTONS, tell)
        self.speaker = Speaker(sounds.waves(), tell)
        self.view = View(self.session)
        self._views = {1: self.view}
        self.meter = FrameMeter(RATE)
        self._ticker = Ticker(STEP)
        self._phase = Phase.AIM
        # What the game asks the world is compiled before the first frame, not in the first shot.
        with self.session.pool.trial():
            self.session.pool.shoot(self.session.direction, 0.0)
            self.session.pool.step()
        self.session.preview()

    def magnify(self, times: int) -> None:
        """Draw the picture `times` as large from now on."""
        if times not in self._views:
            self._views[times] = View(self.session, times)
        self._views[times].go_on_from(self.view)
        self.view = self._views[times]
        self.size = self.view.layout.size

    @property
    def running(self) -> bool:
        """Whether the player wants to go on."""
        return self.session.running

    @running.setter
    def running(self, value: bool) -> None:
        self.session.running = value

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event."""
        if event.type == pygame.MOUSEMOTION:
            self.session.point(self.view.layout.place(event.pos))
        elif event.type == pygame.MOUSEWHEEL:
            self.session.change_power(POWER_NOTCH * event.y)
        elif event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            self._click(event)
        else:
            for action, down in self.controls.read(event):
                self._do(action, down)

    def _click(self, event: pygame.event.Event) -> None:
        """Take a button of the mouse: the left one drags the cue ball where it may be put, else it draws the cue."""
        down, session = event.type == pygame.MOUSEBUTTONDOWN, self.session
        if event.button == LEFT_BUTTON and session.dragging and not down:
            session.let_go()
        elif event.button == LEFT_BUTTON and down and session.grab(self.view.layout.place(event.pos)):
            return
        elif event.button in MOUSE:
            self._do(MOUSE[event.button], down)

    def _do(self, action: Action, down: bool) -> None:
        """Begin or end an action."""
        (self.session.begin if down else self.session.end)(action)

    def advance(self, seconds: float) -> None:
        """Make the steps that are due, and the sounds of what happened in them."""
        for _ in range(self._ticker.due(seconds)):
            self.session.tick()
        self._sound()

    def _sound(self) -> None:
        """Play what was not heard yet."""
        pool = self.session.pool
        self.speaker.muted = Mode.MUTE in self.session.modes
        for impact, impulse in pool.noises:
            self.speaker.play(impact, sounds.volume(impact, impulse))
        pool.noises.clear()
        if pool.over and pool.phase is not self._phase:
            self.speaker.play(sounds.WON if pool.phase is Phase.WON else sounds.LOST, 0.8)
        self._phase = pool.phase

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the frame."""
        self.view.draw(surface, self.session, self.meter)


def run(*, tell: Callable[[str], None], seconds: float | None = None, balls: int = 1) -> FrameMeter:
    """The times of the frames of a sitting with so many balls, which ends with the window or after some seconds."""
    return play(lambda: PoolApp(tell, balls=balls), seconds)
