"""Every shipped scene goes through both kinds of file, and through a world, and comes back the same."""

from pathlib import Path

import pytest

import carom
from carom import scenes
from tests.worlds import small_scene


@pytest.mark.parametrize("ending", ["toml", "json"])
@pytest.mark.parametrize("name", scenes.names())
def test_through_a_file(tmp_path: Path, name: str, ending: str) -> None:
    scene = small_scene(name)
    path = tmp_path / f"{name}.{ending}"
    scene.save(path)
    loaded = carom.Scene.load(path)
    assert repr(loaded) == repr(scene)  # by repr, which tells -0.0 from 0.0
    assert loaded.build().digest() == scene.build().digest()
    again = tmp_path / f"again.{ending}"
    loaded.save(again)
    assert again.read_bytes() == path.read_bytes()


@pytest.mark.parametrize("name", [name for name in scenes.names() if name != "pool"])
def test_through_a_world(name: str) -> None:
    world = small_scene(name).build()
    twin = carom.Scene.from_world(world).build()
    assert twin.digest() == world.digest()


@pytest.mark.compiled
@pytest.mark.parametrize("name", scenes.names())
def test_through_a_world_that_has_run(tmp_path: Path, name: str) -> None:
    world = small_scene(name).build()
    world.run(0.5)
    scene = carom.Scene.from_world(world)
    scene.save(tmp_path / "end.toml")
    twin = carom.Scene.load(tmp_path / "end.toml").build()
    assert twin.balls.position.tolist() == world.balls.position.tolist()
    assert twin.balls.velocity.tolist() == world.balls.velocity.tolist()
    for shape, other in zip(world.shapes, twin.shapes, strict=True):
        assert tuple(other.aabb) == pytest.approx(tuple(shape.aabb), abs=1e-12)
