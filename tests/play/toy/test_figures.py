"""The figures on the panel are those of the world's counters."""

import numpy as np
import pytest

import carom
from carom.play.toy.figures import PAUSE, Figures, Twin, tree_of
from carom.play.toy.table import Table
from carom.play.toy.view import View
from carom.play.toy.words import figure_texts, load_text, short

BOX = [((0, 0), (8, 0)), ((8, 0), (8, 8)), ((8, 8), (0, 8)), ((0, 8), (0, 0))]


def room(balls: int, broad_phase: str) -> carom.World:
    """A room of four walls, a compound, and balls that do not touch."""
    world = carom.World(detection="discrete", broad_phase=broad_phase)
    for start, end in BOX:
        world.add(carom.Segment(start, end))
    world.add(carom.Compound([carom.Point((7.5, 7.5))], pivot=(7, 7), angular_velocity=1.0))
    world.add_balls([(1 + place % 3, 1 + place // 3) for place in range(balls)], radius=0.2)
    return world


@pytest.mark.parametrize("balls", [1, 4, 2, 6])
def test_brute_force_tests_every_pair_and_every_shape_once_an_iteration(balls: int) -> None:
    # The compound has two parts: its point, and the center point.
    assert Twin(room(balls, "brute")).box_tests() == balls * (balls - 1) // 2 + balls * (len(BOX) + 2)


def test_a_twin_follows_the_balls_that_come_and_go() -> None:
    world = room(4, "brute")
    twin = Twin(world)
    for balls in (4, 3, 5):
        while len(world.balls) > balls:
            world.remove(world.balls[0])
        while len(world.balls) < balls:
            world.add(carom.Ball((4, 1 + len(world.balls)), radius=0.1))
        assert twin.box_tests() == balls * (balls - 1) // 2 + 6 * balls


@pytest.mark.parametrize("broad_phase", ["brute", "quadtree", "grid"])
def test_an_iteration_on_the_twin_counts_what_one_in_the_world_does_and_leaves_that_alone(broad_phase: str) -> None:
    world = room(6, broad_phase)
    world.substeps = world.iterations = 1
    digest = world.digest()
    counted = Twin(world).box_tests()
    assert world.digest() == digest
    world.step(1 / 60)
    assert world.statistics.box_tests == counted


def test_rates_are_those_of_the_last_second() -> None:
    table = Table()
    figures = Figures(table)
    assert not figures.wait(0.5 * PAUSE)
    before = table.world.statistics.as_dict()
    table.step(1 / 60)
    after = table.world.statistics.as_dict()
    assert figures.wait(0.5 * PAUSE)
    assert figures.rates.box_tests == pytest.approx((after["box_tests"] - before["box_tests"]) / PAUSE)
    assert figures.rates.full_tests == pytest.approx((after["full_tests"] - before["full_tests"]) / PAUSE)
    for _ in range(8):
        figures.wait(PAUSE)
    assert figures.rates.box_tests == 0.0


def test_rates_begin_anew_when_the_table_was_cleared() -> None:
    table = Table()
    figures = Figures(table)
    table.step(1 / 60)
    figures.wait(PAUSE)
    table.clear()
    figures.wait(PAUSE)
    assert (figures.rates.box_tests, figures.rates.box_tests_once) == (0.0, 0)


def test_no_rate_is_below_0_when_a_table_that_was_played_on_is_cleared() -> None:
    table = Table()
    figures = Figures(table)
    for _ in range(8):
        table.step(1 / 60)
        figures.wait(PAUSE)
    assert figures.rates.box_tests > 0.0
    table.clear()
    figures.wait(PAUSE)
    assert figures.rates.box_tests == 0.0


def test_a_twin_turns_what_the_world_has_turned() -> None:
    world = carom.World(detection="discrete", broad_phase="grid", substeps=1, iterations=1)
    arm = world.add(carom.Compound([carom.Point((20, 0))], pivot=(0, 0), rotating=False))
    world.add(carom.Ball((-20, 0.6), radius=0.5))
    twin = Twin(world)
    assert twin.box_tests() == 0
    arm.orientation = 3.141592653589793
    before = twin.box_tests()
    world.step(1 / 60)
    assert before == world.statistics.box_tests > 0


def test_a_quadtree_has_nodes_leaves_and_no_more_shapes_in_one_than_it_says() -> None:
    table = Table()
    table.world.broad_phase = "quadtree"
    tree = tree_of(table.world)
    assert tree.nodes == 4 * (tree.nodes - tree.leaves) + 1 > 1
    assert tree.most >= 1
    assert 0.0 < tree.height < tree.width
    table.world.levels = 1
    whole = tree_of(table.world)
    assert (whole.nodes, whole.leaves) == (1, 1)
    assert whole.most > tree.most


def test_brute_force_has_no_tree() -> None:
    table = Table()
    table.world.broad_phase = "brute"
    assert tree_of(table.world).leaves == 0


@pytest.mark.parametrize(
    ("number", "words"),
    [(0, "0"), (999, "999"), (1000, "1.0k"), (1234, "1.2k"), (9_960, "10k"), (34_200_000, "34M"), (2.5e9, "2.5G")],
)
def test_numbers_are_short(number: float, words: str) -> None:
    assert short(number) == words


def test_figures_are_told_of_both_tables() -> None:
    import pygame

    pygame.display.set_mode((100, 100))
    views = [View(Table(), pygame.Rect(0, 0, 330, 250)) for _ in range(2)]
    views[1].table.clear()
    views[0].measure()
    texts = figure_texts(views, waiting=3)
    assert (texts["in play"], texts["launched"]) == ("5 · 0", "5 +3")
    assert texts["leaves"] == str(views[0].tree.leaves)
    assert set(texts) >= {"box tests once", "box tests", "full tests", "collisions", "strays", "overlaps", "asleep"}


def test_the_load_is_frames_a_second_and_milliseconds() -> None:
    class Meter:
        rate, work = 59.9, 0.00312

    assert load_text(Meter()) == "60 fps, 3.1 ms a frame"  # type: ignore[arg-type]


def test_balls_that_sleep_go_on_sleeping_while_figures_are_read() -> None:
    world = carom.World(detection="discrete", sleep_speed=1.0, sleep_time=0.0)
    world.add_balls(np.array([(1.0, 1.0), (4.0, 4.0)]), radius=0.5)
    world.step(1 / 60)
    assert world.statistics.sleeping == 2
    Twin(world).box_tests()
    world.step(1 / 60)
    assert world.statistics.sleeping == 2
