"""Which runs go out next, and together: chunks of about a second of work, halved where their worker died.

A death says only that one of a chunk's runs may have killed its worker. Halves of the chunk go out again; a single run
that died goes out once more when nothing else does, so that its deaths are nobody else's.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable
from dataclasses import dataclass
from math import ceil

#: Seconds of work in a chunk.
CHUNK_SECONDS = 1.0
#: Runs of a chunk at most.
MOST_IN_CHUNK = 10_000
#: How often a run may kill its worker.
MOST_DEATHS = 3


@dataclass(frozen=True, slots=True)
class Chunk:
    """Runs that go out together, by their places, and how often one of them has gone out, this time counted."""

    places: tuple[int, ...]
    attempt: int
    alone: bool = False


class Chunks:
    """The runs that are still to be done."""

    def __init__(self, places: Iterable[int], seconds: float = CHUNK_SECONDS) -> None:
        self._fresh = deque(places)
        self._halves: deque[tuple[int, ...]] = deque()
        self._suspects: deque[int] = deque()
        self._deaths: Counter[int] = Counter()
        self._attempts: Counter[int] = Counter()
        self._target = seconds
        self._work, self._count = 0.0, 0

    def __bool__(self) -> bool:
        return bool(self._fresh or self._halves or self._suspects)

    def next(self, in_flight: int) -> Chunk | None:
        """The chunk to send now, where `in_flight` others are out; None where none may go."""
        if self._halves:
            return self._sent(self._halves.popleft())
        if self._fresh:
            count = min(self._size(), len(self._fresh))
            return self._sent(tuple(self._fresh.popleft() for _ in range(count)))
        if self._suspects and in_flight == 0:
            return self._sent((self._suspects.popleft(),), alone=True)
        return None

    def done(self, count: int, seconds: float) -> None:
        """Note that `count` runs have taken `seconds` of work."""
        self._work += seconds
        self._count += count

    def died(self, chunk: Chunk, workers: int = 1) -> list[int]:
        """Take back a chunk on which some `workers` have died; the places of runs that are given up."""
        if len(chunk.places) > 1:
            middle = len(chunk.places) // 2
            self._halves += (chunk.places[:middle], chunk.places[middle:])
            return []
        (place,) = chunk.places
        if chunk.alone:
            self._deaths[place] += workers
        if self._deaths[place] >= MOST_DEATHS:
            return [place]
        self._suspects.append(place)
        return []

    def _size(self) -> int:
        """How many runs make a chunk, by the work that those done have taken."""
        if self._count == 0:
            return 1
        each = self._work / self._count
        return MOST_IN_CHUNK if each * MOST_IN_CHUNK < self._target else max(1, ceil(self._target / each))

    def _sent(self, places: tuple[int, ...], alone: bool = False) -> Chunk:
        """A chunk of some runs, which go out once more."""
        self._attempts.update(places)
        return Chunk(places, max(self._attempts[place] for place in places), alone)
