"""The Pinball Game as an application: keys and controller, pause, help, drawing modes, sound."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from math import ceil

import pygame

from carom.play.controls import Button, Controls
from carom.play.letters import Letters
from carom.play.meter import FrameMeter
from carom.play.pen import Pen
from carom.play.pinball.art import back as art_back
from carom.play.pinball.art import pictures as art
from carom.play.pinball.art.paint import CREAM, GOLD, NIGHT
from carom.play.pinball.rules.controls import Control, Phase
from carom.play.pinball.rules.game import Pinball
from carom.play.pinball.rules.scores import LETTERS, HighScores
from carom.play.pinball.screen import sounds
from carom.play.pinball.screen.effects import Effects
from carom.play.pinball.screen.help import draw_help
from carom.play.pinball.screen.lines import Mode
from carom.play.pinball.screen.sheet import Sheet
from carom.play.sound import Speaker
from carom.play.window import RATE, Ticker, play


class Command(Enum):
    """What a key does besides playing."""

    HELP = "help"
    RATE = "rate"
    MODE = "mode"
    PAUSE = "pause"
    MUTE = "mute"
    LEAVE = "leave"


Action = Control | Command

KEYS: dict[int, Action] = {
    pygame.K_LSHIFT: Control.LEFT,
    pygame.K_z: Control.LEFT,
    pygame.K_LEFT: Control.LEFT,
    pygame.K_RSHIFT: Control.RIGHT,
    pygame.K_SLASH: Control.RIGHT,
    pygame.K_RIGHT: Control.RIGHT,
    pygame.K_SPACE: Control.PLUNGER,
    pygame.K_DOWN: Control.PLUNGER,
    pygame.K_RETURN: Control.START,
    pygame.K_1: Control.START,
    pygame.K_a: Control.NUDGE_LEFT,
    pygame.K_d: Control.NUDGE_RIGHT,
    pygame.K_w: Control.NUDGE_UP,
    pygame.K_UP: Control.NUDGE_UP,
    pygame.K_F1: Command.HELP,
    pygame.K_F2: Command.RATE,
    pygame.K_F3: Command.MODE,
    pygame.K_p: Command.PAUSE,
    pygame.K_m: Command.MUTE,
    pygame.K_ESCAPE: Command.LEAVE,
}
BUTTONS: dict[Button, Action] = {
    Button.LEFT_SHOULDER: Control.LEFT,
    Button.RIGHT_SHOULDER: Control.RIGHT,
    Button.SOUTH: Control.PLUNGER,
    Button.START: Control.START,
    Button.BACK: Command.PAUSE,
    Button.LEFT: Control.NUDGE_LEFT,
    Button.RIGHT: Control.NUDGE_RIGHT,
    Button.UP: Control.NUDGE_UP,
}


class PinballApp:
    """The pinball game in a window.

    Args:
        tell: Told in one line what is missing: a sound card, a place for high scores.
        game: The game; by default a new one, with the user's high scores.
        seed: Of the new game's chance.
    """

    title = "Carom Comet"
    size = (art.SIZE[0] + art_back.SIZE[0], art.SIZE[1])

    def __init__(self, tell: Callable[[str], None], game: Pinball | None = None, seed: int = 0) -> None:
        self.running = True
        self.game = Pinball(HighScores.load(tell=tell), seed) if game is None else game
        self.mode = Mode.ART
        self.paused = self.helping = self.rating = False
        self._away = False
        self.speaker = Speaker(sounds.make(), tell)
        self.meter = FrameMeter(RATE)
        self._controls: Controls[Action] = Controls(KEYS, BUTTONS, tell)
        self._ticker = Ticker(Pinball.STEP)
        self._letters = Letters()
        self.effects = Effects()
        self._sheets: dict[int, Sheet] = {}
        self._times = 1

    def magnify(self, times: int) -> None:
        """Draw the picture `times` as large from now on."""
        self._times = times
        self.size = (PinballApp.size[0] * times, PinballApp.size[1] * times)

    # -- what comes in -----------------------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event: a press acts on the next step of the game."""
        if event.type in (pygame.WINDOWFOCUSLOST, pygame.WINDOWFOCUSGAINED):
            self._away = event.type == pygame.WINDOWFOCUSLOST
        if self._types(event):
            return
        for action, down in self._controls.read(event):
            if isinstance(action, Control):
                self._press(action, down)
            elif down:
                self._obey(action)

    def _types(self, event: pygame.event.Event) -> bool:
        """Whether an event types an initial or takes one back; keys with letters do nothing else meanwhile."""
        if event.type != pygame.KEYDOWN or self.game.phase is not Phase.ENTRY or self.paused or self.helping:
            return False
        letter = getattr(event, "unicode", "")
        typed = len(letter) == 1 and letter.upper() in LETTERS
        if typed or event.key == pygame.K_BACKSPACE:
            self.game.type_initial(letter if typed else "")
        return typed or event.key == pygame.K_BACKSPACE

    def _press(self, control: Control, down: bool) -> None:
        """Pass a press to the game; what is let go is let go in a pause too."""
        if down and (self.paused or self.helping):
            return
        waiting = self.game.phase in (Phase.ATTRACT, Phase.OVER)
        self.game.press(Control.START if waiting and down and control is Control.PLUNGER else control, down)

    def _obey(self, command: Command) -> None:
        """Do what a key says that does not play."""
        if command is Command.HELP:
            self.helping = not self.helping
        elif command is Command.RATE:
            self.rating = not self.rating
        elif command is Command.MODE:
            self.mode = self.mode.following
        elif command is Command.PAUSE:
            self.paused = not self.paused
        elif command is Command.MUTE:
            self.speaker.muted = not self.speaker.muted
            self.speaker.stop()
        else:
            self._leave()

    def _leave(self) -> None:
        """Close the help, or pause a game, or end: nobody loses a game to one press."""
        if self.helping:
            self.helping = False
        elif self.paused or self.game.phase in (Phase.ATTRACT, Phase.OVER):
            self.running = False
        else:
            self.paused = True

    # -- time --------------------------------------------------------------------------------------------------------

    def advance(self, seconds: float) -> None:
        """Make the steps of the game that are due, with their sounds."""
        if self._away and self.game.phase is not Phase.ATTRACT:
            self.paused = True
        if self.paused or self.helping:
            return
        for _ in range(self._ticker.due(seconds)):
            self.game.tick()
        events = self.game.take_events()
        self.effects.advance(seconds)
        self.effects.note(events)
        sounds.play(self.speaker, events, self.game.phase is Phase.ATTRACT)

    # -- the picture -------------------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the table, its back, and what lies over them."""
        if self._times not in self._sheets:
            self._sheets[self._times] = Sheet(self.game, self._letters, self._times, self.effects)
        self._sheets[self._times].draw(surface, self.mode)
        pen = Pen(surface, self._letters, self._times)
        if self.rating:
            self._draw_rate(pen)
        if self.helping:
            draw_help(surface, self._letters, self._times)
        elif self.paused:
            plate(pen, "PAUSE", (art.SIZE[0] // 2, 392), 34)
            plate(pen, "P goes on, Esc ends", (art.SIZE[0] // 2, 448), 15)

    def _draw_rate(self, pen: Pen) -> None:
        """Draw frames a second and the work of each."""
        meter = self.meter
        words = f"{meter.rate:.0f} frames/s   {1e3 * meter.work:.1f} ms   {100 * meter.share:.0f} %   {self.mode.value}"
        plate(pen, words, (art.SIZE[0] // 2, 6), 13)


def plate(pen: Pen, words: str, place: tuple[int, int], size: int) -> None:
    """Write words on a dark plate, their upper edge's middle at a place."""
    width = ceil(pen.width(words, size))
    around = pygame.Rect(place[0] - width // 2 - 12, place[1], width + 24, size + 14)
    pen.rect(NIGHT, around, radius=6)
    pen.rect(GOLD, around, 2, radius=6)
    pen.words(words, (place[0], place[1] + 6), size, CREAM, anchor="middle")


def run(*, tell: Callable[[str], None], seconds: float | None = None) -> FrameMeter:
    """The times of all frames of a session: played until it is left, or for some seconds."""

    def ready() -> PinballApp:
        """The game after its first step, which has it compiled, now or in the background: before the window opens."""
        app = PinballApp(tell)
        app.game.tick()
        return app

    return play(ready, seconds)
