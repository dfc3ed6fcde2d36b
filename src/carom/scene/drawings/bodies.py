"""What both kinds of drawings are read as: bodies with outlines, names and options, and what was not understood."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

from carom.scene.drawings.pieces import Piece
from carom.scene.faults import Faults


@dataclass(slots=True)
class Body:
    """One element of a drawing that is a body, in the scene's coordinates; a group with a pivot has parts instead."""

    where: object  # its words are how a message names it
    name: str | None
    options: dict[str, Any]  # its own and those of the groups that it is in
    written: dict[str, str] = field(default_factory=dict)  # how and where each is written in the drawing
    own: frozenset[str] = frozenset()  # those that the element itself has
    outlines: list[list[Piece]] = field(default_factory=list)
    filled: bool = False
    point: bool = False
    parts: list[Body] | None = None


@dataclass(slots=True)
class Drawing:
    """All that was found in a drawing."""

    faults: Faults
    where: object = ""  # what speaks of the world, as a message names it
    bodies: list[Body] = field(default_factory=list)
    world: dict[str, Any] = field(default_factory=dict)
    left_out: Counter[str] = field(default_factory=Counter)  # what was not understood, and how often
