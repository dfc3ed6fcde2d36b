"""Gates in a world: open from one side, a segment from the other, whatever way they turn."""

from math import pi

import pytest

from carom import Ball, Gate, World


def hits_of(ball: Ball, gate: Gate, seconds: float = 4.0) -> int:
    """How often a ball meets a gate in an otherwise empty world."""
    world = World(substeps=1)
    world.add(gate)
    world.add(ball)
    return len(world.run(seconds, dt=0.1))


@pytest.mark.parametrize("direction", [None, (0, 1), (3, 1), (-2, 0.1)])
def test_a_ball_passes_along_the_direction_and_bounces_against_it(direction: tuple[float, float] | None) -> None:
    along = Ball((5, -2), radius=1, velocity=(0, 1))
    assert hits_of(along, Gate((0, 0), (10, 0), direction)) == 0
    assert along.velocity == (0, 1)
    assert along.position[1] > 1.5
    against = Ball((5, 2), radius=1, velocity=(0, -1))
    assert hits_of(against, Gate((0, 0), (10, 0), direction)) == 1
    assert against.velocity == (0, 1)


def test_the_order_of_the_ends_does_not_turn_a_gate() -> None:
    ball = Ball((5, -2), radius=1, velocity=(0, 1))
    assert hits_of(ball, Gate((10, 0), (0, 0))) == 0


def test_a_ball_that_turns_back_half_way_is_let_out_where_it_came_from() -> None:
    world = World(substeps=1)
    world.add(Gate((0, 0), (10, 0)))
    ball = world.add(Ball((5, -2), radius=1, velocity=(0, 1)))
    world.run(2.5, dt=0.1)
    assert ball.position[1] == pytest.approx(0.5)
    ball.velocity = (0, -1)
    assert len(world.run(2, dt=0.1)) == 0
    assert ball.velocity == (0, -1)


def test_a_ball_that_has_passed_is_stopped_on_its_way_back() -> None:
    world = World(substeps=1)
    gate = world.add(Gate((0, 0), (10, 0)))
    ball = world.add(Ball((5, -2), radius=1, velocity=(0, 1)))
    world.run(3.5, dt=0.1)
    ball.velocity = (0, -1)
    hits = world.run(1, dt=0.1)
    assert [hit.shape for hit in hits] == [gate]
    assert ball.velocity == (0, 1)


def test_a_ball_pressed_against_the_closed_side_stays_there() -> None:
    world = World(gravity=(0, -10))
    world.add(Gate((0, 0), (10, 0), elasticity=0.5))
    ball = world.add(Ball((5, 2), radius=1))
    world.run(5)
    assert ball.position[1] == pytest.approx(1, abs=1e-6)


def test_a_ball_placed_on_a_gate_goes_by_the_side_of_its_centre() -> None:
    for y, hits, end in ((0.4, 1, 1.0), (-0.4, 0, -0.5)):
        world = World(detection="discrete", substeps=1)
        world.add(Gate((0, 0), (10, 0)))
        ball = world.add(Ball((5, y), radius=1, velocity=(0, -1)))
        assert len(world.step(0.1)) == hits
        assert ball.position[1] == pytest.approx(end)


def test_a_gate_that_turns_takes_its_sides_along() -> None:
    world = World(substeps=1)
    gate = world.add(Gate((-5, 0), (5, 0), motion="kinematic", pivot=(0, 0)))
    for quarters in range(9):
        gate.rotate((0, 0), quarters * pi / 2)
        x, y = gate.direction
        along = world.add(Ball((-2 * x, -2 * y), radius=1, velocity=(x, y)))
        assert len(world.run(4, dt=0.1)) == 0
        assert along.velocity == (x, y)
        world.remove(along)
        against = world.add(Ball((2 * x, 2 * y), radius=1, velocity=(-x, -y)))
        assert len(world.run(4, dt=0.1)) == 1
        assert against.velocity == (pytest.approx(x, abs=1e-15), pytest.approx(y, abs=1e-15))
        world.remove(against)


@pytest.mark.parametrize(("place", "hits"), [((-3.0, -1.2), 0), ((3.0, 1.2), 1)])
def test_a_turning_gate_lets_by_what_it_meets_with_its_open_side(place: tuple[float, float], hits: int) -> None:
    world = World(substeps=1)
    world.add(Gate((-5, 0), (5, 0), (0, 1), motion="kinematic", pivot=(0, 0), angular_velocity=1.0))
    ball = world.add(Ball(place, radius=1))
    assert len(world.run(0.7, dt=0.02)) == hits
    assert (ball.position == place) is (hits == 0)


def test_a_travelling_gate_lets_balls_by_in_its_own_frame() -> None:
    for velocity, hits in (((0, -2), 0), ((0, 2), 1)):
        world = World(substeps=1)
        world.add(Gate((0, 0), (10, 0), motion="kinematic", velocity=velocity))
        ball = world.add(Ball((5, -2 if hits == 0 else 2), radius=1))
        assert len(world.run(2, dt=0.1)) == hits
        assert ball.velocity == ((0, 4) if hits else (0, 0))


def test_a_ball_too_fast_to_be_seen_before_the_gate_passes_from_its_open_side() -> None:
    ball = Ball((5, -1.05), radius=1, velocity=(0, 14))
    assert hits_of(ball, Gate((0, 0), (10, 0)), seconds=1) == 0
    assert ball.velocity == (0, 14)


def test_a_ball_pushed_onto_the_open_side_passes() -> None:
    world = World(substeps=1)
    world.add(Gate((0, 0), (10, 0)))
    ball = world.add(Ball((5, -1), radius=1))
    world.add(Ball((5, -2.5), radius=1, mass=1e9))
    world.step(0.1)
    assert ball.position[1] == pytest.approx(-0.5)
