"""What notebooks show: pictures, pages that play, and tables."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from carom.draw.alone import picture_alone
from carom.draw.film.footage import picture_at
from carom.draw.page.page import replay_page
from carom.draw.picture import picture_of, svg
from carom.draw.tables import table_of
from carom.record import Recording
from carom.scene.scene import Scene
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.detection import Contact
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.world.world import World

if TYPE_CHECKING:
    from carom.pictured import Pictured

__all__ = ["player", "still", "table_of"]

#: Pixels: the longer side of a picture, and the height of a page. A notebook's column is about as wide.
PICTURE_SIZE, PAGE_HEIGHT = 800, 560
#: Characters: what a notebook can hold of one page. It is loaded and saved with all of its outputs.
LONGEST_PAGE = 16_000_000


def still(shown: Pictured) -> str:
    """The picture of a world or shape as it stands, of a scene, a contact, or a recording's last frame, as SVG."""
    if isinstance(shown, Recording):
        return svg(picture_at(shown, size=PICTURE_SIZE))
    if isinstance(shown, Scene):
        return svg(picture_of(shown.build(), shown.name or "Scene", size=PICTURE_SIZE))
    if isinstance(shown, World):
        return svg(picture_of(shown, caption=f"At {shown.time:g} s.", size=PICTURE_SIZE))
    if isinstance(shown, Shape | Compound | Group | Ball | Contact):
        return svg(picture_alone(shown))
    raise TypeError(f"there are no pictures of a {type(shown).__name__}")


def player(shown: Pictured) -> str | None:
    """The page that plays a recording, in a frame of its own, from which nothing can reach the notebook.

    None for a recording whose page would be longer than `LONGEST_PAGE`; the notebook then shows its picture.
    """
    if not isinstance(shown, Recording):
        raise TypeError(f"there are no pages of a {type(shown).__name__}")
    page = replay_page(shown)
    if len(page) > LONGEST_PAGE:
        return None
    return (
        f'<iframe srcdoc="{escape(page)}" sandbox="allow-scripts" title="{escape(shown.name or "A run")}" '
        f'style="width: 100%; height: {PAGE_HEIGHT}px; border: 0; border-radius: 8px"></iframe>'
    )
