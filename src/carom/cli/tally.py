"""Touches and hits counted by the shape that was hit, while a run goes on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.record.members import BALLS, parts, touches_by_label
from carom.rows.tables import Row
from carom.shapes.label import label_of
from carom.world.counts import Counter
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from carom.record import Recording
    from carom.world.world import World


@dataclass(slots=True)
class Tallied:
    """What happened at one shape, or at all shapes of one name."""

    label: str
    touches: int = 0
    bounces: int = 0
    entries: int = 0
    fastest: float = 0.0
    strongest: float = 0.0

    @property
    def hits(self) -> int:
        """The bounces, and the times that a ball came in."""
        return self.bounces + self.entries

    def add(self, count: Row) -> None:
        """Count what a row of `COUNT` says of one of the shapes."""
        self.touches += int(count["touches"])
        self.bounces += int(count["bounces"])
        self.entries += int(count["entries"])
        self.fastest = max(self.fastest, float(count["fastest"]))
        self.strongest = max(self.strongest, float(count["strongest"]))


class Tally:
    """The counts of a run, by label: shapes of one name, and balls among each other, count together."""

    def __init__(self, labels: Mapping[int, str]) -> None:
        self._labels = labels
        self._counter = Counter()

    @classmethod
    def of(cls, world: World) -> Tally:
        """A tally of a world's shapes."""
        return cls({shape.id or 0: label_of(shape) for shape in parts(world.shapes)})

    def add(self, hits: NDArray[Any]) -> None:
        """Count more hits, which come after those before."""
        self._counter.add(hits)

    def counts(self) -> list[Tallied]:
        """The counts, what was touched most often first."""
        found: dict[str, Tallied] = {}
        for row in self._counter.rows():
            label = self._labels.get(int(row["shape"]), BALLS)
            found.setdefault(label, Tallied(label)).add(row)
        return sorted(found.values(), key=lambda count: (-count.touches, -count.hits, count.label))


def shares_of(recording: Recording, until: float) -> list[tuple[str, int]]:
    """The touches of a recorded run until some time of it, without sensors, by what was touched, the most first."""
    bounces = recording.hits["kind"] == HitKind.BOUNCE
    return touches_by_label(recording, np.compress(bounces & (recording.hits["time"] <= until), recording.hits))
