"""Parameters by path: `world.gravity`, `balls[0].velocity[1]`, `shapes.left bumper.kick`, set in a scene.

A path begins with `world`, `shapes` or `balls`. Shapes and balls are named by their place, `shapes[3]`, or by their
name, `shapes.left bumper`; a name that several bear means all of them. Then come fields, as scene files have them, and
the places of items in lists.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

from pydantic import ValidationError

from carom.checks import refuse
from carom.errors import InvalidArgument
from carom.scene import Scene
from carom.scene.descriptor import Descriptor
from carom.scene.faults import Faults, path_of
from carom.spelling import hint

#: A place in a scene: names of fields, and places in lists.
Steps: TypeAlias = tuple[str | int, ...]

#: What a path may begin with.
ROOTS = ("world", "shapes", "balls")
_STEP = re.compile(r"\[(\d{1,9})\]|\.(\w+)")


def is_path(name: str) -> bool:
    """Whether a parameter's name is a path into a scene, not the name of a function's argument."""
    return "." in name or "[" in name


def places_of(scene: Scene, path: str) -> list[Steps]:
    """The places in a scene that a path means; raises `InvalidArgument` where there are none."""
    root = next((root for root in ROOTS if re.match(rf"{root}[.\[]", path)), None)
    if root is None:
        raise _fault(path, f"must begin with {' or '.join(ROOTS)}")
    rest = path[len(root) :]
    if root == "world" or rest.startswith("["):
        return [_walked(scene, path, (root,), rest)]
    named = getattr(scene, root)
    # A name may hold dots, so the longest that fits is taken.
    fits = {one.name for one in named if one.name and re.match(rf"\.{re.escape(one.name)}[.\[]", rest)}
    if not fits:
        raise _unnamed(path, root, rest, [one.name for one in named if one.name])
    name = max(fits, key=len)
    places = [place for place, one in enumerate(named) if one.name == name]
    return [_walked(scene, path, (root, place), rest[len(name) + 1 :]) for place in places]


def _unnamed(path: str, root: str, rest: str, names: list[str]) -> InvalidArgument:
    """The error to raise where nothing bears the name that a path begins with."""
    name = rest.removeprefix(".").rpartition(".")[0] or rest.removeprefix(".")
    said = hint(name, names)
    listed = ", ".join(list(dict.fromkeys(names))[:10]) or "none"
    return _fault(path, f"none of the {root} is called {name!r}; {said or f'names are {listed}'}")


def _walked(scene: Scene, path: str, steps: Steps, rest: str) -> Steps:
    """`steps` and those that `rest` names, each of which leads somewhere."""
    thing: Any = scene
    for step in steps:
        thing = thing[step] if isinstance(step, int) else getattr(thing, step)
    while rest:
        found = _STEP.match(rest)
        if found is None:
            raise _fault(path, f"cannot be read from {rest!r} on")
        rest = rest[found.end() :]
        step = int(found[1]) if found[1] else found[2]
        if isinstance(step, int):
            if not isinstance(thing, tuple) or step >= len(thing):
                there = f"there are {len(thing)}" if isinstance(thing, tuple) else "it is no list"
                raise _fault(path, f"{path_of(steps)} has no item {step}: {there}")
            thing = thing[step]
        else:
            thing = _field(path, steps, thing, step)
        steps = (*steps, step)
    if isinstance(thing, Descriptor) or (
        isinstance(thing, tuple) and any(isinstance(one, Descriptor) for one in thing)
    ):
        raise _fault(path, "must lead to a field, like world.gravity")
    return steps


def _field(path: str, steps: Steps, thing: Any, name: str) -> Any:
    """What a descriptor's field holds."""
    known = [field for field in type(thing).model_fields if field != "kind"] if isinstance(thing, Descriptor) else []
    if name not in known:
        said = hint(name, known) or f"there are {', '.join(known) or 'none'}"
        raise _fault(path, f"{path_of(steps)} has no field {name}; {said}")
    return getattr(thing, name)


def with_values(scene: Scene, values: Iterable[tuple[Steps, Any]]) -> Scene:
    """A scene with some values at some places; raises `SceneError` where they cannot stand there together."""
    tree: dict[Any, Any] = {}
    for (*above, last), value in values:
        branch = tree
        for step in above:
            branch = branch.setdefault(step, {})
        branch[last] = value
    return scene.model_copy(update={root: _set(getattr(scene, root), below, (root,)) for root, below in tree.items()})


def _set(thing: Any, tree: Mapping[str | int, Any], steps: Steps) -> Any:
    """A descriptor or a list of a scene with what a tree of values puts below it."""
    if isinstance(thing, tuple):
        items = list(thing)
        for place, below in tree.items():
            item = items[int(place)]
            # A fault's path has the kind of a shape after its place, where pydantic would have put it.
            kind = (item.kind,) if hasattr(item, "kind") else ()
            items[int(place)] = _set(item, below, (*steps, place, *kind)) if isinstance(below, dict) else below
        return tuple(items)
    fields = dict(thing)
    for name, below in tree.items():
        fields[str(name)] = _set(fields[str(name)], below, (*steps, name)) if isinstance(below, dict) else below
    try:
        return type(thing)(**fields)
    except ValidationError as error:
        faults = Faults(type(thing))
        faults.add(error, *steps)
        raise faults.error() from None


def _fault(path: str, words: str) -> InvalidArgument:
    """The error to raise for a path."""
    return InvalidArgument(f"parameters: {path}: {words}")


def check_values(scene: Scene, path: str, places: list[Steps], values: Iterable[Any]) -> None:
    """Raise `InvalidArgument` for the first value that cannot stand at the places of a path, all else as it is."""
    for value in values:
        try:
            with_values(scene, [(steps, value) for steps in places])
        except ValueError as error:
            said = str(error)
            where = "" if said.startswith(f"{path}:") else f"{path}: "
            raise InvalidArgument(f"parameters: {where}{said}") from None


def refuse_path(name: str) -> InvalidArgument:
    """The error to raise for a name that is neither a path nor a scene function's argument."""
    return refuse("parameters", f"must be named by paths that begin with {' or '.join(ROOTS)}", name)
