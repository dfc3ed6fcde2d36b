"""The lamps of the pinball table: which there are, how they burn, and where they belong to a shape.

Lamps are called as the shapes that they belong to: "left bumper", "right bumper", "low bumper"; "left lane", "middle
lane", "right lane"; "left inlane", "right inlane", "left outlane", "right outlane"; "left orbit", "right orbit"; "left
target", "right target"; "drop target 1", "drop target 2", "drop target 3"; "saucer". Others belong to none: "2x", "3x",
"4x", "5x", "shoot again", "multiball", "jackpot", "tilt". Where the shapes are is in `Table.places`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import StrEnum

BUMPERS = ("left bumper", "right bumper", "low bumper")
LANES = ("left lane", "middle lane", "right lane")
INLANES = ("left inlane", "right inlane")
OUTLANES = ("left outlane", "right outlane")
ORBITS = ("left orbit", "right orbit")
TARGETS = ("left target", "right target")
BANK = ("drop target 1", "drop target 2", "drop target 3")
SAUCER = "saucer"
MULTIPLIERS = ("2x", "3x", "4x", "5x")
SIGNS = ("shoot again", "multiball", "jackpot", "tilt")

#: Every lamp that belongs to a shape.
PLACED = (*BUMPERS, *LANES, *INLANES, *OUTLANES, *ORBITS, *TARGETS, *BANK, SAUCER)
#: Every lamp.
NAMES = (*PLACED, *MULTIPLIERS, *SIGNS)


class LampState(StrEnum):
    """How a lamp burns."""

    OFF = "off"
    ON = "on"
    BLINK = "blink"


class Lamps(Mapping[str, LampState]):
    """The state of every lamp by name.

    >>> lamps = Lamps()
    >>> lamps.put(LampState.ON, "2x")
    >>> lamps["2x"], lamps["3x"]
    (<LampState.ON: 'on'>, <LampState.OFF: 'off'>)
    """

    def __init__(self) -> None:
        self._states = dict.fromkeys(NAMES, LampState.OFF)

    def __getitem__(self, name: str) -> LampState:
        return self._states[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._states)

    def __len__(self) -> int:
        return len(self._states)

    def put(self, state: LampState, *names: str) -> None:
        """Have lamps burn so."""
        for name in names:
            if name not in self._states:
                raise KeyError(name)
            self._states[name] = state

    def put_out(self) -> None:
        """Put all lamps out."""
        self.put(LampState.OFF, *NAMES)

    def all_on(self, names: tuple[str, ...]) -> bool:
        """Whether each of some lamps is on."""
        return all(self._states[name] is LampState.ON for name in names)
