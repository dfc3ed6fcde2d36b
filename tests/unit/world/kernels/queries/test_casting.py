"""Rays and moving circles: what they touch first, where, and what they do not see."""

from itertools import pairwise
from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Gate, Point, Segment, World
from carom.world import CastHit
from tests.worlds import world_of


@pytest.mark.parametrize(
    ("shape", "point", "normal"),
    [
        (Segment((5, -3), (5, 3)), (5, 0), (-1, 0)),
        (Segment((4, -1), (6, 1)), (5, 0), (-sqrt(0.5), sqrt(0.5))),
        (Gate((5, -3), (5, 3), (-1, 0)), (5, 0), (-1, 0)),
        (Circle((6, 0), 1), (5, 0), (-1, 0)),
        (Circle((0, 0), 5), (5, 0), (-1, 0)),
        (Circle((6, 0), 1, solid=True), (5, 0), (-1, 0)),
        (Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), (5, 0), (-1, 0)),
        (Arc((10, 0), 5, 0.5 * pi, 1.5 * pi), (5, 0), (-1, 0)),
        (Ball((6, 0), 1), (5, 0), (-1, 0)),
    ],
)
def test_a_ray_hits_each_kind_where_it_first_meets_it(shape: Any, point: Any, normal: Any) -> None:
    world = world_of(shape)
    hit = world.ray_cast((0, 0), (8, 0))
    assert hit == CastHit(shape, pytest.approx(5 / 8), pytest.approx(point), pytest.approx(normal))
    assert world.ray_cast((0, 20), (8, 20)) is None
    assert world.ray_cast((0, 0), (4.9, 0)) is None
    assert world.ray_cast((0, 0), (-8, 0)) is None or isinstance(shape, Circle)


def test_lines_are_hit_from_both_sides_and_normals_point_back() -> None:
    for shape in (Segment((5, -3), (5, 3)), Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), Circle((0, 0), 5)):
        world = world_of(shape)
        assert world.ray_cast((1, 0), (9, 0)).normal == (-1, 0)
        assert world.ray_cast((9, 0), (1, 0)).normal == (1, 0)


@pytest.mark.parametrize("shape", [Circle((0, 0), 5, solid=True), Ball((0, 0), 5)])
def test_a_ray_does_not_see_the_disc_that_it_starts_in(shape: Any) -> None:
    wall = Segment((9, -1), (9, 1))
    world = world_of(shape, wall)
    assert world.ray_cast((1, 0), (10, 0)).shape is wall
    assert world.ray_cast((-1, 0), (10, 0)).shape is wall
    assert world.ray_cast((-6, 0), (10, 0)).shape is shape


def test_a_gate_is_seen_from_its_closed_side_alone() -> None:
    world = world_of(Gate((5, -3), (5, 3), (1, 0)))
    assert world.ray_cast((0, 0), (8, 0)) is None
    assert world.ray_cast((8, 0), (0, 0)).normal == (1, 0)
    assert world.circle_cast((0, 0), 1, (8, 0)) is None
    assert world.circle_cast((8, 0), 1, (0, 0)).fraction == 0.25


def test_points_are_touched_by_circles_and_never_hit_by_rays() -> None:
    point = Point((5, 0))
    world = world_of(point)
    assert world.ray_cast((0, 0), (10, 0)) is None
    assert world.circle_cast((0, 0), 1, (10, 0)) == CastHit(point, 0.4, (5, 0), (-1, 0))


def test_the_first_of_several_is_hit_and_of_two_at_one_place_the_one_added_first() -> None:
    far, near, same = Segment((7, -1), (7, 1)), Segment((5, -1), (5, 1)), Segment((5, -1), (5, 1))
    assert world_of(far, near, same).ray_cast((0, 0), (10, 0)).shape is near
    ball, wall = Ball((6, 0), 1), Segment((5, -1), (5, 1))
    assert world_of(ball, wall).ray_cast((0, 0), (10, 0)).shape is ball
    assert world_of(Segment((5, -1), (5, 1)), Ball((6, 0), 1)).ray_cast((0, 0), (10, 0)).shape.kind == "segment"


def test_the_target_itself_is_within_reach() -> None:
    world = world_of(Segment((5, -1), (5, 1)))
    assert world.ray_cast((0, 0), (5, 0)).fraction == 1.0
    assert world.ray_cast((5, 0), (9, 0)).fraction == 0.0


def test_a_ray_of_no_length_hits_nothing() -> None:
    world = world_of(Segment((-1, 0), (1, 0)), Circle((0, 0), 1), Ball((0, 0), 2))
    assert world.ray_cast((0, 0), (0, 0)) is None
    assert world.circle_cast((0, 0), 1, (0, 0)) is None


def test_no_ray_and_no_circle_slips_through_a_joint() -> None:
    world = World()
    corners = [(0.1 * k, 0.3 * sqrt(k)) for k in range(100)]
    for start, end in pairwise(corners):
        world.add(Segment(start, end))
    inner = np.array(corners[1:-1])
    way = np.array([0.7, -1.3])
    assert world.ray_cast(inner - way, inner + way).found.all()
    line = World()
    joints = [(sqrt(k) * 0.6, sqrt(k) * 0.8) for k in range(100)]
    for start, end in pairwise(joints):
        line.add(Segment(start, end))
    inner = np.array(joints[1:-1])
    across = np.array([0.8, -0.6])
    assert line.circle_cast(inner - across, 0.3, inner + across).found.all()
    ring = world_of(*(Arc((1, 2), 3, k, k + 1) for k in range(6)), Arc((1, 2), 3, 6, 0))
    angles = np.arange(7.0)
    out = np.array([1, 2]) + 6 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    assert ring.ray_cast((1, 2), out).found.all()
    assert ring.circle_cast((1, 2), 0.5, out).found.all()


@pytest.mark.parametrize(
    ("shape", "fraction", "point"),
    [
        (Segment((5, -3), (5, 3)), 0.3, (5, 0)),
        (Circle((8, 0), 3), 0.3, (5, 0)),
        (Circle((0, 0), 5), 0.3, (5, 0)),
        (Circle((8, 0), 3, solid=True), 0.3, (5, 0)),
        (Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), 0.3, (5, 0)),
        (Ball((8, 0), 3), 0.3, (5, 0)),
        (Ball((8, 4), 3), 0.5, (6.2, 1.6)),
    ],
)
def test_a_circle_touches_each_kind_its_radius_earlier(shape: Any, fraction: float, point: Any) -> None:
    hit = world_of(shape).circle_cast((0, 0), 2, (10, 0))
    assert (hit.shape, hit.fraction, hit.point) == (shape, pytest.approx(fraction), pytest.approx(point))
    x, y = 10 * hit.fraction - hit.point[0], -hit.point[1]
    assert hit.normal == pytest.approx((x / 2, y / 2))


def test_a_circle_misses_a_bare_end_as_a_ball_does_and_touches_its_guard_point() -> None:
    world = world_of(Segment((5, 1), (5, 3)))
    assert world.circle_cast((0, 0), 2, (10, 0)) is None
    world.add(Point((5, 1)))
    assert world.circle_cast((0, 0), 2, (10, 0)).shape.kind == "point"


def test_a_circle_that_overlaps_at_the_start_touches_if_it_goes_deeper_and_may_leave() -> None:
    for shape in (Segment((1, -3), (1, 3)), Ball((4, 0), 3), Circle((4, 0), 3, solid=True), Point((1, 0))):
        world = world_of(shape)
        assert world.circle_cast((0, 0), 2, (10, 0)).fraction == 0
        assert world.circle_cast((0, 0), 2, (-10, 0)) is None
