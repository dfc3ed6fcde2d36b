"""What a drawing says of its shapes in words, as options of a scene: `data-carom-*`, and labels with `kick=4`.

The options are those of the descriptors, by their names and types; so a keyword that scenes learn, drawings know too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from math import isfinite
from typing import Any, get_args

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.shape_descriptors import CompoundDescriptor, MovingDescriptor, Part
from carom.spelling import hint

PREFIX = "data-carom-"

#: The descriptors of single shapes, by their kinds.
SHAPES = {one.model_fields["kind"].default: one for one in get_args(get_args(Part)[0])}
#: What the lines of a drawing say themselves, and words do not.
DRAWN = frozenset({"position", "start", "end", "center", "radius", "start_angle", "end_angle", "shapes", "orientation"})
#: What is said of one element, and not of what is in it.
OWN = frozenset({"name", "pivot", "ball"})
#: What moves a compound, and is not for its parts.
MOVING = frozenset({*MovingDescriptor.model_fields, "motion"}) - {"orientation"}
#: Options that are right where they are not negative, or positive, whatever the others are.
NOT_NEGATIVE, POSITIVE = frozenset({"elasticity", "friction", "kick"}), frozenset({"mass"})
#: Kinds that a drawing cannot tell from others by itself.
KINDS = ("gate", "point")

_FIELDS = {
    name: model.model_fields[name].annotation
    for model in (*SHAPES.values(), CompoundDescriptor, BallDescriptor)
    for name in model.model_fields
    if name not in DRAWN and name not in {"kind", "pivot"}
} | {"kind": str, "ball": bool, "pivot": tuple[float, float]}
_WORLD = {name: field.annotation for name, field in WorldDescriptor.model_fields.items()} | {
    "name": str,
    "guard": bool,
    "tolerance": float,
}

_WORD = re.compile(r'([A-Za-z_][\w-]*)=("[^"]*"|\S*)|(\S+)')
#: An option as somebody may write it who has forgotten how.
_SLIP = re.compile(r"([A-Za-z_][\w-]*)(?:\s+=|:\s*(?=[-+.\d]))\s*\S+")
WRITTEN = 'options stand at the end, without blanks: kick=4 velocity=3,4 name="two words"'
_TRUE, _FALSE = ("true", "yes", "on", "1", ""), ("false", "no", "off", "0")


def of_shape(name: str, text: str) -> tuple[str, Any]:
    """An option of a shape or ball, by the descriptors' own name, with its value; raises `ValueError`."""
    return _option(name, text, _FIELDS)


def of_world(name: str, text: str) -> tuple[str, Any]:
    """An option of the world, or of the scene; raises `ValueError`."""
    return _option(name, text, _WORLD)


def check_signs(options: dict[str, Any], written: dict[str, str]) -> None:
    """Raise `ValueError` for a number that must not be negative and is, which begins with how the option is written.

    The descriptors say the same, but not before all of a drawing is read.
    """
    for key, value in options.items():
        if key in NOT_NEGATIVE and value < 0.0:
            raise ValueError(f"{written[key]}: must not be negative, not {value}")
        if key in POSITIVE and value <= 0.0:
            raise ValueError(f"{written[key]}: must be positive, not {value}")


def label(text: str) -> tuple[str, list[tuple[str, str]]]:
    """The name in a label and the options after it, as they are written: `bumper kick=4` names a bumper.

    Raises `ValueError` for words after an option, and for an option that is written otherwise.
    """
    words: list[str] = []
    options: list[tuple[str, str]] = []
    for key, value, word in _WORD.findall(text):
        if key:
            options.append((key, value.strip('"')))
        elif options:
            last = options[-1][0]
            raise ValueError(f"{word[:60]!r} after {last}=: {WRITTEN}")
        else:
            words.append(word)
    slip = _SLIP.search(text) if not options else None
    if slip and slip[1].replace("-", "_") in _FIELDS:
        raise ValueError(f"{slip[0][:60]!r}: {WRITTEN}")
    return (" ".join(words), options) if options else (text.strip(), [])


def labelled(place: str, text: str) -> tuple[str, list[tuple[str, str]]]:
    """What `label` finds in a text; its `ValueError` begins with the place that the text stands in."""
    try:
        return label(text)
    except ValueError as error:
        raise ValueError(f"{place}: {error}") from None


def _option(name: str, text: str, fields: dict[str, Any]) -> tuple[str, Any]:
    """An option among `fields`, with its value."""
    known = name.replace("-", "_")
    if known not in fields:
        if known in DRAWN:
            raise ValueError("is drawn, not written")
        said = hint(known, fields) or f"there are {', '.join(sorted(fields))}"
        raise ValueError(f"is unknown; {said}")
    try:
        value = _value(fields[known], text.strip())
    except ValueError as error:
        raise ValueError(f"{error}, not {text[:60]!r}") from None
    if known == "kind" and value not in KINDS:
        raise ValueError(f"must be one of {', '.join(KINDS)}, for all else is drawn, not {text[:60]!r}")
    return known, value


def _value(annotation: Any, text: str) -> Any:
    """The value that a text writes for a field of some type."""
    types = set(_types_in(annotation))
    if tuple in types:
        count = 4 if _count(annotation) == 4 else 2
        return _numbers(text, count)
    if bool in types:
        return _switch(text)
    if int in types:
        return _whole(text)
    if float in types:
        return _numbers(text, 1)[0]
    return text


def _types_in(annotation: Any) -> Iterable[Any]:
    """The plain types that a field's type is made of; a tuple stands for what is in it."""
    if getattr(annotation, "__origin__", None) is tuple:
        yield tuple
        return
    inner = [one for one in get_args(annotation) if isinstance(one, type) or get_args(one)]
    if not inner:
        yield annotation
    for one in inner:
        yield from _types_in(one)


def _count(annotation: Any) -> int:
    """How many numbers are in the tuple that a field's type speaks of."""
    if getattr(annotation, "__origin__", None) is tuple:
        return len(get_args(annotation))
    return max((_count(one) for one in get_args(annotation)), default=0)


def _numbers(text: str, count: int) -> Any:
    """As many numbers as there must be, as a tuple."""
    must = "must be a number" if count == 1 else f"must be {count} numbers"
    try:
        values = tuple(float(word) for word in text.replace(",", " ").split())
    except ValueError:
        raise ValueError(must) from None
    if len(values) != count or not all(map(isfinite, values)):
        raise ValueError(must)
    return values


def _switch(text: str) -> bool:
    """Whether a switch is on; an attribute without a value is."""
    if text.lower() not in (*_TRUE, *_FALSE):
        raise ValueError("must be true or false")
    return text.lower() in _TRUE


def _whole(text: str) -> int:
    """A whole number, also in hexadecimal or binary digits."""
    try:
        return int(text, 0)
    except ValueError:
        raise ValueError("must be a whole number") from None
