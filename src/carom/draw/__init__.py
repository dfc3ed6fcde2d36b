"""Pictures of worlds and of runs.

`picture_of` decides what a picture shows, `svg` writes it as an SVG file's text, `Trace` follows a run for it.
"""

from carom.draw.painter import Lettering, Painter, Style
from carom.draw.picture import Picture, picture_of, svg
from carom.draw.svg import SvgPainter
from carom.draw.theme import ThemeName
from carom.draw.trace import Trace

__all__ = [
    "Lettering",
    "Painter",
    "Picture",
    "Style",
    "SvgPainter",
    "ThemeName",
    "Trace",
    "picture_of",
    "svg",
]
