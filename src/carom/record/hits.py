"""The hits of a recording: plain rows, which notebooks show as a table with names."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from weakref import ref

from carom.rows.hit import HIT
from carom.rows.tables import Rows
from carom.world.plural import MemberRows

if TYPE_CHECKING:
    from carom.record.recording import Recording


class RecordedHits(MemberRows):
    """A structured array of hits. Slices and masks of it are hits of the same recording."""

    DTYPE = HIT

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

    def _label(self, member_id: int) -> str:
        recording = None if self._recording is None else self._recording()
        return f"{member_id}" if recording is None else recording.label_of(member_id)
