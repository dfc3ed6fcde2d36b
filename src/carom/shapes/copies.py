"""What copies and pickles keep of a user's own subclasses."""

from __future__ import annotations

from collections.abc import Container
from typing import Any


def added_attributes(thing: object, own: Container[str]) -> dict[str, Any]:
    """The attributes that a subclass of the user's has added to `thing`, in slots too; those that are `own` are not."""
    state: Any = object.__getstate__(thing)
    found: dict[str, Any] = {}
    for attributes in state if isinstance(state, tuple) else (state,):
        found.update(attributes or {})
    return {name: value for name, value in found.items() if name not in own}


def add_attributes(thing: object, attributes: dict[str, Any]) -> None:
    """Give a copy what `added_attributes` found, past any `__setattr__`."""
    for name, value in attributes.items():
        object.__setattr__(thing, name, value)
