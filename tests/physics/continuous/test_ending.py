"""Steps end whatever happens in them, and everything stays finite."""

import pickle
from math import cos, pi, sin, tan
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from tests.physics.continuous.rooms import exact_world, random_room
from tests.worlds import box, crowded, guarded


def test_a_step_ends_where_a_ball_has_had_as_many_impacts_as_it_may_and_goes_on_from_there() -> None:
    def room(max_impacts: int | None) -> carom.World:
        walls = [carom.Segment((x, -1.0), (x, 1.0)) for x in (0.0, 1.0)]
        world = exact_world(*walls, max_impacts=max_impacts)
        world.add(carom.Ball((0.5, 0.0), 0.25, velocity=(1000.0, 0.0)))
        return world

    limited, free = room(50), room(None)
    times: list[float] = []
    for turn in range(1, 5):
        with pytest.raises(carom.ImpactLimit) as limit:
            limited.step(1.0)
        assert limit.value.balls == [limited.balls[0].id]
        assert limit.value.time == limited.time
        times += np.asarray(limit.value.hits)["time"].tolist()
        assert len(times) == 50 * turn
    assert np.asarray(free.step(1.0))["time"].tolist()[:200] == times
    assert limited.balls.velocity[0].tolist() == free.balls.velocity[0].tolist()
    assert limited.statistics.stalled == 0
    # Another process that makes the step hands it on.
    twin = pickle.loads(pickle.dumps(carom.ImpactLimit("too many", [3], 0.5)))
    assert (str(twin), twin.balls, twin.time) == ("too many", [3], 0.5)


def test_inelastic_collapse_ends() -> None:
    world = exact_world()
    for k, speed in enumerate((1.0, 0.0, -1.0)):
        world.add(carom.Ball((1.5 * k, 0.0), 0.5, velocity=(speed, 0.0), elasticity=0.1))
    for _ in range(3):
        world.step(1.0)
    x = world.balls.position[:, 0]
    assert (np.diff(x) >= 1.0 - 1e-9).all()
    assert world.balls.velocity.sum() == pytest.approx(0.0, abs=1e-12)


def test_balls_that_overlap_at_first_are_moved_apart() -> None:
    world = exact_world(*guarded(box(10.0, 10.0)))
    random = Random(1)
    for _ in range(30):
        world.add(carom.Ball((random.uniform(3.0, 7.0), random.uniform(3.0, 7.0)), 0.5))
    for _ in range(20):
        world.step(0.1)
    position = world.balls.position
    apart = np.hypot(*(position[:, None] - position[None, :]).transpose(2, 0, 1))[np.triu_indices(30, 1)]
    assert apart.min() > 1.0 - 1e-6
    assert ((position > 0.5 - 1e-6) & (position < 9.5 + 1e-6)).all()


@pytest.mark.slow
@pytest.mark.compiled
@given(seed=st.integers(0, 2**32 - 1), dt=st.sampled_from((0.001, 1 / 60, 1.0)))
def test_worlds_of_everything_stay_finite(seed: int, dt: float) -> None:
    world = crowded(8, seed, detection="continuous")
    for _ in range(3):
        hits = np.asarray(world.step(dt))
        assert np.isfinite(world.balls.position).all()
        assert np.isfinite(world.balls.velocity).all()
        assert np.isfinite(hits["point"]).all()
        assert np.isfinite(hits["impulse"]).all()


@pytest.mark.parametrize("seed", range(8))
def test_substeps_and_iterations_change_nothing(seed: int) -> None:
    found = []
    for substeps, iterations in ((1, 6), (3, 1), (40, 20)):
        random = Random(seed)
        world = exact_world(*random_room(random).shapes, substeps=substeps, iterations=iterations)
        for k in range(4):
            place = (2.0 * (k % 2) - 1.0, 2.0 * (k // 2) - 1.0)
            velocity = (random.gauss(0.0, 6.0), random.gauss(0.0, 6.0))
            world.add(carom.Ball(place, random.uniform(0.3, 0.9), velocity=velocity, mass=random.uniform(0.5, 2.0)))
        hits = np.asarray(world.step(2.0))
        found.append((hits, world.balls.position.copy()))
    for hits, position in found[1:]:
        assert hits.tobytes() == found[0][0].tobytes()
        assert position.tolist() == found[0][1].tolist()


@pytest.mark.slow
@pytest.mark.compiled
@given(seed=st.integers(0, 2**32 - 1))
def test_a_ball_shot_into_a_wedge_comes_out_of_it_or_to_rest_in_few_impacts(seed: int) -> None:
    random = Random(seed)
    half, turn = random.uniform(0.05, 1.5), random.uniform(0.0, 6.3)
    elasticity, radius = random.choice((0.0, 0.05, 0.5, 0.9, 1.0)), 10 ** random.uniform(-2.0, 1.0)
    world = carom.World(detection="continuous", friction=random.choice((0.0, 0.1)) * radius, max_impacts=3000)
    far = 9.0 * radius / sin(half)
    for side in (half, -half):
        world.add(carom.Segment((0.0, 0.0), (far * cos(turn + side), far * sin(turn + side)), elasticity=elasticity))
    away, aim = 4.0 * radius / sin(half), turn + pi + random.uniform(-0.3, 0.3) * half
    world.add(
        carom.Ball((away * cos(turn), away * sin(turn)), radius, (9 * radius * cos(aim), 9 * radius * sin(aim)), 2.0)
    )
    for _ in range(20):
        world.step(1.0)
    x, y = world.balls.position[0]
    along, across = x * cos(turn) + y * sin(turn), -x * sin(turn) + y * cos(turn)
    # It is between the two, or has gone out to where they end.
    assert along > 0.0
    assert abs(across) <= along * tan(half) or along > far * cos(half)
