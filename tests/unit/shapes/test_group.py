"""Groups: static shapes that are one thing, in a world, its snapshots, its scenes and its hits."""

import pickle
from copy import copy, deepcopy
from typing import Any

import numpy as np
import pytest

import carom
from carom import outlines
from tests.worlds import bits

DETECTIONS = pytest.mark.parametrize("detection", ["discrete", "continuous"])


def brick(left: float, bottom: float, **options: Any) -> carom.Group:
    """A brick of 2 by 1: four sides and four corners."""
    return carom.Group(outlines.rectangle(left, bottom, left + 2, bottom + 1), **options)


def wall(detection: Any = "discrete", **options: Any) -> carom.World:
    """A world with a wall of six bricks, and a ball that bounces about below and between them."""
    world = carom.World(detection=detection)
    world.add(*outlines.rectangle(-5, -5, 5, 5))
    for column in (-4, -1, 2):
        for line in (0, 2):
            world.add(brick(column, line, name=f"brick {column} {line}", **options))
    world.add(carom.Ball((-3, -2), 0.3, velocity=(3.1, 7.3)))
    return world


def bricks(world: carom.World) -> list[carom.Group]:
    """The bricks of a world."""
    return [shape for shape in world.shapes if isinstance(shape, carom.Group)]


@DETECTIONS
def test_the_whole_brick_is_gone_at_its_first_bounce(detection: Any) -> None:
    world = wall(detection, once=True)
    hits = world.run(8.0)
    struck = [hit.shape.group for hit in hits if hit.kind == carom.HitKind.BOUNCE and hit.shape.group is not None]
    assert len(struck) == len(set(struck)) > 2  # none twice
    assert set(struck) == {one for one in bricks(world) if not one.can_collide}
    for one in bricks(world):
        assert {part.can_collide for part in one.shapes} == {one.can_collide}


@DETECTIONS
def test_parts_drop_one_by_one_where_only_they_were_told(detection: Any) -> None:
    world = carom.World(detection=detection)
    target = world.add(brick(0, 0))
    for part in target.shapes:
        part.once = True
    world.add(carom.Ball((1, -1), 0.25, (0, 4)))
    (hit,) = world.run(0.5)
    assert [part for part in target.shapes if not part.can_collide] == [hit.shape]
    assert target.can_collide


@DETECTIONS
def test_once_can_be_set_and_taken_back_and_a_part_can_be_spared(detection: Any) -> None:
    world = carom.World(detection=detection)
    target = world.add(brick(0, 0))
    ball = world.add(carom.Ball((1, -1), 0.25, (0, 4)))
    for once, left in ((None, 8), (True, 0), (False, 8), (True, 1)):
        target.once, target.can_collide = once, True
        if left == 1:
            target.shapes[5].once = False
        ball.position, ball.velocity = (1, -1), (0, 4)
        assert len(world.run(0.4)) == 1
        assert sum(part.can_collide for part in target.shapes) == left


@DETECTIONS
def test_a_ball_in_a_part_that_is_a_sensor_leaves_it_when_the_brick_goes(detection: Any) -> None:
    world = carom.World(detection=detection)
    eye = carom.Circle((1, 5), 1, sensor=True, solid=True)
    world.add(carom.Group([carom.Segment((0, 0), (2, 0)), eye], once=True))
    inside = world.add(carom.Ball((1, 5), 0.25))
    world.add(carom.Ball((1, -1), 0.25, (0, 4)))
    hits = world.run(0.5)
    assert [(hit.kind.name, hit.ball is inside) for hit in hits] == [("ENTER", True), ("BOUNCE", False), ("EXIT", True)]


@DETECTIONS
def test_a_step_that_is_undone_leaves_the_brick_standing(detection: Any) -> None:
    world = carom.World(detection=detection)
    target = world.add(brick(0, 0, once=True))
    target.shapes[3].can_collide = False
    target.shapes[4].once = False
    world.add(carom.Ball((1, -1), 0.25, (0, 4)))
    spinner = world.add(carom.Circle((99, 9), 1, motion="kinematic", velocity=(1e308, 0)))
    before = world._arrays.shapes.used.tobytes()
    with pytest.raises(carom.NonFiniteState):
        world.step(10.0)
    assert world._arrays.shapes.used.tobytes() == before
    world.remove(spinner)
    world.run(0.5)
    assert [part.can_collide for part in target.shapes] == [False] * 4 + [True] + [False] * 3


@DETECTIONS
def test_snapshots_copies_pickles_and_scenes_go_on_alike(detection: Any) -> None:
    world = wall(detection, once=True)
    world.run(2.0)
    restored = carom.World()
    restored.restore(world.snapshot())
    twins = [restored, copy(world), deepcopy(world), pickle.loads(pickle.dumps(world))]
    hits = world.run(4.0)
    for twin in twins:
        assert bits(twin.run(4.0)) == bits(hits)
        assert twin.digest() == world.digest()
    for twin in (*twins, carom.Scene.from_world(world).build()):
        assert [one.name for one in twin.shapes] == [one.name for one in world.shapes]
        assert [one.can_collide for one in bricks(twin)] == [one.can_collide for one in bricks(world)]
        assert [one.once for one in bricks(twin)] == [True] * 6
        assert all(part.group is one for one in bricks(twin) for part in one.shapes)


def test_a_scene_says_what_parts_have_and_whether_they_drop_together(tmp_path: Any) -> None:
    world = carom.World()
    world.add(brick(0, 0, once=True, name="brick", elasticity=0.5, layer=4))
    world.add(carom.Group([carom.Point((5, 5), once=True), carom.Point((6, 5), kick=1.0)]))
    scene = carom.Scene.from_world(world)
    scene.save(tmp_path / "wall.toml")
    assert carom.Scene.load(tmp_path / "wall.toml") == scene
    assert carom.Scene.from_world(scene.build()) == scene
    first, second = bricks(scene.build())
    assert (first.once, first.name, {part.elasticity for part in first.shapes}) == (True, "brick", {0.5})
    assert (second.once, [part.once for part in second.shapes]) == (None, [True, False])


def test_a_restore_makes_and_takes_away_groups() -> None:
    world = carom.World()
    first = world.add(brick(0, 0, name="first"))
    snapshot = world.snapshot()
    second = world.add(brick(5, 5, name="second"))
    extra = first.add(carom.Point((3, 3)))
    world.restore(snapshot)
    assert list(world.shapes) == [first]
    assert (len(first.shapes), extra.group, extra.world, second.world) == (8, None, None, None)
    assert len(second.shapes) == 8
    world.remove(first)
    world.restore(snapshot)
    (again,) = world.shapes
    assert (again is first, again.name, len(again.shapes)) == (False, "first", 8)


@DETECTIONS
def test_a_run_ends_when_a_group_or_its_name_is_met(detection: Any) -> None:
    ends = []
    for until in ("object", "brick -1 0"):
        world = wall(detection)
        hits = world.run(20.0, until=world.shapes["brick -1 0"] if until == "object" else until)
        assert [hit.shape.group for hit in hits][-1] is world.shapes["brick -1 0"]
        ends.append(bits(hits))
    assert ends[0] == ends[1]


def test_parts_stay_static_and_are_moved_together_or_alone() -> None:
    group = brick(0, 0)
    with pytest.raises(carom.InvalidArgument, match="motion must stay 'static' for a part of a group"):
        group.shapes[0].motion = "kinematic"
    with pytest.raises(carom.InvalidArgument, match="must be static"):
        group.add(carom.Point((0, 0), motion="kinematic"))
    group.shapes[0].motion = "static"
    assert group.motion == carom.Motion.STATIC
    world = carom.World()
    world.add(group)
    group.position = (5, 7)
    assert (tuple(group.aabb), group.position) == ((4.0, 6.5, 6.0, 7.5), (5.0, 7.0))
    before = [part.position for part in group.shapes]
    with pytest.raises(carom.InvalidArgument, match="position must leave the"):
        group.position = (1.7e308, 1e308)
    assert [part.position for part in group.shapes] == before
    group.shapes[4].position = (0, 0)
    assert tuple(group.aabb) == (0.0, 0.0, 6.0, 7.5)


def test_a_group_tells_whether_anything_of_it_can_be_met() -> None:
    group = brick(0, 0, can_collide=False)
    assert (group.can_collide, group.add(carom.Point((1, 1))).can_collide) == (False, False)
    group.can_collide = True
    assert all(part.can_collide for part in group.shapes)
    for part in group.shapes[1:]:
        part.can_collide = False
    assert group.can_collide
    group.shapes[0].can_collide = False
    assert not group.can_collide


def test_what_it_is_called_and_how_it_is_recorded() -> None:
    world = wall(once=True)
    run = carom.Recording.of(world, 4.0)
    assert len(run.shape_ids) == 8 + 6 * 8
    names = {run.names.get(int(shape)) for shape in run.hits["shape"]}
    assert any(name is not None and name.startswith("brick") for name in names)
    gone = [part.id for one in bricks(world) if not one.can_collide for part in one.shapes]
    assert gone
    assert not run.colliding[-1][np.isin(run.shape_ids, gone)].any()
    assert repr(bricks(world)[0]) == "Group(8 shapes)"
