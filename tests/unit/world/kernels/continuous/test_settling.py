"""Islands solved whole: momentum, energy, no approach now or over the tick; who parts, passes, sleeps and wakes."""

from math import sqrt

import numpy as np
import numpy.lib.recfunctions as rfn
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Ball, Circle, Segment, World
from carom.constants import (
    ISLAND_OPEN,
    ISLAND_TICK,
    MOTION_SHARE,
    QUIET_TICKS,
    REBOUND,
    REST_SHARE,
    SETTLED_SHARE,
    SQUEEZE_DEEP,
    TICK_SHARE,
)
from carom.rows.flight import ASLEEP, FLYING, NO_TICK
from carom.rows.relation import LASTING, LYING, PASSING
from carom.world.kernels.continuous.settling import frame_of, tolerance_of
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.heaps import (
    accelerations,
    heap,
    impetus,
    is_symmetric,
    joined,
    kinetic,
    pairs_of,
    places,
    settled,
    taken_apart,
    velocities,
)
from tests.islands import pyramid
from tests.kernel_calls import in_flight, look_at
from tests.worlds import continuous_world

GRAVITY = (0.0, -10.0)
#: Seconds of the tick of balls of radius ½ under this gravity.
TICK = ISLAND_TICK * sqrt(0.05)


def cluster(random: np.random.Generator, gravity: tuple[float, float], speed: float, decades: float = 1.0) -> Arrays:
    """Balls that touch, far from all shapes, each with a velocity of its own."""
    at, _ = pyramid(int(random.integers(2, 5)))
    world = World(detection="continuous", gravity=gravity)
    for k in random.permutation(len(at)):
        mass, elasticity = 10 ** random.uniform(-decades, decades), random.choice([0.0, 0.5, 1.0])
        world.add(Ball(tuple(at[k]), 0.5, tuple(speed * random.normal(size=2)), mass, elasticity=elasticity))
    return heap(world)


def pit(random: np.random.Generator, speed: float = 0.0) -> Arrays:
    """A pyramid on a floor between walls."""
    rows = int(random.integers(2, 5))
    at, _ = pyramid(rows)
    walls = [Segment((-0.5, -1), (-0.5, 5)), Segment((rows - 0.5, 5), (rows - 0.5, -1)), Segment((-5, 0), (9, 0))]
    world = continuous_world(*walls, gravity=GRAVITY)
    for k in random.permutation(len(at)):
        mass = 10 ** random.uniform(-1, 1)
        world.add(Ball(tuple(at[k]), 0.5, tuple(speed * random.normal(size=2)), mass, elasticity=0.5))
    return heap(world)


def tolerance(arrays: Arrays, gravity: float) -> float:
    """The speed of approach that solves of such balls, which lie about each other, may leave."""
    pull = max(gravity, 4 * float((velocities(arrays) ** 2).sum(axis=1).max()))
    return SETTLED_SHARE * sqrt(2 * REBOUND * pull * 0.5) if gravity > 0.0 else TICK_SHARE * ISLAND_TICK * sqrt(pull)


def approaches(arrays: Arrays, tau: float = 0.0) -> list[float]:
    """The speeds with which those that lie on each other, or on walls, part; mean ones over a tick, less their gaps."""
    at, v = places(arrays), velocities(arrays) + 0.5 * tau * accelerations(arrays)
    radii, found = arrays.balls.used["radius"], []
    for i, j in pairs_of(arrays):
        way = at[i] - at[j]
        gap = float(np.hypot(*way) - radii[i] - radii[j])
        speed = float((v[i] - v[j]) @ way / np.hypot(*way))
        found.append(speed + (max(gap, 0.0) / tau if tau > 0.0 else 0.0))
    shapes = arrays.shapes.used
    for i, row in pairs_of(arrays, LASTING):
        n = np.array([-shapes[row]["ty"], shapes[row]["tx"]])
        height = (at[i] - [shapes[row]["ax"], shapes[row]["ay"]]) @ n
        n, height = (n, height) if height > 0 else (-n, -height)
        found.append(float(v[i] @ n) + (max(height - radii[i], 0.0) / tau if tau > 0.0 else 0.0))
    return found


@pytest.mark.slow
@given(st.integers(0, 10**6), st.booleans(), st.booleans(), st.floats(-6, 3))
def test_in_free_space_momentum_stays_energy_never_rises_and_nobody_approaches(
    seed: int, struck: bool, falls: bool, size: float
) -> None:
    random, speed = np.random.default_rng(seed), 10**size
    arrays = cluster(random, GRAVITY if falls else (0, 0), speed)
    slack = tolerance(arrays, 10.0 if falls else 0.0)
    momentum, energy, mass = impetus(arrays), kinetic(arrays), float(arrays.balls.used["mass"].sum())
    scale = float((arrays.balls.used["mass"] * np.abs(velocities(arrays)).max(axis=1)).sum())
    assert settled(arrays, 0, struck=struck) == arrays.balls.count
    assert np.abs(impetus(arrays) - momentum).max() <= 1e-13 * scale
    assert kinetic(arrays) <= energy * (1 + 1e-14)
    # And over the tick gravity alone changes the momentum, to the rounding of velocities.
    tau = float(arrays.flights["tick_time"][0])
    change = tau * (arrays.balls.used["mass"] @ accelerations(arrays) - mass * np.array(GRAVITY if falls else (0, 0)))
    assert tau == NO_TICK or np.abs(change).max() <= 1e-13 * (scale + tau * 10 * mass)
    assert min(approaches(arrays), default=0.0) >= -slack
    assert is_symmetric(pairs_of(arrays))
    assert (arrays.flights["body"] == 0).all()


@pytest.mark.slow
@given(st.integers(0, 10**6), st.booleans(), st.sampled_from([0.0, 1e-3, 0.1, 3.0]))
def test_on_a_floor_energy_never_rises_and_over_the_tick_nobody_approaches(
    seed: int, struck: bool, speed: float
) -> None:
    arrays = pit(np.random.default_rng(seed), speed)
    energy, slack = kinetic(arrays), tolerance(arrays, 10.0)
    assert settled(arrays, 0, struck=struck) == arrays.balls.count
    assert kinetic(arrays) <= energy * (1 + 1e-14)
    assert min(approaches(arrays)) >= -slack
    tau = float(arrays.flights["tick_time"][arrays.flights["tick_time"] < NO_TICK].min(initial=NO_TICK))
    if 0.0 < tau < NO_TICK:
        assert tau <= TICK * (1 + 1e-12)
        v, a, m = velocities(arrays), accelerations(arrays), arrays.balls.used["mass"]
        # Forces do no work but that of gravity.
        work = (m * ((v + tau * a) ** 2 - v**2).sum(axis=1) / 2 - m * ((v + tau * a / 2) * tau) @ GRAVITY).sum()
        assert work <= 1e-12 * (energy + m.sum() * 100 * tau**2)
        if speed < 1e-2:
            # Faster, forces may be scaled down for their work: then places are put right at the next tick.
            assert min(approaches(arrays, tau)) >= -10 * TICK_SHARE * tau * 10 - 1e-12
    assert is_symmetric(pairs_of(arrays))


def test_a_heap_at_rest_keeps_its_forces_from_tick_to_tick() -> None:
    arrays = pit(np.random.default_rng(3))
    settled(arrays)
    forces = rfn.structured_to_unstructured(arrays.relations[["force_x", "force_y"]])
    assert forces.max() > 1.0
    assert np.abs(accelerations(arrays)).max() <= 1e-5
    look_at(arrays, float(arrays.flights["tick_time"][0]))
    settled(arrays)
    after = rfn.structured_to_unstructured(arrays.relations[["force_x", "force_y"]])
    assert after == pytest.approx(forces, abs=1e-4)
    # Both sides of a pair know the same.
    lying = arrays.relations["kind"] == LYING
    rows = {
        (row["ball"], row["other"]): force for row, force in zip(arrays.relations[lying], after[lying], strict=True)
    }
    assert all((rows[j, i] == -force).all() for (i, j), force in rows.items())


def ticked(arrays: Arrays, ticks: int) -> None:
    """Let so many ticks of an island pass."""
    for _ in range(ticks):
        tick = float(arrays.flights["tick_time"][0])
        if tick < NO_TICK:
            look_at(arrays, tick)
            settled(arrays)


@pytest.mark.parametrize("motion", [{}, {"motion": "kinematic", "velocity": (1e-3, 0)}])
def test_an_island_at_rest_sleeps_after_some_ticks_but_not_on_what_moves(motion: dict[str, object]) -> None:
    floor = Segment((-5, 0), (5, 0), **motion)  # type: ignore[arg-type]
    arrays = heap(continuous_world(floor, Ball((0, 0.5), 0.5), Ball((0, 1.5), 0.5), gravity=GRAVITY))
    settled(arrays)
    ticked(arrays, QUIET_TICKS - 2)
    assert (arrays.flights["quiet"][:2] == QUIET_TICKS - 1).all()
    assert arrays.states[0]["sleeping"] == 0
    ticked(arrays, 2)
    slept = not motion
    assert arrays.states[0]["sleeping"] == 2 * slept
    assert (arrays.flights["kind"][:2] == (ASLEEP if slept else FLYING)).all()
    assert (arrays.balls.used["asleep"] == slept).all()
    assert (arrays.flights["tick_time"][:2] == NO_TICK).all() == slept
    if slept:
        assert np.abs(velocities(arrays)).max() == np.abs(accelerations(arrays)).max() == 0
        # Solved again, all of them wake, and lie on each other still.
        settled(arrays, 1)
        assert (arrays.states[0]["sleeping"], arrays.flights["tick_time"][0] < NO_TICK) == (0, True)
        assert pairs_of(arrays) == {(0, 1), (1, 0)}


def test_a_ball_that_moves_keeps_its_island_awake() -> None:
    floor = Segment((-50, 0), (50, 0))
    arrays = heap(continuous_world(floor, Ball((0, 0.5), 0.5, velocity=(1, 0)), Ball((1, 0.5), 0.5, velocity=(1, 0))))
    arrays.states[0]["gravity_y"] = -10.0
    settled(arrays)
    ticked(arrays, QUIET_TICKS + 4)
    assert (arrays.states[0]["sleeping"], arrays.flights["quiet"][:2].tolist()) == (0, [0, 0])


@pytest.mark.parametrize("depth", [0.9 * SQUEEZE_DEEP, 1.1 * SQUEEZE_DEEP])
def test_a_mover_that_is_deep_in_a_ball_goes_over_it(depth: float) -> None:
    wall = Segment((-0.5, -5), (-0.5, 5))
    press = Segment((0.5, -5), (0.5, 5), motion="kinematic", velocity=(-1, 0))
    arrays = heap(continuous_world(wall, press, Ball((0, 0), 0.5), Ball((0, 1), 0.5), gravity=GRAVITY))
    arrays.shapes.rows["ax"][1] -= depth * 0.5
    arrays.shapes.rows["bx"][1] -= depth * 0.5
    assert pairs_of(arrays, LASTING) == {(0, 0), (0, 1), (1, 0), (1, 1)}
    settled(arrays)
    over = depth > SQUEEZE_DEEP
    assert arrays.states[0]["squeezed"] == 2 * over
    for ball in arrays.balls.rows[:2]:
        assert find_relation(arrays.relations, ball, PASSING, 1) == over
        assert find_relation(arrays.relations, ball, LASTING, 1) == (not over)
        assert not find_relation(arrays.relations, ball, PASSING, 0)
    assert (arrays.balls.used["x"] >= -1e-12).all()


@pytest.mark.parametrize(("gap", "speed", "ends"), [(2.0, 0.0, True), (0.5, 0.0, False), (0.5, 1.0, True)])
def test_balls_that_have_parted_or_part_fast_lie_on_each_other_no_more(gap: float, speed: float, ends: bool) -> None:
    # Nothing presses them: they fall side by side.
    apart = 1 + gap * ISLAND_OPEN * 0.5
    arrays = joined(
        in_flight(continuous_world(Ball((0, 0), 0.5), Ball((apart, 0), 0.5, velocity=(speed, 0)), gravity=GRAVITY)),
        [(0, 1)],
    )
    settled(arrays)
    assert pairs_of(arrays) == (set() if ends else {(0, 1), (1, 0)})
    assert accelerations(arrays) == pytest.approx(np.array([GRAVITY, GRAVITY]))
    assert (arrays.flights["tick_time"][:2] == NO_TICK).all() == ends


def test_who_lies_on_nobody_any_more_is_held_by_its_shape_alone() -> None:
    slope = Segment((-5, 0), (5, 0))
    arrays = joined(in_flight(continuous_world(slope, Ball((0, 0.5), 0.5), Ball((2, 0.5), 0.5), gravity=(3, -10))), [])
    for i in range(2):
        add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[i], i, LASTING, 0)
    joined(arrays, [(0, 1)])
    settled(arrays)
    assert pairs_of(arrays) == set()
    assert pairs_of(arrays, LASTING) == {(0, 0), (1, 0)}
    assert accelerations(arrays) == pytest.approx(np.array([(3, 0), (3, 0)]), abs=1e-12)


@pytest.mark.parametrize("share", [0.5, 2.0])
def test_what_an_island_has_won_its_motion_pays_and_the_rest_is_owed(share: float) -> None:
    arrays = heap(continuous_world(Ball((0, 0), 0.5, (3, 1), 2), Ball((1, 0), 0.5, (3, 4)), gravity=GRAVITY))
    motion, momentum = 0.5 * 2 / 3 * 3**2, impetus(arrays)  # in the frame of the centre of mass
    energy = kinetic(arrays)
    arrays.flights["surplus"][:2] = share * motion / 3
    settled(arrays)
    assert kinetic(arrays) == pytest.approx(energy - min(share, 1.0) * motion)
    assert impetus(arrays) == pytest.approx(momentum)
    owed = max(share - 1.0, 0.0) * motion / 3
    assert arrays.flights["surplus"][:2] == pytest.approx([owed, owed], abs=1e-12)


@pytest.mark.slow
@given(st.integers(0, 10**6))
def test_overlaps_are_taken_back_for_no_energy(seed: int) -> None:
    random = np.random.default_rng(seed)
    arrays = pit(random, 0.3)
    rows, count = arrays.balls.rows, arrays.balls.count
    for name in ("x", "y"):
        rows[name][:count] += random.uniform(-1e-3, 1e-3, count)
    deep = deepest(arrays)
    before = kinetic(arrays) + 10 * float(arrays.balls.used["mass"] @ arrays.balls.used["y"])
    settled(arrays)
    owed = float(arrays.balls.used["mass"] @ arrays.flights["surplus"][:count])
    after = kinetic(arrays) + 10 * float(arrays.balls.used["mass"] @ arrays.balls.used["y"])
    assert after <= before + owed + 1e-12 * abs(before)
    assert deepest(arrays) <= max(0.5 * deep, 1e-6)


def deepest(arrays: Arrays) -> float:
    """The deepest overlap of two balls."""
    at, radii = places(arrays), arrays.balls.used["radius"]
    return max(float(radii[i] + radii[j] - np.hypot(*(at[i] - at[j]))) for i, j in pairs_of(arrays))


def test_the_frame_of_an_island_is_that_of_its_shapes_or_of_its_centre_of_mass() -> None:
    for shapes, frame, moved in (
        ([], (2.5, 0.0), False),
        ([Segment((-5, -0.5), (5, -0.5))], (0, 0), False),
        ([Segment((-5, -0.5), (5, -0.5), motion="kinematic", velocity=(0, 1))], (0, 0), True),
        ([Circle((9, 9), 1, motion="kinematic", velocity=(0, 1))], (2.5, 0.0), False),
    ):
        arrays = heap(continuous_world(*shapes, Ball((0, 0), 0.5, (1, 0), 1), Ball((1, 0), 0.5, (3, 0), 3)))
        counts = taken_apart(arrays, [0, 1])
        assert frame_of(*arrays.island, arrays.shapes.rows, counts) == (pytest.approx(frame), moved)


def test_an_island_is_solved_the_closer_the_slower_it_is() -> None:
    assert tolerance_of(2.0, 0.1, 1e9) == 0.2
    assert tolerance_of(2.0, 0.1, 0.5) == MOTION_SHARE * 0.5
    assert tolerance_of(2.0, 0.1, 0.0) == REST_SHARE * 2.0
