"""Tables have the areas and perimeters of the closed forms, and their starts are as the invariant measure has them."""

from math import acos, cos, hypot, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import scenes, study
from tests.worlds import BILLIARDS, small_scene

LENS = acos(1.0 / 3.0)

#: Area and perimeter of shipped billiards as they come, from the textbook's formulas.
CLOSED = {
    "annulus": (pi * (2.0**2 - 0.8**2), 2.0 * pi * 2.8),
    "circle": (4.0 * pi, 4.0 * pi),
    "lemon": (2.0 * 9.0 * LENS - 2.0 * sqrt(8.0), 2.0 * 2.0 * 3.0 * LENS),
    "lorentz": (1.15 * 1.15 * sqrt(3.0) - pi / 2.0, 2.0 * 1.15 * (1.0 + sqrt(3.0)) - 4.0 + pi),
    "mushroom": (2.0 * pi + 1.6 * 2.0, 2.0 * pi + 4.0 + 2.0 * 2.0),
    "rectangle": (24.0, 20.0),
    "sinai": (16.0 - pi, 16.0 + 2.0 * pi),
    "stadium": (16.0 + 4.0 * pi, 8.0 + 4.0 * pi),
    "wedge": (16.0, 8.0 + 8.0 * sqrt(2.0)),
}


@pytest.mark.parametrize("name", sorted(CLOSED))
def test_area_and_perimeter_are_those_of_the_closed_form(name: str) -> None:
    table = study.table(name)
    assert (table.area, table.perimeter) == pytest.approx(CLOSED[name], rel=1e-12)


def test_a_flower_is_triangles_and_sectors() -> None:
    table = study.table(scenes.flower(6, radius=1.0, distance=1.5))
    chord, side = sqrt(1.0 - (1.5 * sin(pi / 6)) ** 2), 1.5 * sin(pi / 6)
    corner = 1.5 * cos(pi / 6) + chord
    half = acos((corner * cos(pi / 6) - 1.5) / 1.0)
    area = 6.0 * (half + 1.5 * corner * sin(pi / 6))
    assert hypot(chord, side) == pytest.approx(1.0)
    assert table.area == pytest.approx(area, rel=1e-12)
    assert table.perimeter == pytest.approx(12.0 * half, rel=1e-12)


def test_an_ellipse_has_its_area_to_its_tolerance() -> None:
    table = study.table(scenes.ellipse(tolerance=1e-4))
    assert table.area == pytest.approx(6.0 * pi, abs=1e-4 * 6.0 * table.perimeter)
    assert abs(table.area / (6.0 * pi) - 1.0) > 1e-9  # arcs are not ellipses: a tolerance that is met by chance tells


def test_the_way_in_is_by_scene_by_name_or_by_table() -> None:
    table = study.table("sinai")
    assert study.table(table) is table
    again = study.table(scenes.sinai())
    assert (again.scene, again.area) == (table.scene, table.area)
    assert table.scene.balls == ()
    assert [len(loop.pieces) for loop in table.loops] == [4, 1]


@pytest.mark.parametrize(
    ("scene", "told"),
    [
        (3, "scene must be a Scene, the name of a shipped one, or a Table, not 3"),
        ("pinball", r"shapes\[7\] \('launch gate'\) is a gate, not 'pinball'"),
        (carom.Scene(name="x", shapes=[carom.Compound([carom.Circle((0, 0), 1)], (0, 0))]), r"shapes\[0\] is a comp"),
        (
            carom.Scene(shapes=[carom.Circle((0, 0), 1, motion="kinematic", velocity=(1, 0), name="a")]),
            r"'a'\) moves",
        ),
        (carom.Scene(world={"friction": 1.0}, shapes=[carom.Circle((0, 0), 1)]), "must have no friction"),
        (carom.Scene(shapes=[carom.Circle((0, 0), 1, sensor=True)]), "must have walls"),
    ],
)
def test_what_is_no_table_is_refused(scene: Any, told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        study.table(scene)


def test_a_name_that_is_none_is_refused() -> None:
    with pytest.raises(carom.SceneError, match="did you mean 'mushroom'"):
        study.table("mushrom")


def test_what_balls_do_not_bounce_off_is_no_wall() -> None:
    inside: dict[str, Any] = {"center": (0, 0), "radius": 0.5}
    extra = [
        carom.Circle(**inside, sensor=True),
        carom.Circle(**inside, can_collide=False),
        carom.Circle(**inside, collides_with=1),
        carom.Point((0.1, 0.1)),
    ]
    assert study.table(carom.Scene(shapes=[carom.Circle((0, 0), 1), *extra])).area == pytest.approx(pi)


def naive(name: str, x: float, y: float) -> bool:
    """Whether a place lies in a shipped table, from what its docstring says."""
    return {
        "annulus": hypot(x, y) < 2.0 and hypot(x - 0.6, y) > 0.8,
        "circle": hypot(x, y) < 2.0,
        "ellipse": hypot(x / 3.0, y / 2.0) < 1.0,
        "flower": any(hypot(x - 1.2 * cos(0.4 * pi * k), y - 1.2 * sin(0.4 * pi * k)) < 1.0 for k in range(5))
        or hypot(x, y) < 1.2 * cos(pi / 5),
        "lemon": hypot(abs(x) + 1.0, y) < 3.0,
        "lorentz": 0 < x < 1.15
        and 0 < y < 1.15 * sqrt(3)
        and hypot(x, y) > 1.0
        and hypot(x - 1.15, y - 1.15 * sqrt(3)) > 1.0,
        "mushroom": (hypot(x, y) < 2.0 and y > 0.0) or (abs(x) < 0.8 and -2.0 < y <= 0.0),
        "rectangle": abs(x) < 3.0 and abs(y) < 2.0,
        "sinai": max(abs(x), abs(y)) < 2.0 and hypot(x, y) > 1.0,
        "stadium": hypot(max(abs(x) - 2.0, 0.0), y) < 2.0,
        "wedge": abs(x) < y < 4.0,
    }[name]


@pytest.mark.parametrize("name", BILLIARDS)
def test_a_table_contains_what_it_says(name: str) -> None:
    table = study.table(scenes.ellipse(tolerance=1e-6) if name == "ellipse" else small_scene(name))
    points = np.random.default_rng(7).uniform(-4.2, 4.2, (4000, 2))
    told = table.contains(points)
    expected = [naive(name, x, y) for x, y in points.tolist()]
    assert told.tolist() == expected
    assert 30 < told.sum() < 3900


def test_starts_in_a_table_are_uniform_in_phase_space() -> None:
    table = study.table("mushroom")
    position, velocity = table.random_starts(20_000, seed=3)
    assert position.shape == velocity.shape == (20_000, 2)
    assert table.contains(position).all()
    # Shares of a binomial law, within four of its deviations.
    stem = 1.6 * 2.0 / table.area
    assert np.mean(position[:, 1] < 0.0) == pytest.approx(stem, abs=4.0 * sqrt(stem * (1 - stem) / 20_000))
    assert np.hypot(*velocity.T) == pytest.approx(np.ones(20_000), rel=1e-12)
    quarters = np.bincount(np.floor((np.arctan2(velocity[:, 1], velocity[:, 0]) + pi) / (pi / 4)).astype(int) % 8)
    assert np.abs(quarters / 20_000 - 0.125).max() < 4.0 * sqrt(0.125 * 0.875 / 20_000)
    # Direction and place have nothing to do with each other.
    assert abs(np.corrcoef(position[:, 1], velocity[:, 1])[0, 1]) < 4.0 / sqrt(20_000)


def test_starts_from_the_walls_are_uniform_in_arc_length_and_sine() -> None:
    table = study.table("sinai")
    position, velocity = table.random_starts(20_000, seed=5, boundary=True)
    assert table.contains(position).all()  # inside already, by the radius of an ensemble's balls
    on_disc = np.hypot(*position.T) < 1.1
    share = 2.0 * pi / table.perimeter
    assert on_disc.mean() == pytest.approx(share, abs=4.0 * sqrt(share * (1 - share) / 20_000))
    out = position[on_disc] / np.hypot(*position[on_disc].T)[:, None]
    assert ((out * velocity[on_disc]).sum(axis=1) > 0.0).all()
    sines = np.sort(out[:, 0] * velocity[on_disc, 1] - out[:, 1] * velocity[on_disc, 0])
    # Kolmogorov and Smirnov: the greatest difference to a uniform law, times the root of the number, is below 1.95 but
    # once in a thousand times.
    apart = np.abs(0.5 * (sines + 1.0) - np.arange(len(sines)) / len(sines)).max()
    assert apart * sqrt(len(sines)) < 1.95


@pytest.mark.parametrize("boundary", [False, True])
def test_under_gravity_all_starts_have_one_energy(boundary: bool) -> None:
    table = study.table(scenes.wedge(angle=0.5, height=4.0))
    position, velocity = table.random_starts(2000, seed=1, boundary=boundary, speed=6.0)
    energy = 0.5 * (velocity**2).sum(axis=1) + 9.8 * position[:, 1]
    assert energy == pytest.approx(np.full(2000, 18.0), rel=1e-4 if boundary else 1e-12)
    top = 18.0 / 9.8
    assert position[:, 1].max() < top
    # In the triangle below its top, half of the area lies above the height over the root of 2.
    if not boundary:
        assert np.mean(position[:, 1] > top / sqrt(2.0)) == pytest.approx(0.5, abs=4.0 * 0.5 / sqrt(2000))
    else:  # where the speed is v(y), a wall's part dy is left as often as v(y) says: the share below h is 1-(1-h)^1.5
        assert np.mean(position[:, 1] < 0.5 * top) == pytest.approx(1 - 0.5**1.5, abs=4.0 * 0.48 / sqrt(2000))


def test_starts_come_from_the_seed() -> None:
    table = study.table("stadium")
    one, same, other = (table.random_starts(50, seed=seed) for seed in (4, 4, 5))
    assert np.array_equal(one.position, same.position)
    assert np.array_equal(one.velocity, same.velocity)
    assert not np.array_equal(one.position, other.position)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"n": 0}, "n must be from 1"),
        ({"n": 1.5}, "n must be a whole number, not 1.5"),
        ({"n": 5, "seed": -1}, "seed must be from 0"),
        ({"n": 5, "speed": 0.0}, "speed must be positive, not 0.0"),
        ({"n": 5, "boundary": 1}, "boundary must be True or False, not 1"),
        ({"n": 5, "sped": 1}, "did you mean speed"),
    ],
)
def test_starts_that_cannot_be_are_refused(given: dict[str, Any], told: str) -> None:
    table = study.table("circle")
    for method in (table.random_starts, table.ensemble):
        with pytest.raises(carom.InvalidArgument, match=told):
            method(**given)


def test_points_are_asked_for() -> None:
    with pytest.raises(carom.InvalidArgument, match="points must be numbers of shape"):
        study.table("circle").contains([1.0, 2.0, 3.0])


def test_an_ensemble_is_the_table_with_balls_that_do_not_meet() -> None:
    table = study.table("sinai")
    world = table.ensemble(30, seed=2)
    assert world.detection == "continuous"
    assert np.array_equal(world.balls.position, table.random_starts(30, seed=2).position)
    assert not (world.balls.layer & world.balls.collides_with).any()
    hits = world.run(2.0)
    assert len(hits) > 10
    assert {hit.shape.name for hit in hits} == {"wall", "disc"}
