"""Pictures of worlds and of runs.

`picture_of` decides what a picture of a world shows, `picture_at` what one of a recorded frame does; `svg` and `png`
write them. `Trace` follows a run for a picture of it. `Film` draws a recording frame by frame, `write_film` makes it a
GIF or an MP4, `replay_page` a page that plays it. `Live` draws a world that goes on into a window's surface;
`partition_of` says how its broad phase divides the room.
"""

from carom.draw.film.film import Film
from carom.draw.film.footage import picture_at
from carom.draw.film.movie import write_film
from carom.draw.history.trace import Trace
from carom.draw.live import Live
from carom.draw.page.page import replay_page
from carom.draw.paint.painter import Lettering, Painter, Style
from carom.draw.paint.raster import RasterPainter, png
from carom.draw.paint.svg import SvgPainter
from carom.draw.parts.cells import Cell, Partition, partition_of
from carom.draw.parts.layers import DEFAULT_LAYERS, Layer
from carom.draw.picture import Picture, picture_of, svg
from carom.draw.theme import ThemeName

__all__ = [
    "DEFAULT_LAYERS",
    "Cell",
    "Film",
    "Layer",
    "Lettering",
    "Live",
    "Painter",
    "Partition",
    "Picture",
    "RasterPainter",
    "Style",
    "SvgPainter",
    "ThemeName",
    "Trace",
    "partition_of",
    "picture_at",
    "picture_of",
    "png",
    "replay_page",
    "svg",
    "write_film",
]
