"""Heaps: balls that lie on each other, in rooms of all kinds. None is outside, they hardly overlap, and they sleep."""

from itertools import pairwise
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Segment, World
from carom.rows.flight import NO_TICK
from tests.clock import within

HEIGHT = 9.0

#: What heaps may win at events and ticks, of the energy at the start: rounding.
GAIN = 1e-9

#: Seconds in which a step returns, by far.
SOON = 60.0


@pytest.fixture(autouse=True, scope="module")
def _compiled() -> None:
    """Compile before a clock runs."""
    World(detection="continuous").step(1)


def v_room(world: World, e: float) -> None:
    """Two walls that slope down to each other."""
    world.add(Segment((-HEIGHT, HEIGHT), (0, 0), elasticity=e), Segment((0, 0), (HEIGHT, HEIGHT), elasticity=e))


def bin_room(world: World, e: float) -> None:
    """A floor and two walls."""
    for start, end in pairwise([(-1.5, HEIGHT), (-1.5, 0), (1.5, 0), (1.5, HEIGHT)]):
        world.add(Segment(start, end, elasticity=e))


def bowl_room(world: World, e: float) -> None:
    """The inside of a circle."""
    world.add(Circle((0, HEIGHT / 2), HEIGHT / 2, elasticity=e))


def tray_room(world: World, e: float) -> None:
    """A floor with rounded corners."""
    world.add(Arc((-1, 0.5), 0.5, np.pi, 1.5 * np.pi, elasticity=e))
    world.add(Arc((1, 0.5), 0.5, 1.5 * np.pi, 2 * np.pi, elasticity=e))
    world.add(Segment((-1, 0), (1, 0), elasticity=e))
    world.add(*(Segment((x, 0.5), (x, HEIGHT), elasticity=e) for x in (-1.5, 1.5)))


ROOMS = {"v": v_room, "bin": bin_room, "bowl": bowl_room, "tray": tray_room}
#: Large heaps take the interpreter minutes.
COMPILED = [pytest.mark.slow, pytest.mark.compiled]
#: Rooms in which what is inelastic comes to rest. On what is bent a single ball swings for ever: there is no friction.
STILL = ("v", "bin")


def heap(room: str, count: int, e: float = 0.5, seed: int = 1, masses: tuple[float, ...] = ()) -> World:
    """Balls let go in rows over each other in a room."""
    world = World(gravity=(0, -10), detection="continuous")
    ROOMS[room](world, 0.5)
    random = Random(seed)
    radius = 0.2 if count < 100 else 0.1
    columns = max(1, int(1.6 / (2.5 * radius)))
    for k in range(count):
        x = -0.8 + (k % columns) * 2.5 * radius + random.uniform(-0.1, 0.1) * radius
        mass = masses[k] if k < len(masses) else 1.0
        world.add(Ball((x, 1.2 + (k // columns) * 2.5 * radius), radius, mass=mass, elasticity=e))
    return world


def energy(world: World) -> float:
    """The energy of the balls in this gravity."""
    balls = world.balls
    return float((balls.mass * (0.5 * (balls.velocity**2).sum(axis=1) + 10 * balls.position[:, 1])).sum())


def ledger(world: World) -> float:
    """The energy that the balls have by right: of islands as of their last solves, less what they have won and owe."""
    balls, flights = world.balls, world._arrays.flights[: len(world.balls)]
    now = 0.5 * (balls.velocity**2).sum(axis=1) + 10 * balls.position[:, 1]
    return float(
        (balls.mass * (np.where(flights["tick_time"] < NO_TICK, flights["energy"], now) - flights["surplus"])).sum()
    )


def deepest(world: World) -> float:
    """The deepest overlap of two balls, in radii of the smaller."""
    places, radii = world.balls.position, world.balls.radius
    apart = np.linalg.norm(places[:, None] - places[None], axis=2) - radii[:, None] - radii[None]
    np.fill_diagonal(apart, np.inf)
    return float((-apart / np.minimum(radii[:, None], radii[None])).max())


def is_inside(world: World, room: str) -> bool:
    """True if all centres are in a room, as far as a thousandth of a radius."""
    x, y = world.balls.position.T
    near = world.balls.radius * (1 - 1e-3)
    if room == "v":
        return bool(((y - abs(x)) / np.sqrt(2) >= near).all())
    if room == "bowl":
        return bool((np.hypot(x, y - HEIGHT / 2) <= HEIGHT / 2 - near).all())
    return bool(((y >= near) & (abs(x) <= 1.5 - near)).all())


@pytest.mark.compiled
@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("count", [5, *(pytest.param(many, marks=COMPILED) for many in (30, 100))])
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_heap_is_inside_hardly_overlaps_gains_nothing_and_sleeps(room: str, count: int, e: float) -> None:
    world = heap(room, count, e)
    least = start = booked = energy(world)
    for _ in range(600):
        with within(SOON):
            world.step(1 / 60)
        assert is_inside(world, room)
        assert deepest(world) <= 1e-3
        now, book = energy(world), ledger(world)
        # Within a tick contacts do work, up to this; the tick's end takes it back.
        assert now <= least + 1e-4 * start
        assert book <= booked + GAIN * start
        least, booked = min(least, now), min(booked, book)
    if room in STILL and e < 1:
        assert moving(world) == 0


def moving(world: World) -> int:
    """How many balls move faster than a ball falls in a thousandth of its radius."""
    speeds = np.linalg.norm(world.balls.velocity, axis=1)
    return int((speeds > np.sqrt(2 * 10 * 1e-3 * world.balls.radius)).sum())


@pytest.mark.compiled
@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_heap_is_the_same_in_any_steps_and_through_snapshots(room: str, e: float) -> None:
    digests = set()
    random = Random(5)
    parts = [random.randrange(1, 2**14) for _ in range(200)]
    irregular = [part / 2**20 for part in parts]
    end = 2.0
    irregular.append(end - sum(irregular))
    for steps in ([1 / 64] * 128, [1 / 1024] * 2048, [1.0] * 2, [end], irregular):
        world = heap(room, 12, e)
        for dt in steps:
            world.step(dt)
        digests.add((world.time, world.balls.position.tobytes(), world.balls.velocity.tobytes()))
    world = heap(room, 12, e)
    for _ in range(128):
        world.step(1 / 64)
        if random.random() < 0.3:
            snapshot, world = world.snapshot(), World()
            world.restore(snapshot)
    digests.add((world.time, world.balls.position.tobytes(), world.balls.velocity.tobytes()))
    assert len(digests) == 1


@pytest.mark.slow
@pytest.mark.compiled
@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(sorted(ROOMS)), st.integers(2, 30), st.integers(0, 10**6),
    st.lists(st.floats(-1, 1), min_size=30, max_size=30), st.floats(0, 1), st.sampled_from([1e-3, 1 / 60, 1.0]),
)  # fmt: skip
def test_balls_of_many_masses_come_to_rest(
    room: str, count: int, seed: int, powers: list[float], e: float, dt: float
) -> None:
    world = heap(room, count, e, seed, masses=tuple(10**power for power in powers))
    least = start = booked = energy(world)
    for _ in range(max(1, round(2 / dt))):
        with within(SOON):
            world.step(dt)
        now, book = energy(world), ledger(world)
        # Within a tick contacts do work, up to this; the tick's end takes it back.
        assert now <= least + 1e-4 * start
        assert book <= booked + GAIN * start
        least, booked = min(least, now), min(booked, book)
    assert is_inside(world, room)
    assert deepest(world) <= 1e-3


@pytest.mark.compiled
def test_a_sleeping_heap_costs_nothing_and_wakes_where_it_is_hit() -> None:
    world = heap("v", 12)
    world.run(10)
    assert world.statistics.sleeping == 12
    world.statistics.reset()
    world.run(10)
    assert world.statistics.box_tests == 0
    world.add(Ball((0, 5), 0.2, velocity=(0, -5)))
    world.run(1)
    world.run(10)
    assert world.statistics.sleeping == 13
    assert is_inside(world, "v")


def test_a_support_that_is_taken_away_lets_a_heap_fall() -> None:
    world = World(gravity=(0, -10), detection="continuous")
    floor = world.add(Segment((-5, 0), (5, 0)))
    world.add(Ball((0, 0.5), 0.5, elasticity=0.5), Ball((0, 1.5), 0.5, elasticity=0.5))
    world.run(1)
    assert world.statistics.sleeping == 2
    world.remove(floor)
    world.run(1)
    assert world.balls.position[:, 1] == pytest.approx([0.5 - 5, 1.5 - 5])


@pytest.mark.compiled
@pytest.mark.parametrize("speed", [0.1, 1.0, 10.0])
def test_a_piston_lifts_a_stack(speed: float) -> None:
    world = World(gravity=(0, -10), detection="continuous")
    world.add(*(Segment((x, 0), (x, 20)) for x in (-0.6, 0.6)))
    piston = world.add(Segment((-0.6, 0), (0.6, 0), motion="kinematic", velocity=(0, speed)))
    world.add(*(Ball((0, 0.5 + k), 0.5, elasticity=0.0) for k in range(4)))
    with within(SOON):
        world.run(1)
    height = piston.start[1]
    assert height == pytest.approx(speed)
    assert deepest(world) <= 1e-3
    assert world.balls.position[:, 1].min() >= height + 0.5 * (1 - 1e-3)


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("seed", range(4))
def test_a_cluster_that_is_hit_from_all_sides_keeps_its_momentum(seed: int, elasticity: float) -> None:
    random = np.random.default_rng(seed)
    world = World(detection="continuous")
    lattice = [(c + 0.5 * r, r * 0.75**0.5) for r in range(-2, 3) for c in range(-2, 3) if abs(r + c) <= 2]
    world.add(*(Ball(place, 0.5, mass=10 ** random.uniform(-1, 1), elasticity=elasticity) for place in lattice))
    for angle in random.uniform(0, 2 * np.pi, 1) + np.arange(4) * 1.5:
        out = np.array([np.cos(angle), np.sin(angle)])
        across = random.uniform(-2, 2) * np.array([-out[1], out[0]])
        world.add(Ball(5 * out + across, 0.5, velocity=-3 * out, elasticity=elasticity))
    mass = world.balls.mass[:, None]
    before = (mass * world.balls.velocity).sum(axis=0)
    for _ in range(20):
        with within(SOON):
            world.run(1)
        assert (mass * world.balls.velocity).sum(axis=0) == pytest.approx(before, abs=1e-12 * mass.sum())


@pytest.mark.compiled
def test_touching_balls_hit_from_both_ends_keep_their_momentum() -> None:
    world = World(detection="continuous")
    for k in range(30):
        world.add(Ball((k, 0), 0.5, elasticity=0.5))
    world.add(Ball((-5, 0.1), 0.5, velocity=(3, 0), elasticity=0.5))
    world.add(Ball((36, -0.2), 0.5, velocity=(-2, 0), elasticity=0.5))
    with within(SOON):
        world.run(20)
    momentum = (world.balls.mass[:, None] * world.balls.velocity).sum(axis=0)
    assert momentum == pytest.approx([1, 0], abs=1e-12)
    assert np.linalg.norm(world.balls.velocity, axis=1).min() > 0
