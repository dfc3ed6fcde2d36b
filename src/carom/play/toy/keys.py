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
    pygame.K_u: "tunnelling",
    pygame.K_e: "editing",
    pygame.K_k: "kind",
    pygame.K_v: "save",
    pygame.K_a: "add",
    pygame.K_x: "take away",
    pygame.K_COMMA: "turn left",
    pygame.K_PERIOD: "turn right",
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
        "Edit the table",
        (
            ("E", "edit, and play again"),
            ("Mouse", "drag a shape to move it"),
            (", and .", "turn what is pointed at; the wheel too"),
            ("A", "add there; so does a click beside all"),
            ("K", "wall, arc, disc, post, ball"),
            ("X", "take away; the right button too"),
            ("V", "save the table as a scene file"),
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
            ("U", "two tables, the same 30 fast balls"),
            ("", "with one motion iteration"),
        ),
    ),
    (
        "Window",
        (("F1 or H", "this help"), ("F11", "full screen"), ("F12", "screenshot (or PrtScr)"), ("Esc", "quit")),
    ),
)
