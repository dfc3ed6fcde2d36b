"""Every field of every descriptor: the names and defaults of what it describes, and no bad value gets in."""

import inspect
from typing import Any

import pytest
from pydantic import BaseModel

import carom
from carom.scene.descriptor import Descriptor
from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.shape_descriptors import PART_IS_SILENT_ON, CompoundDescriptor, GroupDescriptor, ShapeDescriptor
from carom.world.settings import SETTINGS
from tests.unit.scene.shortest import SHAPES

NOT_TEXT = (3, 1.5, True, ["a"], b"a", "\ud800")
NOT_A_SWITCH = (0, 1, "true", None, [True])
NOT_A_NUMBER = ("1", True, None, [1.0], float("nan"), float("inf"), float("-inf"), 10**400)
NOT_POSITIVE = (*NOT_A_NUMBER, 0, 0.0, -1.0)
NEGATIVE = (*NOT_A_NUMBER, -1, -1e-300)
NOT_A_PAIR = (None, 1.0, "12", [1.0], [1, 2, 3], {"x": 1, "y": 2}, {1.0, 2.0}, ["1", 2], [True, 2], [float("nan"), 0])
NOT_A_COUNT = (0, -1, 1.0, "4", True, 2**31)
NOT_LAYERS = (-1, 2**32, 1.0, "1", True)
NOT_A_LIST = (None, 3, "shapes", {"kind": "point"}, [3], [None], [{}], [{"kind": "blob"}], [{"kind": 3}])


def but_none(values: tuple[Any, ...]) -> tuple[Any, ...]:
    """The values but None, which an optional field takes."""
    return tuple(value for value in values if value is not None)


#: By field: values that none of the descriptors that have it may take.
BAD: dict[str, tuple[Any, ...]] = {
    "version": (None, 0, 2, "1", 1.5),
    "name": NOT_TEXT,
    "guard": NOT_A_SWITCH,
    "world": (None, 3, "world", [1]),
    "shapes": NOT_A_LIST,
    "balls": NOT_A_LIST,
    "gravity": NOT_A_PAIR,
    "detection": (None, 3, "fast", "Discrete"),
    "substeps": (*NOT_A_COUNT, 1_000_001),
    "iterations": (*NOT_A_COUNT, 1_000_001),
    "broad_phase": (None, 3, "tree"),
    "levels": (*NOT_A_COUNT, 17),
    "restitution": (None, 3, "half"),
    "friction": NEGATIVE,
    "balls[0].friction": but_none(NEGATIVE),
    "sleep_speed": NEGATIVE,
    "sleep_time": NEGATIVE,
    "rest_speed": but_none(NEGATIVE),
    "max_speed": but_none(NOT_POSITIVE),
    "max_impacts": NOT_A_COUNT,
    "bounds": (3, "box", [1, 2, 3], [2, 0, 1, 1], [0, 2, 1, 1], [0, 0, float("nan"), 1], [0, 0, "1", 1]),
    "remove_strays": NOT_A_SWITCH,
    "elasticity": but_none(NEGATIVE),
    "kick": but_none(NEGATIVE),
    "sensor": but_none(NOT_A_SWITCH),
    "can_collide": but_none(NOT_A_SWITCH),
    "layer": NOT_LAYERS,
    "collides_with": NOT_LAYERS,
    "motion": (None, 1, "dynamic", "Static"),
    "pivot": but_none(NOT_A_PAIR),
    "orientation": NOT_A_NUMBER,
    "angular_velocity": NOT_A_NUMBER,
    "rotating": NOT_A_SWITCH,
    "turn_limits": (*but_none(NOT_A_PAIR), [1.0, -1.0], [0.5, 1.0]),
    "velocity": NOT_A_PAIR,
    "kind": (None, 3, "ball", "blob"),
    "position": NOT_A_PAIR,
    "start": NOT_A_PAIR,
    "end": (*NOT_A_PAIR, [0.0, 0.0]),
    "center": NOT_A_PAIR,
    "radius": NOT_POSITIVE,
    "solid": NOT_A_SWITCH,
    "start_angle": NOT_A_NUMBER,
    "end_angle": (*NOT_A_NUMBER, 0.0),
    "direction": (*but_none(NOT_A_PAIR), [0.0, 0.0], [2.0, 0.0]),
    "mass": NOT_POSITIVE,
}

BALL = {"position": [5, 5], "radius": 0.5}


def scene_with(place: str, table: dict[str, Any]) -> dict[str, Any]:
    """The fields of a scene in which `table` stands at `place`."""
    if place == "":
        return table
    return {"world": table} if place == "world" else {place.removesuffix("[0]"): [table]}


def faults(error: carom.SceneError) -> list[str]:
    """The lines of a message, without the heading that says how many there are."""
    heading, *lines = str(error).split("\n  ")
    return lines or [heading]


def tables() -> list[tuple[type[BaseModel], str, dict[str, Any]]]:
    """Every descriptor with the place where it stands in a scene and the shortest table for it."""
    models = {model.model_fields["kind"].default: model for model in ShapeDescriptor.__subclasses__()}
    models |= {"compound": CompoundDescriptor, "group": GroupDescriptor}
    shapes = [(models[kind], "shapes[0]", table) for kind, table in SHAPES.items()]
    return [(carom.Scene, "", {}), (WorldDescriptor, "world", {}), (BallDescriptor, "balls[0]", BALL), *shapes]


def fields() -> list[Any]:
    """Every field of every descriptor."""
    return [
        pytest.param(place, table, field, id=f"{model.__name__}.{field}")
        for model, place, table in tables()
        for field in model.model_fields
    ]


def leaves(model: type[BaseModel]) -> set[type[BaseModel]]:
    """The descriptors that are not there to be derived from."""
    below = model.__subclasses__()
    return {model} if not below else set().union(*(leaves(child) for child in below))


def test_no_descriptor_is_forgotten_here() -> None:
    of_scenes = {model for model in leaves(Descriptor) if model.__module__.startswith("carom.scene.")}
    assert {model for model, _, _ in tables()} == of_scenes


@pytest.mark.parametrize(("place", "table", "field"), fields())
def test_bad_values_are_refused_with_their_path(place: str, table: dict[str, Any], field: str) -> None:
    assert carom.Scene(**scene_with(place, table))
    path = f"{place}.{field}".lstrip(".")
    motion = {"motion": "kinematic"} if field in (*PART_IS_SILENT_ON[:5], "pivot") and place == "shapes[0]" else {}
    motion = {} if table.get("kind") in {"compound", "group"} else motion
    for value in BAD.get(path, BAD.get(field, [])):
        with pytest.raises(carom.SceneError, match=r"must|is missing") as caught:
            carom.Scene(**scene_with(place, table | motion | {field: value}))
        assert all(line.startswith(path) for line in faults(caught.value)), value


@pytest.mark.parametrize(("place", "table", "field"), fields())
def test_what_is_missing_is_named(place: str, table: dict[str, Any], field: str) -> None:
    if field not in table:
        return
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(**scene_with(place, {name: value for name, value in table.items() if name != field}))
    assert str(caught.value) == f"{place}.{field}: is missing"


@pytest.mark.parametrize(("model", "place", "table"), tables())
def test_what_is_unknown_is_refused(model: type[BaseModel], place: str, table: dict[str, Any]) -> None:
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(**scene_with(place, table | {"colour": "red"}))
    assert str(caught.value) == f"{place}.colour: is unknown".lstrip(".")


@pytest.mark.parametrize(("model", "place", "table"), tables())
def test_a_descriptor_cannot_be_changed(model: type[BaseModel], place: str, table: dict[str, Any]) -> None:
    scene = carom.Scene(**scene_with(place, table))
    made = {"": scene, "world": scene.world}.get(place) or (scene.shapes or scene.balls)[0]
    for field in type(made).model_fields:
        with pytest.raises(carom.UnknownName, match=f"{field} cannot be set: a .* cannot be changed"):
            setattr(made, field, getattr(made, field))


# -- the same names and defaults as what is described ---------------------------------------------------------------


def described_by(model: type[BaseModel]) -> dict[str, Any]:
    """The fields of a descriptor with their defaults, without what only files have."""
    own = {"kind", "orientation"}
    return {name: field.get_default() for name, field in model.model_fields.items() if name not in own}


@pytest.mark.parametrize(
    "model", [*ShapeDescriptor.__subclasses__(), BallDescriptor, CompoundDescriptor, GroupDescriptor]
)
def test_fields_are_the_constructors_arguments(model: Any) -> None:
    makers: dict[Any, Any] = {
        BallDescriptor: carom.Ball,
        CompoundDescriptor: carom.Compound,
        GroupDescriptor: carom.Group,
    }
    maker = makers.get(model) or model.maker
    arguments = {
        name: parameter.default for name, parameter in inspect.signature(maker).parameters.items() if name != "user"
    }
    fields = described_by(model)
    assert fields.keys() == arguments.keys()
    for name, default in arguments.items():
        if default is not inspect.Parameter.empty:
            assert fields[name] == default, name
        else:
            assert model.model_fields[name].is_required(), name


def test_world_fields_are_the_worlds_settings() -> None:
    defaults = {name: inspect.signature(carom.World).parameters[name].default for name in SETTINGS}
    assert described_by(WorldDescriptor) == defaults
    texts = {name: getattr(carom.World, name).__doc__ for name in SETTINGS}
    assert {name: field.description for name, field in WorldDescriptor.model_fields.items()} == texts


def test_a_ball_that_no_number_can_hold_is_a_fault_of_the_scene() -> None:
    with pytest.raises(
        carom.SceneError, match=r"^balls\[0\]\.position: must leave the ball's box finite, not \(1e\+308"
    ):
        carom.Scene(balls=[{"position": (1e308, 0), "radius": 1e308}])
