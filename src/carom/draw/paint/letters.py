"""The letters of raster pictures: Noto Sans, plain and bold, in all the scripts that pygame_gui brings it for."""

from __future__ import annotations

import warnings
from functools import lru_cache
from importlib.util import find_spec
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom.draw.paint import directions
from carom.draw.paint.svg import printable
from carom.errors import LettersWarning
from carom.extras import needed

if TYPE_CHECKING:
    from carom.draw.paint.patches import Colour

#: The files of the fonts, without `Regular` or `Bold`, in the order in which a letter is looked for in them.
FACES = (
    "NotoSans-{}.ttf",
    "NotoSansSC-{}.otf",
    "NotoSansJP-{}.otf",
    "NotoSansKR-{}.ttf",
    "NotoSansArabic-{}.ttf",
    "NotoSansHebrew-{}.ttf",
    "NotoSansGeorgian-{}.ttf",
)
#: In the names of the files whose letters join.
ARABIC = "Arabic"
#: Letters are drawn so many times larger and made smaller, for fonts put small letters at whole pixels, unevenly apart.
FINER = 4
#: Pixels: the size at which fonts are asked which letters they have.
ASKED = 16
MISSING = 'raster pictures have bold letters alone, and of few scripts, without pygame_gui: pip install "carom[draw]"'


class Letters:
    """Words as surfaces of pygame's, their letters some pixels high; a letter that one font lacks is of the next.

    Raises `MissingExtra` without pygame. Without pygame_gui they are pygame's own, and a `LettersWarning` says so.
    """

    def __init__(self) -> None:
        self._pygame = needed("pygame", "pygame-ce", "draw", "raster pictures")
        self._freetype = needed("pygame.freetype", "pygame-ce", "draw", "raster pictures")
        self._pygame.font.init()
        self._freetype.init()
        self._font = lru_cache(maxsize=64)(self._pygame.font.Font)
        self._asked = lru_cache(maxsize=None)(self._freetype.Font)
        self._fonts = lru_cache(maxsize=2)(fonts)
        self._file_of = lru_cache(maxsize=4096)(self._found)
        self.surface = lru_cache(maxsize=512)(self._rendered)

    def _rendered(self, words: str, pixels: float, colour: Colour, *, bold: bool = False) -> tuple[Any, int]:
        """Words as a surface, and the pixels from its upper edge to their baseline."""
        height = max(1, round(FINER * pixels))
        pieces = [
            piece
            for line, from_right in directions.pieces(printable(words))
            for piece in self._drawn(line, height, colour, bold=bold, from_right=from_right)
        ]
        ascent = max((above for _, above in pieces), default=0)
        width = -(-sum(piece.get_width() for piece, _ in pieces) // FINER)
        below = max((piece.get_height() - above for piece, above in pieces), default=0)
        lines = -(-(ascent + below) // FINER)
        large = self._pygame.Surface((FINER * width, FINER * lines), self._pygame.SRCALPHA)
        large.fill((*colour, 0))
        left = 0
        for piece, above in pieces:
            large.blit(piece, (left, ascent - above))
            left += piece.get_width()
        return self._pygame.transform.smoothscale(large, (width, lines)), round(ascent / FINER)

    def _drawn(
        self, words: str, height: int, colour: Colour, *, bold: bool, from_right: bool
    ) -> list[tuple[Any, int]]:  # fmt: skip
        """Words of one direction as surfaces from left to right, one for each font, with the pixels above baselines."""
        found = []
        for file, letters in groupby(words, lambda letter: self._file_of(letter, bold=bold)):
            font = self._font(file, height)
            font.set_direction(self._pygame.DIRECTION_RTL if from_right else self._pygame.DIRECTION_LTR)
            if ARABIC in file:
                font.set_script("Arab")  # which joins its letters
            found.append((font.render("".join(letters), True, colour), font.get_ascent()))
        return found[::-1] if from_right else found

    def _found(self, letter: str, *, bold: bool) -> str:
        """The file of the first font that has a letter; of the first one where none has."""
        files = self._fonts(bold=bold) or (self._pygame.font.get_default_font(),)
        for file in files[: len(files) if len(files) > 1 else 0]:
            if self._asked(file, ASKED).get_metrics(letter)[0] is not None:
                return file
        return files[0]


def fonts(*, bold: bool) -> tuple[str, ...]:
    """The paths of the fonts that pygame_gui brings; none where it is not installed."""
    folder = fonts_folder()
    paths = [folder / face.format("Bold" if bold else "Regular") for face in FACES] if folder is not None else []
    return tuple(str(path) for path in paths if path.is_file())


@lru_cache
def fonts_folder() -> Path | None:
    """The folder of pygame_gui's fonts; None, and a warning, where it is not installed."""
    package = find_spec("pygame_gui")
    if package is None or package.origin is None:
        warnings.warn(MISSING, LettersWarning, stacklevel=2)
        return None
    return Path(package.origin).with_name("data")
