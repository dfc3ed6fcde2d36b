"""Copies and pickles of a world: its snapshot, and the objects that go with it.

Members say nothing of their world when they are copied or pickled, so one that goes alone is lone. The world names its
members, and within one copy or pickle every object is made once: so it gets the very copies that lists, classes and the
members' own data hold, in whatever order all of them come, and takes them in.
"""

from __future__ import annotations

from collections.abc import Container
from copy import copy
from typing import TYPE_CHECKING, Any

from carom.shapes.assembly import Assembly
from carom.shapes.copies import add_attributes, added_attributes
from carom.world.departed import Departed
from carom.world.hits import NO_ROWS, Hits
from carom.world.link import Link
from carom.world.snapshot import read_snapshot, write_snapshot

if TYPE_CHECKING:
    from carom.world.world import World


def state_of(world: World, own: Container[str]) -> dict[str, Any]:
    """What a copy or pickle of a world holds; `own` are the attributes that are no user's.

    Balls of `add_balls` that nobody has asked for have no objects, and need none.
    """
    return {
        "snapshot": write_snapshot(world),
        "members": dict(world._objects),
        "wholes": {key: shape for key, shape in world._added.items() if isinstance(shape, Assembly)},
        "departed": world._departed,
        "left": world._left,
        "link": world._link,
        "added": added_attributes(world, own),
    }


def shallow(state: dict[str, Any]) -> dict[str, Any]:
    """A state whose objects are no longer those of the world that it is of; what users hung on them is."""
    return state | {
        "members": {key: copy(member) for key, member in state["members"].items()},
        "wholes": {key: whole._like([]) for key, whole in state["wholes"].items()},
        "departed": Departed(),
        "link": Link(),
    }


def take_state(world: World, state: dict[str, Any]) -> None:
    """Make a new world the one that a state is of, with the objects in it."""
    for key, member in state["members"].items():
        member._rejoin(world, world._arrays.table_of(member), key)
    world._objects = dict(state["members"])
    world._added = dict(state["wholes"])
    read_snapshot(world, state["snapshot"])
    world._departed = state["departed"]
    world._left = state["left"]
    world._link = state["link"]
    world._link.world = world
    world._no_hits = Hits.of(world, NO_ROWS)
    add_attributes(world, state["added"])
