"""Responses: worked bounces and exchanges."""

from math import sqrt

import pytest

from carom.geometry import response


def test_a_ball_reflects_along_the_normal() -> None:
    assert response.reflected(3.0, -4.0, 0.0, 0.0, 0.0, 1.0, 1.0, -4.0, 0.0, False) == (3.0, 4.0, 8.0)
    assert response.reflected(3.0, -4.0, 0.0, 0.0, 0.0, 1.0, 0.5, -4.0, 0.0, False) == (3.0, 2.0, 6.0)
    assert response.reflected(3.0, -4.0, 0.0, 0.0, 0.0, 1.0, 0.0, -4.0, 0.0, False) == (3.0, 0.0, 4.0)


def test_a_surface_that_swings_adds_its_speed_once_and_elasticity_times() -> None:
    assert response.reflected(0.0, -4.0, 0.0, 2.0, 0.0, 1.0, 1.0, -6.0, 0.0, False) == (0.0, 8.0, 12.0)
    assert response.reflected(0.0, -4.0, 9.0, 2.0, 0.0, 1.0, 0.5, -6.0, 0.0, False) == (0.0, 5.0, 9.0)


def test_a_kick_adds_to_a_slow_ball_as_to_a_fast_one() -> None:
    assert response.reflected(1.0, -0.5, 0.0, 0.0, 0.0, 1.0, 0.0, -0.5, 7.0, False) == (1.0, 7.0, 7.5)
    assert response.reflected(1.0, -0.5, 0.0, 0.0, 0.0, 1.0, 0.0, -0.5, 7.0, True) == (0.0, 7.0, 7.5)


def test_the_total_rule_scales_the_whole_relative_velocity() -> None:
    assert response.reflected(3.0, -4.0, 0.0, 0.0, 0.0, 1.0, 0.5, -4.0, 0.0, True) == (1.5, 2.0, 6.0)
    assert response.reflected(3.0, -4.0, 1.0, 2.0, 0.0, 1.0, 0.5, -6.0, 0.0, True) == (2.0, 5.0, 9.0)


def test_an_approach_at_contact_is_that_of_the_fall_so_far() -> None:
    assert response.approach_at_contact(-5.0, -10.0, 0.8) == -3.0
    assert response.approach_at_contact(-3.0, 10.0, 0.8) == -5.0
    assert response.approach_at_contact(-1.0, -10.0, 0.8) == 0.0


def test_a_ball_that_leaves_or_feels_no_gravity_keeps_its_speed_to_the_bit() -> None:
    assert response.approach_at_contact(2.5, -10.0, 0.8) == 2.5
    assert response.approach_at_contact(0.0, -10.0, 0.8) == 0.0
    assert response.approach_at_contact(-1e-200, 0.0, 0.8) == -1e-200
    assert response.approach_at_contact(-0.1, 3.0, 0.0) == -0.1


def test_the_height_of_a_bounce_does_not_depend_on_how_deep_it_is_found() -> None:
    # Dropped from 1 under gravity 10, found at several depths: the speed at contact is always sqrt(20).
    for setback in (0.0, 1e-9, 0.01, 0.2):
        speed = -sqrt(2.0 * 10.0 * (1.0 + setback))
        assert response.approach_at_contact(speed, -10.0, setback) == pytest.approx(-sqrt(20.0), rel=1e-15)


def test_balls_of_newtons_cradle_swap_velocities_exactly() -> None:
    assert response.exchanged(0.3, -0.7, 1.1, 1.1, 1.0) == (-0.7, 0.3)
    assert response.exchanged(0.1, 0.0, 3.0, 3.0, 1.0) == (0.0, 0.1)


def test_a_heavy_ball_at_rest_is_a_wall() -> None:
    u1, u2 = response.exchanged(1.0, 0.0, 1.0, 1e300, 1.0)
    assert u1 == -1.0
    assert u2 == pytest.approx(2e-300)


def test_an_inelastic_pair_goes_on_as_one() -> None:
    u1, u2 = response.exchanged(4.0, -2.0, 1.0, 2.0, 0.0)
    assert u1 == u2 == pytest.approx(0.0, abs=1e-15)
    assert response.exchanged(3.0, 1.0, 1.0, 1.0, 0.5) == (1.5, 2.5)


def test_the_lighter_of_two_overlapping_balls_moves_farther() -> None:
    assert response.separated(0.0, 0.0, 3.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.4) == pytest.approx((-0.1, 0.0, 1.3, 0.0))


def test_by_a_normal_of_any_length_a_ball_rebounds_as_it_is_reflected() -> None:
    for length in (1.0, 0.25, 8.0, 1e-200, 1e200):
        assert response.rebounded(3.0, -4.0, 0.0, 0.0, 0.0, length, 1.0, 0.0, False) == (3.0, 4.0, 8.0)
        assert response.rebounded(3.0, -4.0, 1.0, 2.0, 0.0, length, 0.5, 0.0, True) == (2.0, 5.0, 9.0)
        assert response.rebounded(1.0, -0.5, 0.0, 0.0, 0.0, length, 0.0, 7.0, False) == (1.0, 7.0, 7.5)
        assert response.rebounded(0.0, -4.0, 9.0, 2.0, 0.0, length, 0.5, 0.0, False) == (0.0, 5.0, 9.0)
    assert response.rebounded(3.0, -4.0, 0.0, 0.0, 0.0, 0.0, 1.0, 9.0, True) == (3.0, -4.0, 0.0)
