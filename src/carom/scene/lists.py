"""The lists of a scene, checked block by block: so that the faults of a long list take no more memory than the list.

A block is checked by pydantic. What is wrong in the first ones is told, what is wrong in the others is counted.
"""

from __future__ import annotations

from functools import cache
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, TypeAdapter, ValidationError

from carom.limits import MOST_NAMES
from carom.scene.capture import described_all
from carom.scene.descriptors import BallDescriptor
from carom.scene.faults import Faults, path_of
from carom.scene.shape_descriptors import CompoundDescriptor, GroupDescriptor, Part, PartList

ShapeList = Annotated[
    tuple[Annotated[Part | CompoundDescriptor | GroupDescriptor, Field(discriminator="kind")], ...],
    BeforeValidator(described_all),
]
BallList = Annotated[tuple[BallDescriptor, ...], BeforeValidator(described_all)]

#: The lists of a scene, in the order in which they are told.
LISTS = ("shapes", "balls")

#: Items in a block.
BLOCK = 500

Path = tuple[int | str, ...]


def checked_list(field: str, given: list[Any] | tuple[Any, ...], faults: Faults) -> tuple[Any, ...]:
    """The descriptors of one of the `LISTS`; fewer where there are faults."""
    return _checked(_adapter(field), given, (field,), faults)


def crowd(table: dict[str, Any]) -> str | None:
    """What is wrong with a table that has more names than any has; None where it has not."""
    return f"must have at most {MOST_NAMES} names, not {len(table)}" if len(table) > MOST_NAMES else None


@cache
def _adapter(field: str) -> TypeAdapter[tuple[Any, ...]]:
    """What checks a block of a list."""
    types: dict[str, Any] = {"shapes": ShapeList, "balls": BallList, "parts": PartList}
    return TypeAdapter(types[field])


def _checked(
    adapter: TypeAdapter[tuple[Any, ...]], given: list[Any] | tuple[Any, ...], path: Path, faults: Faults
) -> tuple[Any, ...]:
    """The descriptors of a list at `path`, checked block by block."""
    made: list[Any] = []
    for start in range(0, len(given), BLOCK):
        found, block = Faults(faults.model), []
        for place, item in enumerate(given[start : start + BLOCK], start):
            block.append(_unpacked(item, (*path, place), found))
        try:
            made += adapter.validate_python(block)
        except ValidationError as error:
            faults.add(error, *path, start)
        faults.join(found)
    return tuple(made)


def _unpacked(item: Any, path: Path, faults: Faults) -> Any:
    """An item, whose own list of parts is checked already if it is long; without strange names if it has too many."""
    if not isinstance(item, dict):
        return item
    parts = item.get("shapes")
    if isinstance(parts, (list, tuple)) and len(parts) > BLOCK and item.get("kind") in {"compound", "group"}:
        found = Faults(faults.model)
        made = _checked(_adapter("parts"), parts, (*path, item["kind"], "shapes"), found)
        faults.join(found)
        item = item | {"shapes": () if found.count else made}
    wrong = crowd(item)
    if wrong:
        faults.add_words(path_of(path), wrong)
        known = {"kind", *BallDescriptor.model_fields, *CompoundDescriptor.model_fields}
        return {name: value for name, value in item.items() if name in known}
    return item
