"""What shows itself in a notebook: a picture, or a page that plays."""

from __future__ import annotations


class Pictured:
    """Base of what notebooks show as a picture."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        """The picture, as the text of an SVG file."""
        from carom.draw.notebook import still  # here, for drawing lies above what it draws

        return still(self)


class Played(Pictured):
    """Base of what notebooks show as a page that plays, and as a picture where they cannot."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        """The page, as an element of HTML; None where it would be too large for a notebook."""
        from carom.draw.notebook import player

        return player(self)
