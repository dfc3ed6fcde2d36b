"""The window that a game is played in, and its loop: events, time, picture, sixty times a second."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

import pygame

import carom
from carom.play import screenshot
from carom.play.letters import Letters
from carom.play.meter import FrameMeter
from carom.play.screen import Screen, check_screen

if TYPE_CHECKING:
    from collections.abc import Callable

#: Frames a second.
RATE = 60
#: Seconds: a frame that took longer, as when the window was moved, counts as so long.
LONGEST_FRAME = 0.25
#: What is written in the picture's lower left corner while it is so.
COMPILING = "compiling in the background, once on this machine, for {:.0f} s: until then it may be slow, or stand still"
#: What is written there, one line that hides little of the game's own: letters of so many pixels, their ink, its plate,
#: and how high that is.
SMALL, INK, PLATE, HIGH = 12, (214, 214, 214), (24, 24, 28), 15
#: What a window says until its first frame.
GREETING = "one moment ..."
#: Seconds: steps of a frame that take longer while kernels are compiled are not made again for so long, the longer the
#: more often they did; and how often at most.
LONG, REST, TRIES = 0.07, 1.0, 3
#: The keys that keep a screenshot, and for how many seconds it is said where.
SCREENSHOT = (pygame.K_PRINTSCREEN, pygame.K_F12)
TOLD = 5.0


class Game(Protocol):
    """What a window shows.

    Attributes:
        title: The window's title.
        size: Width and height of the picture in pixels; the window may be larger or smaller.
        running: False once the game wants to be closed.
        meter: Takes the times of the frames; a game makes it and may show what it says.
    """

    title: str
    size: tuple[int, int]
    running: bool
    meter: FrameMeter

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event. Places of the mouse are in the picture's pixels."""

    def advance(self, seconds: float) -> None:
        """Take note that so much time went by since the last frame."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the frame into a surface of `size` pixels."""


@runtime_checkable
class Sharp(Protocol):
    """A game that can draw its picture larger, which is done in large windows instead of enlarging what is drawn."""

    def magnify(self, times: int) -> None:
        """Draw the picture `times` as wide and high as at first from now on; `size` and places follow."""


class Window:
    """A window with a game in it. Raises `NoDisplay` where there is no screen."""

    def __init__(self, game: Game) -> None:
        self._game = game
        self._screen = Screen(game.size, magnified=isinstance(game, Sharp))
        self._times = 1
        self._magnify()
        self._letters = Letters()
        self._shooting = False
        self._kept, self._kept_left = "", 0.0
        self._compiled_for = 0.0
        pygame.display.set_caption(game.title)
        self._greet()

    @property
    def surface(self) -> pygame.Surface:
        """The game's picture."""
        return self._screen.picture

    def frame(self, seconds: float) -> None:
        """Play one frame, `seconds` after the last one."""
        game, screen = self._game, self._screen
        game.meter.begin()
        events = pygame.event.get()
        screen.fit()
        self._magnify()
        for event in events:
            if event.type == pygame.QUIT:
                game.running = False
            elif event.type == pygame.KEYDOWN and event.key == pygame.K_F11:
                screen.toggle_full()
            elif event.type == pygame.KEYDOWN and event.key in SCREENSHOT:
                self._shooting = True
            else:
                game.handle(screen.seen(event))
        game.advance(min(seconds, LONGEST_FRAME))
        game.draw(screen.picture)
        self._keep()
        self._tell(seconds)
        screen.show()
        game.meter.end()
        pygame.display.flip()

    def _greet(self) -> None:
        """Say that the game is about to begin: its first frame takes a moment, for which it is painted."""
        picture, size = self.surface, SMALL * self._times
        picture.fill(PLATE)
        width, height = picture.get_size()
        self._letters.draw(picture, GREETING, (width / 2, (height - size) / 2), size, INK, anchor="middle")
        self._screen.show()
        pygame.display.flip()
        pygame.event.pump()

    def _magnify(self) -> None:
        """Have the game draw as large as the screen has its picture."""
        if self._screen.times != self._times and isinstance(self._game, Sharp):
            self._times = self._screen.times
            self._game.magnify(self._times)

    def _keep(self) -> None:
        """Keep a screenshot, if that was asked for."""
        if self._shooting:
            self._kept, self._kept_left = screenshot.keep(self.surface, self._game.title), TOLD
            self._shooting = False

    def _tell(self, seconds: float) -> None:
        """Write into the picture's corner where a screenshot was kept, or else that kernels are compiled meanwhile."""
        self._compiled_for = self._compiled_for + seconds if carom.compiling() else 0.0
        words = COMPILING.format(self._compiled_for) if self._compiled_for else ""
        if self._kept_left > 0.0:
            words, self._kept_left = self._kept, self._kept_left - seconds
        if not words:
            return
        letters, times = self._letters, self._times
        area = pygame.Rect(0, 0, letters.width(words, SMALL * times) + 12 * times, HIGH * times)
        area.bottomleft = (0, self._game.size[1])
        self.surface.fill(PLATE, area)
        letters.draw(self.surface, words, (area.left + 6 * times, area.top + times), SMALL * times, INK)

    def run(self, seconds: float | None = None) -> FrameMeter:
        """The times of all frames, once the game has been closed or `seconds` are over."""
        ticking, left = pygame.time.Clock(), seconds
        passed = 1.0 / RATE
        while self._game.running and (left is None or left > 0.0):
            self.frame(passed)
            passed = ticking.tick(RATE) / 1e3
            left = None if left is None else left - passed
        return self._game.meter


def play(game: Callable[[], Game], seconds: float | None) -> FrameMeter:
    """The times of all frames of a game, which is made once there is a screen, and played until it ends."""
    try:
        check_screen()
        return Window(game()).run(seconds)
    finally:
        pygame.quit()


class Patience:
    """Lets time stand still where steps, interpreted while kernels are compiled, would keep the window from answering.

    A step that would take much longer yet does not come back until they are compiled. So what took long is tried again
    after a while, and where it took long time and again, only once they are compiled.
    """

    def __init__(self) -> None:
        self._times = 0
        self._rest = 0.0

    def allows(self, seconds: float) -> bool:
        """Whether steps are to be made now that `seconds` went by."""
        self._rest = max(self._rest - seconds, 0.0)
        return not carom.compiling() or (self._rest == 0.0 and self._times < TRIES)

    def took(self, seconds: float) -> None:
        """Take note of how long the steps of a frame took."""
        self._times = self._times + 1 if seconds > LONG else 0
        self._rest = REST * self._times


class Ticker:
    """Makes steps of one length of frames of any length."""

    def __init__(self, step: float, most: float = 0.1) -> None:
        self.step = step
        self._most = most
        self._left = 0.0

    def due(self, seconds: float) -> int:
        """How many steps to make now that `seconds` went by; of a longer time than `most` the rest is let go.

        While kernels are compiled in the background, of a longer time than a frame's is.
        """
        # What is interpreted may take longer than its own time: then it goes on slowly, rather than by leaps.
        self._left = min(self._left + seconds, 1.0 / RATE if carom.compiling() else self._most)
        # A thousandth of a step of grace, so that frames of exactly one step do not make now none, now two.
        steps = int(self._left / self.step + 1e-3)
        self._left -= steps * self.step
        return steps
