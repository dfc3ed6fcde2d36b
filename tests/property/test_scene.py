"""Any scene goes through a file bit for bit, and any damaged file is a `SceneError` and nothing else."""

import json
import tempfile
from pathlib import Path
from typing import Any

import pytest
import tomli_w
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.scene.faults import path_of
from tests.scene_tables import (
    changed,
    nothing_good,
    places,
    scene_or_words,
    tables_of_scenes,
)


def through_file(scene: carom.Scene, ending: str) -> carom.Scene:
    """The scene, saved and loaded."""
    with tempfile.TemporaryDirectory() as folder:
        scene.save(Path(folder) / f"scene.{ending}")
        return carom.Scene.load(Path(folder) / f"scene.{ending}")


@pytest.mark.slow
@given(tables_of_scenes, st.sampled_from(("toml", "json")))
def test_a_scene_goes_through_a_file_bit_for_bit(table: dict[str, Any], ending: str) -> None:
    scene = carom.Scene(**table)
    assert repr(through_file(scene, ending)) == repr(scene)


@pytest.mark.slow
@given(tables_of_scenes)
def test_a_scene_builds_a_world_that_gives_the_scene_back(table: dict[str, Any]) -> None:
    world = carom.Scene(**{**table, "guard": False}).build()
    first = carom.Scene.from_world(world)
    second = carom.Scene.from_world(first.build())
    assert len(first.shapes) == len(table.get("shapes", []))
    assert len(first.balls) == len(table.get("balls", []))
    assert [shape.name for shape in first.shapes] == [shape.get("name") for shape in table.get("shapes", [])]
    assert first.balls == second.balls
    assert first.world == second.world


@pytest.mark.slow
@given(tables_of_scenes, st.data())
def test_any_change_is_taken_or_refused_as_a_whole(table: dict[str, Any], data: st.DataObject) -> None:
    path = data.draw(st.sampled_from(places(table)[1:] or [("guard",)]))
    damaged = changed({"guard": False} | table, path, data.draw(nothing_good))
    result = scene_or_words(carom.Scene, **damaged)
    assert isinstance(result, str) or repr(through_file(result, "json")) == repr(result)


@pytest.mark.slow
@given(tables_of_scenes, st.sampled_from(("toml", "json")), st.data())
def test_a_damaged_file_is_a_scene_error(table: dict[str, Any], ending: str, data: st.DataObject) -> None:
    plain = carom.Scene(**table).plain()
    text = (tomli_w.dumps(plain) if ending == "toml" else json.dumps(plain)).encode()
    place = data.draw(st.integers(0, len(text) - 1))
    cut = data.draw(st.sampled_from((text[:place], text[place:], text[:place] + b"\xff" + text[place + 1 :])))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"scene.{ending}"
        path.write_bytes(
            data.draw(st.sampled_from((cut, text[:place] + data.draw(st.binary(max_size=3)) + text[place:])))
        )
        result = scene_or_words(carom.Scene.load, path)
        assert isinstance(result, carom.Scene) or result.startswith(f"{path}: ")


@given(st.lists(st.one_of(st.integers(0, 9), st.text(max_size=4)), max_size=5).map(tuple))
def test_a_path_can_be_written_for_any_place(location: tuple[int | str, ...]) -> None:
    assert "\n" not in path_of(location)
