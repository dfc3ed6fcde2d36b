"""The runs that parameters list."""

from typing import Any

import numpy as np
import pyarrow as pa
import pytest

import carom
from carom.study.sweeps.grid import Run, runs_of


def test_a_grid_is_all_with_all_and_its_last_name_varies_fastest() -> None:
    found = runs_of({"a": [1, 2], "seed": range(2), "b": np.array([0.5, 1.5])})
    expected = [Run({"a": a, "b": b}, seed) for a in (1, 2) for seed in (0, 1) for b in (0.5, 1.5)]
    assert found == expected
    assert found[0].given == {"a": 1, "b": 0.5, "seed": 0}


def test_lists_of_dictionaries_and_tables_say_the_same() -> None:
    rows = [{"a": 1.0, "seed": 3}, {"a": 2.0, "seed": 4}]

    class Pandas:
        """What has the method of a DataFrame of pandas."""

        def to_dict(self, form: str) -> Any:
            assert form == "records"
            return rows

    class Polars:
        """What has the method of a DataFrame of polars."""

        def to_dicts(self) -> Any:
            return rows

    expected = [Run({"a": 1.0}, 3), Run({"a": 2.0}, 4)]
    for given in (rows, iter(rows), pa.Table.from_pylist(rows), Pandas(), Polars()):
        assert runs_of(given) == expected
    assert runs_of([{"a": 1}])[0].given == {"a": 1}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (3, "must be a grid, a list of dictionaries or a DataFrame, not 3"),
        ("abc", "must be a grid"),
        ([], "must list at least one run"),
        ({"a": []}, "must list at least one run"),
        ({"a": 3}, r"parameters\['a'\] must be a list of values, not 3"),
        ({"a": "abc"}, r"parameters\['a'\] must be a list of values"),
        ([3], r"parameters\[0\] must be a dictionary"),
        ([{"a": 1}, {"b": 1}], r"parameters\[1\] must have the names of the first, \['a'\]"),
        ([{"a": 1}, {"a": 1}], r"parameters\[1\] must differ from parameters\[0\]"),
        ([{"a": {}}], r"parameters\[0\]\['a'\] must be a number, a string"),
        ([{1: 2}], "must have names that are strings, not 1"),
        ({"seed": [-1]}, r"parameters\[0\]\['seed'\] must be a whole number from 0"),
        ({"seed": [0.5]}, "must be a whole number"),
        ({"seed": [True]}, "must be a whole number"),
        ({"a": range(10_000), "b": range(10_000)}, "must make at most 10,000,000 runs, not 100000000"),
    ],
)
def test_what_lists_no_runs_is_refused(given: Any, words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words):
        runs_of(given)
