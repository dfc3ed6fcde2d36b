"""Balls that slide along bent and turning shapes: their energy, their clock, and the same bits in any steps."""

from copy import deepcopy
from math import cos, hypot, pi, sin, sqrt
from time import perf_counter

import pytest

from carom import Arc, Ball, Circle, Segment, World
from carom.shapes.shape import Shape
from tests.worlds import continuous_world, energy

#: Seconds for which a world of one ball may take for a minute; a step that does not end takes for ever.
CLOCK = 5.0


def run_within_clock(world: World, seconds: float, steps: int) -> None:
    """Step a world, and fail where that takes too long."""
    began = perf_counter()
    for _ in range(steps):
        world.step(seconds / steps)
        assert perf_counter() - began < CLOCK


@pytest.mark.compiled
@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("spin", [0.0, 1e-3, 1.0, 30.0])
@pytest.mark.parametrize("scale", [1.0, *(pytest.param(scale, marks=pytest.mark.slow) for scale in (1e-3, 1e3))])
@pytest.mark.parametrize("gap", [0.0, 0.01])
def test_a_ball_in_a_ring_that_turns_keeps_its_energy(
    scale: float, spin: float, elasticity: float, gap: float
) -> None:  # fmt: skip
    world = continuous_world(gravity=(0, 0))
    motion = {"motion": "kinematic", "angular_velocity": spin} if spin else {}
    world.add(Circle((0, 0), 3 * scale, elasticity=elasticity, **motion))
    ball = world.add(Ball(((2.7 - gap) * scale, 0), 0.3 * scale, velocity=(0, 40 * scale)))
    run_within_clock(world, 1.0, 10)
    before = energy(world)
    run_within_clock(world, 60.0, 240)
    assert energy(world) == pytest.approx(before, rel=1e-9)
    assert hypot(*ball.position) <= (2.7 + 1e-3 * 0.3) * scale


@pytest.mark.compiled
@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("spin", [0.0, 1.0, -30.0])
@pytest.mark.parametrize("scale", [1.0, *(pytest.param(scale, marks=pytest.mark.slow) for scale in (1e-3, 1e3))])
@pytest.mark.parametrize("share", [0.05, 0.25, 0.9])
def test_a_ball_that_is_let_go_where_gravity_is_tangent_rolls_down(
    scale: float, spin: float, elasticity: float, share: float
) -> None:  # fmt: skip
    world = continuous_world(gravity=(0, -10 * scale))
    motion = {"motion": "kinematic", "angular_velocity": spin} if spin else {}
    world.add(Circle((0, 0), scale, elasticity=elasticity, **motion))
    away = (1 - share) * scale
    ball = world.add(Ball((away, 0), share * scale))
    before = energy(world)
    low = 0.0
    began = perf_counter()
    for _ in range(600):
        world.step(1 / 60)
        low = min(low, ball.position[1])
        assert perf_counter() - began < CLOCK
        assert hypot(*ball.position) <= away + 1e-3 * share * scale
        assert energy(world) <= before + 1e-9 * 10 * scale * scale
    assert low == pytest.approx(-away, rel=0.05)


#: Along which a ball slides, and where it begins: still and moving, concave and convex, bent and straight.
TRACKS: dict[str, tuple[Shape, tuple[float, float], tuple[float, float]]] = {
    "bowl": (Arc((0, 0), 2, pi, 0), (1.7 * sin(1), -1.7 * cos(1)), (0, 0)),
    "loop": (Circle((0, 0), 2), (0, -1.7), (9.5, 0)),
    "loop that is left": (Circle((0, 0), 2), (0, -1.7), (7, 0)),
    "dome": (Circle((0, 0), 2, solid=True), (0.2, sqrt(2.3**2 - 0.04)), (0, 0)),
    "ring that turns": (Circle((0, 0), 2, motion="kinematic", angular_velocity=2.0), (0, -1.7), (3, 0)),
    "ring that swings": (
        Circle((0, 0), 2, motion="kinematic", pivot=(0, 1), angular_velocity=0.7), (0, -1.7), (1, 0)
    ),
    "ring that travels": (Circle((0, 0), 2, motion="kinematic", velocity=(1, 0.5)), (0, -1.7), (3, 0)),
    "bar that turns": (
        Segment((-4, 0), (4, 0), motion="kinematic", pivot=(0, 0), angular_velocity=0.2), (1, 0.3), (-1, 0)
    ),
}  # fmt: skip
PATTERNS = ([16] * 64, [1, 700, 3, 64, 5, 200, 17, 33, 1], [1024])


@pytest.mark.compiled
@pytest.mark.parametrize("elasticity", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("track", TRACKS)
def test_a_sliding_ball_is_the_same_in_any_steps(track: str, elasticity: float) -> None:
    shape, place, velocity = TRACKS[track]
    seen = []
    for steps in PATTERNS:
        world = continuous_world(deepcopy(shape), gravity=(0, -10))
        ball = world.add(Ball(place, 0.3, velocity=velocity, elasticity=elasticity))
        for _ in range(3):
            for step in steps:
                world.step(step / 1024)
        seen.append((ball.position, ball.velocity))
    assert seen[0] == seen[1] == seen[2]
