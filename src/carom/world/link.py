"""`Link`: what a world's hits and answers share with it, by which copies of them find the copied world."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from carom.world.world import World


class Link:
    """Leads from hits and answers to the world that they are of; a world has one, which all of them share.

    A copy or pickle of hits holds the link and not the world. One that holds the world too makes one new link for both,
    in whatever order they come, and the new world ties it to itself. Without the world, the copy of a link leads to the
    same world, and one that was pickled leads nowhere.
    """

    __slots__ = ("world",)

    def __init__(self, world: World | None = None) -> None:
        self.world = world

    def __deepcopy__(self, memo: dict[int, Any]) -> Link:
        return Link(self.world)

    def __reduce__(self) -> Any:
        return Link, ()
