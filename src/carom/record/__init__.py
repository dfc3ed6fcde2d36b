"""What a run was: recorded frame by frame, saved, loaded, asked at any time."""

from carom.record.recorder import Recorder
from carom.record.recording import Recording

__all__ = ["Recorder", "Recording"]
