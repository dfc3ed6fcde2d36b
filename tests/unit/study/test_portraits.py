"""Plots of studies: each in one call, each draws the arrays that the study returned."""

from collections.abc import Callable, Iterator
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

import carom
from carom import study
from carom.study import plots
from carom.study.billiards.escapes import Correlation, Escape
from carom.study.billiards.maps import BoundaryMap, MeanFreePath
from carom.study.billiards.sections import Section
from carom.study.billiards.spectra import Lyapunov

mpl.use("Agg")


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    """No figure stays open."""
    yield
    plt.close("all")


def a_map() -> BoundaryMap:
    """Two orbits of three hits, made up, on a table with an island."""
    along = np.array([[1.0, 2.0, 3.0], [17.0, 18.0, 19.0]])
    return BoundaryMap(study.table("sinai"), along.copy(), along, along / 20.0)


def a_path() -> MeanFreePath:
    """Four flights, made up."""
    return MeanFreePath(2.0, 0.1, 2.1, np.array([3, 4]), np.array([1.0, 1.5, 2.5, 3.0]))


def an_escape(rate: float = 0.5) -> Escape:
    """A survival, made up, that ends with nobody."""
    time = np.linspace(0.0, 4.0, 5)
    survival = np.array([1.0, 0.6, 0.3, 0.1, 0.0])
    return Escape(time, survival, 0.1 * survival, np.array([0.5, 3.5]), rate, 0.1, 1.0, 0.4)


def a_correlation() -> Correlation:
    """A correlation, made up."""
    return Correlation(np.array([0.0, 1.0, 2.0]), np.array([1.0, 0.2, -0.1]), np.array([0.0, 0.1, 0.2]))


def a_spectrum() -> Lyapunov:
    """Three exponents, made up, two of order and one of chaos."""
    exponents = np.array([0.01, 0.02, 1.47])
    value, error = np.array([0.5, 0.0, 0.0, -0.5]), np.array([0.3, 0.0, 0.0, 0.3])
    return Lyapunov(value, error, exponents, np.array([9, 10, 11]), 10.0)


def a_section() -> Section:
    """Three crossings, made up, of two orbits."""
    numbers, times = np.array([0, 0, 9]), np.array([1.0, 2.0, 1.5])
    return Section(((0.0, 0.0), (3.0, 4.0)), numbers, times, times + 2.0, times - 3.0, times, 4.0, 3, 9.0)


PLOTS: list[tuple[Callable[..., Any], Any]] = [
    (plots.boundary_map, a_map()),
    (plots.mean_free_path, a_path()),
    (plots.survival, an_escape()),
    (plots.correlation, a_correlation()),
    (plots.spectrum, a_spectrum()),
    (plots.section, a_section()),
]


@pytest.mark.parametrize(("plot", "found"), PLOTS, ids=lambda value: getattr(value, "__name__", ""))
def test_one_call_makes_a_figure_or_draws_into_given_axes_on_any_ground(plot: Callable[..., Any], found: Any) -> None:
    for style in ("default", "dark_background"):
        with plt.style.context(style):
            axes = plot(found)
            assert axes.figure.axes[0] is axes
            assert axes.get_title()
            assert axes.get_xlabel()
            _, mine = plt.subplots()
            assert plot(found, mine) is mine
            # What is not a thing of its own has the colour of the ground's letters.
            assert mine.title.get_color() == mpl.rcParams["text.color"]
    with pytest.raises(carom.UnknownName, match="did you mean axes"):
        plot(found, axis=None)
    with pytest.raises(carom.InvalidArgument, match=r"found must be what study\.\w+ returns, not 'stadium'"):
        plot("stadium")


def test_a_phase_portrait_is_a_dot_for_each_hit_a_colour_for_each_orbit_and_a_line_for_each_island() -> None:
    axes = plots.boundary_map(a_map())
    (dots,) = axes.collections
    assert np.asarray(dots.get_offsets()).tolist() == [
        [along, along / 20.0] for along in (1.0, 2.0, 3.0, 17.0, 18.0, 19.0)
    ]
    colours = dots.get_facecolors()
    assert (colours[:3] == colours[0]).all()
    assert (colours[3:] == colours[3]).all()
    assert (colours[0] != colours[3]).any()
    (line,) = axes.get_lines()
    assert line.get_xdata()[0] == pytest.approx(16.0)
    assert axes.get_ylim() == (-1.0, 1.0)
    assert axes.get_xlim() == (0.0, pytest.approx(16.0 + 2.0 * np.pi))


def test_free_paths_are_told_with_their_mean_and_what_it_must_be() -> None:
    axes = plots.mean_free_path(a_path())
    assert [line.get_xdata()[0] for line in axes.get_lines()] == [2.0, 2.1]
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert "mean 2 ± 0.1" in texts
    assert "π·area/perimeter 2.1" in texts
    assert sum(patch.get_height() * patch.get_width() for patch in axes.patches) == pytest.approx(1.0)


def test_survival_is_drawn_while_someone_is_there_with_the_rate_that_was_found() -> None:
    axes = plots.survival(an_escape())
    curve, decay = axes.get_lines()
    assert curve.get_ydata().tolist() == [1.0, 0.6, 0.3, 0.1]
    assert decay.get_xdata()[0] == 1.0
    assert decay.get_ydata() == pytest.approx(0.6 * np.exp(-0.5 * np.array([0.0, 1.0, 2.0])))
    assert axes.get_yscale() == "log"
    assert "rate 0.5 ± 0.1" in [text.get_text() for text in axes.get_legend().get_texts()]
    assert len(plots.survival(an_escape(rate=0.0)).get_lines()) == 1


def test_a_correlation_is_drawn_with_a_band_of_two_errors() -> None:
    axes = plots.correlation(a_correlation())
    assert axes.get_lines()[-1].get_ydata().tolist() == [1.0, 0.2, -0.1]
    (band,) = axes.collections
    corners = band.get_paths()[0].vertices
    assert corners[:, 1].max() == pytest.approx(1.0)
    assert corners[:, 1].min() == pytest.approx(-0.5)


def test_a_spectrum_tells_order_from_chaos() -> None:
    axes = plots.spectrum(a_spectrum())
    assert [line.get_xdata()[0] for line in axes.get_lines()] == [0.5, 0.0]
    (steps,) = axes.patches
    density, edges, _ = steps.get_data()
    shares = density * np.diff(edges)
    assert (shares.sum(), shares[0], shares[-1]) == pytest.approx((1.0, 2.0 / 3.0, 1.0 / 3.0))
    assert "mean 0.5 ± 0.3" in [text.get_text() for text in axes.get_legend().get_texts()]


def test_a_section_is_a_dot_for_each_crossing_a_colour_for_each_orbit() -> None:
    axes = plots.section(a_section())
    (dots,) = axes.collections
    assert np.asarray(dots.get_offsets()).tolist() == [[3.0, -2.0], [4.0, -1.0], [3.5, -1.5]]
    colours = dots.get_facecolors()
    assert (colours[0] == colours[1]).all()
    assert (colours[0] != colours[2]).any()
    assert axes.get_xlim() == (0.0, 5.0)
