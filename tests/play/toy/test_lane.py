"""Launches: one after the other, so that no ball overlaps another."""

from math import dist

import pytest

import carom
from carom.play.toy.lane import Lane
from carom.play.toy.table import USUAL_RADIUS, Table


def empty() -> Table:
    """A table without balls."""
    table = Table()
    table.clear()
    return table


def test_a_ball_is_launched_upwards_clear_of_all_walls() -> None:
    table = empty()
    lane = Lane(table)
    lane.waiting = 1
    assert lane.feed([table], lane.widest, 20.0) == 1
    (ball,) = table.world.balls
    assert ball.velocity == (0.0, 20.0)
    assert list(table.world.contacts()) == []


def test_a_ball_is_as_heavy_as_its_area_says() -> None:
    table = empty()
    assert table.launch((20.0, 20.0), USUAL_RADIUS, 1.0).mass == 1.0
    assert table.launch((10.0, 20.0), 0.5 * USUAL_RADIUS, 1.0).mass == 0.25


def test_nothing_is_launched_unless_a_ball_waits() -> None:
    table = empty()
    assert Lane(table).feed([table], 0.5, 20.0) == 0


def test_a_ball_waits_while_another_is_at_the_foot_of_the_lane() -> None:
    table = empty()
    lane = Lane(table)
    lane.waiting = 2
    assert [lane.feed([table], 0.5, 20.0) for _ in range(3)] == [1, 0, 0]
    assert (lane.waiting, table.launched) == (1, 1)


def test_a_ball_waits_for_a_place_in_every_table() -> None:
    tables = [empty(), empty()]
    lane = Lane(tables[0])
    lane.waiting = 1
    foot = lane.foot(0.5)
    tables[1].world.add(carom.Ball((0.5 * (foot.left + foot.right), foot.bottom + 0.5), radius=0.5, velocity=(0, 19)))
    assert lane.feed(tables, 0.5, 20.0) == 0
    assert tables[0].in_play == 0


def test_a_ball_that_came_back_is_shot_up_again() -> None:
    table = empty()
    lane = Lane(table)
    lane.waiting = 2
    lane.feed([table], 0.5, 20.0)
    (ball,) = table.world.balls
    ball.velocity = (0.0, -1.0)
    assert lane.feed([table], 0.5, 20.0) == 0
    assert ball.velocity == (0.0, 20.0)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("radius", [0.1, 0.6])
def test_launching_n_puts_n_balls_on_the_table_of_which_none_overlaps_another(radius: float) -> None:
    table = empty()
    table.world.detection = "continuous"
    lane = Lane(table)
    lane.waiting = 40
    for _ in range(60 * 20):
        if lane.feed([table], radius, 30.0):
            places = [(ball.position, ball.radius) for ball in table.world.balls]
            newest = places[-1]
            assert all(dist(newest[0], place) > newest[1] + size for place, size in places[:-1])
        table.step(1 / 60)
    assert (table.launched, table.in_play, lane.waiting) == (40, 40, 0)
