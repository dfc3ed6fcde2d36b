"""What cannot be a recording is refused, by the name of the part that does not fit."""

from collections.abc import Callable
from dataclasses import replace
from math import inf, nan
from typing import Any

import numpy as np
import pytest

import carom


def spoiled(values: Any, place: Any, value: Any) -> Any:
    """A copy of an array with another value somewhere."""
    copy = np.array(values)
    copy[place] = value
    return copy


BAD: list[tuple[str, Callable[[Any], Any], str]] = [
    ("scene", lambda old: None, "scene must be a Scene"),
    ("times", lambda old: old[:0], "must have shape"),
    ("times", lambda old: spoiled(old, 3, nan), "times must be finite"),
    ("times", lambda old: old[::-1], "times must not descend"),
    ("times", lambda old: old[None], "times must have 1 axes, not 2"),
    ("ids", lambda old: old[::-1], "ids must ascend"),
    ("ids", lambda old: old - 1000, "ids must ascend from 0 or more"),
    ("ids", lambda old: old + 0.5, "ids must be of type i8"),
    ("radii", lambda old: spoiled(old, 0, nan), "radii must be positive and finite"),
    ("masses", lambda old: spoiled(old, 0, 0.0), "masses must be positive and finite"),
    ("positions", lambda old: spoiled(old, (0, 0, 0), inf), "positions must be finite"),
    ("positions", lambda old: spoiled(old, (0, 0, 0), nan), "positions must be finite for balls that are there"),
    ("positions", lambda old: old[:, :-1], "positions must have shape"),
    ("velocities", lambda old: spoiled(old, (0, 0, 0), nan), "velocities must be finite"),
    ("asleep", lambda old: old.astype(float), "asleep must be of type"),
    ("shape_ids", lambda old: spoiled(old, 0, old[1]), "shape_ids must differ"),
    ("colliding", lambda old: old[:, :-1], "colliding must have shape"),
    ("moving", lambda old: spoiled(old, 0, 10**6), "moving must be among shape_ids"),
    ("moving", lambda old: spoiled(old, 0, old[1]), "moving must differ"),
    ("poses", lambda old: spoiled(old, (0, 0, 0), nan), "poses must be finite"),
    ("hits", lambda old: np.zeros(3), "hits must be rows"),
    ("hits", lambda old: old[::-1], "hits['time'] must not descend"),
    ("names", lambda old: 5, "names must be a mapping"),
    ("about", lambda old: 5, "about must be a string"),
]


@pytest.mark.parametrize(("field", "change", "told"), BAD)
def test_parts_that_do_not_fit_are_refused_by_name(
    recording: carom.Recording, field: str, change: Callable[[Any], Any], told: str
) -> None:
    with pytest.raises(carom.RecordingError) as caught:
        replace(recording, **{field: change(getattr(recording, field))})
    assert told in str(caught.value)


def test_a_recording_needs_a_frame(recording: carom.Recording) -> None:
    none = {
        name: getattr(recording, name)[:0]
        for name in ("times", "positions", "velocities", "asleep", "colliding", "poses")
    }
    with pytest.raises(carom.RecordingError, match="times must have at least one frame"):
        replace(recording, **none)


@pytest.mark.parametrize(
    ("field", "value", "told"),
    [
        ("speed", nan, "hits['speed'] must be finite"),
        ("velocity", inf, "hits['velocity'] must be finite"),
        ("position", nan, "hits['position'] must be finite"),
        ("kind", 7, "must be a HitKind"),
    ],
)
def test_hits_that_cannot_be_are_refused(recording: carom.Recording, field: str, value: float, told: str) -> None:
    hits = recording.hits.copy()
    hits[field][0] = value
    with pytest.raises(carom.RecordingError) as caught:
        replace(recording, hits=hits)
    assert told in str(caught.value)
