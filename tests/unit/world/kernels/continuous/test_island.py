"""Who an island is made of: components of graphs, contacts once each and in their order, surfaces, ticks."""

from math import cos, inf, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Circle, Segment, World
from carom.constants import ISLAND_TICK, ISLAND_TURN, REBOUND, STILL_SPEED
from carom.rows.flight import NO_BALL, NO_TICK
from carom.rows.island import NO_BODY
from carom.rows.pose import is_moving
from carom.rows.relation import LASTING, LYING
from carom.world.kernels.continuous.island import (
    aim_at_middle,
    collect,
    dismiss,
    enlist_neighbours,
    fill_contacts,
    hasten,
    join,
    lies,
    next_tick,
    part,
    part_from_all,
    pull_on,
    rest_speed_of,
    tick_length,
)
from carom.world.kernels.step.relations import add_relation, find_relation, set_force
from carom.world.tables import Arrays
from tests.heaps import heap, is_symmetric, joined, pairs_of, taken_apart
from tests.islands import pyramid
from tests.kernel_calls import in_flight, look_at
from tests.worlds import continuous_world

COUNT = 14


def crowd() -> Arrays:
    """Balls far from each other, in flight."""
    world = World(detection="continuous")
    world.add_balls([(3.0 * k, 0.0) for k in range(COUNT)], radius=1.0)
    return in_flight(world)


def component(links: list[tuple[int, int]], seeds: set[int]) -> set[int]:
    """Who hangs together with these, by asking all links until nobody new is found."""
    found = set(seeds)
    while True:
        more = {end for link in links if found & set(link) for end in link} - found
        if not more:
            return found
        found |= more


@given(st.integers(0, 10**6))
def test_an_island_is_a_component_of_who_lies_on_whom_and_leaves_no_trace(seed: int) -> None:
    random = np.random.default_rng(seed)
    drawn = random.integers(0, COUNT, (int(random.integers(0, 20)), 2)).tolist()
    links = [(i, j) for i, j in drawn if i != j]
    arrays = joined(crowd(), links)
    first, second = (int(i) for i in random.choice(COUNT, 2, replace=False))
    second = NO_BALL if random.random() < 0.5 else second
    bodies, _ = arrays.island
    bodies["ball"], bodies["core"] = 99, 7
    count = collect(arrays.balls.rows, arrays.flights, arrays.relations, bodies, first, second)
    expected = component(links, {first} | ({second} - {NO_BALL}))
    assert sorted(bodies["ball"][:count].tolist()) == sorted(expected)
    assert (bodies["core"][:count] == 1).all()
    assert (bodies["ball"][count:] == 99).all()
    for k in range(count):
        assert arrays.flights[bodies[k]["ball"]]["body"] == k + 1
    dismiss(arrays.flights, bodies, count)
    assert (arrays.flights["body"] == 0).all()


@pytest.mark.slow
@given(st.integers(0, 10**6))
def test_who_lies_on_whom_is_known_to_both_whatever_begins_and_ends(seed: int) -> None:
    random = np.random.default_rng(seed)
    arrays, pairs = joined(crowd(), []), set[frozenset[int]]()
    tables = arrays.states[0], arrays.balls.rows, arrays.relations
    before = int(arrays.states[0]["relations"])
    for _ in range(40):
        i, j = (int(k) for k in random.choice(COUNT, 2, replace=False))
        what = int(random.integers(5))
        if what < 3:
            join(*tables, i, j)
            pairs.add(frozenset((i, j)))
        elif what == 3:
            part(*tables, i, j)
            pairs.discard(frozenset((i, j)))
        else:
            part_from_all(*tables, i)
            pairs = {pair for pair in pairs if i not in pair}
        assert is_symmetric(pairs_of(arrays))
        assert {frozenset(pair) for pair in pairs_of(arrays)} == pairs
        assert arrays.states[0]["relations"] == before + 2 * len(pairs)
        assert lies(arrays.relations, arrays.balls.rows[i]) == any(i in pair for pair in pairs)


def test_an_island_that_is_hastened_is_solved_now_and_no_other() -> None:
    arrays = joined(crowd(), [(0, 1), (1, 2), (5, 6)])
    arrays.flights["tick_time"] = 9.0
    look_at(arrays, 0.25)
    rows = arrays.balls.rows, arrays.flights, arrays.relations
    arrays.states[0]["step_number"] += 1
    hasten(arrays.states[0], *rows, arrays.island[0], 2)
    assert arrays.flights["tick_time"][:7].tolist() == [0.25, 0.25, 0.25, 9, 9, 9, 9]
    assert (arrays.flights["body"] == 0).all()
    # A step that fails puts back what was hastened.
    half = len(arrays.flights) // 2
    assert (arrays.flights["kept"][:7] == arrays.states[0]["step_number"]).tolist() == [True] * 3 + [False] * 4
    assert (arrays.flights["tick_time"][half : half + 3] == 9.0).all()


def pit(random: np.random.Generator, rows: int = 3) -> Arrays:
    """A pyramid between walls, on a floor that moves; the order of all relations is any."""
    places, _ = pyramid(rows)
    floor = Segment((-5, 0), (rows + 5, 0), motion="kinematic", velocity=(0.5, 0.25))
    walls = [Segment((-0.5, -1), (-0.5, 5)), Segment((rows - 0.5, 5), (rows - 0.5, -1)), floor]
    shapes = [walls[k] for k in random.permutation(3)]
    order = random.permutation(len(places))
    return heap(continuous_world(*shapes, *[Ball(tuple(places[k]), 0.5) for k in order], gravity=(0, -10)))


@pytest.mark.slow
@given(st.integers(0, 10**6))
def test_contacts_are_listed_once_each_what_stands_still_last(seed: int) -> None:
    random = np.random.default_rng(seed)
    arrays = pit(random)
    rows, relations = arrays.balls.rows, arrays.relations
    for i, j in pairs_of(arrays):
        set_force(relations, rows[i], LYING, j, 0.0, float(min(i, j) + 10 * max(i, j)))
    for i, row in pairs_of(arrays, LASTING):
        set_force(relations, rows[i], LASTING, row, 1000.0 + i + 10 * row, 0.0)
    count, found = taken_apart(arrays, [int(i) for i in random.permutation(arrays.balls.count)])
    bodies, contacts = arrays.island[0][:count], arrays.island[1][:found]
    pairs = contacts[contacts["second"] != NO_BODY]
    ends = [sorted((int(bodies[pair["first"]]["ball"]), int(bodies[pair["second"]]["ball"]))) for pair in pairs]
    assert sorted(ends) == sorted([i, j] for i, j in pairs_of(arrays) if i < j)
    assert pairs["force"].tolist() == [i + 10 * j for i, j in ends]
    held = contacts[contacts["second"] == NO_BODY]
    sides = [(int(bodies[contact["first"]]["ball"]), int(contact["shape"])) for contact in held]
    assert sorted(sides) == sorted(pairs_of(arrays, LASTING))
    assert held["force"].tolist() == [1000 + i + 10 * row for i, row in sides]
    kinds = [0 if one["second"] != NO_BODY else 2 - is_moving(arrays.shapes.rows[one["shape"]]) for one in contacts]
    assert kinds == sorted(kinds)
    assert {0, 1, 2} == set(kinds)


def test_of_a_part_of_an_island_all_contacts_of_its_core_are_listed_and_no_others() -> None:
    arrays = heap(continuous_world(*[Ball((float(k), 0), 0.5) for k in range(6)], Segment((-5, -0.5), (9, -0.5))))
    bodies, _contacts = arrays.island
    count, _ = taken_apart(arrays, [2, 3])
    bodies["core"][:2] = 0
    count = enlist_neighbours(arrays.balls.rows, arrays.flights, arrays.relations, bodies, count, 0)
    assert bodies["ball"][:count].tolist() == [2, 3, 1]
    assert bodies["core"][:count].tolist() == [1, 0, 0]
    assert core_contacts(arrays, count) == [(2, 3), (2, 1), (2, "floor")]
    dismiss(arrays.flights, bodies, count)


def core_contacts(arrays: Arrays, count: int) -> list[tuple[int, int | str]]:
    """The contacts of the core of an island, by the balls' rows."""
    bodies, contacts = arrays.island
    tables = arrays.balls.rows, arrays.flights, arrays.shapes.rows, arrays.relations, arrays.island
    found = fill_contacts(arrays.states[0], *tables, count)
    return [
        (
            int(bodies[one["first"]]["ball"]),
            "floor" if one["second"] == NO_BODY else int(bodies[one["second"]]["ball"]),
        )
        for one in contacts[:found]
    ]


def test_contacts_with_what_is_not_there_any_more_end() -> None:
    floor, short, other = Segment((-5, 0), (5, 0)), Segment((0.5, -1), (0.5, -3)), Segment((-5, 0), (5, 0), layer=2)
    arrays = in_flight(continuous_world(floor, short, other, Ball((0, 0.5), 0.5, collides_with=1)))
    ball = arrays.balls.rows[0]
    for row in (1, 2, 0):
        add_relation(arrays.states[0], arrays.relations, ball, 0, LASTING, row)
    assert taken_apart(arrays, [0]) == (1, 1)
    assert arrays.island[1]["shape"][0] == 0
    assert pairs_of(arrays, LASTING) == {(0, 0)}


@pytest.mark.slow
@given(st.floats(-3, 3), st.booleans(), st.booleans(), st.floats(-0.01, 0.01))
def test_a_surface_has_its_gap_normal_bend_and_velocity(angle: float, inside: bool, moving: bool, gap: float) -> None:
    motion = {"motion": "kinematic", "velocity": (0.5, -2), "angular_velocity": 3.0} if moving else {}
    away = 2 - 0.5 - gap if inside else 2 + 0.5 + gap
    n = (-cos(angle), -sin(angle)) if inside else (cos(angle), sin(angle))
    world = continuous_world(
        Circle((0, 0), 2, solid=False, **motion), Ball((away * cos(angle), away * sin(angle)), 0.5)
    )
    arrays = in_flight(world)
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, LASTING, 0)
    assert taken_apart(arrays, [0]) == (1, 1)
    contact = arrays.island[1][0]
    assert (contact["gap"], contact["start_nx"], contact["start_ny"]) == pytest.approx((gap, *n), abs=1e-12)
    assert contact["bend"] == pytest.approx(away if inside else -away)
    # The circle turns about its centre: that moves its surface along itself.
    assert contact["start_bias"] == pytest.approx(-(0.5 * n[0] - 2 * n[1]) if moving else 0.0, abs=1e-12)


@pytest.mark.parametrize("inside", [False, True])
def test_inside_of_what_is_bent_the_mean_normal_is_that_of_the_middle_of_a_tick(inside: bool) -> None:
    away = 1.5 if inside else 2.5
    arrays = in_flight(continuous_world(Circle((0, 0), 2, solid=False), Ball((away, 0), 0.5, velocity=(0, 3))))
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, LASTING, 0)
    counts = taken_apart(arrays, [0])
    aim_at_middle(arrays.states[0], arrays.shapes.rows, arrays.island, counts[1], 0.1)
    contact = arrays.island[1][0]
    mean = np.array([away, 0.15]) / np.hypot(away, 0.15)
    expected = -mean if inside else (1.0, 0.0)
    assert (contact["mean_nx"], contact["mean_ny"]) == pytest.approx(tuple(expected))
    assert contact["mean_bias"] == 0


def test_the_mean_normal_of_a_shape_that_turns_is_that_of_the_middle_of_a_tick() -> None:
    bar = Segment((-5, 0), (5, 0), motion="kinematic", pivot=(0, 0), angular_velocity=0.5)
    arrays = in_flight(continuous_world(bar, Ball((1, 0.5), 0.5)))
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, LASTING, 0)
    counts = taken_apart(arrays, [0])
    aim_at_middle(arrays.states[0], arrays.shapes.rows, arrays.island, counts[1], 0.1)
    contact = arrays.island[1][0]
    assert (contact["mean_nx"], contact["mean_ny"]) == pytest.approx((-sin(0.025), cos(0.025)))
    assert contact["start_bias"] == pytest.approx(-0.5)


def test_what_presses_and_turns_an_island() -> None:
    still = heap(continuous_world(Segment((-5, 0), (5, 0)), Ball((0, 0.5), 0.5), Ball((0, 1.25), 0.25)))
    bodies, contacts = still.island
    counts = taken_apart(still, [0, 1])
    assert pull_on(bodies, contacts, still.shapes.rows, counts) == (0, 0, 0.25, 0)
    bodies["gx"], bodies["gy"] = 3.0, 4.0
    assert pull_on(bodies, contacts, still.shapes.rows, counts) == (5, 0, 0.25, 0)
    bodies["vx"][1] = 6.0  # across the contact of the two, whose centres are 0.75 apart
    assert pull_on(bodies, contacts, still.shapes.rows, counts) == pytest.approx((48, 8, 0.25, 6))
    bowl = heap(continuous_world(Circle((0, 0), 2, solid=False), Ball((0, -1.5), 0.5, velocity=(3, 0))))
    counts = taken_apart(bowl, [0])
    assert pull_on(*bowl.island, bowl.shapes.rows, counts) == pytest.approx((6, 2, 0.5, 3))
    bar = Segment((-5, 0), (5, 0), motion="kinematic", velocity=(1, 2), angular_velocity=0.5, pivot=(0, 0))
    turning = heap(continuous_world(bar, Ball((0, 0.5), 0.5, velocity=(1, 4))))
    counts = taken_apart(turning, [0])
    pull, turns, _radius, fastest = pull_on(*turning.island, turning.shapes.rows, counts)
    assert (pull, turns, fastest) == pytest.approx((1, 0.5, sqrt(17)))


@given(st.floats(1e-6, 1e6), st.floats(1e-6, 1e6), st.floats(1e-6, 1e6))
def test_ticks_are_as_short_as_what_pulls_and_what_turns_ask_for(pull: float, turning: float, radius: float) -> None:
    fall, turn = ISLAND_TICK * sqrt(radius / pull), ISLAND_TURN / turning
    assert tick_length(pull, turning, radius) == min(fall, turn)
    assert tick_length(pull, 0.0, radius) == fall
    assert tick_length(0.0, turning, radius) == turn
    assert tick_length(0.0, 0.0, radius) == inf
    assert rest_speed_of(pull, radius, 7.0) ** 2 / (2 * pull) == pytest.approx(REBOUND * radius)
    assert rest_speed_of(0.0, radius, 7.0) == STILL_SPEED * 7


def test_the_next_tick_is_the_earliest_of_all() -> None:
    arrays = joined(crowd(), [(0, 1), (1, 2)])
    bodies, _ = arrays.island
    count = collect(arrays.balls.rows, arrays.flights, arrays.relations, bodies, 0, NO_BALL)
    arrays.flights["tick_time"][:3] = NO_TICK
    assert next_tick(arrays.flights, bodies, count) == (NO_TICK, 0)
    arrays.flights["tick_time"][:3], arrays.flights["tick_low"][:3] = (2.0, 1.0, 1.0), (0.0, 1e-17, -1e-17)
    assert next_tick(arrays.flights, bodies, count) == (1, -1e-17)
    dismiss(arrays.flights, bodies, count)
    assert not find_relation(arrays.relations, arrays.balls.rows[0], LYING, 2)
