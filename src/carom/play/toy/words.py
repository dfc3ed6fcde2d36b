"""Numbers as the panel shows them."""

from __future__ import annotations

from collections.abc import Sequence

from carom.play.meter import FrameMeter
from carom.play.toy.figures import Tree
from carom.play.toy.view import View

#: What stands for a number where there is none.
NONE = "-"


def short(number: float) -> str:
    """A number of at most five characters: 7, 950, 1.2k, 34M."""
    for size, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if number >= 0.9995 * size:
            scaled = number / size
            return f"{scaled:.1f}{letter}" if scaled < 9.95 else f"{scaled:.0f}{letter}"
    return f"{number:.0f}"


def figure_texts(views: Sequence[View], waiting: int) -> dict[str, str]:
    """The figures of the panel by name; of two tables both, the first one's first; `waiting` balls are to come."""
    tables = [view.table for view in views]
    rates = [view.figures.rates for view in views]
    columns: dict[str, list[float]] = {
        "launched": [table.launched for table in tables[:1]],
        "in play": [table.in_play for table in tables],
        "asleep": [table.world.statistics.sleeping for table in tables],
        "strays": [table.strays for table in tables],
        "overlaps": [table.world.statistics.overlaps for table in tables],
        "box tests once": [rate.box_tests_once for rate in rates],
        "box tests": [rate.box_tests for rate in rates],
        "full tests": [rate.full_tests for rate in rates],
        "collisions": [rate.collisions for rate in rates],
    }
    texts = {name: " · ".join(short(number) for number in numbers) for name, numbers in columns.items()}
    if waiting:
        texts["launched"] += f" +{short(waiting)}"
    return texts | tree_texts(views[0].tree)


def tree_texts(tree: Tree) -> dict[str, str]:
    """What the broad phase looks like; dashes for what it does not have."""
    return {
        "nodes": str(tree.nodes or NONE),
        "leaves": str(tree.leaves or NONE),
        "leaf size": f"{tree.width:.1f} by {tree.height:.1f}" if tree.leaves else NONE,
        "most": str(tree.most or NONE),
    }


def load_text(meter: FrameMeter) -> str:
    """How many frames are shown, and how long each takes."""
    return f"{meter.rate:.0f} fps, {1e3 * meter.work:.1f} ms a frame"
