"""Sizes, units and view boxes, against the rules of SVG 2."""

import pytest

from carom.scene.drawings.pieces import Matrix, Vector
from carom.scene.drawings.tree import Element
from carom.scene.drawings.view_boxes import Page, fitting, page_of, pixels, view_box


def root(**attributes: str) -> Element:
    """An element with attributes."""
    return Element("svg", attributes, 1)


@pytest.mark.parametrize(
    ("text", "length"),
    [("3", 3.0), ("3px", 3.0), ("25.4mm", 96.0), ("2.54 cm", 96.0), ("1in", 96.0), ("72pt", 96.0), ("50%", 20.0)],
)
def test_lengths_are_in_pixels(text: str, length: float) -> None:
    assert pixels(text, 40.0) == pytest.approx(length, rel=1e-15)


@pytest.mark.parametrize("text", ["", "abc", "3mmm", "2em", "1e999", "nan", "3 4"])
def test_what_is_no_length_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="must be"):
        pixels(text, 40.0)


@pytest.mark.parametrize(
    ("attributes", "page"),
    [
        ({}, Page(None, None, 1.0)),
        ({"width": "25.4mm", "height": "50.8mm"}, Page(25.4, 50.8, 96.0 / 25.4)),
        ({"width": "100%", "height": "100%", "viewBox": "0 0 40 20"}, Page(40.0, 20.0, 1.0)),
        ({"width": "80", "viewBox": "0 0 40 20"}, Page(80.0, 40.0, 1.0)),
        ({"width": "2in", "height": "25.4mm"}, Page(2.0, 1.0, 96.0)),
        ({"height": "80", "viewBox": "0 0 40 20"}, Page(160.0, 80.0, 1.0)),
    ],
)
def test_a_side_that_is_not_said_follows_from_the_view_box(attributes: dict[str, str], page: Page) -> None:
    assert page_of(root(**attributes)) == page


@pytest.mark.parametrize(
    ("ratio", "place"),
    [
        ("xMidYMid", (40.0, 20.0)),  # as large as fits, in the middle
        ("xMinYMin", (20.0, 20.0)),
        ("xMaxYMax meet", (60.0, 20.0)),
        ("none", (40.0, 20.0)),
        ("xMidYMid slice", (40.0, 20.0)),
        ("xMidYMin slice", (40.0, 40.0)),
        ("xMidYMax slice", (40.0, 0.0)),
    ],
)
def test_contents_lie_in_their_viewport_as_they_are_told(ratio: str, place: Vector) -> None:
    element = root(viewBox="0 0 10 10", preserveAspectRatio=ratio)
    assert fitting(element, (0.0, 0.0), (80.0, 40.0)).place((5.0, 5.0)) == place


def test_contents_are_as_large_as_fits_unless_it_is_said() -> None:
    element = root(viewBox="0 0 10 10")
    assert fitting(element, (1.0, 2.0), (80.0, 40.0)).place((0.0, 0.0)) == (21.0, 2.0)
    assert fitting(root(), (1.0, 2.0), (80.0, 40.0)).place((3.0, 4.0)) == (4.0, 6.0)


def test_contents_are_in_the_unit_of_the_sheet() -> None:
    plain = root(width="25.4mm", height="25.4mm")
    assert page_of(plain).contents(plain)[0].place((96.0, 48.0)) == pytest.approx((25.4, 12.7))
    boxed = root(width="30mm", height="20mm", viewBox="0 0 300 200")
    assert page_of(boxed).contents(boxed) == (Matrix(0.1, 0.0, 0.0, 0.1), (300.0, 200.0))


def test_a_view_box_is_four_numbers() -> None:
    assert view_box(root(viewBox="1,2 3 4")) == (1.0, 2.0, 3.0, 4.0)
    assert view_box(root(viewBox="0 0 0 0")) is None
    assert view_box(root()) is None
    with pytest.raises(ValueError, match="must be four numbers"):
        view_box(root(viewBox="1 2 3"))
