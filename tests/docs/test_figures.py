"""The figures of the mathematics pages: each is drawn, holds its words, says what it shows, and stands on a page."""

import re
from math import isfinite
from pathlib import Path
from xml.etree import ElementTree

import pytest

from carom.draw import ThemeName
from docs.figures import FIGURES, draw_all
from docs.figures.sheet import LETTERS, svg_of
from tests.conventions.source_trees import ROOT

DRAWING = re.compile(r"^```\{drawing\} (\S+)\n(.+)\n```$", re.MULTILINE)
PAGES = sorted([*(ROOT / "docs" / "maths").glob("*.md"), ROOT / "docs" / "how-the-film-works.md"])
SVG = "{http://www.w3.org/2000/svg}"
#: Pixels: an average letter is about this part of its height wide.
LETTER_WIDTH = 0.55 * LETTERS


@pytest.mark.parametrize("name", sorted(FIGURES))
def test_the_words_of_a_figure_are_inside_of_it(name: str) -> None:
    root = ElementTree.fromstring(svg_of(name, ThemeName.LIGHT))
    width, height = float(root.attrib["width"]), float(root.attrib["height"])
    for text in root.iter(f"{SVG}text"):
        x, y, half = float(text.attrib["x"]), float(text.attrib["y"]), 0.5 * LETTER_WIDTH * len(text.text or "")
        assert half <= x <= width - half, text.text
        assert LETTERS * 0.7 <= y <= height, text.text


@pytest.mark.parametrize("name", sorted(FIGURES))
def test_the_words_of_a_figure_do_not_overlap(name: str) -> None:
    root = ElementTree.fromstring(svg_of(name, ThemeName.LIGHT))
    words = [(float(t.attrib["x"]), float(t.attrib["y"]), t.text or "") for t in root.iter(f"{SVG}text")]
    for place, (x, y, text) in enumerate(words):
        for other_x, other_y, other in words[:place]:
            apart = abs(x - other_x) >= 0.5 * LETTER_WIDTH * (len(text) + len(other)) or abs(y - other_y) >= LETTERS
            assert apart, (text, other)


@pytest.mark.parametrize("name", sorted(FIGURES))
def test_the_numbers_of_a_figure_are_finite(name: str) -> None:
    numbers = re.findall(r"[ \"ML](nan|-?inf|-?\d+\.?\d*)", svg_of(name, ThemeName.DARK))
    assert len(numbers) > 8
    assert all(isfinite(float(number)) for number in numbers)


def test_every_figure_stands_on_one_page_with_a_caption() -> None:
    found = [name for page in PAGES for name, _ in DRAWING.findall(page.read_text(encoding="utf-8"))]
    assert sorted(found) == sorted(FIGURES)
    assert all(figure.alt.endswith(".") for figure in FIGURES.values())


def test_figures_are_drawn_for_light_and_dark_pages_and_again_the_same(tmp_path: Path) -> None:
    draw_all(tmp_path)
    files = sorted(tmp_path.glob("*.svg"))
    assert len(files) == 2 * len(FIGURES)
    before = [(path.read_bytes(), path.stat().st_mtime_ns) for path in files]
    draw_all(tmp_path)
    assert [(path.read_bytes(), path.stat().st_mtime_ns) for path in files] == before
