"""Bodies as descriptors of shapes, compounds and balls.

A drawing may have a hundred thousand pieces with the same few options. So options are checked once, on a descriptor
with a geometry that nothing can be wrong with, and all pieces with the same options are copies of it with their own.
What any positive number is right for is not even that: such options may be others for every piece.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, inf, pi
from typing import Any

from pydantic import ValidationError

from carom.errors import InvalidArgument
from carom.scene.descriptor import Descriptor
from carom.scene.descriptors import BallDescriptor
from carom.scene.drawings import keywords
from carom.scene.drawings.bodies import Body
from carom.scene.drawings.curves import chains_of, fitted
from carom.scene.drawings.pieces import Conic, Piece, Straight, Vector
from carom.scene.faults import Faults
from carom.scene.shape_descriptors import CompoundDescriptor, GateDescriptor
from carom.shapes.outlines.curves import Chain
from carom.spelling import hint

#: A geometry for each kind that every option may be checked with.
_SAMPLES: dict[str, dict[str, Any]] = {
    "point": {"position": (0.0, 0.0)},
    "segment": {"start": (0.0, 0.0), "end": (1.0, 0.0)},
    "circle": {"center": (0.0, 0.0), "radius": 1.0},
    "arc": {"center": (0.0, 0.0), "radius": 1.0, "start_angle": 0.0, "end_angle": 1.0},
    "ball": {"position": (0.0, 0.0), "radius": 1.0},
}
#: Bodies whose curves are fitted at once: with more it is hardly quicker, and takes more memory.
AT_ONCE = 32_000
#: Checked options that are kept: a drawing whose pieces have more different ones checks some of them again.
MOST_SAMPLES = 1000
#: Options for which every positive number is right.
_FREE = keywords.NOT_NEGATIVE | keywords.POSITIVE
#: What tells what a body is, and is no field of a descriptor.
_TELLS = frozenset({"ball", "kind"})

Made = list[tuple[str, dict[str, Any]]]


class Shaper:
    """Makes the descriptors of all bodies of a drawing, and notes what is wrong with them."""

    def __init__(self, faults: Faults, tolerance: float) -> None:
        self.shapes: list[Descriptor] = []
        self.balls: list[Descriptor] = []
        self._faults = faults
        self._tolerance = tolerance
        self._samples: dict[Any, Descriptor] = {}
        self._chains: dict[int, Chain] = {}

    def add_all(self, bodies: list[Body]) -> None:
        """Make the descriptors of bodies, their curves fitted some thousands at once, and let go of each body."""
        while bodies:
            some = bodies[:AT_ONCE]
            del bodies[:AT_ONCE]
            self._chains = chains_of(_pieces_in(some), self._tolerance)
            some.reverse()
            while some:
                self._add(some.pop())

    def _add(self, body: Body) -> None:
        """Make the descriptors of a body."""
        try:
            if body.parts is not None:
                self._refuse_balls(body, body.parts)
                self._add_compound(body, [part for below in body.parts for part in self._parts_of(below)])
            elif body.options.get("ball"):
                self.balls += self._parts_of(body)
            else:
                self._add_shapes(body)
            body.outlines = []  # what was made of them is enough to keep
        except _Refused as refused:
            for words in refused.words:
                self._faults.add_words(str(refused.where), words)

    def _add_shapes(self, body: Body) -> None:
        """Make the shapes of a body, or the compound that it is where it has a pivot and more than one piece."""
        made = self._made(body)
        moving = [key for key in keywords.MOVING if body.options.get(key)]
        if len(made) < 2 or not (moving or "pivot" in body.options):
            self.shapes += self._described(body, made, body.options)
        elif "pivot" in body.options:
            surface = {key: value for key, value in body.options.items() if key not in keywords.MOVING | {"pivot"}}
            self._add_compound(body, self._described(body, made, surface))
        else:
            raise _Refused(
                body.where,
                f"{body.written[min(moving)]}: needs a pivot too, such as {_as_in(body, 'pivot', '10 20')}, for it is "
                f"{len(made)} pieces that move as one",
            )

    def _add_compound(self, body: Body, parts: list[Any]) -> None:
        """Make a compound."""
        fields = CompoundDescriptor.model_fields
        said = body.options.items()
        moving = {key: value for key, value in said if key in fields and key in keywords.MOVING | {"pivot"}}
        try:
            self.shapes.append(CompoundDescriptor(name=body.name, shapes=tuple(parts), **moving))
        except ValidationError as error:
            raise self._refused(body, error) from None

    def _refuse_balls(self, body: Body, parts: list[Body]) -> None:
        """Raise for balls in a group that turns about a pivot."""
        for part in parts:
            if part.options.get("ball"):
                words = f"{part.written['ball']}: a ball is no part of what moves as one; move it out of {body.where}"
                raise _Refused(part.where, words)

    def _parts_of(self, body: Body) -> list[Descriptor]:
        """The descriptors of a body's pieces."""
        return self._described(body, self._made(body), body.options)

    # -- geometry --------------------------------------------------------------------------------------------------

    def _made(self, body: Body) -> Made:
        """The kind and the geometry of each piece of a body."""
        whole = [piece for outline in body.outlines for piece in outline if isinstance(piece, Conic) and piece.whole]
        kind = "ball" if body.options.get("ball") else body.options.get("kind")
        if body.point or kind in {"ball", "point"}:
            if len(body.outlines) != 1 or not whole or not whole[0].round:
                raise _Refused(
                    body.where, f"{body.written.get('ball', body.written.get('kind', 'kind'))}: is for circles"
                )
            center, radius = whole[0].center, whole[0].radius
            return (
                [("ball", {"position": center, "radius": radius})]
                if kind == "ball"
                else [("point", {"position": center})]
            )
        try:
            made = [
                one
                for outline in body.outlines
                for piece in outline
                for one in self._geometry(piece, filled=body.filled)
            ]
        except InvalidArgument as error:
            raise _Refused(body.where, str(error)) from None
        if kind == "gate":
            if any(one != "segment" for one, _ in made):
                raise _Refused(body.where, f"{body.written['kind']}: a gate is straight")
            return [("gate", geometry) for _, geometry in made]
        return made

    def _geometry(self, piece: Piece, *, filled: bool) -> Made:
        """The kinds and the geometry of what stands for a piece."""
        if isinstance(piece, Straight):
            return [("segment", {"start": piece.start, "end": piece.end})]
        if not isinstance(piece, Conic) or not piece.round:
            return fitted(piece, self._tolerance, self._chains.pop(id(piece), None))
        if piece.whole:
            return [("circle", {"center": piece.center, "radius": piece.radius, "solid": filled})]
        begin, end = _angle(piece.center, piece.start), _angle(piece.center, piece.end)
        (ux, uy), (vx, vy) = piece.u, piece.v
        if (ux * vy - uy * vx > 0.0) != (piece.sweep > 0.0):
            begin, end = end, begin
        geometry = {"center": piece.center, "radius": piece.radius, "start_angle": begin, "end_angle": end}
        return [("arc", geometry)]

    # -- descriptors -----------------------------------------------------------------------------------------------

    def _described(self, body: Body, made: Made, options: dict[str, Any]) -> list[Descriptor]:
        """The descriptors of the pieces of a body."""
        described = []
        known: dict[str, tuple[Descriptor | None, dict[str, Any]]] = {}
        for kind, geometry in made:
            if kind not in known:
                given = {**self._given(body, kind, options), "name": body.name}
                sample = None if kind == "gate" else self._sample(body, kind, given)
                known[kind] = sample, (given if sample is None else {**vars(sample), **given})
            sample, fields = known[kind]
            if sample is None:  # a gate, whose direction is checked against its geometry
                described.append(self._checked(body, GateDescriptor, {**geometry, **fields}))
            else:
                filled = {"solid": options["solid"]} if kind == "circle" and "solid" in options else {}
                described.append(_copied(sample, {**fields, **geometry, **filled}))
        return described

    def _given(self, body: Body, kind: str, options: dict[str, Any]) -> dict[str, Any]:
        """Those of the options that a kind of piece has; raises where the body's own are others."""
        fields = _model_of(kind).model_fields
        for key in body.own - _TELLS:
            if key in options and key not in fields:
                said = hint(key, fields) or f"there are {', '.join(sorted(set(fields) - keywords.DRAWN - {'kind'}))}"
                raise _Refused(body.where, f"{body.written[key]}: is nothing that a {kind} has; {said}")
        return {key: value for key, value in options.items() if key in fields and key != "kind"}

    def _sample(self, body: Body, kind: str, given: dict[str, Any]) -> Descriptor:
        """A descriptor whose options are checked: as they are given, but for the name and the values of free ones."""
        settled = {key: value for key, value in given.items() if key != "name" and not _is_free(key, value)}
        same = (kind, *given, *sorted(settled.items()))
        sample = self._samples.get(same)
        if sample is None:
            if len(self._samples) == MOST_SAMPLES:
                self._samples.clear()
            table = {**_SAMPLES[kind], **given}
            del table["name"]
            sample = self._samples[same] = self._checked(body, _model_of(kind), table)
        return sample

    def _checked(self, body: Body, model: type[Descriptor], table: dict[str, Any]) -> Descriptor:
        """The descriptor that a table makes."""
        try:
            return model(**table)
        except ValidationError as error:
            raise self._refused(body, error) from None

    def _refused(self, body: Body, error: ValidationError) -> _Refused:
        """What is wrong with a body's options, each by the name that it has in the drawing."""
        found = Faults(CompoundDescriptor)
        found.add(error)
        told = []
        for words in found.first:
            key, mark, rest = words.partition(":")
            told.append(f"{body.written[key]}:{rest}{_remedy(body, key)}" if mark and key in body.written else words)
        return _Refused(body.where, *told)


def _remedy(body: Body, key: str) -> str:
    """What may be missing where an option that moves a shape is refused: what makes it a ball, or turns its group."""
    if key not in keywords.MOVING or not body.options.keys().isdisjoint({"ball", "motion", "pivot"}):
        return ""
    if key not in body.own:
        return f"; what moves as one needs {_as_in(body, 'pivot', '10 20')}, or in it a circle labelled pivot"
    circle = len(body.outlines) == 1 and all(isinstance(piece, Conic) and piece.whole for piece in body.outlines[0])
    return f"; a ball says {_as_in(body, 'ball', 'true')}" if circle and key == "velocity" else ""


def _as_in(body: Body, key: str, text: str) -> str:
    """An option as a body's drawing would write it: as an attribute, or as a word of a label or of extended data."""
    attribute = any(place.startswith(keywords.PREFIX) for place in body.written.values())
    return f'{keywords.PREFIX}{key}="{text}"' if attribute else f"{key}={text.replace(' ', ',')}"


class _Refused(Exception):
    """A body that cannot be made: where it is, and what is wrong with it."""

    def __init__(self, where: object, *words: str) -> None:
        super().__init__(where, *words)
        self.where = where
        self.words = words


def _pieces_in(bodies: list[Body]) -> Iterator[Piece]:
    """All pieces of bodies and of their parts."""
    for body in bodies:
        for part in body.parts if body.parts is not None else (body,):
            for outline in part.outlines:
                yield from outline


def _model_of(kind: str) -> type[Descriptor]:
    """The descriptor of a kind of piece."""
    return BallDescriptor if kind == "ball" else keywords.SHAPES[kind]


def _is_free(key: str, value: Any) -> bool:
    """Whether the value of an option is right, whatever the others are."""
    return key in _FREE and 0.0 < value < inf


def _copied(sample: Descriptor, fields: dict[str, Any]) -> Descriptor:
    """A copy of a descriptor with other fields: as `model_copy` makes it, which takes 8 µs."""
    copy = sample.__class__.__new__(sample.__class__)
    object.__setattr__(copy, "__dict__", fields)
    for field in ("__pydantic_fields_set__", "__pydantic_extra__", "__pydantic_private__"):
        object.__setattr__(copy, field, getattr(sample, field))
    return copy


def _angle(center: Vector, place: Vector) -> float:
    """The direction of a place as seen from a centre, from 0 to 2π."""
    return atan2(place[1] - center[1], place[0] - center[0]) % (2.0 * pi)
