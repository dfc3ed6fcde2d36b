"""Outlines are tangent where they promise it, to rounding: nothing in them needs a guard point."""

from math import hypot, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.scene.shipped.outline import band, mirrored, polar, rounded, walls
from tests.strategies import angles, numbers, points

CLOSE = 1e-9


def needed(parts: list) -> list:
    """The guard points that parts need."""
    return carom.guard_points([part.build() for part in parts], tolerance=CLOSE, angle_tolerance=1e-7)


def test_walls_lead_from_point_to_point() -> None:
    parts = walls([(0, 0), (1, 0), (1, 2)], name="wall")
    assert [(part.start, part.end, part.name) for part in parts] == [
        ((0.0, 0.0), (1.0, 0.0), "wall"),
        ((1.0, 0.0), (1.0, 2.0), "wall"),
    ]


@given(points, angles, numbers(0.1, 5.0), numbers(0.1, 5.0), numbers(0.5, 20.0))
def test_a_band_round_two_discs_is_tangent(
    center: tuple[float, float], angle: float, radius: float, other: float, apart: float
) -> None:
    discs = [(center, radius), (polar(center, abs(radius - other) + apart, angle), other)]
    parts = band(discs)
    assert [part.kind for part in parts] == ["segment", "arc", "segment", "arc"]
    assert needed(parts) == []
    # The band lies outside of both discs: it touches each, and no more.
    for middle, reach in discs:
        for part in (part.build() for part in parts):
            assert part.distance(middle) >= reach - CLOSE


def test_a_band_round_posts_is_closed_and_tangent() -> None:
    posts = [((0.0, 0.0), 0.25), ((3.0, 0.0), 0.5), ((3.0, 2.0), 0.125), ((0.5, 3.0), 1.0)]
    parts = band(posts, kick=2.0)
    assert len(parts) == 8
    assert needed(parts) == []
    assert all(part.kick == 2.0 for part in parts)


@given(points, angles, st.floats(-0.95 * pi, 0.95 * pi).filter(lambda turn: abs(turn) > 0.05), numbers(0.1, 2.0))
def test_a_rounded_corner_is_tangent(start: tuple[float, float], angle: float, turn: float, radius: float) -> None:
    corner = polar(start, 60.0, angle)
    end = polar(corner, 60.0, angle + turn)
    parts = rounded([(start, 0.0), (corner, radius), (end, 0.0)])
    assert [part.kind for part in parts] == ["segment", "arc", "segment"]
    bare = sorted(point.position for point in needed(parts))
    assert bare == [pytest.approx(place, abs=1e-9) for place in sorted([start, end])]
    assert parts[1].radius == radius


def test_a_closed_path_has_no_end() -> None:
    corners = [((0, 0), 0.5), ((4, 0), 1.0), ((4, 4), 0.25), ((2, 2), 0.5), ((0, 4), 0.75)]
    parts = rounded(corners, closed=True)
    assert [part.kind for part in parts] == ["segment", "arc"] * 5
    assert needed(parts) == []


def test_mirrored_parts_are_the_mirror_image() -> None:
    compound = carom.Scene(
        shapes=[
            {
                "kind": "compound",
                "pivot": (1, 2),
                "turn_limits": (-0.25, 1),
                "name": "left flipper",
                "shapes": [part.model_dump() for part in band([((1, 2), 0.5), ((3, 1), 0.25)])],
            }
        ]
    ).shapes[0]
    (image,) = mirrored([compound], 5.0)
    assert (image.pivot, image.turn_limits, image.name) == ((9.0, 2.0), (-1.0, 0.25), "right flipper")
    one, other = compound.build(), image.build()
    for x, y in ((0.0, 0.0), (2.5, 3.0), (4.0, 1.0), (-1.0, 7.0)):
        assert other.distance((10.0 - x, y)) == pytest.approx(one.distance((x, y)), abs=1e-12)
    assert mirrored([image], 5.0)[0].build().aabb == pytest.approx(one.aabb)


def test_mirrored_arcs_cover_the_mirrored_angles() -> None:
    arc = carom.Scene(shapes=[carom.Arc((1, 0), 2.0, 0.0, pi / 2)]).shapes[0]
    image = mirrored([arc], 0.0)[0].build()
    assert image.position == (-1.0, 0.0)
    assert image.p0 == pytest.approx((-1.0, 2.0))
    assert image.p1 == pytest.approx((-3.0, 0.0))
    assert hypot(*image.p0) > 0
