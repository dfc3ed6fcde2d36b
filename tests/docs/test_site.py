"""What the site does to its pages: links, docstrings and formulas; and that it refuses to load from a network.

Needs the extra `docs`, and is skipped without it.
"""

import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.conventions.source_trees import ROOT

pytest.importorskip("sphinx_gallery", reason="no Sphinx: the site's own parts are not tested")
sys.path.append(str(ROOT / "docs" / "extensions"))

from sphinx.errors import ExtensionError

from docs.extensions import mathml, pages

APP: Any = None


@pytest.mark.parametrize(
    ("page", "link", "there"),
    [
        ("modes", "[x](../README.md#how)", "[x](index.md#how)"),
        ("maths/tangents", "[x](../../CONTRIBUTING.md)", "[x](../contributing.md)"),
        ("maths/tangents", "[x](../../examples/lidar.py)", "[x](../gallery/lidar.rst)"),
        ("index", "[x](../examples/README.rst)", "[x](gallery/index.rst)"),
        ("index", "[x](concepts.md)", "[x](concepts.md)"),
    ],
)
def test_links_out_of_the_docs_lead_to_their_pages(page: str, link: str, there: str) -> None:
    source = [f"See {link}."]
    pages.link_within(APP, page, source)
    assert source == [f"See {there}."]


def test_bars_and_stars_of_docstrings_are_those_of_formulas_but_in_code() -> None:
    lines = ["The part |c - q| of `a*b|c_` and dtype_ in *x."]
    pages.escape_docstring(APP, "function", "f", None, None, lines)
    assert lines == [r"The part \|c - q\| of `a*b|c_` and dtype\_ in \*x."]


def test_a_colon_in_the_sentence_on_an_attribute_is_no_type() -> None:
    lines = ["What it is: a point.", "More."]
    pages.escape_docstring(APP, "property", "kind", None, None, lines)
    assert lines == [": What it is: a point.", "More."]


def test_bars_of_formulas_open_and_close_in_turn() -> None:
    text = mathml.mathml(r"|a| < \bigl||b| - c\bigr|")
    assert text.count('form="prefix"') == text.count('form="postfix"') == 3
    small = [part for part in text.split("<mo ") if part.startswith('stretchy="false"')]
    assert ["prefix" in part for part in small] == [True, False, True, False]


@pytest.mark.parametrize(
    "tag",
    [
        '<script src="https://example.org/x.js"></script>',
        '<img alt="" src="//example.org/x.png">',
        '<link rel="stylesheet" href="https://example.org/x.css">',
    ],
)
def test_a_page_that_loads_from_a_network_fails_the_build(tag: str, tmp_path: Path) -> None:
    app: Any = SimpleNamespace(outdir=tmp_path)
    page = tmp_path / "page.html"
    page.write_text('<script src="_static/x.js"></script><a href="https://example.org">x</a>', encoding="utf-8")
    pages.refuse_network(app, None)
    page.write_text(tag, encoding="utf-8")
    with pytest.raises(ExtensionError, match=r"load something from a network: page\.html"):
        pages.refuse_network(app, None)
