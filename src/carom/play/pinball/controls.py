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


class Phase(StrEnum):
    """What the game is about."""

    ATTRACT = "attract"
    PLAY = "play"
    BONUS = "bonus"
    ENTRY = "entry"
    OVER = "over"
