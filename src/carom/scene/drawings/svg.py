"""SVG drawings as bodies: the tree is walked once, with all that groups hand down to what is in them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from random import Random
from typing import Any

from carom.errors import SceneError
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings import keywords
from carom.scene.drawings.bodies import Body, Drawing
from carom.scene.drawings.counting import Amount, own_of, refuse_amount
from carom.scene.drawings.keeping import kept_in
from carom.scene.drawings.limits import DEEPEST, MOST_CURVES, MOST_ELEMENTS, MOST_MARKS, SAMPLE
from carom.scene.drawings.outlines import DRAWS, NEEDS, length, outlines_of
from carom.scene.drawings.pieces import Matrix, Vector, is_nothing, moved
from carom.scene.drawings.sampling import Sample
from carom.scene.drawings.sheets import Sheet, is_painted
from carom.scene.drawings.transforms import transform
from carom.scene.drawings.tree import MARK, XLINK, Element, read_tree
from carom.scene.drawings.view_boxes import fitting, page_of
from carom.scene.drawings.words import Said, is_pivot, said_by, world_of
from carom.scene.faults import Faults

#: What holds other elements and draws them.
GROUPS = frozenset({"a", "g", "svg", "switch", "use"})
#: What draws nothing by itself, and is no loss.
SILENT = frozenset(
    {"clipPath", "color-profile", "cursor", "defs", "desc", "filter", "font", "linearGradient", "marker", "mask"}
    | {"metadata", "pattern", "radialGradient", "script", "style", "symbol", "title", "view"}
)
#: What changes how an element is seen, and is passed over: the attribute, and the word for it.
UNHEARD = {
    "clip-path": "clipping",
    "mask": "mask",
    "filter": "filter",
    "marker-start": "marker",
    "marker-mid": "marker",
    "marker-end": "marker",
}
#: How the name of an attribute ends that FreeCAD gives to its dimensions: arrows and lines that tell a length.
DIMENSION = f"{MARK}dimpoint"
#: The word for an element that is not understood, where that is not its name.
WORDS = {"tspan": "text", "flowRoot": "text", "textPath": "text"}


@dataclass(frozen=True, slots=True)
class Below:
    """What a group hands down to what is in it, and where the bodies in it go."""

    matrix: Matrix
    viewport: Vector
    bodies: list[Body]
    properties: dict[str, str] = field(default_factory=dict)
    options: dict[str, Any] = field(default_factory=dict)
    written: dict[str, str] = field(default_factory=dict)
    name: str | None = None
    compound: Body | None = None


class SvgReader:
    """Reads one drawing into `drawing`."""

    def __init__(self, data: bytes, drawing: Drawing) -> None:
        self._drawing = drawing
        self._root = read_tree(data)
        if self._root.tag != "svg":
            raise SceneError(f"{self._root}: must be an svg element")
        named = [element for element in self._root.walk() if "id" in element.attributes]
        self._by_id = {element.attributes["id"]: element for element in reversed(named)}
        self._amounts: dict[int, Amount] = {}
        self._keys: dict[tuple[tuple[str, str], ...], tuple[dict[str, str], frozenset[str]]] = {}
        self._check_amount(self._root, 0)
        self._share = 1.0
        self._chance = Random(0)
        self._sheet = Sheet(self._root)

    def kept_scene(self) -> dict[str, Any] | None:
        """The table of the scene that the drawing is a picture of, None where it is none of carom's."""
        return kept_in(self._root)

    def sample(self) -> Sample | None:
        """Some of the bodies of a drawing, where it has so many curves that all take long."""
        share = SAMPLE / max(1, self._amounts[id(self._root)].curves)
        if share > 0.5:
            return None
        kept, self._drawing, self._share = self._drawing, Drawing(Faults(WorldDescriptor)), share
        try:
            self.read()
            page = page_of(self._root)
            return Sample(self._drawing, share, max(page.width or 0.0, page.height or 0.0))
        finally:
            self._drawing, self._share = kept, 1.0

    def read(self) -> None:
        """Take in all that is in the drawing."""
        root = self._root
        self._drawing.world, wrong = world_of(root)
        self._drawing.where = root
        for words in wrong:
            self._drawing.faults.add_words(str(root), words)
        try:
            page = page_of(root)
            inner, size = page.contents(root)
        except ValueError as error:
            raise SceneError(f"{root}: width, height, viewBox: {error}") from None
        up = Matrix(1.0, 0.0, 0.0, -1.0, 0.0, page.height or 0.0)
        below = Below(up.after(inner), size, self._drawing.bodies)
        below = replace(below, properties=self._sheet.properties_of(root))
        for child in root.children:
            self._visit(child, below)

    def let_go(self) -> None:
        """Let go of what the elements say, once it is taken in: bodies keep them for their names and lines alone."""
        for element in [*self._root.walk()]:
            name = element.attributes.get("id")
            element.attributes = {"id": name} if name else {}
            element.children = []

    # -- before anything is drawn ----------------------------------------------------------------------------------

    def _check_amount(self, element: Element, depth: int) -> Amount:
        """How much is drawn for an element, by reference too; raises where that is too much, or without end."""
        key = id(element)
        if key in self._amounts:
            if self._amounts[key].elements == 0:
                raise SceneError(f"{element}: is drawn again by what is in it, without end")
            return self._amounts[key]
        if depth > 2 * DEEPEST:
            raise SceneError(f"{element}: nested too deeply by reference: more than {DEEPEST} levels")
        self._amounts[key] = Amount(0, 0, 0)
        elements, (marks, curves) = 1, own_of(element)
        target = self._target_of(element)
        for child in element.children if target is None else [*element.children, target]:
            if child.children or child.tag == "use":
                inner, more, bent = self._check_amount(child, depth + 1)
            else:
                inner, (more, bent) = 1, own_of(child)
            elements, marks, curves = elements + inner, marks + more, curves + bent
            if elements > MOST_ELEMENTS or marks > MOST_MARKS or curves > MOST_CURVES:
                refuse_amount(elements, marks, child)
        self._amounts[key] = Amount(elements, marks, curves)
        return self._amounts[key]

    def _target_of(self, element: Element) -> Element | None:
        """What a `use` refers to, in this file; None for what refers to nothing that is in it."""
        if element.tag != "use":
            return None
        link = element.attributes.get("href", element.attributes.get(f"{XLINK}{MARK}href", "")).strip()
        return self._by_id.get(link[1:]) if link.startswith("#") else None

    # -- the walk --------------------------------------------------------------------------------------------------

    def _visit(self, element: Element, below: Below) -> None:
        """Take in an element and what is in it; where something is wrong with it that is noted, and it left out."""
        if MARK in element.tag or element.tag in SILENT:
            return
        if self._share < 1.0 and element.tag in DRAWS and self._chance.random() > self._share:
            return
        properties = {**below.properties, **self._sheet.properties_of(element)}
        if properties.pop("display", "") == "none":
            return
        if element.tag not in GROUPS and element.tag not in DRAWS:
            self._drawing.left_out[WORDS.get(element.tag, element.tag)] += 1
            return
        if any(key.endswith(DIMENSION) for key in element.attributes):
            self._drawing.left_out["dimension"] += 1
            return
        self._note_unheard(element)
        try:
            said = said_by(element)
            matrix = below.matrix
            if "transform" in element.attributes:
                matrix = matrix.after(_transform_of(element))
            if element.tag in GROUPS:
                state = replace(below, matrix=matrix, properties=properties)
                self._enter(element, _handed_down(element, state, said), said)
            elif is_pivot(element):
                if below.compound is None:
                    self._drawing.left_out["pivot outside of a group"] += 1
            elif properties.get("visibility", "visible") == "visible":
                self._draw(element, matrix, properties, below, said)
        except SceneError:  # of what has been noted within it, which is enough
            raise
        except ValueError as error:
            self._drawing.faults.add_words(str(element), str(error))

    def _enter(self, element: Element, state: Below, said: Said) -> None:
        """Take in what is in a group, or what is referred to."""
        children = element.children
        if element.tag == "use":
            target = self._target_of(element)
            if target is None:
                self._drawing.left_out["reference to what is not in the drawing"] += 1
                return
            state = _placed(element, target, state)
            children = target.children if target.tag == "symbol" else [target]
        elif element.tag == "svg":
            state = _placed(element, element, state)
        marks = [child for child in children if is_pivot(child)]
        pivot = said.options.get("pivot")
        if len(marks) > 1:
            raise ValueError(f"must turn about one place, but {marks[1]} is a second circle that says so")
        if marks and pivot is None:
            pivot = _center_of(marks[0], state.viewport)
        if pivot is not None:
            state = self._compound(element, state, said, pivot)
        for child in children:
            self._visit(child, state)

    def _compound(self, element: Element, state: Below, said: Said, pivot: Vector) -> Below:
        """The state within a group with a pivot, whose bodies are parts of one."""
        if state.compound is not None:
            raise ValueError(f"{said.written.get('pivot', 'pivot')}: {state.compound.where} has one, and this is in it")
        moving = {key: value for key, value in state.options.items() if key in keywords.MOVING}
        parts: list[Body] = []
        moving["pivot"] = state.matrix.place(pivot)
        body = Body(element, state.name, moving, {**state.written, **said.written}, parts=parts)
        state.bodies.append(body)
        surface = {key: value for key, value in state.options.items() if key not in keywords.MOVING}
        return replace(state, bodies=parts, options=surface, compound=body)

    def _draw(self, element: Element, matrix: Matrix, properties: dict[str, str], below: Below, said: Said) -> None:
        """Add the body of an element that draws an outline."""
        filled = is_painted(properties.get("fill", "black"))
        if not filled and not is_painted(properties.get("stroke", "none")) and not said.options:
            return
        if properties.get("fill", "").startswith("url("):
            self._drawing.left_out["gradient or pattern"] += 1
        outlines = [moved(outline, matrix) for outline in outlines_of(element, below.viewport)]
        if is_nothing(outlines):
            if said.options:
                raise ValueError(f"draws nothing: it needs {NEEDS[element.tag]}, and no transform that scales it to 0")
            self._drawing.left_out[f"{element.tag} without a size"] += 1
            return
        options = {**below.options, **said.options} if said.options else below.options
        if "pivot" in options:
            options = {**options, "pivot": matrix.place(options["pivot"])}
        written, own = self._keys_of(said)
        if below.written:
            written = {**below.written, **written}
        keywords.check_signs(options, written)
        below.bodies.append(Body(element, said.name or below.name, options, written, own, outlines, filled))

    def _keys_of(self, said: Said) -> tuple[dict[str, str], frozenset[str]]:
        """How the options of an element are written, and their names: the same objects where these are the same."""
        same = tuple(said.written.items())
        if same not in self._keys:
            self._keys[same] = said.written, frozenset(said.options)
        return self._keys[same]

    def _note_unheard(self, element: Element) -> None:
        """Count what an element has that is passed over."""
        attributes = element.attributes
        style = attributes.get("style", "")
        if "url(" not in style and UNHEARD.keys().isdisjoint(attributes):
            return
        for attribute, word in UNHEARD.items():
            if attributes.get(attribute, "").startswith("url(") or f"{attribute}:url(" in style:
                self._drawing.left_out[word] += 1


def _handed_down(element: Element, below: Below, said: Said) -> Below:
    """The state within an element, with what it says."""
    if not said.options:
        return replace(below, name=said.name or below.name)
    written = {key: f"{place} of {element}" for key, place in said.written.items()}
    options = {**below.options, **said.handed_down()}
    return replace(below, options=options, written={**below.written, **written}, name=said.name or below.name)


def _transform_of(element: Element) -> Matrix:
    """The transform that an element has; raises `ValueError`, which begins with the attribute."""
    text = element.attributes.get("transform")
    if text is None:
        return Matrix()
    try:
        return transform(text)
    except ValueError as error:
        raise ValueError(f"transform: {error}") from None


def _center_of(mark: Element, viewport: Vector) -> Vector:
    """The centre of a circle, as the group that it is in has it."""
    return _transform_of(mark).place((length(mark, "cx", viewport[0]), length(mark, "cy", viewport[1])))


def _placed(element: Element, target: Element, state: Below) -> Below:
    """The state within a `use` or an inner `svg`: at its x and y, and in its own view box if it has one."""
    across, along = state.viewport
    corner = length(element, "x", across), length(element, "y", along)
    if target.tag not in {"svg", "symbol"}:
        return replace(state, matrix=state.matrix.after(Matrix(e=corner[0], f=corner[1])))
    width = length(element, "width", across, length(target, "width", across, across))
    height = length(element, "height", along, length(target, "height", along, along))
    inner = fitting(target, corner, (width, height))
    return replace(state, matrix=state.matrix.after(inner), viewport=_inner_size(inner, (width, height)))


def _inner_size(inner: Matrix, size: Vector) -> Vector:
    """What 100% are within a viewport of a size whose contents are transformed."""
    return size[0] / inner.a, size[1] / inner.d
