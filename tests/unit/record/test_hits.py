"""The hits of a recording are rows as ever, and know what their ids are called while it is there."""

import pickle

import numpy as np

from carom.record.hits import RecordedHits
from carom.rows.hit import HIT
from tests.pages.runs import furnished_run


def test_columns_are_plain_and_slices_are_hits() -> None:
    hits = furnished_run().hits
    assert isinstance(hits, RecordedHits)
    assert type(hits["speed"]) is np.ndarray
    assert type(hits[["time", "speed"]]) is np.ndarray
    assert isinstance(hits[3:7], RecordedHits)
    assert isinstance(hits[hits["speed"] > 1.0], RecordedHits)
    assert hits[0]["time"] == hits["time"][0]
    assert repr(hits["kind"][:2]).startswith("array")


def test_ids_have_names_while_the_recording_is_there() -> None:
    run = furnished_run()
    shape = int(run.hits["shape"][0])
    assert run.hits[:5]._label(shape) == run.label_of(shape)
    assert RecordedHits.of(run, np.zeros(1, HIT))._label(shape) == run.label_of(shape)
    assert np.zeros(1, HIT).view(RecordedHits)._label(7) == "7"


def test_hits_pickled_alone_are_the_same_rows() -> None:
    hits = furnished_run().hits
    again = pickle.loads(pickle.dumps(np.asarray(hits)))
    assert again.tobytes() == hits.tobytes()
