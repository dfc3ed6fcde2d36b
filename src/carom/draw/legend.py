"""What the panel says of a picture: the legend with a sample of each mark, the numbers, and what is left out."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom.draw.looks import GATE, GUARD, LOOKS, MOVING, POST, Look
from carom.draw.marks import arrow_mark, ball_mark, hit_mark, pivot_mark, track_style
from carom.draw.panel import GLYPH_WIDTH
from carom.draw.trace import MOST_HITS
from carom.draw.tracks import BANDS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.draw.frame import Frame
    from carom.draw.painter import Painter, Vector
    from carom.draw.panel import Glyph
    from carom.draw.trace import Trace
    from carom.draw.tracks import Track
    from carom.world.world import World

#: How many balls of different inks the sample of balls shows.
SAMPLE_BALLS = 3
HALF = 0.5 * GLYPH_WIDTH
#: Pixels: the radius of a sample ball; where a sample gate stands left of the middle, and half of its length.
BALL = 6.0
GATE_OFFSET, HALF_GATE = 6.0, 7.0


def look_sample(look: Look) -> Glyph:
    """The sample of a material: a line of it, or its dot, with the pivot or the arrow that belongs to it."""

    def draw(painter: Painter, frame: Frame, middle: Vector) -> None:
        x, y = middle
        if look in (POST, GUARD):
            painter.circle(frame.world(x, y), frame.units(look.dot), look.spot())
            return
        if look is GATE:
            painter.segment(
                frame.world(x - GATE_OFFSET, y - HALF_GATE), frame.world(x - GATE_OFFSET, y + HALF_GATE), look.style
            )
            arrow_mark(painter, frame, frame.world(x - GATE_OFFSET, y), (1.0, 0.0), look.style)
            return
        painter.segment(frame.world(x - HALF, y), frame.world(x + HALF, y), look.style)
        if look is MOVING:
            pivot_mark(painter, frame, frame.world(x - HALF, y))

    return draw


def ball_sample(inks: Sequence[str]) -> Glyph:
    """The sample of balls: one to three of them, by the inks in use."""

    def draw(painter: Painter, frame: Frame, middle: Vector) -> None:
        for number, ink in enumerate(inks):
            x = middle[0] + 1.2 * BALL * (number - 0.5 * (len(inks) - 1))
            ball_mark(painter, frame, frame.world(x, middle[1]), frame.units(BALL), ink)

    return draw


def track_sample(ink: str) -> Glyph:
    """The sample of a track: a line that fades to the left."""

    def draw(painter: Painter, frame: Frame, middle: Vector) -> None:
        edges = np.linspace(middle[0] - HALF, middle[0] + HALF, BANDS + 1)
        for band in range(BANDS):
            ends = [frame.world(float(x), middle[1]) for x in edges[band : band + 2]]
            painter.polyline(np.array(ends), track_style(ink, band))

    return draw


def hit_sample(painter: Painter, frame: Frame, middle: Vector) -> None:
    """Draw the sample of hit points: weak, middling, strong."""
    for strength, offset in ((0.0, -8.0), (0.3, 0.0), (1.0, 10.0)):
        hit_mark(painter, frame, frame.world(middle[0] + offset, middle[1]), strength, 1.0)


def legend(looks: Sequence[Look], inks: Sequence[str], *, tracks: bool, hits: bool) -> tuple[tuple[str, Glyph], ...]:
    """The entries for the `looks` that occur, for balls of some `inks`, for tracks and for hits."""
    entries = [(look.label, look_sample(look)) for look in LOOKS if look in looks]
    if inks:
        entries.append(("balls", ball_sample(inks[:SAMPLE_BALLS])))
    if tracks:
        entries.append(("track, fading with age", track_sample(inks[-1])))
    if hits:
        entries.append(("hit, sized by its impulse", hit_sample))
    return tuple(entries)


def facts(world: World, trace: Trace | None) -> tuple[tuple[str, str], ...]:
    """The panel's numbers: what there is, or what happened in the run that was followed."""
    balls = ("balls", f"{len(world.balls):,}")
    if trace is None:
        return ("shapes", f"{len(world.shapes):,}"), balls
    lines = [("time", seconds(world.time)), balls, ("hits", f"{trace.bounces:,}")]
    strays = world.statistics.strays
    return (*lines, ("strays", f"{strays:,}")) if strays else tuple(lines)


def remarks(world: World, trace: Trace | None, tracks: Sequence[Track]) -> tuple[str, ...]:
    """What the picture leaves out, in words."""
    lines = []
    if tracks:
        span = max(float(track.times[-1]) for track in tracks) - min(float(track.times[0]) for track in tracks)
        whose = "all balls" if len(tracks) == len(world.balls) else f"{len(tracks)} of {len(world.balls):,} balls"
        lines.append(f"Tracks of {whose}, over the last {seconds(span)}.")
    if trace is not None and trace.bounces > MOST_HITS:
        lines.append(f"Of the hits, the {MOST_HITS:,} strongest are shown.")
    return tuple(lines)


def seconds(time: float) -> str:
    """A time to the hundredth of a second, in one word."""
    return f"{time:,.2f}".rstrip("0").rstrip(".") + "\N{NO-BREAK SPACE}s"
