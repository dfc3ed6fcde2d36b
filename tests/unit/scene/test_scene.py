"""Scenes make worlds and are made of worlds; what they hold is copied, and never changes."""

import copy
import pickle
from typing import Any

import pytest

import carom
from tests.unit.scene.everything import flipper, world_of_everything


def test_a_scene_builds_what_it_describes() -> None:
    scene = carom.Scene(
        world={"gravity": (0, -9.8), "bounds": (-1, -2, 3, 4)},
        shapes=[{"kind": "segment", "start": [0, 0], "end": [1, 0]}, carom.Circle((5, 5), 1), flipper(name="left")],
        balls=[{"position": (1, 2), "radius": 0.5}],
    )
    world = scene.build()
    assert (world.gravity, world.bounds) == ((0.0, -9.8), carom.Aabb(-1, -2, 3, 4))
    assert [shape.kind for shape in world.shapes] == ["segment", "circle", "compound"]
    assert world.shapes[2].name == "left"
    assert world.balls[0].position == (1.0, 2.0)
    assert scene.build() is not world
    assert scene.build().digest() == world.digest()


def test_a_world_and_the_one_built_from_its_scene_are_the_same() -> None:
    world = world_of_everything()
    twin = carom.Scene.from_world(world).build()
    for setting in type(carom.Scene().world).model_fields:
        assert getattr(twin, setting) == getattr(world, setting), setting
    assert twin.digest() == world.digest()


def test_a_scene_copies_what_it_is_made_of() -> None:
    ball = carom.Ball((0, 0), 1.0)
    scene = carom.Scene(balls=[ball])
    ball.position = (5, 5)
    assert scene.balls[0].position == (0.0, 0.0)
    assert ball.world is None
    scene.build()
    assert ball.world is None


def test_settings_that_the_world_refuses_are_faults_of_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(**settings: Any) -> None:
        raise carom.InvalidArgument(f"friction must be something else, not {settings['friction']}")

    monkeypatch.setattr("carom.world.world.World", refuse)
    with pytest.raises(carom.SceneError, match=r"^world: friction must be something else, not 2.0$"):
        carom.Scene(world={"friction": 2}).build()


def test_scenes_are_values() -> None:
    scene = carom.Scene.from_world(world_of_everything())
    assert scene == carom.Scene.from_world(world_of_everything())
    assert len({scene, carom.Scene.from_world(world_of_everything()), carom.Scene()}) == 2
    for twin in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert twin == scene


def test_the_json_schema_knows_every_field() -> None:
    schema = carom.Scene.json_schema()
    assert schema["required"] == ["version"]
    assert schema["properties"].keys() == carom.Scene.model_fields.keys()
    kinds = {entry["$ref"].rpartition("/")[2] for entry in schema["properties"]["shapes"]["items"]["oneOf"]}
    assert len(kinds) == 7
    for kind in kinds:
        definition = schema["$defs"][kind]
        assert definition["required"][0] == "kind"
        assert definition["additionalProperties"] is False


def test_the_json_schema_explains_every_field() -> None:
    schema = carom.Scene.json_schema()
    for definition in (schema, *schema["$defs"].values()):
        assert definition["description"]
        for name, field in definition["properties"].items():
            assert name == "kind" or field["description"].endswith("."), name
