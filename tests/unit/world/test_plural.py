"""What is true and what is false of hits and of the answers to many queries, and what NumPy makes of them."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import carom
from carom.world.plural import Plural


def kinds(base: type[Plural[Any]] = Plural) -> Iterator[type[Plural[Any]]]:
    """Every class of plurals that has rows."""
    for kind in base.__subclasses__():
        if hasattr(kind, "DTYPE"):
            yield kind
        yield from kinds(kind)


assert carom.Worlds  # what is imported when it is asked for has one too
KINDS = list(kinds())


def rows(kind: type[Plural[Any]], count: int) -> Plural[Any]:
    """A number of rows in a world where something happened."""
    return kind.of(carom.World(), np.zeros(count, kind.DTYPE))


def test_all_kinds_are_seen() -> None:
    of_hits, of_queries = (
        {"Hits", "CopyHits", "Touches", "Counts"},
        {"CastHits", "Neighbors", "Contacts", "InBoxes", "Aims"},
    )
    assert {kind.__name__ for kind in KINDS} == of_hits | of_queries


@pytest.mark.parametrize("count", [0, 1, 2, 5])
@pytest.mark.parametrize("kind", KINDS)
def test_what_is_empty_is_false_and_all_else_true(kind: type[Plural[Any]], count: int) -> None:
    plural = rows(kind, count)
    assert bool(plural) is (count > 0)
    assert bool(plural[:1]) is (count > 0)
    assert bool(plural[np.zeros(count, np.bool_)]) is False


#: What may be made of rows whose truth is NumPy's to tell.
DERIVED: dict[str, Callable[[Any], Any]] = {
    "a column": lambda rows: rows["shape"],
    "a comparison of a column": lambda rows: rows["shape"] > 3,
    "columns": lambda rows: rows[[rows.dtype.names[0]]],
    "equality": lambda rows: rows == rows,
    "equality with an array": lambda rows: np.zeros(len(rows), rows.dtype) == rows,
    "inequality": lambda rows: rows != rows,
    "numbers": lambda rows: rows.view(np.uint8),
    "a sum": lambda rows: rows["shape"].sum(),
    "all": lambda rows: (rows == rows).all(),
}


def truth(value: Any) -> bool | None:
    """Whether a value is true; None where NumPy will not say."""
    try:
        return bool(value)
    except ValueError:
        return None


@pytest.mark.parametrize("count", [0, 1, 2, 5])
@pytest.mark.parametrize("make", DERIVED.values(), ids=DERIVED)
@pytest.mark.parametrize("kind", KINDS)
def test_what_numpy_makes_of_rows_is_as_true_as_ever(
    kind: type[Plural[Any]], make: Callable[[Any], Any], count: int
) -> None:
    made, plain = make(rows(kind, count)), make(np.zeros(count, kind.DTYPE))
    assert truth(made) == truth(plain)
    assert np.array_equal(made, plain)
    if np.ndim(plain) == 1:
        assert [item.tolist() for item in made] == [item.tolist() for item in plain]


def test_questions_may_be_asked_in_an_if() -> None:
    world = carom.World()
    ball = world.add(carom.Ball((0, 0.5), 1))
    boxes = np.array([(-1, -1, 1, 1), (5, 5, 6, 6)])
    assert not world.contacts()
    assert not world.overlapping(boxes[1:])
    assert world.overlapping(boxes)
    assert not world.step(0.1)
    world.add(carom.Segment((-5, 0), (5, 0)))
    assert world.contacts()
    assert world.contacts()[0].ball is ball
    ball.velocity = (0, -1)
    assert world.step(0.1)
    assert world.nearest([(0, 0)])
    assert not world.nearest(np.zeros((0, 2)))
