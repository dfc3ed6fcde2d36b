"""The base of all descriptors: how strictly they read, and how they are written."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, model_validator

from carom.errors import UnknownName

#: What stands first in a table, in this order.
_FIRST = ("version", "kind", "name")


#: What no field is by default.
_WRITTEN = object()

#: What NumPy has for numbers, booleans and lists.
OF_NUMPY = np.generic, np.ndarray


def in_python(value: Any) -> Any:
    """A number, boolean or array of NumPy as a number, boolean or list of Python; anything else as it is."""
    return value.tolist() if isinstance(value, OF_NUMPY) else value


class Descriptor(BaseModel):
    """A part of a scene: strict (no text for a number), frozen, and without room for what it does not know."""

    model_config = ConfigDict(
        strict=True, frozen=True, extra="forbid", allow_inf_nan=False, use_attribute_docstrings=True
    )

    @model_validator(mode="before")
    @classmethod
    def _in_python(cls, given: Any) -> Any:
        """The fields with what is of NumPy as of Python: strict fields take no other, or what they take varies."""
        if type(given) is dict and any(isinstance(value, OF_NUMPY) for value in given.values()):
            return {name: in_python(value) for name, value in given.items()}
        return given

    if not TYPE_CHECKING:  # type checkers know that it is frozen

        def __setattr__(self, name: str, value: Any) -> None:
            self._refuse_change(name)
            super().__setattr__(name, value)

        def __delattr__(self, name: str) -> None:
            self._refuse_change(name)
            super().__delattr__(name)

    def _refuse_change(self, name: str) -> None:
        """Raise `UnknownName` for an attribute that is not a subclass's own business."""
        if not name.startswith("_"):
            raise UnknownName(f"{name} cannot be set: a {type(self).__name__} cannot be changed")

    def plain(self) -> dict[str, Any]:
        """The descriptor as a file holds it: plain tables, without what is as it would be anyway.

        Fields of its own stand before those that it has from another descriptor.
        """
        table = {}
        for name, default, written in _fields(type(self)):
            value = getattr(self, name)
            # By repr, for -0.0 equals 0.0 and is not the same.
            if value is not default and (name == "kind" or repr(value) != written):
                table[name] = _plain(value)
        return table


@cache
def _fields(kind: type[Descriptor]) -> tuple[tuple[str, Any, str], ...]:
    """The fields of a descriptor in their order in a table, each with its default and how that is written."""

    def rank(field: str) -> int:
        return _FIRST.index(field) if field in _FIRST else len(_FIRST) + (field not in kind.__annotations__)

    fields = kind.model_fields
    # A kind is written always, so it has no default here.
    return tuple(
        (name, _WRITTEN if name == "kind" else fields[name].default, repr(fields[name].default))
        for name in sorted(fields, key=rank)
    )


def _plain(value: Any) -> Any:
    """A field's value as a file holds it."""
    if isinstance(value, tuple):
        return [item if type(item) is float else _plain(item) for item in value]
    return value.plain() if isinstance(value, Descriptor) else value
