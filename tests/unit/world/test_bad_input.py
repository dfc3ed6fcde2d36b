"""Bad input to a world is refused by name, with its value, before anything has changed; found by a walk.

A new setting, method or argument of `World` fails these tests until `BAD` says what it must refuse and, for a method,
`GOOD` how to call it rightly.
"""

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import carom
from carom.world.settings import SETTINGS, Setting
from tests.unit.test_bad_input import (
    NO_FLAGS,
    NO_MASKS,
    NO_NUMBERS,
    NO_VECTORS,
    Case,
    names_it,
    parameters,
    set_attribute,
)
from tests.worlds import crowded, quiet

pytestmark = pytest.mark.filterwarnings("ignore:World.overlaps:DeprecationWarning")  # the old name is walked too

INF, NAN = float("inf"), float("nan")

NO_COUNTS = [0, -1, 2**40, 1.0, 2.5, "1", None, True, NAN, [1]]
NO_SIZES = [*NO_NUMBERS, -1e-9, -1]
NO_ARRAYS = [NAN, INF, "1", None, True, 1j, {}, [[1, 2], [3]], ..., [None], ["1"], [True, True], 10**400]

NO_PLACES = [NAN, INF, "1", None, True, {}, ..., (NAN, 0), (0, INF), (1, 2, 3), [(1, NAN)], [(1, 2, 3)]]


def each_alone(values: list[Any]) -> list[Any]:
    """Values for an argument that takes any number: each by itself, and behind one that is right."""
    return [*([value] for value in values), *([carom.Point((1, 2)), value] for value in values)]


BAD: dict[str, list[Any]] = {
    # settings
    "gravity": NO_VECTORS,
    "detection": ["Discrete", "", None, 0, b"discrete"],
    "substeps": NO_COUNTS,
    "iterations": NO_COUNTS,
    "broad_phase": ["sweep", "Grid", None, 1],
    "levels": [*NO_COUNTS, 17],
    "restitution": ["Normal", "elastic", None, 1],
    "friction": NO_SIZES,
    "sleep_speed": NO_SIZES,
    "sleep_time": NO_SIZES,
    "rest_speed": [bad for bad in NO_SIZES if bad is not None],
    "max_speed": [bad for bad in NO_SIZES if bad is not None] + [0, 0.0],
    "max_impacts": [bad for bad in NO_COUNTS if bad is not None],
    "bounds": [5, "abcd", (1, 2, 3), (NAN, 0, 1, 1), (2, 0, 1, 1), (0, 2, 1, 1), {1, 2, 3, 4}, {1: 1}, (0, 0, INF, 1)],
    "remove_strays": NO_FLAGS,
    # methods
    "add.shapes": each_alone([None, 5, "wall", carom.Segment, (0, 0), carom.World(), [carom.Point((0, 0))]]),
    "remove.shapes": each_alone([None, 5, "wall", carom.Ball((0, 0), 1), carom.Compound([], (0, 0)), quiet().balls[0]]),
    "position": [*NO_ARRAYS, 5, (1, 2), [(1, 2, 3)], [(1, NAN)], [(0, INF)], np.zeros((2, 2, 2))],
    "velocity": [*NO_ARRAYS, (1, 2, 3), [(1, 2)] * 3, [(NAN, 0), (0, 0)]],
    "radius": [*NO_ARRAYS, 0, -1, -0.0, [1, 2, 3], [1, 0], [[1, 1]]],
    "mass": [*NO_ARRAYS, 0, -1, [1, 2, 3], [1, -1], [1, INF]],
    "elasticity": [*NO_ARRAYS, -1, -1e-9, [1, 2, 3], [0, -1]],
    "add_balls.friction": [*(bad for bad in NO_ARRAYS if bad is not None), -2, -1e-9, [1, 2, 3], [0, -0.5]],
    "add_balls.layer": [*NO_MASKS, [1, 2, 3], [1, -1], [1, 2**32], [1.0, 2.0], [[1, 1]], [True, True], ["1"], 2**70],
    "add_balls.collides_with": [*NO_MASKS, [1, 2, 3], [1, -1], [1, 2**32], [1.0, 2.0], [[1, 1]], [True, True], ["1"]],
    "sensor": [*NO_FLAGS, [True] * 3, [0, 1], [[True, True]], ["yes", "no"], [1.0, 0.0], NAN],
    "can_collide": [*NO_FLAGS, [True] * 3, [0, 1], [[True, True]], ["yes", "no"], [1.0, 0.0], NAN],
    "member_id": [0, 10**6, -1, 1.0, "1", None, True, 2**70],
    "dt": NO_SIZES,
    "run.dt": [*NO_SIZES, 0, 0.0],
    "seconds": [*NO_SIZES, 1e308],
    "progress": [5, "bar", [], True],
    "until": [0, -1, 1.5, True, 2**70, "nowhere", b"x", [1], carom.Point((0, 0)), carom.Ball((0, 0), 1), NAN],
    "until_each": [0, -1, 1.5, True, 2**70, "all", [1]],
    "keep": ["All", "", None, 1, True],
    "snapshot": [None, 5, "text", b"", b"carom snapshot 1\n", [1]],
    # queries
    "origin": NO_PLACES,
    "target": NO_PLACES,
    "center": NO_PLACES,
    "point": NO_PLACES,
    "direction": [*NO_PLACES, (0, 0)],
    "circle_cast.radius": [NAN, INF, "1", None, True, -1],
    "aabb": [None, 5, "abcd", (1, 2, 3)],
    "ball": [None, 5, "ball", carom.Ball((0, 0), 1), carom.Point((0, 0))],
    "layer": [-1, 2**32, 1.5, "1", None, True],
    "collides_with": [-1, 2**32, 1.5, "1", None, True],
    "sensors": NO_FLAGS,
}

GOOD: dict[str, Callable[[carom.World], dict[str, Any]]] = {
    "add": lambda world: {"shapes": [carom.Point((1, 2)), carom.Ball((3, 4), 0.5)]},
    "remove": lambda world: {"shapes": [world.balls[0], world.shapes[0]]},
    "add_balls": lambda world: {"position": [(1, 2), (3, 4)], "radius": 0.5},
    "object": lambda world: {"member_id": world.balls[0].id},
    "step": lambda world: {"dt": 0.1},
    "run": lambda world: {"seconds": 0.2, "dt": 0.1},
    "restore": lambda world: {"snapshot": world.snapshot()},
    "ray_cast": lambda world: {"origin": (0, 0), "target": (1, 2)},
    "circle_cast": lambda world: {"center": (0, 0), "radius": 0.5, "target": (1, 2)},
    "nearest": lambda world: {"point": (1, 2)},
    "overlapping": lambda world: {"aabb": carom.Aabb(0, 0, 1, 1)},
    "contacts": lambda world: {},
    "overlaps": lambda world: {},
    "aim": lambda world: {"ball": world.balls[0], "direction": (1, 2)},
}


def bad_values(called: str, argument: str) -> list[Any]:
    """What an argument must refuse; fails where nothing says so."""
    for key in (f"{called}.{argument}", argument):
        if key in BAD:
            return BAD[key]
    raise AssertionError(f"BAD does not say what {argument} of World.{called} must refuse")


def good_arguments(called: str, world: carom.World) -> dict[str, Any]:
    """Arguments that are right; fails where nothing says which."""
    assert called in GOOD, f"GOOD does not say how to call World.{called}"
    return GOOD[called](world)


def methods(kind: type) -> list[str]:
    """The public methods of a class that take arguments."""
    names = [name for name in dir(kind) if not name.startswith("_")]
    called = [name for name in names if inspect.isfunction(inspect.getattr_static(kind, name))]
    return [name for name in called if parameters(getattr(kind, name))]


def attributes(kind: type) -> list[str]:
    """What can be set on objects of a class."""
    found = {name: inspect.getattr_static(kind, name) for name in dir(kind) if not name.startswith("_")}
    return [
        name
        for name, value in found.items()
        if isinstance(value, Setting) or (isinstance(value, property) and value.fset is not None)
    ]


def all_cases(kind: type) -> Iterator[Case]:
    """The cases of everything that a world takes."""
    for name in parameters(kind.__init__):
        yield from (Case("carom", kind.__name__, name, value) for value in bad_values(kind.__name__, name))
    for name in attributes(kind):
        yield from (Case(kind.__name__, "", name, value) for value in bad_values("", name))
    for called in methods(kind):
        for name in parameters(getattr(kind, called)):
            yield from (Case(kind.__name__, called, name, value) for value in bad_values(called, name))


@pytest.fixture(scope="module")
def world() -> carom.World:
    """A world that nothing must change."""
    return crowded()


@pytest.mark.parametrize("case", list(all_cases(carom.World)), ids=str)
def test_bad_input_is_refused_by_name_and_changes_nothing(world: carom.World, case: Case) -> None:
    owner, called, argument, value = case
    before = world.snapshot()
    with pytest.raises(carom.CaromError) as caught:
        give(world, owner, called, argument, value)
    assert isinstance(caught.value, ValueError)
    message = str(caught.value)
    assert names_it(message, argument, value) or message.startswith(told_name(argument)), message
    assert world.snapshot() == before


def give(world: carom.World, owner: str, called: str, argument: str, value: Any) -> None:
    """Give a value to a constructor, a method or an attribute."""
    if owner == "carom":
        carom.World(**{argument: value})
    elif called:
        call(world, called, good_arguments(called, world) | {argument: value})
    else:
        set_attribute(world, **{argument: value})


def call(world: carom.World, called: str, arguments: dict[str, Any]) -> None:
    """Call a method, `shapes` being its arguments without a name."""
    named = {name: value for name, value in arguments.items() if name != "shapes"}
    getattr(world, called)(*arguments.get("shapes", []), **named)


def told_name(argument: str) -> str:
    """How messages begin that name a place in an argument, or what is wrong with something too long to show."""
    return {"shapes": "shape", "member_id": "id", "bounds": "bounds: ", "snapshot": "snapshot"}.get(
        argument, f"{argument}["
    )


@pytest.mark.parametrize("called", methods(carom.World))
def test_good_input_is_taken(called: str) -> None:
    world = crowded(balls=2)
    call(world, called, good_arguments(called, world))


def test_the_settings_are_the_attributes_that_can_be_set() -> None:
    assert set(SETTINGS) == set(attributes(carom.World)) == set(parameters(carom.World.__init__))


def test_the_walk_sees_what_nothing_speaks_of() -> None:
    class Novelty:
        def __init__(self, gravity: float) -> None: ...

        def fold(self, corner: float) -> None: ...

    with pytest.raises(AssertionError, match=r"corner of World\.fold"):
        list(all_cases(Novelty))
    with pytest.raises(AssertionError, match=r"how to call World\.fold"):
        good_arguments("fold", carom.World())


@pytest.mark.parametrize("given", [{}, {"radius": None}])
def test_a_radius_must_be_given(given: dict[str, Any]) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"^radius must be numbers"):
        carom.World().add_balls([(0, 0)], **given)


def test_the_message_about_long_arrays_is_short() -> None:
    places = np.zeros((100_000, 2))
    places[77_777, 1] = NAN
    for given in (places, places.tolist()):
        with pytest.raises(carom.InvalidArgument, match=r"^position\[77777, 1\] must be finite, not nan$"):
            carom.World().add_balls(given, radius=1)
    with pytest.raises(carom.InvalidArgument) as caught:
        carom.World().add_balls(places.ravel().tolist(), radius=1)
    assert len(str(caught.value)) < 1100
