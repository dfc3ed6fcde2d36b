"""The SVG painter: well-formed, true arcs, few characters, two themes, the same bytes every time."""

import re
from itertools import pairwise
from math import cos, hypot, pi, sin
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.draw import Lettering, Style, SvgPainter, ThemeName
from carom.draw.paint.svg import digits, printable
from carom.draw.parts.frame import Frame
from carom.draw.theme import DARK, LIGHT
from carom.shapes.aabb import Aabb

FRAME = Frame.around(Aabb(-1.0, -1.0, 1.0, 1.0), 100.0)
LINE = Style("wall", width=2.0)
SVG = "{http://www.w3.org/2000/svg}"
NUMBER = r"-?\d+(?:\.\d+)?"


def finished(painter: SvgPainter) -> ElementTree.Element:
    """The root of what the painter has drawn."""
    return ElementTree.fromstring(painter.finish())


def arc_path(start: float, end: float, radius: float = 1.0) -> str:
    """The path of an arc about the origin."""
    painter = SvgPainter(FRAME)
    painter.arc((0.0, 0.0), radius, start, end, LINE)
    return finished(painter).find(f".//{SVG}path").get("d")


def test_marks_of_all_kinds_make_well_formed_xml_in_their_layers() -> None:
    painter = SvgPainter(FRAME, title="a <scene> & more")
    painter.layer("shapes")
    painter.segment((0.0, 0.0), (1.0, 1.0), LINE)
    painter.circle((0.0, 0.0), 0.5, Style("wall", fill="wall", fill_opacity=0.2))
    painter.arc((0.0, 0.0), 0.5, 0.0, 1.0, LINE)
    painter.layer("words")
    painter.polyline(np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]), Style("wall", dash=(3.0, 2.0)))
    painter.text((0.0, 0.0), "x < y & z", Lettering(bold=True, anchor="end"))
    root = finished(painter)
    assert root.find(f"{SVG}title").text == "a <scene> & more"
    assert [group.get("id") for group in root.findall(f"{SVG}g")] == ["shapes", "words"]
    assert root.find(f".//{SVG}text").text == "x < y & z"
    assert [len(root.findall(f".//{SVG}{tag}")) for tag in ("path", "circle", "polyline")] == [2, 1, 1]


def test_y_points_up() -> None:
    painter = SvgPainter(FRAME)
    painter.circle((0.0, 0.5), 0.1, LINE)
    painter.circle((0.0, -0.5), 0.1, LINE)
    high, low = (float(circle.get("cy")) for circle in finished(painter).iter(f"{SVG}circle"))
    assert high < low


@pytest.mark.parametrize(("start", "end"), [(0.0, 1.0), (3.0, 1.0), (0.0, pi), (0.1, 0.1 + 1.999 * pi), (6.0, 0.2)])
def test_an_arc_is_an_arc_of_its_own_radius_between_its_own_ends(start: float, end: float) -> None:
    path = arc_path(start, end)
    assert "L" not in path
    places = re.findall(rf"[M ]({NUMBER}) ({NUMBER})(?=A|$)", path)
    for angle, place in ((start, places[0]), (end, places[-1])):
        assert tuple(map(float, place)) == pytest.approx(FRAME.pixel(cos(angle), sin(angle)), abs=0.006)
    (radius,) = set(re.findall(rf"A({NUMBER}) ", path))
    assert float(radius) == pytest.approx(FRAME.scale, abs=0.006)


@given(st.floats(0.0, 2 * pi), st.floats(0.01, 2 * pi - 0.01))
def test_rounding_moves_no_arc_off_its_circle(start: float, sweep: float) -> None:
    path = arc_path(start, start + sweep)
    places = [tuple(map(float, place)) for place in re.findall(rf"[M ]({NUMBER}) ({NUMBER})(?=A|$)", path)]
    center = FRAME.pixel(0.0, 0.0)
    for (ax, ay), (bx, by) in pairwise(places):
        chord = hypot(bx - ax, by - ay)
        middle = ((ax + bx) / 2, (ay + by) / 2)
        # What a viewer takes for the centre: on the perpendicular of the chord, to the left of the way (y down).
        height = (FRAME.scale**2 - chord**2 / 4) ** 0.5
        found = (middle[0] + height * (by - ay) / chord, middle[1] - height * (bx - ax) / chord)
        assert hypot(found[0] - center[0], found[1] - center[1]) < 0.05 * max(1.0, FRAME.scale / chord)


def test_auto_holds_both_themes_and_each_other_one_its_own() -> None:
    def rules(theme: ThemeName) -> str:
        painter = SvgPainter(FRAME, theme)
        painter.circle((0.0, 0.0), 0.5, LINE)
        return finished(painter).find(f"{SVG}style").text

    light, dark = LIGHT.inks["wall"], DARK.inks["wall"]
    assert light in rules(ThemeName.LIGHT)
    assert dark not in rules(ThemeName.LIGHT)
    assert dark in rules(ThemeName.DARK)
    assert light not in rules(ThemeName.DARK)
    assert re.search(rf"{light}.*prefers-color-scheme:dark.*{dark}", rules(ThemeName.AUTO))


def test_marks_of_one_style_share_one_group() -> None:
    painter = SvgPainter(FRAME)
    painter.layer("shapes")
    for x in (0.1, 0.2, 0.3):
        painter.circle((x, 0.0), 0.05, LINE)
    painter.circle((0.4, 0.0), 0.05, Style("moving"))
    groups = finished(painter).find(f"{SVG}g").findall(f"{SVG}g")
    assert [len(list(group)) for group in groups] == [3, 1]


@given(st.floats(-1e5, 1e5))
def test_a_number_is_kept_to_the_hundredth_in_few_characters(value: float) -> None:
    text = digits(value)
    assert re.fullmatch(NUMBER, text)
    assert text != "-0"
    assert float(text) == pytest.approx(value, abs=0.0050001)


@given(st.text())
def test_any_text_can_be_written(words: str) -> None:
    painter = SvgPainter(FRAME, title=words)
    painter.text((0.0, 0.0), words, Lettering())
    finished(painter)


def test_what_xml_cannot_hold_is_replaced_and_all_else_kept() -> None:
    assert printable("a\x00b\ud800c\tÄ\U0001f3b1") == "a\ufffdb\ufffdc\tÄ\U0001f3b1"
