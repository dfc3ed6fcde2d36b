"""Scenes: a world and what is in it, as one frozen description that files hold and worlds are built from."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Self

from pydantic import BaseModel, ValidationError

from carom.checks import refuse
from carom.errors import InvalidArgument, SceneError
from carom.pictured import Pictured
from carom.scene.balls import add_balls, described_balls
from carom.scene.capture import described_world
from carom.scene.descriptor import Descriptor
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings.reading import ENDINGS, is_drawing, read_drawing
from carom.scene.faults import Faults, field_of, is_elsewhere, is_unknown
from carom.scene.fields import Text, Version
from carom.scene.files import Plain, path_of, read_plain, write_plain
from carom.scene.guarding import guarded
from carom.scene.lists import LISTS, BallList, ShapeList, checked_list, crowd
from carom.spelling import spelled

if TYPE_CHECKING:
    from carom.world.world import World

VERSION = 1


class Scene(Descriptor, Pictured):
    """A world's settings, shapes and balls, as they stand at the beginning.

    `Scene(world=…, shapes=[…], balls=[…])` takes descriptors, tables as they stand in a file, and shapes and balls
    themselves, whose state it copies (all but `user`). With `guard=True` the world gets the points that bare ends need.
    A scene cannot be changed. A mistake raises `SceneError`, which lists every fault with its path.
    """

    version: Version
    """The version of the file's form: 1."""
    name: Text | None = None
    """What the scene is called."""
    guard: bool = False
    """Whether the world gets the points that bare ends need."""
    world: WorldDescriptor = WorldDescriptor()
    """The world's settings."""
    shapes: ShapeList = ()
    """The shapes and compounds, in the order in which they are added."""
    balls: BallList = ()
    """The balls, likewise."""

    def __init__(self, /, **fields: Any) -> None:
        self._fill({"version": VERSION} | fields)

    def _fill(self, table: Plain, checked: Mapping[str, tuple[Any, ...]] = MappingProxyType({})) -> None:
        """Set the fields to what `table` holds, or raise `SceneError` with all that is wrong in it.

        Lists of descriptors that are known to be good are given apart, as `checked`.
        """
        wrong = crowd(table)
        if wrong:
            raise SceneError(wrong)
        in_lists = {field: Faults(type(self)) for field in LISTS}
        given = {field: table[field] for field in LISTS if isinstance(table.get(field), (list, tuple))}
        lists = {field: checked_list(field, items, in_lists[field]) for field, items in given.items()}
        faults, unknown = Faults(type(self)), Faults(type(self))
        if isinstance(table.get("world"), dict) and (wrong := crowd(table["world"])):
            faults.add_words("world", wrong)
            table = table | {"world": {}}
        try:
            BaseModel.__init__(self, **{name: value for name, value in table.items() if name not in lists})
        except ValidationError as error:
            faults.add(error, unless=lambda details: is_unknown(details) or field_of(details) in LISTS)
            for field, found in in_lists.items():  # one that is no list is told in its place among them
                found.add(error, unless=partial(is_elsewhere, field))
            unknown.add(error, unless=lambda details: not is_unknown(details))
        faults.join(*in_lists.values(), unknown)
        if faults.count:
            raise faults.error()
        # They are checked, and checking them once more would build all shapes again.
        self.__dict__.update(lists | dict(checked))
        self.__pydantic_fields_set__.update(lists, checked)

    @classmethod
    @spelled
    def load(cls, path: str | os.PathLike[str], tolerance: float | None = None) -> Self:
        """The scene in a `.toml` or `.json` file, or that a drawing shows, an `.svg` or `.dxf` file.

        Of a drawing, ellipses, Bézier curves and splines become tangent arcs no farther off than `tolerance`, by
        default a thousandth of the drawing's size; ends nearer than it are joined. What is no part of a scene, such as
        text, is left out with a `DrawingWarning`. Raises `SceneError` with the file's name and every fault in it.
        """
        path = path_of(path)
        drawn = is_drawing(path)
        if tolerance is not None and not drawn:
            raise refuse("tolerance", f"is for drawings, {' and '.join(ENDINGS)}", tolerance)
        table = {} if drawn else read_plain(path)
        scene = cls.__new__(cls)
        try:
            if drawn:
                read = read_drawing(path, tolerance)
                scene._fill({"version": VERSION, **read.table}, read.lists)
            else:
                scene._fill(table)
        except SceneError as error:
            raise SceneError(f"{path}: {error}") from None
        return scene

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a `.toml` or `.json` file that loads as the same scene, bit for bit.

        The file is complete or as it was before, whatever happens. Raises `SceneError` where it cannot be written.
        """
        write_plain(path, self.plain())

    def build(self) -> World:
        """A new world with the scene's settings, shapes (those that guard after those they guard) and balls."""
        from carom.world.world import World  # here, so that scenes can be read and checked without a compiler

        try:
            world = World(**self.world.settings())
        except InvalidArgument as error:
            raise SceneError(f"world: {error}") from None
        shapes = [descriptor.build() for descriptor in self.shapes]
        world.add(*(guarded(shapes) if self.guard else shapes))
        add_balls(world, self.balls)
        return world

    @classmethod
    def from_world(cls, world: World) -> Self:
        """A scene of `world` as it stands now: settings, shapes and balls, without time, ids, passing and sleep.

        What `move_to` has sent somewhere rests where it is: the rest of its way is left out.
        """
        from carom.world.world import World

        if not isinstance(world, World):
            raise refuse("world", "must be a World", world)
        return cls(world=described_world(world), shapes=list(world.shapes), balls=described_balls(world))

    @classmethod
    def json_schema(cls) -> Plain:
        """The JSON Schema of scene files, for editors that complete and check them."""
        schema = cls.model_json_schema()
        for definition in schema["$defs"].values():
            if "kind" in definition["properties"]:
                definition["required"].insert(0, "kind")  # a file must say it, whatever its default is in Python
        return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
