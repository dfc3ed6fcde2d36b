"""The base of all descriptors: how strictly they read, and how they are written."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict

#: What stands first in a table, in this order.
_FIRST = ("version", "kind", "name")


class Descriptor(BaseModel):
    """A part of a scene: strict (no text for a number), frozen, and without room for what it does not know."""

    model_config = ConfigDict(
        strict=True, frozen=True, extra="forbid", allow_inf_nan=False, use_attribute_docstrings=True
    )

    def plain(self) -> dict[str, Any]:
        """The descriptor as a file holds it: plain tables, without what is as it would be anyway.

        Fields of its own stand before those that it has from another descriptor.
        """
        fields = type(self).model_fields
        table = {}
        for name in sorted(fields, key=self._rank):
            value, field = getattr(self, name), fields[name]
            # By repr, for -0.0 equals 0.0 and is not the same.
            if name == "kind" or repr(value) != repr(field.default):
                table[name] = _plain(value)
        return table

    def _rank(self, field: str) -> int:
        """Where a field stands in the table."""
        if field in _FIRST:
            return _FIRST.index(field)
        return len(_FIRST) + (field not in type(self).__annotations__)


def _plain(value: Any) -> Any:
    """A field's value as a file holds it."""
    if isinstance(value, Descriptor):
        return value.plain()
    return [_plain(item) for item in value] if isinstance(value, tuple) else value
