"""The cases of this folder, and what a tolerance relative to a case's largest number means."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

DATA = Path(__file__).parent / "data"


def load(name: str) -> list[dict[str, Any]]:
    """The cases of one file."""
    cases: list[dict[str, Any]] = json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))
    return cases


def numbers_in(part: Any) -> Iterator[float]:
    """Every number of a case, or of a part of it."""
    if isinstance(part, dict):
        for value in part.values():
            yield from numbers_in(value)
    elif isinstance(part, list):
        for value in part:
            yield from numbers_in(value)
    elif isinstance(part, int | float) and not isinstance(part, bool):
        yield float(part)


def flat(part: Any) -> tuple[float, ...]:
    """The numbers of nested lists in order."""
    return tuple(numbers_in(part))


def largest(case: dict[str, Any]) -> float:
    """The largest magnitude in a case, which its tolerance is relative to."""
    return max(map(abs, numbers_in(case)))
