"""What happens in a game of pinball, for sounds, lights and tests."""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple


class EventKind(StrEnum):
    """What an event is."""

    BOUNCE = "bounce"  # off a wall, a post, a guide or another ball
    BUMPER = "bumper"
    SLINGSHOT = "slingshot"
    TARGET = "target"
    BANK = "bank"  # all drop targets are down
    LANE = "lane"
    LANES = "lanes"  # all top lanes are lit
    ORBIT = "orbit"
    INLANE = "inlane"
    OUTLANE = "outlane"
    SPINNER = "spinner"  # half a turn
    SAUCER = "saucer"  # holds a ball
    KICKOUT = "kickout"  # the saucer lets its ball go
    GATE = "gate"
    FLIPPER = "flipper"  # starts up
    FLIPPER_HIT = "flipper hit"
    LAUNCH = "launch"
    SERVE = "serve"  # a ball is put on the plunger
    DRAIN = "drain"
    SAVE = "save"  # a drained ball is given back
    EXTRA = "extra"  # an extra ball is won
    MULTIBALL = "multiball"
    MODE = "mode"  # begins; its name is the part
    MORE = "more"  # time for a mode; its part says how much
    SHOT = "shot"  # a lit shot of a mode
    FEAT = "feat"  # all shots of a mode were made
    NUDGE = "nudge"
    WARNING = "warning"
    TILT = "tilt"
    BONUS = "bonus"  # a step of counting the bonus up
    KNOCK = "knock"  # a new high score
    FREED = "freed"  # a ball at rest was nudged free
    GAME_START = "game start"
    GAME_OVER = "game over"


class Event(NamedTuple):
    """Something that happened in a step of the game.

    Attributes:
        kind: What it was.
        part: The name of the shape, or "".
        place: Where, as (x, y).
        speed: That of the impact, along the normal, in units/s; 0 where nothing struck.
        score: The points given.
    """

    kind: EventKind
    part: str = ""
    place: tuple[float, float] = (0.0, 0.0)
    speed: float = 0.0
    score: int = 0
