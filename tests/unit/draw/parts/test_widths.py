"""Widths of words: never less than the letters of common fonts take, and not much more."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.draw.paint.letters import Letters
from carom.draw.parts.widths import SQUARE, widest

NAMES = ("left slingshot's band", "drop target 3 \N{MULTIPLICATION SIGN} 4", "wall", "guard point", "WWW", "illi")


@given(st.text(st.characters(min_codepoint=32, max_codepoint=126), min_size=1, max_size=30))
def test_words_of_noto_sans_are_no_wider(words: str) -> None:
    pytest.importorskip("pygame_gui")
    surface, _ = Letters().surface(words, 11.0, (0, 0, 0))
    assert surface.get_width() <= 11.0 * widest(words) + 1.5


@pytest.mark.parametrize("name", NAMES)
def test_words_of_dejavu_sans_are_no_wider_and_not_much_narrower(name: str) -> None:
    pygame = pytest.importorskip("pygame")
    matplotlib = pytest.importorskip("matplotlib")
    pygame.font.init()
    font = pygame.font.Font(str(Path(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf")), 100)
    # pygame's sizes are the heights of fonts' squares, as those of SVG are.
    width = font.size(name)[0] / 100.0
    assert width <= widest(name) <= 1.4 * width + 0.1


def test_letters_of_the_east_are_squares_and_marks_on_letters_take_no_room() -> None:
    assert widest("\u6f22\u5b57") == 2.0 * SQUARE
    assert widest("e\u0301") == widest("e")
    assert widest("") == 0.0
