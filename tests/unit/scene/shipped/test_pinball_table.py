"""The pinball table has all that a table has, and nothing that a ball could rest on."""

import pytest

import carom
from carom import scenes
from carom.scene.shape_descriptors import CompoundDescriptor
from tests.unit.scene.shipped.joints import distance_of_guard_points


def names_in(scene: carom.Scene) -> set[str | None]:
    """The names of a scene's shapes."""
    return {shape.name for shape in scene.shapes}


@pytest.mark.parametrize("name", ["left flipper", "right flipper", "spinner"])
def test_moving_bands_need_no_points(name: str) -> None:
    (part,) = [shape for shape in scenes.pinball().shapes if shape.name == name]
    assert isinstance(part, CompoundDescriptor)
    assert carom.guard_points(part.build().shapes) == []


def test_a_slingshot_is_a_closed_band() -> None:
    for side in ("left", "right"):
        parts = [shape.build() for shape in scenes.pinball().shapes if (shape.name or "").startswith(f"{side} sling")]
        assert len(parts) == 6
        assert carom.guard_points(parts) == []


def test_the_pinball_table_has_all_that_a_table_has() -> None:
    scene = scenes.pinball()
    kinds = [shape.kind for shape in scene.shapes]
    bumpers = [shape for shape in scene.shapes if (shape.name or "").endswith("bumper")]
    kicking = [shape for shape in scene.shapes if (shape.name or "").endswith("slingshot's band")]
    assert len(bumpers) == 3
    assert all(bumper.solid and bumper.kick > 0.0 for bumper in bumpers)
    assert len(kicking) == 2
    assert all(band.kick > 0.0 for band in kicking)
    assert kinds.count("gate") == 2
    assert {"drop target 1", "drop target 2", "drop target 3"} <= names_in(scene)
    assert {"dome", "plunger", "plunger lane", "drain", "left lane", "left inlane", "right outlane"} <= names_in(scene)
    flippers = [shape for shape in scene.shapes if (shape.name or "").endswith("flipper")]
    assert [flipper.orientation for flipper in flippers] == [0.0, 0.0]
    assert sorted(flipper.turn_limits[0] <= 0.0 <= flipper.turn_limits[1] for flipper in flippers) == [True, True]
    parts = sum(len(shape.shapes) if isinstance(shape, carom.Compound) else 1 for shape in scene.build().shapes)
    assert 90 <= parts <= 150
    box = scene.build().shapes[1].aabb
    assert (box.left, box.right, box.top) == pytest.approx((0.0, 20.0, 42.0))


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("down", [(), (1,), (2,), (3,), (1, 2), (1, 3), (2, 3), (1, 2, 3)])
def test_no_ball_rests_on_the_bank_whichever_targets_are_down(down: tuple[int, ...]) -> None:
    world = scenes.pinball().build()
    for shape in world.shapes:
        if shape.name in {f"drop target {number}" for number in down}:
            shape.can_collide = False
    for ball in list(world.balls):
        world.remove(ball)
    for x in (15.9, 16.1, 16.3, 16.5):
        for y in (20.5, 21.2, 22.4, 24.2, 24.6):
            ball = world.add(carom.Ball((x, y), 0.6))
            lowest = y
            for _ in range(40):
                world.run(0.25)
                lowest = min(lowest, ball.position[1])
            assert lowest < 18.0, (x, y)
            world.remove(ball)


def test_the_dome_goes_over_into_its_walls() -> None:
    assert distance_of_guard_points(scenes.pinball(), "dome") > 1e-3
