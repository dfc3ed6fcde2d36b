"""What is wrong with a scene, in words: one line per fault, each beginning with the fault's path."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, get_args

from pydantic import BaseModel
from pydantic_core import PydanticCustomError

from carom.checks import written
from carom.errors import CaromError, SceneError
from carom.limits import MOST_FAULTS, REASONS
from carom.spelling import hint

if TYPE_CHECKING:
    from pydantic import ValidationError
    from pydantic_core import ErrorDetails

#: Characters of a value, or of a strange name, that are shown.
LONGEST = 60

#: The lists whose items say of which kind they are.
OF_KINDS = ("shapes", "actuators")

#: The words for pydantic's types of error. Those not here speak for themselves.
_WORDS = {
    "missing": "is missing",
    "extra_forbidden": "is unknown",
    "greater_than": "must be positive",
    "finite_number": "must be finite",
    "float_type": "must be a number",
    "float_parsing": "must be a number",
    "int_type": "must be a whole number",
    "int_from_float": "must be a whole number",
    "bool_type": "must be true or false",
    "string_type": "must be a string",
    "tuple_type": "must be a list",
    "model_type": "must be a table",
    "model_attributes_type": "must be a table",
    "dict_type": "must be a table",
    "union_tag_not_found": "is missing",
}

#: Types of error whose words say it all; the value would add nothing.
_WITHOUT_VALUE = {"missing", "extra_forbidden", "union_tag_not_found"}


class Faults:
    """What is wrong with a `model`, as it is found: the number of faults, and the words of the first ones.

    With the fault whose number is `enough`, `add_words` raises the error, and nothing more is looked for.
    """

    def __init__(self, model: type[BaseModel], enough: int | None = None) -> None:
        self.model = model
        self.enough = enough
        self.count = 0
        self.first: list[str] = []

    def add(
        self, error: ValidationError, *path: int | str, unless: Callable[[ErrorDetails], bool] | None = None
    ) -> None:
        """Take in what pydantic found below `path`; a number at its end is that of the first item there."""
        room = MOST_FAULTS - len(self.first)
        if unless is None and room == 0:
            self.count += error.error_count()
            return
        found = [details for details in error.errors(include_url=False) if unless is None or not unless(details)]
        self.count += len(found)
        self.first += [_fault(details, path, self.model) for details in found[:room]]

    def add_words(self, path: str, words: str) -> None:
        """Take in one fault; raises `SceneError` where it is enough of them."""
        self.count += 1
        if len(self.first) < MOST_FAULTS:
            self.first.append(f"{path}: {words}")
        if self.count == self.enough:
            raise self.error()

    def join(self, *others: Faults) -> None:
        """Take in the faults of others, which come after these."""
        for other in others:
            self.count += other.count
            self.first += other.first[: MOST_FAULTS - len(self.first)]

    def error(self) -> SceneError:
        """The error to raise: the only fault on the first line, or their number, and a line for each of the first."""
        if self.count == 1:
            return SceneError(self.first[0])
        more = [f"and {self.count - len(self.first)} more"] if self.count > len(self.first) else []
        rest = ", and what comes after them was not looked at" if self.count == self.enough else ""
        return SceneError("\n  ".join([f"{self.count} faults{rest}", *self.first, *more]))


def refused_below(error: CaromError, fields: Iterable[str]) -> PydanticCustomError:
    """A constructor's `error` as a fault: of the field that its message begins with, if that is one of `fields`."""
    message = str(error)
    match = re.match(r"(\w+)((?:\[\d+\])*) (.*)", message, re.DOTALL)
    if match and match[1] in set(fields):
        return fault_below(f".{match[1]}{match[2]}", match[3])
    return fault_below("", message)


def fault_below(path: str, words: str) -> PydanticCustomError:
    """A fault for a validator to raise: `words` about what lies at `path` below the validator's own place."""
    return PydanticCustomError("below", "{words}", {"path": path, "words": words})


def _fault(details: ErrorDetails, above: tuple[int | str, ...], model: type[BaseModel]) -> str:
    """One fault as `path: words`, found below `above`; a number at its end is that of the first item there."""
    kind = details["type"]
    location = (*above, *details["loc"])
    match above, details["loc"]:
        case (*steps, int(start)), (int(number), *below):
            location = (*steps, start + number, *below)
    path = path_of(location)
    context = details.get("ctx", {})
    if kind == "below":
        return _joined(path + context["path"], context["words"])
    if kind == "extra_forbidden":
        *place, name = location
        return _joined(path, _unknown(str(name), _names_at(model, place)))
    if kind == "union_tag_not_found":
        for name in details["input"]:
            if said := hint(str(name), ["kind"]):
                return _joined(f"{path}.{name}", f"is unknown; {said}")
    if kind in {"union_tag_not_found", "union_tag_invalid"}:
        path = f"{path}.kind"
    return _joined(path, _words(kind, details))


def _unknown(name: str, known: list[str]) -> str:
    """What to say of a field that is none of the `known` ones."""
    said = hint(name, known)
    return f"{_WORDS['extra_forbidden']}; {said}" if said else _WORDS["extra_forbidden"]


def _names_at(model: type[BaseModel], place: Iterable[int | str]) -> list[str]:
    """The fields of the table at a place in a `model`, where a step may be the kind that a table was taken for."""
    models = [model]
    for step in place:
        if isinstance(step, str):
            tagged = [one for one in models if "kind" in one.model_fields and one.model_fields["kind"].default == step]
            fields = [one.model_fields[step].annotation for one in models if step in one.model_fields]
            models = tagged or [below for annotation in fields for below in _models_in(annotation)]
    return [name for one in models for name in one.model_fields]


def _models_in(annotation: Any) -> Iterator[type[BaseModel]]:
    """The models that a field's type speaks of."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for part in get_args(annotation):
        yield from _models_in(part)


def field_of(details: ErrorDetails) -> int | str | None:
    """The field of the model that a fault is in; None where it is in no one."""
    return details["loc"][0] if details["loc"] else None


def is_elsewhere(field: str, details: ErrorDetails) -> bool:
    """Whether a fault is in another field."""
    return field_of(details) != field


def is_unknown(details: ErrorDetails) -> bool:
    """Whether what is wrong is a name at the top of the scene that there is not."""
    return details["type"] == "extra_forbidden" and len(details["loc"]) == 1


def _joined(path: str, words: str) -> str:
    """`path: words`, or the words alone where the path is the scene itself."""
    path = path.removeprefix(".")
    return f"{path}: {words}" if path else words


def _words(kind: str, details: ErrorDetails) -> str:
    """What is wrong, and the value where it helps."""
    context = details.get("ctx", {})
    if kind in _WITHOUT_VALUE:
        return _WORDS[kind]
    value = shortened(details["input"])
    if kind == "union_tag_invalid":
        return f"must be one of {context['expected_tags']}, not {shortened(context['tag'])}"
    if kind == "literal_error":
        return f"must be {context['expected']}, not {value}"
    if kind == "greater_than_equal":
        least = context["ge"]
        return f"must not be negative, not {value}" if least == 0 else f"must be at least {least}, not {value}"
    if kind == "less_than_equal":
        reason = REASONS.get(str(details["loc"][-1]))
        return f"must be at most {context['le']}{f' ({reason})' if reason else ''}, not {value}"
    return f"{_WORDS[kind]}, not {value}" if kind in _WORDS else details["msg"]


def shortened(value: object) -> str:
    """`value` as it is written, cut where it is long."""
    text = written(value, LONGEST)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def path_of(location: tuple[int | str, ...]) -> str:
    """A place in a scene as a user writes it: `shapes[3].radius`."""
    path = ""
    for place, step in enumerate(location):
        if isinstance(step, int):
            path += f"[{step}]"
        elif not _is_tag(location, place):
            path += f".{step}" if re.fullmatch(r"\w{1,60}", step) else f".{shortened(step)}"
    return path.removeprefix(".")


def _is_tag(location: tuple[int | str, ...], place: int) -> bool:
    """Whether pydantic put the step at `place` there to say which kind of table it took; no file holds such a step."""
    return place >= 2 and isinstance(location[place - 1], int) and location[place - 2] in OF_KINDS
