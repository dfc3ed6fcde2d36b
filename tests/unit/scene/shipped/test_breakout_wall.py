"""Breakout's wall can be taken down brick by brick, and its paddle and room are smooth."""

from itertools import combinations
from math import hypot, pi
from typing import Any

import numpy as np
import pytest

import carom
from carom.scene.shape_descriptors import CircleDescriptor
from carom.scene.shipped.breakout_wall import BALL_RADIUS, HEIGHT, WIDTH, breakout


def bricks(**sizes: int) -> list[CircleDescriptor]:
    """The bricks of the scene."""
    return [shape for shape in breakout(**sizes).shapes if isinstance(shape, CircleDescriptor)]


def test_bricks_are_gone_after_one_bounce_and_have_names_of_their_own() -> None:
    names = [brick.name for brick in bricks()]
    assert len(set(names)) == len(names) == 63
    assert all(brick.once and brick.solid and not brick.sensor for brick in bricks())


def test_no_two_bricks_touch_and_no_ball_fits_between_neighbours_of_a_row() -> None:
    places = np.array([brick.center for brick in bricks()])
    apart = [hypot(*(a - b)) for a, b in combinations(places, 2)]
    radius = bricks()[0].radius
    assert 2.0 * radius < min(apart) < 2.0 * (radius + BALL_RADIUS)
    assert places[:, 0].min() - radius > 0.0
    assert places[:, 0].max() + radius < WIDTH
    assert places[:, 1].max() + radius + 2.0 * BALL_RADIUS < HEIGHT, "a ball has room above them"


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (3, 4), (7, 11), (14, 24)])
def test_rows_and_columns_may_be_others_and_bricks_keep_apart(rows: int, columns: int) -> None:
    made = bricks(rows=rows, columns=columns)
    assert len(made) == rows * columns - rows // 2
    places, radius = np.array([brick.center for brick in made]), made[0].radius
    assert min((hypot(*(a - b)) for a, b in combinations(places, 2))) > 2.0 * radius
    assert places[:, 0].min() - radius > 0.0
    assert places[:, 0].max() + radius < WIDTH
    assert places[:, 1].max() + radius + 2.0 * BALL_RADIUS < HEIGHT


def test_a_ball_may_be_as_fast_as_is_asked() -> None:
    world = breakout(speed=9.0).build()
    assert hypot(*world.balls[0].velocity) == pytest.approx(9.0)
    assert world.max_speed == 18.0


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"rows": 8}, r"rows must be from 1 to 7 \(of bricks this large, 11 in one\), not 8"),
        ({"columns": 1}, "columns must be from 2 to 24, not 1"),
        ({"speed": 0.0}, "speed must be positive, not 0.0"),
        ({"column": 4}, "did you mean columns"),
    ],
)
def test_walls_that_cannot_be_are_refused(given: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        breakout(**given)


def test_room_and_paddle_need_no_guard_points() -> None:
    world = breakout().build()
    (paddle,) = [shape for shape in world.shapes if isinstance(shape, carom.Compound)]
    assert carom.guard_points(paddle.shapes) == []
    assert carom.guard_points([shape for shape in world.shapes if shape.name == "wall"]) == []


def test_where_a_ball_meets_the_paddle_says_where_it_goes() -> None:
    ways = []
    for x in (10.5, 12.0, 13.5):
        world = breakout().build()
        world.balls[0].position, world.balls[0].velocity = (x, 6.0), (0.0, -18.0)
        world.run(0.2)
        ways.append(np.arctan2(*world.balls[0].velocity[::-1]))
    assert ways[0] > pi / 2.0 + 0.3
    assert ways[1] == pytest.approx(pi / 2.0)
    assert ways[2] < pi / 2.0 - 0.3


def test_a_brick_that_was_hit_lets_the_ball_through() -> None:
    world = breakout().build()
    ball = world.balls[0]
    (brick,) = [shape for shape in world.shapes if shape.name == "brick 1.6"]
    for _ in range(2):
        ball.position, ball.velocity = (brick.position[0], 15.0), (0.0, 18.0)
        hits = world.run(0.3)
    assert not brick.can_collide
    assert {hit.shape.name for hit in hits} & {"brick 2.5", "brick 2.6"}


def test_no_ball_comes_up_unnoticed_once_it_is_down() -> None:
    world = breakout().build()
    for x in np.linspace(0.5, WIDTH - 0.5, 24):
        ball = world.balls[0]
        ball.position, ball.velocity = (float(x), 2.6), (0.0, -18.0)
        hits = world.run(0.1)
        assert "drain" in {hit.shape.name for hit in hits}, x
