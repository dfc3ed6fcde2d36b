"""What ends a run before its time: so many hits, a shape that is met, or whatever a function says."""

from __future__ import annotations

from collections.abc import Callable
from threading import get_ident
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np

from carom import checks
from carom.rows.hit import EXIT
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.spelling import hint

if TYPE_CHECKING:
    from carom.world.hits import Hits
    from carom.world.world import World

#: What is taken for `until`.
Until: TypeAlias = "int | str | Shape | Ball | Compound | Group | Callable[[Hits], Any] | None"

#: The same in words, told where something else was given.
UNTIL = "must be a number of hits, a shape or ball of this world or its name, a function, or None"


class Ending(Protocol):
    """A condition that is looked at after steps of a run."""

    @property
    def hits_to_wait_for(self) -> int:
        """How many hits there must be before it can come true: steps that have them are looked at; 0: all are."""

    def is_over(self, hits: Hits) -> bool:
        """Whether it has come true by the end of the steps that these are the hits of, the next ones of the run."""


class SoMany:
    """So many hits, of every kind and all balls together."""

    def __init__(self, count: int) -> None:
        self._left = count

    @property
    def hits_to_wait_for(self) -> int:
        """Those that are left."""
        return self._left

    def is_over(self, hits: Hits) -> bool:
        """Whether as many have come."""
        self._left -= len(hits)
        return self._left <= 0


class SoManyEach:
    """So many hits of each ball that is in the world by then; one of two balls counts for both."""

    hits_to_wait_for = 1

    def __init__(self, world: World, count: int) -> None:
        self._world = world
        self._count = count
        self._counts = np.zeros(1, np.int64)

    def is_over(self, hits: Hits) -> bool:
        """Whether every ball has had as many. A world without balls goes on."""
        ids = self._world._arrays.balls.used["id"]
        if len(hits) == 0 or len(ids) == 0:
            return False
        most = max(int(ids[-1]), int(hits["ball"].max()), int(hits["shape"].max()))
        if most >= len(self._counts):
            self._counts = np.concatenate([self._counts, np.zeros(most + 1, np.int64)])
        for field in ("ball", "shape"):
            np.add.at(self._counts, hits[field], 1)
        return bool((self._counts[ids] >= self._count).all())


class Met:
    """A bounce off one of some shapes or balls, or a ball's coming into it."""

    hits_to_wait_for = 1

    def __init__(self, ids: list[int]) -> None:
        self._ids = ids

    def is_over(self, hits: Hits) -> bool:
        """Whether there was one."""
        if len(hits) == 0:
            return False
        met = np.isin(hits["shape"], self._ids) | np.isin(hits["ball"], self._ids)
        return bool((met & (hits["kind"] != EXIT)).any())


class Asked:
    """A function of the user's, which is given the hits of each step and may use the world, but not step it."""

    hits_to_wait_for = 0

    def __init__(self, world: World, function: Callable[[Hits], Any]) -> None:
        self._world = world
        self._function = function

    def is_over(self, hits: Hits) -> bool:
        """Whether it says so."""
        self._world._watcher = get_ident()
        try:
            return bool(self._function(hits))
        finally:
            self._world._watcher = None


class First:
    """Whichever of two conditions comes true first."""

    def __init__(self, one: Ending, other: Ending) -> None:
        self._both = (one, other)

    @property
    def hits_to_wait_for(self) -> int:
        """The fewer of theirs."""
        return min(ending.hits_to_wait_for for ending in self._both)

    def is_over(self, hits: Hits) -> bool:
        """Whether one of them has come true; both are told of every step."""
        one, other = (ending.is_over(hits) for ending in self._both)
        return one or other


def ending_of(world: World, until: Any, until_each: Any) -> Ending | None:
    """The condition that a run's arguments name, or None; raises `InvalidArgument`."""
    one = None if until is None else _ending(world, until)
    if until_each is None:
        return one
    each = SoManyEach(world, checks.whole("until_each", until_each, 1))
    return each if one is None else First(one, each)


def _ending(world: World, until: Any) -> Ending:
    """The condition that `until` names."""
    if isinstance(until, str):
        return Met(_ids_called(world, until))
    if isinstance(until, (Shape, Ball, Compound, Group)):
        if until.world is not world:
            raise checks.refuse("until", "must be in this world", until)
        return Met(_ids_of(until))
    if callable(until):
        return Asked(world, until)
    if isinstance(until, float) or hasattr(until, "__index__"):
        return SoMany(checks.whole("until", until, 1))
    raise checks.refuse("until", UNTIL, until)


def _ids_of(member: Shape | Ball | Compound | Group) -> list[int]:
    """The ids of what a member is made of."""
    parts = member.shapes if isinstance(member, Compound | Group) else (member,)
    return [part.id for part in parts if part.id is not None]


def _ids_called(world: World, name: str) -> list[int]:
    """The ids of all that bears a name; raises where nothing does."""
    members = [*world._list(), *world._objects.values()]
    found = {key for member in members if member.name == name for key in _ids_of(member)}
    if not found:
        said = hint(name, sorted({member.name for member in members if member.name is not None}))
        raise checks.refuse("until", f"must be the name of a shape or ball here{f' ({said})' if said else ''}", name)
    return sorted(found)
