"""The shipped scenes: their names, their arguments, and tables whose joints are tangent or guarded."""

import inspect
from itertools import pairwise
from typing import Any

import pytest

import carom
from carom import scenes
from carom.scene.shape_descriptors import CompoundDescriptor
from tests.worlds import SMALL, small_scene

NAMES = ("galton", "gas", "newtons_cradle", "pinball", "pool", "sinai", "stadium", "toy")
NOT_COUNTS = (0, -1, 1.0, "5", None, True, 10**7)


def names_in(scene: carom.Scene) -> set[str | None]:
    """The names of a scene's shapes."""
    return {shape.name for shape in scene.shapes}


def test_all_are_listed_and_found_by_name() -> None:
    assert scenes.names() == NAMES == tuple(scenes.__all__)
    for name in NAMES:
        assert scenes.by_name(name).name == name


@pytest.mark.parametrize(
    ("name", "hint"), [("pinbal", "did you mean 'pinball'"), ("x", "there are galton, gas"), (3, "")]
)
def test_a_name_that_is_none_is_refused(name: Any, hint: str) -> None:
    with pytest.raises(carom.SceneError, match=f"no shipped scene is called {name!r}; .*{hint}"):
        scenes.by_name(name)


@pytest.mark.parametrize(
    ("name", "argument"),
    [(name, argument) for name in NAMES for argument in inspect.signature(getattr(scenes, name)).parameters],
)
def test_arguments_are_counts(name: str, argument: str) -> None:
    refused = NOT_COUNTS[1:] if argument == "seed" else NOT_COUNTS
    for value in refused[:-1] if argument == "seed" else refused:
        with pytest.raises(carom.InvalidArgument, match=argument):
            getattr(scenes, name)(**SMALL.get(name, {}) | {argument: value})


@pytest.mark.parametrize("name", NAMES)
def test_a_scene_is_the_same_each_time(name: str) -> None:
    assert small_scene(name) == small_scene(name)
    assert small_scene(name).build().digest() == small_scene(name).build().digest()


@pytest.mark.parametrize("name", sorted(SMALL))
def test_chance_comes_from_the_seed(name: str) -> None:
    make = getattr(scenes, name)
    assert make(**SMALL[name]) == make(**SMALL[name], seed=0) != make(**SMALL[name], seed=1)


@pytest.mark.parametrize("name", NAMES)
def test_nothing_overlaps_at_the_start(name: str) -> None:
    world = small_scene(name).build()
    for ball in world.balls:
        for shape in world.shapes:
            for part in shape.shapes if isinstance(shape, carom.Compound) else [shape]:
                contact = part.detect(ball)
                assert contact is None or part.sensor or contact.setback < 1e-9, (ball, part)


@pytest.mark.parametrize("name", NAMES)
def test_every_ball_is_within_the_bounds(name: str) -> None:
    world = small_scene(name).build()
    assert world.bounds is not None
    for ball in world.balls:
        assert ball.position in world.bounds


# -- joints ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["pool", "stadium"])
def test_a_rim_of_tangent_joints_needs_no_points(name: str) -> None:
    scene = small_scene(name)
    assert carom.guard_points([shape.build() for shape in scene.shapes]) == []
    assert len(scene.build().shapes) == len(scene.shapes)


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


def test_the_dome_and_the_toys_corner_go_over_into_their_walls() -> None:
    for scene, arc in ((scenes.pinball(), "dome"), (scenes.toy(), "corner")):
        (bow,) = [shape.build() for shape in scene.shapes if shape.name == arc]
        ends = {bow.p0, bow.p1}
        points = [shape.position for shape in scene.build().shapes if shape.kind == "point"]
        for end in ends:
            assert min(abs(x - end[0]) + abs(y - end[1]) for x, y in points) > 1e-3


@pytest.mark.parametrize("name", NAMES)
def test_every_bare_end_is_guarded(name: str) -> None:
    shapes = list(small_scene(name).build().shapes)
    solid = [part for shape in shapes for part in (shape.shapes if isinstance(shape, carom.Compound) else [shape])]
    solid = [part for part in solid if part.can_collide and not part.sensor]
    assert carom.guard_points(solid) == []


# -- what the tables have -------------------------------------------------------------------------------------------


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


def test_the_toys_table_has_all_that_the_toy_has() -> None:
    scene = scenes.toy()
    (pocket,) = [shape for shape in scene.shapes if shape.name == "pocket"]
    (bumper,) = [shape for shape in scene.shapes if shape.name == "bumper"]
    assert pocket.elasticity > 1.0
    assert bumper.elasticity > 1.0
    assert bumper.solid
    assert [shape.kind for shape in scene.shapes].count("gate") == 1
    resting = [shape for shape in scene.shapes if shape.kind == "compound"]
    assert len(resting) == 3
    assert all(not shape.rotating and shape.angular_velocity != 0.0 for shape in resting)
    boxes = [shape.aabb for shape in scene.build().shapes]
    assert min(box.left for box in boxes) == 0.0
    assert max(box.right for box in boxes) == 32.0
    assert max(box.top for box in boxes) == 24.0


def test_the_cradles_balls_touch() -> None:
    places = [ball.position[0] for ball in scenes.newtons_cradle(balls=7).balls[1:]]
    assert [later - earlier for earlier, later in pairwise(places)] == [1.0] * 5


def test_the_gas_is_an_equilibrium() -> None:
    scene = scenes.gas(balls=500)
    world = scene.build()
    area = (world.shapes[0].length) ** 2
    assert 500 * 3.141592653589793 * 0.25 / area == pytest.approx(0.20)
    assert world.balls.velocity.sum(axis=0) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert (world.balls.velocity**2).sum(axis=1).mean() == pytest.approx(7.5**2)
    assert scenes.gas(balls=1).balls[0].velocity != (0.0, 0.0)
