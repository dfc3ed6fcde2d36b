"""Axes for plots are of a figure of their own, and their colours can be told apart on light and dark grounds."""

from itertools import combinations

import matplotlib as mpl
import matplotlib.pyplot as plt
import pytest
from matplotlib.colors import to_rgb

import carom
from carom.study.axes import FIRST, MANY, OUTLINE, SECOND, axes_of, named

mpl.use("Agg")


def test_new_axes_are_alone_in_a_new_figure() -> None:
    axes, other = axes_of(None), axes_of(None)
    assert axes.figure.axes == [axes]
    assert axes.figure is not other.figure
    assert named(axes, "title", "across", "up") is axes
    assert (axes.get_title(), axes.get_xlabel(), axes.get_ylabel()) == ("title", "across", "up")
    assert axes_of(axes) is axes
    for bad in (5, axes.figure, [axes]):
        with pytest.raises(carom.InvalidArgument, match="axes must be axes of matplotlib or None"):
            axes_of(bad)
    plt.close("all")


def luminance(colour: str) -> float:
    """The relative luminance of a colour, as the guidelines for web content define it."""
    parts = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in to_rgb(colour)]
    return sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))


def test_colours_stand_out_on_white_and_on_black() -> None:
    for colour in (FIRST, SECOND, OUTLINE, *MANY):
        assert 1.05 / (luminance(colour) + 0.05) > 2.7  # against white
        assert (luminance(colour) + 0.05) / 0.05 > 3.0  # against black
    assert len(set(MANY)) == len(MANY)
    for one, other in combinations(MANY, 2):
        assert sum((a - b) ** 2 for a, b in zip(to_rgb(one), to_rgb(other), strict=True)) > 0.02
