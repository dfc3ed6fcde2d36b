"""What a descriptor writes: nothing that would be so anyway, what is its own before what it shares, all of it plain."""

import json

import pytest

import carom
from carom.scene.descriptors import BallDescriptor
from carom.scene.shape_descriptors import CompoundDescriptor, PointDescriptor, SegmentDescriptor
from tests.worlds import small_scene


def test_what_would_be_so_anyway_is_not_written() -> None:
    assert BallDescriptor(position=(1, 2), radius=0.5).plain() == {"position": [1.0, 2.0], "radius": 0.5}
    assert PointDescriptor(position=(1, 2), elasticity=1.0, name=None).plain() == {
        "kind": "point",
        "position": [1.0, 2.0],
    }


def test_a_zero_with_a_sign_is_not_the_one_without() -> None:
    ball = {"position": (0.0, 0.0), "radius": 1.0}
    assert "velocity" not in BallDescriptor(**ball, velocity=(0.0, 0.0)).plain()
    assert repr(BallDescriptor(**ball, velocity=(0.0, -0.0)).plain()["velocity"]) == "[0.0, -0.0]"


def test_kind_and_name_come_first_then_what_is_its_own() -> None:
    segment = SegmentDescriptor(kick=1.0, layer=2, end=(1.0, 0.0), start=(0.0, 0.0), name="wall")
    assert list(segment.plain())[:4] == ["kind", "name", "start", "end"]
    assert sorted(list(segment.plain())[4:]) == ["kick", "layer"]
    assert next(iter(small_scene("toy").plain())) == "version"


def test_descriptors_in_a_descriptor_are_tables_in_a_list() -> None:
    parts = (PointDescriptor(position=(1, 0), name="tip"), PointDescriptor(position=(2, 0)))
    assert CompoundDescriptor(pivot=(0, 0), shapes=parts).plain()["shapes"] == [part.plain() for part in parts]


@pytest.mark.parametrize("name", carom.scenes.names())
def test_what_is_written_is_plain_and_read_as_the_same(name: str) -> None:
    scene = small_scene(name)
    assert carom.Scene(**json.loads(json.dumps(scene.plain()))) == scene


def test_a_scene_and_its_parts_are_not_changed() -> None:
    scene = carom.scenes.toy()
    for part, name in ((scene, "name"), (scene, "wrld"), (scene.world, "gravity"), (scene.shapes[0], "elasticity")):
        before = part.model_dump()
        with pytest.raises(carom.UnknownName, match=f"{name} cannot be set: a {type(part).__name__} cannot be changed"):
            setattr(part, name, 1.0)
        with pytest.raises(carom.UnknownName, match=f"{name} cannot be set"):
            delattr(part, name)
        assert part.model_dump() == before
