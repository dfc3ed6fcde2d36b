"""Any value can be refused: what a message shows of it is what `repr` begins with, however large or deep it is."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.checks import LONGEST_VALUE, written

leaves = st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=30), st.binary(max_size=9))
values = st.recursive(
    leaves,
    lambda below: st.one_of(
        st.lists(below, max_size=30),
        st.lists(below, max_size=30).map(tuple),
        st.dictionaries(st.text(max_size=5), below, max_size=30),
    ),
)


@pytest.mark.slow
@given(values, st.integers(1, 100))
def test_what_is_written_is_what_repr_begins_with(value: Any, longest: int) -> None:
    whole = repr(value)
    text = written(value, longest)
    assert text == whole or (len(whole) > longest and text[:longest] == whole[:longest])


class Rude:
    """A value that cannot be written."""

    def __repr__(self) -> str:
        raise RuntimeError("no")


def deep(levels: int) -> list[Any]:
    """A list in a list in a list."""
    value: list[Any] = []
    for _ in range(levels):
        value = [value]
    return value


@pytest.mark.parametrize(
    "value",
    [10**5000, -(10**5000), [10**5000], {"a": 10**5000}, deep(100_000), ["x"] * 10**6, "x" * 10**7, Rude(), [Rude()]],
    ids=lambda value: type(value).__name__,
)
def test_any_value_is_refused_by_name(value: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"^radius must ") as caught:
        carom.Ball((0, 0), value)
    assert len(str(caught.value)) < LONGEST_VALUE + 100
    with pytest.raises(carom.SceneError, match=r"^guard: must be true or false, not ") as refused:
        carom.Scene(guard=value)
    assert len(str(refused.value)) < 200


def test_arrays_are_written_as_they_write_themselves() -> None:
    array = np.arange(10.0)
    assert written(array, 1000) == repr(array)
