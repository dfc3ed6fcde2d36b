"""The types of a descriptor's fields: what is taken in which form, and what is said of what is not."""

from typing import Any

import numpy as np
import pytest
from pydantic import ConfigDict, TypeAdapter, ValidationError

import carom
from carom.scene.fields import Sides, Text, Vector, as_tuple


def read(kind: Any, value: Any) -> Any:
    """The value as a field of that type holds it."""
    return TypeAdapter(kind, config=ConfigDict(strict=True)).validate_python(value)


def words(kind: Any, value: Any) -> str:
    """What is said of a value that a field of that type refuses."""
    with pytest.raises(ValidationError) as caught:
        read(kind, value)
    (fault,) = caught.value.errors()
    return fault["msg"]


@pytest.mark.parametrize("given", [(1, 2.5), [1.0, 2.5], np.array([1.0, 2.5]).tolist(), iter((1.0, 2.5))])
def test_a_pair_may_be_anything_of_two_numbers(given: Any) -> None:
    assert repr(read(Vector, given)) == "(1.0, 2.5)"


@pytest.mark.parametrize("given", ["12", b"12", {1: 2, 3: 4}, {1, 2}, frozenset({1, 2}), [1], [1, 2, 3], 5, None])
def test_what_is_no_pair_is_refused_with_the_value(given: Any) -> None:
    assert words(Vector, given) == f"must be a pair of numbers, not {given!r}"


def test_sides_may_be_a_box_or_four_numbers() -> None:
    assert read(Sides, carom.Aabb(-1, -2, 3, 4)) == read(Sides, [-1, -2, 3, 4]) == (-1.0, -2.0, 3.0, 4.0)
    assert read(Sides, (1, 2, 1, 2)) == (1.0, 2.0, 1.0, 2.0)
    assert words(Sides, [1, 2, 3]) == "must be four numbers (left, bottom, right, top), not [1, 2, 3]"


@pytest.mark.parametrize("sides", [(1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 1.0, 0.0)])
def test_sides_in_the_wrong_order_are_refused(sides: tuple[float, ...]) -> None:
    assert words(Sides, sides) == f"must have left <= right and bottom <= top, not {sides}"


def test_text_is_what_utf_8_can_hold() -> None:
    assert read(Text, "ä \N{BALLOON}") == "ä \N{BALLOON}"
    assert words(Text, "a\ud800") == r"must be text that UTF-8 can hold, not 'a\ud800'"


def test_only_a_list_becomes_a_tuple() -> None:
    assert as_tuple([1, 2]) == (1, 2)
    for other in ((1, 2), "12", None, {1: 2}):
        assert as_tuple(other) is other


@pytest.mark.parametrize("value", [True, 1.0])
def test_what_only_equals_a_version_is_none(value: object) -> None:
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(version=value)
    assert str(caught.value) == f"version: must be the whole number 1, not {value}"
    with pytest.raises(carom.SceneError, match="version: must be 1, not '1'"):
        carom.Scene(version="1")
    assert carom.Scene(version=1) == carom.Scene()
