"""The table of the pinball game: its parts, what moves and switches, and where balls can be."""

from itertools import pairwise
from math import atan2, degrees, hypot, pi

import pytest

import carom
from carom.play.pinball.rules import lamps
from carom.play.pinball.rules.events import EventKind
from carom.play.pinball.rules.table import BALL_RADIUS, IDLE_SPIN, MOST_SPIN, SERVE_PLACE, STEP, Table


@pytest.fixture
def table() -> Table:
    return Table()


def test_the_table_begins_without_balls_and_steps_by_single_substeps(table: Table) -> None:
    assert len(table.world.balls) == 0
    assert table.world.substeps == 1
    assert table.plunger.kick == 0.0


def test_every_lamp_that_belongs_to_a_part_has_its_place(table: Table) -> None:
    assert set(lamps.PLACED) <= set(table.places)
    assert table.places["low bumper"] == pytest.approx((9.3, 24.6))
    assert all(table.holds(*table.places[name]) for name in lamps.PLACED)


def test_parts_are_found_by_the_ids_that_hits_have(table: Table) -> None:
    kinds = {part.name: part.kind for part in table.parts.values()}
    assert kinds["left bumper"] is EventKind.BUMPER
    assert kinds["left slingshot's band"] is EventKind.SLINGSHOT
    assert kinds["left slingshot"] is EventKind.BOUNCE
    assert kinds["drop target 2"] is EventKind.TARGET
    assert kinds["right flipper"] is EventKind.FLIPPER_HIT
    assert kinds["drain"] is EventKind.DRAIN


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_flipper_moves_in_the_very_next_step_holds_at_its_stop_and_falls_back(table: Table, side: str) -> None:
    flipper = table.left if side == "left" else table.right
    assert flipper.angle == 0.0
    assert flipper.press(True)
    assert not flipper.press(True)
    table.world.step(STEP)
    assert flipper.angle == pytest.approx(22.0 * STEP)
    for _ in range(24):
        table.world.step(STEP)
    assert flipper.raised
    assert flipper.angle == flipper.reach
    assert not flipper.press(False)
    for _ in range(32):
        table.world.step(STEP)
    assert flipper.angle == 0.0


def test_a_flipper_can_be_put_where_another_stands(table: Table) -> None:
    table.right.put(0.4, True)
    assert table.right.angle == pytest.approx(0.4)
    assert table.right.pressed
    table.right.put(table.right.angle, True)
    table.world.step(STEP)
    assert table.right.angle == pytest.approx(0.4 + 22.0 * STEP)
    table.right.put(table.right.angle, False)
    table.world.step(STEP)
    assert table.right.angle < 0.4 + 22.0 * STEP


def test_a_lowered_target_lets_balls_through_until_it_is_raised(table: Table) -> None:
    ball = table.world.add(carom.Ball((16.0, 21.8), BALL_RADIUS, (30.0, 0.0)))

    def names() -> set[str]:
        ball.position, ball.velocity = (16.0, 21.8), (30.0, 0.0)
        return {table.parts[hit.shape.id or 0].name for _ in range(12) for hit in table.world.step(STEP)}

    assert names() == {"drop target 2"}
    table.lower("drop target 2")
    assert table.down == {"drop target 2"}
    assert not table.clear_of_targets(16.6, 21.8)
    assert table.clear_of_targets(14.0, 21.8)
    assert names() == {"right target"}
    ball.position = (9.0, 21.8)
    table.raise_targets()
    assert table.down == set()
    assert names() == {"drop target 2"}


def test_the_spinner_is_turned_by_what_strikes_it_and_slows_down(table: Table) -> None:
    x, y = table.spinner.pivot
    table.strike_spinner((x + 1.5, y), (0.0, 5.0))
    assert table.spinner.angular_velocity == pytest.approx(IDLE_SPIN + 3.0)
    table.strike_spinner((x + 1.5, y), (0.0, -1000.0))
    assert table.spinner.angular_velocity == -MOST_SPIN
    for _ in range(100):
        table.slow_spinner()
    assert table.spinner.angular_velocity == -IDLE_SPIN
    table.slow_spinner()
    assert table.spinner.angular_velocity == -IDLE_SPIN


def test_what_has_moved_is_set_back(table: Table) -> None:
    table.left.press(True)
    table.lower("drop target 1")
    table.strike_spinner((10.0, 18.8), (0.0, 9.0))
    table.reset()
    assert (table.left.pressed, table.down, table.spinner.angular_velocity) == (False, set(), IDLE_SPIN)


def test_a_ball_is_in_the_lane_until_it_is_wholly_past_the_gate(table: Table) -> None:
    assert table.beyond_lane(19.3, 5.0) < 0.0
    assert table.beyond_lane(19.3, 31.4) < BALL_RADIUS
    assert table.beyond_lane(19.3, 32.8) > BALL_RADIUS
    assert table.beyond_lane(9.3, 22.0) > BALL_RADIUS
    assert table.beyond_lane(18.3, 1.8) < 0.0


@pytest.mark.parametrize("place", [(-0.1, 9.0), (20.1, 9.0), (9.0, -0.1), (2.0, 40.0), (10.0, 42.1)])
def test_outside_of_the_cabinet_no_ball_can_be(table: Table, place: tuple[float, float]) -> None:
    assert not table.holds(*place)
    assert table.holds(10.0, 41.0)
    assert table.holds(10.0, 5.0)


def test_a_ball_is_cradled_on_a_raised_flipper_alone(table: Table) -> None:
    on = (5.15, 9.96)
    assert not table.cradled(*on)
    table.left.put(table.left.reach, True)
    assert table.cradled(*on)
    assert not table.cradled(9.3, 12.0)
    table.left.press(False)
    assert not table.cradled(*on)


def test_both_flippers_turn_by_the_same_angle(table: Table) -> None:
    assert table.left.reach == table.right.reach == pytest.approx(56.0 * pi / 180.0)
    assert (table.left.up, table.right.up) == (1.0, -1.0)
    assert table.middle == pytest.approx(9.3)


@pytest.mark.compiled
def test_a_held_flipper_catches_a_ball_that_rolls_down_the_inlane(table: Table) -> None:
    ball = table.world.add(carom.Ball((2.55, 14.5), BALL_RADIUS, (0.0, -5.0)))
    table.left.press(True)
    table.world.run(3.0, STEP)
    assert table.cradled(*ball.position)
    assert max(map(abs, ball.velocity)) < 0.1


def cradled(table: Table) -> tuple[carom.Ball, bytes]:
    """A ball that lies still on the raised left flipper, and the world as it is then."""
    ball = table.world.add(carom.Ball((2.55, 12.0), BALL_RADIUS))
    table.left.press(True)
    table.world.run(3.5, STEP)
    assert table.cradled(*ball.position)
    return ball, table.world.snapshot()


def again(table: Table, snapshot: bytes) -> None:
    """Set the table back to where a ball is cradled on the left."""
    table.world.restore(snapshot)
    table.left.pressed, table.right.pressed = True, False


@pytest.mark.slow
@pytest.mark.compiled
def test_a_caught_ball_can_be_shot_at_what_one_likes(table: Table) -> None:
    _, snapshot = cradled(table)
    seen = set()
    for wait in range(184, 304, 2):
        again(table, snapshot)
        table.left.press(False)
        table.world.run(wait * STEP, STEP)
        table.left.press(True)
        hits = table.world.run(0.8, STEP)
        seen |= {table.parts[shape].name for shape in hits["shape"].tolist()}
    assert {"right orbit", "drop target 1", "spinner", "right slingshot's band"} <= seen


def left_with(table: Table, ball: carom.Ball) -> tuple[float, float]:
    """The angle in degrees and the speed with which a ball leaves the left flipper that swings up now."""
    velocity = ball.velocity
    table.left.press(True)
    for _ in range(30):
        table.world.step(STEP)
        if min(shape.distance(ball.position) for shape in table.left.shape.shapes) < BALL_RADIUS + 0.01:
            velocity = ball.velocity
    return degrees(atan2(velocity[1], velocity[0])), hypot(*velocity)


@pytest.mark.compiled
@pytest.mark.parametrize("feed", ["cradle", "inlane"])
def test_the_later_the_flip_the_farther_across_and_the_root_is_the_weakest(table: Table, feed: str) -> None:
    if feed == "cradle":
        ball, snapshot = cradled(table)
        waits = range(120, 328, 4)
    else:
        ball = table.world.add(carom.Ball((2.55, 14.5), BALL_RADIUS, (0.0, -5.0)))
        snapshot, waits = table.world.snapshot(), range(296, 396, 4)
    shots = []
    for wait in waits:
        again(table, snapshot)
        table.left.press(False)
        table.world.run(wait * STEP, STEP)
        shots.append(left_with(table, ball))
    angles, speeds = zip(*shots, strict=True)
    assert all(later < sooner + 0.3 for sooner, later in pairwise(angles))
    assert angles[0] - angles[-1] > 30.0
    assert all(inner < outer for inner, outer in pairwise(speeds[: len(speeds) // 3]))
    assert speeds[0] < 0.6 * max(speeds) < 60.0


@pytest.mark.compiled
def test_a_caught_ball_can_be_passed_to_the_other_flipper(table: Table) -> None:
    ball, snapshot = cradled(table)
    caught = []
    for wait in range(226, 240, 2):
        again(table, snapshot)
        table.right.press(True)
        table.left.press(False)
        table.world.run(wait * STEP, STEP)
        table.left.press(True)
        table.world.run(6 * STEP, STEP)
        table.left.press(False)
        table.world.run(3.0, STEP)
        caught.append(table.cradled(*ball.position) and ball.position[0] > table.middle)
    assert any(caught)


@pytest.mark.compiled
def test_nothing_tunnels_at_the_highest_speed(table: Table) -> None:
    world = table.world
    assert world.max_speed is not None
    flippers = (table.left, table.right)
    for way in range(24):
        ball = world.add(carom.Ball((9.3, 13.0), BALL_RADIUS))
        vx, vy = carom.angle_to_vector(way * pi / 12.0)
        ball.velocity = (world.max_speed * vx, world.max_speed * vy)
        for step in range(480):
            if step % 30 == 0:
                for flipper in flippers:
                    flipper.press(not flipper.pressed)
            world.step(STEP)
            x, y = ball.position
            assert table.holds(x, y)
            if y < 6.5:
                break
            assert table.beyond_lane(x, y) > 0.0
        world.remove(ball)


def test_a_step_compares_a_ball_with_few_shapes_so_that_it_is_quick_enough_interpreted_too(table: Table) -> None:
    table.world.add(carom.Ball(SERVE_PLACE, BALL_RADIUS))
    table.world.run(1.0, STEP)
    before = table.world.statistics.box_tests
    for _ in range(48):
        table.world.step(STEP)
    # The ball is pressed into the corner of the plunger, where it meets its neighbours in every iteration.
    assert (table.world.statistics.box_tests - before) / 48 < 100
