"""Which of some shapes were hit since an episode began: lights, and what has to be cleared."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from carom.rl.names import Names


class Marks:
    """Whether each name that a regular expression means was hit, in each copy: `hit`, of shape (copies, names)."""

    def __init__(self, pattern: str | None, names: Names, copies: int) -> None:
        meant = names.columns_like(pattern)[:-1]
        bearing = [name for name, one in zip(names.columns, meant, strict=True) if one]
        places = {name: place for place, name in enumerate(dict.fromkeys(bearing))}
        self._none = len(places)
        # The last column, of what is no shape, has no mark.
        self._place = np.full(len(meant) + 1, self._none)
        self._place[:-1][meant] = [places[name] for name in bearing]
        self._hit = np.zeros((copies, len(places) + 1), bool)
        self.hit = self._hit[:, :-1]

    def note(self, copies: NDArray[np.int64], columns: NDArray[np.int64]) -> None:
        """Mark what was hit, given the copy and the column of each hit."""
        if self._none > 0:
            self._hit[copies, self._place[columns]] = True

    def clear(self, copies: NDArray[np.int64]) -> None:
        """Forget what was hit in some copies."""
        self._hit[copies] = False
