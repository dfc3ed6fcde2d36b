"""What a descriptor writes: nothing that would be so anyway, what is its own before what it shares, all of it plain."""

import json
from typing import Any

import numpy as np
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


WHOLE = (np.int64, np.uint8, np.int32)


@pytest.mark.parametrize("whole", WHOLE)
def test_numbers_and_booleans_of_numpy_are_taken_as_those_of_python(whole: Any) -> None:
    yes, no = np.True_, np.False_
    given = carom.Scene(
        version=whole(1),
        guard=yes,
        world={"substeps": whole(3), "gravity": np.array([0, 1]), "remove_strays": yes, "friction": np.float32(0.5)},
        shapes=[
            {"kind": "circle", "center": (whole(1), 2.0), "radius": whole(2), "layer": whole(2), "sensor": yes},
            {
                "kind": "compound",
                "pivot": (0, 0),
                "collides_with": whole(7),
                "shapes": [{"kind": "point", "position": np.array([1, 2]), "can_collide": no}],
            },
        ],
        balls=[{"position": (0, 0), "radius": np.float64(0.5), "layer": whole(4), "sensor": yes}],
    )
    plain = carom.Scene(
        guard=True,
        world={"substeps": 3, "gravity": (0, 1), "remove_strays": True, "friction": 0.5},
        shapes=[
            {"kind": "circle", "center": (1, 2), "radius": 2, "layer": 2, "sensor": True},
            {
                "kind": "compound",
                "pivot": (0, 0),
                "collides_with": 7,
                "shapes": [{"kind": "point", "position": (1, 2), "can_collide": False}],
            },
        ],
        balls=[{"position": (0, 0), "radius": 0.5, "layer": 4, "sensor": True}],
    )
    assert given == plain
    assert repr(given) == repr(plain)  # that of NumPy's numbers would be another
    assert json.dumps(given.plain()) == json.dumps(plain.plain())


def test_what_is_wrong_of_numpy_is_still_wrong() -> None:
    for world, told in (
        ({"substeps": np.float64(3.0)}, "world.substeps: must be a whole number, not 3.0"),
        ({"substeps": np.True_}, "world.substeps: must be a whole number, not True"),
        ({"substeps": np.int64(0)}, "world.substeps: must be at least 1, not 0"),
        ({"remove_strays": np.int64(1)}, "world.remove_strays: must be true or false, not 1"),
        ({"friction": np.array([0.5])}, "world.friction: must be a number, not [0.5]"),
    ):
        with pytest.raises(carom.SceneError) as caught:
            carom.Scene(world=world)
        assert str(caught.value) == told
