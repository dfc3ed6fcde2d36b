"""The layers of a picture: what can be switched on and off, by name."""

from __future__ import annotations

from enum import StrEnum
from typing import Any

from carom.checks import refuse


class Layer(StrEnum):
    """What a picture can show, in the order in which it is drawn: later layers lie over earlier ones."""

    CELLS = "cells"
    """The cells of the broad phase that hold shapes at rest, the darker the more."""
    BOXES = "boxes"
    """The boxes around shapes and balls."""
    SECTORS = "sectors"
    """The sectors of arcs: where a ball's centre must be to touch one, but for its ends."""
    SENSORS = "sensors"
    """Shapes that balls pass through and that report them."""
    SHAPES = "shapes"
    """All other shapes."""
    NAMES = "names"
    """Names of shapes and balls, where there is room."""
    TRACKS = "tracks"
    """The ways of balls, fading with age."""
    LIGHTS = "lights"
    """A glow around what was just hit."""
    HITS = "hits"
    """A dot where a ball bounced, the larger the greater its impulse."""
    TANGENTS = "tangents"
    """Lines along the surface: at the latest hits, or at the ends of shapes where no run is shown."""
    NORMALS = "normals"
    """Arrows square to the surface, likewise."""
    BALLS = "balls"
    """The balls."""
    VELOCITIES = "velocities"
    """An arrow for each ball, the longer the faster it is."""
    RETICLES = "reticles"
    """A ring around each of the latest hits, turning with the speed of the impact."""


#: What a picture shows unless it is told otherwise.
DEFAULT_LAYERS = frozenset({Layer.SHAPES, Layer.SENSORS, Layer.BALLS, Layer.TRACKS, Layer.HITS})


def layers_of(names: Any) -> frozenset[Layer]:
    """The layers with some names; raises `InvalidArgument` for a name that none has, and for what are no names."""
    known = {layer.value: layer for layer in Layer}
    try:
        given = list(names)
    except TypeError:
        raise refuse("layers", f"must be a collection of {', '.join(known)}", names) from None
    for name in given:
        if not isinstance(name, str) or name not in known:
            raise refuse("layers", f"must be among {', '.join(known)}", name)
    return frozenset(known[name] for name in given)
