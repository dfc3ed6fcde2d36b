"""DXF drawings as bodies: what is in model space, with blocks where they are inserted. The file is read by ezdxf."""

from __future__ import annotations

import re
from collections.abc import Iterable
from io import StringIO
from logging import ERROR, getLogger
from typing import Any

from ezdxf.entities.insert import Insert
from ezdxf.filemanagement import read
from ezdxf.lldxf.const import DXFError
from ezdxf.lldxf.encoding import decode_dxf_unicode

from carom.errors import SceneError
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings import keywords
from carom.scene.drawings.bodies import Body, Drawing
from carom.scene.drawings.counting import check_text
from carom.scene.drawings.entities import DRAWS, disc, discs_of, outlines_of
from carom.scene.drawings.limits import DEEPEST, MOST_ELEMENTS
from carom.scene.drawings.pieces import is_nothing
from carom.scene.drawings.sampling import Sample, some_of
from carom.scene.faults import Faults

#: The application whose extended data hold options, as strings such as `kick=4`.
APPLICATION = "CAROM"
#: Layers on which programs draw what is not to be printed.
NOT_DRAWN = frozenset({"DEFPOINTS"})


class Place:
    """Where an entity is, as a message names it; the line is only looked for when it is asked for."""

    __slots__ = ("_data", "_handle", "_kind", "_layer")

    def __init__(self, entity: Any, data: str) -> None:
        self._kind, self._layer = entity.dxftype(), entity.dxf.layer
        self._handle = entity.dxf.handle
        self._data = data

    def __str__(self) -> str:
        told = f"{self._kind} on layer {self._layer[:60]!r}"
        if self._handle is None:
            return told
        found = re.search(rf"^ *5\s*\n *{self._handle}\s*$", self._data, re.MULTILINE)
        line = f", line {self._data.count(chr(10), 0, found.start()) + 1}" if found else ""
        return f"{told} (handle {self._handle}{line})"


class DxfReader:
    """Reads the text of one drawing into `drawing`."""

    def __init__(self, text: str, drawing: Drawing) -> None:
        self._drawing = drawing
        drawing.where = "the drawing"
        self._text = text
        self._document: Any = _document_of(text)
        self._hidden = {
            layer.dxf.name.upper()
            for layer in self._document.layers
            if layer.is_off() or layer.is_frozen() or layer.dxf.name.upper() in NOT_DRAWN
        }
        self._sizes: dict[str, int] = {}
        self._discs: set[tuple[float, float, float]] = set()

    def read(self) -> None:
        """Take in all that is in the drawing's model space."""
        space = list(self._document.modelspace())
        if sum(self._size_of(entity, 0) for entity in space) > MOST_ELEMENTS:
            raise SceneError(f"a drawing may have at most {MOST_ELEMENTS} entities, those of blocks counted each time")
        self._visit(space, self._drawing.bodies, None, {})

    # -- before anything is drawn ----------------------------------------------------------------------------------

    def _size_of(self, entity: Any, depth: int) -> int:
        """How many entities are drawn for one; raises where there is no end to them."""
        if not isinstance(entity, Insert):
            return 1
        name = entity.dxf.name
        block = self._document.blocks.get(name)
        if block is None:
            return 1
        if entity.dxf.get("zscale", 1.0) == 0.0:
            entity.dxf.zscale = 1.0  # as flat programs write, and ezdxf cannot turn
        if name not in self._sizes:
            self._sizes[name] = -1
            if depth > DEEPEST:
                raise SceneError(f"{Place(entity, self._text)}: nested too deeply: more than {DEEPEST} levels")
            self._sizes[name] = sum(self._size_of(part, depth + 1) for part in block)
        if self._sizes[name] < 0:
            raise SceneError(f"{Place(entity, self._text)}: block {name[:60]!r} is inserted in itself, without end")
        size = 1 + self._sizes[name] * max(1, entity.mcount)
        if size > MOST_ELEMENTS:
            raise SceneError(f"{Place(entity, self._text)}: draws more than {MOST_ELEMENTS} entities")
        return size

    # -- the walk --------------------------------------------------------------------------------------------------

    def _visit(self, entities: Iterable[Any], bodies: list[Body], above: str | None, options: dict[str, Any]) -> None:
        """Take in entities; those on layer 0 of a block are on the layer that it is inserted on."""
        listed = list(entities)
        self._discs |= {disc for entity in listed if entity.dxftype() == "HATCH" for disc in discs_of(entity)}
        for entity in listed:
            kind = entity.dxftype()
            layer = above if above is not None and entity.dxf.layer == "0" else entity.dxf.layer
            if layer.upper() in self._hidden or entity.dxf.get("invisible", 0):
                continue
            try:
                name, own, written = self._said_by(entity, layer)
                if kind == "INSERT":
                    self._insert(entity, bodies, layer, name, {**options, **own}, written)
                elif kind in DRAWS:
                    self._draw(entity, bodies, name, {**options, **own}, written)
                elif kind not in {"HATCH", "ATTDEF", "VIEWPORT"} or (kind == "HATCH" and not discs_of(entity)):
                    self._drawing.left_out[kind.lower()] += 1
            except SceneError:  # of what has been noted within it, which is enough
                raise
            except (ValueError, DXFError, ArithmeticError) as error:
                self._drawing.faults.add_words(str(Place(entity, self._text)), str(error))

    def _said_by(self, entity: Any, layer: str) -> tuple[str | None, dict[str, Any], dict[str, str]]:
        """The name of an entity and its options: those in its layer's name, and over them those in its data."""
        name, labelled = keywords.labelled("layer", decode_dxf_unicode(layer))
        said = [(f"layer {key}", key, text) for key, text in labelled]
        if entity.has_xdata(APPLICATION):
            lines = [str(tag.value) for tag in entity.get_xdata(APPLICATION) if tag.code == 1000]
            for line in lines:
                words, listed = keywords.labelled(APPLICATION, line)
                if words:
                    raise ValueError(f"{APPLICATION}: {words[:60]!r}: {keywords.WRITTEN}")
                said += [(f"{APPLICATION} {key}", key, text) for key, text in listed]
        options: dict[str, Any] = {}
        written: dict[str, str] = {}
        for place, key, text in said:
            try:
                known, value = keywords.of_shape(key, text)
            except ValueError as error:
                raise ValueError(f"{place}: {error}") from None
            options[known] = value
            written[known] = place
        name = options.pop("name", None) or (name if layer != "0" else "")
        return name.encode("utf-8", "replace").decode() or None, options, written

    def _insert(
        self,
        entity: Any,
        bodies: list[Body],
        layer: str,
        name: str | None,
        options: dict[str, Any],
        written: dict[str, str],
    ) -> None:
        """Take in a block where it is inserted: as a compound where it is to move, about its base point."""
        if self._document.blocks.get(entity.dxf.name) is None:
            self._drawing.left_out["insert of a block that is not in the drawing"] += 1
            return
        if 0.0 in {entity.dxf.xscale, entity.dxf.yscale}:
            raise ValueError("must not be scaled to nothing: its xscale and yscale must not be 0")
        copies = entity.multi_insert() if entity.mcount > 1 else [entity]
        moves = "pivot" in options or any(options.get(key) for key in keywords.MOVING)
        surface = {key: value for key, value in options.items() if key not in keywords.MOVING | {"pivot"}}
        for copy in copies:
            if copy.attribs:
                self._drawing.left_out["attribute"] += len(copy.attribs)
            parts = bodies
            if moves:
                moving = {key: value for key, value in options.items() if key in keywords.MOVING}
                base = copy.dxf.insert
                moving["pivot"] = options.get("pivot") or (float(base.x), float(base.y))
                body = Body(Place(entity, self._text), name, moving, written, parts=[])
                bodies.append(body)
                parts = body.parts or []
                body.parts = parts
            self._visit(copy.virtual_entities(skipped_entity_callback=self._skipped), parts, layer, surface)

    def _skipped(self, entity: Any, _: str) -> None:
        """Count what ezdxf cannot transform."""
        self._drawing.left_out[entity.dxftype().lower()] += 1

    def _draw(
        self, entity: Any, bodies: list[Body], name: str | None, options: dict[str, Any], written: dict[str, str]
    ) -> None:
        """Add the body of an entity that draws an outline."""
        kind = entity.dxftype()
        outlines = outlines_of(entity)
        if outlines is None:
            self._drawing.left_out[f"{kind.lower()} in space"] += 1
            return
        if is_nothing(outlines):
            if written:
                raise ValueError("draws nothing: it needs a size")
            self._drawing.left_out[f"{kind.lower()} without a size"] += 1
            return
        filled = kind == "CIRCLE" and disc(outlines[0][0]) in self._discs
        bodies.append(
            Body(
                Place(entity, self._text), name, options, written, frozenset(written), outlines, filled, kind == "POINT"
            )
        )


# -- files -------------------------------------------------------------------------------------------------------------


def _document_of(text: str) -> Any:
    """The document that ezdxf reads from a text; raises `SceneError`."""
    log = getLogger("ezdxf")
    level = log.level
    # What it warns of says nothing to who plays the drawing, and may be a line for each entity.
    log.setLevel(ERROR)
    try:
        return read(StringIO(text))
    except (DXFError, OSError, ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise SceneError(f"is no DXF that can be read: {error or type(error).__name__}") from None
    finally:
        log.setLevel(level)


def sample_of(text: str) -> Sample | None:
    """Some of the bodies of a drawing, where it has so many curves that all take long."""
    some = some_of(text)
    if some is None:
        return None
    drawing = Drawing(Faults(WorldDescriptor))
    DxfReader(some.text, drawing).read()
    return Sample(drawing, some.share, some.size)


def text_of(data: bytes) -> str:
    """The text of a DXF file, whose encoding stands in its header; raises `SceneError`."""
    if data.startswith(b"AutoCAD Binary DXF"):
        raise SceneError("is a binary DXF; it must be saved as text (ASCII)")
    found = re.search(rb"\$DWGCODEPAGE\s+3\s+(\S+)", data[:100_000])
    version = re.search(rb"\$ACADVER\s+1\s+AC(\d+)", data[:100_000])
    # From AC1021 on it is UTF-8, whatever the header says.
    page = "utf-8"
    if found and version and int(version[1]) < 1021:
        page = found[1].decode("ascii", "replace").lower().replace("ansi_", "cp").replace("dos", "cp")
    try:
        text = data.decode(page, "surrogateescape")
    except (LookupError, UnicodeError):  # of a page that there is not
        text = data.decode("cp1252", "replace")
    text = text.replace("\r\n", "\n")
    check_text(text)
    return text
