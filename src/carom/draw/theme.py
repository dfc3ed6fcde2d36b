"""The themes: which colour each ink has on a light and on a dark ground."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping


class ThemeName(StrEnum):
    """The themes by name; `AUTO` follows the reader's own setting where the medium can tell it, else it is light."""

    AUTO = "auto"
    LIGHT = "light"
    DARK = "dark"


#: The inks of single balls and their tracks, given out in turn.
BALL_INKS = ("ball-1", "ball-2", "ball-3", "ball-4", "ball-5", "ball-6")


@dataclass(frozen=True, slots=True)
class Theme:
    """A colour, `#rrggbb`, for every ink."""

    name: str
    inks: Mapping[str, str]


LIGHT = Theme(
    "light",
    MappingProxyType(
        {
            "paper": "#f3f1ec",
            "stage": "#fffefb",
            "text": "#22262c",
            "muted": "#62666d",
            "rule": "#d9d5cb",
            "wall": "#3b424d",
            "bumper": "#d9480f",
            "moving": "#1f68d1",
            "gate": "#9c6a00",
            "sensor": "#1f8a5b",
            "off": "#8f8b82",
            "post": "#3b424d",
            "hit": "#c2255c",
            "ball": "#7a8594",
            "ball-1": "#0b8599",
            "ball-2": "#7048e8",
            "ball-3": "#5c940d",
            "ball-4": "#b07d00",
            "ball-5": "#ae3ec9",
            "ball-6": "#3b5bdb",
        }
    ),
)

DARK = Theme(
    "dark",
    MappingProxyType(
        {
            "paper": "#12151a",
            "stage": "#191d24",
            "text": "#eceae5",
            "muted": "#a0a6af",
            "rule": "#353c47",
            "wall": "#c6ccd6",
            "bumper": "#ff8a4c",
            "moving": "#6cb2ff",
            "gate": "#f0c05a",
            "sensor": "#5fd6a0",
            "off": "#6b7280",
            "post": "#c6ccd6",
            "hit": "#ff7aa8",
            "ball": "#8b97a7",
            "ball-1": "#3bc9db",
            "ball-2": "#a58bff",
            "ball-3": "#a9d94b",
            "ball-4": "#ffcf6b",
            "ball-5": "#e599f7",
            "ball-6": "#91a7ff",
        }
    ),
)
