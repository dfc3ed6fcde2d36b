"""Plots of a run: each in one call, each says what the recording holds."""

import sys
from collections.abc import Iterator

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

import carom
from carom.study import plots
from carom.world.touches import touches_of
from tests.fresh import printed

mpl.use("Agg")


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    """No figure stays open."""
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def falling() -> carom.Recording:
    """A ball that bounces on a floor, in a room with one shape of each kind."""
    world = carom.World(gravity=(0, -10))
    world.add(carom.Segment((-2, 0), (2, 0), name="floor"))
    world.add(carom.Arc((0, 3), 3.0, 0.0, 3.0, name="dome"))
    world.add(carom.Circle((5, 5), 0.5, solid=True))
    world.add(carom.Point((-2, 0)))
    world.add(carom.Ball((0, 2), radius=0.5))
    return carom.Recording.of(world, seconds=2)


@pytest.fixture(scope="module")
def gas() -> carom.Recording:
    """Ten balls in a box, without gravity."""
    return carom.Recording.of(carom.scenes.gas(balls=10).build(), seconds=1)


def empty() -> carom.Recording:
    """A run without anything in it."""
    return carom.Recording.of(carom.World(), seconds=0.1)


@pytest.mark.parametrize("plot", [plots.energy, plots.hits_by_shape, plots.heat_map, plots.speeds])
def test_one_call_makes_a_figure_or_draws_into_given_axes(plot: object, gas: carom.Recording) -> None:
    assert callable(plot)
    axes = plot(gas)
    assert len(axes.figure.axes) >= 1
    assert axes.get_title()
    _, mine = plt.subplots()
    assert plot(gas, mine) is mine
    assert mine.get_title()


@pytest.mark.parametrize("plot", [plots.energy, plots.hits_by_shape, plots.heat_map, plots.speeds])
def test_a_run_without_anything_has_plots_too(plot: object) -> None:
    assert callable(plot)
    assert plot(empty()).get_title()


def test_energy_without_gravity_is_one_line(gas: carom.Recording) -> None:
    axes = plots.energy(gas)
    (line,) = axes.get_lines()
    assert np.array_equal(line.get_ydata(), gas.kinetic_energy())
    assert np.array_equal(line.get_xdata(), gas.times)
    low, high = axes.get_ylim()
    assert low == 0.0 < np.max(gas.kinetic_energy()) < high


def test_energy_under_gravity_is_two_lines_with_a_legend(falling: carom.Recording) -> None:
    axes = plots.energy(falling)
    total, kinetic = axes.get_lines()
    assert np.array_equal(total.get_ydata(), falling.energy())
    assert np.array_equal(kinetic.get_ydata(), falling.kinetic_energy())
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["kinetic and potential", "kinetic"]


def test_a_negative_energy_is_in_sight() -> None:
    world = carom.World(gravity=(0, -10))
    world.add(carom.Ball((0, -5), radius=0.5))
    run = carom.Recording.of(world, seconds=0.1)
    low, _ = plots.energy(run).get_ylim()
    assert low < run.energy().min() < 0.0


def test_hits_are_counted_by_name_the_most_first(falling: carom.Recording) -> None:
    axes = plots.hits_by_shape(falling)
    assert [text.get_text() for text in axes.get_yticklabels()] == ["floor"]
    assert [bar.get_width() for bar in axes.patches] == [len(touches_of(falling.hits))]
    assert axes.get_xlabel() == "touches"
    axes = plots.hits_by_shape(falling, count="hits")
    assert [bar.get_width() for bar in axes.patches] == [len(falling.hits)]
    assert axes.get_xlabel() == "hits"
    assert len(falling.hits) > 0


def test_balls_count_together_and_sensors_do_not(gas: carom.Recording) -> None:
    world = carom.World()
    world.add(carom.Segment((2, -1), (2, 1), sensor=True))
    for x in (0.0, 4.0):
        world.add(carom.Ball((x, 0), radius=0.5, velocity=(4 - 2 * x, 0)))
    axes = plots.hits_by_shape(carom.Recording.of(world, seconds=2))
    assert [text.get_text() for text in axes.get_yticklabels()] == ["ball against ball"]
    assert [bar.get_width() for bar in axes.patches] == [1]


def test_what_was_hit_less_often_shares_the_last_row() -> None:
    world = carom.World(detection="continuous", substeps=1)
    for number in range(4):
        for x in (-1.0, 1.0 + number):  # lanes that get longer: fewer hits
            world.add(carom.Segment((x, 10 * number - 2), (x, 10 * number + 2), name=f"lane {number}"))
        world.add(carom.Ball((0, 10 * number), radius=0.2, velocity=(9, 0)))
    run = carom.Recording.of(world, seconds=4)
    axes = plots.hits_by_shape(run, rows=3)
    assert [text.get_text() for text in axes.get_yticklabels()] == ["lane 0", "lane 1", "2 others"]
    assert sum(bar.get_width() for bar in axes.patches) == len(run.hits)


def test_the_map_has_each_frame_of_each_ball_once(falling: carom.Recording) -> None:
    axes = plots.heat_map(falling, cells=30)
    (image,) = axes.images
    share = np.asarray(image.get_array())
    assert share.sum() == pytest.approx(1.0)
    assert max(share.shape) == 30
    left, right, bottom, top = image.get_extent()
    column = int((0.0 - left) / (right - left) * share.shape[1])
    assert share[:, column].sum() == pytest.approx(1.0)  # the ball only falls and rises
    assert bottom < 0.0 < 5.5 < top


def test_the_map_outlines_lines_and_round_shapes(falling: carom.Recording) -> None:
    axes = plots.heat_map(falling)
    assert [type(patch).__name__ for patch in axes.patches] == ["Arc", "Circle"]
    (floor,) = axes.get_lines()
    assert floor.get_xydata().tolist() == [[-2.0, 0.0], [2.0, 0.0]]


def test_the_map_of_balls_alone_is_as_wide_as_their_ways() -> None:
    world = carom.World()
    world.add(carom.Ball((0, 0), radius=0.5, velocity=(10, 0)))
    (image,) = plots.heat_map(carom.Recording.of(world, seconds=1)).images
    left, right, _, _ = image.get_extent()
    assert (left, right) == pytest.approx((-0.2, 10.2))


def test_speeds_are_a_density_beside_maxwells(gas: carom.Recording) -> None:
    axes = plots.speeds(gas, bins=20)
    area = sum(bar.get_height() * bar.get_width() for bar in axes.patches)
    assert area == pytest.approx(1.0)
    assert len(axes.patches) == 20
    assert len(axes.get_lines()) == 1


def test_equal_speeds_are_one_bar() -> None:
    world = carom.World()
    world.add(carom.Ball((0, 0), radius=0.5, velocity=(3, 4)))
    axes = plots.speeds(carom.Recording.of(world, seconds=0.1), bins=10)
    assert sum(bar.get_height() > 0.0 for bar in axes.patches) == 1
    assert axes.patches[0].get_x() == 0.0


def test_balls_at_rest_have_no_temperature() -> None:
    world = carom.World()
    world.add(carom.Ball((0, 0), radius=0.5))
    assert len(plots.speeds(carom.Recording.of(world, seconds=0.1)).get_lines()) == 0


def test_speeds_before_since_are_left_out() -> None:
    world = carom.World(detection="continuous", substeps=1)
    world.add(carom.Segment((1, -1), (1, 1), elasticity=0.5))
    world.add(carom.Ball((0, 0), radius=0.5, velocity=(1, 0)))
    run = carom.Recording.of(world, seconds=2)
    assert plots.speeds(run).get_xlim()[1] > 1.0
    assert plots.speeds(run, since=1.0).get_xlim()[1] < 0.6


def test_maxwells_law_has_the_mean_energy_that_it_was_given() -> None:
    speed = np.linspace(0.0, 60.0, 60_001)
    masses = np.array([1.0, 1.0, 4.0])
    density = plots.maxwell(speed, masses, 3.0)
    assert np.trapezoid(density, speed) == pytest.approx(1.0, rel=1e-6)
    light, heavy = (plots.maxwell(speed, np.array([mass]), 3.0) for mass in (1.0, 4.0))
    assert density == pytest.approx((2.0 * light + heavy) / 3.0)
    one = plots.maxwell(speed, np.array([2.0]), 3.0)
    assert np.trapezoid(0.5 * 2.0 * speed**2 * one, speed) == pytest.approx(3.0, rel=1e-6)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"plot": "hits_by_shape", "rows": 1}, "rows must be from 2 to .*, not 1"),
        ({"plot": "hits_by_shape", "count": "balls"}, "count must be"),
        ({"plot": "heat_map", "cells": 0}, "cells must be from 1 to .*, not 0"),
        ({"plot": "speeds", "bins": 0}, "bins must be from 1 to .*, not 0"),
        ({"plot": "speeds", "since": -1.0}, "since must not be negative"),
        ({"plot": "speeds", "since": 2.0}, "since must not be past the end"),
    ],
)
def test_bad_input_is_refused_by_name(arguments: dict[str, object], words: str, gas: carom.Recording) -> None:
    plot = getattr(plots, str(arguments.pop("plot")))
    with pytest.raises(carom.InvalidArgument, match=words):
        plot(gas, **arguments)
    assert plt.get_fignums() == []


def test_without_matplotlib_one_line_says_what_to_install(
    gas: carom.Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(carom.CaromError, match=r'^plots need matplotlib: pip install "carom\[study\]"$'):
        plots.energy(gas)


@pytest.mark.slow
def test_importing_plots_does_not_import_matplotlib() -> None:
    assert printed("import sys, carom.study.plots; print('matplotlib' in sys.modules)").strip() == "False"
