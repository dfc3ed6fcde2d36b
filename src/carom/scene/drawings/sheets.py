"""Style sheets, as far as they say whether something is seen and whether it is filled.

What drawing programs write is understood: rules for `.class`, `#id`, `tag`, `tag.class` and `*`, separated by commas.
Rules within `@media` and the like are for some readers only, and pass unheard; nothing is ever imported.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from carom.scene.drawings.tree import Element

Properties = Mapping[str, str]

#: The properties that are read, all but `display` inherited.
READ = ("fill", "stroke", "display", "visibility")

_SELECTOR = re.compile(r"([\w-]+|\*)?([.#][\w-]+)?")


class Sheet:
    """The rules of all style sheets of a drawing."""

    def __init__(self, root: Element) -> None:
        self._rules: dict[tuple[str, str], dict[str, str]] = {}
        for element in root.walk():
            if element.tag == "style" and element.text:
                self._add(element.text)

    def _add(self, text: str) -> None:
        """Take in the rules of one sheet; later ones overrule earlier ones."""
        for chunk in _uncommented(text).split("}"):
            selectors, _, body = chunk.rpartition("{")
            said = declarations(body)
            if not said or "{" in selectors:
                continue
            for selector in selectors.split(","):
                found = _SELECTOR.fullmatch(selector.strip())
                if found and found[0]:
                    self._rules.setdefault((found[1] or "*", found[2] or ""), {}).update(said)

    def properties_of(self, element: Element) -> dict[str, str]:
        """What is said of an element itself: by its attributes, over those by the sheets, over those by its style."""
        attributes = element.attributes
        said = {name: attributes[name].strip() for name in READ if name in attributes}
        if self._rules:
            classes = [f".{name}" for name in attributes.get("class", "").split()]
            marks = ["", *classes, *([f"#{attributes['id']}"] if "id" in attributes else [])]
            for mark in marks:
                for tag in ("*", element.tag):
                    said |= self._rules.get((tag, mark), {})
        if "style" in attributes:
            said |= declarations(attributes["style"])
        return said


def _uncommented(text: str) -> str:
    """A sheet without its comments."""
    first, *others = text.split("/*")
    return " ".join([first, *(other.partition("*/")[2] for other in others)])


def declarations(text: str) -> dict[str, str]:
    """The properties that a style's text sets, those that are read."""
    said = {}
    for declaration in text.split(";"):
        name, _, value = declaration.partition(":")
        if name.strip() in READ:
            said[name.strip()] = value.replace("!important", "").strip()
    return said


def is_painted(paint: str) -> bool:
    """Whether a fill or stroke is anything at all."""
    return paint not in {"none", "transparent"}
