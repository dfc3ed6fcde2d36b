"""Hits counted by the shape that was hit, while a run goes on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.record.members import BALLS, hits_by_label, label_of, parts
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from carom.record import Recording
    from carom.world.world import World


@dataclass(slots=True)
class Count:
    """What happened at one shape, or at all shapes of one name."""

    label: str
    bounces: int = 0
    entries: int = 0
    fastest: float = 0.0
    strongest: float = 0.0

    def add(self, hits: NDArray[Any]) -> None:
        """Count some hits, all of them with this shape."""
        bounces = hits[hits["kind"] == HitKind.BOUNCE]
        self.bounces += len(bounces)
        self.entries += int(np.count_nonzero(hits["kind"] == HitKind.ENTER))
        if len(bounces) > 0:
            self.fastest = max(self.fastest, float(bounces["speed"].max()))
            self.strongest = max(self.strongest, float(bounces["impulse"].max()))


class Tally:
    """The counts of a run, by label: shapes of one name, and balls among each other, count together."""

    def __init__(self, labels: Mapping[int, str]) -> None:
        self._labels = labels
        self._counts: dict[str, Count] = {}

    @classmethod
    def of(cls, world: World) -> Tally:
        """A tally of a world's shapes."""
        return cls({shape.id or 0: label_of(shape) for shape in parts(world.shapes)})

    def add(self, hits: NDArray[Any]) -> None:
        """Count more hits."""
        if len(hits) == 0:
            return
        hits = hits[np.argsort(hits["shape"], kind="stable")]
        shapes, starts = np.unique(hits["shape"], return_index=True)
        for shape, part in zip(shapes.tolist(), np.split(hits, starts[1:]), strict=True):
            label = self._labels.get(shape, BALLS)
            self._counts.setdefault(label, Count(label)).add(part)

    def counts(self) -> list[Count]:
        """The counts, the most frequent first."""
        return sorted(self._counts.values(), key=lambda count: (-count.bounces - count.entries, count.label))


def shares_of(recording: Recording, until: float) -> list[tuple[str, int]]:
    """The bounces of a recorded run, until some time of it, by what was hit, the most frequent first."""
    bounces = recording.hits["kind"] == HitKind.BOUNCE
    return hits_by_label(recording, np.compress(bounces & (recording.hits["time"] <= until), recording.hits))
