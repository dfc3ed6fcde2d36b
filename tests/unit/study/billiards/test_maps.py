"""Boundary maps are those of the laws that order keeps, and mean free paths are π times the area over the perimeter."""

from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import scenes, study
from tests.worlds import BILLIARDS, small_scene


def test_in_a_round_room_every_ball_keeps_its_angle_and_goes_on_by_it() -> None:
    found = study.boundary_map(scenes.circle(radius=1.0), n=20, hits=8, seed=4)
    assert np.ptp(found.sine, axis=1) == pytest.approx(np.zeros(20), abs=1e-11)
    # The chord of a ball with the sine s of its angle of incidence is seen from the middle by π - 2 asin s.
    step = np.mod(np.diff(found.arc_length, axis=1), 2.0 * pi)
    expected = np.mod(pi - 2.0 * np.arcsin(found.sine[:, :1]), 2.0 * pi)
    assert step == pytest.approx(np.broadcast_to(expected, step.shape), abs=1e-9)
    chord = 2.0 * np.sqrt(1.0 - found.sine[:, :1] ** 2)
    assert np.diff(found.time, axis=1) == pytest.approx(np.broadcast_to(chord, step.shape), abs=1e-4)


def momenta_about_foci(found: study.BoundaryMap, focus: float) -> np.ndarray[Any, Any]:
    """The products of the angular momenta about two foci, an orbit a row, from places and angles of hits."""
    places, tangents = found.table._at(found.arc_length.ravel())
    normals = np.column_stack((-tangents[:, 1], tangents[:, 0]))
    sine = found.sine.ravel()[:, None]
    velocity = sine * tangents - np.sqrt(1.0 - sine**2) * normals
    left, right = ((places[:, 0] - x) * velocity[:, 1] - places[:, 1] * velocity[:, 0] for x in (-focus, focus))
    product: np.ndarray[Any, Any] = (left * right).reshape(found.sine.shape)
    return product


def test_in_an_ellipse_the_product_of_two_momenta_is_kept() -> None:
    found = study.boundary_map(scenes.ellipse(6.0, 4.0, tolerance=1e-7), n=6, hits=6, seed=2)
    product = momenta_about_foci(found, sqrt(5.0))
    assert np.ptp(product, axis=1).max() < 1e-3  # points are balls of 3e-5, and the slope of arcs is off by less
    assert np.ptp(product) > 1.0


@pytest.mark.slow
@pytest.mark.compiled
def test_in_an_ellipse_of_arcs_the_product_of_two_momenta_is_kept_for_thousands_of_hits() -> None:
    # It is between -5 and 4. Arcs within 1e-9 of the axis have slopes within the power of 2/3 of that, 3e-6 or so.
    product = momenta_about_foci(study.boundary_map(scenes.ellipse(), n=30, hits=2000, seed=2), sqrt(5.0))
    assert np.abs(np.diff(product, axis=1)).max() < 2e-4
    assert np.ptp(product, axis=1).max() < 3e-3
    apart = np.abs(product[:, 0]) > 3e-3
    assert apart.sum() > 20
    # Who has passed between the foci always does, who has passed outside of them too.
    assert (np.sign(product[apart]) == np.sign(product[apart, :1])).all()
    coarse = momenta_about_foci(study.boundary_map(scenes.ellipse(tolerance=1e-5), n=30, hits=2000, seed=2), sqrt(5.0))
    assert np.median(np.ptp(coarse, axis=1)) > 30.0 * np.median(np.ptp(product, axis=1))


def test_a_map_starts_from_the_walls_or_from_anywhere_and_at_any_speed() -> None:
    wall = study.boundary_map("circle", n=5, hits=2, seed=1)
    fast = study.boundary_map("circle", n=5, hits=2, seed=1, speed=4.0)
    inside = study.boundary_map("circle", n=5, hits=2, seed=1, boundary=False)
    assert fast.sine == pytest.approx(wall.sine, abs=1e-9)
    assert 4.0 * fast.time == pytest.approx(wall.time, rel=1e-9)
    assert not np.allclose(inside.sine, wall.sine)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("name", ["sinai", "stadium", "mushroom"])
def test_a_map_keeps_the_measure_of_birkhoff(name: str) -> None:
    found = study.boundary_map(name, n=400, hits=50, seed=3)
    for hit in (0, 49):  # whatever the table, uniform starts stay uniform, so that each column of hits is a sample
        for values, low, high in (
            (found.sine[:, hit], -1.0, 1.0),
            (found.arc_length[:, hit], 0.0, found.table.perimeter),
        ):
            uniform = (np.sort(values) - low) / (high - low)
            apart = np.abs(uniform - (np.arange(400) + 0.5) / 400).max()
            assert apart * sqrt(400) < 1.95  # Kolmogorov and Smirnov: once in a thousand times more


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("name", [name for name in BILLIARDS if name != "wedge"])
def test_the_mean_free_path_is_pi_area_over_perimeter(name: str) -> None:
    # L. A. Santaló, 1976; N. Chernov, J. Stat. Phys. 88, 1, 1997.
    found = study.mean_free_path(small_scene(name), n=4000, hits=60, seed=11)
    assert abs(found.value - found.expected) < 4.0 * found.error
    # In a round room those near the wall hit so often that the error is largest, two thirds of a percent.
    assert 0.0 < found.error < 0.008 * found.expected


def test_the_mean_free_path_of_few_orbits_is_within_its_error() -> None:
    found = study.mean_free_path(scenes.rectangle(2.0, 1.0), n=40, hits=10, seed=3)
    assert found.expected == pytest.approx(pi * 2.0 / 6.0)
    assert abs(found.value - found.expected) < 4.0 * found.error < 0.4 * found.expected
    assert found.counts.shape == (40,)
    assert found.value == pytest.approx(10.0 * found.expected / found.counts.mean())
    assert found.paths.max() < sqrt(5.0)  # no flight is longer than the diagonal
    assert len(found.paths) == found.counts.sum() - 40


def test_hits_of_starts_from_the_walls_are_even_within_their_errors() -> None:
    found = study.boundary_map("mushroom", n=1000, hits=20).density(bins=4)
    assert found.value.sum() == pytest.approx(1.0)
    assert found.first.tolist() == pytest.approx(np.linspace(0.0, study.table("mushroom").perimeter, 5).tolist())
    assert found.second.tolist() == [-1.0, -0.5, 0.0, 0.5, 1.0]
    away = (found.value - 1.0 / 16.0) / found.error
    assert abs(away).max() < 4.0
    assert 0.3 < np.mean(away * away) < 2.0
    assert found.error.max() < 0.006


def test_the_error_of_a_density_is_how_the_orbits_differ() -> None:
    found = study.boundary_map("circle", n=30, hits=9, seed=2)
    density = found.density(bins=3)
    rows = np.clip((3.0 * found.arc_length / found.table.perimeter).astype(int), 0, 2)
    columns = np.clip((1.5 * (found.sine + 1.0)).astype(int), 0, 2)
    shares = [[np.mean((rows == k) & (columns == m), axis=1) for m in range(3)] for k in range(3)]
    assert density.value == pytest.approx(np.mean(shares, axis=2))
    assert density.error == pytest.approx(np.std(shares, axis=2, ddof=1) / sqrt(30))
    with pytest.raises(carom.InvalidArgument, match="bins must be from 1"):
        found.density(bins=0)


@pytest.mark.parametrize(
    ("study_of", "given", "told"),
    [
        (study.boundary_map, {"hits": 0}, "hits must be from 1"),
        (study.boundary_map, {"n": 0}, "n must be from 1"),
        (study.boundary_map, {"hitz": 5}, "did you mean hits"),
        (study.boundary_map, {"scene": "toy"}, r"scene must be a closed table; shapes\[\d+\] \('launch gate'\)"),
        (study.mean_free_path, {"n": 1}, "n must be from 2"),
        (study.mean_free_path, {"seed": 0.5}, "seed must be a whole number, not 0.5"),
        (study.mean_free_path, {"scene": "wedge"}, "scene must have no gravity, not 'wedge'"),
    ],
)
def test_what_cannot_be_studied_is_refused(study_of: Any, given: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        study_of(**({"scene": "circle"} | given))
