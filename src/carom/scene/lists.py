"""The lists of a scene, checked block by block: so that the faults of a long list take no more memory than the list.

A block is checked by pydantic. What is wrong in the first ones is told, what is wrong in the others is counted.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import BeforeValidator, Field, TypeAdapter, ValidationError

from carom.limits import MOST_NAMES
from carom.scene.capture import described_all
from carom.scene.descriptors import BallDescriptor
from carom.scene.faults import Faults, path_of
from carom.scene.shape_descriptors import CompoundDescriptor, GroupDescriptor, Part, PartList

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

ShapeList = Annotated[
    tuple[Annotated[Part | CompoundDescriptor | GroupDescriptor, Field(discriminator="kind")], ...],
    BeforeValidator(described_all),
]
BallList = Annotated[tuple[BallDescriptor, ...], BeforeValidator(described_all)]

#: The lists of a scene, in the order in which they are told.
LISTS = ("shapes", "balls")

#: Items in a block.
BLOCK = 500

#: What holds a list of parts.
ASSEMBLIES: dict[str, type[CompoundDescriptor | GroupDescriptor]] = {
    "compound": CompoundDescriptor,
    "group": GroupDescriptor,
}

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
    """The descriptors of a list at `path`, checked block by block; an item with faults of its own ends its block."""
    made: list[Any] = []
    block: list[Any] = []
    for place, item in enumerate(given):
        in_parts, in_names = Faults(faults.model), Faults(faults.model)
        block.append(_unpacked(item, (*path, place), in_parts, in_names))
        if len(block) == BLOCK or place + 1 == len(given) or in_parts.count or in_names.count:
            made += _checked_block(adapter, block, (*path, place + 1 - len(block)), faults, in_parts)
            faults.join(in_names)
            block = []
    return tuple(made)


def _checked_block(
    adapter: TypeAdapter[tuple[Any, ...]], block: list[Any], path: Path, faults: Faults, in_parts: Faults
) -> tuple[Any, ...]:
    """The descriptors of a block whose first item is at `path`; `in_parts` are the faults in the last one's parts.

    Those stand where pydantic would tell them: after the faults of the fields that come first, before those of others.
    """
    try:
        made = adapter.validate_python(block)
    except ValidationError as error:
        last = len(block) - 1 if in_parts.count else None
        faults.add(error, *path, unless=lambda details: _side_of_parts(details, last) != "before")
        faults.join(in_parts)
        faults.add(error, *path, unless=lambda details: _side_of_parts(details, last) != "after")
        return ()
    faults.join(in_parts)
    return made


def _side_of_parts(details: ErrorDetails, last: int | None) -> str:
    """Whether a fault in a block stands before the faults that were found in the parts of the `last` item, or after.

    Neither where it says that these parts were left out.
    """
    place, *steps = details["loc"]
    if place != last:
        return "before"
    if len(steps) < 2 or steps[1] == "shapes":
        return "neither"
    fields = list(ASSEMBLIES[str(steps[0])].model_fields)
    return "before" if steps[1] in fields[: fields.index("shapes")] else "after"


def _unpacked(item: Any, path: Path, in_parts: Faults, in_names: Faults) -> Any:
    """An item, whose own list of parts is checked already if it is long; without strange names if it has too many."""
    if not isinstance(item, dict):
        return item
    kind, parts = item.get("kind"), item.get("shapes")
    if isinstance(parts, (list, tuple)) and len(parts) > BLOCK and isinstance(kind, str) and kind in ASSEMBLIES:
        made = _checked(_adapter("parts"), parts, (*path, kind, "shapes"), in_parts)
        item = item | {"shapes": () if in_parts.count else made}
    wrong = crowd(item)
    if wrong:
        in_names.add_words(path_of(path), wrong)
        known = {"kind", *BallDescriptor.model_fields, *CompoundDescriptor.model_fields}
        return {name: value for name, value in item.items() if name in known}
    return item
