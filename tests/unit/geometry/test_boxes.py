"""What a box has in common with a segment, a circle and an arc: some of their many points, if any."""

from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.geometry import boxes as box_functions
from carom.geometry.arc import arc_ends
from tests.flat import flat
from tests.strategies import Figure, arcs, circles, numbers, places_on, segments

boxes = flat(box_functions)

Box = tuple[float, float, float, float]
figures: st.SearchStrategy[Figure] = st.one_of(
    st.tuples(st.just("segment"), segments()),
    st.tuples(st.just("circle"), circles),
    st.tuples(st.just("disc"), circles),
    st.tuples(st.just("arc"), arcs()),
)


@st.composite
def boxed(draw: st.DrawFn) -> tuple[Box, Figure]:
    """A figure, and a box near a place of it."""
    figure = draw(figures)
    x, y = draw(places_on(figure))
    away, size = numbers(-4.0, 4.0), numbers(0.0, 6.0)
    left, bottom = x + draw(away), y + draw(away)
    return (left, bottom, left + draw(size), bottom + draw(size)), figure


def meets(box: Box, figure: Figure) -> bool:
    """What carom says of a figure."""
    kind, given_numbers = figure
    if kind == "segment":
        return boxes.box_meets_segment(*box, *given_numbers)
    if kind == "arc":
        cx, cy, r, start, end = given_numbers
        return boxes.box_meets_arc(*box, cx, cy, r, *arc_ends(cx, cy, r, start, end))
    return boxes.box_meets_circle(*box, *given_numbers, int(kind == "disc"))


def way_in(box: Box, figure: Figure) -> float:
    """How deep in the box the deepest of many points of a figure is; below 0, how far outside the nearest is."""
    kind, given_numbers = figure
    share = np.linspace(0.0, 1.0, 20_001)
    if kind == "segment":
        ax, ay, bx, by = given_numbers
        x, y = ax + share * (bx - ax), ay + share * (by - ay)
    else:
        cx, cy, r = given_numbers[:3]
        start, end = given_numbers[3:] if kind == "arc" else (0.0, 2 * pi)
        angle = start + share * ((end - start) % (2 * pi) or 2 * pi)
        x, y = cx + r * np.cos(angle), cy + r * np.sin(angle)
    left, bottom, right, top = box
    depth = float(np.minimum(np.minimum(x - left, right - x), np.minimum(y - bottom, top - y)).max())
    if kind == "disc":  # a corner inside of it is enough
        corners = [
            np.hypot(cornered_x - cx, cornered_y - cy) for cornered_x in (left, right) for cornered_y in (bottom, top)
        ]
        depth = max(depth, r - min(corners))
    return depth


@given(boxed())
def test_a_box_meets_what_has_a_point_in_it(case: tuple[Box, Figure]) -> None:
    box, figure = case
    depth = way_in(box, figure)
    if depth > 1e-6:
        assert meets(box, figure)
    elif depth < -0.05:
        assert not meets(box, figure)


@pytest.mark.parametrize("turn", [0.0, 0.5 * pi, pi, 1.5 * pi])
def test_touching_counts_on_each_side(turn: float) -> None:
    box = (-1.0, -1.0, 1.0, 1.0)
    c, s = round(cos(turn)), round(sin(turn))
    for away, found in ((2.0, True), (2.0 + 1e-12, False)):
        assert boxes.box_meets_circle(*box, away * c, away * s, 1.0, 0) == found
    for away, found in ((1.0, True), (1.0 + 1e-12, False)):
        assert boxes.box_meets_segment(*box, away * c - s, away * s + c, away * c + s, away * s - c) == found


def test_a_box_inside_a_circle_meets_the_disc_alone() -> None:
    box = (-1.0, -1.0, 1.0, 1.0)
    assert boxes.box_meets_circle(*box, 0.0, 0.0, 9.0, 1)
    assert not boxes.box_meets_circle(*box, 0.0, 0.0, 9.0, 0)
    assert not boxes.box_meets_arc(*box, 0.0, 0.0, 9.0, 9.0, 0.0, -9.0, 0.0)


def test_a_segment_past_a_corner_is_missed_though_the_boxes_overlap() -> None:
    box = (0.0, 0.0, 2.0, 2.0)
    assert boxes.box_meets_segment(*box, 2.0, 0.0, 0.0, 2.0)
    assert boxes.box_meets_segment(*box, 3.0, 1.0, 1.0, 3.0)
    assert not boxes.box_meets_segment(*box, 3.1, 1.0, 1.0, 3.1)


def test_an_arc_that_ends_in_a_box_meets_it() -> None:
    box = (-1.0, -1.0, 1.0, 1.0)
    for ends in ((0.5, 0.0, 9.5, 9.0), (18.5, 0.0, -0.5, 0.0)):
        assert boxes.box_meets_arc(*box, 9.5, 0.0, 9.0, *ends) == (ends[0] == 0.5 or ends[2] == -0.5)
