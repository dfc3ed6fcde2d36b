"""The elements of an XML file as a tree, with the line of each; nothing outside of the file is ever read.

The parser is expat itself, for it alone says in which line an element stands. Entities are read as far as Illustrator
writes them, a few short words without further entities in them; all others are refused before they are used.
"""

from __future__ import annotations

from collections.abc import Iterator
from pyexpat import ErrorString, ExpatError, ParserCreate
from typing import Any

from carom.errors import SceneError
from carom.scene.drawings.limits import DEEPEST, LONGEST_ENTITY, MOST_ELEMENTS, MOST_EXPANDED

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
#: What stands between a namespace and a name.
MARK = " "


class Element:
    """An element: its name (with the namespace before it, unless that is SVG's), attributes, children, text, line."""

    __slots__ = ("attributes", "children", "line", "tag", "text")

    def __init__(self, tag: str, attributes: dict[str, str], line: int) -> None:
        self.tag = tag
        self.attributes = attributes
        self.children: list[Element] = []
        self.line = line
        self.text = ""

    def __str__(self) -> str:
        """The element as a message names it: `<circle id="bumper"> (line 12)`."""
        name = self.attributes.get("id")
        tag = self.tag.rpartition(MARK)[2]
        return f'<{tag} id="{name[:60]}"> (line {self.line})' if name else f"<{tag}> (line {self.line})"

    def walk(self) -> Iterator[Element]:
        """The element and all that is in it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting += reversed(element.children)


class _Reader:
    """Takes what expat finds."""

    def __init__(self, data: bytes) -> None:
        self.root: Element | None = None
        self._open: list[Element] = []
        self._count = 0
        self._references = data.count(b"&")
        self._words = 0
        self._parser: Any = ParserCreate(namespace_separator=MARK)
        self._parser.buffer_text = True
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._text
        self._parser.EntityDeclHandler = self._entity
        self._parser.ExternalEntityRefHandler = None

    def read(self, data: bytes) -> Element:
        """The root of the tree."""
        try:
            self._parser.Parse(data, True)
        except ExpatError as error:
            raise SceneError(f"line {error.lineno}: is not well-formed XML: {ErrorString(error.code)}") from None
        except SceneError:
            raise
        except (LookupError, ValueError) as error:  # of an encoding that there is not
            raise SceneError(f"line 1: is not well-formed XML: {error}") from None
        finally:
            self._parser = None  # which holds what holds it: of a large tree the search for garbage would take long
        if self.root is None:
            raise SceneError("line 1: is not well-formed XML: no element found")
        return self.root

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        line = self._parser.CurrentLineNumber
        element = Element(tag.removeprefix(SVG + MARK), attributes, line)
        self._count += 1
        if self._count > MOST_ELEMENTS:
            raise SceneError(f"{element}: a drawing may have at most {MOST_ELEMENTS} elements")
        if len(self._open) >= DEEPEST:
            raise SceneError(f"{element}: nested too deeply: more than {DEEPEST} levels")
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _end(self, _: str) -> None:
        self._open.pop()

    def _text(self, text: str) -> None:
        # Only style sheets, titles and the like say anything; between shapes is nothing but white space.
        if self._open and not text.isspace():
            self._open[-1].text += text

    def _entity(self, name: str, parameter: bool, value: str | None, *_: object) -> None:
        where = f"line {self._parser.CurrentLineNumber}: entity {name[:60]!r}"
        if value is None:
            raise SceneError(f"{where}: must be text, not a reference to another file")
        self._words = max(self._words, len(value))
        if parameter or "&" in value or "<" in value or len(value) > LONGEST_ENTITY:
            raise SceneError(f"{where}: must be a short text without markup and entities in it")
        if self._words * self._references > MOST_EXPANDED:
            raise SceneError(f"{where}: stands for too much text, all references taken together")


def read_tree(data: bytes) -> Element:
    """The root of the XML in `data`; raises `SceneError`, with the line, where it is broken, hostile or too large."""
    # Every element has one or two of them, and counting is quick.
    if data.count(b"<") > 2 * MOST_ELEMENTS + 10_000:
        raise SceneError(f"a drawing may have at most {MOST_ELEMENTS} elements")
    return _Reader(data).read(data)
