"""The types of a descriptor's fields: what a value in a scene file may be."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field
from pydantic_core import PydanticCustomError

from carom.limits import MOST_IMPACTS, MOST_ITERATIONS, MOST_LEVELS, MOST_SUBSTEPS
from carom.rows.ball import ALL_LAYERS
from carom.scene.descriptor import in_python
from carom.scene.faults import shortened
from carom.shapes.aabb import Aabb


def _sequence(value: Any, count: int, what: str) -> tuple[Any, ...]:
    """`value` as a tuple of `count` items, whatever they are; refused as not being `what`."""
    if not isinstance(value, (str, bytes, dict, set, frozenset)):
        try:
            items = tuple(map(in_python, value))
        except TypeError:
            items = ()
        if len(items) == count:
            return items
    raise PydanticCustomError("sequence", "must be {what}, not {value}", {"what": what, "value": shortened(value)})


def as_pair(value: Any) -> tuple[Any, ...]:
    """`value` as a tuple of two items, whatever they are; refused where it is none."""
    return _sequence(value, 2, "a pair of numbers")


def _as_sides(value: Any) -> tuple[Any, ...]:
    """`value`, an `Aabb` or four items, as a tuple of four items."""
    if isinstance(value, Aabb):
        return value.left, value.bottom, value.right, value.top
    return _sequence(value, 4, "four numbers (left, bottom, right, top)")


def _in_order(sides: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    """`sides`, unless one of them lies beyond the one across."""
    left, bottom, right, top = sides
    if left > right or bottom > top:
        raise PydanticCustomError("sides", "must have left <= right and bottom <= top, not {value}", {"value": sides})
    return sides


def _writable(text: str) -> str:
    """`text`, unless UTF-8 has no bytes for it."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        must = "must be text that UTF-8 can hold, not {value}"
        raise PydanticCustomError("text", must, {"value": shortened(text)}) from None
    return text


def as_tuple(value: Any) -> Any:
    """A list as a tuple; anything else as it is, for the field to judge."""
    return tuple(map(in_python, value)) if isinstance(value, list) else value


def _whole(value: Any) -> Any:
    """`value`, unless it only equals a whole number, as `True` and `1.0` do."""
    if type(value) is not int and isinstance(value, (int, float)):
        raise PydanticCustomError("version", "must be the whole number 1, not {value}", {"value": shortened(value)})
    return value


Version = Annotated[Literal[1], BeforeValidator(_whole)]
Positive = Annotated[float, Field(gt=0.0)]
NonNegative = Annotated[float, Field(ge=0.0)]
Text = Annotated[str, AfterValidator(_writable)]
Substeps = Annotated[int, Field(ge=1, le=MOST_SUBSTEPS)]
Iterations = Annotated[int, Field(ge=1, le=MOST_ITERATIONS)]
Levels = Annotated[int, Field(ge=1, le=MOST_LEVELS)]
Impacts = Annotated[int, Field(ge=1, le=MOST_IMPACTS)]
Layers = Annotated[int, Field(ge=0, le=ALL_LAYERS)]
Vector = Annotated[tuple[float, float], BeforeValidator(as_pair)]
Sides = Annotated[tuple[float, float, float, float], AfterValidator(_in_order), BeforeValidator(_as_sides)]
