"""How balls and kinematic shapes move in a substep, and which sleepers that wakes."""

from math import cos, hypot, sin

import numpy as np
import pytest

from carom import Ball, Segment
from carom.rows.tables import Row
from carom.world.kernels.broad_phase.shape_index import MOVING
from carom.world.kernels.step.beginning import list_restless
from carom.world.kernels.step.motion import (
    EVERYWHERE,
    box_of_ways,
    is_far_from_all,
    move_shapes,
    moved,
    put_ball,
    rouse,
    slow_by_friction,
    turn_of,
    turning_bulge,
    wake,
    wake_in_box,
)
from tests.kernel_calls import advance_pose, ball_rows, prepared, state_row
from tests.worlds import world_of


def ball_row(*values: float) -> Row:
    """The row of a ball with a place and a velocity."""
    row = ball_rows([(0.0, 0.0, 1.0)])[0]
    row["x"], row["y"], row["vx"], row["vy"] = values
    return row


def test_a_ball_moves_along_its_parabola_in_one_substep_or_in_many() -> None:
    whole, parts = ball_row(1.0, 2.0, 3.0, -4.0), ball_row(1.0, 2.0, 3.0, -4.0)
    put_ball(whole, *moved(whole, 0.5, 0.25, -10.0))
    for _ in range(8):
        put_ball(parts, *moved(parts, 0.0625, 0.25, -10.0))
    expected = 1 + 3 * 0.5 + 0.25 * 0.125, 2 - 4 * 0.5 - 10 * 0.125, 3 + 0.25 * 0.5, -4 - 10 * 0.5
    for row in (whole, parts):
        assert tuple(row[name] for name in ("x", "y", "vx", "vy")) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("turn", [0.01, 0.5, 2.0, 9.0])
def test_a_turning_shape_strays_from_the_straight_way_by_its_bulge_at_most(turn: float) -> None:
    hand = Segment((1, 1), (4, 2), motion="kinematic", pivot=(0.5, 0))._row
    hand["orientation"], hand["orientation_before"] = turn, 0.0
    bulge, seen = turning_bulge(hand), 0.0
    for place in np.linspace((1, 1), (4, 2), 20) - (0.5, 0):
        turned = [(cos(a) * place[0] - sin(a) * place[1], sin(a) * place[0] + cos(a) * place[1]) for a in (turn, 0)]
        for share in np.linspace(0, 1, 40):
            angle = share * turn
            x, y = cos(angle) * place[0] - sin(angle) * place[1], sin(angle) * place[0] + cos(angle) * place[1]
            # The nearest place of the straight way between where it was and is.
            away = np.subtract(*turned)
            along = np.clip(np.dot((x, y) - np.array(turned[1]), away) / np.dot(away, away), 0, 1)
            seen = max(seen, float(np.hypot(*((x, y) - np.array(turned[1]) - along * away))))
    assert seen <= bulge <= 2 * hypot(3.5, 2) + 1e-12
    assert bulge < 1.5 * seen or turn > 1.0


def test_a_shape_wakes_the_sleepers_in_its_way_and_no_others() -> None:
    world = world_of(Segment((0, 0), (1, 0), motion="kinematic", velocity=(0, 8)), sleep_speed=1.0)
    for y in (2.0, 3.9, 4.4, 5.2):
        world.add(Ball((0.5, y), 0.5))
    room = prepared(world)
    balls, state = room.balls.used, room.states[0]
    balls["asleep"], state["sleeping"] = 1, 4
    assert move_shapes(state, balls, room.shapes.rows, room.order, room.index[MOVING], 0.5)
    assert balls["asleep"].tolist() == [0, 0, 0, 1]
    assert state["sleeping"] == 1
    assert room.shapes.rows[0]["cy"] == 4.0


def test_a_world_of_shapes_at_rest_does_not_move() -> None:
    room = prepared(world_of(Segment((0, 0), (1, 0)), Segment((0, 1), (1, 1), motion="kinematic")))
    before = room.shapes.used.tobytes()
    assert not move_shapes(room.states[0], room.balls.rows, room.shapes.rows, room.order, room.index[MOVING], 0.5)
    assert room.shapes.used.tobytes() == before


def test_the_box_around_all_ways_hides_no_ball_from_a_shape_that_turns() -> None:
    random, far, seen_by_box = np.random.default_rng(1), 0, 0
    nowhere = np.inf, np.inf, -np.inf, -np.inf
    for scale in np.geomspace(1e-6, 1e6, 1000):
        corner = random.uniform(-1, 1, 2) * scale * random.choice((0.0, 1.0, 1e9))
        # Where all lies along one axis there is nothing to spare.
        flat = np.array((1.0, random.choice((0.0, 1.0)))) * scale
        x, y = (corner + random.uniform(0, 4, (2, 2)) * flat).T
        hand = Segment((x[0], y[0]), (x[1], y[1]), motion="kinematic", pivot=tuple(corner))._row
        balls = ball_rows((*(corner + random.uniform(-16, 16, 2) * flat), 0.3 * scale) for _ in range(2))
        balls["vx"], balls["vy"] = random.uniform(-9, 9, (2, 2)) * scale
        state = state_row(balls, "grid", 1)
        state["gravity_y"] = -5.0 * scale
        around = box_of_ways(state, balls, 0.1)
        exact = is_far_from_all(state, balls, hand, 0.1, EVERYWHERE)
        assert is_far_from_all(state, balls, hand, 0.1, around) == exact
        far, seen_by_box = far + exact, seen_by_box + is_far_from_all(state, balls, hand, 0.1, around)
    assert 100 < far < 900
    assert is_far_from_all(state, balls, hand, 0.1, nowhere)


def test_shapes_that_turn_alike_or_not_are_each_where_their_own_turn_puts_them() -> None:
    spins = 0.3, 0.3, -7.0, 0.3, 0.0, 1e300
    hands = [Segment((1, k), (4, 2), motion="kinematic", pivot=(0, 0), angular_velocity=spins[k]) for k in range(6)]
    room = prepared(world_of(*hands, substeps=1))
    room.states[0]["moving_stale"] = 1
    list_restless(room.states[0], room.shapes.rows, room.order, room.index[MOVING])
    alone = [Segment((1, k), (4, 2), motion="kinematic", pivot=(0, 0), angular_velocity=spins[k]) for k in range(6)]
    for _ in range(3):
        assert move_shapes(room.states[0], room.balls.rows, room.shapes.rows, room.order, room.index[MOVING], 0.5)
        for row, hand in zip(room.shapes.used, alone, strict=True):
            advance_pose(hand._row, 0.5)
            expected = hand._row.copy()
            expected["id"] = row["id"]
            assert row == expected


def test_a_turn_that_is_known_is_not_computed_again() -> None:
    one, other = (0.5, 7.0, 8.0), (0.25, 9.0, 10.0)
    assert turn_of(0.5, one, other) == one
    assert turn_of(0.25, one, other) == other
    assert turn_of(2.0, one, other) == (2.0, cos(2.0), sin(2.0))


def test_who_is_woken_counts_its_rest_anew_and_who_is_roused_does_not() -> None:
    for how, still_time in ((wake, 0.0), (rouse, 3.0)):
        ball, state = ball_row(0, 0, 0, 0), state_row(ball_rows([]), "grid", 1)
        ball["asleep"], ball["still_time"], state["sleeping"] = 1, 3.0, 2
        for _ in range(2):
            how(state, ball)
            assert (ball["asleep"], ball["still_time"], state["sleeping"]) == (0, still_time, 1)


def test_a_box_wakes_the_balls_that_touch_it() -> None:
    rows = ball_rows([(-1.0, 0.5, 1.0), (-1.001, 0.5, 1.0), (0.5, 2.0, 1.0), (0.5, 2.001, 1.0)])
    rows["asleep"], state = 1, state_row(rows, "grid", 1)
    state["sleeping"] = 4
    wake_in_box(state, rows, 0.0, 0.0, 1.0, 1.0)
    assert rows["asleep"].tolist() == [0, 1, 0, 1]


def test_friction_takes_its_loss_and_never_turns_a_ball_about() -> None:
    for loss, left in ((1.0, 4.0), (4.999, 0.001), (5.0, 0.0), (7.0, 0.0)):
        ball = ball_row(0, 0, 3.0, -4.0)
        slow_by_friction(ball, loss)
        assert (ball["vx"], ball["vy"]) == pytest.approx((0.6 * left, -0.8 * left), abs=1e-14)
