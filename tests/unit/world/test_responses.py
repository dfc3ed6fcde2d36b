"""Responses in a world: bounces, kicks, rest, friction, and the speed limit."""

from math import cos, hypot, sin

import pytest

from carom import Arc, Ball, Circle, Point, Segment, World


def struck(ball: Ball, shape: object, **settings: object) -> tuple[World, Ball]:
    """A world of one substep a step in which a ball and a shape have met for a tenth of a second."""
    world = World(detection="discrete", substeps=1, **settings)  # type: ignore[arg-type]
    world.add(shape)  # type: ignore[type-var]
    world.add(ball)
    world.step(0.1)
    return world, ball


def test_a_bounce_scales_the_normal_speed_alone() -> None:
    _, ball = struck(Ball((0, 1), radius=1, velocity=(3, -2), elasticity=0.5), Segment((-9, 0), (9, 0), elasticity=0.5))
    assert ball.velocity == (3, 0.5)
    assert ball.position == (pytest.approx(0.3), 1)


def test_a_total_bounce_scales_the_whole_velocity() -> None:
    ball = Ball((0, 1), radius=1, velocity=(3, -2), elasticity=0.5)
    struck(ball, Segment((-9, 0), (9, 0), elasticity=0.5), restitution="total")
    assert ball.velocity == (0.75, 0.5)


def test_a_total_bounce_is_relative_to_the_surface() -> None:
    ball = Ball((0, 1), radius=1, velocity=(3, -2), elasticity=0.5)
    struck(ball, Segment((-9, 0), (9, 0), motion="kinematic", velocity=(1, 0)), restitution="total")
    assert ball.velocity == (2, 1)


def test_elasticity_above_one_adds_speed() -> None:
    _, ball = struck(Ball((0, 2), radius=1, velocity=(0, -2)), Circle((0, 0), 1, solid=True, elasticity=1.5))
    assert ball.velocity == (0, 3)


@pytest.mark.parametrize("shape", [Point, lambda place, **options: Circle(place, 0.5, solid=True, **options)])
def test_a_kick_adds_its_speed_along_the_normal(shape: type[Point]) -> None:
    place = (0.0, 0.0)
    ball = Ball((3 * 0.5, 4 * 0.5), radius=2.5, velocity=(0, 0.0))
    reach = 2.5 if shape is Point else 3.0
    ball.position = 0.6 * reach, 0.8 * reach
    ball.velocity = -0.6, -0.8
    struck(ball, shape(place, elasticity=0.25, kick=5.0))
    assert ball.velocity == (pytest.approx(0.6 * 5.25), pytest.approx(0.8 * 5.25))


def test_a_kick_is_given_to_the_slowest_approach_and_to_none_that_leaves() -> None:
    _, ball = struck(
        Ball((0, 1), radius=1, velocity=(0, -1e-6)), Segment((-9, 0), (9, 0), elasticity=0.1, kick=5.0), rest_speed=1.0
    )
    assert ball.velocity[1] == pytest.approx(5)
    _, ball = struck(Ball((0, 0.5), radius=1, velocity=(0, 1)), Segment((-9, 0), (9, 0), kick=5.0))
    assert ball.velocity == (0, 1)
    assert ball.position == (0, 1)


def test_a_slow_approach_rests_and_gives_no_hit() -> None:
    for speed, hits in ((0.099, 0), (0.101, 1)):
        world = World(detection="discrete", substeps=1, rest_speed=0.1)
        world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
        ball = world.add(Ball((0, 1), radius=1, velocity=(3, -speed)))
        assert len(world.step(0.1)) == hits
        assert ball.velocity == (3, pytest.approx(0.5 * speed * hits))
        assert world.statistics.collisions == hits


def test_nothing_rests_at_elasticity_one() -> None:
    _, ball = struck(Ball((0, 1), radius=1, velocity=(0, -0.01)), Segment((-9, 0), (9, 0)), rest_speed=0.1)
    assert ball.velocity == (0, 0.01)


def test_the_default_rest_speed_is_twice_what_gravity_adds_in_a_substep() -> None:
    for speed, hits in ((1.99, 0), (2.01, 1)):
        world = World(detection="discrete", substeps=2, gravity=(0, -10))
        world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
        # Touches half-way through the first substep of 0.1 s, with this speed.
        fallen = (speed - 0.5) * 0.05 + 5 * 0.05 * 0.05
        world.add(Ball((0, 1 + fallen), radius=1, velocity=(0, 0.5 - speed)))
        assert world.rest_speed is None
        assert len(world.step(0.2)) == hits


def test_two_balls_rest_against_each_other_too() -> None:
    for speed, hits in ((0.099, 0), (0.101, 1)):
        world = World(detection="discrete", substeps=1, rest_speed=0.1)
        first = world.add(Ball((0, 0), radius=1, velocity=(speed, 0.5), elasticity=0.5, mass=3))
        second = world.add(Ball((2, 0), radius=1, velocity=(0, 0.5)))
        assert len(world.step(0.1)) == hits
        if not hits:
            assert first.velocity == (pytest.approx(0.75 * speed), 0.5)
            assert second.velocity == (pytest.approx(0.75 * speed), 0.5)


def test_without_gravity_nothing_rests_by_default() -> None:
    _, ball = struck(Ball((0, 1), radius=1, velocity=(0, -1e-9)), Segment((-9, 0), (9, 0), elasticity=0.5))
    assert ball.velocity == (0, pytest.approx(0.5e-9))


def test_the_approach_is_taken_as_it_was_at_contact() -> None:
    world = World(detection="discrete", substeps=1, gravity=(0, -8), rest_speed=0)
    world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
    ball = world.add(Ball((0, 1.25), radius=1))
    hits = world.step(0.5)  # falls 1, which is 0.75 too deep; at contact its speed was 2
    assert hits[0].setback == 0.75
    assert hits[0].speed == 4
    assert ball.position == (0, 1)
    assert ball.velocity == (0, pytest.approx(1))


def test_a_ball_deeper_than_it_can_have_fallen_stops() -> None:
    world = World(detection="discrete", substeps=1, gravity=(0, -8), rest_speed=0)
    world.add(Segment((-9, 0), (9, 0)))
    ball = world.add(Ball((0, 0.25), radius=1))
    world.step(0.125)
    assert ball.position == (0, 1)
    assert ball.velocity == (0, 0)


def test_gravity_along_a_wall_corrects_nothing() -> None:
    world = World(detection="discrete", substeps=1, gravity=(0, -8))
    world.add(Segment((0, -9), (0, 9)))
    ball = world.add(Ball((1.1, 0), radius=1, velocity=(-2, 0)))
    world.step(0.125)
    assert ball.velocity == (2, -1)


def test_a_swinging_flipper_adds_its_speed_and_more() -> None:
    world = World(detection="discrete", substeps=1)
    flipper = world.add(
        Segment((0, 0), (10, 0), motion="kinematic", pivot=(0, 0), angular_velocity=0.5, elasticity=0.5)
    )
    ball = world.add(Ball((6, 1), radius=1, velocity=(0, -2)))
    hits = world.step(2**-20)
    assert [hit.shape for hit in hits] == [flipper]
    # Approach 2 + 3 at a distance of 6 from the pivot; the ball leaves at 3 + 0.5·5.
    assert ball.velocity == (pytest.approx(0, abs=1e-5), pytest.approx(5.5, rel=1e-5))
    assert hits[0].speed == pytest.approx(5, rel=1e-5)


def test_a_flipper_moves_as_its_pivot_and_its_turn_say() -> None:
    flipper = Segment((0, 0), (10, 0), motion="kinematic", pivot=(2, 3), angular_velocity=0.5, velocity=(1, -7))
    assert flipper.surface_velocity((6, 1)) == (1 + 0.5 * 2, -7 + 0.5 * 4)


def test_a_platform_throws_a_ball_at_twice_its_speed() -> None:
    _, ball = struck(Ball((0, 1.1), radius=1), Segment((-9, 0), (9, 0), motion="kinematic", velocity=(4, 2)))
    assert ball.velocity == (0, 4)
    assert ball.position == (0, pytest.approx(1.2))


def test_a_surface_that_runs_away_bounces_nothing() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Segment((-9, 0), (9, 0), motion="kinematic", velocity=(0, -3)))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -2)))
    assert len(world.step(0.01)) == 0
    assert ball.velocity == (0, -2)


def test_friction_slows_evenly_and_never_reverses() -> None:
    world = World(detection="discrete", substeps=4, friction=2.0)
    ball = world.add(Ball((0, 0), radius=1, velocity=(3, 4)))
    world.step(1.0)
    assert hypot(*ball.velocity) == pytest.approx(3)
    assert ball.velocity[0] * 4 == pytest.approx(ball.velocity[1] * 3)
    for _ in range(4):
        world.step(0.5)
        assert ball.velocity[0] >= 0
        assert ball.velocity[1] >= 0
    assert ball.velocity == (0, 0)


def test_friction_far_beyond_a_ball_s_speed_stops_it() -> None:
    world = World(detection="discrete", friction=1e9)
    ball = world.add(Ball((0, 0), radius=1, velocity=(-3, 1)))
    world.step(1)
    assert ball.velocity == (0, 0)


def test_a_ball_made_too_fast_by_a_response_is_slowed_and_counted() -> None:
    world, ball = struck(Ball((0, 1), radius=1, velocity=(-3, -4)), Segment((-9, 0), (9, 0), kick=8.0), max_speed=6.5)
    assert ball.velocity == (pytest.approx(-3 * 6.5 / hypot(3, 12)), pytest.approx(12 * 6.5 / hypot(3, 12)))
    assert world.statistics.slowed == 1


def test_a_ball_that_meets_nothing_is_not_slowed() -> None:
    world = World(detection="discrete", max_speed=1.0)
    ball = world.add(Ball((0, 0), radius=1, velocity=(30, 0)))
    world.step(0.1)
    assert ball.velocity == (30, 0)
    assert world.statistics.slowed == 0


def test_both_balls_of_a_pair_are_slowed() -> None:
    world = World(detection="discrete", substeps=1, max_speed=1.0)
    balls = [world.add(Ball((0, 0), radius=1, velocity=(5, 3))), world.add(Ball((2, 0), radius=1, velocity=(-5, 0)))]
    world.step(0.01)
    assert [hypot(*ball.velocity) for ball in balls] == pytest.approx([1, 1])
    assert world.statistics.slowed == 2


def test_a_ball_that_slides_along_a_floor_is_slowed_too() -> None:
    world = World(detection="discrete", gravity=(0, -10), max_speed=3.0)
    world.add(Segment((-99, 0), (99, 0), elasticity=0.5))
    ball = world.add(Ball((0, 1), radius=1, velocity=(5, 0)))
    world.step(0.1)
    assert ball.velocity[0] == pytest.approx(3, rel=1e-3)


def test_speeds_near_the_end_of_numbers_are_limited_and_braked_too() -> None:
    world = World(detection="discrete", substeps=1, max_speed=2.0)
    world.add(Segment((-9, 0), (9, 0)))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -1e200)))
    world.step(0.0)
    assert ball.velocity == (0, pytest.approx(2))
    world = World(detection="discrete", friction=1.0)
    ball = world.add(Ball((0, 0), radius=1, velocity=(3e200, 4e200)))
    world.step(1e-200)
    assert ball.velocity == (3e200, 4e200)


def test_a_ball_inside_an_arena_bounces_off_its_inside() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Circle((0, 0), 5))
    ball = world.add(Ball((3.95, 0), radius=1, velocity=(2, 1)))
    world.step(0.1)
    assert hypot(*ball.position) == pytest.approx(4)
    assert hypot(*ball.velocity) == pytest.approx(hypot(2, 1))


def test_a_ball_over_an_arc_s_centre_is_pushed_from_its_middle() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Arc((0, 0), 0.5, 0, 1))
    ball = world.add(Ball((0, 0), radius=1))
    world.step(0.1)
    assert hypot(*ball.position) == pytest.approx(0.5)


@pytest.mark.compiled
@pytest.mark.parametrize("turn", [0.1, 0.7, 1.9, 2.8])
def test_balls_that_stick_hit_once_however_long_they_travel_together(turn: float) -> None:
    world = World(detection="discrete")
    x, y = cos(turn), sin(turn)
    world.add(Ball((0, 0), radius=1, velocity=(3, 1), elasticity=0, mass=1.3))
    world.add(Ball((2.1 * x, 2.1 * y), radius=1, velocity=(3 - 0.7 * x, 1 - 0.7 * y), mass=0.3))
    assert len(world.run(20)) == 1


@pytest.mark.parametrize("turn", [0.1, 0.7, 1.9, 2.8])
def test_a_ball_that_slides_along_a_wall_without_gravity_hits_it_once(turn: float) -> None:
    world = World(detection="discrete")
    x, y = cos(turn), sin(turn)
    world.add(Segment((-99 * x, -99 * y), (99 * x, 99 * y), elasticity=0))
    world.add(Ball((-1.5 * y, 1.5 * x), radius=1, velocity=(2 * x + y, 2 * y - x)))
    assert len(world.run(20)) == 1


@pytest.mark.parametrize(("m1", "m2", "e"), [(1, 1, 1), (2, 5, 0.7), (1, 1e6, 1), (3, 1, 0)])
def test_a_head_on_meeting_of_balls_follows_the_formulas(m1: float, m2: float, e: float) -> None:
    world = World(detection="discrete", substeps=1)
    first = world.add(Ball((0, 0), radius=1, velocity=(3, 1), mass=m1, elasticity=e))
    second = world.add(Ball((2, 0), radius=1, velocity=(-1, 1), mass=m2))
    hits = world.step(1e-3)
    u1 = (m1 * 3 - m2 - e * m2 * 4) / (m1 + m2)
    u2 = (m1 * 3 - m2 + e * m1 * 4) / (m1 + m2)
    assert first.velocity == (pytest.approx(u1), 1)
    assert second.velocity == (pytest.approx(u2), 1)
    assert hits[0].impulse == pytest.approx(m2 * (u2 + 1))


def test_balls_move_apart_in_inverse_proportion_to_their_masses() -> None:
    world = World(detection="discrete", substeps=1)
    first = world.add(Ball((0, 0), radius=1, mass=3))
    second = world.add(Ball((1, 0), radius=1, mass=1))
    world.step(0.1)
    assert first.position == (-0.25, 0)
    assert second.position == (1.75, 0)
    assert first.velocity == second.velocity == (0, 0)
