"""An impact within an island: cradles, walls, momentum, and energy that never rises."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.constants import IMPACT_SHARE
from carom.rows.island import NO_BODY
from carom.world.kernels.continuous.spreading import end_approaches, resolve_impact, spread_impact
from tests.islands import body_rows, contact_rows, counts_of, kinetic_energy, momentum, pyramid, stack, touching


@pytest.mark.parametrize("count", [2, 3, 5, 12])
@pytest.mark.parametrize("shot", [1, 2, 5])
@pytest.mark.parametrize("speed", [0.0, 1e-3])
def test_as_many_balls_leave_a_cradle_as_have_come(count: int, shot: int, speed: float) -> None:
    shot = min(shot, count - 1)
    places = [(float(i), 0.0) for i in range(count)]
    bodies = body_rows(places, velocities=[(2.0 if i < shot else 0.0, 0.0) for i in range(count)])
    contacts = contact_rows(touching(places), elasticity=1.0)
    assert resolve_impact(bodies, contacts, counts_of(bodies, contacts), speed) <= 2e-6
    assert bodies["vx"] == pytest.approx([0.0] * (count - shot) + [2.0] * shot, abs=1e-12)
    assert (bodies["vy"] == 0).all()


def test_only_who_is_reached_is_told() -> None:
    places = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (5.0, 0.0), (6.0, 0.0)]
    bodies = body_rows(places, velocities=[(1, 0), (0, 0), (0, 0), (0, 0), (0, 0)])
    contacts = contact_rows(touching(places), elasticity=1.0)
    resolve_impact(bodies, contacts, counts_of(bodies, contacts), 0.0)
    assert bodies["reached"].tolist() == [1, 0, 1, 0, 0]


def test_a_slow_rebound_is_none_and_a_fast_one_is_as_elastic_as_the_contact() -> None:
    for speed, expected in ((0.4, 0.5), (0.6, 0.0)):
        bodies = body_rows([(0, 0)], velocities=(0, -1))
        contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)], elasticity=0.5)
        resolve_impact(bodies, contacts, (1, 1), speed)
        assert bodies["vy"][0] == pytest.approx(expected)
    contacts["elasticity"] = 1.5  # gives back what came, and no more
    bodies["vy"] = -1
    resolve_impact(bodies, contacts, (1, 1), 0.1)
    assert bodies["vy"][0] == 1


def test_a_moving_shape_throws_a_ball() -> None:
    bodies = body_rows([(0, 0)])
    contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)], elasticity=1.0)
    contacts["start_bias"] = -3.0
    resolve_impact(bodies, contacts, (1, 1), 0.1)
    assert bodies["vy"][0] == 6


@pytest.mark.slow
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.3, 0.9, 1.0]), st.sampled_from([0.0, 1e-3, 0.1]), st.booleans())
def test_momentum_stays_energy_never_rises_and_nothing_approaches(
    seed: int, elasticity: float, speed: float, walls: bool
) -> None:
    random = np.random.default_rng(seed)
    places, links = pyramid(int(random.integers(2, 5)))
    if not walls:
        links = touching(places)
    bodies = body_rows(places, 10 ** random.uniform(-1.5, 1.5, len(places)))
    struck = int(random.integers(len(places)))
    bodies["vx"][struck], bodies["vy"][struck] = random.normal(size=2)
    contacts = contact_rows(links, elasticity)
    energy, before = kinetic_energy(bodies), momentum(bodies)
    worst = resolve_impact(bodies, contacts, counts_of(bodies, contacts), speed)
    assert worst <= max(IMPACT_SHARE * speed, 1e-12)
    assert kinetic_energy(bodies) <= energy * (1 + 1e-14)
    if not walls:
        assert np.abs(momentum(bodies) - before).max() <= 1e-14 * np.abs(before).max() * len(links)


def test_a_blow_on_a_long_stack_ends() -> None:
    places, links = stack(100)
    bodies = body_rows(places)
    bodies["vy"][-1] = -1
    contacts = contact_rows(links, elasticity=1.0)
    assert resolve_impact(bodies, contacts, counts_of(bodies, contacts), 1e-3) <= 1e-6
    assert kinetic_energy(bodies) <= 0.5 * (1 + 1e-14)
    assert bodies["visits"].max() <= 64


@pytest.mark.parametrize(("weight", "expected"), [(1.0, 0.5), (1e3, 0.0)])
def test_what_presses_on_a_contact_takes_low_rebounds(weight: float, expected: float) -> None:
    # Of radius ½ and mass 1: under a pull of 1000 a rebound of ½ rises by 1.25e-4.
    bodies = body_rows([(0, 0)], velocities=(0, -1))
    contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)], elasticity=0.5)
    contacts["force"] = weight
    resolve_impact(bodies, contacts, (1, 1), 0.1)
    assert bodies["vy"][0] == pytest.approx(expected)


def test_contacts_that_give_an_impulse_are_told() -> None:
    places = [(0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (4.0, 0.0)]
    bodies = body_rows(places, velocities=[(1, 0), (0, 0), (0, 0), (0, 0)])
    contacts = contact_rows(touching(places))
    contacts["acted"] = 1
    least = spread_impact(bodies, contacts, counts_of(bodies, contacts), 0.01)
    assert least == IMPACT_SHARE * 0.01
    assert contacts["acted"].tolist() == [1, 0]
    assert bodies["reached"].tolist() == [1, 1, 0, 0]


def test_what_visits_have_left_is_ended_at_once() -> None:
    bodies = body_rows([(0, 0), (1, 0)], velocities=[(1, 0), (0, 0)])
    contacts = contact_rows(touching([(0, 0), (1, 0)]), elasticity=1.0)
    spread_impact(bodies, contacts, (2, 1), 10.0 / IMPACT_SHARE)
    assert bodies["vx"].tolist() == [1, 0]
    assert end_approaches(bodies, contacts, (2, 1), 1e-9) <= 1e-9
    assert bodies["vx"] == pytest.approx([0.5, 0.5])
    assert bodies["reached"].tolist() == [1, 1]
