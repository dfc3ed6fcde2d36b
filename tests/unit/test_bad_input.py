"""Bad input is refused by name, with its value, before anything has changed; whatever takes input is found by a walk.

A new argument, settable attribute or method of a public name fails these tests until `BAD` says what it must refuse
and, for a new callable, `GOOD` how to call it rightly.
"""

import inspect
from collections.abc import Callable, Iterator
from functools import partial
from math import inf, nan
from typing import Any, NamedTuple

import pytest

import carom

#: Public names whose walk is elsewhere, or that take no input of the user's.
ELSEWHERE = {
    "draw",
    "study",
    "outlines",
    "World",
    "Worlds",
    "Hits",
    "HitKind",
    "Recorder",
    "Recording",
    "Scene",
    "scenes",
    "Motion",
    "__version__",
    "compile",
}

NO_NUMBERS = [nan, inf, -inf, "1", b"1", None, True, [1.0], 10**400, 1j]
NO_VECTORS = [(nan, 0), (0, inf), (0, -inf), (1,), (1, 2, 3), "ab", None, 5, {1: 2, 3: 4}, {1, 2}, ("1", 2), (True, 2)]
NO_FLAGS = [0, 1, "yes", "", None, 1.0]
NO_MASKS = [-1, 2**32, 1.5, "1", None, True]
NO_NAMES = [5, b"x", ("x",)]
NO_BALLS = [None, 5, carom.Point((0, 0)), carom.Ball]


def _some(values: list[Any]) -> list[Any]:
    """The values without None, where that means something."""
    return [value for value in values if value is not None]


#: What each argument or attribute must refuse; one with an owner's name before it is that owner's alone. Nothing is to
#: be refused by `user`, which is the user's own.
BAD: dict[str, list[Any]] = {
    # any shape
    "elasticity": [*NO_NUMBERS, -1e-9, -1],
    "kick": [*NO_NUMBERS, -1e-9, -1],
    "sensor": NO_FLAGS,
    "can_collide": NO_FLAGS,
    "once": NO_FLAGS,
    "layer": NO_MASKS,
    "collides_with": NO_MASKS,
    "motion": ["dynamic", carom.Motion.DYNAMIC, "Static", None, 0, 3],
    "pivot": _some(NO_VECTORS),
    "angular_velocity": NO_NUMBERS,
    "rotating": NO_FLAGS,
    "turn_limits": [*_some(NO_VECTORS), (1.0, -1.0), (0.5, 1.0), (-1.0, -0.5)],
    "velocity": NO_VECTORS,
    "name": NO_NAMES,
    "user": [],
    # geometry
    "position": NO_VECTORS,
    "start": NO_VECTORS,
    "end": [*NO_VECTORS, (1, 2)],
    "p0": [*NO_VECTORS, (5, 4)],
    "p1": [*NO_VECTORS, (1, 2)],
    "direction": [*_some(NO_VECTORS), (0, 0), (4, 2), (-8, -4)],
    "center": NO_VECTORS,
    "radius": [*NO_NUMBERS, 0, 0.0, -0.0, -1],
    "solid": NO_FLAGS,
    "start_angle": NO_NUMBERS,
    "end_angle": [*NO_NUMBERS, 1.0],
    "angles": [*NO_VECTORS, (1.0, 1.0), (0.0, 1e-320)],
    "mass": [*NO_NUMBERS, 0, -0.0, -1],
    "friction": [*_some(NO_NUMBERS), -1e-9, -1],
    "shapes": [None, 5, [None], [carom.Ball((0, 0), 1)], [carom.Compound([], (0, 0))]],
    "Group.shapes": [None, 5, [], [None], [carom.Ball((0, 0), 1)], [carom.Circle((0, 0), 1, motion="kinematic")]],
    "shape": [None, carom.Ball((0, 0), 1), carom.Compound([], (0, 0))],
    "orientation": NO_NUMBERS,
    # boxes and lines
    "left": [*NO_NUMBERS, 100],
    "bottom": [*NO_NUMBERS, 100],
    "right": NO_NUMBERS,
    "top": NO_NUMBERS,
    "point": NO_VECTORS,
    "gradient": [bad for bad in NO_NUMBERS if bad not in (inf, -inf)],
    "first": NO_VECTORS,
    "second": [*NO_VECTORS, (1, 2)],
    "other": [None, 5, (0, 0, 1, 1)],
    # what shapes are asked
    "p": NO_VECTORS,
    "angle": NO_NUMBERS,
    "ball": NO_BALLS,
    "contact": [None, 5, carom.Ball((0, 0), 1)],
    "restitution": ["Normal", "", None, 1],
    "circle": [None, carom.Point((0, 0)), 5],
    "dt": [*NO_NUMBERS, -1e-9],
    "gravity": NO_VECTORS,
    # helpers
    "a": NO_NUMBERS,
    "v": NO_VECTORS,
    "w": [*NO_VECTORS, (0, 0)],
    "normalize.v": [*NO_VECTORS, (0, 0), (0.0, -0.0)],
    "tolerance": [*_some(NO_NUMBERS), -1e-9],
    "angle_tolerance": [*_some(NO_NUMBERS), -1e-9],
    # where the same name is another thing
    "Compound.pivot": NO_VECTORS,
    "rotate.pivot": NO_VECTORS,
    "Compound.elasticity": [*_some(NO_NUMBERS), -1e-9],
    "Compound.kick": [*_some(NO_NUMBERS), -1e-9],
    "Compound.sensor": _some(NO_FLAGS),
    "Compound.can_collide": _some(NO_FLAGS),
    "Compound.once": _some(NO_FLAGS),
    "Compound.layer": _some(NO_MASKS),
    "Compound.collides_with": _some(NO_MASKS),
    "Group.elasticity": [*_some(NO_NUMBERS), -1e-9],
    "Group.kick": [*_some(NO_NUMBERS), -1e-9],
    "Group.sensor": _some(NO_FLAGS),
    "Group.can_collide": _some(NO_FLAGS),
    "Group.once": _some(NO_FLAGS),
    "Group.layer": _some(NO_MASKS),
    "Group.collides_with": _some(NO_MASKS),
    "Compound.orientation": [*NO_NUMBERS, 2.0, -2.0],
    "rotate.angle": [*NO_NUMBERS, 2.0, -2.0],
    "move_to.dt": [*NO_NUMBERS, 0, -0.0, -1e-9, 1e-320],
    "move_to.orientation": [*_some(NO_NUMBERS), 2.0, -2.0],
    "guard_points.shapes": [None, 5, [None], [carom.Ball((0, 0), 1)]],
}


def contact() -> carom.Contact:
    """A contact to respond to."""
    found = carom.Point((0, 0)).detect(carom.Ball((0, 1), 2))
    assert found is not None
    return found


#: Arguments that are right, for every public constructor, function and method with arguments.
GOOD: dict[str, Callable[[], dict[str, Any]]] = {
    "Aabb": lambda: {"left": 0, "bottom": 0, "right": 2, "top": 2},
    "Arc": lambda: {"center": (1, 2), "radius": 3, "start_angle": 1.0, "end_angle": 2.0},
    "Ball": lambda: {"position": (1, 2), "radius": 3},
    "Circle": lambda: {"center": (1, 2), "radius": 3},
    "Compound": lambda: {"shapes": [carom.Point((3, 4))], "pivot": (0, 0)},
    "Gate": lambda: {"start": (1, 2), "end": (5, 4), "direction": (0, 1)},
    "Group": lambda: {"shapes": [carom.Point((3, 4))]},
    "Line": lambda: {"point": (1, 2), "gradient": 3.0},
    "Point": lambda: {"position": (1, 2)},
    "Segment": lambda: {"start": (1, 2), "end": (5, 4)},
    "angle_to_vector": lambda: {"a": 1.0},
    "compiling": dict,
    "guard_points": lambda: {"shapes": [carom.Segment((0, 0), (1, 1))]},
    "normalize": lambda: {"v": (1, 2)},
    "normalize_angle": lambda: {"a": 1.0},
    "parallel_component": lambda: {"v": (1, 2), "w": (3, 4)},
    "perp": lambda: {"v": (1, 2)},
    "rotate_point": lambda: {"p": (1, 2), "center": (3, 4), "a": 1.0},
    # methods
    "add": lambda: {"shape": carom.Point((1, 2))},
    "at": lambda: {"point": (1, 2)},
    "closest_point": lambda: {"p": (1, 2)},
    "common_tangent": lambda: {"circle": carom.Circle((9, 9), 1)},
    "common_tangents": lambda: {"circle": carom.Circle((9, 9), 1)},
    "contains": lambda: {"p": (1, 2)},
    "detect": lambda: {"ball": carom.Ball((1, 2), 1)},
    "distance": lambda: {"p": (1, 2)},
    "in_sector": lambda: {"p": (1, 2)},
    "including": lambda: {"point": (1, 2)},
    "parameter": lambda: {"point": (1, 2)},
    "Line.intersection": lambda: {"other": carom.Line((0, 0), 1)},
    "move": lambda: {"dt": 0.5},
    "Aabb.overlaps": lambda: {"other": carom.Aabb(0, 0, 1, 1)},
    "move_to": lambda: {"position": (7, 8), "dt": 0.5},
    "respond": lambda: {"contact": contact()},
    "rotate": lambda: {"pivot": (0, 0), "angle": 0.5},
    "set_angles": lambda: {"start_angle": 1.0, "end_angle": 2.0},
    "set_ends": lambda: {"start": (1, 2), "end": (5, 4)},
    "surface_velocity": lambda: {"p": (1, 2)},
    "tangent_points": lambda: {"p": (9, 9)},
    "through": lambda: {"first": (1, 2), "second": (3, 4)},
    "translated": lambda: {"v": (1, 2)},
}

#: Classes whose objects only carom makes: `Contact` by `detect`, `Shape` through its kinds, the others by queries.
MADE_BY_CAROM = {"Aim", "CastHit", "Contact", "Neighbor", "Shape"}


class Case(NamedTuple):
    """A bad value for an argument of a public name (owner "carom") or method, or for an attribute (`called` empty)."""

    owner: str
    called: str
    argument: str
    value: Any

    def __str__(self) -> str:
        shown = "huge" if isinstance(self.value, int) and self.value > 2**40 else repr(self.value)
        return f"{self.owner}.{self.called}:{self.argument}={shown[:30]}"


def bad_values(owner: str, called: str, argument: str) -> list[Any]:
    """What an argument must refuse; fails where nothing says so."""
    for key in (f"{called or owner}.{argument}", argument):
        if key in BAD:
            return BAD[key]
    raise AssertionError(f"BAD does not say what {argument} of {owner}.{called} must refuse")


def good_arguments(owner: str, called: str) -> dict[str, Any]:
    """Arguments that are right; fails where nothing says which."""
    for key in (f"{owner}.{called}", called):
        if key in GOOD:
            return GOOD[key]()
    raise AssertionError(f"GOOD does not say how to call {owner}.{called}")


def parameters(function: Any) -> list[str]:
    """The names of the arguments of a callable."""
    return [name for name in inspect.signature(function).parameters if name != "self"]


def public_things() -> dict[str, Any]:
    """The public classes and functions that take input, by name."""
    things = {name: getattr(carom, name) for name in carom.__all__ if name not in ELSEWHERE | MADE_BY_CAROM}
    return {name: thing for name, thing in things.items() if not issubclass(type(thing), type) or _takes_input(thing)}


def _takes_input(kind: type) -> bool:
    """Whether a class is no exception, whose messages are carom's own."""
    return not issubclass(kind, Exception)


def callable_cases(owner: str, called: str, function: Any) -> Iterator[Case]:
    """The cases of all arguments of one callable."""
    names = parameters(function)
    assert not names or set(good_arguments(owner, called)) <= set(names)
    for name in names:
        yield from (Case(owner, called, name, value) for value in bad_values(owner, called, name))


def member_cases(owner: str, kind: type) -> Iterator[Case]:
    """The cases of the methods and settable attributes of a class."""
    for name in dir(kind):
        member = inspect.getattr_static(kind, name)
        if name.startswith("_"):
            continue
        if isinstance(member, property):
            values = [] if member.fset is None else bad_values(owner, "", name)
            yield from (Case(owner, "", name, value) for value in values)
        elif callable(getattr(kind, name)):
            yield from callable_cases(owner, name, getattr(kind, name))


def all_cases() -> Iterator[Case]:
    """The cases of everything public."""
    for name, thing in public_things().items():
        yield from callable_cases("carom", name, thing)
        if isinstance(thing, type):
            yield from member_cases(name, thing)


def options_of(kind: str) -> dict[str, Any]:
    """Options with which everything about an object of a class can be set."""
    limits = {"turn_limits": (-1.0, 1.0)}
    if kind in {"Point", "Segment", "Gate", "Circle", "Arc"}:
        return {"motion": "kinematic", **limits}
    return limits if kind == "Compound" else {}


def subject(kind: str) -> Any:
    """An object of a class."""
    return getattr(carom, kind)(**good_arguments("carom", kind), **options_of(kind))


def state(thing: Any) -> Any:
    """All that an object knows, to compare before and after."""
    if isinstance(thing, carom.Compound):
        return [state(part) for part in (thing.center_point, *thing.shapes)], dict(thing._surface), thing.name
    if isinstance(thing, carom.Group):
        return [state(part) for part in thing.shapes], dict(thing._surface), thing.name
    if isinstance(thing, carom.Shape | carom.Ball):
        return thing._row.tobytes(), thing.name, getattr(thing, "compound", None)
    return repr(thing)


def names_it(message: str, argument: str, value: Any) -> bool:
    """Whether an error's message begins with the argument's name and shows the value, or the fault in it."""
    parts = list(value) if isinstance(value, tuple | list) else []
    return message.startswith(argument) and any(repr(part) in message for part in [value, *parts])


@pytest.mark.parametrize("case", list(all_cases()), ids=str)
def test_bad_input_is_refused_by_name_and_changes_nothing(case: Case) -> None:
    owner, called, argument, value = case
    if owner == "carom":
        good = good_arguments(owner, called) | options_of(called)
        touched = [thing for given in good.values() for thing in (given if isinstance(given, list) else [given])]
        function = getattr(carom, called)
    else:
        good = good_arguments(owner, called) if called else {}
        touched = [good["contact"].ball if called == "respond" else subject(owner)]
        function = getattr(touched[0], called) if called else partial(set_attribute, touched[0])
    before = [state(thing) for thing in touched]
    with pytest.raises(carom.InvalidArgument) as caught:
        function(**(good | {argument: value}))
    assert names_it(str(caught.value), argument, value)
    assert [state(thing) for thing in touched] == before


def set_attribute(thing: Any, **values: Any) -> None:
    """Set attributes of an object."""
    for name, value in values.items():
        setattr(thing, name, value)


@pytest.mark.parametrize("name", list(public_things()))
def test_good_input_is_taken(name: str) -> None:
    thing = public_things()[name]
    if not isinstance(thing, type):
        thing(**good_arguments("carom", name))
        return
    for method in dir(thing):
        if not method.startswith("_") and callable(getattr(thing, method)):
            arguments = good_arguments(name, method) if parameters(getattr(thing, method)) else {}
            owner = arguments["contact"].ball if method == "respond" else subject(name)
            getattr(owner, method)(**arguments)


def test_the_walk_sees_what_nothing_speaks_of() -> None:
    class Novelty:
        def __init__(self, elasticity: float) -> None: ...

        @property
        def weight(self) -> float:
            return 0.0

        @weight.setter
        def weight(self, value: float) -> None: ...

    with pytest.raises(AssertionError, match=r"weight of Novelty"):
        list(member_cases("Novelty", Novelty))
    with pytest.raises(AssertionError, match=r"how to call carom\.Novelty"):
        list(callable_cases("carom", "Novelty", Novelty))
