"""Words that are read from the right stand where browsers put them, and numbers and Latin words among them."""

import pytest

from carom.draw.paint.directions import pieces

SHIN, LAMED, ALEF, BEH = "\u05e9", "\u05dc", "\u0627", "\u0628"


@pytest.mark.parametrize(
    ("words", "shown"),
    [
        ("", ""),
        ("a (1.5) b", "a (1.5) b"),
        (f"{SHIN}{LAMED}", f"{LAMED}{SHIN}"),
        (f"{SHIN}{LAMED} 12", f"12 {LAMED}{SHIN}"),
        (f"{SHIN} -1.5%", f"1.5%- {SHIN}"),
        (f"{ALEF} 5%", f"5 {ALEF}%"),
        (f"{SHIN} %%2", f"%%2 {SHIN}"),
        (f"ball {SHIN}{LAMED} 3", f"ball 3 {LAMED}{SHIN}"),
        (f"{SHIN} 3 ball", f"3 {SHIN} ball"),
        (f"{BEH}{ALEF} ab 12 {BEH}", f"{ALEF}{BEH} ab 12 {BEH}"),
        (f"a {SHIN} {LAMED}, b", f"a {LAMED} {SHIN}, b"),
        (f"{SHIN}\u05b8{LAMED}", f"{LAMED}\u05b8{SHIN}"),
    ],
)
def test_pieces_stand_as_a_browser_has_them(words: str, shown: str) -> None:
    found = pieces(words)
    assert "".join(text[::-1] if from_right else text for text, from_right in found) == shown
    assert sorted("".join(text for text, _ in found)) == sorted(words)
