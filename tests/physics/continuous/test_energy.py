"""Energy, and in a round room angular momentum, hold over a million impacts at elasticity 1."""

from math import cos, pi, sin, sqrt
from random import Random

import numpy as np
import pytest

import carom
from tests.physics.continuous.rooms import exact_world, random_room, ring, stadium
from tests.worlds import box, energy

IMPACTS = 1_000_000
DRIFT = 1e-9


def sent(shapes: list[carom.Shape], position: tuple[float, float], angle: float, radius: float) -> carom.World:
    """A world with one ball of speed 1."""
    world = exact_world(*shapes)
    world.add(carom.Ball(position, radius, velocity=(cos(angle), sin(angle))))
    return world


def run_impacts(world: carom.World, count: int, seconds: float) -> None:
    """Run a world until so many impacts have happened, in steps of so many seconds."""
    done = 0
    while done < count:
        hits = len(world.step(seconds))
        assert 0 < hits < 100_000
        done += hits
    assert world.statistics.stalled == 0


def speed(world: carom.World) -> float:
    """The speed of a world's only ball."""
    vx, vy = world.balls[0].velocity
    return sqrt(vx * vx + vy * vy)


ROOMS = {
    "stadium": lambda: stadium(1.5, 1.0),
    "Sinai": lambda: [*box(4.0, 4.0), carom.Circle((2.0, 2.0), 1.0, solid=True)],
    "any": lambda: random_room(Random(4)).shapes,
}


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("name", ROOMS)
def test_energy_of_one_ball(name: str) -> None:
    world = sent(ROOMS[name](), (0.5, 0.4), 1.0, 0.1)
    run_impacts(world, IMPACTS, 10_000.0)
    assert speed(world) ** 2 == pytest.approx(1.0, rel=DRIFT)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("pieces", [0, 1 + 4])
@pytest.mark.parametrize("angle", [1.5, 0.1])
def test_energy_and_angular_momentum_in_a_round_room(pieces: int, angle: float) -> None:
    center, radius = (0.25, -0.5), 2.0
    wall: list[carom.Shape] = ring(center, radius, pieces) if pieces else [carom.Circle(center, radius)]
    world = sent(wall, (1.0, 0.3), angle, 0.1)
    before = angular_momentum(world, center)
    run_impacts(world, IMPACTS, 10_000.0)
    assert speed(world) ** 2 == pytest.approx(1.0, rel=DRIFT)
    assert abs(angular_momentum(world, center) - before) < DRIFT * radius


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("gravity", [0.0, -1.0])
def test_what_is_kept_drifts_to_no_side(gravity: float) -> None:
    # An impact rounds; of twenty starts no more rise than fall, but for chance.
    random, drifts = Random(5), []
    for _ in range(20):
        world = exact_world(carom.Circle((0, 0), 1), gravity=(0, gravity))
        away, place, angle = random.uniform(0.1, 0.6), random.uniform(0, 2 * pi), random.uniform(0, 2 * pi)
        velocity = 5 * cos(angle), 5 * sin(angle)
        world.add(carom.Ball((away * cos(place), away * sin(place)), 0.05, velocity=velocity))
        before = speed(world) ** 2 / 2 - gravity * world.balls[0].position[1], angular_momentum(world, (0, 0))
        hits = len(world.run(4000.0, 10.0))
        after = speed(world) ** 2 / 2 - gravity * world.balls[0].position[1], angular_momentum(world, (0, 0))
        # Gravity turns a ball about the middle; without it both are kept.
        kept = 1 if gravity else 2
        drifts.append([(new - old) / 12.5 / hits for new, old in zip(after[:kept], before, strict=False)])
    drift = np.array(drifts)
    assert np.abs(drift).max() <= 1e-17
    assert (np.abs(drift.mean(axis=0)) <= 4 * drift.std(axis=0, ddof=1) / sqrt(len(drift))).all()


def angular_momentum(world: carom.World, center: tuple[float, float]) -> float:
    """The angular momentum of a world's only ball about a point, per mass."""
    (x, y), (vx, vy) = world.balls[0].position, world.balls[0].velocity
    return (x - center[0]) * vy - (y - center[1]) * vx


@pytest.mark.slow
@pytest.mark.compiled
def test_energy_and_momentum_of_many_balls() -> None:
    random = Random(5)
    world = exact_world(*box(10.0, 10.0))
    for i in range(64):
        place = (0.7 + 1.2 * (i % 8), 0.7 + 1.2 * (i // 8))
        velocity = (random.gauss(0.0, 1.0), random.gauss(0.0, 1.0))
        world.add(
            carom.Ball(place, random.uniform(0.1, 0.5), velocity=velocity, mass=10.0 ** random.uniform(-2.0, 2.0))
        )
    before = energy(world)
    run_impacts(world, IMPACTS, 50.0)
    assert energy(world) == pytest.approx(before, rel=DRIFT)


@pytest.mark.compiled
@pytest.mark.parametrize("slope", [1e-2, 1e-3, 1e-4])
def test_flat_bounces_stay_bounces_in_long_steps(slope: float) -> None:
    # Rebounds a thousandth of a second apart, in a step of 50 seconds, are no contact that lasts.
    world = sent([carom.Circle((0.0, 0.0), 2.0)], (0.0, -1.9), slope, 0.1)
    before = angular_momentum(world, (0.0, 0.0))
    hits = world.step(50.0 * slope / 1e-3)
    # A chord takes 2·1.9·sin(slope) seconds.
    assert len(hits) == pytest.approx(50.0 * slope / 1e-3 / (3.8 * sin(slope)), abs=2.0)
    assert speed(world) ** 2 == pytest.approx(1.0, rel=DRIFT)
    assert angular_momentum(world, (0.0, 0.0)) == pytest.approx(before, rel=DRIFT)


@pytest.mark.parametrize("slope", [1e-2, 1e-3])
def test_bounces_are_counted_up_to_the_limit_and_not_slid_over(slope: float) -> None:
    # They are high enough to be seen: a contact that lasts instead would lose what energy they have.
    world = sent([carom.Circle((0.0, 0.0), 2.0)], (0.0, -1.9), slope, 0.1)
    world.max_impacts = 100
    with pytest.raises(carom.ImpactLimit) as limit:
        world.step(1000.0 * slope)
    assert limit.value.hits is not None
    assert len(limit.value.hits) == 100
    assert speed(world) ** 2 == pytest.approx(1.0, rel=DRIFT)
