"""What shows itself in a notebook: a picture, a page that plays, or a table."""

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


class Tabled:
    """Base of what notebooks show as a table."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        """The table, as an element of HTML; None where it is an array of something else."""
        from carom.draw.notebook import table_of

        return table_of(self)
