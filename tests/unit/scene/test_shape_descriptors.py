"""Shapes and compounds are made as their tables describe them."""

import pytest

import carom
from carom.scene.shape_descriptors import PART_IS_SILENT_ON
from tests.unit.scene.shortest import SHAPES


@pytest.mark.parametrize("kind", [kind for kind in SHAPES if kind not in {"compound", "group"}])
def test_a_shape_is_built_as_described(kind: str) -> None:
    looks = {
        "name": "it",
        "elasticity": 0.5,
        "kick": 2.0,
        "sensor": True,
        "can_collide": False,
        "once": True,
        "layer": 2,
        "collides_with": 5,
        "motion": "kinematic",
        "pivot": (3.0, 4.0),
        "angular_velocity": 0.25,
        "rotating": False,
        "turn_limits": (-1.0, 2.0),
        "velocity": (1.0, -1.0),
    }
    (described,) = carom.Scene(shapes=[SHAPES[kind] | looks]).shapes
    shape = described.build()
    for name, value in looks.items():
        expected = carom.Motion.KINEMATIC if name == "motion" else value
        assert getattr(shape, name) == expected, name
    assert shape.kind == kind
    assert shape.orientation == 0.0


def test_an_oriented_shape_is_turned_about_its_pivot() -> None:
    table = SHAPES["segment"] | {"motion": "kinematic", "pivot": (0, 0), "orientation": 0.5, "turn_limits": (0, 1)}
    hand = carom.Scene(shapes=[table]).shapes[0].build()
    twin = carom.Segment((0, 0), (1, 0), motion="kinematic", pivot=(0, 0))
    twin.rotate((0, 0), 0.5)
    assert (hand.p0, hand.p1, hand.orientation) == (twin.p0, twin.p1, 0.5)
    assert hand.turn_limits == (0.0, 1.0)


@pytest.mark.parametrize("orientation", [-0.1, 1.1])
def test_no_orientation_beyond_the_stops(orientation: float) -> None:
    table = SHAPES["segment"] | {"motion": "kinematic", "orientation": orientation, "turn_limits": (0, 1)}
    with pytest.raises(carom.SceneError, match=r"shapes\[0\].*turn_limits"):
        carom.Scene(shapes=[table])


@pytest.mark.parametrize("kind", [kind for kind in SHAPES if kind not in {"compound", "group"}])
def test_a_static_shape_is_not_turned(kind: str) -> None:
    with pytest.raises(carom.SceneError, match=r"shapes\[0\].*kinematic"):
        carom.Scene(shapes=[SHAPES[kind] | {"orientation": 1.0}])


def test_a_compound_is_built_as_described() -> None:
    parts = [SHAPES["circle"] | {"elasticity": 0.25}, SHAPES["segment"]]
    table = SHAPES["compound"] | {"shapes": parts, "name": "vane", "angular_velocity": 2.0, "kick": 3.0}
    vane = carom.Scene(shapes=[table]).shapes[0].build()
    assert [part.kind for part in vane.shapes] == ["circle", "segment"]
    assert [part.elasticity for part in vane.shapes] == [0.25, 1.0]
    assert [part.kick for part in vane.shapes] == [3.0, 3.0]
    assert (vane.name, vane.pivot, vane.angular_velocity) == ("vane", (0.0, 0.0), 2.0)


@pytest.mark.parametrize("field", PART_IS_SILENT_ON)
def test_a_part_does_not_say_how_it_moves(field: str) -> None:
    values = {"pivot": (0, 0), "rotating": False, "orientation": 0.5, "turn_limits": (0, 1), "velocity": (1, 0)}
    part = SHAPES["circle"] | {"motion": "kinematic", field: values.get(field, {"motion": "kinematic"}.get(field, 1.0))}
    with pytest.raises(carom.SceneError, match=r"shapes\[0\]\.shapes\[0\]\.\w+: is for the compound to set"):
        carom.Scene(shapes=[SHAPES["compound"] | {"shapes": [part]}])


def test_a_compound_holds_no_compounds() -> None:
    with pytest.raises(carom.SceneError, match=r"shapes\[0\]\.shapes"):
        carom.Scene(shapes=[SHAPES["compound"] | {"shapes": [SHAPES["compound"]]}])


def test_a_group_is_built_as_described_of_static_parts() -> None:
    parts = [SHAPES["circle"], SHAPES["point"] | {"kick": 1.0}]
    (group,) = carom.Scene(shapes=[SHAPES["group"] | {"shapes": parts, "name": "brick", "once": True}]).build().shapes
    assert isinstance(group, carom.Group)
    assert (group.name, group.once, [part.kick for part in group.shapes]) == ("brick", True, [0.0, 1.0])
    with pytest.raises(carom.SceneError, match=r"shapes\[0\]\.shapes: must hold at least one shape"):
        carom.Scene(shapes=[SHAPES["group"] | {"shapes": []}])
    with pytest.raises(carom.SceneError, match=r"shapes\[0\]\.shapes\[1\]\.motion: must be static"):
        carom.Scene(
            shapes=[SHAPES["group"] | {"shapes": [SHAPES["circle"], SHAPES["point"] | {"motion": "kinematic"}]}]
        )
