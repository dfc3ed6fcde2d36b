"""SVG's basic shapes as pieces."""

from itertools import pairwise
from math import hypot

import pytest

from carom.scene.drawings.outlines import DRAWS, outlines_of
from carom.scene.drawings.pieces import Conic, Piece, Straight
from carom.scene.drawings.tree import Element


def outline(tag: str, **attributes: str) -> list[Piece]:
    """The only outline of an element."""
    (found,) = outlines_of(Element(tag, attributes, 1), (200.0, 100.0))
    return found


def test_lines_and_polygons_are_straight() -> None:
    assert outline("line", x1="1", y1="2", x2="50%", y2="50%") == [Straight((1.0, 2.0), (100.0, 50.0))]
    assert len(outline("polyline", points="0,0 1,0 1,1")) == 2
    assert len(outline("polygon", points="0,0 1,0 1,1")) == 3
    assert len(outline("polygon", points="0,0 1,0 1,1 0,0")) == 3


@pytest.mark.parametrize("radii", [{}, {"rx": "2"}, {"ry": "2"}, {"rx": "2", "ry": "1"}, {"rx": "99", "ry": "99"}])
def test_a_rectangle_goes_round_once(radii: dict[str, str]) -> None:
    pieces = outline("rect", x="1", y="2", width="10", height="6", **radii)
    for before, after in pairwise([*pieces, pieces[0]]):
        assert hypot(before.end[0] - after.start[0], before.end[1] - after.start[1]) < 1e-14
    corners = [piece for piece in pieces if isinstance(piece, Conic)]
    assert len(corners) == (4 if radii else 0)
    xs, ys = zip(*[point for piece in pieces for point in piece.points()], strict=True)
    assert (min(xs), max(xs)) == pytest.approx((1.0, 11.0))
    assert (min(ys), max(ys)) == pytest.approx((2.0, 8.0))
    assert all(
        piece.round == ("ry" not in radii or "rx" not in radii) for piece in corners[:1] if radii != {"rx": "99"}
    )


def test_circles_and_ellipses_are_whole() -> None:
    assert outline("circle", cx="1", cy="2", r="3") == [Conic((1.0, 2.0), (3.0, 0.0), (0.0, 3.0))]
    assert outline("ellipse", rx="3", ry="1") == [Conic((0.0, 0.0), (3.0, 0.0), (0.0, 1.0))]
    assert outline("ellipse", rx="3") == outline("ellipse", rx="3", ry="3")


@pytest.mark.parametrize("tag", ["circle", "ellipse", "rect", "path", "polyline", "polygon"])
def test_what_has_no_size_has_no_pieces(tag: str) -> None:
    assert [piece for found in outlines_of(Element(tag, {}, 1), (1.0, 1.0)) for piece in found] == []
    assert tag in DRAWS


@pytest.mark.parametrize(
    ("tag", "attributes", "said"),
    [
        ("circle", {"r": "-1"}, "r: must not be negative, not '-1'"),
        ("rect", {"width": "1", "height": "x"}, "height: must be a number"),
        ("line", {"x1": "2em"}, "x1: must be a number, with a unit among"),
        ("polygon", {"points": "1 2 3"}, "points: must be pairs"),
        ("path", {"d": "M 0 0 L 3"}, "d: L takes 2 numbers at a time, not 1"),
    ],
)
def test_what_is_wrong_begins_with_the_attribute(tag: str, attributes: dict[str, str], said: str) -> None:
    with pytest.raises(ValueError) as caught:
        outlines_of(Element(tag, attributes, 1), (1.0, 1.0))
    assert str(caught.value).startswith(said)
