"""Plain values: what tables and JSON can hold, the same text wherever they come from."""

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.study.sweeps.values import MOST_NUMBERS, NotPlain, name_of, plain, text_of

values = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**63), 2**63 - 1) | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4),
    max_leaves=12,
)


@settings(max_examples=40)
@given(values)
def test_the_text_of_a_plain_value_is_read_as_the_same_value(value: object) -> None:
    assert plain(value) == value
    assert repr(json.loads(text_of(plain(value)))) == repr(value)


def test_numbers_of_numpy_are_those_of_python() -> None:
    for value, clean in [
        (np.float32(0.5), 0.5),
        (np.int8(-3), -3),
        (np.bool_(True), True),
        (np.array([[1, 2], [3, 4]]), [[1, 2], [3, 4]]),
        ((1.0, (True, "a")), [1.0, [True, "a"]]),
    ]:
        assert repr(plain(value)) == repr(clean)
    assert math.isnan(plain(np.float64("nan")))


@pytest.mark.parametrize(
    "value", [object(), {"a": 1}, {1}, b"a", 1j, 2**63, [[object()]], np.zeros(MOST_NUMBERS + 1), [0] * 10_001]
)
def test_what_no_table_can_hold_is_refused(value: object) -> None:
    with pytest.raises(NotPlain):
        plain(value)


def test_names_differ_where_values_do_and_do_not_depend_on_the_order_of_names() -> None:
    assert name_of({"a": 1, "b": 2}) == name_of({"b": 2, "a": 1})
    assert len({name_of(value) for value in (0, 0.0, -0.0, False, None, "0", [0], [])}) == 8
    assert text_of({"b": 1, "a": 2}, in_order=False) == '{"b":1,"a":2}'
