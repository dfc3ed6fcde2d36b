"""How long the work of frames takes, and how many are shown a second."""

from __future__ import annotations

import time as clock
from collections import deque
from statistics import median, quantiles

#: How many of the last frames the figures on the screen are about.
RECENT = 60
#: How many frames the closing sentence is about at most: half an hour of them.
MOST_FRAMES = 108_000


class FrameMeter:
    """Takes the time of frames: `begin` before the work of one, `end` after it."""

    def __init__(self, rate: float) -> None:
        self.target = 1.0 / rate
        self._begun = 0.0
        self._work: deque[float] = deque(maxlen=MOST_FRAMES)
        self._recent: deque[float] = deque(maxlen=RECENT)
        self._ends: deque[float] = deque(maxlen=RECENT + 1)

    def begin(self) -> None:
        """Note that the work of a frame begins."""
        self._begun = clock.perf_counter()

    def end(self) -> None:
        """Note that the work of the frame is done."""
        now = clock.perf_counter()
        self._work.append(now - self._begun)
        self._recent.append(now - self._begun)
        self._ends.append(now)

    @property
    def frames(self) -> int:
        """How many frames there were."""
        return len(self._work)

    @property
    def rate(self) -> float:
        """Frames a second, over the last ones; 0 before there are two."""
        if len(self._ends) < 2:
            return 0.0
        return (len(self._ends) - 1) / (self._ends[-1] - self._ends[0])

    @property
    def work(self) -> float:
        """Seconds of work a frame: the median of the last ones."""
        return median(self._recent) if self._recent else 0.0

    @property
    def share(self) -> float:
        """How much of the time that a frame has is work."""
        return self.work / self.target

    def line(self) -> str:
        """All frames in a sentence."""
        if not self._work:
            return "no frames"
        slow = quantiles(self._work, n=100)[-1] if len(self._work) > 1 else self._work[0]
        return (
            f"{len(self._work)} frames: {1e3 * median(self._work):.2f} ms of work each (median), "
            f"99 % within {1e3 * slow:.2f} ms, {self.rate:.0f} a second at the end"
        )
