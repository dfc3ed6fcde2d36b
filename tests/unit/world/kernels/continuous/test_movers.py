"""Kinematic shapes in the film: where they are follows from the time alone, and where they stop they stop exactly."""

from math import inf
from random import Random
from typing import Any

import pytest

from carom import Segment, World
from carom.world.kernels.continuous.movers import (
    begin_motion,
    change_movers,
    foresee_changes,
    list_movers,
    moves_as_before,
    orientation_at,
    show_movers,
    take_back,
    take_up_changed,
    time_to_change,
    time_to_stop,
    unlist_resting,
)
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight, look_at, prepared
from tests.worlds import continuous_world


def hand(**options: Any) -> Segment:
    """A hand that turns about its end."""
    return Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), **options)


def going(*hands: Segment) -> Arrays:
    """The tables of a world in which shapes have begun to move."""
    return in_flight(continuous_world(*hands), 1.0)


def shown(world: World) -> list[Any]:
    """Where the shapes are, to the bit."""
    return [(shape.orientation, shape.position, shape.angular_velocity, shape.velocity) for shape in world.shapes]


def clock() -> World:
    """Hands that turn for ever, that stop soon or late, that travel, and that are sent somewhere."""
    kept = [
        hand(angular_velocity=0.7, velocity=(0.1, -0.3)),
        hand(angular_velocity=2.0, turn_limits=(-1, 0.5)),
        hand(angular_velocity=-0.33, turn_limits=(-1, 0.5)),
        hand(),
        hand(),
    ]
    world = continuous_world(*kept)
    kept[3].move_to((3, 4), dt=1.7, orientation=0.4)
    kept[4].move_to((0, 1), dt=5.0)
    return world


@pytest.mark.parametrize("steps", [[8] * 128, [1, 700, 3, 64, 5, 200, 17, 33, 1], [512, 512]])
def test_where_shapes_are_follows_from_the_time_alone(steps: list[int]) -> None:
    one, other = clock(), clock()
    for _ in range(4):
        one.step(1.0)
        for step in steps:
            other.step(step / 1024)
        assert shown(one) == shown(other)


def test_a_hand_that_turns_for_ever_does_not_drift() -> None:
    world = continuous_world(hand(angular_velocity=0.7, velocity=(0.1, -0.3)))
    for _ in range(1000):
        world.step(1 / 60)
    (found,) = world.shapes
    assert found.orientation == pytest.approx(0.7 * world.time, rel=1e-15)
    assert world._arrays.shapes.used[0]["pivot_x"] == pytest.approx(0.1 * world.time, rel=1e-15)


def test_stops_and_goals_are_reached_to_the_bit() -> None:
    world = clock()
    world.run(6.0, dt=1 / 60)
    kept = world.shapes
    assert kept[1].orientation == 0.5
    assert kept[2].orientation == -1
    assert (kept[3].position, kept[3].orientation) == ((3, 4), 0.4)
    assert kept[4].position == (0, 1)
    assert [(shape.angular_velocity, shape.velocity) for shape in list(kept)[1:]] == [(0, (0, 0))] * 4


def test_the_time_to_a_stop_is_the_way_to_it_by_the_speed() -> None:
    def waits(time_left: float = 0.0, **options: Any) -> tuple[float, float]:
        row = hand(**options)._row
        row["time_left"] = time_left
        begin_motion(row, 3.0, 0.0)
        return time_to_stop(row), time_to_change(row)

    assert waits(angular_velocity=2.0, turn_limits=(-1, 0.5)) == (0.25, 0.25)
    assert waits(angular_velocity=-2.0, turn_limits=(-1, 0.5)) == (0.5, 0.5)
    assert waits(0.125, angular_velocity=-2.0, turn_limits=(-1, 0.5)) == (0.5, 0.125)
    assert waits(angular_velocity=2.0) == (-1.0, inf)
    assert waits(turn_limits=(-1, 0.5)) == (-1.0, inf)
    assert waits(0.25) == (-1.0, 0.25)


@pytest.mark.parametrize("seed", range(8))
def test_the_first_shape_that_stops_or_arrives_is_foreseen_and_is_there_exactly(seed: int) -> None:
    random = Random(seed)
    times, hands = [], []
    world = continuous_world()
    for _ in range(5):
        stop, duration, spin = random.uniform(0.1, 4), random.uniform(0.1, 2), random.choice((-2.0, 3.0))
        hands.append(world.add(hand(turn_limits=(-stop, stop))))
        if random.random() < 0.4:
            hands[-1].move_to((random.uniform(-1, 1), 0), dt=duration)
            times.append(duration)
        else:
            hands[-1].angular_velocity = spin
            times.append(stop / abs(spin))
    arrays = in_flight(world)
    state, shapes, order = arrays.states[0], arrays.shapes.rows, arrays.order
    foresee_changes(state, shapes, order)
    assert state["change"] + state["change_low"] == pytest.approx(min(times))
    first = times.index(min(times))
    state["now"], state["now_low"] = state["change"], state["change_low"]
    change_movers(state, shapes, order)
    row = shapes[first]
    assert (row["spin"], row["velocity_x"], row["velocity_y"], row["since"]) == (0, 0, 0, state["now"])
    if row["turn_low"] in (row["orientation"], -row["orientation"]):
        assert abs(float(row["orientation"])) == float(row["turn_high"])
    later = sorted(times)[1]
    assert state["change"] == pytest.approx(later)


def test_rows_show_where_shapes_are_and_are_taken_back_to_where_their_motion_began() -> None:
    arrays = going(hand(angular_velocity=2.0, velocity=(1, 0)), hand())
    state, shapes, order = arrays.states[0], arrays.shapes.rows, arrays.order
    before = shapes[:2].copy()
    look_at(arrays, 0.25)
    show_movers(state, shapes, order)
    assert (shapes[0]["orientation"], shapes[0]["pivot_x"]) == (0.5, 0.25)
    assert shapes[1].tobytes() == before[1].tobytes()
    take_back(state, shapes, order)
    for name in ("orientation", "pivot_x", "ax", "ay", "bx", "by", "left", "top", "time_left"):
        assert shapes[0][name] == before[0][name]


def test_a_hand_is_never_shown_beyond_its_stop() -> None:
    row = hand(angular_velocity=2.0, turn_limits=(-1, 0.5))._row
    begin_motion(row, 0.0, 0.0)
    assert orientation_at(row, 0.25 - 1e-17) == 0.5
    assert orientation_at(row, 0.3) == 0.5
    assert orientation_at(row, -9.0) == -1.0


def test_those_that_move_or_are_sent_are_listed_until_they_rest() -> None:
    rests, turns, travels, sent = hand(), hand(angular_velocity=1.0, turn_limits=(-1, 1)), hand(velocity=(1, 0)), hand()
    world = continuous_world(Segment((5, 5), (6, 6)), rests, turns, travels, sent)
    sent.move_to((1, 0), dt=0.5)  # where it is: it does not move on the way
    arrays = prepared(world)
    tables = arrays.states[0], arrays.shapes.rows, arrays.order

    def listed() -> list[int]:
        return arrays.order[5 : 5 + arrays.states[0]["movers"]].tolist()

    take_up_changed(*tables)
    assert listed() == [2, 3, 4]
    # One that rests without a mark of it is taken out; who begins to move is found by those who look at all.
    arrays.shapes.rows[2]["spin"] = 0.0
    arrays.shapes.rows[1]["spin"] = 1.0
    unlist_resting(*tables)
    assert listed() == [3, 4]
    list_movers(*tables)
    assert listed() == [1, 3, 4]
    assert arrays.order[:5].tolist() == [0, 1, 2, 3, 4]


def test_a_world_that_looks_at_its_tables_anew_knows_what_moves() -> None:
    world = clock()
    for seconds, moving in ((0.125, [0, 1, 2, 3, 4]), (1.75, [0, 2, 4]), (2.0, [0, 4]), (2.0, [0])):
        world.step(seconds)
        world._changed_all(of_flights=False)
        world._arrays.prepare()
        assert world._arrays.order[5 : 5 + world._arrays.states[0]["movers"]].tolist() == moving


@pytest.mark.parametrize("speed", [1.0, 1e3, 1e9])
@pytest.mark.parametrize("stop", [1.0, 0.3, 2.0])
def test_what_comes_to_a_stop_has_travelled_no_farther_than_its_speed_brings_it(speed: float, stop: float) -> None:
    world = continuous_world(hand(angular_velocity=0.125, velocity=(speed, 0), turn_limits=(-1, stop)))
    for _ in range(40):
        world.step(0.5)
    (found,) = world.shapes
    assert found.orientation == stop
    assert found.pivot[0] == pytest.approx(20 * speed, rel=1e-15)


def test_what_is_sent_and_stops_on_the_way_arrives_when_it_was_to() -> None:
    sent = hand(turn_limits=(-1, 0.5))
    world = continuous_world(sent)
    sent.move_to((3, 4), dt=2.0, orientation=0.5)
    row = sent._row
    row["angular_velocity"] = 1.0  # faster than it was to turn
    world.step(1.0)
    assert (sent.orientation, row["time_left"]) == (0.5, pytest.approx(1.0, rel=1e-15))
    world.step(1.0)
    assert (sent.position, sent.velocity) == ((3, 4), (0, 0))


def test_a_motion_that_was_not_changed_is_told_from_one_that_was() -> None:
    arrays = going(hand(angular_velocity=2.0, velocity=(1, 0), turn_limits=(-1, 1)), hand())
    state, shapes, order = arrays.states[0], arrays.shapes.rows, arrays.order
    look_at(arrays, 0.25)
    show_movers(state, shapes, order)
    before = shapes[:2].copy()
    assert all(moves_as_before(state, shape) for shape in shapes[:2])
    for field in ("angular_velocity", "velocity_x", "velocity_y", "orientation", "pivot_x", "pivot_y", "time_left"):
        for k in range(2):
            shapes[k][field] += 1e-9
            assert not moves_as_before(state, shapes[k])
            shapes[k] = before[k]
    shapes[0]["rotating"] = 0
    assert not moves_as_before(state, shapes[0])
