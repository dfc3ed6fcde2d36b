"""Counters of what a world has done."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias, get_args

from carom.turns import having

if TYPE_CHECKING:
    from carom.world.world import World

Counter: TypeAlias = Literal[
    "box_tests", "full_tests", "collisions", "strays", "overlaps", "sleeping", "held", "squeezed", "slowed"
]
COUNTERS: tuple[Counter, ...] = get_args(Counter)


class Statistics:
    """A live view of a world's counters; they count from the world's beginning or the last `reset`."""

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def _count(self, name: Counter) -> int:
        return int(self._world._states[0][name])

    @property
    def box_tests(self) -> int:
        """Pairs whose boxes were compared; of many kinematic shapes in the discrete mode, those whose boxes met."""
        return self._count("box_tests")

    @property
    def full_tests(self) -> int:
        """Pairs whose shapes were compared."""
        return self._count("full_tests")

    @property
    def collisions(self) -> int:
        """Bounces."""
        return self._count("collisions")

    @property
    def strays(self) -> int:
        """Balls that left the bounds."""
        return self._count("strays")

    @property
    def overlaps(self) -> int:
        """Times that two balls were found with their centres at the same place."""
        return self._count("overlaps")

    @property
    def sleeping(self) -> int:
        """Balls that sleep now."""
        return self._count("sleeping")

    @property
    def stalled(self) -> int:
        """Always 0: no ball is stopped any more. It goes with the next version but one."""
        return 0

    @property
    def held(self) -> int:
        """Impacts that took all of the approach, since many before them had come too soon to be told apart."""
        return self._count("held")

    @property
    def squeezed(self) -> int:
        """Balls that had no room to be pushed to; a shape went over them. Each counts once (discrete: a substep)."""
        return self._count("squeezed")

    @property
    def slowed(self) -> int:
        """Times that a ball was slowed to `max_speed`."""
        return self._count("slowed")

    def as_dict(self) -> dict[str, int]:
        """All counters by name."""
        return {name: self._count(name) for name in COUNTERS}

    def reset(self) -> None:
        """Set all counters but `sleeping` to 0."""
        having(self._world, self._reset)

    def _reset(self) -> None:
        """Set the counters to 0, with the world to itself."""
        for name in COUNTERS:
            if name != "sleeping":
                self._world._states[0][name] = 0

    def __repr__(self) -> str:
        return "Statistics(" + ", ".join(f"{name}={count}" for name, count in self.as_dict().items()) + ")"
