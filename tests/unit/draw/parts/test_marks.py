"""Marks in pixels: their sizes, and what they are made of."""

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest

import carom
from carom.draw.history.tracks import BANDS
from carom.draw.page.painter import PagePainter
from carom.draw.paint.painter import Style
from carom.draw.parts.frame import Frame
from carom.draw.parts.marks import (
    LARGEST_HIT,
    NORMAL,
    OLDEST,
    RETICLE,
    SMALLEST_HIT,
    YOUNGEST,
    box_mark,
    faded,
    hit_mark,
    long_arrow_mark,
    reticle_mark,
    track_style,
)
from carom.shapes.aabb import Aabb
from tests.unit.draw.svg_marks import SVG, layer, root_of, trace_of
from tests.worlds import world_of


def test_stronger_hits_have_larger_dots() -> None:
    world = carom.World(gravity=(0, -10))
    world.add(carom.Segment((-5, 0), (5, 0), elasticity=0.7))
    world.add(carom.Ball((0, 4), 0.5))
    trace = trace_of(world, 200)
    circles = layer(root_of(world, trace), "hits").iter(f"{SVG}circle")
    radii = [float(circle.get("r")) for circle in circles]
    assert radii == sorted(radii, reverse=True)
    assert radii[0] > radii[-1]


def test_balls_of_less_than_two_pixels_have_no_rim() -> None:
    world = world_of(carom.Circle((0, 0), 1000), carom.Ball((0, 0), 0.5), carom.Ball((9, 0), 50))
    groups = list(layer(root_of(world), "balls"))
    assert [("stroke-width" in group.attrib) for group in groups] == [False, True]


FRAME = Frame(200.0, 100.0, Aabb(0.0, 0.0, 20.0, 10.0), 10.0, 0.0, 0.0)


def calls_of(draw_marks: Callable[[PagePainter], None]) -> list[list[Any]]:
    """The calls that some marks are made of."""
    painter = PagePainter()
    painter.layer("marks")
    draw_marks(painter)
    return list(painter.layers["marks"])


@pytest.mark.parametrize("pixels", [40.0, 5.0])
def test_an_arrow_is_as_long_as_it_is_to_be_and_points_where_it_is_to(pixels: float) -> None:
    shaft, head = calls_of(lambda painter: long_arrow_mark(painter, FRAME, (1.0, 2.0), (0.6, 0.8), pixels, NORMAL))
    x, y, neck_x, neck_y = shaft[2]
    corners = np.array(head[2]).reshape(3, 2)
    assert (x, y) == (1.0, 2.0)
    assert corners[1] == pytest.approx((1 + 0.06 * pixels, 2 + 0.08 * pixels))
    assert (corners[0] + corners[2]) / 2 == pytest.approx((neck_x, neck_y))
    assert np.dot(corners[0] - corners[2], (0.6, 0.8)) == pytest.approx(0.0, abs=1e-12)


def test_the_dot_of_a_hit_grows_with_its_strength_from_the_smallest_to_the_largest() -> None:
    sizes = [
        calls_of(lambda painter, s=s: hit_mark(painter, FRAME, (1.0, 1.0), s, 1.0))[0][2][2]  # type: ignore[misc]
        for s in (-1.0, 0.0, 0.3, 0.6, 1.0, 9.0)
    ]
    assert sizes == sorted(sizes)
    assert (10 * sizes[0], 10 * sizes[-1]) == pytest.approx((SMALLEST_HIT, LARGEST_HIT))
    assert sizes[0] == sizes[1] < sizes[2] < sizes[4] == sizes[5]


def test_tracks_fade_with_age() -> None:
    opacities = [track_style("ball", band).opacity for band in range(BANDS)]
    assert opacities == sorted(opacities)
    assert (opacities[0], opacities[-1]) == pytest.approx((OLDEST, YOUNGEST))
    assert faded(NORMAL, 0.25).opacity == 0.25 * NORMAL.opacity


def test_a_reticle_is_a_ring_with_four_ticks_across_it() -> None:
    ring, *ticks = calls_of(lambda painter: reticle_mark(painter, FRAME, (5.0, 5.0), 0.3, 1.0))
    assert 10 * ring[2][2] == pytest.approx(RETICLE)
    assert len(ticks) == 4
    for number, tick in enumerate(ticks):
        inner, outer = np.array(tick[2]).reshape(2, 2) - 5.0
        assert 10 * np.hypot(*inner) < RETICLE < 10 * np.hypot(*outer)
        assert np.arctan2(*outer[::-1]) % (2 * pi) == pytest.approx(0.3 + number * pi / 2)


def test_a_box_is_four_lines_or_its_area() -> None:
    box = Aabb(1.0, 2.0, 4.0, 6.0)
    sides = calls_of(lambda painter: box_mark(painter, box))
    assert [call[0] for call in sides] == ["segment"] * 4
    assert {tuple(call[2][:2]) for call in sides} == {(1, 2), (4, 2), (4, 6), (1, 6)}
    (area,) = calls_of(lambda painter: box_mark(painter, box, Style(fill="cell")))
    assert (area[0], area[2]) == ("polyline", [1, 2, 4, 2, 4, 6, 1, 6])
