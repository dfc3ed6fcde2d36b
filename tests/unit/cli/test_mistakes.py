"""What is said of a name that there is not: the one that was meant, or all that there are."""

import pytest

from carom.cli.mistakes import meant, no_such

NAMES = ("shapes", "Balls", "hits")


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("shape", "did you mean shapes?"),
        ("SHAPES", "did you mean shapes?"),
        ("bals", "did you mean Balls?"),
        ("balls", "did you mean Balls?"),
        ("qqq", ""),
        ("", ""),
    ],
)
def test_the_nearest_name_is_meant_in_small_letters_or_large(text: str, hint: str) -> None:
    assert meant(text, NAMES) == hint


def test_a_name_of_none_is_told_with_the_nearest_or_with_all() -> None:
    assert str(no_such("layer", "hit", NAMES)) == "hit: no such layer; did you mean hits?"
    assert str(no_such("layer", "qqq", NAMES)) == "qqq: no such layer; there are shapes, Balls, hits"
    assert str(no_such("layer", "hit", iter(NAMES), "--layers")) == "--layers hit: no such layer; did you mean hits?"
