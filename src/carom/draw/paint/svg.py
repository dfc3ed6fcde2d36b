"""The painter of SVG files: true circles and arcs, one file for light and dark readers, the same bytes every time."""

from __future__ import annotations

from math import ceil, cos, pi, sin
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from carom.draw.paint.painter import sides
from carom.draw.theme import DARK, LIGHT, THEMES, Theme, ThemeName, theme_name
from carom.spelling import spelled

if TYPE_CHECKING:
    from carom.draw.paint.painter import Lettering, Points, Style, Vector
    from carom.draw.parts.frame import Frame

FONT = "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif"

#: Radians. Longer arcs are drawn in pieces: near a half turn, the rounding of an arc's ends would move its centre far.
LONGEST_PIECE = 2.0 * pi / 3.0


def digits(value: float) -> str:
    """`value` in as few characters as a hundredth of a pixel needs."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in {"-0", ""} else text


def printable(words: str) -> str:
    """`words` as XML can hold them: control characters and lone surrogates become U+FFFD."""

    def allowed(character: str) -> bool:
        code = ord(character)
        return code in {0x9, 0xA, 0xD} or 0x20 <= code <= 0xD7FF or 0xE000 <= code <= 0xFFFD or code >= 0x10000

    return "".join(character if allowed(character) else "\ufffd" for character in words)


@spelled
class SvgPainter:
    """Draws into SVG text; `finish` returns it."""

    def __init__(self, frame: Frame, theme: ThemeName = ThemeName.AUTO, title: str = "") -> None:
        self._frame = frame
        self._theme = theme_name(theme)
        self._title = title
        self._parts: list[str] = []
        self._style: str | None = None
        self._in_layer = False
        self._classes: dict[str, tuple[str, str]] = {}

    # -- the painter's calls ---------------------------------------------------------------------------------------

    def layer(self, name: str) -> None:
        """Begin the layer `name`, a group with that id."""
        self._close_layer()
        self._parts.append(f"<g id={quoteattr(name)}>")
        self._in_layer = True

    def segment(self, start: Vector, end: Vector, style: Style) -> None:
        """Draw a straight line, as a path."""
        self._use(style)
        self._parts.append(f'<path d="M{self._place(*start)}L{self._place(*end)}"/>')

    def circle(self, center: Vector, radius: float, style: Style) -> None:
        """Draw a circle."""
        self._use(style)
        x, y = self._frame.pixel(*center)
        self._parts.append(f'<circle cx="{digits(x)}" cy="{digits(y)}" r="{digits(radius * self._frame.scale)}"/>')

    def arc(self, center: Vector, radius: float, start_angle: float, end_angle: float, style: Style) -> None:
        """Draw an arc as one to three elliptical arcs of a path, none longer than a third of a turn."""
        self._use(style)
        sweep = (end_angle - start_angle) % (2.0 * pi)
        pieces = max(1, ceil(sweep / LONGEST_PIECE))
        radius_text = digits(radius * self._frame.scale)
        path = ""
        for piece in range(pieces + 1):
            angle = start_angle + sweep * piece / pieces
            place = self._place(center[0] + radius * cos(angle), center[1] + radius * sin(angle))
            # Counterclockwise with y up is SVG's sweep 0, with y down.
            path += f"A{radius_text} {radius_text} 0 0 0 {place}" if piece else f"M{place}"
        self._parts.append(f'<path d="{path}"/>')

    def box(self, low: Vector, high: Vector, style: Style) -> None:
        """Draw the sides of a box."""
        for start, end in sides(low, high):
            self.segment(start, end, style)

    def polyline(self, points: Points, style: Style) -> None:
        """Draw a line through points, closed where it is filled."""
        # Round ends would make beads where the parts of a translucent track meet.
        self._use(style, ' stroke-linecap="butt"' if style.opacity < 1.0 else "")
        places = " ".join(self._place(float(x), float(y)) for x, y in points)
        tag = "polyline" if style.fill is None else "polygon"
        self._parts.append(f'<{tag} points="{places}"/>')

    def text(self, position: Vector, words: str, lettering: Lettering) -> None:
        """Write one line of words."""
        self._close_style()
        x, y = self._frame.pixel(*position)
        look = f'class="{self._class("fill", lettering.ink)}" font-size="{digits(lettering.size)}"'
        if lettering.bold:
            look += ' font-weight="600"'
        if lettering.anchor != "start":
            look += f' text-anchor="{lettering.anchor}"'
        self._parts.append(f'<text x="{digits(x)}" y="{digits(y)}" {look}>{escape(printable(words))}</text>')

    # -- the file --------------------------------------------------------------------------------------------------

    def finish(self) -> str:
        """The whole SVG text."""
        self._close_layer()
        width, height = digits(self._frame.width), digits(self._frame.height)
        shown_width, shown_height = self._frame.pixels
        head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{shown_width}" height="{shown_height}" '
            f'viewBox="0 0 {width} {height}" role="img" fill="none" stroke-linecap="round" stroke-linejoin="round" '
            f'font-family="{FONT}">'
        )
        title = f"<title>{escape(printable(self._title))}</title>"
        return "\n".join([head, title, f"<style>{self._rules()}</style>", *self._parts, "</svg>", ""])

    def _rules(self) -> str:
        """The style sheet: the colours of the inks in use, those of the dark theme behind a media query."""
        if self._theme is ThemeName.AUTO:
            return f"{self._colours(LIGHT)}@media(prefers-color-scheme:dark){{{self._colours(DARK)}}}"
        return self._colours(THEMES[self._theme])

    def _colours(self, theme: Theme) -> str:
        """One rule for each class in use, in the order of their names."""
        rules = (f".{name}{{{part}:{theme.inks[ink]}}}" for name, (part, ink) in sorted(self._classes.items()))
        return "".join(rules)

    def _place(self, x: float, y: float) -> str:
        """The world's point (x, y) as SVG writes it."""
        pixel_x, pixel_y = self._frame.pixel(x, y)
        return f"{digits(pixel_x)} {digits(pixel_y)}"

    def _class(self, part: str, ink: str) -> str:
        """The class that gives `part` (fill or stroke) the colour of `ink`."""
        name = f"{part[0]}-{ink}"
        self._classes[name] = (part, ink)
        return name

    def _use(self, style: Style, more: str = "") -> None:
        """Open a group with the look of `style` and `more` attributes, unless the last mark had the same."""
        attributes = self._attributes(style) + more
        if attributes != self._style:
            self._close_style()
            self._parts.append(f"<g {attributes}>")
            self._style = attributes

    def _attributes(self, style: Style) -> str:
        """What a group of marks of one style says of itself."""
        classes = []
        shown = []
        if style.fill is not None:
            classes.append(self._class("fill", style.fill))
            if style.fill_opacity != 1.0:
                shown.append(f'fill-opacity="{digits(style.fill_opacity)}"')
        if style.stroke is not None:
            classes.append(self._class("stroke", style.stroke))
            shown.append(f'stroke-width="{digits(style.width)}"')
            if style.dash:
                shown.append(f'stroke-dasharray="{" ".join(map(digits, style.dash))}"')
        if style.opacity != 1.0:
            shown.append(f'opacity="{digits(style.opacity)}"')
        return " ".join([f'class="{" ".join(classes)}"', *shown])

    def _close_style(self) -> None:
        """End the group of the last style, if one is open."""
        if self._style is not None:
            self._parts.append("</g>")
            self._style = None

    def _close_layer(self) -> None:
        """End the layer that is open, if one is."""
        self._close_style()
        if self._in_layer:
            self._parts.append("</g>")
            self._in_layer = False
