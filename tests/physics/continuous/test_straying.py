"""Balls that leave a world's bounds: when that is, in whatever steps, and what one that is removed does no more."""

import numpy as np
import pytest

import carom
from carom import Ball, Circle, Segment, World
from tests.clock import within
from tests.worlds import continuous_world

BOUNDS = (-3.0, -2.0, 3.0, 4.0)

#: Steps that lead to each second exactly, in units of 1/1024 s.
PATTERNS = {
    "1/64": [16] * 64,
    "1/8": [128] * 8,
    "1": [1024],
    "1/1024, then the rest": [1, 1023],
    "uneven": [1, 700, 3, 64, 5, 200, 17, 33, 1],
    "1/128": [8] * 128,
}


def told(world: World, steps: list[int], seconds: int) -> list[tuple[str, int, bytes]]:
    """The digest of a world, how many balls have strayed and its hits so far, after each second."""
    seen, hits = [], b""
    for _ in range(seconds):
        for step in steps:
            hits += np.asarray(world.step(step / 1024)).tobytes()
        seen.append((world.digest(), world.statistics.strays, hits))
    return seen


def shower(seed: int, removes: bool) -> World:
    """Balls of two sizes, a sensor and one that lies on a wheel, in a ring that lies around the bounds."""
    random = np.random.default_rng(seed)
    world = World(
        gravity=((0, 0), (0, -5), (2, -3))[seed % 3],
        friction=(0.0, 0.0, 0.4)[seed // 3 % 3],
        sleep_speed=(0.0, 0.3)[seed % 2],
        sleep_time=0.1,
        bounds=BOUNDS,
        remove_strays=removes,
    )
    world.add(
        Circle((0, 0), 6, elasticity=0.9), Circle((3, 1), 1.5, solid=True, sensor=True), Segment((-4, -1), (1, -1))
    )
    world.add(Segment((-1, 1), (1, 1.2), motion="kinematic", angular_velocity=1.5, velocity=(0.3, 0.1), elasticity=0.5))
    places, speeds = random.uniform(-2.5, 2.5, (20, 2)), random.uniform(-6, 6, (20, 2))
    world.add_balls(places, speeds, random.choice((0.1, 0.3), 20), elasticity=(0.0, 0.5, 1.0)[seed % 3])
    world.add(Ball((2, 2), 0.8, (1, 0.5), sensor=True))
    return world


@pytest.mark.compiled
@pytest.mark.parametrize("removes", [False, True])
@pytest.mark.parametrize("seed", range(12))
def test_other_steps_tell_the_same_strays_and_hits_and_leave_the_same_bits(seed: int, removes: bool) -> None:
    worlds = [shower(seed, removes) for _ in PATTERNS]
    films = [told(world, steps, 3) for world, steps in zip(worlds, PATTERNS.values(), strict=True)]
    assert all(film == films[0] for film in films)
    assert films[0][-1][1] > 5
    assert (len(worlds[0].balls) < 21) == removes


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(4))
def test_a_snapshot_taken_at_any_time_goes_on_with_the_same_bits(seed: int) -> None:
    world = shower(seed, True)
    for _ in range(24):
        world.step(1 / 8)
        other = World()
        other.restore(world.snapshot())
        assert other.step(1 / 16).tobytes() + other.step(1 / 16).tobytes() == copy_of(world).step(1 / 8).tobytes()


def copy_of(world: World) -> World:
    """A world in the same state."""
    other = World()
    other.restore(world.snapshot())
    return other


@pytest.mark.parametrize("side", range(4))
@pytest.mark.parametrize("pull", [0.0, 1.5])
def test_a_ball_leaves_when_all_of_it_is_out_and_hits_nothing_any_more(side: int, pull: float) -> None:
    way = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)][side])
    wall = Segment(9.5 * way + way[::-1], 9.5 * way - way[::-1])
    world = continuous_world(wall, Ball((0, 0), 1.0, 2.0 * way), gravity=tuple(pull * way))
    world.bounds, world.remove_strays = (-5, -5, 5, 5), True
    out = (np.sqrt(4.0 + 2.0 * pull * 6.0) - 2.0) / pull if pull else 3.0
    world.step(float(out) * (1 - 1e-9))
    assert world.statistics.strays == 0
    world.add(Ball(8.0 * way, 0.5))  # in its way, and a stray itself
    assert len(world.step(10.0)) == 0
    assert world.strays[0].position == pytest.approx(6.0 * way, abs=1e-8)
    assert world.strays[0].velocity == pytest.approx((2.0 + pull * out) * way)


@pytest.mark.parametrize("removes", [False, True])
def test_aim_tells_what_a_step_will_so_nothing_beyond_the_bounds_where_balls_are_removed(removes: bool) -> None:
    wall, ball = Segment((9, -3), (9, 3)), Ball((0, 0), 1, (2, 0))
    world = continuous_world(wall, ball)
    world.bounds, world.remove_strays = (-5, -5, 5, 5), removes
    aim = world.aim(ball)
    hits = world.step(10.0)
    if removes:
        assert (aim, len(hits)) == (None, 0)
    else:
        assert aim is not None
        assert (aim.shape, aim.time) == (wall, hits[0].time)


def test_a_stray_that_is_not_removed_comes_back_and_may_leave_again() -> None:
    for steps in ([1 / 64] * 640, [10.0], [3.0, 7.0]):
        world = continuous_world(Segment((-1, -1), (1, -1)), Ball((0, 0), 0.5, (0, 8)), gravity=(0, -4))
        world.bounds = (-3, -3, 3, 5)
        for step in steps:
            world.step(step)
        # It is over the top from y = 5.5 on, at each of its jumps, which take 4.12 s.
        assert world.statistics.strays == 3
        assert [len(world.strays), world.balls[0].position[1] > 5.5] == [1, True]


def test_what_touches_the_bounds_is_in_and_what_is_put_out_strays_at_once() -> None:
    world = continuous_world(Ball((6, 0), 1), Ball((0, 0), 1))
    world.bounds = (-5, -5, 5, 5)
    world.step(1.0)
    assert (world.statistics.strays, world.strays) == (0, [])
    world.balls[1].position = (0, 7)
    world.step(1.0)
    assert (world.statistics.strays, world.strays) == (1, [world.balls[1]])
    world.bounds = (-5, -5, 5, 8)
    world.step(1.0)
    assert (world.statistics.strays, world.strays) == (1, [])
    world.bounds, world.remove_strays = (-1, -1, 1, 1), True
    world.step(1.0)
    assert (world.statistics.strays, len(world.balls)) == (3, 0)


def sinking(removes: bool) -> World:
    """Three balls that lie on each other on a floor which sinks out of the bounds, with a sensor there."""
    floor = [Segment((-1, 0), (1, 0), motion="kinematic", velocity=(0, -1), elasticity=0.0)]
    walls = [Segment((x, -9), (x, 9)) for x in (-0.5, 0.5)]
    pile = [Ball((0.0, 0.5 + k), 0.5, (0, -1), elasticity=0.0) for k in range(3)]
    world = continuous_world(*floor, *walls, *pile, gravity=(0, -10))
    world.add(Circle((0, -4), 2, solid=True, sensor=True))
    world.bounds, world.remove_strays = (-3, -3, 3, 5), removes
    return world


def test_what_lies_on_a_ball_that_is_removed_is_let_go_when_that_leaves() -> None:
    films = [told(sinking(True), steps, 5) for steps in PATTERNS.values()]
    assert all(film == films[0] for film in films)
    world = sinking(True)
    hits = world.run(5.5, dt=1 / 64)
    exits = hits[hits["kind"] == carom.HitKind.EXIT]
    # The lowest is wholly out when it has sunk by 4; the next, let go, falls from there, its foot 1 above it.
    assert exits["time"][0] == pytest.approx(4.0, abs=1e-6)
    assert np.diff(exits["time"])[0] < 1.0
    assert len(world.balls) == 0


@pytest.mark.parametrize("turned", [False, True])
def test_what_a_sensor_has_inside_leaves_it_when_one_of_them_is_removed(turned: bool) -> None:
    eye, big = Ball((3, 0), 0.5, (1, 0), sensor=True), Ball((5, 0), 3)
    world = continuous_world(*((big, eye) if turned else (eye, big)))
    world.bounds, world.remove_strays = (-5, -5, 5, 5), True
    hits = world.step(4.0)
    assert [hit.kind for hit in hits] == [carom.HitKind.ENTER, carom.HitKind.EXIT]
    assert hits["time"].tolist() == pytest.approx([0.0, 2.5], abs=1e-8)
    assert (world.strays, list(world.balls)) == ([eye], [big])


@pytest.mark.parametrize("speed", [0.0, 1.0])
@pytest.mark.parametrize("count", [0, 9])
def test_a_ball_that_others_push_off_a_sensor_leaves_it_at_once(count: int, speed: float) -> None:
    eye, pushed = Ball((0, 0), 0.5, sensor=True), Ball((1.4, 0), 1.0, (0, -speed))
    # It is pushed by one which is pushed itself only later.
    heavy = [Ball((1.4, 2.05), 1.0, mass=1e4), Ball((1.4, 3.0), 1.0, mass=1e9)]
    world = continuous_world(eye, pushed, *heavy, *(Ball((20.0 + 3 * k, 0), 1) for k in range(count)))
    hits = world.step(1 / 64)
    assert np.hypot(*pushed.position) > 1.7
    assert [(hit.kind, hit.time) for hit in hits if hit.ball is pushed and hit.shape is eye] == [
        (carom.HitKind.ENTER, 0.0),
        (carom.HitKind.EXIT, 0.0),
    ]


def test_a_ball_that_meets_another_and_the_ring_around_it_at_once_meets_them_in_one_order() -> None:
    ring = Circle((-0.5, -0.5), 0.5)
    world = continuous_world(ring, Ball((-1, 3), 0.05, (0, -3), elasticity=0.0), gravity=(3, -4))
    world.add(Ball((-0.5, -0.5), 0.5, elasticity=0.0), Ball((4.0, 3.0), 0.2, elasticity=0.0))
    other, hits, others = copy_of(world), b"", b""
    with within(5.0):
        for _ in range(64):
            hits += world.step(1 / 64).tobytes()
            others += other.step(1 / 64).tobytes()
            other = copy_of(other)
    assert hits == others
    assert len(hits) > 0
