"""What a true arc is worth: one elastic ball in a round room, and in the same room made of segments."""

from dataclasses import dataclass, field, replace
from functools import cache
from math import atan2, cos, floor, hypot, log10, pi, sin, sqrt
from time import process_time

import numpy as np

from benchmarks.chart import Chart, Curve
from benchmarks.common import Figure
from benchmarks.engines import CONTINUOUS, engines
from benchmarks.setup import Floats, Setup
from carom.draw.paint.painter import Style

TITLE = "Round room: one elastic ball, a true circle beside polygons; stepped and read"
ROOM_RADIUS = 10.0
RADIUS = 0.5
WAY = ROOM_RADIUS - RADIUS  # how far from the middle the ball's centre can be
START, DIRECTION = (3.0, 1.0), 0.7
TIME_STEP = 1.0 / 60.0
SPEEDS = (0.25, 4.0)  # radii a step
SEGMENTS = (64, 256, 1024)


@dataclass
class History:
    """What became of the ball of one engine in one room."""

    room: str
    engine: str
    seconds_a_step: float = 0.0
    energy_drift: float = 0.0  # relative
    momentum_drift: float = 0.0  # of the angular momentum, relative to |v|·R
    left_after: float | None = None  # impacts
    off: list[tuple[float, float]] = field(default_factory=list)  # impacts, and radii off the exact path


def setup_of(speed: float, segments: int, chained: bool) -> Setup:
    """The room, of one circle where there are 0 segments; their ends are on that circle."""
    velocity = speed * RADIUS / TIME_STEP * np.array([[cos(DIRECTION), sin(DIRECTION)]])
    made = Setup(np.array([START]), velocity, RADIUS, TIME_STEP, chained=chained)
    if segments == 0:
        return replace(made, rings=np.array([[0.0, 0.0, ROOM_RADIUS]]))
    angle = 2.0 * pi * np.arange(segments) / segments
    corners = ROOM_RADIUS * np.column_stack((np.cos(angle), np.sin(angle)))
    return replace(made, segments=np.hstack((corners, np.roll(corners, -1, axis=0))))


class ExactPath:
    """The path in the round room in closed form: all chords are of one length, each turned by the same angle."""

    def __init__(self, setup: Setup) -> None:
        (self.x, self.y), (self.vx, self.vy) = setup.position[0].tolist(), setup.velocity[0].tolist()
        self.speed = hypot(self.vx, self.vy)
        b = (self.x * self.vx + self.y * self.vy) / self.speed
        ahead = sqrt(b * b + WAY * WAY - self.x * self.x - self.y * self.y)
        self.first = (ahead - b) / self.speed  # time of the first impact
        self.chord = 2.0 * ahead / self.speed  # time from one to the next
        momentum = (self.x * self.vy - self.y * self.vx) / self.speed
        self.turn = 2.0 * atan2(ahead, momentum)
        self.angle = atan2(self.y + self.vy * self.first, self.x + self.vx * self.first)

    def impacts(self, time: float) -> float:
        """How many impacts there are up to a time, with fractions of chords."""
        return (time - self.first) / self.chord

    def at(self, time: float) -> tuple[float, float]:
        """Where the ball's centre is."""
        if time <= self.first:
            return self.x + self.vx * time, self.y + self.vy * time
        chords = floor(self.impacts(time))
        part = self.impacts(time) - chords
        angle, after = self.angle + chords * self.turn, self.angle + (chords + 1) * self.turn
        return (
            WAY * ((1.0 - part) * cos(angle) + part * cos(after)),
            WAY * ((1.0 - part) * sin(angle) + part * sin(after)),
        )


def follow(engine: str, room: str, setup: Setup, impacts: int) -> History:
    """Step one engine until there should have been so many impacts, or the ball is out of the room."""
    world = engines(with_continuous=True)[engine](setup)
    path = ExactPath(setup)
    history = History(room, engine)
    steps = int((path.first + impacts * path.chord) / setup.time_step)
    looks = set(np.unique(np.geomspace(path.first / setup.time_step + 2.0, steps, 60).astype(int)).tolist())
    world.step()
    spent = 0.0
    done = 1
    for step in range(2, steps + 1):
        began = process_time()
        world.step()
        x, y = world.first_ball()
        spent += process_time() - began
        done = step
        if hypot(x, y) > ROOM_RADIUS:
            history.left_after = path.impacts(step * setup.time_step)
            break
        if step in looks:
            look(history, path, step * setup.time_step, (x, y))
    history.seconds_a_step = spent / max(done - 1, 1)
    weigh(history, setup, *world.state())
    return history


def look(history: History, path: ExactPath, time: float, place: tuple[float, float]) -> None:
    """Note how far the ball is off its exact path."""
    x, y = path.at(time)
    history.off.append((path.impacts(time), hypot(place[0] - x, place[1] - y) / RADIUS))


def weigh(history: History, setup: Setup, position: Floats, velocity: Floats) -> None:
    """Note what the ball has lost or won of its energy and angular momentum."""
    x, y, vx, vy = *position[0].tolist(), *velocity[0].tolist()
    x0, y0, vx0, vy0 = *setup.position[0].tolist(), *setup.velocity[0].tolist()
    before = vx0 * vx0 + vy0 * vy0
    history.energy_drift = (vx * vx + vy * vy) / before - 1.0
    history.momentum_drift = ((x * vy - y * vx) - (x0 * vy0 - y0 * vx0)) / (sqrt(before) * ROOM_RADIUS)


@cache
def histories(quick: bool) -> dict[float, list[History]]:
    """All engines in all rooms, at both speeds."""
    return {speed: [follow(*case, 20 if quick else 1_000) for case in cases(speed)] for speed in SPEEDS}


def cases(speed: float) -> list[tuple[str, str, Setup]]:
    """Engine, name of the room, and the room: the circle for carom alone, and chains; for peers also loose ones."""
    found = [(name, "circle", setup_of(speed, 0, chained=False)) for name in ("carom", CONTINUOUS)]
    for segments in SEGMENTS:
        loose, chain = (setup_of(speed, segments, chained) for chained in (False, True))
        for name in engines(with_continuous=True):
            if name in ("pymunk", "Box2D"):
                found.append((name, f"{segments:,} loose", loose))
            found.append((name, f"{segments:,} segments", chain))
    return found


def run(quick: bool) -> list[Figure]:
    """Microseconds of a step, and what became of the ball."""
    return [figure_of(speed, history) for speed, found in histories(quick).items() for history in found]


def figure_of(speed: float, history: History) -> Figure:
    """A row of the table."""
    remarks = {
        "energy drift": f"{history.energy_drift:+.0e}",
        "ang. mom. drift": f"{history.momentum_drift:+.0e}",
        "radii off the path": f"{history.off[-1][1]:.1g}" if history.off else "",
        "left the room": "no" if history.left_after is None else f"at impact {history.left_after:,.0f}",
    }
    value = 1e6 * history.seconds_a_step
    return Figure(f"{history.room}, {speed:g} radii a step", history.engine, value, "µs a step", None, remarks)


# -- the plot --------------------------------------------------------------------------------------------------------

LEAST, MOST = -16, 2  # powers of ten of radii
INKS = {"carom": "ball-3", CONTINUOUS: "ball-1", "pymunk": "ball-4", "Box2D": "ball-2"}
DASHES: dict[str, tuple[float, ...]] = {"circle": (), "1,024 segments": (6.0, 4.0), "64 segments": (2.0, 4.0)}


def plot(quick: bool) -> str:
    """How far each ball is off the exact path, as SVG, after more and more impacts; at the lower speed."""
    chart = Chart(
        "How far a ball in a round room is off its exact path",
        "impacts",
        "radii off the exact path",
        across=(0.0, log10(20 if quick else 1_000)),
        up=(LEAST, MOST, 2),
    )
    shown = [history for history in histories(quick)[SPEEDS[0]] if history.room in DASHES]
    return chart.draw(
        [
            Curve(
                f"{history.engine}, {history.room}",
                Style(INKS[history.engine], width=1.8, dash=DASHES[history.room]),
                [(max(count, 1.0), max(off, 1e-16)) for count, off in history.off],
            )
            for history in shown
        ]
    )
