"""A step of the continuous mode: impacts one after the other at their exact times, however long the step is."""

from itertools import pairwise
from math import sqrt

import numpy as np
import pytest

from carom import Ball, Circle, HitKind, Segment, World
from carom.rows.hit import HIT_ROW
from carom.rows.saved import KEPT, PAIRS_DUE, SHAPES_DUE
from carom.rows.state import BEGIN, DONE, NEEDS_PAIRS, NEEDS_ROOM, SHAPES
from carom.world.kernels.continuous.film import begin_parting, fly, step_continuous
from tests.kernel_calls import film_tables, foresee_all, in_flight, prepared
from tests.worlds import box, continuous_world, starve


@pytest.mark.parametrize("steps", [1, 7])
def test_a_dropped_ball_bounces_at_the_times_of_the_textbook(steps: int) -> None:
    world = continuous_world(Segment((-9, 0), (9, 0), elasticity=0.5), gravity=(0, -10), rest_speed=0.0)
    world.add(Ball((0, 6), 1))
    times = [float(time) for _ in range(steps) for time in world.step(2.4 / steps)["time"]]
    fall = sqrt(2 * 5 / 10)
    expected = [fall]
    while expected[-1] + 2 * fall * 0.5 ** len(expected) < 2.4:
        expected.append(expected[-1] + 2 * fall * 0.5 ** len(expected))
    assert times == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("dt", [20.0, 0.3])
def test_a_ball_between_walls_is_where_a_mirror_says(dt: float) -> None:
    world = continuous_world(*box(10.0, 7.0))
    ball = world.add(Ball((2, 3), 1, velocity=(3, -2)))
    hits = world.run(60, dt=dt)

    def mirrored(start: float, width: float) -> float:
        """Where a ball is that runs to and fro."""
        away = (start - 1) % (2 * (width - 2))
        return 1 + min(away, 2 * (width - 2) - away)

    assert ball.position == pytest.approx((mirrored(2 + 3 * 60, 10.0), mirrored(3 - 2 * 60, 7.0)), abs=1e-9)
    # It has 8 to run from side to side and had run 1 of them, 5 from floor to roof and had run 3.
    assert len(hits) == (1 + 3 * 60) // 8 + (3 + 2 * 60) // 5
    assert all(first <= second for first, second in pairwise(hits["time"].tolist()))


def test_a_ball_hits_a_closing_wall_ever_faster() -> None:
    press = Segment((20, -1), (20, 1), motion="kinematic", velocity=(-1, 0))
    world = continuous_world(Segment((0, -1), (0, 1)), press)
    ball = world.add(Ball((1, 0), 1, velocity=(3, 0)))
    place, speed, wall, time, speeds = 1.0, 3.0, 20.0, 0.0, []
    for _ in range(3):  # to the press, and back to the wall
        there = (wall - 1 - place) / (speed + 1)
        time, wall, speed = time + there, wall - there, speed + 2
        back = (wall - 2) / speed
        time, wall, place = time + back, wall - back, 1.0
        speeds.append(speed)
    hits = world.step(time + 1e-6)
    assert len(hits) == 6
    assert ball.velocity[0] == pytest.approx(speeds[-1])
    assert hits["time"][-1] == pytest.approx(time)


def test_a_sensor_is_entered_and_left_at_the_times_of_its_border_in_one_step() -> None:
    world = continuous_world(Circle((0, 0), 2, solid=True, sensor=True))
    world.add(Ball((-10, 0), 1, velocity=(4, 0)))
    hits = world.step(10.0)
    assert [(hit.kind, hit.time) for hit in hits] == [
        (HitKind.ENTER, pytest.approx(7 / 4)),
        (HitKind.EXIT, pytest.approx(13 / 4)),
    ]


def gas(**settings: object) -> World:
    """Balls in a box, enough for cells."""
    world = continuous_world(*box(8, 8), **settings)
    random = np.random.default_rng(1)
    cells = np.stack(np.meshgrid(np.arange(5.0), np.arange(5.0)), -1).reshape(-1, 2)
    world.add_balls(1.5 + 1.2 * cells, velocity=random.normal(0, 3, (25, 2)), radius=0.3)
    return world


@pytest.mark.parametrize("gravity", [(0, 0), (0, -3)])
def test_a_kernel_that_comes_back_for_room_goes_on_to_the_same_bits(gravity: tuple[float, float]) -> None:
    films = []
    for starved in (False, True):
        world, hits = gas(gravity=gravity), []
        for _ in range(8):
            if starved:
                starve(world)
            hits += [hit.tobytes() for hit in np.asarray(world.step(1 / 8))]
        films.append((hits, world.balls.position.tolist(), world.balls.velocity.tolist()))
    assert films[0] == films[1]
    assert len(films[0][0]) > 40


def test_the_kernel_asks_for_the_room_that_it_needs() -> None:
    world = gas()
    arrays = prepared(world)
    arrays.states[0]["dt"], arrays.states[0]["steps_left"] = 0.125, 1
    arrays.hits, arrays.starts = arrays.hits[:0].copy(), arrays.starts[:0].copy()
    status = step_continuous(*arrays.block().arguments)
    seen = set()
    while status != DONE:
        seen.add(status)
        arrays.extend(status)
        status = step_continuous(*arrays.block().arguments)
    assert seen == {NEEDS_ROOM, NEEDS_PAIRS}
    assert (arrays.states[0]["stage"], arrays.states[0]["steps_left"]) == (BEGIN, 0)


def test_fly_deals_with_all_up_to_the_horizon_and_no_more() -> None:
    arrays = in_flight(continuous_world(Segment((0, -5), (0, 5)), Ball((3, 0), 1, velocity=(-2, 0))), 1.0)
    heads = foresee_all(arrays)
    tables = *film_tables(arrays), heads, arrays.hits.view(HIT_ROW), arrays.relations, arrays.flights, arrays.queue
    assert fly(arrays.states[0], arrays.balls.rows, *tables, arrays.island) == DONE
    # The impact is at the horizon, to the bit: it belongs to this step.
    assert (arrays.states[0]["hits"], arrays.states[0]["now"]) == (1, 1.0)
    assert arrays.balls.rows["vx"][0] == 2
    assert arrays.flights["time"][0] == 1.0


def test_balls_are_parted_by_the_stages_of_the_discrete_mode() -> None:
    world = gas()
    world.step(0.1)
    arrays = world._arrays
    state = arrays.states[0]
    world.balls.position[3] += 0.125
    begin_parting(state, arrays.balls.rows, arrays.flights, arrays.saved)
    assert state["stage"] == SHAPES
    kept = [KEPT * (k != 3) for k in range(25)]
    assert arrays.saved["touched"][:25].tolist() == [SHAPES_DUE | PAIRS_DUE | bit for bit in kept]


def test_balls_put_onto_each_other_are_moved_apart_before_they_fly() -> None:
    world = continuous_world(Ball((0, 0), 1, (1, 0)), Ball((1.5, 0), 1, (-1, 0)))
    (hit,) = world.step(0.5)
    assert hit.time == 0.0
    first, second = world.balls.position
    assert second[0] - first[0] == pytest.approx(2 + 2 * 0.5)
