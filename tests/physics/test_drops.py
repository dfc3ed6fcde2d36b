"""Balls dropped under gravity keep their energy exactly, whatever the substeps, the floor and the direction of gravity.

The apex of a ball is the height at which it would come to rest: `y + v²/2g`, measured against gravity from where it
touches. Every bounce takes e² of it.
"""

from math import cos, hypot, pi, sin, sqrt

import pytest

from carom import Arc, Ball, Circle, Compound, Point, Segment, World
from carom.shapes.shape import Shape

RADIUS = 0.5


def apex(world: World, ball: Ball) -> float:
    """How high a ball would rise against gravity from the origin, were there nothing in its way."""
    (gx, gy), (x, y), (vx, vy) = world.gravity, ball.position, ball.velocity
    g = hypot(gx, gy)
    return -(gx * x + gy * y) / g + (vx * vx + vy * vy) / (2.0 * g)


def bounces(world: World, dt: float, count: int) -> int:
    """How many hits there were when at least `count` have happened; a step at a time, so that none lasts too long."""
    done = 0
    while done < count:
        done += len(world.run(100 * dt, dt=dt))
    return done


@pytest.mark.compiled
@pytest.mark.parametrize(("substeps", "dt"), [(1, 1 / 60), (4, 1 / 60), (7, 0.0217), (1, 0.005)])
@pytest.mark.parametrize("motion", ["static", "kinematic"])
def test_an_elastic_ball_keeps_its_apex_over_a_thousand_bounces(substeps: int, dt: float, motion: str) -> None:
    world = World(detection="discrete", gravity=(0, -9.81), substeps=substeps)
    world.add(Segment((-5, 0), (5, 0), motion=motion))
    ball = world.add(Ball((0, 3.21), RADIUS))
    before = apex(world, ball)
    assert bounces(world, dt, 1000) >= 1000
    assert apex(world, ball) - RADIUS == pytest.approx(before - RADIUS, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("turn", [0.3, 2.0, -pi / 2, pi])
def test_gravity_in_any_direction_is_as_good(turn: float) -> None:
    gx, gy = 9.81 * sin(turn), -9.81 * cos(turn)
    world = World(detection="discrete", gravity=(gx, gy), substeps=2)
    world.add(Segment((5 * cos(turn), 5 * sin(turn)), (-5 * cos(turn), -5 * sin(turn))))
    ball = world.add(Ball((-2 * sin(turn), 2 * cos(turn)), RADIUS))
    before = apex(world, ball)
    bounces(world, 1 / 60, 1000)
    assert apex(world, ball) - RADIUS == pytest.approx(before - RADIUS, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("tilt", [0.05, -0.4, 1.2])
def test_a_tilted_floor_keeps_the_energy_of_a_ball_that_bounces_down_it(tilt: float) -> None:
    world = World(detection="discrete", gravity=(0, -9.81), substeps=3)
    far = 1e8
    world.add(Segment((-far * cos(tilt), -far * sin(tilt)), (far * cos(tilt), far * sin(tilt))))
    ball = world.add(Ball((0, 3), RADIUS, velocity=(0.5, 0)))
    before = apex(world, ball)
    bounces(world, 1 / 60, 1000)
    fallen = max(abs(ball.position[1]), before)
    assert apex(world, ball) == pytest.approx(before, rel=0.0, abs=1e-9 * fallen)


@pytest.mark.compiled
@pytest.mark.parametrize("shape", [Circle((0, 0), 4), Arc((0, 0), 4, pi - 0.2, 0.2), Circle((0, -9), 3, solid=True)])
def test_a_curved_floor_keeps_the_energy_too(shape: Shape) -> None:
    world = World(detection="discrete", gravity=(0, -9.81), substeps=2)
    world.add(shape)
    ball = world.add(Ball((0.7, -1.3), RADIUS))
    before = apex(world, ball)
    wanted = 1 if shape.position[1] < 0 else 1000
    bounces(world, 1 / 60, wanted)
    scale = max(abs(before), abs(ball.position[1]), 4.0)
    assert apex(world, ball) == pytest.approx(before, rel=0.0, abs=1e-9 * scale)


def first_rebound(floor: Shape | Compound, e: float, dt: float, substeps: int, **settings: object) -> float:
    """The height to which a ball rises after its first bounce, as a share of that from which it fell."""
    world = World(detection="discrete", gravity=(0, -9.81), rest_speed=0, substeps=substeps, **settings)  # type: ignore[arg-type]
    world.add(floor)
    ball = world.add(Ball((0.125, 4), RADIUS, elasticity=e))
    before = apex(world, ball) - RADIUS
    while not len(world.step(dt)):
        assert apex(world, ball) - RADIUS == pytest.approx(before, rel=1e-13)
    return (apex(world, ball) - RADIUS) / before


@pytest.mark.compiled
@pytest.mark.parametrize("e", [0.3, 0.5, 0.8, 0.95, 1.0, 1.2])
@pytest.mark.parametrize(("substeps", "dt"), [(1, 1 / 60), (4, 1 / 60), (3, 0.011)])
@pytest.mark.parametrize("restitution", ["normal", "total"])
def test_a_ball_rebounds_to_the_square_of_its_elasticity(e: float, substeps: int, dt: float, restitution: str) -> None:
    floors = (
        Segment((-5, 0), (5, 0)),
        Segment((-5, 0), (5, 0), motion="kinematic", pivot=(1, 1)),
        Compound([Segment((-5, 0), (5, 0))], pivot=(2, 0)),
    )
    for floor in floors:
        assert first_rebound(floor, e, dt, substeps, restitution=restitution) == pytest.approx(e * e, rel=1e-9)


@pytest.mark.parametrize("e", [0.3, 0.8])
def test_an_elasticity_of_the_floor_counts_as_well(e: float) -> None:
    share = first_rebound(Segment((-5, 0), (5, 0), elasticity=0.5), e, 1 / 60, 4)
    assert share == pytest.approx(0.25 * e * e, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("e", [0.5, 0.8, 0.95])
def test_every_later_bounce_takes_the_same_share(e: float) -> None:
    world = World(detection="discrete", gravity=(0, -9.81), rest_speed=0)
    world.add(Segment((-5, 0), (5, 0)))
    ball = world.add(Ball((0, 4), RADIUS, elasticity=e))
    height = apex(world, ball) - RADIUS
    done = 0
    # Below this a ball comes back within a substep, and two bounces are one.
    while height > 0.01:
        hits = len(world.step(1 / 240))
        done += hits
        height *= e ** (2 * hits)
        assert apex(world, ball) - RADIUS == pytest.approx(height, rel=1e-9)
    assert done >= 4


@pytest.mark.parametrize("kick", [0.5, 6.0])
def test_a_kick_is_added_to_the_speed_of_the_rebound(kick: float) -> None:
    share = first_rebound(Segment((-5, 0), (5, 0), kick=kick), 0.8, 1 / 60, 4)
    speed = sqrt(2 * 9.81 * 3.5)
    assert share == pytest.approx((0.8 * speed + kick) ** 2 / speed**2, rel=1e-9)


def test_a_platform_that_travels_is_met_in_its_own_frame() -> None:
    world = World(detection="discrete", gravity=(0, -9.81), rest_speed=0)
    world.add(Segment((-5, 0), (5, 0), motion="kinematic", velocity=(3, 0)))
    ball = world.add(Ball((0, 4), RADIUS, velocity=(3, 0), elasticity=0.8))
    while not len(world.step(1 / 240)):
        pass
    height = ball.position[1] + ball.velocity[1] ** 2 / (2 * 9.81) - RADIUS
    assert ball.velocity[0] == 3
    assert height == pytest.approx(0.64 * 3.5, rel=1e-9)


def test_a_rising_platform_throws_by_the_speed_of_both_and_loses_none_of_it() -> None:
    # In the platform's frame the ball falls from rest relative to the ground, and gravity is the same.
    ends = []
    for speed in (0.0, 2.0):
        world = World(detection="discrete", gravity=(0, -9.81), rest_speed=0)
        world.add(Segment((-5, 0), (5, 0), motion="kinematic", velocity=(0, speed)))
        ball = world.add(Ball((0, 4), RADIUS, velocity=(0, speed), elasticity=0.8))
        world.run(1.2, dt=1 / 240)
        ends.append((ball.position[1] - speed * world.time, ball.velocity[1] - speed))
    assert ends[0] == pytest.approx(ends[1], rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("shape", [Point((0, 0)), Circle((0, -1), 1, solid=True)])
def test_a_post_keeps_the_apex_of_a_ball_balanced_on_it(shape: Shape) -> None:
    world = World(detection="discrete", gravity=(0, -9.81))
    world.add(shape)
    ball = world.add(Ball((0, 3), RADIUS))
    before = apex(world, ball)
    bounces(world, 1 / 60, 1000)
    assert apex(world, ball) - RADIUS == pytest.approx(before - RADIUS, rel=1e-9)


def test_a_ball_comes_to_rest_and_stays_where_it_is() -> None:
    world = World(detection="discrete", gravity=(0, -9.81))
    world.add(Segment((-5, 0), (5, 0)))
    ball = world.add(Ball((0, 3), RADIUS, elasticity=0.6))
    world.run(8)
    assert len(world.run(5)) == 0
    assert ball.position == (0, pytest.approx(RADIUS, rel=1e-9))
    assert abs(ball.velocity[1]) <= 9.81 / 240
