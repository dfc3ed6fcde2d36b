"""The runs of a sweep: what `parameters` lists, each with its seed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

from carom.checks import refuse
from carom.study.sweeps.values import MOST_WHOLE, NotPlain, plain, text_of

#: The parameter that seeds random numbers.
SEED = "seed"
#: Runs of one sweep at most; more do not fit the memory of the process that counts them.
MOST_RUNS = 10_000_000


@dataclass(frozen=True, slots=True)
class Run:
    """One run: its parameters as plain values, without the seed, and its seed."""

    parameters: dict[str, Any]
    seed: int | None

    @property
    def given(self) -> dict[str, Any]:
        """What scene functions and measures are given: the parameters, with the seed if there is one."""
        return self.parameters if self.seed is None else {**self.parameters, SEED: self.seed}


def runs_of(parameters: Any) -> list[Run]:
    """The runs that `parameters` lists, in its order: of a grid the last name varies fastest.

    Raises:
        InvalidArgument: It is no grid, list of dictionaries or DataFrame, or lists no run, or one twice.
    """
    rows = list(_grid(parameters)) if isinstance(parameters, Mapping) else _rows(parameters)
    if not rows:
        raise refuse("parameters", "must list at least one run", parameters)
    runs = [_run(f"parameters[{place}]", row) for place, row in enumerate(rows)]
    names = set(runs[0].given)
    seen: dict[str, int] = {}
    for place, run in enumerate(runs):
        if set(run.given) != names:
            raise refuse(
                f"parameters[{place}]", f"must have the names of the first, {sorted(names)}", sorted(run.given)
            )
        first = seen.setdefault(text_of(run.given), place)
        if first != place:
            raise refuse(f"parameters[{place}]", f"must differ from parameters[{first}]", run.given)
    return runs


def _grid(grid: Mapping[Any, Any]) -> Iterable[dict[Any, Any]]:
    """The rows of a grid, whose values are lists of values."""
    lists: list[list[Any]] = []
    count = 1
    for name, values in grid.items():
        if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
            raise refuse(f"parameters[{name!r}]", "must be a list of values", values)
        lists.append(list(values))
        count *= len(lists[-1])
    if count > MOST_RUNS:
        raise refuse("parameters", f"must make at most {MOST_RUNS:,} runs", count)
    return (dict(zip(grid, values, strict=True)) for values in product(*lists))


def _rows(table: Any) -> list[Any]:
    """The rows of a list of dictionaries, or of a DataFrame of pandas or polars or a table of pyarrow."""
    for method, arguments in (("to_pylist", ()), ("to_dicts", ()), ("to_dict", ("records",))):
        if hasattr(table, method):
            return list(getattr(table, method)(*arguments))
    if isinstance(table, (str, bytes)) or not isinstance(table, Iterable):
        raise refuse("parameters", "must be a grid, a list of dictionaries or a DataFrame", table)
    return list(table)


def _run(where: str, row: Any) -> Run:
    """A run, of its row."""
    if not isinstance(row, Mapping):
        raise refuse(where, "must be a dictionary", row)
    clean: dict[str, Any] = {}
    for name, value in row.items():
        if not isinstance(name, str) or not name:
            raise refuse(where, "must have names that are strings", name)
        try:
            clean[name] = plain(value)
        except NotPlain as must:
            raise refuse(f"{where}[{name!r}]", f"must be {must}", value) from None
    seed = clean.pop(SEED, None)
    if seed is not None and (type(seed) is not int or not 0 <= seed <= MOST_WHOLE):
        raise refuse(f"{where}['{SEED}']", f"must be a whole number from 0 to {MOST_WHOLE}", seed)
    return Run(clean, seed)
