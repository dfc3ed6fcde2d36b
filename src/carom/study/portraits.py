"""Plots of studies, one call each: what `study.boundary_map` and its sisters return, drawn.

Each draws into `axes`, or into a new figure where there are none, and returns the axes. They look well on light and on
dark grounds, as `matplotlib.style` sets them.
"""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from carom.checks import refuse
from carom.spelling import spelled
from carom.study.axes import FIRST, MANY, OUTLINE, SECOND, axes_of, named
from carom.study.billiards.escapes import Correlation, Escape
from carom.study.billiards.maps import BoundaryMap, MeanFreePath
from carom.study.billiards.sections import Section
from carom.study.billiards.spectra import Lyapunov

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.study.billiards.ensembles import Numbers
    from carom.study.billiards.outline import Floats

#: Points in a phase portrait above which they are drawn ever smaller, and their largest size.
CROWD, DOT = 20_000, 3.0
#: Bars of a histogram.
BARS = 100
#: Deviations that a band of error shows to either side.
BAND = 2.0


@spelled
def boundary_map(found: BoundaryMap, axes: Axes | None = None) -> Axes:
    """The phase portrait of a `study.boundary_map`: each hit by arc length and sine, each orbit in one colour.

    Lines divide the outer wall and the islands.
    """
    _check(found, BoundaryMap, "boundary_map")
    axes = axes_of(axes)
    orbits, hits = found.sine.shape
    _dots(axes, found.arc_length.ravel(), found.sine.ravel(), np.repeat(np.arange(orbits), hits))
    for end in np.cumsum([loop.length for loop in found.table.loops[:-1]]):
        axes.axvline(end, color=OUTLINE, linewidth=1.0)
    axes.set_xlim(0.0, found.table.perimeter)
    axes.set_ylim(-1.0, 1.0)
    return named(axes, "Boundary map", "arc length in lengths", "sine of the angle of incidence")


@spelled
def section(found: Section, axes: Axes | None = None) -> Axes:
    """The phase portrait of a `study.section`: each crossing by its distance and velocity along the line, by orbit."""
    _check(found, Section, "section")
    axes = axes_of(axes)
    _dots(axes, found.distance, found.along, found.orbit)
    (ax, ay), (bx, by) = found.cut
    axes.set_xlim(0.0, hypot(bx - ax, by - ay))
    return named(axes, "Poincaré section", "distance along the line in lengths", "velocity along the line in lengths/s")


@spelled
def mean_free_path(found: MeanFreePath, axes: Axes | None = None) -> Axes:
    """The plot of how long the flights of a `study.mean_free_path` are, with their mean and π·area/perimeter."""
    _check(found, MeanFreePath, "mean_free_path")
    axes = axes_of(axes)
    axes.hist(found.paths, bins=BARS, density=True, color=FIRST, alpha=0.75, label="flights")
    label = f"mean {found.value:.4g} ± {found.error:.1g}"
    axes.axvline(found.value, color=SECOND, label=label)
    axes.axvline(found.expected, color=OUTLINE, linestyle="--", label=f"π·area/perimeter {found.expected:.4g}")
    axes.legend(frameon=False)
    axes.set_xlim(left=0.0)
    return named(axes, "Free paths", "flight in lengths", "share of flights per length")


@spelled
def survival(found: Escape, axes: Axes | None = None) -> Axes:
    """The plot of how many orbits of a `study.escape` are still there, with the rate that was found and its line."""
    _check(found, Escape, "escape")
    axes = axes_of(axes)
    there = found.survival > 0.0
    time, share, error = found.time[there], found.survival[there], BAND * found.error[there]
    axes.fill_between(time, np.maximum(share - error, 0.5 / len(found.times)), share + error, color=FIRST, alpha=0.25)
    axes.plot(time, share, color=FIRST, label="orbits")
    if found.rate > 0.0:
        later = time[time >= found.since]
        begin = float(np.interp(found.since, found.time, found.survival))
        label = f"rate {found.rate:.4g} ± {found.rate_error:.1g}"
        decay = begin * np.exp(-found.rate * (later - found.since))
        axes.plot(later, decay, color=SECOND, linestyle="--", label=label)
    axes.set_yscale("log")
    axes.set_xlim(0.0, found.time[-1])
    axes.legend(frameon=False)
    return named(axes, "Survival", "time in s", "share of orbits that are there")


@spelled
def correlation(found: Correlation, axes: Axes | None = None) -> Axes:
    """The plot of a `study.correlation` over time, with a band of two standard errors to either side."""
    _check(found, Correlation, "correlation")
    axes = axes_of(axes)
    error = BAND * found.error
    axes.axhline(0.0, color=OUTLINE, linewidth=1.0)
    axes.fill_between(found.time, found.value - error, found.value + error, color=FIRST, alpha=0.25)
    axes.plot(found.time, found.value, color=FIRST)
    axes.set_xlim(0.0, found.time[-1])
    return named(axes, "Correlation of velocity", "time in s", "v(0)·v(t) / v(0)²")


@spelled
def spectrum(found: Lyapunov, axes: Axes | None = None) -> Axes:
    """The plot of how the greatest exponents of the orbits of a `study.lyapunov` differ, with their mean.

    Order is a peak beside 0, chaos a hill where its exponent is.
    """
    _check(found, Lyapunov, "lyapunov")
    axes = axes_of(axes)
    density, edges = np.histogram(found.exponents, bins=BARS, density=True)
    axes.stairs(density, edges, fill=True, color=FIRST, alpha=0.75, label="orbits")
    value, error = float(found.spectrum[0]), float(found.error[0])
    axes.axvline(value, color=SECOND, label=f"mean {value:.4g} ± {error:.1g}")
    axes.axvline(0.0, color=OUTLINE, linewidth=1.0)
    axes.legend(frameon=False)
    return named(axes, "Lyapunov exponents", "greatest exponent in 1/s", "share of orbits per 1/s")


def _check(found: object, kind: type, study: str) -> None:
    """Raise `InvalidArgument` for what is not the result of a study."""
    if not isinstance(found, kind):
        raise refuse("found", f"must be what study.{study} returns", found)


def _dots(axes: Axes, x: Floats, y: Floats, orbit: Numbers) -> None:
    """Draw a dot for each place, smaller where they are many, in the colour of its orbit."""
    size = DOT * min(1.0, CROWD / max(1, len(x)))
    colours = np.array(MANY)[orbit % len(MANY)]
    axes.scatter(x, y, s=max(size, 0.05), c=colours, linewidths=0.0, rasterized=True)
