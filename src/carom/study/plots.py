"""Plots of a run, one call each: its energy, what was hit how often, where balls were, how fast they were.

Each takes a `Recording`, draws into `axes`, or into a new figure where there are none, and returns the axes. The extra
`study` brings matplotlib, which is imported when the first plot is made. The plots of studies are here too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from carom.checks import instance, non_negative, one_of, refuse, whole
from carom.draw.paint.painter import Style
from carom.draw.parts.outlines import line_mark
from carom.extras import needed
from carom.record.members import hits_by_label, touches_by_label
from carom.record.recording import Recording
from carom.spelling import spelled
from carom.study.axes import FIRST, OUTLINE, SECOND, axes_of, named
from carom.study.portraits import boundary_map, correlation, mean_free_path, section, spectrum, survival
from carom.typing import Vector
from carom.world.hits import HitKind

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "boundary_map",
    "correlation",
    "energy",
    "heat_map",
    "hits_by_shape",
    "mean_free_path",
    "section",
    "spectrum",
    "speeds",
    "survival",
]

Floats: TypeAlias = NDArray[np.float64]

#: What `hits_by_shape` may count.
Counted: TypeAlias = Literal["touches", "hits"]
COUNTED: tuple[Counted, ...] = ("touches", "hits")

#: How many rows `hits_by_shape` has at most; what was hit less often shares the last one.
MOST_ROWS = 12
#: How many cells a map has at most along a side, and a histogram in all: more than any picture has pixels.
MOST_CELLS = 10_000
#: The part of its greatest width that a heat map is drawn beyond the shapes.
MARGIN = 0.02


@spelled
def energy(recording: Recording, axes: Axes | None = None) -> Axes:
    """The plot of energy over time: the balls' kinetic energy, and with gravity the sum with their potential energy.

    >>> import carom
    >>> from carom.study import plots
    >>> axes = plots.energy(carom.Recording.of(carom.scenes.newtons_cradle().build(), seconds=0.1))
    >>> axes.get_xlabel()
    'time in s'
    """
    instance("recording", recording, Recording, "a Recording")
    axes = axes_of(axes)
    kinetic, total = recording.kinetic_energy(), recording.energy()
    if np.array_equal(kinetic, total):
        axes.plot(recording.times, kinetic, color=FIRST)
    else:
        axes.plot(recording.times, total, color=SECOND, label="kinetic and potential")
        axes.plot(recording.times, kinetic, color=FIRST, label="kinetic")
        axes.legend(frameon=False, loc="upper right", ncols=2)
    axes.set_ylim(*_room_for(np.concatenate((kinetic, total))))
    return named(axes, "Energy", "time in s", "energy in mass · length²/s²")


@spelled
def hits_by_shape(
    recording: Recording, axes: Axes | None = None, *, rows: int = MOST_ROWS, count: Counted = "touches"
) -> Axes:
    """The plot of how often each shape was touched, the most often first, by name; balls count together.

    `rows` is how many bars there are at most; the last one then stands for all others. With `count="hits"` every hit
    counts, also those of a ball that rolls along a shape or comes to rest on it, which are one touch.
    """
    instance("recording", recording, Recording, "a Recording")
    rows = whole("rows", rows, 2)
    by_label = touches_by_label if one_of("count", count, COUNTED) == "touches" else hits_by_label
    axes = axes_of(axes)
    bounces = recording.hits[recording.hits["kind"] == HitKind.BOUNCE]
    bars = by_label(recording, bounces)
    if len(bars) > rows:
        rest = bars[rows - 1 :]
        bars = [*bars[: rows - 1], (f"{len(rest)} others", sum(count for _, count in rest))]
    drawn = axes.barh(range(len(bars)), [count for _, count in bars], color=FIRST)
    axes.set_yticks(range(len(bars)), [label for label, _ in bars])
    axes.invert_yaxis()
    axes.bar_label(drawn, fmt="{:,.0f}", padding=3)
    axes.margins(x=0.12)
    return named(axes, f"{count.capitalize()} by shape", count, "")


@spelled
def heat_map(recording: Recording, axes: Axes | None = None, *, cells: int = 80) -> Axes:
    """The map of where balls were: each cell's colour is its share of all balls' time, shapes are outlined.

    Colours go by the root of the share, so that what is rarely visited can be told from what never is. `cells` is how
    many there are along the longer side.
    """
    instance("recording", recording, Recording, "a Recording")
    cells = whole("cells", cells, 1, MOST_CELLS)
    axes = axes_of(axes)
    places = recording.positions.reshape(-1, 2)
    places = places[np.isfinite(places).all(axis=1)]
    left, bottom, right, top = _extent(recording, places)
    side = max(right - left, top - bottom) / cells
    columns, rows = max(1, round((right - left) / side)), max(1, round((top - bottom) / side))
    counts, _, _ = np.histogram2d(
        places[:, 0], places[:, 1], bins=(columns, rows), range=((left, right), (bottom, top))
    )
    share = counts.T / max(1, len(places))
    norm = needed("matplotlib.colors", "matplotlib", "study", "plots").PowerNorm(0.5, vmin=0.0)
    extent = (left, right, bottom, top)
    image = axes.imshow(share, norm=norm, origin="lower", extent=extent, cmap="magma", interpolation="nearest")
    axes.figure.colorbar(image, ax=axes, label="share of the time", shrink=0.8)
    _outline(recording, axes)
    axes.set_aspect("equal")
    return named(axes, "Where the balls were", "x in lengths", "y in lengths")


@spelled
def speeds(recording: Recording, axes: Axes | None = None, *, since: float = 0.0, bins: int = 60) -> Axes:
    """The plot of how speeds are distributed over all balls and all frames from the time `since` on.

    Beside it, what Maxwell's law says of balls of these masses and this energy in equilibrium: in the plane, a ball of
    mass m has the speed v with the density m·v/T·exp(-m·v²/2T), T being its mean kinetic energy.
    """
    instance("recording", recording, Recording, "a Recording")
    since, bins = non_negative("since", since), whole("bins", bins, 1, MOST_CELLS)
    frames = recording.times - recording.times[0] >= since
    if not frames.any():
        raise refuse("since", f"must not be past the end, {recording.duration!r} s", since)
    axes = axes_of(axes)
    squared = np.sum(recording.velocities[frames] ** 2, axis=-1)
    there = np.isfinite(squared)
    masses = np.broadcast_to(recording.masses, squared.shape)[there]
    speed = np.sqrt(squared[there])
    if len(speed) == 0:
        return named(axes, "Speeds", "speed in lengths/s", "share of balls per length/s")
    fastest = float(speed.max()) or 1.0
    axes.hist(speed, bins=bins, range=(0.0, fastest), density=True, color=FIRST, alpha=0.75, label="balls")
    temperature = float(np.mean(0.5 * masses * squared[there]))
    if temperature > 0.0:
        grid = np.linspace(0.0, fastest, 200)
        axes.plot(grid, maxwell(grid, masses, temperature), color=SECOND, label="Maxwell")
        axes.legend(frameon=False)
    return named(axes, "Speeds", "speed in lengths/s", "share of balls per length/s")


def maxwell(speed: Floats, masses: Floats, temperature: float) -> Floats:
    """The density of speeds in the plane for balls of `masses` whose mean kinetic energy is `temperature`."""
    kinds, counts = np.unique(masses, return_counts=True)
    ratio = kinds[:, None] / temperature
    each = ratio * speed * np.exp(-0.5 * ratio * speed * speed)
    mean: Floats = np.average(each, axis=0, weights=counts)
    return mean


def _room_for(values: Floats) -> tuple[float, float]:
    """Limits that hold 0 and all `values`, so that what is constant looks so, with room above for a legend."""
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    room = 0.05 * (high - low) or 1.0
    return low - (room if low < 0.0 else 0.0), high + 3.0 * room


def _extent(recording: Recording, places: Floats) -> tuple[float, float, float, float]:
    """The box (left, bottom, right, top) of all shapes at the beginning; of the balls' places where there are none."""
    boxes = np.array([tuple(shape.aabb) for shape in recording.shapes_at(0)]).reshape(-1, 4)
    if len(boxes) == 0:
        boxes = np.concatenate((places, places), axis=1)
    if len(boxes) == 0:
        return 0.0, 0.0, 1.0, 1.0
    left, bottom = boxes[:, :2].min(axis=0).tolist()
    right, top = boxes[:, 2:].max(axis=0).tolist()
    margin = MARGIN * max(right - left, top - bottom) or 0.5
    return left - margin, bottom - margin, right + margin, top + margin


def _outline(recording: Recording, axes: Axes) -> None:
    """Draw the lines of all shapes as they stood at the beginning."""
    lines = _AxesLines(axes, needed("matplotlib.patches", "matplotlib", "study", "plots"))
    for shape in recording.shapes_at(0):
        line_mark(lines, shape, Style(OUTLINE, width=1.0))


@dataclass(frozen=True)
class _AxesLines:
    """What draws the outlines of shapes on axes, with the patches of matplotlib."""

    axes: Axes
    patches: Any

    def segment(self, start: Vector, end: Vector, style: Style) -> None:
        """Draw a straight line."""
        self.axes.plot(*zip(start, end, strict=True), color=style.stroke, linewidth=style.width)

    def circle(self, center: Vector, radius: float, style: Style) -> None:
        """Draw a circle."""
        self.axes.add_patch(self.patches.Circle(center, radius, fill=False, color=style.stroke))

    def arc(self, center: Vector, radius: float, start_angle: float, end_angle: float, style: Style) -> None:
        """Draw the part of a circle counterclockwise from one angle to another."""
        angles = np.degrees((start_angle, end_angle))
        size = 2.0 * radius
        self.axes.add_patch(
            self.patches.Arc(center, size, size, theta1=angles[0], theta2=angles[1], color=style.stroke)
        )
