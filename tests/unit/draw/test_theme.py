"""The themes: the same inks, every one of them legible on its ground."""

import pytest

from carom.draw.theme import BALL_INKS, DARK, LIGHT, Theme

GROUNDS = {"paper", "stage", "rule"}


def luminance(colour: str) -> float:
    """The relative luminance of `#rrggbb`. Source: WCAG 2.1."""
    channels = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    """The contrast of two colours, 1 to 21. Source: WCAG 2.1."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_the_themes_have_the_same_inks() -> None:
    assert LIGHT.inks.keys() == DARK.inks.keys()
    assert set(BALL_INKS) <= LIGHT.inks.keys()


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_lines_stand_out_from_the_stage(theme: Theme) -> None:
    faint = {ink: contrast(colour, theme.inks["stage"]) for ink, colour in theme.inks.items() if ink not in GROUNDS}
    assert {ink: ratio for ink, ratio in faint.items() if ratio < 3.0} == {}


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_words_stand_out_from_the_paper(theme: Theme) -> None:
    assert min(contrast(theme.inks[ink], theme.inks["paper"]) for ink in ("text", "muted")) >= 4.5
