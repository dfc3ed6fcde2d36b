"""The hits of a recording: plain rows, which notebooks show as a table with names."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from weakref import ref

import numpy as np

from carom.pictured import Tabled
from carom.rows.hit import HIT
from carom.rows.tables import Rows

if TYPE_CHECKING:
    from carom.record.recording import Recording


class RecordedHits(np.ndarray[Any, np.dtype[Any]], Tabled):
    """A structured array of hits. Columns of it are plain arrays, slices and masks hits of the same recording."""

    _recording: ref[Recording] | None = None

    @classmethod
    def of(cls, recording: Recording, rows: Rows) -> RecordedHits:
        """The rows as hits of a recording, which is not kept for them."""
        hits = rows.view(cls)
        hits._recording = ref(recording)
        return hits

    def __array_finalize__(self, source: Any) -> None:
        if source is not None:
            self._recording = getattr(source, "_recording", None)

    def __getitem__(self, key: Any) -> Any:
        item = super().__getitem__(key)
        return np.asarray(item) if isinstance(item, RecordedHits) and item.dtype != HIT else item

    def label_of(self, member_id: int) -> str:
        """What to call the shape or ball with an id; the id, where the recording is no more."""
        recording = None if self._recording is None else self._recording()
        return f"{member_id}" if recording is None else recording.label_of(member_id)
