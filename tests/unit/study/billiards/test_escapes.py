"""Orbits escape as fast as the published rates say, and velocities are forgotten as closed forms say."""

from math import pi
from typing import Any

import numpy as np
import pytest

import carom
from carom import scenes, study
from carom.study.billiards import ensembles, escapes


def test_in_a_round_room_each_orbit_escapes_when_its_angle_says() -> None:
    found = study.escape(scenes.circle(radius=1.0), (0.0, 1.0), n=30, seconds=12.0, seed=5, since=1.0)
    hits = study.boundary_map(scenes.circle(radius=1.0), n=30, hits=60, seed=5, boundary=False)
    through = hits.arc_length < 1.0
    times = [row[hole][0] if hole.any() else np.inf for row, hole in zip(hits.time, through, strict=True)]
    expected = np.where(np.array(times) <= 12.0, times, np.inf)
    # Nearly along the wall a ball hits more often than sixty times; such orbits meet any hole at once.
    assert found.times == pytest.approx(expected, abs=1e-6)
    assert found.survival[0] == 1.0
    assert found.survival[-1] == pytest.approx(np.isinf(found.times).mean())
    assert (np.diff(found.survival) <= 0.0).all()
    middle = len(found.time) // 2
    assert found.survival[middle] == pytest.approx((found.times > found.time[middle]).mean())
    assert found.error[middle] == pytest.approx(np.sqrt(found.survival[middle] * (1 - found.survival[middle]) / 30))


def test_in_a_round_room_orbits_escape_when_a_turn_by_their_chord_comes_to_the_hole() -> None:
    table = study.table(scenes.circle(radius=1.0))
    found = study.escape(table, (2.0, 2.4), n=40, seconds=60.0, seed=9, since=1.0)
    position, velocity = table.random_starts(40, seed=9)
    radius = 1.0 - float(table.ensemble(1).balls.radius[0])  # of the circle that middles of balls meet
    for (x, y), (u, v), time in zip(position, velocity, found.times, strict=True):
        momentum, along = x * v - y * u, x * u + y * v
        half = np.sqrt(radius**2 - momentum**2)  # half of each chord
        first, turn = half - along, 2.0 * np.arccos(abs(momentum) / radius) * np.sign(momentum)
        times = first + 2.0 * half * np.arange(1 + int(60.0 / half))
        angles = np.arctan2(y + first * v, x + first * u) + turn * np.arange(len(times))
        through = times[(np.mod(angles, 2.0 * pi) >= 2.0) & (np.mod(angles, 2.0 * pi) < 2.4) & (times <= 60.0)]
        assert time == pytest.approx(through[0] if len(through) else np.inf, abs=1e-9)


def test_who_has_left_is_followed_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = []
    run = ensembles.Batch.run

    def noted(self: ensembles.Batch, seconds: float) -> carom.Hits:
        began = self.world.time
        found = run(self, seconds)
        parts.append((began, set(self.numbers(found).tolist())))
        return found

    monkeypatch.setattr(ensembles.Batch, "run", noted)
    # A hole in the floor; those that go nearly straight beside it, or from side to side, stay long.
    table = study.table(scenes.rectangle(4.0, 2.0))
    found = study.escape(table, (0.1, 1.9), n=20, seconds=400.0, seed=1)
    left = {orbit for orbit, time in enumerate(found.times) if time < 100.0}
    assert len(left) > 10
    assert 3 < len(parts) < escapes.PARTS  # the last one has left by then
    for began, met in parts:
        assert all(found.times[orbit] >= began for orbit in met)
    parts.clear()
    everywhere = study.escape(table, (0.0, table.perimeter), n=20, seconds=400.0, seed=1)
    assert (everywhere.times < 20.0).all()
    assert len(parts) == 1


@pytest.mark.slow
@pytest.mark.compiled
def test_chaotic_orbits_escape_at_the_rate_of_bauer_and_bertsch() -> None:
    # W. Bauer and G. F. Bertsch, Phys. Rev. Lett. 65, 2213, 1990: speed·hole/(π·area) for small holes. The next term is
    # half of the chance to hit the hole, here a quarter of a percent, and less than the error.
    table = study.table(scenes.lorentz())
    hole = 0.005 * table.perimeter
    found = study.escape(table, (1.0, 1.0 + hole), n=20_000, seconds=60.0, seed=1)
    assert abs(found.rate - found.expected) < 3.0 * found.rate_error < 0.04 * found.expected


@pytest.mark.slow
@pytest.mark.compiled
def test_in_a_stadium_those_that_bounce_up_and_down_are_there_for_long() -> None:
    # C. P. Dettmann and O. Georgiou, Physica D 238, 2395, 2009, find a constant over t; for starts that are uniform in
    # phase space it is derived here. With a hole from h1 to h2 in a straight wall from -a to a, the share that survives
    # comes to (3 ln 3 + 4)·((a + h1)² + (a - h2)²)/(2π(4a + πr))/t. Of those on one side of
    # the hole, L wide, half go towards it; the others come back from the half circle with k times their angle, k
    # being even from 1/3 to 3, whose mean 1/k is 3/4 ln 3.
    half, radius, h1, h2 = 2.0, 0.5, -0.5, 0.7
    table = study.table(scenes.stadium(2.0 * half, radius))
    begins = np.cumsum([0.0, *(piece.wall.length for piece in table.loops[0].pieces)])
    lower = [piece.ends[0] == pytest.approx((-half, -radius)) for piece in table.loops[0].pieces].index(True)
    middle = begins[lower] + half
    found = study.escape(table, (middle + h1, middle + h2), n=100_000, seconds=240.0, seed=1)
    survivors = (
        (3.0 * np.log(3.0) + 4.0) * ((half + h1) ** 2 + (half - h2) ** 2) / (2.0 * pi * (4.0 * half + pi * radius))
    )
    assert abs(240.0 * found.survival[-1] - survivors) < 2.0 * 240.0 * found.error[-1] < 0.16 * survivors


def test_a_closed_hole_lets_nobody_out() -> None:
    square = scenes.rectangle(2.0, 2.0)
    table = study.table(square)
    found = study.escape(table, (table.perimeter - 1e-12, table.perimeter), n=4, seconds=9.0, since=2.0)
    assert found.rate == 0.0
    assert found.rate_error == np.inf
    assert (found.survival == 1.0).all()


def wave(phase: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The correlation of the sign of a speed between two walls, as many of their distances later."""
    return np.abs(np.mod(phase, 2.0) - 1.0) * 2.0 - 1.0


def test_in_a_rectangle_velocities_are_correlated_as_triangular_waves() -> None:
    # Each component only changes its sign, 1/width or 1/height times its size a second; then the mean over directions.
    found = study.correlation(scenes.rectangle(3.0, 2.0), n=300, seconds=6.0, steps=12, seed=1)
    angles = (np.arange(20_000) + 0.5) * 2.0 * pi / 20_000
    across, along = np.abs(np.cos(angles)), np.abs(np.sin(angles))
    for time, value, error in zip(found.time, found.value, found.error, strict=True):
        expected = np.mean(across**2 * wave(across * time / 3.0) + along**2 * wave(along * time / 2.0))
        assert abs(value - expected) <= 4.0 * error + 1e-4
    assert (found.time[0], found.time[-1], found.value[0], found.error[0]) == pytest.approx((0.0, 6.0, 1.0, 0.0))


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("name", ["sinai", "mushroom", "lorentz"])
def test_correlations_begin_with_the_slope_of_every_table(name: str) -> None:
    table = study.table(name)
    free = pi * table.area / table.perimeter
    found = study.correlation(table, n=5000, seconds=0.02 * free, steps=1, seed=2)
    # Who hits twice in a fiftieth of a free time is a part in a thousand of those who hit once.
    assert abs(found.value[1] - (1.0 - 4.0 / 3.0 * 0.02)) < 4.0 * found.error[1] + 1e-4


@pytest.mark.parametrize(
    ("study_of", "given", "told"),
    [
        (study.escape, {"hole": (1.0, 0.5)}, r"hole must be two arc lengths from 0 to 12.56.*, not \(1.0, 0.5\)"),
        (study.escape, {"hole": (0.0, 13.0)}, "hole must be two arc lengths"),
        (study.escape, {"hole": 3}, "hole must be a pair of numbers, not 3"),
        (study.escape, {"hole": (0, 1), "seconds": -1.0}, "seconds must be positive, not -1.0"),
        (study.escape, {"hole": (0, 1), "seconds": 9.0, "since": 9.0}, "since must be .*, not 9.0"),
        (study.escape, {"hole": (0, 1), "seconds": 9.0}, "seconds must be .*, not 9.0"),
        (study.escape, {"hole": (0, 1), "n": 1}, "n must be from 2"),
        (study.correlation, {"steps": 0}, "steps must be from 1"),
        (study.correlation, {"seconds": 0.0}, "seconds must be positive, not 0.0"),
        (study.correlation, {"speed": "1"}, "speed must be a number, not '1'"),
        (study.correlation, {"scene": 1}, "scene must be a Scene"),
    ],
)
def test_what_cannot_be_studied_is_refused(study_of: Any, given: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        study_of(**({"scene": "circle"} | given))
