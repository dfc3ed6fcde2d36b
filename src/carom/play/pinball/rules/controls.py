"""What a player presses, and what a game is about."""

from __future__ import annotations

from enum import StrEnum


class Control(StrEnum):
    """What a player presses."""

    LEFT = "left"
    RIGHT = "right"
    PLUNGER = "plunger"
    NUDGE_LEFT = "nudge left"
    NUDGE_RIGHT = "nudge right"
    NUDGE_UP = "nudge up"
    START = "start"


#: The velocity that a nudge adds to every ball on the field.
NUDGES = {Control.NUDGE_LEFT: (-4.0, 1.5), Control.NUDGE_RIGHT: (4.0, 1.5), Control.NUDGE_UP: (0.0, 4.0)}


class Phase(StrEnum):
    """What the game is about."""

    ATTRACT = "attract"
    PLAY = "play"
    BONUS = "bonus"
    ENTRY = "entry"
    OVER = "over"
