"""What a player can do, and with which keys and buttons."""

from __future__ import annotations

from enum import StrEnum, auto

import pygame

from carom.play.controls import Button


class Action(StrEnum):
    """An action of the player."""

    TURN_LEFT = auto()
    TURN_RIGHT = auto()
    FINE = auto()
    STRONGER = auto()
    WEAKER = auto()
    PLACE_UP = auto()
    PLACE_DOWN = auto()
    DRAW = auto()
    SHOOT = auto()
    CANCEL = auto()
    IMPACTS = auto()
    STEPS = auto()
    FRAME = auto()
    TO_IMPACT = auto()
    AGAIN = auto()
    SAME = auto()
    MORE = auto()
    PAUSE = auto()
    MUTE = auto()
    HELP = auto()
    RATE = auto()
    QUIT = auto()


KEYS = {
    pygame.K_LEFT: Action.TURN_LEFT,
    pygame.K_RIGHT: Action.TURN_RIGHT,
    pygame.K_LSHIFT: Action.FINE,
    pygame.K_RSHIFT: Action.FINE,
    pygame.K_UP: Action.STRONGER,
    pygame.K_DOWN: Action.WEAKER,
    pygame.K_w: Action.PLACE_UP,
    pygame.K_x: Action.PLACE_DOWN,
    pygame.K_SPACE: Action.DRAW,
    pygame.K_RETURN: Action.SHOOT,
    pygame.K_KP_ENTER: Action.SHOOT,
    pygame.K_BACKSPACE: Action.CANCEL,
    pygame.K_c: Action.IMPACTS,
    pygame.K_s: Action.STEPS,
    pygame.K_n: Action.FRAME,
    pygame.K_b: Action.TO_IMPACT,
    pygame.K_r: Action.AGAIN,
    pygame.K_t: Action.SAME,
    pygame.K_g: Action.MORE,
    pygame.K_p: Action.PAUSE,
    pygame.K_m: Action.MUTE,
    pygame.K_h: Action.HELP,
    pygame.K_F1: Action.HELP,
    pygame.K_F2: Action.RATE,
    pygame.K_ESCAPE: Action.QUIT,
}

BUTTONS = {
    Button.LEFT: Action.TURN_LEFT,
    Button.RIGHT: Action.TURN_RIGHT,
    Button.UP: Action.STRONGER,
    Button.DOWN: Action.WEAKER,
    Button.SOUTH: Action.DRAW,
    Button.EAST: Action.CANCEL,
    Button.WEST: Action.IMPACTS,
    Button.NORTH: Action.STEPS,
    Button.LEFT_SHOULDER: Action.FINE,
    Button.RIGHT_SHOULDER: Action.TO_IMPACT,
    Button.BACK: Action.HELP,
    Button.START: Action.AGAIN,
}

#: What the help says: the keys, the buttons of a controller, and what they do.
HELP: tuple[tuple[str, str, str], ...] = (
    ("Mouse, Left and Right", "cross, stick", "aim; with Shift very finely"),
    ("W and X", "", "first shot, or after a foul: place the cue ball; or drag it"),
    ("Space or left button", "A", "shoot as the power says; hold: draw the cue, let go"),
    ("Backspace, right button", "B", "put the cue down again"),
    ("Up and Down, wheel", "cross, stick", "power"),
    ("Return", "", "shoot with the power shown"),
    ("Space, while balls roll", "A", "three times as fast"),
    ("C", "X", "collision mode: where the balls were at each impact"),
    ("S", "Y", "step mode"),
    ("N", "", "step mode: the next frame"),
    ("B", "right shoulder", "step mode: on to the next impact"),
    ("R, or Return at the end", "Start", "again, from another position"),
    ("T", "", "again, from the same position"),
    ("G", "", "another game: the eight, or 3, 5, 8 balls in so many shots"),
    ("P", "", "pause"),
    ("M", "", "sound on and off"),
    ("F1 or H", "Back", "this help"),
    ("F2", "", "frame rate"),
    ("F11", "", "full screen"),
    ("F12, PrtScr", "", "screenshot"),
    ("Esc", "", "quit"),
)
