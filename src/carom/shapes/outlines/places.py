"""The places that a user gave."""

from __future__ import annotations

from collections.abc import Iterable

from carom.checks import pair, refuse
from carom.typing import Pair, Vector


def places_of(name: str, points: Iterable[Pair]) -> list[Vector]:
    """Points as pairs of floats; raises where they are none."""
    try:
        items = list(points)
    except TypeError:
        raise refuse(name, "must be a list of points", points) from None
    return [pair(f"{name}[{index}]", item) for index, item in enumerate(items)]
