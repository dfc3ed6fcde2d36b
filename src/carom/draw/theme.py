"""The themes: which colour each ink has on a light and on a dark ground, and on paper."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING

from carom.checks import one_of

if TYPE_CHECKING:
    from collections.abc import Mapping


class ThemeName(StrEnum):
    """The themes by name; `AUTO` follows the reader's own setting where the medium can tell it, else it is light."""

    AUTO = "auto"
    LIGHT = "light"
    DARK = "dark"
    PRINT = "print"


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
            "glow": "#dd6b00",
            "box": "#7a7f87",
            "cell": "#3b5bdb",
            "sector": "#1f68d1",
            "tangent": "#9c36b5",
            "normal": "#2b8a3e",
            "velocity": "#22262c",
            "reticle": "#c2255c",
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
            "glow": "#ffc14d",
            "box": "#868e99",
            "cell": "#91a7ff",
            "sector": "#6cb2ff",
            "tangent": "#da77f2",
            "normal": "#69db7c",
            "velocity": "#eceae5",
            "reticle": "#ff7aa8",
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

#: Black on white, without tints, for paper: greys, dashes and widths tell apart what colours do elsewhere.
PRINT = Theme(
    "print",
    MappingProxyType(
        {
            "paper": "#ffffff",
            "stage": "#ffffff",
            "text": "#000000",
            "muted": "#3d3d3d",
            "rule": "#b5b5b5",
            "wall": "#000000",
            "bumper": "#000000",
            "moving": "#666666",
            "gate": "#000000",
            "sensor": "#4d4d4d",
            "off": "#8a8a8a",
            "post": "#000000",
            "hit": "#000000",
            "glow": "#8a8a8a",
            "box": "#6b6b6b",
            "cell": "#4d4d4d",
            "sector": "#6b6b6b",
            "tangent": "#000000",
            "normal": "#000000",
            "velocity": "#000000",
            "reticle": "#000000",
            "ball": "#8a8a8a",
            "ball-1": "#1c1c1c",
            "ball-2": "#6f6f6f",
            "ball-3": "#a3a3a3",
            "ball-4": "#474747",
            "ball-5": "#8a8a8a",
            "ball-6": "#2e2e2e",
        }
    ),
)


def theme_name(value: object) -> ThemeName:
    """The name of a theme, given as such or as a string; raises `InvalidArgument` where it is none."""
    return ThemeName(one_of("theme", value, tuple(name.value for name in ThemeName)))


#: The theme of each name; where the reader's setting cannot be known, it is light.
THEMES: Mapping[ThemeName, Theme] = MappingProxyType(
    {ThemeName.AUTO: LIGHT, ThemeName.LIGHT: LIGHT, ThemeName.DARK: DARK, ThemeName.PRINT: PRINT}
)
