"""Table friction for each ball: its own or the world's, in both modes, wherever a ball comes from and goes to."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import Ball, World
from tests.worlds import crowded

MODES = ("discrete", "continuous")
frictions = st.one_of(st.floats(0.0, 5.0), st.sampled_from((0.0, 1e-3, 1e3)))


def rolled(worlds: float, balls: list[float | None], detection: str, steps: int = 12) -> World:
    """A world with a friction, in which balls that have these meet each other and two walls."""
    world = World(friction=worlds, detection=detection, substeps=2, sleep_speed=0.2, sleep_time=0.1)  # type: ignore[arg-type]
    world.add(carom.Segment((-3, -9), (-3, 9), elasticity=0.75), carom.Segment((9, -9), (9, 9)))
    for n, friction in enumerate(balls):
        world.add(Ball((1.5 * n, 0.3 * n), 0.5, (3 - 2 * n, 0.5), friction=friction))
    for _ in range(steps):
        world.step(0.0625)
    return world


def seen(world: World) -> tuple[bytes, ...]:
    """All that friction acts on, to the bit."""
    rows = world._arrays.balls.used
    return tuple(rows[name].tobytes() for name in ("x", "y", "vx", "vy", "still_time", "asleep"))


@pytest.mark.parametrize("detection", MODES)
@settings(max_examples=10, deadline=None)
@given(own=frictions, worlds=frictions)
def test_a_friction_of_its_own_is_as_if_the_world_had_it(detection: str, own: float, worlds: float) -> None:
    assert seen(rolled(worlds, [own] * 3, detection)) == seen(rolled(own, [None] * 3, detection))


@pytest.mark.parametrize("detection", MODES)
@settings(max_examples=10, deadline=None)
@given(worlds=frictions)
def test_none_is_the_worlds_friction(detection: str, worlds: float) -> None:
    assert seen(rolled(worlds, [None] * 3, detection)) == seen(rolled(worlds, [worlds] * 3, detection))


@pytest.mark.parametrize("detection", MODES)
@settings(max_examples=10, deadline=None)
@given(worlds=frictions, own=st.lists(st.one_of(st.none(), frictions), min_size=1, max_size=6))
def test_each_ball_of_many_comes_to_rest_where_it_should(
    detection: str, worlds: float, own: list[float | None]
) -> None:
    speed, dt, steps = 2.0, 1 / 16, 8
    world = World(friction=worlds, detection=detection, substeps=4)  # type: ignore[arg-type]
    for lane, friction in enumerate(own):
        world.add(Ball((0, 3 * lane), 1, (speed, 0), friction=friction))
    world.run(steps * dt, dt)
    for ball, given_friction in zip(world.balls, own, strict=True):
        friction = worlds if given_friction is None else given_friction
        elapsed, substep = steps * dt, dt / 4
        assert ball.velocity[0] == pytest.approx(max(speed - friction * elapsed, 0.0), abs=1e-12)
        moving = min(elapsed, speed / friction) if friction else elapsed
        # Friction acts at the end of a substep: the ball comes farther, by at most its first speed for a substep.
        exact = (speed - 0.5 * friction * moving) * moving
        assert exact - 1e-12 <= ball.position[0] <= exact + speed * substep + 1e-12


@pytest.mark.compiled
@pytest.mark.parametrize("detection", MODES)
def test_the_way_to_a_stop_is_that_of_the_formula(detection: str) -> None:
    for friction in (0.25, 1.0, 3.0):
        world = World(friction=9.0, detection=detection, substeps=64)  # type: ignore[arg-type]
        ball, other = world.add(Ball((0, 0), 0.1, (2, 0), friction=friction), Ball((0, 9), 0.1, (2, 0)))
        world.run(10.0)
        assert ball.velocity == other.velocity == (0, 0)
        assert ball.position[0] == pytest.approx(2.0**2 / (2 * friction), rel=1e-3)
        assert other.position[0] == pytest.approx(2.0**2 / (2 * 9.0), rel=5e-3)


@pytest.mark.parametrize("detection", MODES)
def test_a_ball_that_its_own_friction_stops_falls_asleep(detection: str) -> None:
    world = World(detection=detection, sleep_speed=0.1, sleep_time=0.25)  # type: ignore[arg-type]
    braked, free = world.add(Ball((0, 0), 0.5, (1, 0), friction=2.0), Ball((0, 5), 0.5, (1, 0)))
    world.run(1.0)
    assert (braked.asleep, free.asleep) == (True, False)


@pytest.mark.parametrize("detection", MODES)
def test_friction_that_is_set_acts_at_once_and_the_worlds_on_the_others(detection: str) -> None:
    world = World(detection=detection)  # type: ignore[arg-type]
    first, second = world.add(Ball((0, 0), 0.5, (4, 0)), Ball((0, 5), 0.5, (4, 0)))
    world.step(0.5)
    assert first.velocity == second.velocity == (4, 0)
    first.friction = 2.0
    world.step(0.5)
    assert (first.velocity[0], second.velocity[0]) == pytest.approx((3, 4))
    world.friction = 1.0
    world.step(0.5)
    assert (first.velocity[0], second.velocity[0]) == pytest.approx((2, 3.5))
    first.friction = None
    world.step(0.5)
    assert (first.velocity[0], second.velocity[0]) == pytest.approx((1.5, 3))
    second.friction = 0.0
    world.step(0.5)
    assert (first.velocity[0], second.velocity[0]) == pytest.approx((1, 3))


@pytest.mark.parametrize("friction", [None, 0.0, 0.75])
def test_a_friction_goes_wherever_the_ball_goes(friction: float | None) -> None:
    ball = Ball((0, 0), 1, friction=friction)
    world = World(friction=3.0)
    world.add(ball)
    restored = World()
    restored.restore(world.snapshot())
    scene = carom.Scene.from_world(world)
    recording = carom.Recording.of(pickle.loads(pickle.dumps(world)), 0.1)
    outside = World().add(copy.copy(ball))
    balls = [
        ball,
        copy.copy(ball),
        copy.deepcopy(ball),
        pickle.loads(pickle.dumps(ball)),
        outside,
        restored.balls[0],
        copy.deepcopy(world).balls[0],
        scene.build().balls[0],
        recording.scene.build().balls[0],
        carom.Scene(**scene.plain()).build().balls[0],
    ]
    world.remove(ball)
    assert [each.friction for each in balls] == [friction] * len(balls)


def test_a_scene_file_says_only_what_is_not_the_worlds(tmp_path: Path) -> None:
    world = World()
    world.add(Ball((0, 0), 1), Ball((5, 0), 1, friction=0.0), Ball((9, 0), 1, friction=0.5))
    path = tmp_path / "scene.toml"
    carom.Scene.from_world(world).save(path)
    assert path.read_text(encoding="utf-8").count("friction") == 2
    assert [ball.friction for ball in carom.Scene.load(path).build().balls] == [None, 0.0, 0.5]


def test_the_digest_knows_frictions() -> None:
    digests = set()
    for friction in (None, 0.0, 0.5):
        world = World(friction=0.5)
        world.add(Ball((0, 0), 1, friction=friction))
        digests.add(world.digest())
    assert len(digests) == 3


@pytest.mark.parametrize("detection", MODES)
def test_a_crowd_whose_balls_have_the_worlds_friction_of_their_own_is_the_same_crowd(detection: str) -> None:
    plain, own = crowded(detection=detection), crowded(detection=detection, friction=7.0)
    own.balls.friction[:] = plain.friction
    for world in (plain, own):
        world.run(0.5)
    assert seen(plain) == seen(own)
    assert np.asarray(plain.run(0.25)).tobytes() == np.asarray(own.run(0.25)).tobytes()
