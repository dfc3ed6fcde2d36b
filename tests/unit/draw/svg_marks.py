"""What an SVG file of a picture holds: its layers, the marks of each, and the words among them."""

from collections.abc import Iterable
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import carom
from carom import draw
from carom.draw import Layer

SVG = "{http://www.w3.org/2000/svg}"


def trace_of(world: carom.World, steps: int) -> draw.Trace:
    """The trace of some steps."""
    trace = draw.Trace(world)
    for _ in range(steps):
        trace.note(world.step(1 / 60))
    return trace


def root_of(world: carom.World, trace: draw.Trace | None = None, **options: Any) -> Element:
    """The root of the picture of a world."""
    return ElementTree.fromstring(draw.svg(draw.picture_of(world, "name", trace=trace, **options)))


def layer(root: Element, name: str) -> Element:
    """One layer of a picture."""
    found = root.find(f"{SVG}g[@id='{name}']")
    assert found is not None
    return found


def marks_of(picture: draw.Picture) -> dict[str, list[Element]]:
    """The marks of each layer of a picture."""
    root = ElementTree.fromstring(draw.svg(picture))
    marks = {"path", "circle", "polyline", "polygon", "text"}
    return {
        group.attrib["id"]: [mark for mark in group.iter() if mark.tag.removeprefix(SVG) in marks]
        for group in root.findall(f"{SVG}g")
    }


def of_world(world: carom.World, *layers: Layer, trace: draw.Trace | None = None) -> dict[str, list[Element]]:
    """The marks of a picture of a world that shows some layers."""
    return marks_of(draw.picture_of(world, "name", layers=layers, trace=trace))


def at_end(recording: carom.Recording, *layers: Layer) -> dict[str, list[Element]]:
    """The marks of a picture of a recording's end."""
    return marks_of(draw.picture_at(recording, layers=layers))


def words_in(marks: Iterable[Element]) -> list[str]:
    """The words among some marks, line by line."""
    return [mark.text or "" for mark in marks if mark.tag == f"{SVG}text"]


def fallen(seconds: float = 0.5, **options: Any) -> carom.Recording:
    """A ball that has just hit a floor at x = 1, at 0.4472 s."""
    world = carom.World(gravity=(0, -10), detection="continuous")
    world.add(carom.Segment((-3, 0), (3, 0), name="floor", **options))
    world.add(carom.Ball((1, 1.5), 0.5, name="ball"))
    return carom.Recording.of(world, seconds)
