"""Marks tell which names were hit since an episode began."""

import numpy as np

from carom.rl.marks import Marks
from carom.rl.names import Names
from tests.rl_tasks import yard


def test_hits_are_marked_by_name_in_their_copies_until_these_begin_anew() -> None:
    names = Names(yard().build())
    marks = Marks("wall|brick.*", names, 3)
    assert marks.hit.tolist() == [[False] * 3] * 3
    walls = [place for place, name in enumerate(names.columns) if name == "wall"]
    brick, bumper = names.columns.index("brick 2"), names.columns.index("bumper 1")
    marks.note(np.array([0, 0, 2, 2, 1]), np.array([walls[0], walls[2], brick, bumper, len(names.columns)]))
    assert marks.hit.tolist() == [[True, False, False], [False, False, False], [False, False, True]]
    marks.clear(np.array([0]))
    assert marks.hit.tolist() == [[False, False, False], [False, False, False], [False, False, True]]


def test_of_nothing_there_is_nothing() -> None:
    marks = Marks(None, Names(yard().build()), 2)
    marks.note(np.array([1]), np.array([0]))
    assert marks.hit.shape == (2, 0)
