"""The modes: for a while some shots are lit, each pays, and so many of them pay once more.

Three lit bumpers or the saucer start one, the next in turn; the saucer prolongs it too. A mode ends with its time, its
last shot, multiball or the ball.
"""

from __future__ import annotations

from typing import NamedTuple

from carom.play.pinball.rules.lamps import ORBITS, TARGETS


class Mode(NamedTuple):
    """What is to be shot, and for what.

    Attributes:
        name: What it is called.
        words: What to shoot.
        parts: The names of the shapes that count.
        lamps: Those of them that have lamps.
        worth: Points of each shot.
        shots: How many make it whole.
        reward: Points of that.
        seconds: How long it lasts.
    """

    name: str
    words: str
    parts: tuple[str, ...]
    lamps: tuple[str, ...]
    worth: int
    shots: int
    reward: int
    seconds: int


MODES = (
    Mode("COMET HUNT", "ORBITS", ORBITS, ORBITS, 8_000, 2, 20_000, 30),
    Mode("METEORS", "TARGETS", TARGETS, TARGETS, 4_000, 3, 20_000, 30),
    Mode("SPIN OUT", "SPINNER", ("spinner",), (), 300, 20, 20_000, 30),
)


class Modes:
    """Which mode goes on.

    Attributes:
        mode: The mode, or None.
        shots: How many of its shots were made.
        steps_left: The steps that are left of it.

    >>> modes = Modes()
    >>> modes.start(rate=480).name, modes.shoot("left orbit"), modes.shoot("left target")
    ('COMET HUNT', 8000, 0)
    >>> modes.shoot("right orbit"), modes.is_whole
    (8000, True)
    """

    def __init__(self) -> None:
        self.mode: Mode | None = None
        self.shots = self.steps_left = 0
        self._begun = 0

    def start(self, rate: int) -> Mode:
        """The next mode, which begins now; `rate` is that of steps a second."""
        self.mode = mode = MODES[self._begun % len(MODES)]
        self._begun += 1
        self.shots, self.steps_left = 0, mode.seconds * rate
        return mode

    def prolong(self, steps: int) -> None:
        """Have the mode last so many steps more."""
        self.steps_left += steps

    def shoot(self, part: str) -> int:
        """The points for a part that was met: 0 where it is none that is lit."""
        if self.mode is None or part not in self.mode.parts:
            return 0
        self.shots += 1
        return self.mode.worth

    @property
    def is_whole(self) -> bool:
        """Whether all shots of the mode were made."""
        return self.mode is not None and self.shots >= self.mode.shots

    def is_over(self) -> bool:
        """Whether the mode ends with this step, of which it takes note."""
        if self.mode is not None:
            self.steps_left -= 1
        return self.mode is not None and self.steps_left <= 0

    def end(self) -> None:
        """End the mode, if one goes on."""
        self.mode = None

    def line(self, rate: int) -> str:
        """What to shoot, for how much, and for how many seconds yet; "" where no mode goes on."""
        if self.mode is None:
            return ""
        return f"{self.mode.words} {self.mode.worth:,} {-(-self.steps_left // rate)} S"
