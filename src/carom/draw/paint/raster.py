"""The painter of pixels: a surface of pygame's, drawn without a window, lines and letters smooth."""

from __future__ import annotations

import io
from functools import lru_cache
from itertools import pairwise
from math import ceil, pi, sqrt
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.checks import instance
from carom.draw.paint.letters import Letters
from carom.draw.paint.painter import Style, sides
from carom.draw.paint.patches import (
    Extent,
    from_arc,
    from_circle,
    from_segment,
    line_patches,
    nearest_of,
    patches,
    polygon_patches,
    polyline_patches,
)
from carom.draw.theme import THEMES, ThemeName, theme_name
from carom.extras import needed
from carom.spelling import spelled

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Iterable, Sequence

    from carom.draw.paint.painter import Lettering, Points, Vector
    from carom.draw.paint.patches import Colour, Distance, Patch
    from carom.draw.parts.frame import Frame
    from carom.draw.picture import Picture

#: Marks are kept while they are smaller than so many pixels, and so many of them.
LARGEST_KEPT, MOST_KEPT = 96, 4000
#: Small circles stand at places of a grid that is so many times finer than the pixels, to be drawn once for many.
FINER_PLACES = 4
#: What a quick painter draws as pygame does: faint lines, lines up to so many pixels wide, and areas with up to so many
#: corners.
QUICK_WIDTH, QUICK_CORNERS = 3.0, 4
#: Pixels: how far inside of an arc the line may be that a quick painter draws it as.
QUICK_SAGITTA = 0.15
#: The edge of an area that is drawn quickly.
EDGE = Style(width=1.0)
#: The ink that faint lines are mixed with.
GROUND = "stage"


@spelled
def png(picture: Picture, theme: ThemeName = ThemeName.LIGHT) -> bytes:
    """The bytes of a PNG file that shows `picture`; raises `MissingExtra` without pygame."""
    from carom.draw.picture import Picture  # here, for pictures lie above painters

    painter = RasterPainter(instance("picture", picture, Picture, "a Picture").frame, theme)
    picture.draw(painter)
    return painter.png()


@spelled
class RasterPainter:
    """Draws into `surface`, of the size that the frame says; lengths and letters are the frame's, times its zoom.

    While it is `quick`, thin lines, those through many points, and arrows' heads are drawn less finely. Raises
    `MissingExtra` without pygame.
    """

    def __init__(self, frame: Frame, theme: ThemeName = ThemeName.LIGHT, *, quick: bool = False) -> None:
        self.quick = quick
        self._pygame = needed("pygame", "pygame-ce", "draw", "raster pictures")
        self._frame = frame
        self._zoom = frame.zoom
        self._scale = frame.scale * frame.zoom
        self._left, self._top = frame.stage_left * frame.zoom, frame.stage_top * frame.zoom
        self._stage_left, self._stage_top = frame.stage.left, frame.stage.top
        self.surface = self._pygame.Surface(frame.pixels)
        self._inks: dict[str, Colour] = {
            ink: (int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16))
            for ink, colour in THEMES[theme_name(theme)].inks.items()
        }
        self._kept: dict[Hashable, list[Patch]] = {}
        self._letters = Letters()
        self._mixed = lru_cache(maxsize=1024)(self._mixture)

    # -- the painter's calls ---------------------------------------------------------------------------------------

    def layer(self, name: str) -> None:
        """Do nothing: pixels have no layers."""

    def segment(self, start: Vector, end: Vector, style: Style) -> None:
        """Draw a straight line."""
        a, b = self._pixel(*start), self._pixel(*end)
        if style.stroke is not None and self._is_quick(style):
            self._quick_lines(dashes(a, b, style.dash, self._zoom), style, style.stroke)
            return

        def made(colour: Colour, width: float) -> list[Patch]:
            pieces = [from_segment(*piece) for piece in dashes(a, b, style.dash, self._zoom)]
            return line_patches(nearest_of(pieces), Extent.of([a, b], width), width, colour, self.surface.get_size())

        self._stroke(("segment", a, b), made, style, abs(b[0] - a[0]) + abs(b[1] - a[1]))

    def circle(self, center: Vector, radius: float, style: Style) -> None:
        """Draw a circle."""
        (x, y), pixels = self._pixel(*center), radius * self._frame.scale * self._zoom
        if style.stroke is not None and style.fill is None and not style.dash and self._is_quick(style):
            width, colour = style.width * self._zoom, self._mixed(style.stroke, style.opacity)
            self._pygame.draw.aacircle(self.surface, colour, (x, y), pixels + 0.5 * width, max(1, round(width)))
            return
        if 2.0 * pixels < LARGEST_KEPT:
            self._small_circle(x, y, pixels, style)
            return
        extent, edge = Extent.of([(x, y)], pixels + style.width * self._zoom + 1.0), from_circle((x, y), pixels)
        size = self.surface.get_size()
        if style.fill is not None:
            self._blit(patches(edge, extent, self._inks[style.fill], size), style.opacity * style.fill_opacity)
        if style.stroke is not None:
            lines = edge
            if style.dash:
                lines = nearest_of(arc_dashes((x, y), pixels, 0.0, 2.0 * pi, style.dash, self._zoom))
            width = style.width * self._zoom
            self._blit(line_patches(lines, extent, width, self._inks[style.stroke], size), style.opacity)

    def arc(self, center: Vector, radius: float, start_angle: float, end_angle: float, style: Style) -> None:
        """Draw an arc."""
        place, pixels = self._pixel(*center), radius * self._frame.scale * self._zoom
        sweep = (end_angle - start_angle) % (2.0 * pi)
        if style.stroke is not None and not style.dash and self._is_quick(style):
            # A chord over an angle a of a circle of radius r is r a²/8 inside of it.
            pieces = ceil(sweep / sqrt(8.0 * QUICK_SAGITTA / max(pixels, 1.0)))
            angles = start_angle + np.linspace(0.0, sweep, max(3, pieces + 1))
            xs, ys = place[0] + pixels * np.cos(angles), place[1] - pixels * np.sin(angles)
            places = list(zip(xs.tolist(), ys.tolist(), strict=True))
            self._quick_lines(pairwise(places), style, style.stroke)
            return

        def made(colour: Colour, width: float) -> list[Patch]:
            pieces = arc_dashes(place, pixels, start_angle, sweep, style.dash, self._zoom)
            extent = Extent.of([place], pixels + width)
            return line_patches(nearest_of(pieces), extent, width, colour, self.surface.get_size())

        self._stroke(("arc", place, pixels, start_angle, end_angle), made, style, 2.0 * pixels)

    def box(self, low: Vector, high: Vector, style: Style) -> None:
        """Draw the sides of a box."""
        (left, bottom), (right, top) = self._pixel(*low), self._pixel(*high)
        size = round(right - left), round(bottom - top)
        if style.stroke is None or not self._is_quick(style) or max(size) >= LARGEST_KEPT:
            for start, end in sides(low, high):
                self.segment(start, end, style)
            return
        key = ("box", size, style)
        found = self._kept.get(key)
        if found is None:
            found = [(self._box_patch(size, style, style.stroke), 0, 0)]
            self._keep(key, found)
        rim = max(1, round(style.width * self._zoom))
        self.surface.blit(found[0][0], (round(left) - rim, round(top) - rim))

    def polyline(self, points: Points, style: Style) -> None:
        """Draw a line through points; with a fill, the area that they bound."""
        places = self._pixels(points)
        if style.fill is not None:
            self._area(places, style, self._inks[style.fill])
        if style.stroke is not None:
            ends = places if style.fill is None else [*places, places[0]]
            if self.quick:
                self._quick_lines(pairwise(ends), style, style.stroke)
            else:
                width, size = style.width * self._zoom, self.surface.get_size()
                self._blit(polyline_patches(ends, width, self._inks[style.stroke], size), style.opacity)

    def text(self, position: Vector, words: str, lettering: Lettering) -> None:
        """Write one line of words."""
        x, y = self._pixel(*position)
        pixels, colour = lettering.size * self._zoom, self._inks[lettering.ink]
        letters, ascent = self._letters.surface(words, pixels, colour, bold=lettering.bold)
        shift = {"start": 0.0, "middle": 0.5, "end": 1.0}[lettering.anchor]
        self.surface.blit(letters, (round(x - shift * letters.get_width()), round(y - ascent)))

    # -- the picture -----------------------------------------------------------------------------------------------

    def png(self) -> bytes:
        """The picture as the bytes of a PNG file."""
        file = io.BytesIO()
        self._pygame.image.save(self.surface, file, "picture.png")
        return file.getvalue()

    def rgb(self) -> bytes:
        """The picture as bytes: red, green and blue of each pixel, line by line."""
        data: bytes = self._pygame.image.tobytes(self.surface, "RGB")
        return data

    # -- how -------------------------------------------------------------------------------------------------------

    def _pixel(self, x: float, y: float) -> Vector:
        """Where the world's point (x, y) lies, in pixels of the surface."""
        return self._left + (x - self._stage_left) * self._scale, self._top + (self._stage_top - y) * self._scale

    def _pixels(self, points: Points) -> list[Vector]:
        """The same for many points."""
        return [self._pixel(x, y) for x, y in points.tolist()]

    def _small_circle(self, x: float, y: float, radius: float, style: Style) -> None:
        """Draw a circle of which there may be many."""
        column, line = round(x * FINER_PLACES), round(y * FINER_PLACES)
        size = round(radius * 2 * FINER_PLACES)
        whole_x, part_x = divmod(column, FINER_PLACES)
        whole_y, part_y = divmod(line, FINER_PLACES)
        key = ("circle", part_x, part_y, size, style)
        kept = self._kept.get(key)
        if kept is None:
            kept = self._circle_patches(part_x, part_y, 0.5 * size / FINER_PLACES, style)
            for patch, _, _ in kept:
                patch.set_alpha(255, self._pygame.RLEACCEL)
            self._keep(key, kept)
        for patch, left, top in kept:
            self.surface.blit(patch, (whole_x + left - LARGEST_KEPT, whole_y + top - LARGEST_KEPT))

    def _circle_patches(self, part_x: int, part_y: int, radius: float, style: Style) -> list[Patch]:
        """The patches of a circle, as if around the pixel (`LARGEST_KEPT`, `LARGEST_KEPT`)."""
        center = LARGEST_KEPT + part_x / FINER_PLACES, LARGEST_KEPT + part_y / FINER_PLACES
        extent = Extent.of([center], radius + style.width * self._zoom + 1.0)
        edge, size = from_circle(center, radius), (4 * LARGEST_KEPT, 4 * LARGEST_KEPT)
        found: list[Patch] = []
        if style.fill is not None:
            found += faint(patches(edge, extent, self._inks[style.fill], size), style.opacity * style.fill_opacity)
        if style.stroke is not None:
            pieces = arc_dashes(center, radius, 0.0, 2.0 * pi, style.dash, self._zoom) if style.dash else [edge]
            width, colour = style.width * self._zoom, self._inks[style.stroke]
            found += faint(line_patches(nearest_of(pieces), extent, width, colour, size), style.opacity)
        return merged(found)

    def _stroke(self, key: Hashable, made: Callable[[Colour, float], list[Patch]], style: Style, extent: float) -> None:
        """Draw a line, which is made anew unless it was drawn before and is small."""
        if style.stroke is None:
            return
        key = (key, style.stroke, style.width, style.dash)
        found = self._kept.get(key)
        if found is None:
            found = made(self._inks[style.stroke], style.width * self._zoom)
            if extent < LARGEST_KEPT:
                self._keep(key, found)
        self._blit(found, style.opacity)

    def _area(self, places: Sequence[Vector], style: Style, colour: Colour) -> None:
        """Fill the area within a line: whole pixels for a box that stands upright."""
        opacity = style.opacity * style.fill_opacity
        if self.quick and style.fill is not None and opacity == 1.0 and len(places) < 4:
            self._quick_area(places, style.fill)
            return
        xs, ys = {x for x, _ in places}, {y for _, y in places}
        if len(places) == 4 and len(xs) == 2 and len(ys) == 2:
            left, right, top, bottom = round(min(xs)), round(max(xs)), round(min(ys)), round(max(ys))
            box = self._pygame.Rect(left, top, max(1, right - left), max(1, bottom - top)).clip(self.surface.get_rect())
            if opacity == 1.0:
                self.surface.fill(colour, box)
            else:
                veil = self._pygame.Surface(box.size)
                veil.fill(colour)
                self._blit([(veil, box.left, box.top)], opacity)
            return
        if self.quick and style.fill is not None and opacity == 1.0 and len(places) <= QUICK_CORNERS:
            self._quick_area(places, style.fill)
            return
        key = ("area", tuple(places), colour)
        found = self._kept.get(key)
        if found is None:
            found = polygon_patches(places, colour, self.surface.get_size())
            self._keep(key, found)
        self._blit(found, opacity)

    def _is_quick(self, style: Style) -> bool:
        """Whether a line of some style is to be drawn as pygame does."""
        return self.quick and (style.width <= QUICK_WIDTH or style.opacity < 1.0)

    def _quick_lines(self, pieces: Iterable[tuple[Vector, Vector]], style: Style, ink: str) -> None:
        """Draw lines as pygame does: of whole pixels' width, in the colour that they have on the stage."""
        colour, surface = self._mixed(ink, style.opacity), self.surface
        width = max(1, round(style.width * self._zoom))
        line = self._pygame.draw.aaline
        for start, end in pieces:
            line(surface, colour, start, end, width)

    def _quick_area(self, places: Sequence[Vector], ink: str) -> None:
        """Fill an area of few corners as pygame does, its edges smooth."""
        self._pygame.draw.polygon(self.surface, self._inks[ink], places)
        self._quick_lines(pairwise([*places, places[0]]), EDGE, ink)

    def _box_patch(self, size: tuple[int, int], style: Style, ink: str) -> Any:
        """The sides of a box of `size` pixels as a surface that is clear elsewhere, a line's width around it."""
        width = max(1, round(style.width * self._zoom))
        patch = self._pygame.Surface([side + 2 * width + 1 for side in size], self._pygame.SRCALPHA)
        low, high = (width, size[1] + width), (size[0] + width, width)
        for a, b in sides(low, high):
            for start, end in dashes(a, b, style.dash, self._zoom):
                self._pygame.draw.line(patch, self._mixed(ink, style.opacity), start, end, width)
        return patch

    def _keep(self, key: Hashable, found: list[Patch]) -> None:
        """Remember patches, and forget all when they become too many."""
        if len(self._kept) >= MOST_KEPT:
            self._kept.clear()
        self._kept[key] = found

    def _blit(self, found: list[Patch], opacity: float) -> None:
        """Draw patches."""
        alpha = round(255.0 * opacity)
        for patch, left, top in found:
            patch.set_alpha(alpha)
            self.surface.blit(patch, (left, top))

    def _mixture(self, ink: str, opacity: float) -> Colour:
        """The colour of a faint ink on the stage."""
        above, below = self._inks[ink], self._inks[GROUND]
        red, green, blue = (round(opacity * a + (1.0 - opacity) * b) for a, b in zip(above, below, strict=True))
        return red, green, blue


def dashes(start: Vector, end: Vector, dash: Sequence[float], zoom: float) -> list[tuple[Vector, Vector]]:
    """The drawn pieces of a line between two pixels."""
    if not dash or start == end:
        return [(start, end)]
    across, down = end[0] - start[0], end[1] - start[1]
    length = sqrt(across * across + down * down)
    across, down = across / length, down / length
    return [
        ((start[0] + across * low, start[1] + down * low), (start[0] + across * high, start[1] + down * high))
        for low, high in spans(length, dash, zoom)
    ]


def arc_dashes(
    center: Vector, radius: float, start_angle: float, sweep: float, dash: Sequence[float], zoom: float
) -> list[Distance]:
    """The distances from the drawn pieces of an arc."""
    pieces = spans(radius * sweep, dash, zoom) if dash else [(0.0, radius * sweep)]
    return [from_arc(center, radius, start_angle + low / radius, start_angle + high / radius) for low, high in pieces]


def spans(length: float, dash: Sequence[float], zoom: float) -> list[tuple[float, float]]:
    """Where the drawn pieces of a dashed line of some length begin and end; the first is drawn in full."""
    drawn, gap = dash[0] * zoom, dash[1] * zoom
    count = int(length / (drawn + gap)) + 1
    begins = [number * (drawn + gap) for number in range(count)]
    return [(begin, min(begin + drawn, length)) for begin in begins]


def faint(found: list[Patch], opacity: float) -> list[Patch]:
    """Patches, made fainter for good."""
    if opacity < 1.0:
        for patch, _, _ in found:
            patch.fill((255, 255, 255, round(255.0 * opacity)), special_flags=rgba_mult())
    return found


def merged(found: list[Patch]) -> list[Patch]:
    """Patches that stand at the same place as one, the later ones over the earlier ones."""
    joined: dict[tuple[int, int, tuple[int, int]], Any] = {}
    for patch, left, top in found:
        key = (left, top, patch.get_size())
        if key in joined:
            joined[key].blit(patch, (0, 0))
        else:
            joined[key] = patch
    return [(patch, left, top) for (left, top, _), patch in joined.items()]


def rgba_mult() -> int:
    """The number by which pygame knows the product of two colours."""
    number: int = needed("pygame", "pygame-ce", "draw", "raster pictures").BLEND_RGBA_MULT
    return number
