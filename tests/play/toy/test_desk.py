"""The toy without its window: switches, launches, and two tables that are given the same."""

import pytest

from carom.play.toy.desk import STEP, Desk
from carom.play.toy.items import OPTIONS, ROWS, Choice, Slider
from carom.play.toy.settings import SHOWN, Settings


def test_a_world_begins_as_the_panel_says() -> None:
    desk, settings = Desk(), Settings()
    world = desk.tables[0].world
    assert (world.substeps, world.iterations, world.levels) == (settings.motion, settings.collision, settings.levels)
    assert (world.gravity, world.max_speed, world.broad_phase) == ((0.0, -5.0), 40.0, "grid")
    assert world.remove_strays


def test_the_rows_of_the_panel_set_what_there_is() -> None:
    names = {row.name for row in ROWS if isinstance(row, Slider | Choice)}
    assert names <= {*Settings.__dataclass_fields__}


@pytest.mark.parametrize("name", OPTIONS)
def test_a_press_goes_through_all_options_and_comes_back(name: str) -> None:
    desk = Desk()
    first, seen = desk.value(name), []
    for _ in OPTIONS[name]:
        desk.press(name)
        seen.append(desk.value(name))
    assert seen[-1] == first
    assert set(seen) == set(OPTIONS[name])


@pytest.mark.parametrize("name", [*SHOWN, "paused", "muted", "rotating"])
def test_a_press_switches_and_switches_back(name: str) -> None:
    desk = Desk()
    before = desk.is_on(name)
    desk.press(name)
    assert desk.is_on(name) != before
    desk.press(name)
    assert desk.is_on(name) == before


def test_an_action_is_never_on() -> None:
    assert not Desk().is_on("launch")


def test_a_second_table_is_the_same_as_the_first() -> None:
    desk = Desk()
    desk.advance(2)
    desk.change("detection", "both")
    first, second = (table.world for table in desk.tables)
    assert first.time == second.time
    assert (first.balls.position == second.balls.position).all()
    assert first.balls.id.tolist() == second.balls.id.tolist()
    assert second.detection == "continuous"


def test_what_is_set_holds_for_both_tables() -> None:
    desk = Desk()
    desk.change("detection", "both")
    desk.change("gravity", 9.0)
    assert [table.world.gravity for table in desk.tables] == [(0.0, -9.0)] * 2


def test_both_tables_are_given_the_same_launches() -> None:
    desk = Desk()
    desk.do("clear")
    desk.change("detection", "both")
    desk.do("launch")
    desk.advance(1)
    first, second = (list(table.world.balls) for table in desk.tables)
    assert len(first) == len(second) == 1
    assert (first[0].id, first[0].radius) == (second[0].id, second[0].radius)
    assert [table.launched for table in desk.tables] == [1, 1]


def test_clear_leaves_two_tables_that_are_the_same_but_for_the_detection() -> None:
    desk = Desk()
    desk.change("detection", "both")
    desk.advance(1)
    desk.do("clear")
    assert [len(table.world.balls) for table in desk.tables] == [0, 0]
    assert [table.world.detection for table in desk.tables] == ["discrete", "continuous"]
    assert [table.launched for table in desk.tables] == [0, 0]


def test_no_frame_goes_by_in_a_pause_but_for_single_steps() -> None:
    desk = Desk()
    desk.change("paused", True)
    assert desk.advance(3) == []
    desk.do("step")
    assert len(desk.advance(3)) == 1
    assert desk.tables[0].world.time == STEP


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_no_ball_of_a_hundred_is_lost(detection: str) -> None:
    desk = Desk()
    desk.change("detection", detection)
    desk.change("rotating", True)
    desk.change("count", 100)
    desk.do("launch many")
    for _ in range(60 * 30):
        desk.advance(1)
    (table,) = desk.tables
    assert (table.launched, table.in_play, table.strays) == (105, 105, 0)


@pytest.mark.compiled
def test_one_click_shows_tunnelling_within_seconds() -> None:
    desk = Desk()
    desk.do("launch many")
    desk.change("paused", True)
    desk.do("tunnelling")
    for _ in range(60 * 3):
        desk.advance(1)
    discrete, continuous = desk.tables
    assert (discrete.world.detection, continuous.world.detection) == ("discrete", "continuous")
    assert (discrete.world.substeps, desk.settings.speed) == (1, 150)
    assert (discrete.launched, discrete.strays) == (30, 30)
    assert (continuous.launched, continuous.strays, continuous.in_play) == (30, 0, 30)


@pytest.mark.compiled
def test_side_by_side_the_discrete_table_loses_balls_and_the_continuous_one_none() -> None:
    desk = Desk()
    desk.change("detection", "both")
    desk.change("motion", 1)
    desk.change("speed", 150)
    desk.change("count", 30)
    desk.do("launch many")
    for _ in range(60 * 8):
        desk.advance(1)
    discrete, continuous = desk.tables
    assert discrete.launched == continuous.launched == 35
    assert discrete.strays > 10
    assert (continuous.strays, continuous.in_play) == (0, 35)
