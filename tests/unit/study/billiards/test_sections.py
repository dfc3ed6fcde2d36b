"""Sections show what order keeps, cross as often as the measure of phase space says, and when a sensor is entered."""

from math import acos, hypot, pi, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import scenes, study
from carom.study.billiards import ensembles
from carom.study.billiards.ensembles import batches

G = 9.8


def spread(found: study.Section, kept: np.ndarray[Any, Any]) -> float:
    """By how much a quantity changes along an orbit of a section, at most."""
    return max(float(np.ptp(kept[found.orbit == orbit])) for orbit in np.unique(found.orbit))


def test_in_a_round_room_the_angular_momentum_is_kept() -> None:
    found = study.section(scenes.circle(radius=1.0), ((0.0, 0.0), (1.0, 0.0)), n=12, hits=12, seed=1)
    assert len(found.time) > 20
    momentum = found.distance * found.across
    assert spread(found, momentum) < 1e-11
    assert np.ptp(momentum) > 0.3
    assert found.along**2 + found.across**2 == pytest.approx(np.ones(len(found.time)))


def test_in_the_wedge_of_45_degrees_the_energies_across_its_walls_are_kept() -> None:
    # H. E. Lehtihet and B. N. Miller, Physica D 21, 93, 1986. The walls are square, and in their directions gravity has
    # equal parts: each of the two motions keeps its energy. On the middle line these differ by along·across.
    speed = 4.0
    found = study.section("wedge", ((0.0, 0.0), (0.0, 3.0)), n=8, hits=25, seed=2, speed=speed)
    assert len(found.time) > 40
    assert spread(found, found.along * found.across) < 1e-11
    assert np.ptp(found.along * found.across) > 2.0
    energy = 0.5 * (found.along**2 + found.across**2) + G * found.distance
    assert energy == pytest.approx(np.full(len(energy), 0.5 * speed**2), abs=1e-9)


def test_in_the_wedge_of_45_degrees_each_wall_is_hit_at_equal_times() -> None:
    table = study.table("wedge")
    (batch,) = batches(table, table.random_starts(6, seed=4, speed=4.0), 4.0)
    flights = batch.flights(12.0)
    ends, orbit = flights.ends, np.repeat(np.arange(6), flights.counts)
    for number in range(6):
        for wall in batch.world.shapes[:2]:
            mine = ends[(orbit == number) & (ends["shape"] == wall.id)]
            # Upwards at the speed s across the wall and back under g/√2, whatever the other wall does.
            across = -np.sum(mine["velocity"] * mine["normal"], axis=1)
            assert np.diff(mine["time"]) == pytest.approx(np.full(len(mine) - 1, 2.0 * sqrt(2.0) * across[0] / G))


def test_crossings_are_when_a_sensor_is_entered() -> None:
    line = ((-0.7, -0.8), (0.9, 0.8))
    room = scenes.annulus(outer=2.0, inner=0.3, offset=1.2)
    sensor = carom.Segment(*line, sensor=True, name="line")
    room = room.model_copy(update={"shapes": carom.Scene(shapes=[*room.build().shapes, sensor]).shapes})
    table = study.table(room)
    starts = table.random_starts(10, seed=3)
    up, down = (study.section(table, cut, n=10, hits=8, seed=3) for cut in ("line", line[::-1]))
    world = table.world_of(starts)
    hits = world.run(up.seconds, up.seconds)
    first = int(world.balls.id[0])
    for orbit in range(10):
        times = np.sort(np.concatenate([one.time[one.orbit == orbit] for one in (up, down)]))
        mine = hits[hits["ball"] == first + orbit]
        entered = mine[mine["kind"] == carom.HitKind.ENTER]["time"]
        # The ball's edge comes to the line before its middle does.
        assert times == pytest.approx(entered, abs=5e-3)
    assert len(up.time) > 10


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.2, -0.3)])
def test_crossings_are_places_of_the_ways_between_hits(
    gravity: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ensembles, "BATCH", 3)
    square = scenes.rectangle(4.0, 3.0)
    square = square.model_copy(update={"world": square.world.model_copy(update={"gravity": gravity})})
    table, cut = study.table(square), np.array([(-1.0, -1.2), (1.5, 1.0)])
    found = study.section(table, cut, n=5, hits=6, seed=1, speed=2.0)
    way = (cut[1] - cut[0]) / hypot(*(cut[1] - cut[0]))
    normal = np.array([-way[1], way[0]])
    assert len(found.time) > 4
    world = table.world_of(table.random_starts(5, seed=1, speed=2.0))
    for number in np.argsort(found.time):
        rest = found.time[number] - world.time
        world.run(rest, rest)
        ball = world.balls[int(found.orbit[number])]
        assert ball.position == pytest.approx(cut[0] + found.distance[number] * way, abs=1e-9)
        assert ball.velocity == pytest.approx(found.along[number] * way + found.across[number] * normal, abs=1e-9)


@pytest.mark.compiled
def test_lines_are_crossed_as_often_and_as_evenly_as_the_measure_says() -> None:
    # L. A. Santaló, Integral geometry and geometric probability, 1976. In one mean free time hardly any orbit comes
    # twice, so that crossings are independent.
    table, cut = study.table("stadium"), ((-3.0, -1.0), (2.0, 1.5))
    found = study.section(table, cut, n=4000, hits=1, seed=4)
    length, count = hypot(5.0, 2.5), len(found.time)
    assert abs(count - 4000 * found.seconds * length / (pi * table.area)) < 4.0 * sqrt(count)
    for values, low, high in (
        (found.distance, 0.0, length),
        (found.along, -1.0, 1.0),
        (found.time, 0.0, found.seconds),
    ):
        uniform = (np.sort(values) - low) / (high - low)
        apart = np.abs(uniform - (np.arange(count) + 0.5) / count).max()
        assert apart * sqrt(count) < 1.95  # Kolmogorov and Smirnov: once in a thousand times more


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize(("radius", "width", "height"), [(2.0, 1.6, 2.0), (1.0, 0.5, 1.2)])
def test_the_share_of_order_in_a_mushroom_is_that_of_ways_which_pass_its_stem(
    radius: float, width: float, height: float
) -> None:
    # The floor of the cap is a mirror: in the whole disc a ball keeps its distance b from the middle at the nearest. If
    # that is more than half of the width it never comes to the stem, if it is less it almost surely does. At a distance
    # r, 4·acos(b/r) of the directions have more than b; this times π·r, from b to the radius, over 2π times the area.
    # L. A. Bunimovich, Chaos 11, 802, 2001; A. H. Barnett and T. Betcke, Chaos 17, 043125, 2007.
    half, n = 0.5 * width, 2000
    area = 0.5 * pi * radius**2 + width * height
    expected = (radius**2 * acos(half / radius) - half * sqrt(radius**2 - half**2)) / area
    mushroom = scenes.mushroom(radius, width, height)
    into_the_stem = study.section(mushroom, ((half, 0.0), (-half, 0.0)), n=n, hits=150, seed=3)
    share = 1.0 - len(np.unique(into_the_stem.orbit)) / n
    assert abs(share - expected) < 2.0 * sqrt(share * (1.0 - share) / n)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"cut": "lid"}, "cut must be the name of one segment in the scene, not 'lid'"),
        ({"cut": ((0, 0), (0, 0))}, "cut must have two ends apart"),
        ({"cut": ((0, 0), (0, float("nan")))}, "cut"),
        ({"cut": (0, 1)}, "cut"),
        ({"hits": 0}, "hits must be from 1"),
        ({"n": 0}, "n must be from 1"),
        ({"speed": -1.0}, "speed must be positive, not -1.0"),
        ({"cutt": 1}, "did you mean cut"),
    ],
)
def test_what_cannot_be_studied_is_refused(given: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        study.section(**({"scene": "circle", "cut": ((0, 0), (1, 0))} | given))


def test_crossings_are_as_many_in_each_bin_as_the_measure_of_phase_space_says() -> None:
    table = study.table("stadium")
    section = study.section(table, ((-0.3, -0.4), (0.5, 0.3)), n=1000, hits=40)
    found = section.density(bins=3)
    assert float(found.value.sum()) == pytest.approx(len(section.orbit) / (1000 * section.seconds))
    assert (found.first[-1], found.second.tolist()) == (pytest.approx(hypot(0.8, 0.7)), [-1.0, *found.second[1:3], 1.0])
    away = (found.value - hypot(0.8, 0.7) / (9.0 * pi * table.area)) / found.error
    assert abs(away).max() < 4.0
    assert 0.2 < np.mean(away * away) < 2.5
    with pytest.raises(carom.InvalidArgument, match="bins must be a whole number"):
        section.density(bins=2.5)  # type: ignore[arg-type]
