"""The objects of what has left a world, for hits that name it still."""

from __future__ import annotations

from typing import Any
from weakref import WeakValueDictionary

from carom.rows.tables import Rows
from carom.shapes.ball import Ball
from carom.shapes.shape import Shape


class Departed:
    """Shapes and balls that left a world, by their ids.

    They are kept for as long as hits may name them: those that are at hand when they leave, and those of the next step
    or run. After that they are found only where someone else holds them too.
    """

    def __init__(self) -> None:
        self._known: WeakValueDictionary[int, Shape | Ball] = WeakValueDictionary()
        self._before: dict[int, Shape | Ball] = {}
        self._now: dict[int, Shape | Ball] = {}

    def __getstate__(self) -> Any:
        """Those that are known, and which of them are kept."""
        known = {ref.key: ref() for ref in self._known.valuerefs()}
        return (
            {key: member for key, member in known.items() if member is not None},
            list(self._before.values()),
            list(self._now.values()),
        )

    def __setstate__(self, state: Any) -> None:
        """Make this the copy of what gave that state."""
        known, before, now = state
        self._known = WeakValueDictionary(known)
        self._before = {id(member): member for member in before}
        self._now = {id(member): member for member in now}

    def add(self, member_id: int, member: Shape | Ball) -> None:
        """Keep an object that has left."""
        self._known[member_id] = member
        self._now[id(member)] = member

    def has_just_left(self, member: object) -> bool:
        """Whether hits that are at hand may name what has left: it left since the last step or run, or the one before.

        What they name of balls that no one had asked for until then counts too.
        """
        return id(member) in self._now or id(member) in self._before

    def forget_oldest(self) -> None:
        """Forget what the hits before the last step or run named: a new one begins."""
        if self._now or self._before:
            self._before, self._now = self._now, {}

    def find(self, member_id: int, rows: Rows | None = None) -> Shape | Ball | None:
        """What left with an id: its object, or one that is made of its row among `rows`; None if it is not known."""
        member = self._known.get(member_id)
        if member is None and rows is not None and member_id in rows["id"]:
            ball = Ball.__new__(Ball)
            ball.__setstate__((rows[rows["id"] == member_id], None, None))
            ball._leave()
            self.add(member_id, ball)
            member = ball
        return member

    def keep_balls(self, rows: Rows) -> None:
        """Keep objects of all balls that left in rows."""
        for ball in rows["id"]:
            member = self.find(int(ball), rows)
            if member is not None:
                self._now[id(member)] = member
