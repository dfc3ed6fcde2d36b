"""Tracks: thinned to the points that matter, and cut into bands of age."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.draw.history.tracks import BANDS, Track, bands, distances_to_segment, thinned


def track_of(points: list[tuple[float, float]]) -> Track:
    """A track that reaches one point each second."""
    return Track(1, np.arange(float(len(points))), np.array(points))


def test_a_straight_way_is_two_points() -> None:
    thin = thinned(track_of([(x, 2.0 * x) for x in range(50)]), 1e-9)
    assert thin.points.tolist() == [[0, 0], [49, 98]]
    assert thin.times.tolist() == [0, 49]


def test_a_there_and_back_keeps_its_turning_point() -> None:
    thin = thinned(track_of([(0, 0), (1, 0), (2, 0), (1, 0), (0, 0)]), 0.1)
    assert [2, 0] in thin.points.tolist()


@given(st.lists(st.tuples(st.floats(-10, 10), st.floats(-10, 10)), min_size=1, max_size=60), st.floats(0.01, 3.0))
def test_no_point_left_out_is_farther_than_the_tolerance(points: list[tuple[float, float]], tolerance: float) -> None:
    track = track_of(points)
    thin = thinned(track, tolerance)
    kept = thin.times.astype(int).tolist()
    assert kept[0] == 0
    assert kept[-1] == len(points) - 1
    for first, last in pairwise(kept):
        between = track.points[first + 1 : last]
        assert (distances_to_segment(between, track.points[first], track.points[last]) <= tolerance).all()


def test_bands_cover_the_way_from_end_to_end_without_gaps() -> None:
    parts = list(bands(track_of([(0, 0), (7, 0), (10, 3)]), 0.0, 2.0))
    assert [band for band, _ in parts] == list(range(BANDS))
    for (_, before), (_, after) in pairwise(parts):
        assert before[-1].tolist() == pytest.approx(after[0].tolist())
    assert parts[0][1][0].tolist() == [0, 0]
    assert parts[-1][1][-1].tolist() == [10, 3]
    assert any(np.array_equal(point, (7, 0)) for _, part in parts for point in part)


def test_a_track_that_ends_early_is_in_the_older_bands_only() -> None:
    assert [band for band, _ in bands(track_of([(0, 0), (1, 0)]), 0.0, 4.0)] == [0, 1, 2]


@given(st.lists(st.tuples(st.floats(-10, 10), st.floats(-10, 10)), min_size=1, max_size=60), st.floats(0.01, 3.0))
def test_a_track_thinned_in_time_is_near_its_way_at_every_time(
    points: list[tuple[float, float]], tolerance: float
) -> None:
    track = track_of(points)
    thin = thinned(track, tolerance, in_time=True)
    for axis in (0, 1):
        there = np.interp(track.times, thin.times, thin.points[:, axis])
        assert (np.abs(there - track.points[:, axis]) <= tolerance * (1 + 1e-9)).all()


def test_points_of_one_time_are_kept_apart() -> None:
    track = Track(1, np.zeros(3), np.array([(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]))
    assert len(thinned(track, 0.1, in_time=True).times) == 3
