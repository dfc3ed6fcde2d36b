"""Drop targets: a shape that switches itself off at its first bounce, and where the step is undone, on again."""

from typing import Any

import numpy as np
import pytest

import carom
from carom.rows.shape import ONCE, SHAPE, SPENT
from carom.world.kernels.step.spending import keep_spent, row_called, spend, unspend
from tests.kernel_calls import ball_rows, state_row

DETECTIONS = pytest.mark.parametrize("detection", ["discrete", "continuous"])


def lane(detection: Any, balls: int = 1, **target: Any) -> tuple[carom.World, carom.Segment]:
    """A target across a lane, and balls that come to it one behind the other, a wall behind them."""
    world = carom.World(detection=detection)
    aim = world.add(carom.Segment((0, -1), (0, 1), once=True, name="target", **target))
    world.add(carom.Segment((3, -1), (3, 1), name="end"))
    for place in range(balls):
        world.add(carom.Ball((-1.0 - 0.5 * place, 0), 0.1, (4, 0)))
    return world, aim


def bounces(hits: carom.Hits, name: str) -> list[int]:
    """The ids of the balls that bounced off what has a name."""
    return [hit.ball.id for hit in hits if hit.kind == carom.HitKind.BOUNCE and hit.shape.name == name]


@DETECTIONS
def test_the_first_ball_bounces_off_a_target_and_later_ones_pass(detection: Any) -> None:
    world, target = lane(detection)
    first = world.balls[0]
    hits = world.run(0.5)
    assert bounces(hits, "target") == [first.id]
    assert (target.can_collide, target.once) == (False, True)
    assert world.ray_cast((-5, 0.5), (5, 0.5)).shape.name == "end"
    world.remove(first)
    second = world.add(carom.Ball((-1, 0), 0.1, (4, 0)))
    hits = world.run(1.5)
    assert bounces(hits, "target") == []
    assert bounces(hits, "end") == [second.id]


@DETECTIONS
def test_of_balls_that_come_at_once_one_bounces(detection: Any) -> None:
    world = carom.World(detection=detection)
    world.add(carom.Segment((0, -3), (0, 3), once=True))
    for height in (-2, 0, 2):
        world.add(carom.Ball((-1, height), 0.1, (4, 0)))
    hits = world.run(1.0)
    assert len(hits) == 1
    assert sorted(np.sign(world.balls.velocity[:, 0]).tolist()) == [-1, 1, 1]


@DETECTIONS
def test_a_target_is_armed_again_by_being_switched_on(detection: Any) -> None:
    world, target = lane(detection)
    for _ in range(3):
        world.balls[0].position, world.balls[0].velocity = (-1, 0), (4, 0)
        target.can_collide = True
        assert len(bounces(world.run(0.4), "target")) == 1
        assert not target.can_collide
    target.once, target.can_collide = False, True
    world.balls[0].position, world.balls[0].velocity = (-1, 0), (4, 0)
    world.run(0.4)
    assert target.can_collide


@DETECTIONS
def test_each_part_of_a_compound_drops_by_itself_and_moving_ones_do_too(detection: Any) -> None:
    world = carom.World(detection=detection)
    parts = [carom.Circle((0, y), 0.2, solid=True) for y in (-1, 1)]
    world.add(carom.Compound(parts, (0, 0), once=True, velocity=(-0.5, 0)))
    world.add(carom.Ball((-1, 1), 0.1, (4, 0)), carom.Ball((-3, 1), 0.1, (4, 0)))
    hits = world.run(1.0)
    assert [hit.shape for hit in hits if hit.shape in parts] == [parts[1]]
    assert [part.can_collide for part in parts] == [True, False]


@DETECTIONS
def test_a_sensor_has_no_bounces_and_stays(detection: Any) -> None:
    world, target = lane(detection, sensor=True)
    assert [hit.kind.name for hit in world.run(0.5)] == ["ENTER", "EXIT"]
    assert target.can_collide


@DETECTIONS
def test_what_rests_on_a_target_or_sleeps_falls_when_it_drops(detection: Any) -> None:
    world = carom.World(gravity=(0, -10), detection=detection, sleep_speed=0.05, sleep_time=0.2)
    shelf = world.add(carom.Segment((-1, 2), (1, 2), once=True, elasticity=0.5))
    sleeper = world.add(carom.Ball((-0.5, 2.1), 0.1))
    world.run(0.5)
    assert sleeper.asleep
    assert shelf.can_collide  # it has come to rest there without a bounce
    world.add(carom.Ball((0.5, 3), 0.1))
    hits = world.run(60.0, dt=1 / 100, until=shelf)
    assert not sleeper.asleep or detection == "discrete"
    dropped = hits[-1].time
    world.run(0.3, dt=1 / 100)
    fallen = world.time - dropped
    assert sleeper.position[1] == pytest.approx(2.1 - 5 * fallen**2, abs=0.15 if detection == "discrete" else 1e-9)


@DETECTIONS
def test_a_step_that_is_undone_leaves_the_target_standing(detection: Any) -> None:
    world, target = lane(detection)
    spinner = world.add(carom.Circle((9, 9), 1, once=True, motion="kinematic", velocity=(1e308, 0)))
    world.add(carom.Ball((6, 9), 0.1, (0, 0)))
    before = [table.used.tobytes() for table in (world._arrays.shapes, world._arrays.balls)]
    with pytest.raises(carom.NonFiniteState):
        world.step(10.0)
    assert target.can_collide
    assert spinner.can_collide
    assert [table.used.tobytes() for table in (world._arrays.shapes, world._arrays.balls)] == before
    world.remove(spinner)
    assert len(bounces(world.run(0.5), "target")) == 1


@DETECTIONS
def test_a_snapshot_and_a_scene_keep_targets_that_stand_and_those_that_have_dropped(detection: Any) -> None:
    for seconds in (0.1, 0.5):
        world, _ = lane(detection, balls=2)
        world.run(seconds)
        twin = carom.World()
        twin.restore(world.snapshot())
        built = carom.Scene.from_world(world).build()
        for other in (twin, built):
            assert (other.shapes[0].once, other.shapes[0].can_collide) == (True, seconds == 0.1)
        hits = world.run(1.0)
        assert np.asarray(twin.run(1.0)).tobytes() == np.asarray(hits).tobytes()
        assert twin.digest() == world.digest()


def test_a_ring_is_spent_together_but_for_those_that_are_off_or_are_not_to_drop() -> None:
    shapes = np.zeros(6, SHAPE)
    shapes["id"], shapes["drops_with"] = [2, 3, 5, 8, 13, 21], [0, 8, 3, 21, 0, 5]
    shapes["can_collide"], shapes["once"] = [1, 1, 1, 0, 1, 1], [ONCE, ONCE, ONCE, ONCE, ONCE, 0]
    state = state_row(ball_rows([(0.0, 0.0, 1.0)]), "grid", 1)
    state["shapes"] = 6
    before = shapes.copy()
    spend(state, shapes, shapes[2])
    assert shapes["can_collide"].tolist() == [1, 0, 0, 0, 1, 1]
    assert (shapes["once"].tolist(), state["spent"]) == ([ONCE, SPENT, SPENT, ONCE, ONCE, 0], 2)
    unspend(shapes, 6)
    assert shapes.tobytes() == before.tobytes()


def test_a_shape_is_found_by_its_id() -> None:
    shapes = np.zeros(9, SHAPE)
    shapes["id"][:7] = [2, 3, 5, 8, 13, 21, 34]
    state = state_row(ball_rows([(0.0, 0.0, 1.0)]), "grid", 1)
    for count in range(1, 8):
        state["shapes"] = count
        assert [row_called(state, shapes, int(wanted)) for wanted in shapes["id"][:count]] == list(range(count))


def test_nothing_else_has_it() -> None:
    assert not carom.Point((0, 0)).once
    with pytest.raises(carom.InvalidArgument, match="once must be True or False"):
        carom.Point((0, 0), once=1)


def test_spent_shapes_are_armed_again_at_the_end_of_a_step_and_stand_again_where_it_is_undone() -> None:
    shapes = np.zeros(4, SHAPE)
    shapes["can_collide"], shapes["once"] = 1, [0, ONCE, ONCE, 0]
    state = state_row(ball_rows([(0.0, 0.0, 1.0)]), "grid", 1)
    state["shapes"] = 4
    spend(state, shapes, shapes[1])
    assert (shapes["once"].tolist(), shapes["can_collide"].tolist(), state["spent"]) == (
        [0, SPENT, 1, 0],
        [1, 0, 1, 1],
        1,
    )
    undone = shapes.copy()
    unspend(undone, 4)
    assert (undone["once"].tolist(), undone["can_collide"].tolist()) == ([0, ONCE, ONCE, 0], [1, 1, 1, 1])
    keep_spent(state, shapes)
    assert (shapes["once"].tolist(), shapes["can_collide"].tolist(), state["spent"]) == ([0, 1, 1, 0], [1, 0, 1, 1], 0)
