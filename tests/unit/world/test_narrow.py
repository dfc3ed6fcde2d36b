"""Meetings in a world: the order of 2.2, masks and switches, and what a hit says."""

from math import hypot

import numpy as np
import pytest

from carom import Arc, Ball, Circle, HitKind, Point, Segment, World
from carom.rows.masks import may_collide
from carom.world.kernels.step.narrow import boxes_apart


def test_points_come_before_segments_circles_and_arcs_and_static_before_kinematic() -> None:
    world = World(substeps=1, iterations=1)
    arc = world.add(Arc((0, 2), 2.4, 4, 5.5, motion="kinematic"))
    moving_circle = world.add(Circle((0, -1), 0.7, motion="kinematic"))
    moving_wall = world.add(Segment((-9, -0.4), (9, -0.4), motion="kinematic"))
    moving_post = world.add(Point((0, -0.5), motion="kinematic"))
    static_arc = world.add(Arc((0, 2), 2.2, 4, 5.5))
    circle = world.add(Circle((0, -1), 0.8))
    wall = world.add(Segment((-9, -0.2), (9, -0.2)))
    post = world.add(Point((0, -0.3)))
    for shape in world.shapes:
        shape.elasticity = 0.0
    expected = [post, wall, circle, static_arc, moving_post, moving_wall, moving_circle, arc]
    rows = world._room.shapes.used
    world._room.prepare()
    assert [int(rows[k]["id"]) for k in world._room.order] == [shape.id for shape in expected]


def test_a_post_at_a_joint_is_met_before_the_walls() -> None:
    for add_first in (True, False):
        world = World(substeps=1)
        post = Point((0, 0))
        if add_first:
            world.add(post)
        world.add(Segment((-9, -0.5), (0, 0)))
        world.add(Segment((0, 0), (9, -0.5)))
        if not add_first:
            world.add(post)
        world.add(Ball((0, 1.05), radius=1, velocity=(0, -1)))
        hits = world.step(0.1)
        assert [hit.shape for hit in hits] == [post]


def test_pairs_come_after_shapes() -> None:
    world = World(substeps=1)
    world.add(Ball((0, 1), radius=1, velocity=(0, -1)))
    world.add(Ball((2, 1), radius=1, velocity=(-1, 0)))
    world.add(Segment((-9, 0), (9, 0)))
    kinds = [hit.shape.kind for hit in world.step(0.1)]
    assert kinds[0] == "segment"
    assert "ball" in kinds[1:]


def test_a_ball_pushed_onto_a_shape_meets_it_in_the_next_iteration_and_once_more_after_the_last() -> None:
    for iterations, met in ((1, ["ball", "segment"]), (2, ["ball", "segment", "ball", "segment"])):
        world = World(substeps=1, iterations=iterations)
        world.add(Segment((-9, 0), (9, 0)))
        world.add(Ball((0, 1), radius=1))
        world.add(Ball((0, 3), radius=1, velocity=(0, -1), mass=1e12))
        assert [hit.shape.kind for hit in world.step(0.1)] == met


def test_a_row_of_touching_balls_passes_a_push_on_by_one_ball_an_iteration_at_least() -> None:
    world = World(substeps=1, iterations=6)
    balls = [world.add(Ball((2 * k, 0), radius=1)) for k in range(5)]
    balls[0].velocity = (1, 0)
    world.step(0.1)
    assert [ball.velocity[0] for ball in balls] == [0, 0, 0, 0, 1]


def test_an_iteration_that_finds_nothing_ends_them() -> None:
    world = World(substeps=1, iterations=1000, broad_phase="brute")
    world.add(Ball((0, 0), radius=1))
    world.add(Ball((5, 0), radius=1))
    world.step(0.1)
    assert world.statistics.box_tests == 1


def test_boxes_are_compared_before_shapes() -> None:
    world = World(substeps=1, broad_phase="brute")
    world.add(Point((5, 5)))
    world.add(Ball((0, 0), radius=1))
    world.step(0.1)
    assert (world.statistics.box_tests, world.statistics.full_tests) == (1, 0)
    world.add(Point((0.9, 0.9)))
    world.step(0.1)
    assert world.statistics.full_tests == 1
    assert world.statistics.collisions == 0


def test_boxes_that_touch_are_not_apart() -> None:
    ball = Ball((0, 0), radius=1)._row
    assert not boxes_apart(ball, Point((1, 1))._row)
    assert boxes_apart(ball, Point((np.nextafter(1, 2), 0))._row)
    assert boxes_apart(ball, Point((0, np.nextafter(-1, -2)))._row)


@pytest.mark.parametrize("kind", ["shape", "ball"])
@pytest.mark.parametrize(
    ("first", "second", "meets"),
    [
        ((1, 1), (1, 1), True),
        ((1, 2), (2, 1), True),
        ((1, 2), (2, 2), False),
        ((2, 3), (1, 3), True),
        ((1, 0), (1, 1), False),
        ((2**31, 2**31), (2**31, 2**31), True),
        ((4, 8), (8, 3), False),
    ],
)
def test_two_meet_iff_each_is_on_a_layer_that_the_other_meets(
    kind: str, first: tuple[int, int], second: tuple[int, int], meets: bool
) -> None:
    world = World(substeps=1)
    options = {"layer": first[0], "collides_with": first[1]}
    world.add(Ball((0, 0), radius=1, **options) if kind == "ball" else Point((0, 0), **options))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -1), layer=second[0], collides_with=second[1]))
    assert (len(world.step(0.1)) == 1) is meets
    assert (ball.velocity == (0, -1)) is not meets
    rows = world._room.balls.rows if kind == "ball" else world._room.shapes.rows
    assert may_collide(rows[0], ball._row) is meets


def test_what_cannot_collide_meets_nothing() -> None:
    world = World(substeps=1)
    post = world.add(Point((0, 0), can_collide=False))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -1)))
    ghost = world.add(Ball((0.5, 0.9), radius=1, can_collide=False))
    assert len(world.step(0.1)) == 0
    assert ghost.position == (0.5, 0.9)
    post.can_collide = True
    assert [hit.shape for hit in world.step(0.1)] == [post]
    ghost.can_collide = True
    world.step(0.1)
    assert ghost.position != (0.5, 0.9)
    assert ball.position != (0, 1)


def test_a_hit_on_a_shape_says_when_where_and_how() -> None:
    world = World(substeps=4)
    world.step(1.0)
    wall = world.add(Segment((-9, 0), (9, 0), elasticity=0.5))
    ball = world.add(Ball((1, 1.375), radius=1, velocity=(3, -4), mass=2))
    (hit,) = world.step(1.0)
    assert hit.kind is HitKind.BOUNCE
    assert hit.time == 1.25
    assert hit.shape is wall
    assert hit.ball is ball
    assert hit.point == (1.75, 0)
    assert hit.normal == (0, 1)
    assert hit.setback == 0.625
    assert hit.speed == 5
    assert hit.impulse == 2 * (4 + 2)


def test_a_hit_of_the_last_substep_has_the_time_that_the_step_ends_at() -> None:
    world = World(substeps=3)
    world.run(0.5, dt=0.1)
    world.add(Segment((-9, 0), (9, 0)))
    world.add(Ball((0, 1.95), radius=1, velocity=(0, -10)))
    (hit,) = world.step(0.1)
    assert hit.time == world.time


def test_a_normal_points_from_the_shape_to_the_ball_on_either_side() -> None:
    for y in (1, -1):
        world = World(substeps=1)
        world.add(Segment((-9, 0), (9, 0)))
        world.add(Ball((0, y), radius=1, velocity=(0, -y)))
        (hit,) = world.step(0.1)
        assert hit.normal == (0, y)


def test_a_hit_of_two_balls_is_one_whose_shape_is_the_ball_added_first() -> None:
    world = World(substeps=1)
    first = world.add(Ball((2, 0), radius=1, mass=2))
    second = world.add(Ball((0, 0), radius=1, velocity=(3, 4), mass=1))
    (hit,) = world.step(1 / 64)
    assert hit.shape is first
    assert hit.ball is second
    assert hit.normal[0] == pytest.approx(-1, abs=1e-2)
    assert hit.speed == 5
    # On the perimeter of the first ball, as it was before they moved apart.
    assert hypot(hit.point[0] - 2, hit.point[1]) == pytest.approx(1)
    nx, ny = hit.normal
    given = second.velocity[0] - 3, second.velocity[1] - 4
    assert given == (pytest.approx(hit.impulse * nx), pytest.approx(hit.impulse * ny))
    assert hit.impulse > 0


@pytest.mark.parametrize("masses", [(1e-9, 1e9), (1e9, 1e-9)])
def test_the_impulse_of_a_pair_is_right_however_unequal_the_masses(masses: tuple[float, float]) -> None:
    world = World(substeps=1)
    for x, mass in zip((0.0, 1.9), masses, strict=True):
        world.add(Ball((x, 0), radius=1, velocity=(0.3 - x, 0.1), mass=mass))
    (hit,) = world.step(0.0)
    assert hit.impulse == pytest.approx(2 * 1e-9 * 1.9, rel=1e-12)


def test_hits_come_in_the_order_of_time() -> None:
    world = World(gravity=(0, -10))
    world.add(Circle((0, 0), 10))
    for k in range(20):
        world.add(Ball((0.3 * k - 3, 0.2 * k), radius=0.5, velocity=(k, -k)))
    hits = world.run(2)
    assert len(hits) > 100
    assert (np.diff(hits["time"]) >= 0).all()
    assert set(hits["kind"].tolist()) == {HitKind.BOUNCE}


def test_the_impulse_is_the_momentum_given_along_the_normal() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        world = World(substeps=1, iterations=1, restitution="total" if rng.random() < 0.5 else "normal")
        options = {"elasticity": rng.uniform(0, 1.3), "kick": rng.uniform(0, 2)}
        world.add(Circle((0, 0), 1, solid=True, motion="kinematic", velocity=tuple(rng.normal(size=2)), **options))
        ball = world.add(Ball(tuple(rng.normal(size=2)), radius=1.5, velocity=tuple(rng.normal(size=2)), mass=3))
        before = ball.velocity
        for hit in world.step(0.01):
            change = [ball.velocity[k] - before[k] for k in range(2)]
            assert hit.impulse == pytest.approx(3 * (change[0] * hit.normal[0] + change[1] * hit.normal[1]), rel=1e-9)


def test_two_balls_at_one_place_part_against_their_relative_velocity_and_are_counted() -> None:
    world = World(substeps=1)
    first = world.add(Ball((0, 0), radius=1))
    second = world.add(Ball((-0.5, 0), radius=1, velocity=(1, 0)))
    hits = world.step(0.5)
    assert world.statistics.overlaps == 1
    assert (first.position, second.position) == ((1, 0), (-1, 0))
    assert (first.velocity, second.velocity) == ((1, 0), (0, 0))
    assert len(hits) == 1


def test_balls_at_rest_at_one_place_part_upwards() -> None:
    world = World(substeps=1)
    balls = [world.add(Ball((3, 3), radius=1)) for _ in range(2)]
    assert len(world.step(0.1)) == 0
    assert [ball.position for ball in balls] == [(3, 2), (3, 4)]
    assert world.statistics.overlaps == 1


def test_a_ball_at_rest_on_a_post_is_moved_up() -> None:
    world = World(substeps=1)
    world.add(Point((3, 3)))
    ball = world.add(Ball((3, 3), radius=1))
    world.step(0.1)
    assert ball.position == (3, 4)
    assert ball.velocity == (0, 0)
