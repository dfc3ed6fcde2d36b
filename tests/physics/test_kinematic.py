"""Shapes on rails: at rest they are static to the last bit, and they stop, turn and travel as they are told."""

from collections.abc import Callable
from math import cos, pi, sin

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Compound, Point, Segment, World
from carom.shapes.shape import Shape

Options = dict[str, object]


def walls(options: Options) -> list[Shape]:
    """A closed room, the same whatever moves it."""
    return [
        Point((-3, 4), **options),
        Segment((-6.1, -5), (6, -5.2), **options),
        Segment((-6.1, -5), (-6, 6), **options),
        Segment((6, -5.2), (6.2, 6), **options),
        Circle((0.3, -1), 1.2, solid=True, **options),
        Circle((0, 0), 9, **options),
        Arc((0, 3), 6.5, 0.2, pi - 0.1, **options),
    ]


def run(build: Callable[[World], object], **settings: object) -> tuple[bytes, bytes, bytes]:
    """All bits of a few balls after four seconds in a world, and of their hits but for the ids."""
    world = World(detection="discrete", gravity=(0.1, -9.81), **settings)  # type: ignore[arg-type]
    rng = np.random.default_rng(4)
    for _ in range(6):
        world.add(
            Ball(tuple(rng.uniform(-2, 3, 2)), rng.uniform(0.2, 0.5), tuple(rng.normal(0, 9, 2)), elasticity=0.97)
        )
    build(world)
    hits = world.run(4)
    assert len(hits) > 30
    said = np.concatenate([hits[name].ravel() for name in ("time", "point", "normal", "setback", "speed", "impulse")])
    return world.balls.position.tobytes(), world.balls.velocity.tobytes(), said.tobytes()


@pytest.mark.compiled
@pytest.mark.parametrize(("phase", "restitution"), [("brute", "normal"), ("grid", "total"), ("quadtree", "normal")])
@pytest.mark.parametrize(
    "options",
    [
        {"motion": "kinematic"},
        {"motion": "kinematic", "pivot": (17.3, -4.1)},
        {"motion": "kinematic", "pivot": (0.1, 0.7), "rotating": False, "angular_velocity": 40.0},
        {"motion": "kinematic", "pivot": (0.3, 0.2), "turn_limits": (0, 0), "angular_velocity": 40.0},
    ],
)
def test_a_kinematic_shape_at_rest_is_a_static_one_to_the_last_bit(
    options: Options, phase: str, restitution: str
) -> None:
    def build(world: World, given: Options) -> None:
        for shape in walls(given):
            world.add(shape)

    static = run(lambda world: build(world, {}), broad_phase=phase, restitution=restitution)
    assert run(lambda world: build(world, options), broad_phase=phase, restitution=restitution) == static


@pytest.mark.compiled
def test_a_compound_at_rest_is_a_static_shape_to_the_last_bit() -> None:
    static = run(lambda world: [world.add(shape) for shape in walls({})])
    assert run(lambda world: world.add(Compound(walls({}), pivot=(0.3, 9.1)))) == static


def test_a_flipper_is_static_again_once_it_has_turned_back() -> None:
    flipper = Segment((0.1, 0.3), (4.7, -0.9), motion="kinematic", pivot=(0.1, 0.3), turn_limits=(-0.5, 0.5))
    world = World(detection="discrete")
    world.add(flipper)
    before = flipper.p0, flipper.p1, flipper.t0, flipper.aabb
    flipper.angular_velocity = 3.0
    world.run(0.1)
    assert (flipper.p0, flipper.p1) != before[:2]
    flipper.angular_velocity = -3.0
    world.run(0.05)
    flipper.reset()
    flipper.angular_velocity = 0.0
    world.step(1 / 60)
    assert (flipper.p0, flipper.p1, flipper.t0, flipper.aabb) == before


@pytest.mark.parametrize(("spin", "stop"), [(7.3, 0.61), (-7.3, -0.37)])
@pytest.mark.parametrize("substeps", [1, 4, 9])
def test_a_stop_is_met_exactly_within_a_substep(spin: float, stop: float, substeps: int) -> None:
    world = World(detection="discrete", substeps=substeps)
    flipper = world.add(
        Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), angular_velocity=spin, turn_limits=(-0.37, 0.61))
    )
    steps = 0
    while flipper.angular_velocity != 0:
        world.step(1 / 60)
        steps += 1
    assert steps == np.ceil(abs(stop / spin) * 60)
    assert flipper.orientation == stop
    assert flipper.p1 == (pytest.approx(4 * cos(stop)), pytest.approx(4 * sin(stop)))
    before = flipper.p1
    world.run(0.5)
    assert flipper.orientation == stop
    assert flipper.p1 == before


def test_a_flipper_at_its_stop_is_at_rest_for_what_it_meets() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((0, 0), (9, 0), motion="kinematic", pivot=(0, 0), angular_velocity=5.0, turn_limits=(0, 0)))
    ball = world.add(Ball((5, 1), radius=1, velocity=(0, -2)))
    world.step(0.01)
    assert ball.velocity == (0, 2)


def test_the_substep_that_ends_at_a_stop_still_strikes() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((0, 0), (9, 0), motion="kinematic", pivot=(0, 0), angular_velocity=5.0, turn_limits=(0, 1e-3)))
    ball = world.add(Ball((5, 1), radius=1))
    world.step(0.01)
    assert ball.velocity[1] == pytest.approx(2 * 5 * 5, rel=1e-3)
    world.step(0.01)
    ball.position, ball.velocity = (5, 1), (0, -2)
    world.step(0.01)
    assert ball.velocity[1] == pytest.approx(2, rel=1e-2)


@pytest.mark.compiled
def test_a_million_small_turns_accumulate_no_drift() -> None:
    world = World(detection="discrete", substeps=1000)
    hand = world.add(Segment((1, 2), (4, 7), motion="kinematic", pivot=(-3, 1), angular_velocity=2 * pi))
    world.run(100, dt=1.0)
    turn = hand.orientation
    assert turn == pytest.approx(200 * pi, rel=1e-9)
    assert hand.length == pytest.approx(np.hypot(3, 5), rel=1e-13)
    x, y = hand.p0
    assert (x, y) == (
        pytest.approx(-3 + 4 * cos(turn) - 1 * sin(turn), abs=1e-11),
        pytest.approx(1 + 4 * sin(turn) + 1 * cos(turn), abs=1e-11),
    )


def test_velocity_moves_the_pivot_and_the_shape_with_it() -> None:
    world = World(detection="discrete", substeps=8)
    paddle = world.add(Arc((1, 1), 2, 0, pi, motion="kinematic", pivot=(5, 0), velocity=(0.5, -0.25)))
    world.step(4.0)
    assert paddle.position == (3, 0)
    assert paddle.pivot == (7, -1)
    assert paddle.p0 == (5, 0)
    assert paddle.orientation == 0


def test_a_shape_turns_about_a_pivot_that_travels() -> None:
    world = World(detection="discrete", substeps=1)
    post = world.add(Point((2, 0), motion="kinematic", pivot=(0, 0), angular_velocity=pi / 2, velocity=(1, 1)))
    world.step(1.0)
    assert post.position == (pytest.approx(1), pytest.approx(3))


def test_a_compound_s_parts_turn_and_strike_as_one() -> None:
    world = World(detection="discrete", substeps=1)
    blade = Segment((1, 0), (9, 0))
    tip = Point((9, 0))
    world.add(Compound([blade, tip], pivot=(0, 0), angular_velocity=1.0))
    ball = world.add(Ball((5, 1), radius=1))
    hits = world.step(1e-6)
    assert [hit.shape for hit in hits] == [blade]
    assert ball.velocity[1] == pytest.approx(10, rel=1e-4)
    assert tip.orientation == blade.orientation == 1e-6


def test_a_switch_stops_a_turn_at_once() -> None:
    world = World(detection="discrete", substeps=1)
    mill = world.add(Segment((-3, 0), (3, 0), motion="kinematic", angular_velocity=2.0))
    world.step(0.5)
    mill.rotating = False
    before = mill.p0
    world.step(0.5)
    assert mill.p0 == before
    assert mill.angular_velocity == 2
    mill.rotating = True
    world.step(0.5)
    assert mill.orientation == 2
