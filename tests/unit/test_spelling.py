"""Misspelt names are refused by name, with the one that was meant, wherever a name is taken."""

import enum
import inspect
import pickle
from collections.abc import Callable, Iterator
from copy import deepcopy
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import carom
import carom.draw
from carom.study import plots

#: What only carom makes, and what NumPy, `enum` or `typing` have a constructor for.
MADE_BY_CAROM = {"Aim", "CastHit", "Contact", "Neighbor", "Cell", "Partition"}
#: Arrays, whose methods are NumPy's.
ARRAYS = (np.ndarray,)


def public(module: ModuleType) -> Iterator[tuple[str, Any]]:
    """The public classes and functions of a module."""
    names = getattr(module, "__all__", None) or [
        name for name, thing in vars(module).items() if getattr(thing, "__module__", "") == module.__name__
    ]
    for name in names:
        if not name.startswith("_") and callable(getattr(module, name)):
            yield name, getattr(module, name)


def makes_itself(kind: type) -> bool:
    """Whether users call a class to make an object, and carom says how."""
    foreign = issubclass(kind, (Exception, enum.Enum, *ARRAYS)) or getattr(kind, "_is_protocol", False)
    return not foreign and kind.__name__ not in MADE_BY_CAROM


def has_options(function: Callable[..., Any]) -> bool:
    """Whether some argument of a function may be left out, so that a misspelt one would not be missed."""
    return any(one.default is not one.empty for one in inspect.signature(function).parameters.values())


def callables() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Every public constructor, and every public function and method with arguments that may be left out."""
    for module in (carom, carom.draw, carom.scenes, plots):
        for name, thing in public(module):
            if not isinstance(thing, type):
                if has_options(thing):
                    yield name, thing
            elif makes_itself(thing):
                if thing is not carom.Scene and inspect.signature(thing).parameters:
                    yield name, thing
                for method, function in inspect.getmembers(thing, callable):
                    if not method.startswith("_") and "carom" in (function.__module__ or "") and has_options(function):
                        yield f"{name}.{method}", function


CALLABLES = dict(callables())


def test_the_walk_sees_every_kind_of_callable() -> None:
    seen = {"World", "Segment", "Aabb", "Recorder", "guard_points", "World.add_balls", "World.ray_cast", "Recording.of"}
    assert seen | {"gas", "picture_of", "Film", "energy", "Ball.respond"} <= set(CALLABLES)


def misspelt(name: str) -> str:
    """A name with two of its letters in each other's place, or one too many."""
    return name[:-2] + name[-1] + name[-2] if len(name) > 3 and name[-1] != name[-2] else f"{name}{name[-1]}"


def cases() -> Iterator[Any]:
    """Every argument of every callable."""
    for called, function in CALLABLES.items():
        for name in inspect.signature(function).parameters:
            if name not in {"self", "a", "p", "v", "names"}:  # too short, or beside `name`
                yield pytest.param(function, name, id=f"{called}:{name}")


@pytest.mark.parametrize(("function", "name"), list(cases()))
def test_a_misspelt_argument_is_named_with_the_one_that_was_meant(function: Callable[..., Any], name: str) -> None:
    wrong = misspelt(name)
    with pytest.raises(carom.UnknownName) as caught:
        function(**{wrong: 1})
    message = str(caught.value)
    assert message.startswith(f"{wrong} is no argument of {function.__name__}(); did you mean {name}? (there are ")
    assert "_fill" not in message


@pytest.mark.parametrize(("called", "function"), CALLABLES.items(), ids=CALLABLES)
def test_an_unknown_argument_is_refused_with_those_there_are(called: str, function: Callable[..., Any]) -> None:
    with pytest.raises(carom.UnknownName) as caught:
        function(zzqzz=1)
    known = [name for name in inspect.signature(function).parameters if name != "self"]
    assert str(caught.value) == f"zzqzz is no argument of {function.__name__}(); there are {', '.join(known)}"
    for family in (carom.InvalidArgument, ValueError, TypeError, AttributeError):
        assert isinstance(caught.value, family)


@pytest.mark.parametrize(("called", "function"), CALLABLES.items(), ids=CALLABLES)
def test_signatures_stay_those_that_were_written(called: str, function: Callable[..., Any]) -> None:
    parameters = inspect.signature(function).parameters.values()
    assert [one.name for one in parameters if one.kind in {one.VAR_KEYWORD, one.VAR_POSITIONAL}] == []
    assert inspect.getdoc(function)
    method = function if not isinstance(function, type) else function.__init__
    assert method.__qualname__.split(".")[-1] in {"__init__", called.split(".")[-1]}


@pytest.mark.parametrize("make", [carom.Segment, carom.Gate])
def test_friction_is_looked_for_where_it_is(make: Callable[..., Any]) -> None:
    with pytest.raises(
        carom.UnknownName, match=r"friction is no argument of .*World\(friction=...\) or Ball\(friction"
    ):
        make((0, 0), (1, 0), friction=0.3)
    with pytest.raises(carom.UnknownName, match=r"restitution is no argument of .* did you mean elasticity"):
        make((0, 0), (1, 0), restitution=0.3)


# -- attributes --------------------------------------------------------------------------------------------------------

SUBJECTS: dict[str, Callable[[], Any]] = {
    "World": carom.World,
    "Point": lambda: carom.Point((1, 2)),
    "Segment": lambda: carom.Segment((1, 2), (3, 4)),
    "Gate": lambda: carom.Gate((1, 2), (3, 4)),
    "Circle": lambda: carom.Circle((1, 2), 3),
    "Arc": lambda: carom.Arc((1, 2), 3, 0, 1),
    "Ball": lambda: carom.Ball((1, 2), 3),
    "Compound": lambda: carom.Compound([], (0, 0)),
    "Group": lambda: carom.Group([carom.Point((1, 2))]),
}


def attributes(thing: Any, settable: bool) -> list[str]:
    """The public attributes of an object that can be set, or those that cannot."""
    found = []
    for name in dir(type(thing)):
        member = inspect.getattr_static(type(thing), name)
        if not name.startswith("_") and not callable(member) and not isinstance(member, staticmethod | classmethod):
            can = member.fset is not None if isinstance(member, property) else hasattr(type(member), "__set__")
            if can is settable:
                found.append(name)
    return found


@pytest.mark.parametrize(
    ("kind", "name"),
    [(kind, name) for kind, make in SUBJECTS.items() for name in attributes(make(), True) if name not in {"p0", "p1"}],
)
def test_a_misspelt_attribute_is_named_with_the_one_that_was_meant(kind: str, name: str) -> None:
    thing, wrong = SUBJECTS[kind](), misspelt(name)
    with pytest.raises(carom.UnknownName, match=f"^{wrong} is no attribute of a {kind}; did you mean {name}"):
        setattr(thing, wrong, 1)
    assert not hasattr(thing, wrong)


@pytest.mark.parametrize(
    ("kind", "name"), [(kind, name) for kind, make in SUBJECTS.items() for name in attributes(make(), False)]
)
def test_what_cannot_be_set_says_so(kind: str, name: str) -> None:
    thing = SUBJECTS[kind]()
    with pytest.raises(carom.UnknownName, match=f"^{name} of a {kind} cannot be set"):
        setattr(thing, name, 1)


@pytest.mark.parametrize("kind", SUBJECTS)
def test_subclasses_of_a_users_take_attributes_as_python_classes_do(kind: str) -> None:
    made = type("Own", (getattr(carom, kind),), {})
    thing = made.__new__(made)
    made.__init__(thing, **{name: deepcopy(getattr(SUBJECTS[kind](), name)) for name in required(kind)})
    thing.gravty = 3
    assert thing.gravty == 3


def required(kind: str) -> list[str]:
    """The arguments without which an object of a class cannot be made."""
    parameters = inspect.signature(getattr(carom, kind)).parameters.values()
    return [one.name for one in parameters if one.default is one.empty]


def test_the_error_can_be_pickled() -> None:
    with pytest.raises(carom.UnknownName) as caught:
        carom.World().gravty = 3  # type: ignore[attr-defined]
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


# -- scenes ------------------------------------------------------------------------------------------------------------


def tables(scene: carom.Scene) -> Iterator[tuple[str, type, Callable[[dict[str, Any], str], None]]]:
    """The kinds of tables of a scene: a path, the model, and what puts a field there in a scene's table."""
    shapes = list(scene.shapes)
    yield "", carom.Scene, lambda table, name: table.update({name: 1})
    yield "world.", type(scene.world), lambda table, name: table["world"].update({name: 1})
    yield "balls[0].", type(scene.balls[0]), lambda table, name: table["balls"][0].update({name: 1})
    for place, shape in enumerate(shapes):

        def put(table: dict[str, Any], name: str, place: int = place) -> None:
            table["shapes"][place][name] = 1

        yield f"shapes[{place}].", type(shape), put
    part = shapes[-1].shapes[0]
    yield (
        f"shapes[{len(shapes) - 1}].shapes[0].",
        type(part),
        lambda table, name: table["shapes"][-1]["shapes"][0].update({name: 1}),
    )


SCENE = carom.Scene(
    world={"gravity": (0, -1)},
    shapes=[
        *(make() for kind, make in SUBJECTS.items() if kind not in {"World", "Ball", "Compound", "Group"}),
        carom.Compound([carom.Circle((0, 0), 1)], (0, 0)),
    ],
    balls=[carom.Ball((0, 0), 1)],
)


def scene_cases() -> Iterator[Any]:
    """Every field of every kind of table in a scene."""
    for path, model, put in tables(SCENE):
        for name in model.model_fields:  # type: ignore[attr-defined]
            yield pytest.param(path, name, put, id=f"{path}{name}")


@pytest.mark.parametrize(("path", "name", "put"), list(scene_cases()))
def test_a_misspelt_field_is_a_fault_that_names_the_one_that_was_meant(path: str, name: str, put: Any) -> None:
    table = SCENE.plain()
    put(table, misspelt(name))
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(**table)
    assert str(caught.value) == f"{path}{misspelt(name)}: is unknown; did you mean {name}?"


def test_type_is_kind(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text('version = 1\n[world]\nsubstep = 8\n[[shapes]]\ntype = "segment"\nstart = [0, 0]\nend = [1, 0]\n')
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene.load(path)
    assert [line.strip() for line in str(caught.value).splitlines()[1:]] == [
        "world.substep: is unknown; did you mean substeps?",
        "shapes[0].type: is unknown; did you mean kind?",
    ]


def test_what_is_meant_is_known_somewhere() -> None:
    from carom import spelling

    known = {name for function in CALLABLES.values() for name in inspect.signature(function).parameters} | {"kind"}
    known |= {name for make in SUBJECTS.values() for name in attributes(make(), True)}
    assert set(spelling._MEANT.values()) <= known
