"""The scenes that come with carom: `carom.scenes`."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Any

from carom.errors import SceneError
from carom.scene.scene import Scene
from carom.scene.shipped.billiards import (
    annulus,
    circle,
    ellipse,
    flower,
    lemon,
    lorentz,
    mushroom,
    rectangle,
    sinai,
    stadium,
    wedge,
)
from carom.scene.shipped.breakout_wall import breakout
from carom.scene.shipped.cradle import newtons_cradle
from carom.scene.shipped.galton_board import galton
from carom.scene.shipped.gas_box import gas
from carom.scene.shipped.pinball_table import pinball
from carom.scene.shipped.pool_table import pool
from carom.scene.shipped.toy_table import toy

#: The shipped scenes, and nothing else.
__all__ = [
    "annulus",
    "breakout",
    "circle",
    "ellipse",
    "flower",
    "galton",
    "gas",
    "lemon",
    "lorentz",
    "mushroom",
    "newtons_cradle",
    "pinball",
    "pool",
    "rectangle",
    "sinai",
    "stadium",
    "toy",
    "wedge",
]


def names() -> tuple[str, ...]:
    """The names of all shipped scenes, in the order of the alphabet."""
    return tuple(__all__)


def by_name(name: Any) -> Scene:
    """The shipped scene called `name`, as it is without arguments. Raises `SceneError` if there is none."""
    if isinstance(name, str) and name in __all__:
        scene: Scene = globals()[name]()
        return scene
    near = get_close_matches(str(name), __all__, n=1)
    hint = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(__all__)}"
    raise SceneError(f"no shipped scene is called {name!r}; {hint}")
