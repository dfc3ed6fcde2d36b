"""Events in islands: solved as far as they are felt, there as if all were solved, and nothing changes beyond."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Circle, Segment
from carom.constants import IMPACT_SHARE, ISLAND_TURN, JOLT_MOST, JOLT_NEAR, JOLT_SHARE, LEAST_TICK, REBOUND
from carom.rows.flight import ASLEEP, FLYING, NO_BALL, NO_TICK
from carom.rows.island import WANTED
from carom.rows.relation import LASTING, LYING
from carom.world.kernels.continuous import jolt as module
from carom.world.kernels.continuous.island import part
from carom.world.kernels.continuous.jolt import is_any_asleep, more_rings, take_in_pushed, take_in_reached, widen
from carom.world.kernels.continuous.settling import begin_now
from carom.world.tables import Arrays
from tests.heaps import (
    accelerations,
    copied,
    heap,
    impetus,
    is_symmetric,
    jolted,
    kinetic,
    pairs_of,
    settled,
    velocities,
)
from tests.kernel_calls import look_at, near_tables
from tests.worlds import continuous_world

LONG = 60


def chain(masses: Any = 1.0, **options: Any) -> Arrays:
    """A long row of balls on a floor, all pressed against a wall, solved at 0, when a third of a tick has passed."""
    floor, wall = Segment((-5, 0), (LONG + 5, 0)), Segment((LONG - 0.5, -1), (LONG - 0.5, 2))
    all_masses = np.broadcast_to(masses, LONG)
    balls = [Ball((float(k), 0.5), 0.5, mass=float(all_masses[k]), **options) for k in range(LONG)]
    arrays = heap(continuous_world(floor, wall, *balls, gravity=(3, -10)))
    assert settled(arrays) == LONG
    return later(arrays, 0.3)


def later(arrays: Arrays, share: float) -> Arrays:
    """The same when this share of a tick that began at 0 has passed."""
    look_at(arrays, share * float(arrays.flights["tick_time"][0]))
    return arrays


def begin(arrays: Arrays, i: int) -> None:
    """Let a ball begin a flight now."""
    tables = *near_tables(arrays), arrays.flights, arrays.relations
    begin_now(arrays.states[0], arrays.balls.rows, *tables, i)


def strike(arrays: Arrays, i: int, velocity: tuple[float, float]) -> None:
    """Let a ball begin a flight now, with a velocity."""
    begin(arrays, i)
    arrays.balls.rows["vx"][i], arrays.balls.rows["vy"][i] = velocity


def bed(random: np.random.Generator, rows: int, columns: int, elasticity: float) -> Arrays:
    """Layers of balls on a floor between walls, as those of a chain, and as late."""
    height = np.sqrt(0.75)
    walls = Segment((-0.5, -1), (-0.5, 9)), Segment((columns - 0.5, 9), (columns - 0.5, -1))
    places = [(c + (r % 2) / 2, 0.5 + r * height) for r in range(rows) for c in range(columns - r % 2)]
    balls = [Ball(place, 0.5, mass=10 ** random.uniform(-1, 1), elasticity=elasticity) for place in places]
    arrays = heap(continuous_world(*walls, Segment((-5, 0), (columns + 5, 0)), *balls, gravity=(0, -10)))
    settled(arrays)
    return later(arrays, 0.3)


def jolted_whole(arrays: Arrays, i: int) -> int:
    """The number of balls that fly on otherwise where whoever is pushed at all is solved too."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "JOLT_SHARE", 0.0)
        return jolted(arrays, i, struck=True)


def same(one: Arrays, other: Arrays, i: int) -> bool:
    """Whether a ball is on the same flight, to the bit."""
    same_ball = one.balls.rows[i].tobytes() == other.balls.rows[i].tobytes()
    return same_ball and one.flights[i].tobytes() == other.flights[i].tobytes()


@pytest.mark.parametrize("at", [0, LONG // 2, LONG - 1])
def test_a_blow_into_the_floor_is_felt_by_nobody_else(at: int) -> None:
    arrays = chain(elasticity=0.5)
    before = copied(arrays)
    strike(arrays, at, (0.0, -2.0))
    count = jolted(arrays, at, struck=True)
    assert count <= 3
    listed = set(arrays.island[0]["ball"][:count].tolist())
    assert listed >= {at}
    assert all(same(arrays, before, i) for i in range(LONG) if i not in listed)
    assert arrays.balls.rows["vy"][at] == pytest.approx(1.0)
    for i in listed - {at}:
        assert (arrays.balls.rows["vx"][i], arrays.balls.rows["vy"][i]) == pytest.approx((0, 0), abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("light", [1e-5, 1e-2, 1.0])
def test_a_blow_along_a_chain_goes_as_far_as_it_is_felt(light: float) -> None:
    arrays = chain([light] + [1.0] * (LONG - 1))
    before = copied(arrays)
    strike(arrays, 0, (0.5, 0.0))
    whole = copied(arrays)
    count = jolted(arrays, 0, struck=True)
    assert (count < 8) == (light < 0.1)
    listed = set(arrays.island[0]["ball"][:count].tolist())
    assert all(same(arrays, before, i) for i in range(LONG) if i not in listed)
    jolted_whole(whole, 0)
    speed = np.sqrt(2 * REBOUND * np.hypot(3, 10) * 0.5)
    assert np.abs(velocities(arrays) - velocities(whole)).max() <= JOLT_SHARE * speed
    if count < LONG:
        # What has not come to the wall stays: the momentum is what it was where all of these begin new flights.
        strike(before, 0, (0.5, 0.0))
        for i in listed - {0}:
            begin(before, i)
        assert impetus(arrays)[0] == pytest.approx(impetus(before)[0], abs=1e-13)
    assert is_symmetric(pairs_of(arrays))


@pytest.mark.slow
@given(st.integers(0, 10**6), st.floats(-5, 0.5), st.sampled_from([0.0, 0.5]))
def test_what_is_solved_agrees_with_solving_all(seed: int, size: float, elasticity: float) -> None:
    random = np.random.default_rng(seed)
    arrays = bed(random, int(random.integers(2, 4)), int(random.integers(4, 8)), elasticity)
    rest = 0.7 / 0.3 * float(arrays.states[0]["now"])
    who = int(random.integers(arrays.balls.count))
    strike(arrays, who, tuple(10**size * random.normal(size=2)))
    for i in range(arrays.balls.count):
        begin(arrays, i)
    energy, whole = kinetic(arrays), copied(arrays)
    count = jolted(arrays, who, struck=True)
    assert jolted_whole(whole, who) >= count
    # What the tick's solve has left the others, some 1e-10, may come and go.
    assert kinetic(arrays) <= energy * (1 + 1e-14) + 1e-18
    speed = np.sqrt(2 * REBOUND * 10 * 0.5)
    share = JOLT_SHARE * max(speed, 10**size)
    assert np.abs(velocities(arrays) - velocities(whole)).max() <= share
    assert np.abs(accelerations(arrays) - accelerations(whole)).max() * rest <= 20 * share
    assert is_symmetric(pairs_of(arrays))
    assert (arrays.flights["body"] == 0).all()


@pytest.mark.slow
def test_a_ball_that_is_met_is_taken_into_the_island_with_its_tick() -> None:
    arrays = chain()
    tick = float(arrays.flights["tick_time"][0])
    # The first parts from the rest, and is met by it anew.
    arrays.flights["tick_time"][0] = NO_TICK
    strike(arrays, 0, (1e-3, 0.0))
    count = jolted(arrays, 0, 1, True)
    assert arrays.flights["tick_time"][0] == tick
    assert 0 in arrays.island[0]["ball"][:count]
    assert accelerations(arrays)[0] == pytest.approx((0, 0), abs=0.5)


def test_who_is_solved_flies_on_no_longer_than_it_was_solved_for() -> None:
    arrays = chain(elasticity=0.5)
    tick = float(arrays.flights["tick_time"][0])
    # As where two islands have just come together: all but one look again later.
    arrays.flights["tick_time"][:LONG] = 4 * tick
    arrays.flights["tick_time"][7] = tick
    strike(arrays, 7, (0.0, -2.0))
    count = jolted(arrays, 7, struck=True)
    assert count > 1
    assert (arrays.flights["tick_time"][arrays.island[0]["ball"][:count]] == tick).all()


def test_what_comes_onto_a_bend_is_solved_before_that_has_turned_far() -> None:
    pair = Ball((0, 0.5), 0.5, (3, 0), elasticity=0.0), Ball((1, 0.5), 0.5, (3, 0), elasticity=0.0)
    arrays = heap(continuous_world(Circle((0, 5), 5), *pair))
    # They have flown straight so far, and were to go on so for long.
    arrays.flights["tick_time"][:2] = 1000.0
    assert jolted(arrays, 0, struck=True) == 2
    assert (arrays.flights["tick_time"][:2] <= ISLAND_TURN * 5 / 3).all()
    assert accelerations(arrays)[0] == pytest.approx((0, 3**2 / 4.5), abs=0.05)


@pytest.mark.parametrize("share", [1 - 0.5 * LEAST_TICK, 1 - 4 * LEAST_TICK])
def test_near_the_end_of_a_tick_all_of_the_island_is_solved(share: float) -> None:
    arrays = later(chain(), share)
    tick = float(arrays.flights["tick_time"][0])
    strike(arrays, 5, (0.0, -1e-3))
    count = jolted(arrays, 5, struck=True)
    ends = share > 1 - LEAST_TICK
    assert (count == LONG) == ends
    assert (float(arrays.flights["tick_time"][LONG - 1]) > tick) == ends
    assert (arrays.flights["time"][:LONG] == arrays.states[0]["now"]).all() == ends


def test_where_somebody_sleeps_all_wake() -> None:
    arrays = chain()
    arrays.flights["kind"][:LONG], arrays.balls.rows["asleep"][:LONG] = ASLEEP, 1
    arrays.flights["tick_time"][:LONG] = NO_TICK
    arrays.states[0]["sleeping"] = LONG
    assert jolted(arrays, 7, struck=True) == LONG
    assert (arrays.flights["kind"][:LONG] == FLYING).all()
    assert arrays.states[0]["sleeping"] == 0
    assert (arrays.flights["tick_time"][:LONG] < NO_TICK).all()


def test_who_is_reached_or_pushed_is_wanted() -> None:
    arrays = chain()
    bodies, flights = arrays.island[0], arrays.flights
    bodies["ball"][:3], bodies["core"][:3], bodies["reached"][:3] = (4, 5, 6), (1, 0, 0), (1, 0, 1)
    assert take_in_reached(bodies, 3)
    assert bodies["core"][:3].tolist() == [1, 0, WANTED]
    bodies["core"][:3], bodies["reached"][:3] = (1, 0, 0), 0
    assert not take_in_reached(bodies, 3)
    bodies["ax"][:3], bodies["ay"][:3] = flights["ax"][4:7], flights["ay"][4:7]
    bodies["ax"][:3] += (9.0, 0.5, 2.0)
    assert take_in_pushed(flights, bodies, 3, 0.5, 0.6)
    assert bodies["core"][:3].tolist() == [1, 0, WANTED]
    flights["kind"][5] = ASLEEP
    assert is_any_asleep(flights, bodies, 3)
    assert not is_any_asleep(flights, bodies, 1)


def test_who_is_wanted_begins_a_flight_and_lists_its_neighbours() -> None:
    arrays = chain()
    bodies = arrays.island[0]
    bodies["ball"][0], bodies["core"][0] = 4, WANTED
    arrays.flights["body"][4] = 1
    bodies["x"][0] = 4.0
    tables = *near_tables(arrays), arrays.flights, arrays.relations, bodies
    assert widen(arrays.states[0], arrays.balls.rows, *tables, 1, 1) == 3
    assert sorted(bodies["ball"][:3].tolist()) == [3, 4, 5]
    assert bodies["core"][:3].tolist() == [1, 0, 0]
    now = arrays.states[0]["now"]
    assert arrays.flights["time"][[3, 4, 5]].tolist() == [0, now, 0]
    assert bodies["x"][:3].tolist() == pytest.approx(bodies["ball"][:3].tolist(), abs=1e-6)
    assert NO_BALL not in bodies["ball"][:3]
    assert pairs_of(arrays, LASTING) >= {(3, 0), (4, 0), (5, 0)}
    assert pairs_of(arrays, LYING) >= {(3, 4), (4, 3)}


def test_rings_around_who_is_wanted_are_taken_in_with_it() -> None:
    arrays = chain()
    bodies = arrays.island[0]
    bodies["ball"][0], bodies["core"][0] = 4, WANTED
    arrays.flights["body"][4] = 1
    tables = *near_tables(arrays), arrays.flights, arrays.relations, bodies
    assert widen(arrays.states[0], arrays.balls.rows, *tables, 1, 3) == 7
    # Two rings are in the core, the third is beside it.
    core = {int(body["ball"]): int(body["core"]) for body in bodies[:7]}
    assert core == {4: 1, 3: 1, 5: 1, 2: 1, 6: 1, 1: 0, 7: 0}
    assert [more_rings(rings, JOLT_NEAR - 1) for rings in (1, 2)] == [2, 3]
    assert more_rings(3, JOLT_NEAR) == 1


def test_whom_an_event_leaves_as_it_was_flies_on() -> None:
    # Side by side on a floor, touching, with no force between them.
    balls = [Ball((float(k), 0.5), 0.5) for k in range(3)]
    arrays = heap(continuous_world(Segment((-5, 0), (9, 0)), *balls, gravity=(0, -10)))
    settled(arrays)
    later(arrays, 0.3)
    before = copied(arrays)
    strike(arrays, 0, (0.0, -1e-2))
    assert jolted(arrays, 0, struck=True) == 1
    assert arrays.island[0]["ball"][0] == 0
    assert all(same(arrays, before, i) for i in (1, 2))


@pytest.mark.parametrize("behind", [False, True])
def test_a_ball_that_is_thrown_back_at_once_stays_with_whom_it_has_met(behind: bool) -> None:
    # The second has been struck by the first and goes into what lies behind it, if there is something.
    wall = Segment((2.5, -1), (2.5, 2)) if behind else Segment((9.5, -1), (9.5, 2))
    balls = [Ball((float(k), 0.5), 0.5, elasticity=0.5) for k in range(3)]
    arrays = heap(continuous_world(wall, Segment((-5, 0), (12, 0)), *balls, gravity=(0, -10)))
    settled(arrays)
    later(arrays, 0.3)
    part(arrays.states[0], arrays.balls.rows, arrays.relations, 0, 1)
    for i, speed in ((0, 0.25), (1, 0.75)):
        strike(arrays, i, (speed, 0.0))
    held = int(arrays.states[0]["held"])
    jolted(arrays, 0, 1, True)
    assert ((0, 1) in pairs_of(arrays)) == behind
    assert is_symmetric(pairs_of(arrays))
    assert arrays.states[0]["held"] == held + int(behind)
    speeds = velocities(arrays)[:, 0]
    assert speeds[1] >= speeds[0] - IMPACT_SHARE * np.sqrt(2 * REBOUND * 10 * 0.5)


def test_what_is_pushed_far_off_waits_until_it_has_changed_as_much_as_it_may() -> None:
    arrays = chain()
    first_tick = float(arrays.flights["tick_time"][0])
    now = float(arrays.states[0]["now"])
    whole = copied(arrays)
    strike(arrays, 0, (0.05, 0.0))
    strike(whole, 0, (0.05, 0.0))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "JOLT_WAIT", 0.0)
        count = jolted(arrays, 0, struck=True)
    assert JOLT_MOST <= count < LONG
    ticks = arrays.flights["tick_time"][arrays.island[0]["ball"][:count]]
    # Those around the ones that are solved look again sooner.
    assert now < ticks[-1] < first_tick
    assert set(ticks[:JOLT_MOST].tolist()) == {first_tick}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "JOLT_WAIT", 1.0)
        more = jolted(whole, 0, struck=True)
    assert more > count
    assert (whole.flights["tick_time"][:LONG] == first_tick).all()
