"""Scenes make worlds and are made of worlds; what they hold is copied, and never changes."""

import copy
import pickle
from typing import Any

import pytest

import carom


def flipper(**options: Any) -> carom.Compound:
    """A compound of a circle and a segment."""
    parts = [carom.Circle((0, 0), 0.5), carom.Segment((0, 0.5), (3, 0.25), elasticity=0.5, name="edge")]
    return carom.Compound(parts, (0, 0), **options)


def world_of_everything() -> carom.World:
    """A world with every kind of shape, at rest and turned, and with settings of its own."""
    world = carom.World(gravity=(0, -1), bounds=carom.Aabb(-9, -9, 9, 9), broad_phase="brute", max_speed=5)
    world.add(carom.Point((1, 2), name="post", kick=2.0))
    world.add(carom.Segment((4, 0), (0, 0), elasticity=0.25, layer=2, collides_with=3))
    world.add(carom.Gate((0, 5), (0, 7), direction=(1, 0)))
    world.add(carom.Circle((-5, -5), 1.0, solid=True, sensor=True))
    world.add(carom.Arc((5, 5), 1.5, 1.0, 6.0, can_collide=False))
    world.add(carom.Segment((-2, 1), (-1, 1), motion="kinematic", angular_velocity=0.5, turn_limits=(-1, 1)))
    world.add(carom.Arc((-5, 5), 1.0, 0.0, 2.0, motion="kinematic", pivot=(-4, 5), velocity=(0.5, 0.25)))
    world.add(flipper(angular_velocity=3.0, turn_limits=(0, 0.75), name="flipper"))
    world.add(carom.Ball((0.5, -3.0), 0.25, velocity=(1, 0), mass=2.0, name="cue"))
    world.add_balls([[-3.0, -3.0], [-3.0, -2.0]], radius=0.125)
    return world


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


def test_a_scene_holds_the_state_of_a_world_that_has_moved() -> None:
    world = world_of_everything()
    world.run(1.0)
    scene = carom.Scene.from_world(world)
    twin = scene.build()
    assert scene.shapes[5].orientation == pytest.approx(0.5, abs=1e-12)
    assert (scene.shapes[7].orientation, scene.shapes[7].angular_velocity) == (0.75, 0.0)
    for shape, other in zip(world.shapes, twin.shapes, strict=True):
        assert other.orientation == shape.orientation
        assert other.pivot == pytest.approx(shape.pivot, abs=1e-12)
        assert tuple(other.aabb) == pytest.approx(tuple(shape.aabb), abs=1e-12)
    for ball, other in zip(world.balls, twin.balls, strict=True):
        assert (other.position, other.velocity) == (ball.position, ball.velocity)
    assert carom.Scene.from_world(twin) == scene


def test_a_shape_that_has_turned_remembers_where_it_began() -> None:
    world = carom.World()
    hand = world.add(carom.Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0)))
    hand.rotate((0, 0), 1.0)
    twin = carom.Scene.from_world(world).build().shapes[0]
    assert (twin.p0, twin.p1) == (hand.p0, hand.p1)
    twin.reset()
    assert (twin.p0, twin.p1) == ((0.0, 0.0), (2.0, 0.0))


def test_a_scene_copies_what_it_is_made_of() -> None:
    ball = carom.Ball((0, 0), 1.0)
    scene = carom.Scene(balls=[ball])
    ball.position = (5, 5)
    assert scene.balls[0].position == (0.0, 0.0)
    assert ball.world is None
    scene.build()
    assert ball.world is None


def test_bare_ends_are_guarded_where_asked_for() -> None:
    corner = [carom.Segment((0, 0), (4, 0)), carom.Segment((0, 0), (0, 3), elasticity=0.5)]
    assert len(carom.Scene(shapes=corner).build().shapes) == 2
    world = carom.Scene(shapes=corner, guard=True).build()
    points = [shape.position for shape in world.shapes[2:]]
    assert points == [point.position for point in carom.guard_points(corner)] == [(0, 0), (4, 0), (0, 3)]


def test_a_compound_takes_its_guard_points_along() -> None:
    vane = carom.Compound([carom.Segment((1, 0), (3, 0))], (0, 0), turn_limits=(0, 2))
    vane.rotate((0, 0), 1.0)
    world = carom.Scene(shapes=[vane], guard=True).build()
    (guarded,) = world.shapes
    assert [part.kind for part in guarded.shapes] == ["segment", "point", "point"]
    assert guarded.orientation == 1.0
    guarded.rotate((0, 0), 2.0)
    edge, *points = guarded.shapes
    ends = sorted(point.position for point in points)
    assert ends == [pytest.approx(edge.p0, abs=1e-15), pytest.approx(edge.p1, abs=1e-15)]


def test_a_guarded_world_gives_a_scene_that_needs_no_guard() -> None:
    scene = carom.Scene(shapes=[flipper(), carom.Segment((0, 0), (4, 0))], guard=True)
    world = scene.build()
    twin = carom.Scene.from_world(world)
    assert not twin.guard
    assert twin.build().digest() == world.digest()


def test_settings_that_the_world_refuses_are_faults_of_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(**settings: Any) -> None:
        raise carom.InvalidArgument(f"friction must be something else, not {settings['friction']}")

    monkeypatch.setattr("carom.world.world.World", refuse)
    with pytest.raises(carom.SceneError, match=r"^world: friction must be something else, not 2.0$"):
        carom.Scene(world={"friction": 2}).build()


@pytest.mark.parametrize("thing", [None, 3, carom.Ball((0, 0), 1), carom.Scene()])
def test_from_world_wants_a_world(thing: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match=r"^world must be a World, not "):
        carom.Scene.from_world(thing)


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
    assert len(kinds) == 6
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


def test_guard_points_are_called_so_and_those_of_a_compound_go_by_its_name() -> None:
    wall = carom.Segment((5, 0), (9, 0), name="wall")
    world = carom.Scene(guard=True, shapes=(wall, flipper(name="flipper"))).build()
    names = [shape.name for shape in world.shapes if isinstance(shape, carom.Point)]
    assert names == ["guard point", "guard point"]
    (compound,) = [shape for shape in world.shapes if isinstance(shape, carom.Compound)]
    assert {part.name for part in compound.shapes if isinstance(part, carom.Point)} == {None}
