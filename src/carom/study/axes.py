"""Axes for plots, and the colours that they share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom.checks import instance
from carom.extras import needed

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colours that can be told apart on light and dark grounds, and without colour sight: of one thing, another, lines.
FIRST, SECOND, OUTLINE = "#1f8aa8", "#d9480f", "#8a9099"
#: Colours of many things in turn, on both grounds.
MANY = (FIRST, SECOND, "#7a9a01", "#b0568f", "#c28a00", "#6f7bd0", "#2f9e6e", "#a9744f")


def axes_of(axes: Any) -> Axes:
    """The axes that are given, or those of a new figure for None; raises `InvalidArgument` for anything else."""
    if axes is not None:
        kind = needed("matplotlib.axes", "matplotlib", "study", "plots").Axes
        given: Axes = instance("axes", axes, kind, "axes of matplotlib or None")
        return given
    pyplot = needed("matplotlib.pyplot", "matplotlib", "study", "plots")
    _, axes = pyplot.subplots(figsize=(7.0, 4.2), layout="constrained")
    made: Axes = axes
    return made


def named(axes: Axes, title: str, x: str, y: str) -> Axes:
    """The axes with their words."""
    axes.set_title(title)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    return axes
