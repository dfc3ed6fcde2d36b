"""The options that say what a picture looks like."""

import pytest

from carom.cli.mistakes import Mistake
from carom.cli.view import View, layers_from, size_from
from carom.draw import DEFAULT_LAYERS, Layer, ThemeName


def test_layers_are_named_with_commas_between() -> None:
    assert layers_from("hits, cells,") == {Layer.HITS, Layer.CELLS}
    assert layers_from("all") == frozenset(Layer)


@pytest.mark.parametrize("text", ["", " , ", "hit", "HITS", "hits;cells", "all,hits"])
def test_other_layers_are_mistakes(text: str) -> None:
    with pytest.raises(Mistake, match="--layers"):
        layers_from(text)


def test_a_page_shows_at_first_what_was_asked_for() -> None:
    view = View.of(ThemeName.DARK, "hits,cells", "800")
    assert view == View(ThemeName.DARK, {Layer.HITS, Layer.CELLS}, {Layer.HITS, Layer.CELLS}, 800)
    view = View.of(ThemeName.AUTO, None, None)
    assert view == View(ThemeName.AUTO, DEFAULT_LAYERS, DEFAULT_LAYERS | {Layer.LIGHTS}, None)


def test_a_size_is_one_side_or_two() -> None:
    assert size_from("800") == 800
    assert size_from("1280X720") == (1280, 720)


@pytest.mark.parametrize("text", ["", "x", "800x", "-800", "8e2", "63", "9000x800", "1" * 500, "²"])
def test_other_sizes_are_mistakes(text: str) -> None:
    with pytest.raises(Mistake, match="--size"):
        size_from(text)
