"""Where every ball of a game is or went: the ledger that must always balance."""

from __future__ import annotations

from dataclasses import dataclass

import carom


@dataclass(slots=True)
class Ledger:
    """Counts of the balls of a game.

    Attributes:
        created: Balls that were put into the world.
        in_play: Those on the field.
        held: Those in the plunger lane.
        drained: Those that left through the drain, or were put away when a game was broken off.
        stray: Those that were found where no ball can be, and taken.
        freed: How often a ball that rested was nudged free; no ball is made or lost by that.
    """

    created: int = 0
    in_play: int = 0
    held: int = 0
    drained: int = 0
    stray: int = 0
    freed: int = 0

    def serve(self) -> None:
        """Book a new ball in the plunger lane."""
        self.created += 1
        self.held += 1

    def enter(self) -> None:
        """Book a ball that came from the plunger lane onto the field."""
        self.held -= 1
        self.in_play += 1

    def take(self, held: bool, stray: bool = False) -> None:
        """Book a ball out, from the plunger lane or the field, as drained or as a stray."""
        if held:
            self.held -= 1
        else:
            self.in_play -= 1
        if stray:
            self.stray += 1
        else:
            self.drained += 1

    @property
    def balances(self) -> bool:
        """Whether every ball that was created is in exactly one place."""
        places = (self.in_play, self.held, self.drained, self.stray)
        return min(places) >= 0 and self.created == sum(places)

    def check(self, world: carom.World) -> bool:
        """Whether the ledger balances and `world` holds the balls that it says."""
        return self.balances and self.in_play + self.held == len(world.balls)
