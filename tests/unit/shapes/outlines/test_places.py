"""Places that a user gives."""

from math import inf
from typing import Any

import numpy as np
import pytest

from carom import InvalidArgument
from carom.shapes.outlines.places import places_of


def test_places_are_any_pairs() -> None:
    assert places_of("points", np.array([[1, 2], [3, 4]])) == [(1.0, 2.0), (3.0, 4.0)]
    assert places_of("points", iter([(0, 1)])) == [(0.0, 1.0)]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (7, "points must be a list of points"),
        ([(0, 1), 2], r"points\[1\] must be a pair"),
        ([(0, inf)], r"points\[0\]\[1\] must be finite"),
    ],
)
def test_mistakes_are_named(given: Any, message: str) -> None:
    with pytest.raises(InvalidArgument, match=message):
        places_of("points", given)
