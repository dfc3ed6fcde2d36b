"""Paths: where a ball is on one, and one as it goes on, and is seen from elsewhere."""

import pytest

from carom.geometry.path import Path, Turning, is_straight, path_after, path_beside, path_from, place_on

THROWN = Path(1.0, 2.0, 3.0, 4.0, 0.0, -10.0)


def test_a_thrown_ball_is_on_its_parabola() -> None:
    assert place_on(THROWN, 0.0) == (1.0, 2.0)
    assert place_on(THROWN, 0.5) == (2.5, 2.75)


@pytest.mark.parametrize("time", [0.0, 0.25, 1.5])
def test_a_path_goes_on_as_it_would_have(time: float) -> None:
    rest = path_after(THROWN, time)
    assert (rest.vx, rest.vy) == (3.0, 4.0 - 10.0 * time)
    assert place_on(rest, 0.75) == pytest.approx(place_on(THROWN, time + 0.75), abs=1e-14)


def test_a_path_is_seen_from_a_place_and_from_what_travels() -> None:
    turning = Turning(7.0, 7.0, 2.0, -1.0, 5.0)
    assert path_from(THROWN, 1.0, 1.0) == (0.0, 1.0, 3.0, 4.0, 0.0, -10.0)
    assert path_beside(THROWN, turning) == (1.0, 2.0, 1.0, 5.0, 0.0, -10.0)


def test_a_pull_too_small_to_be_squared_is_none() -> None:
    assert not is_straight(THROWN)
    assert not is_straight(Path(0.0, 0.0, 0.0, 0.0, 1e-100, -1e-100))
    assert is_straight(Path(1.0, 2.0, 3.0, 4.0, 0.0, 0.0))
    assert is_straight(Path(1.0, 2.0, 3.0, 4.0, 1e-300, 0.0))
