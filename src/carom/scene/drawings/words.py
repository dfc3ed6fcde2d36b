"""What an SVG element says of itself: its name, and its options in attributes and in its label."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any

from carom.scene.drawings import keywords
from carom.scene.drawings.tree import INKSCAPE, MARK, Element

#: Attributes that may be meant for carom: a word like its name, with `data-` before it or without.
_NEARLY = re.compile(r"(?:data[-_])?(c\w*?[mn])[-_](.+)", re.IGNORECASE)
_LABEL = f"{INKSCAPE}{MARK}label"
#: The label of a circle that says where its group turns.
PIVOT = "pivot"


@dataclass(slots=True)
class Said:
    """The name of an element, its options, and how each of these is written in the drawing."""

    name: str | None
    options: dict[str, Any] = field(default_factory=dict)
    written: dict[str, str] = field(default_factory=dict)

    def handed_down(self) -> dict[str, Any]:
        """The options that hold for what is in the element too."""
        return {key: value for key, value in self.options.items() if key not in keywords.OWN}


def said_by(element: Element) -> Said:
    """What an element says; raises `ValueError`, which begins with the attribute or the word of the label.

    Attributes overrule the label, and a label's name the id, which programs give by themselves.
    """
    attributes = element.attributes
    name, labelled = keywords.labelled("label", attributes[_LABEL]) if _LABEL in attributes else ("", [])
    said = Said(name or attributes.get("id"))
    for key, text in labelled:
        _add(said, f"label {key}", key, text)
    for attribute, text in attributes.items():
        if not attribute.startswith(keywords.PREFIX):
            _refuse_slip(attribute)
        elif not (is_pivot(element) and attribute == "data-carom-pivot"):
            _add(said, attribute, attribute.removeprefix(keywords.PREFIX), text)
    said.name = said.options.pop("name", None) or said.name
    return said


def _refuse_slip(attribute: str) -> None:
    """Raise `ValueError`, which begins with the attribute, for one that nearly begins as those of carom do."""
    found = _NEARLY.match(attribute)
    if found and get_close_matches(found[1], ["carom"], cutoff=0.75):
        raise ValueError(f"{attribute[:60]}: is unknown; did you mean {keywords.PREFIX}{found[2][:60]}?")


def _add(said: Said, place: str, key: str, text: str) -> None:
    """Take in an option."""
    try:
        known, value = keywords.of_shape(key, text)
    except ValueError as error:
        raise ValueError(f"{place}: {error}") from None
    said.options[known] = value
    said.written[known] = place


def is_pivot(element: Element) -> bool:
    """Whether a circle is no body, but says where its group turns."""
    if element.tag not in {"circle", "ellipse"}:
        return False
    attributes = element.attributes
    return attributes.get(_LABEL, "").strip() == PIVOT or attributes.get("data-carom-pivot", "none").strip() == ""


def world_of(root: Element) -> tuple[dict[str, Any], list[str]]:
    """What the root says of the world and the scene, and what is wrong with that."""
    world: dict[str, Any] = {}
    wrong: list[str] = []
    for child in root.children:
        if child.tag == "title" and child.text.strip():
            world["name"] = " ".join(child.text.split())
    for attribute, text in root.attributes.items():
        try:
            if not attribute.startswith(keywords.PREFIX):
                _refuse_slip(attribute)
                continue
            key, value = _of_world(attribute, text)
            world[key] = value
        except ValueError as error:
            wrong.append(str(error))
    return world, wrong


def _of_world(attribute: str, text: str) -> tuple[str, Any]:
    """An option of the world; raises `ValueError`, which begins with the attribute."""
    try:
        return keywords.of_world(attribute.removeprefix(keywords.PREFIX), text)
    except ValueError as error:
        raise ValueError(f"{attribute}: {error}") from None
