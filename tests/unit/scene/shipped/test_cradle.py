"""The cradle's balls touch, and have as far to go on either side."""

from itertools import pairwise

import pytest

from carom import scenes
from carom.scene.shipped.cradle import RADIUS, RUN_UP, SPEED, newtons_cradle


def test_the_cradles_balls_touch() -> None:
    places = [ball.position[0] for ball in scenes.newtons_cradle(balls=7).balls[1:]]
    assert [later - earlier for earlier, later in pairwise(places)] == [1.0] * 5


@pytest.mark.parametrize("count", [2, 3, 7, 1000])
def test_the_first_ball_and_the_last_have_the_same_way_to_go(count: int) -> None:
    scene = newtons_cradle(balls=count)
    first, *row = scene.balls
    xs = [end[0] for wall in scene.shapes for end in (wall.start, wall.end)]
    assert first.velocity == (SPEED, 0.0)
    assert all(ball.velocity == (0.0, 0.0) for ball in row)
    before_row, by_left_wall = row[0].position[0] - 2.0 * RADIUS, min(xs) + RADIUS
    assert by_left_wall < first.position[0] < before_row
    assert before_row - by_left_wall == pytest.approx(RUN_UP)
    assert max(xs) - RADIUS - row[-1].position[0] == pytest.approx(RUN_UP)
