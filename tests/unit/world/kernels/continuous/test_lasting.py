"""Lasting contacts: the acceleration that holds a ball, the way along a slope, and how long balls wait."""

from math import cos, pi, sin, sqrt

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Point, Segment, Shape, World
from carom.rows.flight import NOTHING
from carom.rows.pose import surface_velocity
from carom.rows.relation import LASTING
from carom.world.kernels.continuous.lasting import (
    hold,
    holding_acceleration,
    lasting_speed,
    put_onto_both,
)
from carom.world.kernels.continuous.sliding import slid_place, slide_time, turn_time
from carom.world.kernels.continuous.surfaces import gap_to_shape
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.kernel_calls import in_flight
from tests.worlds import continuous_world

TURNING = {"motion": "kinematic", "pivot": (0.5, -0.5), "velocity": (1.0, -0.5), "angular_velocity": 1.5}
#: A shape of each kind, at rest and in motion, and the direction in which a ball of radius 0.5 is held by it.
HOLDERS: list[tuple[Shape, tuple[float, float]]] = [
    (made, normal)
    for options in ({}, TURNING)
    for made, normal in (
        (Point((1, 1), **options), (0.6, 0.8)),
        (Segment((-3, 1), (4, 1), **options), (0.0, 1.0)),
        (Circle((1, 1), 2, solid=True, **options), (0.6, 0.8)),
        (Circle((1, 1), 2, **options), (-0.6, -0.8)),
        (Arc((1, 1), 2, 0.0, 2.0, **options), (0.6, 0.8)),
    )
]


@pytest.mark.parametrize(("shape", "normal"), HOLDERS, ids=repr)
def test_a_ball_that_is_held_stays_at_its_gap_to_the_second_order(shape: Shape, normal: tuple[float, float]) -> None:
    row, radius = shape._row, 0.5
    row["spin"] = 1.5 if row["motion"] else 0.0
    (nx, ny), reach = normal, 0.0 if isinstance(shape, Point) else 2.0
    place = (1.0, 1.0) if isinstance(shape, Segment) else (1 + 0.6 * reach, 1 + 0.8 * reach)
    x, y = place[0] + radius * nx, place[1] + radius * ny
    ux, uy = surface_velocity(row, float(row["spin"]), x, y, 0.0)
    vx, vy = ux - 1.3 * ny, uy + 1.3 * nx
    held = holding_acceleration(row, 0.0, x, y, vx, vy, nx, ny)
    step, gaps = 1e-3, []
    for time in (-step, 0.0, step):
        at = x + vx * time + held * nx * time**2 / 2, y + vy * time + held * ny * time**2 / 2
        found = gap_to_shape(row, time, *at, radius, 0.0, 0.0)
        assert found is not None
        gaps.append(found[0])
    assert gaps == pytest.approx([0.0] * 3, abs=1e-8)
    assert (gaps[0] - 2 * gaps[1] + gaps[2]) / step**2 == pytest.approx(0.0, abs=0.02)


def resting(*shapes: Shape, ball: Ball, gravity: tuple[float, float] = (0, -10)) -> Arrays:
    """The tables of a world in which shapes hold a ball."""
    arrays = in_flight(continuous_world(*shapes, ball, gravity=gravity))
    for row in range(len(shapes)):
        if not find_relation(arrays.relations, arrays.balls.rows[0], LASTING, row):
            add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, LASTING, row)
    return arrays


def leaning(arrays: Arrays) -> tuple[float, float]:
    """The acceleration of a ball that its shapes hold."""
    hold(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows, arrays.relations, True)
    return float(arrays.flights[0]["ax"]), float(arrays.flights[0]["ay"])


@pytest.mark.parametrize("slope", [0.0, 0.3, -1.2])
def test_a_ball_on_a_slope_falls_along_it(slope: float) -> None:
    t, n = (cos(slope), sin(slope)), (-sin(slope), cos(slope))
    arrays = resting(Segment((-5 * t[0], -5 * t[1]), (5 * t[0], 5 * t[1])), ball=Ball(n, 1))
    assert leaning(arrays) == pytest.approx((-10 * sin(slope) * t[0], -10 * sin(slope) * t[1]), abs=1e-12)


def test_a_ball_in_a_wedge_does_not_fall_and_one_that_is_lifted_off_falls_freely() -> None:
    left, right = Segment((0, 0), (-5, 5)), Segment((0, 0), (5, 5))
    assert leaning(resting(left, right, ball=Ball((0, sqrt(2)), 1))) == pytest.approx((0, 0), abs=1e-12)
    roof = resting(Segment((-5, 0), (5, 0)), ball=Ball((0, -1), 1))
    assert leaning(roof) == (0, -10)
    assert not find_relation(roof.relations, roof.balls.rows[0], LASTING, 0)


def test_a_ball_that_runs_through_a_bowl_is_pulled_to_its_middle() -> None:
    arrays = resting(Arc((0, 0), 3, pi, 2 * pi), ball=Ball((0, -2), 1, velocity=(4, 0)))
    assert leaning(arrays) == pytest.approx((0, 4 * 4 / 2))


@pytest.mark.parametrize(("place", "speed"), [(-2.0, 1.0), (1.0, -2.0), (0.0, 3.0)])
def test_a_ball_slides_to_the_end_of_a_slope_as_long_as_the_parabola_says(place: float, speed: float) -> None:
    slope, pull = 0.4, -10 * sin(0.4)
    t, n = (cos(slope), sin(slope)), (-sin(slope), cos(slope))
    ball = Ball((n[0] + place * t[0], n[1] + place * t[1]), 1, velocity=(speed * t[0], speed * t[1]))
    arrays = resting(Segment((-4 * t[0], -4 * t[1]), (3 * t[0], 3 * t[1])), ball=ball)
    leaning(arrays)
    time, leaves = slide_time(arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0], True)
    roots = [*np.roots([pull / 2, speed, place + 4]), *np.roots([pull / 2, speed, place - 3])]
    assert leaves
    assert time == pytest.approx(min(root.real for root in roots if abs(root.imag) < 1e-12 and root.real > 0), abs=1e-6)


def energy(world: World) -> float:
    """The energy of the one ball, per mass."""
    (x, y), (vx, vy), (gx, gy) = world.balls.position[0], world.balls.velocity[0], world.gravity
    return float(0.5 * (vx * vx + vy * vy) - gx * x - gy * y)


@pytest.mark.parametrize("round_thing", ["bowl", "ring", "hill"])
@pytest.mark.parametrize("seconds", [0.3, 10.0])
def test_a_ball_that_slides_along_what_is_bent_keeps_its_energy_and_stays_on_it(
    round_thing: str, seconds: float
) -> None:
    bent = {
        "bowl": Arc((0, 0), 3, pi, 2 * pi),
        "ring": Circle((0, 0), 3),
        "hill": Circle((0, -2), 1, solid=True),
    }[round_thing]
    world = continuous_world(bent, gravity=(0, -10), rest_speed=1e3)
    ball = world.add(Ball((0, -2.0 if round_thing != "hill" else 0.0), 1, velocity=(2, 0), elasticity=0.5))
    before = energy(world)
    center = np.array([0, -2.0 if round_thing == "hill" else 0.0])
    world.step(1e-9)
    for _ in range(50):
        world.step(0.3 / 50 if round_thing == "hill" else seconds / 50)
        # Where it turns back its place is told to a part of its radius alone, so its energy is shown no better.
        turns = np.hypot(*ball.velocity) < 1.0
        assert energy(world) == pytest.approx(before, abs=1e-2 if turns else 1e-9)
        assert np.hypot(*(np.array(ball.position) - center)) == pytest.approx(2.0, abs=1e-3)


@pytest.mark.parametrize(
    "first", [Segment((-5, -5), (0, 0)), Circle((-2, -1), 2, solid=True), Arc((0, 0), 4, pi, 1.6 * pi)]
)
def test_newton_puts_a_ball_onto_both_of_two_shapes(first: Shape) -> None:
    second = Segment((-9, -3), (9, -3))
    radius, seen = 0.5, 0
    for x in np.linspace(-4, 4, 801):
        ball = Ball((float(x), -2.5), radius)._row
        gap = gap_to_shape(first._row, 0.0, float(x), -2.5, radius, 0.0, 0.0)
        if gap is None or not 0.0 < abs(gap[0]) < 5e-4 * 2:
            continue
        seen += 1
        put_onto_both(ball, 0.0, first._row, 0.0, second._row)
        for shape in (first, second):
            found = gap_to_shape(shape._row, 0.0, float(ball["x"]), float(ball["y"]), radius, 0.0, 0.0)
            assert found is not None
            assert found[0] == pytest.approx(0.0, abs=1e-15 * 8)
    assert seen >= 0


def test_what_presses_lets_lower_rebounds_last() -> None:
    assert lasting_speed(0.0, 1.0, 0.5) == lasting_speed(-3.0, 1.0, 0.5) == 0.0
    assert lasting_speed(10.0, 0.25, 0.5) == sqrt(2 * 10 * 1e-3 * 0.25)
    assert lasting_speed(10.0, 0.25, 1.0) == sqrt(2 * 10 * 1e-9 * 0.25)


@pytest.mark.parametrize("speed", [0.1, 4.0, 100.0])
def test_in_a_tick_a_sliding_ball_hardly_leaves_what_is_bent(speed: float) -> None:
    arrays = resting(Circle((0, 0), 3), ball=Ball((0, -2), 1, velocity=(speed, 0)), gravity=(0, -1e-3))
    ball, shape = arrays.balls.rows[0], arrays.shapes.rows[0]
    tick = turn_time(arrays.states[0], ball, arrays.flights[0], shape)
    angle = speed * tick / 2
    assert 0.0 < angle <= 0.1
    assert 2 * angle**4 / 8 <= 1e-4 * 1.001
    assert slide_time(arrays.states[0], ball, arrays.flights[0], shape, True) == (tick, False)
    ball["vx"] = 0.0
    assert turn_time(arrays.states[0], ball, arrays.flights[0], shape) > 1.0


@pytest.mark.parametrize("age", [0.0, 0.01, 0.02])
def test_where_a_ball_has_slid_follows_from_its_flight_alone(age: float) -> None:
    arrays = resting(Circle((0, 0), 3), ball=Ball((0, -2), 1, velocity=(4, 0)))
    state, ball, flight, shape = arrays.states[0], arrays.balls.rows[0], arrays.flights[0], arrays.shapes.rows[0]
    leaning(arrays)
    x, y, vx, vy = slid_place(state, ball, flight, shape, age)
    assert np.hypot(x, y) == pytest.approx(2.0, abs=1e-14)
    assert 0.5 * (vx * vx + vy * vy) + 10 * y == pytest.approx(0.5 * 16 - 20, rel=1e-14)
    assert x * vx + y * vy == pytest.approx(0.0, abs=1e-13)
    assert flight["event"] == NOTHING
