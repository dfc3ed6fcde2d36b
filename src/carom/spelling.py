"""What is said of a name that nothing bears: a misspelt option, attribute or field, and the name that was meant."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar

from carom.errors import UnknownName

_set = object.__setattr__

T = TypeVar("T", bound=Callable[..., Any])

#: Names that other libraries, or a hurry, have for options and fields of carom's.
_MEANT = {
    "angle": "orientation",
    "angular_speed": "angular_velocity",
    "bounce": "elasticity",
    "bounciness": "elasticity",
    "category": "layer",
    "centre": "center",
    "continuous": "detection",
    "damping": "friction",
    "data": "user",
    "drag": "friction",
    "is_sensor": "sensor",
    "label": "name",
    "limits": "turn_limits",
    "mask": "collides_with",
    "omega": "angular_velocity",
    "p": "position",
    "pos": "position",
    "r": "radius",
    "restitution": "elasticity",
    "shape": "kind",
    "speed": "velocity",
    "spin": "angular_velocity",
    "trigger": "sensor",
    "type": "kind",
    "user_data": "user",
    "v": "velocity",
    "vel": "velocity",
    "weight": "mass",
    "x": "position",
}

#: Where to find what is not asked of the thing that was given it.
_ELSEWHERE = {
    "density": "only balls have a mass, Ball(mass=...)",
    "dt": "it is an argument of World.step and World.run",
    "friction": "balls slide on the table, so it is the world's or a ball's, World(friction=...) or Ball(friction=...)",
    "gravity": "it is the world's, World(gravity=...)",
    "mass": "only balls have one, Ball(mass=...)",
}

#: Characters of a name that is compared with others; a longer one is like none of them.
LONGEST_NAME = 60


def hint(name: str, known: Iterable[str]) -> str:
    """What to say of a `name` that is none of the `known` ones: which was meant, or where to look; "" for neither."""
    if len(name) > LONGEST_NAME:
        return ""
    names = {one.lower(): one for one in known}
    lower = name.lower()
    if _MEANT.get(lower) in names:
        return f"did you mean {_MEANT[lower]}?"
    if lower in _ELSEWHERE and lower not in names:
        return _ELSEWHERE[lower]
    from difflib import get_close_matches  # here, for few programs misspell a name

    near = get_close_matches(lower, names, n=1)
    return f"did you mean {names[near[0]]}?" if near else ""


def _unknown(name: str, what: str, known: list[str]) -> UnknownName:
    """The error to raise for a `name` that is no argument or attribute, which `what` says."""
    said = hint(name, known)
    there_are = f"there are {', '.join(known)}" if known else "there are none"
    return UnknownName(f"{name} is no {what}; {said}{' (' if said else ''}{there_are}{')' if said else ''}")


def spelled(thing: T) -> T:
    """`thing`, a class or function, which from now on refuses keyword arguments that it does not have by their names.

    Its signature, and what type checkers know of it, stay as they are.
    """
    if isinstance(thing, type):
        made: Any = thing
        made.__init__ = _checked(made.__init__, made)
        made._SPELLED = True
        return thing
    checked: Any = _checked(thing, thing)
    return checked  # type: ignore[no-any-return]


def _checked(function: Callable[..., Any], owner: Callable[..., Any]) -> Callable[..., Any]:
    """`function` behind a look at its keyword arguments, which are those in the signature of `owner`."""
    known = frozenset(inspect.signature(owner).parameters)

    @wraps(function)
    def checked(*arguments: Any, **options: Any) -> Any:
        if not known.issuperset(options):
            raise unknown_argument(owner, options)
        return function(*arguments, **options)

    return checked


def unknown_argument(owner: Callable[..., Any], options: Mapping[str, Any]) -> UnknownName:
    """The error to raise where not all `options` are arguments of `owner`; speaks of the first that is none."""
    known = [name for name in inspect.signature(owner).parameters if name not in {"self", "cls"}]
    unknown = next(name for name in options if name not in known)
    return _unknown(unknown, f"argument of {owner.__name__}()", known)


class Spelled:
    """Base of what has the attributes that it has, and takes no others; a user's subclass may have more.

    It holds for classes that are `spelled`, not for what is derived from them.
    """

    __slots__ = ()

    if not TYPE_CHECKING:  # type checkers let any attribute be set where they see this

        def __setattr__(self, name: str, value: Any) -> None:
            kind = type(self)
            if not name.startswith("_") and not hasattr(kind, name) and "_SPELLED" in kind.__dict__:
                raise _unknown(name, f"attribute of a {kind.__name__}", _settable(kind))
            try:
                _set(self, name, value)
            except AttributeError:
                if _can_be_set(inspect.getattr_static(kind, name, None)) or "_SPELLED" not in kind.__dict__:
                    raise
                there_are = ", ".join(_settable(kind))
                raise UnknownName(f"{name} of a {kind.__name__} cannot be set (there are {there_are})") from None


def _settable(kind: type) -> list[str]:
    """The public attributes of a class that can be set, in the order of their names."""
    names = [name for name in dir(kind) if not name.startswith("_")]
    return [name for name in names if _can_be_set(inspect.getattr_static(kind, name))]


def _can_be_set(attribute: object) -> bool:
    """Whether a class's attribute is one that its objects can be given."""
    return attribute.fset is not None if isinstance(attribute, property) else hasattr(type(attribute), "__set__")
