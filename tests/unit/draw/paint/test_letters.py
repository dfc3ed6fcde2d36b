"""Letters of raster pictures: thin or bold as in SVG, of every script that there is a font for."""

import warnings
from collections.abc import Iterator

import numpy as np
import pytest

from carom.draw.paint import letters
from carom.draw.paint.letters import MISSING, Letters, fonts_folder
from carom.errors import LettersWarning

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
BLACK = (0, 0, 0)


@pytest.fixture
def without_fonts(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """As if pygame_gui were not installed."""
    fonts_folder.cache_clear()
    monkeypatch.setattr(letters, "find_spec", lambda name: None)
    yield
    fonts_folder.cache_clear()


def darkness(words: str, *, bold: bool = False) -> float:
    """How much of a pixel words cover in all."""
    surface, _ = Letters().surface(words, 16.0, BLACK, bold=bold)
    return float(pygame.surfarray.array_alpha(surface).sum() / 255.0)


def test_bold_letters_are_darker_and_wider() -> None:
    pytest.importorskip("pygame_gui")
    assert darkness("illegibility", bold=True) > 1.25 * darkness("illegibility")
    plain, bold = (Letters().surface("illegibility", 16.0, BLACK, bold=bold)[0].get_width() for bold in (False, True))
    assert plain < bold < 1.2 * plain


@pytest.mark.parametrize(
    "words", ["\u6f22", "\u5b57", "\ud55c", "\u05db", "\u0643", "\u03b1", "\u0416", "\u2202", "\u221e"]
)
def test_letters_of_many_scripts_are_not_the_box_of_missing_ones(words: str) -> None:
    pytest.importorskip("pygame_gui")
    assert darkness(words) != darkness("\ue000")
    assert 3.0 < darkness(words) < 200.0


def test_a_word_of_two_scripts_stands_on_one_line() -> None:
    pytest.importorskip("pygame_gui")
    made = Letters()
    mixed, ascent = made.surface("ab\u6f22", 40.0, BLACK)
    plain, own = made.surface("ab", 40.0, BLACK)
    lower = pygame.surfarray.array_alpha(mixed)[: plain.get_width() - 2, ascent - own :]
    alone = pygame.surfarray.array_alpha(plain)[: plain.get_width() - 2]
    lines = min(lower.shape[1], alone.shape[1])
    assert np.abs(lower[:, :lines].astype(int) - alone[:, :lines]).mean() < 12.0


def test_hebrew_is_drawn_from_the_right() -> None:
    pytest.importorskip("pygame_gui")
    word, last, first = (Letters().surface(words, 40.0, BLACK)[0] for words in ("\u05e9\u05d5", "\u05d5", "\u05e9"))
    covers = pygame.surfarray.array_alpha(word).astype(int)
    left = np.abs(covers[: last.get_width() - 2] - pygame.surfarray.array_alpha(last)[:-2]).mean()
    assert last.get_width() < 0.7 * first.get_width()
    assert left < 12.0


def test_arabic_letters_join() -> None:
    pytest.importorskip("pygame_gui")
    joined = Letters().surface("\u0633\u0644\u0633", 40.0, BLACK)[0].get_width()
    assert joined < 0.9 * sum(Letters().surface(letter, 40.0, BLACK)[0].get_width() for letter in "\u0633\u0644\u0633")


@pytest.mark.usefixtures("without_fonts")
def test_without_the_fonts_pygames_own_is_used_and_one_line_says_so() -> None:
    made = Letters()
    with pytest.warns(LettersWarning, match="pip install") as told:
        surface, _ = made.surface("words", 16.0, BLACK)
    assert surface.get_width() > 20
    assert [str(warning.message) for warning in told] == [MISSING]
    assert "\n" not in MISSING
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made.surface("other words", 16.0, BLACK)


def test_no_words_are_no_letters() -> None:
    assert Letters().surface("", 16.0, BLACK)[0].get_width() == 0
