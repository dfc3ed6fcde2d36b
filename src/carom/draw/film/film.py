"""A recording as moving pixels: what never changes is drawn once, the rest anew for each frame."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from carom.draw.film.footage import Footage
from carom.draw.paint.raster import RasterPainter
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer
from carom.draw.theme import ThemeName
from carom.spelling import spelled

if TYPE_CHECKING:
    from collections.abc import Collection

    from carom.draw.parts.frame import Size
    from carom.record import Recording

#: Seconds of tracks and of hits in a film, in how many bands tracks fade, and how many hits are shown at most.
SPAN, FILM_BANDS, FILM_HITS = 1.5, 4, 120


@spelled
class Film:
    """The frames of a recording as pictures of one size; `frame` draws one, whichever was drawn before it.

    Raises `MissingExtra` without pygame.
    """

    def __init__(
        self,
        recording: Recording,
        *,
        layers: Collection[Layer] = DEFAULT_LAYERS,
        theme: ThemeName = ThemeName.LIGHT,
        size: Size = None,
    ) -> None:
        self._again = partial(Film, layers=layers, theme=theme, size=size)
        self._footage = Footage(recording)
        picture = self._footage.picture(len(recording) - 1, SPAN, layers=layers, size=size)
        self._picture = replace(picture, bands=FILM_BANDS)
        self._painter = RasterPainter(picture.frame, theme)
        self._picture.draw_still(self._painter)
        self._ground = self._painter.surface.copy()
        self._painter.quick = True

    def __reduce__(self) -> Any:
        """The recording, of which the frames are drawn anew."""
        return self._again, (self.recording,)

    @property
    def recording(self) -> Recording:
        """What is shown."""
        return self._footage.recording

    @property
    def pixels(self) -> tuple[int, int]:
        """Width and height."""
        return self._picture.frame.pixels

    def frame(self, frame: int) -> Any:
        """The surface of pygame's that shows a frame; it is the same each time, so the next frame replaces this one."""
        surface = self._painter.surface
        surface.blit(self._ground, (0, 0))
        moment = self._footage.moment(frame, SPAN, FILM_HITS)
        panel = replace(self._picture.panel, facts=self._footage.facts(frame))
        picture = replace(self._picture, moment=moment, panel=panel)
        picture.draw_moving(self._painter)
        return surface

    def rgb(self, frame: int) -> bytes:
        """The bytes of a frame: red, green and blue of each pixel, line by line."""
        self.frame(frame)
        return self._painter.rgb()
