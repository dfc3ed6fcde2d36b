"""Shapes that move and turn in the continuous mode: met at any speed, in their own frame, stopped exactly."""

from functools import partial
from math import acos, asin, cos, hypot, pi, sin
from typing import Any, Literal

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Compound, Gate, Point, Segment, guard_points
from carom.shapes.shape import Shape
from tests.worlds import continuous_world

#: Worlds without gravity or rest speed.
lively_world = partial(continuous_world, rest_speed=0.0)

G = 10.0


@pytest.mark.parametrize("velocity", [(0.0, 2.0), (3.0, 0.0), (1.0, -3.0), (0.0, 50.0)])
@pytest.mark.parametrize("elasticity", [1.0, 0.8, 0.5])
def test_a_platform_that_travels_is_a_floor_in_its_own_frame(velocity: tuple[float, float], elasticity: float) -> None:
    ux, uy = velocity
    lift = lively_world(Segment((-5, 0), (5, 0), motion="kinematic", velocity=velocity), gravity=(0, -G))
    still = lively_world(Segment((-5, 0), (5, 0)), gravity=(0, -G))
    one = lift.add(Ball((0, 1.7), 0.5, velocity=(ux + 0.1, uy + 1), elasticity=elasticity))
    other = still.add(Ball((0, 1.7), 0.5, velocity=(0.1, 1), elasticity=elasticity))
    hits, expected = np.asarray(lift.run(3)), np.asarray(still.run(3))
    assert hits["time"] == pytest.approx(expected["time"], abs=1e-9)
    assert hits["impulse"] == pytest.approx(expected["impulse"], rel=1e-8, abs=1e-9)
    (x, y), (vx, vy) = one.position, one.velocity
    assert (x - 3 * ux, y - 3 * uy) == pytest.approx(other.position, abs=1e-9)
    assert (vx - ux, vy - uy) == pytest.approx(other.velocity, abs=1e-8)


@pytest.mark.parametrize("speed", [1.0, 1e2, 1e4])
@pytest.mark.parametrize("elasticity", [1.0, 0.5])
def test_a_paddle_throws_a_ball_at_rest(speed: float, elasticity: float) -> None:
    world = lively_world(Segment((0, -5), (0, 5), motion="kinematic", velocity=(speed, 0)))
    ball = world.add(Ball((3, 0.3), 0.5, elasticity=elasticity))
    (hit,) = world.step(5 / speed)
    assert hit.time == pytest.approx(2.5 / speed, rel=1e-12)
    assert ball.velocity == pytest.approx(((1 + elasticity) * speed, 0))
    assert ball.position == pytest.approx((3 + (1 + elasticity) * 2.5, 0.3))


def bar(**motion: Any) -> Segment:
    """A flipper that lies on the x axis and turns about the origin."""
    return Segment((0, 0), (4, 0), motion="kinematic", pivot=(0, 0), **motion)


@pytest.mark.parametrize("spin", [1.0, 10.0, 100.0, 1000.0])
@pytest.mark.parametrize("elasticity", [1.0, 0.5])
def test_a_ball_that_rests_on_a_flipper_is_thrown_when_it_starts(spin: float, elasticity: float) -> None:
    flipper = bar(turn_limits=(0, 0.8))
    world = lively_world(flipper, gravity=(0, -G), rest_speed=None)
    ball = world.add(Ball((2, 0.5), 0.5, elasticity=elasticity))
    assert len(world.run(0.5)) == 0
    assert ball.position == pytest.approx((2, 0.5), abs=1e-9)
    flipper.angular_velocity = spin
    hits = world.step(1e-6)
    assert len(hits) == 1
    assert hits[0].speed == pytest.approx(2 * spin, rel=1e-3)
    assert ball.velocity == pytest.approx((0, (1 + elasticity) * 2 * spin), rel=1e-3, abs=1e-4 * spin)
    world.run(1)
    assert flipper.orientation == 0.8
    assert flipper.angular_velocity == 0
    assert np.isfinite(world.balls.position).all()
    assert world.statistics.stalled == 0


@pytest.mark.parametrize("spin", [2.0, 30.0])
def test_a_ball_without_elasticity_is_carried_along_a_turning_bar(spin: float) -> None:
    world = lively_world(bar(angular_velocity=spin), substeps=8)
    ball = world.add(Ball((1, 0.5), 0.5, elasticity=0))
    # Along the bar s'' = ω²s from s = 1, s' = ω·0.5: the ball is at rest at first, and the surface moves under it.
    turn = 0.6
    for _ in range(60):
        world.step(turn / spin / 60)
    x, y = ball.position
    along, off = x * cos(turn) + y * sin(turn), y * cos(turn) - x * sin(turn)
    assert off == pytest.approx(0.5, abs=1e-3 * 0.5)
    # s = cosh(ωt) + (0.5)·sinh(ωt), from s'(0) = 0·t + ω·0.5.
    assert along == pytest.approx(np.cosh(turn) + 0.5 * np.sinh(turn), rel=2e-3)
    assert world.statistics.stalled == 0


@pytest.mark.parametrize("spin", [1.0, 1e2, 1e3, 1e5])
def test_a_bar_from_behind_hits_when_it_comes(spin: float) -> None:
    rng = np.random.default_rng(0)
    for _ in range(50):
        world = lively_world(bar(angular_velocity=spin))
        place, away = rng.uniform(0.5, 2 * pi - 0.5), rng.uniform(1, 3.9)
        ball = world.add(Ball((away * cos(place), away * sin(place)), 0.2, elasticity=rng.choice([0, 0.5, 1])))
        touch = place - asin(0.2 / away)
        hits = world.step((touch + 0.2) / spin)
        assert hits[0].time == pytest.approx(touch / spin, rel=1e-9)
        assert hits[0].speed == pytest.approx(spin * hypot(*hits[0].point), rel=1e-9)
        (x, y) = ball.position
        assert y * cos(touch + 0.2) - x * sin(touch + 0.2) > 0.2 * (1 - 1e-3)


@pytest.mark.parametrize("spin", [7.0, 100.0])
def test_a_flipper_stops_exactly_and_is_still_from_then_on(spin: float) -> None:
    stop = 0.3
    flipper = bar(turn_limits=(0, stop), angular_velocity=spin)
    away = 3.0
    place = stop + asin(0.5 / away) + 0.1
    world = lively_world(flipper)
    ball = world.add(Ball((away * cos(place), away * sin(place)), 0.5, velocity=(0, -1)))
    hits = world.step(1 / 2)
    assert flipper.orientation == stop
    assert flipper.angular_velocity == 0
    # It comes to the bar after that has stopped, so it keeps its speed.
    assert len(hits) == 1
    assert hits[0].speed == pytest.approx(1, rel=1e-12)
    assert hypot(*ball.velocity) == pytest.approx(1, rel=1e-12)


def test_a_kinematic_shape_at_rest_is_a_static_one_to_the_last_bit() -> None:
    runs = []
    for motion in ("static", "kinematic"):
        walls = [
            Segment((0, 0), (5, 0.3), motion=motion),
            Segment((5, 0.3), (4.7, 5), motion=motion),
            Segment((4.7, 5), (0, 5.5), motion=motion),
            Segment((0, 5.5), (0, 0), motion=motion),
            Circle((2, 2), 0.5, motion=motion),
            Arc((3, 3.5), 0.7, 1, 5, motion=motion),
            Point((1, 4), motion=motion),
        ]
        world = lively_world(*walls, *guard_points(walls), gravity=(0.3, -4), rest_speed=None)
        world.add_balls([(1, 1), (3, 1), (1.5, 3)], velocity=(2.0, 3.1), radius=[0.2, 0.3, 0.1], elasticity=0.9)
        hits = np.asarray(world.run(10)).copy()
        runs.append((hits["time"].tobytes(), hits["impulse"].tobytes(), world.balls.position.tobytes()))
    assert runs[0] == runs[1]


def flipper_of_arcs(spin: float) -> Compound:
    """A compound flipper: two rails and two round ends, that turns about the middle of one end."""
    base, tip, length = 0.5, 0.2, 3.0
    lean = acos((base - tip) / length)
    rails: list[Shape] = [
        Segment((base * cos(side), base * sin(side)), (length + tip * cos(side), tip * sin(side)))
        for side in (lean, -lean)
    ]
    ends = [Arc((0, 0), base, lean, 2 * pi - lean), Arc((length, 0), tip, 2 * pi - lean, lean)]
    return Compound([*rails, *ends], pivot=(0, 0), angular_velocity=spin)


@pytest.mark.compiled
@pytest.mark.parametrize("spin", [3.0, -100.0, 1000.0])
@pytest.mark.parametrize("elasticity", [1.0, 0.3])
def test_nothing_gets_into_a_flipper(spin: float, elasticity: float) -> None:
    rng = np.random.default_rng(5)
    count = 40
    world = lively_world(flipper_of_arcs(spin), Circle((0, 0), 8), substeps=2)
    angle, away = rng.uniform(0.4, 2 * pi - 0.4, count), rng.uniform(1, 7.5, count)
    radius = rng.uniform(0.05, 0.3, count)
    world.add_balls(np.stack([away * np.cos(angle), away * np.sin(angle)], 1), radius=radius, elasticity=elasticity)
    world._arrays.balls.used["layer"], world._arrays.balls.used["collides_with"] = 2, 1
    turned = 0.0
    for _ in range(150):
        turn = rng.uniform(0.01, 2.5)
        world.step(turn / abs(spin))
        turned += turn if spin > 0 else -turn
        x, y = world.balls.position.T
        along, off = x * cos(turned) + y * sin(turned), np.abs(y * cos(turned) - x * sin(turned))
        # Distance from the flipper's skeleton, a tapered line, less its half width there.
        inside = (np.clip(along, 0, 3), 0.5 - 0.1 * np.clip(along, 0, 3))
        assert (np.hypot(along - inside[0], off) > inside[1] * 0.9).all()
        assert (np.hypot(x, y) < 8 - radius * (1 - 1e-6)).all()
        assert np.isfinite(world.balls.velocity).all()
    assert world.statistics.stalled == 0
    if elasticity == 1:
        assert np.hypot(*world.balls.velocity.T).max() < abs(spin) * 8 * 200


@pytest.mark.parametrize("broad_phase", ["grid", "brute"])
@pytest.mark.parametrize("gravity", [0.0, -1.0])
@pytest.mark.parametrize("sensor", [False, True])
@pytest.mark.parametrize("kind", ["point", "segment", "circle", "arc", "gate", "flipper"])
def test_what_comes_to_rest_behind_a_ball_is_not_met(
    kind: str, sensor: bool, gravity: float, broad_phase: Literal["grid", "brute"]
) -> None:
    # The ball is far beyond when the shape stops across its way.
    moved: dict[str, Any] = {"motion": "kinematic", "sensor": sensor}
    shape: Point | Segment | Circle | Arc | Gate = {
        "point": lambda: Point((1, 5), **moved),
        "segment": lambda: Segment((1, 3), (1, 7), **moved),
        "circle": lambda: Circle((1, 5), 0.5, **moved),
        "arc": lambda: Arc((0, 5), 1, -1.5, 1.5, **moved),
        "gate": lambda: Gate((1, 3), (1, 7), direction=(1, 0), **moved),
        "flipper": lambda: Segment((1, 1), (3, 1), pivot=(1, 1), turn_limits=(-pi / 2, pi), **moved),
    }[kind]()
    world = continuous_world(shape, gravity=(0, gravity), broad_phase=broad_phase)
    ball = world.add(Ball((0, 0), 0.2, velocity=(10, 0)))
    if kind == "flipper":
        shape.angular_velocity = -pi / 4
    else:
        shape.move_to((shape.position[0], 0), dt=2.0)
    hits = world.run(4.0, 0.5)
    assert len(hits) == 0
    assert ball.position == pytest.approx((40.0, 8.0 * gravity), abs=1e-13)
