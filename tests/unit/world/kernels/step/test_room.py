"""Whether a ball that is pushed has room to go: no push takes its centre across the side of a shape."""

from copy import copy
from math import pi

import pytest

from carom import Arc, Ball, Circle, Gate, Segment, Shape
from carom.constants import SIDE_ROOM
from carom.world.kernels.step.room import ACROSS, BY_BALL, FREE, NEAR, barrier, pressed_depth
from carom.world.tables import Arrays
from tests.kernel_calls import prepared, shape_index
from tests.worlds import world_of


def push(arrays: Arrays, dx: float, dy: float, pusher: int = BY_BALL) -> int:
    """What a push of a world's first ball leads to."""
    tables = arrays.shapes.rows, shape_index(arrays), arrays.relations
    return barrier(arrays.states[0], arrays.balls.rows[0], *tables, pusher, dx, dy)


@pytest.mark.parametrize(
    ("shape", "found"),
    [
        (Segment((2, -3), (2, 3)), ACROSS),
        (Segment((2, 0.5), (2, 3)), FREE),
        (Gate((2, -3), (2, 3), direction=(-1, 0)), ACROSS),
        (Gate((2, -3), (2, 3), direction=(1, 0)), FREE),
        (Arc((0, 0), 2, 1.5 * pi, 0.5 * pi), ACROSS),
        (Circle((0, 0), 2), ACROSS),
        (Circle((4, 0), 2, solid=True), ACROSS),
        (Circle((0, 0), 9, solid=True), FREE),
        (Segment((2, -3), (2, 3), sensor=True), FREE),
        (Segment((2, -3), (2, 3), layer=2), FREE),
    ],
)
@pytest.mark.parametrize("radius", [1.0, 4.0])
def test_a_push_is_seen_to_cross_the_side_of_what_would_stop_the_ball(shape: Shape, found: int, radius: float) -> None:
    # A push longer than the ball's radius is looked for among all shapes, a shorter one in the index.
    arrays = prepared(world_of(copy(shape), Ball((1, 0), radius, collides_with=1)))
    assert push(arrays, 2.5, 0.0) == found
    assert push(arrays, -0.1, 0.0) in (FREE, NEAR)


@pytest.mark.parametrize("away", [0.9, 1.1])
def test_a_push_is_too_near_where_it_leaves_less_than_half_a_radius(away: float) -> None:
    radius = 2.0
    arrays = prepared(world_of(Segment((-5, 0), (5, 0)), Ball((0, 3), radius)))
    end = away * SIDE_ROOM * radius
    assert push(arrays, 0.0, end - 3.0) == (NEAR if away < 1.0 else FREE)
    # Going away from it, it may be as near as it is.
    arrays.balls.rows["y"][0] = 0.5 * end
    assert push(arrays, 0.0, 0.1 * end) == FREE


def test_who_pushes_is_no_barrier_and_what_moves_none_to_what_stands_still() -> None:
    mover = Segment((2, -3), (2, 3), motion="kinematic", velocity=(1, 0))
    arrays = prepared(world_of(mover, Segment((9, 9), (10, 9)), Ball((1, 0), 1)))
    assert push(arrays, 2.0, 0.0) == ACROSS
    assert push(arrays, 2.0, 0.0, pusher=0) == FREE
    assert push(arrays, 2.0, 0.0, pusher=1) == FREE


@pytest.mark.parametrize("height", [2.5, 1.9, 1.5])
def test_a_ball_between_two_walls_is_pressed_onto_one_as_deep_as_the_other_pushes_it(height: float) -> None:
    floor, roof = Segment((-5, 0), (5, 0)), Segment((-5, height), (5, height))
    arrays = prepared(world_of(floor, roof, Ball((0, 0.8), 1)))
    tables = arrays.shapes.rows, shape_index(arrays), arrays.relations
    depth = pressed_depth(arrays.balls.rows[0], *tables, 0, 0.0, 1.0, 0.2)
    assert depth == pytest.approx(max(2.0 - height, 0.0))
