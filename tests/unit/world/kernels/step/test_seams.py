"""Points at the seams of walls: a ball beside a wall is not turned by a point on it or behind it."""

import pytest

from carom import Ball, Circle, Point, Segment, Shape
from carom.constants import SEAM_REACH
from carom.world.kernels.step.seams import overlap_beside_walls, yields_to_wall
from tests.kernel_calls import prepared, shape_index
from tests.worlds import world_of

WALL = ((-5.0, 0.0), (5.0, 0.0))


def yields(wall: Shape, ball: Ball, point: tuple[float, float], **options: bool) -> bool:
    """Whether a ball that has not moved meets a wall in place of a point; it meets the point if there is no wall."""
    world = world_of(wall, Point(point, **options), ball)
    room = prepared(world)
    row, place = room.balls.rows[0], (ball.position[0], ball.position[1] + 1e-3)
    tables = room.shapes.rows, shape_index(room), room.relations, True, (*place, *ball.position)
    found = yields_to_wall(room.states[0], row, room.shapes.rows[1], *tables)
    meets = overlap_beside_walls(room.states[0], row, room.shapes.rows[1], *tables)
    assert found or (meets is None) == ((ball.position[0] - point[0]) ** 2 + (ball.position[1] - point[1]) ** 2 >= 1.0)
    assert not found or meets is None
    return bool(found)


@pytest.mark.parametrize(
    ("height", "found"), [(0.0, True), (-0.3, True), (0.9 * SEAM_REACH, True), (1.1 * SEAM_REACH, False), (0.2, False)]
)
def test_a_ball_beside_a_wall_yields_to_it_and_not_to_a_point_that_does_not_stand_out(
    height: float, found: bool
) -> None:
    assert yields(Segment(*WALL), Ball((0.0, 0.6), 1.0), (0.3, height)) == found


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_wall_counts_from_the_side_on_which_the_ball_is(side: float) -> None:
    assert not yields(Segment(*WALL), Ball((0.0, 0.6 * side), 1.0), (0.3, 0.1 * side))
    assert yields(Segment(*WALL), Ball((0.0, 0.6 * side), 1.0), (0.3, -0.1 * side))


def test_a_ball_past_the_end_of_a_wall_is_turned_by_its_point() -> None:
    assert not yields(Segment(*WALL), Ball((5.2, 0.6), 1.0), (5.0, 0.0))


def test_a_point_that_is_not_overlapped_and_sensors_do_not_yield() -> None:
    assert not yields(Segment(*WALL), Ball((0.0, 0.6), 1.0), (3.0, 0.0))
    assert not yields(Segment(*WALL, sensor=True), Ball((0.0, 0.6), 1.0), (0.3, 0.0))
    assert not yields(Segment(*WALL), Ball((0.0, 0.6), 1.0), (0.3, 0.0), sensor=True)


def test_inside_a_hollow_circle_its_points_yield() -> None:
    assert yields(Circle((0.0, 0.0), 3.0), Ball((0.0, -2.5), 1.0), (0.0, -3.0))
    assert not yields(Circle((0.0, 0.0), 3.0), Ball((0.0, -2.5), 1.0), (0.0, -2.8))
