"""What is on the panel, row by row, and in which order: what it is called and what it sets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

from carom.play.toy.settings import BOTH, PACES


@dataclass(frozen=True, slots=True)
class Heading:
    """The words above a group of rows."""

    words: str


@dataclass(frozen=True, slots=True)
class Numbers:
    """A row of figures, each by its name and with its words."""

    figures: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Gauge:
    """The bar of the time that a frame takes."""


@dataclass(frozen=True, slots=True)
class Slider:
    """A slider that sets `name` from `low` to `high` in steps; whole numbers where all three are whole."""

    name: str
    words: str
    low: float
    high: float
    step: float

    def at(self, part: float) -> float:
        """The value at a part of the way, 0 to 1."""
        value = self.low + self.step * round(part * (self.high - self.low) / self.step)
        return value if isinstance(self.step, int) else round(value, 6)

    def part(self, value: float) -> float:
        """The part of the way at which a value is, 0 to 1."""
        return min(1.0, max(0.0, (value - self.low) / (self.high - self.low)))

    def text(self, value: float) -> str:
        """A value in words."""
        return f"{value:.0f}" if isinstance(self.step, int) else f"{value:.{1 if self.step >= 0.1 else 2}f}"


@dataclass(frozen=True, slots=True)
class Choice:
    """Buttons side by side of which one is chosen: the values of `name` and what they are called."""

    name: str
    words: str
    options: tuple[tuple[Any, str], ...]


@dataclass(frozen=True, slots=True)
class Buttons:
    """Buttons that do something, or that are switched on and off, each by its name and with its words."""

    buttons: tuple[tuple[str, str], ...]


Row: TypeAlias = Heading | Numbers | Gauge | Slider | Choice | Buttons

ROWS: tuple[Row, ...] = (
    Gauge(),
    Heading("Balls"),
    Numbers(
        (
            ("launched", "launched"),
            ("in play", "in play"),
            ("asleep", "asleep"),
            ("strays", "strays"),
            ("overlaps", "overlaps"),
        )
    ),
    Slider("size", "next size", 0.1, 0.6, 0.05),
    Slider("speed", "next speed", 1, 150, 1),
    Slider("count", "how many", 1, 100, 1),
    Buttons(
        (("launch", "launch"), ("launch many", "launch n"), ("clear", "clear"), ("help", "help"), ("quit", "quit"))
    ),
    Heading("Collision"),
    Numbers((("box tests once", "box tests an iteration"), ("box tests", "box tests a second"))),
    Numbers((("full tests", "full tests a second"), ("collisions", "collisions a second"))),
    Choice("broad_phase", "broad phase", (("brute", "brute"), ("quadtree", "quadtree"), ("grid", "grid"))),
    Slider("levels", "levels", 1, 10, 1),
    Numbers((("nodes", "nodes"), ("leaves", "leaves, cells"), ("leaf size", "leaf size"), ("most", "most in a leaf"))),
    Slider("motion", "motion iter.", 1, 16, 1),
    Slider("collision", "collision iter.", 1, 16, 1),
    Choice(
        "detection",
        "detection",
        (("discrete", "discrete"), ("continuous", "continuous"), (BOTH, "side by side")),
    ),
    Choice("restitution", "restitution", (("normal", "normal"), ("total", "total"))),
    Slider("gravity", "gravity", 0.0, 30.0, 0.5),
    Slider("friction", "friction", 0.0, 10.0, 0.1),
    Slider("sleep", "sleep below", 0.0, 1.0, 0.05),
    Heading("Time and table"),
    Choice("pace", "pace", tuple((pace, "real time" if pace == 1 else f"1/{pace}") for pace in PACES)),
    Buttons((("paused", "pause"), ("step", "step"), ("rotating", "rotate"), ("muted", "mute"))),
    Buttons((("tunnelling", "who tunnels?"), ("editing", "edit table"), ("save", "save table"))),
    Choice(
        "kind",
        "add",
        (("segment", "wall"), ("arc", "arc"), ("circle", "disc"), ("point", "post"), ("ball", "ball")),
    ),
    Heading("Show"),
    Buttons((("hit points", "hit points"), ("tracks", "tracks"), ("tangents", "tangents"), ("boxes", "boxes"))),
    Buttons((("reticles", "reticles"), ("velocity", "velocity"), ("sectors", "sectors"), ("lights", "lights"))),
)

#: The values that a choice goes through, by its name.
OPTIONS: dict[str, tuple[Any, ...]] = {
    row.name: tuple(value for value, _ in row.options) for row in ROWS if isinstance(row, Choice)
}
