"""Functions of geometry with a number for each field of the tuples that they take, as worked examples are best read."""

from collections.abc import Callable, Iterator
from functools import cache, partial
from inspect import getmembers, isfunction, signature
from types import ModuleType, SimpleNamespace
from typing import Any, get_type_hints

Function = Callable[..., Any]


def flat(module: ModuleType) -> SimpleNamespace:
    """A module's functions, to be called with numbers alone: a shape's, then a ball's, its radius after its place."""
    return SimpleNamespace(**{name: partial(call, function) for name, function in getmembers(module, isfunction)})


def call(function: Function, *numbers: Any) -> Any:
    """What a function returns for the numbers of its arguments, in their order but for the radius after a path."""
    names, given = list(fields(function)), list(numbers)
    assert len(names) == len(given)
    if "path.x" in names and "radius" in names:
        given.insert(names.index("radius"), given.pop(names.index("path.y") + 1))
    return function(*arguments(function, iter(given)))


def arguments(function: Function, numbers: Iterator[Any]) -> list[Any]:
    """The arguments of a function, made of numbers."""
    return [made(kind, numbers) for kind in kinds(function).values()]


@cache
def kinds(function: Function) -> dict[str, Any]:
    """The types of a function's arguments, by their names."""
    hints = get_type_hints(function)
    return {name: hints[name] for name in signature(function).parameters}


def made(kind: Any, numbers: Iterator[Any]) -> Any:
    """A number, or a tuple of as many as its fields and their fields take."""
    if not hasattr(kind, "_fields"):
        return next(numbers)
    return kind(*[made(hint, numbers) for hint in kinds(kind).values()])


@cache
def fields(function: Function) -> dict[str, type]:
    """The types of the numbers that a function takes, by their names: `radius`, or `path.x` for a field."""
    found = {}
    for name, kind in kinds(function).items():
        inner = fields(kind) if hasattr(kind, "_fields") else {}
        found |= {f"{name}.{field}": number for field, number in inner.items()} or {name: kind}
    return found
