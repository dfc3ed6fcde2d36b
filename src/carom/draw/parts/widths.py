"""How wide words are at most, without knowing the reader's font."""

from __future__ import annotations

from unicodedata import combining, east_asian_width

#: Letters by the width, in heights of a letter, that they have at most in the sans-serif fonts of readers' systems.
WIDTHS = {
    **dict.fromkeys("'ijlJf ,.:;I-\N{NO-BREAK SPACE}", 0.36),
    **dict.fromkeys('/\\()[]tr!"_`szcxvykLFP?*|', 0.6),
    **dict.fromkeys("w#+<=>^~\N{MULTIPLICATION SIGN}OQDGMmW%@", 1.0),
}
#: What small letters and digits, and what capitals are wide, and all of the East that stand in a square.
SMALL, CAPITAL, SQUARE = 0.65, 0.8, 1.02


def widest(words: str) -> float:
    """How wide words are at most, in heights of a letter."""
    return sum(map(width_of, words))


def width_of(letter: str) -> float:
    """How wide one letter is at most, in its height."""
    if letter in WIDTHS:
        return WIDTHS[letter]
    if combining(letter):
        return 0.0
    if east_asian_width(letter) in {"W", "F"}:
        return SQUARE
    return CAPITAL if letter.isupper() or not letter.isalnum() else SMALL
