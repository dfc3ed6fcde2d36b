"""The toy's keys and buttons of a controller: what each presses."""

from __future__ import annotations

from collections.abc import Mapping

import pygame

from carom.play.controls import Button
from carom.play.toy.settings import SHOWN

#: What each key presses: an action, a switch, or the next option of a choice.
KEYS: Mapping[int, str] = {
    pygame.K_SPACE: "launch",
    pygame.K_n: "launch many",
    pygame.K_c: "clear",
    pygame.K_p: "paused",
    pygame.K_s: "step",
    pygame.K_w: "pace",
    pygame.K_r: "rotating",
    pygame.K_m: "muted",
    pygame.K_d: "detection",
    pygame.K_b: "broad_phase",
    pygame.K_t: "restitution",
    pygame.K_F1: "help",
    pygame.K_h: "help",
    pygame.K_ESCAPE: "quit",
    **{pygame.K_1 + place: name for place, name in enumerate(SHOWN)},
}

BUTTONS: Mapping[Button, str] = {
    Button.SOUTH: "launch",
    Button.NORTH: "launch many",
    Button.WEST: "rotating",
    Button.EAST: "paused",
    Button.RIGHT_SHOULDER: "step",
    Button.LEFT_SHOULDER: "detection",
    Button.START: "help",
    Button.BACK: "quit",
}

#: What the help says, in two columns: headings, and what to press with what it does.
HELP: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = (
    (
        "Balls",
        (
            ("Space", "launch a ball"),
            ("N", "launch n balls"),
            ("C", "clear the table"),
            ("Mouse", "drag a ball to throw it"),
            ("", "point at a shape: its numbers"),
        ),
    ),
    (
        "Time and sound",
        (
            ("P", "pause, and on again"),
            ("S", "one step"),
            ("W", "real time, 1/4, 1/10"),
            ("R", "rotate the blue parts"),
            ("M", "mute"),
        ),
    ),
    (
        "Collision",
        (
            ("D", "discrete, continuous, side by side"),
            ("B", "brute force, quadtree, grid"),
            ("T", "normal or total restitution"),
        ),
    ),
    (
        "Show",
        tuple((str(place), name) for place, name in enumerate(SHOWN, 1)),
    ),
    (
        "Who tunnels?",
        (
            ("D", "twice: two tables side by side"),
            ("", "motion iterations down to 1"),
            ("N", "at the highest speed"),
        ),
    ),
    (
        "Window",
        (("F1 or H", "this help"), ("F11", "full screen"), ("F12", "screenshot (or PrtScr)"), ("Esc", "quit")),
    ),
)
