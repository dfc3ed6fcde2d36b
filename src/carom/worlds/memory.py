"""The memory of all copies: for each, one after the other, what it has of its own, in whole words of 64 bits."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.rows.ball import BALL
from carom.rows.copies import LAYOUT, LayoutRow
from carom.rows.flight import FLIGHT, QUEUE
from carom.rows.relation import RELATION
from carom.rows.saved import SAVED
from carom.rows.shape import SHAPE
from carom.rows.state import STATE
from carom.rows.tables import Rows

WORD = 8

#: Relations that there is room for in each copy at first, and at least.
RELATIONS = 4


class Memory:
    """What all copies have of their own. Its tables are views, writable, whose first axis is that of the copies.

    Attributes:
        words: All of it, of shape (copies, words).
        layout: Where the parts of a copy are, a table of one row.
    """

    def __init__(self, copies: int, balls: int, flying: bool, moving: int, switched: int, relations: int) -> None:
        """Memory for so many copies, each of so many balls, which fly in the continuous mode.

        `moving` is the number of kinematic shapes, `switched` that of static ones with switches of their own, and
        `relations` how many there is room for.
        """
        self._sizes = balls, flying, moving
        self.layout: Rows = np.zeros(1, LAYOUT)
        layout: LayoutRow = self.layout[0]
        kinds = {
            "state": STATE, "ball": BALL, "saved": SAVED, "flight": FLIGHT, "queue": QUEUE, "shape": SHAPE,
            "relation": RELATION,
        }  # fmt: skip
        for name, dtype in kinds.items():
            layout[f"{name}_words"] = dtype.itemsize // WORD  # type: ignore[literal-required]
        layout["balls"], layout["relations_room"] = balls, relations
        layout["high_word"] = STATE.fields["relations_high"][1] // WORD  # type: ignore[index]
        self.moving_count, self.switched_count = moving, switched
        end = layout["state_words"]
        parts = {
            "balls_at": balls * layout["ball_words"],
            "saved_at": balls * layout["saved_words"],
            "flights_at": balls * layout["flight_words"] if flying else 0,
            "queue_at": balls * layout["queue_words"] if flying else 0,
            "moving_at": moving * layout["shape_words"],
            "relations_at": relations * layout["relation_words"],
        }
        for name, words in parts.items():
            layout[name] = end if words or name != "flights_at" else 0  # type: ignore[literal-required]
            end += words
        layout["switches_at"] = WORD * end
        layout["in_play_at"] = WORD * end + 2 * switched
        end += -(-(2 * switched + balls) // WORD)
        layout["words"] = end
        self.words: NDArray[np.int64] = np.zeros((copies, int(end)), np.int64)

    def _part(self, begin: int, count: int, dtype: Any) -> Rows:
        """A part of all copies, that begins at a byte and holds so many items of a dtype."""
        size = np.dtype(dtype).itemsize
        part: Rows = self.words.view(np.uint8)[:, begin : begin + count * size].view(dtype)
        return part

    @cached_property
    def state(self) -> Rows:
        """The states, of shape (copies,)."""
        return self._part(0, 1, STATE)[:, 0]

    @cached_property
    def balls(self) -> Rows:
        """The rows of the balls, of shape (copies, balls)."""
        return self._part(WORD * int(self.layout[0]["balls_at"]), int(self.layout[0]["balls"]), BALL)

    @cached_property
    def saved(self) -> Rows:
        """The rows that go with the balls, of shape (copies, balls)."""
        return self._part(WORD * int(self.layout[0]["saved_at"]), int(self.layout[0]["balls"]), SAVED)

    @cached_property
    def flights(self) -> Rows:
        """The flights of the balls, of shape (copies, balls); in the discrete mode there are none."""
        count = int(self.layout[0]["balls"]) if self.layout[0]["flights_at"] else 0
        return self._part(WORD * int(self.layout[0]["flights_at"]), count, FLIGHT)

    @cached_property
    def moving(self) -> Rows:
        """The rows of the kinematic shapes, of shape (copies, shapes)."""
        return self._part(WORD * int(self.layout[0]["moving_at"]), self.moving_count, SHAPE)

    @cached_property
    def switches(self) -> NDArray[np.uint8]:
        """The switches of static shapes that have their own in each copy, of shape (copies, shapes, 2)."""
        part = self._part(int(self.layout[0]["switches_at"]), 2 * self.switched_count, np.uint8)
        return part.reshape(len(part), self.switched_count, 2)

    @cached_property
    def in_play(self) -> NDArray[np.bool_]:
        """Whether each ball is in play, of shape (copies, balls)."""
        return self._part(int(self.layout[0]["in_play_at"]), int(self.layout[0]["balls"]), np.bool_)

    def resized(self, switched: int, relations: int) -> Memory:
        """The same copies in memory that has more room for relations, or for switches, which are not filled in."""
        other = Memory(len(self.words), *self._sizes, switched, relations)
        for name in ("state", "balls", "saved", "flights", "moving", "in_play"):
            getattr(other, name)[...] = getattr(self, name)
        begin, end = int(self.layout[0]["queue_at"]), int(self.layout[0]["moving_at"])
        to = int(other.layout[0]["queue_at"])
        other.words[:, to : to + end - begin] = self.words[:, begin:end]
        begin, to = int(self.layout[0]["relations_at"]), int(other.layout[0]["relations_at"])
        count = min(relations, int(self.layout[0]["relations_room"])) * int(self.layout[0]["relation_words"])
        other.words[:, to : to + count] = self.words[:, begin : begin + count]
        shared = min(switched, self.switched_count)
        other.switches[:, :shared] = self.switches[:, :shared]
        return other
