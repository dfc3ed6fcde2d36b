"""The options that say what a picture looks like."""

import pytest

from carom.cli.mistakes import Mistake
from carom.cli.view import layers_from, size_from
from carom.draw import DEFAULT_LAYERS, Layer


def test_layers_are_named_with_commas_between() -> None:
    assert layers_from(None) == DEFAULT_LAYERS
    assert layers_from("hits, cells,") == {Layer.HITS, Layer.CELLS}
    assert layers_from("all") == frozenset(Layer)
    assert layers_from("") == frozenset()


def test_a_size_is_one_side_or_two() -> None:
    assert size_from(None) is None
    assert size_from("800") == 800
    assert size_from("1280X720") == (1280, 720)


@pytest.mark.parametrize("text", ["", "x", "800x", "-800", "8e2", "63", "9000x800", "1" * 500, "²"])
def test_other_sizes_are_mistakes(text: str) -> None:
    with pytest.raises(Mistake, match="--size"):
        size_from(text)
