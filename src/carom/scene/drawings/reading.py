"""A drawing as the table of a scene: read, joined, fitted and named."""

from __future__ import annotations

import gc
import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from math import isnan
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

from pydantic import ValidationError

from carom.checks import positive
from carom.errors import DrawingWarning, InvalidArgument, SceneError
from carom.extras import needed
from carom.limits import LONGEST_FILE
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings.bodies import Body, Drawing
from carom.scene.drawings.joints import joined, size_of, smoothed
from carom.scene.drawings.limits import ENOUGH_FAULTS, FARTHEST, MOST_ARCS, SURE
from carom.scene.drawings.pieces import Piece, arcs_of, is_bare
from carom.scene.drawings.shaping import Shaper
from carom.scene.faults import Faults

if TYPE_CHECKING:
    from carom.scene.drawings.sampling import Sample

#: The endings of drawings.
ENDINGS = (".svg", ".dxf")
#: The share of a drawing's size by which a curve may be off, unless it is said.
TOLERANCE = 1e-3
#: The share of the tolerance within which a piece is no more than a place, and no piece.
BARE = 1e-6


class Reading(NamedTuple):
    """What a drawing says: the table of its scene, apart from it the checked shapes and balls, and the tolerance."""

    table: dict[str, Any]
    lists: dict[str, tuple[Any, ...]]
    tolerance: float


def is_drawing(path: Any) -> bool:
    """Whether a path is that of a drawing, by its ending."""
    return isinstance(path, (str, os.PathLike)) and Path(path).suffix.lower() in ENDINGS


def read_drawing(path: str | os.PathLike[str], tolerance: float | None = None) -> Reading:
    """The scene that a drawing shows.

    What in it was not understood is told once, by a `DrawingWarning`. Raises `SceneError` with all that is wrong in it,
    each with the element and the line that it is in.
    """
    with _without_collector():
        return _read(path, tolerance)


def _read(path: str | os.PathLike[str], tolerance: float | None) -> Reading:
    """The scene that a drawing shows."""
    faults = Faults(WorldDescriptor, ENOUGH_FAULTS)
    drawing = Drawing(faults)
    kept = _read_into(drawing, path, tolerance)
    if kept is not None:
        if tolerance is not None:
            said = "is for drawings that others made; this picture keeps its scene"
            raise InvalidArgument(f"tolerance {tolerance!r}: {said}")
        return Reading(kept, {}, 0.0)
    bodies = _parts_in(drawing)
    size = size_of([outline for body in bodies for outline in body.outlines])
    if not size <= FARTHEST:
        _refuse_far(bodies, faults)
    scene: dict[str, Any] = {
        key: drawing.world.pop(key) for key in ("name", "guard", "tolerance") if key in drawing.world
    }
    said = scene.pop("tolerance", TOLERANCE * size)
    used = said if tolerance is None else positive("tolerance", tolerance)
    if size > 0.0 and used <= 0.0:
        faults.add_words(str(drawing.where), f"data-carom-tolerance: must be positive, not {used}")
        used = TOLERANCE * size
    if used > 0.0:
        _refuse_many(bodies, used)
    _join([body for body in drawing.bodies if body.parts is None], used)
    for body in drawing.bodies:
        if body.parts:
            _join(body.parts, used)
    del bodies  # so that each can be let go
    shaper = Shaper(faults, used)
    shaper.add_all(drawing.bodies)
    world = _world(drawing)
    if faults.count:
        raise faults.error()
    _tell(path, drawing, empty=not (shaper.shapes or shaper.balls))
    lists = {"shapes": tuple(shaper.shapes), "balls": tuple(shaper.balls)}
    return Reading({"guard": True, **scene, "world": world}, lists, used)


def _read_into(drawing: Drawing, path: str | os.PathLike[str], tolerance: float | None) -> dict[str, Any] | None:
    """Take in a file, once the package that it needs is there; the table of the scene that is kept in it, if one is."""
    if Path(path).suffix.lower() == ".dxf":
        needed("ezdxf", "ezdxf", "drawings", "DXF drawings")
        from carom.scene.drawings.dxf import DxfReader, sample_of, text_of

        text = text_of(data_of(path))
        _refuse_sampled(sample_of(text), tolerance)
        DxfReader(text, drawing).read()
        return None
    needed("svgelements", "svgelements", "drawings", "SVG drawings")
    from carom.scene.drawings.svg import SvgReader

    reader = SvgReader(data_of(path), drawing)
    kept = reader.kept_scene()
    if kept is None:
        _refuse_sampled(reader.sample(), tolerance)
        reader.read()
        reader.let_go()
    return kept


def _refuse_far(bodies: list[Body], faults: Faults) -> NoReturn:
    """Raise for the bodies that are too large for a scene, or have places that are no numbers."""
    large = f"is too large: a drawing may be at most {FARTHEST:g} wide and high"
    before = faults.count
    for body in bodies:
        size = size_of(body.outlines)
        if not size <= FARTHEST:
            faults.add_words(str(body.where), "has a coordinate that is no number" if isnan(size) else large)
    if faults.count == before:
        faults.add_words("the drawing", large)
    raise faults.error()


def _parts_in(drawing: Drawing) -> list[Body]:
    """The bodies of a drawing, of compounds their parts."""
    return [part for body in drawing.bodies for part in (body.parts if body.parts is not None else [body])]


def _refuse_sampled(sample: Sample | None, tolerance: float | None) -> None:
    """Raise where some of a drawing says that all of it would surely become too many arcs."""
    if sample is None:
        return
    bodies = _parts_in(sample.drawing)
    used = tolerance
    if used is None:
        size = max(sample.page, size_of([outline for body in bodies for outline in body.outlines]))
        used = sample.drawing.world.get("tolerance", TOLERANCE * size)
    if not used > 0.0:
        return
    arcs = sum(arcs_of(piece, used) for body in bodies for outline in body.outlines for piece in outline)
    if arcs > SURE * MOST_ARCS * sample.share:
        raise SceneError(
            f"{sample.drawing.where}: the curves need about {arcs / sample.share:.2g} arcs at a tolerance of "
            f"{used:.3g}: a drawing may have at most {MOST_ARCS}, and a larger tolerance needs fewer"
        )


def _refuse_many(bodies: list[Body], tolerance: float) -> None:
    """Raise where curves would become too many arcs: at the body with the one that is too many."""
    arcs = 0.0
    for body in bodies:
        arcs += sum(arcs_of(piece, tolerance) for outline in body.outlines for piece in outline)
        if arcs > MOST_ARCS:
            raise SceneError(
                f"{body.where}: the curves up to here need more than {MOST_ARCS} arcs at a tolerance of "
                f"{tolerance:.3g}: a drawing may have no more, and a larger tolerance needs fewer"
            )


def _tell(path: str | os.PathLike[str], drawing: Drawing, *, empty: bool) -> None:
    """Warn of what was left out, all of it in one line, the most frequent first, and of a scene without anything."""
    kinds = ", ".join(f"{word} ({count})" for word, count in drawing.left_out.most_common())
    words = [f"not understood, and left out: {kinds}"] if kinds else []
    if empty:
        words.append("there is nothing in it that is seen and can be met")
    if words:
        warnings.warn(f"{os.fspath(path)}: {'; '.join(words)}", DrawingWarning, stacklevel=5)


def data_of(path: str | os.PathLike[str]) -> bytes:
    """The bytes of a file; raises `SceneError`."""
    try:
        with Path(path).open("rb") as file:
            data = file.read(LONGEST_FILE + 1)
    except OSError as error:
        raise SceneError(f"cannot be read: {error.strerror}") from None
    if len(data) > LONGEST_FILE:
        raise SceneError(f"is longer than {LONGEST_FILE} bytes")
    return data


def _join(bodies: list[Body], tolerance: float) -> None:
    """Bring the ends of bodies together that belong together, and make what is nearly smooth smooth."""
    rows: list[tuple[Body, list[Piece]]] = []
    for body in bodies:
        for outline in body.outlines:
            bare = [is_bare(piece, BARE * tolerance) for piece in outline]
            if any(bare):
                outline = [piece for piece, is_none in zip(outline, bare, strict=True) if not is_none]
            rows.append((body, outline))
        body.outlines = []
    outlines = smoothed(joined([outline for _, outline in rows], tolerance), tolerance)
    for (body, _), outline in zip(rows, outlines, strict=True):
        body.outlines.append(outline)


def _world(drawing: Drawing) -> WorldDescriptor:
    """The settings of the world; a fault is told by the name of its attribute."""
    try:
        return WorldDescriptor(**drawing.world)
    except ValidationError as error:
        found = Faults(WorldDescriptor)
        found.add(error)
        for words in found.first:
            drawing.faults.add_words(str(drawing.where), f"data-carom-{words}")
        return WorldDescriptor()


@contextmanager
def _without_collector() -> Iterator[None]:
    """A while without the search for garbage: a drawing is read as a million objects, none of which is any."""
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            if gc.get_freeze_count() == 0:
                # What was made counts as old from now on, for the search for young garbage would go through all of it.
                # Where some are frozen, as Python 3.12 does at its start, they are to stay so.
                gc.freeze()
                gc.unfreeze()
            gc.enable()
