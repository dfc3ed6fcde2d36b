"""Velocities and accelerations of islands: nothing approaches, energy is kept, hops are stopped, weights are borne."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.rows.island import NO_BODY
from carom.rows.tables import Rows
from carom.world.kernels.continuous.ledger import contact_work
from carom.world.kernels.continuous.resolve import adjust_accelerations, resolve_accelerations, resolve_velocities
from tests.islands import (
    body_rows,
    contact_rows,
    counts_of,
    jacobian,
    kinetic_energy,
    momentum,
    pyramid,
    stack,
    touching,
)


def falling(bodies: Rows) -> Rows:
    """Balls that gravity pulls down."""
    bodies["gy"] = -10
    return bodies


@pytest.mark.slow
@given(st.integers(0, 10**6), st.floats(0, 6))
def test_velocities_do_not_approach_and_no_energy_is_gained(seed: int, decades: float) -> None:
    random = np.random.default_rng(seed)
    places, links = pyramid(int(random.integers(1, 5)))
    bodies = body_rows(places, 10 ** random.uniform(-decades / 2, decades / 2, len(places)))
    bodies["vx"], bodies["vy"] = random.normal(size=(2, len(places)))
    contacts = contact_rows(links)
    energy = kinetic_energy(bodies)
    worst = resolve_velocities(bodies, contacts, counts_of(bodies, contacts), 1e-10)
    speeds = jacobian(bodies, contacts) @ np.stack([bodies["vx"], bodies["vy"]], axis=1).ravel()
    assert speeds.min() >= -worst - 1e-14
    assert kinetic_energy(bodies) <= energy * (1 + 1e-14)
    if decades < 3:
        assert worst <= 1e-9


def test_a_moving_shape_takes_balls_along() -> None:
    places, links = stack(3)
    bodies, contacts = body_rows(places), contact_rows(links)
    contacts["start_bias"][0] = -2.0
    assert resolve_velocities(bodies, contacts, (3, 3), 1e-12) <= 1e-12
    assert bodies["vy"] == pytest.approx([2, 2, 2])


@pytest.mark.parametrize("heavy", [1.0, 1e3])
@pytest.mark.parametrize("count", [1, 30])
def test_a_stack_at_rest_stays_and_bears_its_weight(count: int, heavy: float) -> None:
    places, links = stack(count)
    bodies = falling(body_rows(places, [1.0] * (count - 1) + [heavy]))
    contacts = contact_rows(links)
    for _ in range(2):  # from no forces, and from those found
        assert resolve_accelerations(bodies, contacts, (count, count), 0.01, 1e-11) <= 1e-10
        assert np.abs(bodies["ay"]).max() <= 1e-7
        assert contacts["force"] == pytest.approx(10 * np.cumsum(bodies["mass"][::-1])[::-1])


def test_gaps_close_by_the_end_of_a_tick_and_no_sooner() -> None:
    bodies = falling(body_rows([(0, 0.5001)], velocities=(3, -0.02)))
    contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)])
    contacts["gap"] = 1e-4
    resolve_accelerations(bodies, contacts, (1, 1), 0.01, 1e-13)
    assert bodies["vy"][0] * 0.01 + bodies["ay"][0] * 0.01**2 / 2 == pytest.approx(-1e-4)
    assert bodies["ax"][0] == 0


def test_pairs_part_freely_and_their_momentum_changes_by_gravity_alone() -> None:
    bodies = falling(body_rows([(0, 0), (1, 0), (2, 0)], [1.0, 2.0, 5.0], velocities=[(1, 0), (0, 0), (3, 0)]))
    contacts = contact_rows([(0, 1, 0.0, 0.0), (1, 2, 0.0, 0.0)])
    resolve_accelerations(bodies, contacts, (3, 2), 0.01, 1e-12)
    assert bodies["ax"][2] == 0
    assert bodies["ay"] == pytest.approx([-10] * 3)
    assert (bodies["mass"] * bodies["ax"]).sum() == pytest.approx(0, abs=1e-12)
    assert contacts["force"][0] > 0
    assert contacts["force"][1] == 0


def test_a_low_hop_is_stopped_and_a_high_one_goes_on() -> None:
    for speed, expected in ((0.01, 0.0), (0.2, 0.2)):
        bodies = falling(body_rows([(0, 0.5)], velocities=(1, speed)))
        contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)])
        resolve_accelerations(bodies, contacts, (1, 1), 0.01, 1e-9)
        assert (bodies["vx"][0], bodies["vy"][0]) == pytest.approx((1, expected), abs=1e-12)
        assert bodies["ay"][0] == pytest.approx(0 if expected == 0 else -10, abs=1e-9)


@pytest.mark.slow
@given(st.integers(0, 10**6))
def test_forces_do_no_work(seed: int) -> None:
    random = np.random.default_rng(seed)
    places, links = pyramid(3)
    bodies = falling(body_rows(places, 10 ** random.uniform(-1, 1, 6), velocities=random.normal(size=(6, 2))))
    contacts = contact_rows(links)
    contacts["force"] = random.exponential(size=len(contacts))
    counts = counts_of(bodies, contacts)
    resolve_velocities(bodies, contacts, counts, 1e-12)
    energy = kinetic_energy(bodies)
    resolve_accelerations(bodies, contacts, counts, 0.01, 1e-12)
    assert kinetic_energy(bodies) <= energy * (1 + 1e-14)
    bodies["wx"] = bodies["vx"] + 0.01 * bodies["ax"]
    bodies["wy"] = bodies["vy"] + 0.01 * bodies["ay"]
    # Those that are kept are those that act, so they are what the impulses of the tick are.
    contacts["impulse"] = 0.01 * contacts["force"]
    assert contact_work(bodies, contacts, len(contacts)) <= 1e-11 * (1 + energy)


@pytest.mark.slow
@given(st.integers(0, 10**6))
def test_where_forces_begin_does_not_matter(seed: int) -> None:
    random = np.random.default_rng(seed)
    places, links = pyramid(3)
    links = [link for link in links if link[2] not in (1.0, -1.0)]
    bodies, contacts = falling(body_rows(places, 10 ** random.uniform(-1, 1, 6))), contact_rows(links)
    found = []
    for force in (0.0, random.exponential(size=len(contacts)) * 30):
        contacts["force"] = force
        resolve_accelerations(bodies, contacts, counts_of(bodies, contacts), 0.01, 1e-13)
        found.append([bodies["ax"].copy(), bodies["ay"].copy()])
    assert np.array(found[0]) == pytest.approx(np.array(found[1]), abs=1e-8)


def test_a_part_of_an_island_goes_on_with_what_else_acts_on_it() -> None:
    places, links = stack(3)
    bodies, contacts = falling(body_rows(places)), contact_rows(links)
    resolve_accelerations(bodies, contacts, (3, 3), 0.01, 1e-12)
    before = momentum(bodies)
    # The upper two, without the floor; the topmost is struck.
    bodies["vy"][2] = -0.001
    assert adjust_accelerations(bodies, contacts[2:], (3, 1), 0.005, 1e-12) <= 1e-12
    assert bodies["ay"][0] == pytest.approx(0, abs=1e-10)
    assert bodies["ay"][2] == pytest.approx(0.2)
    assert bodies["ay"][1] == pytest.approx(-0.2)
    assert contacts["force"] == pytest.approx([30, 20, 10.2])
    assert before == pytest.approx([0, 0])


def test_whom_no_contact_changes_goes_on_to_the_bit() -> None:
    bodies = body_rows([(0, 0), (1, 0), (5, 0)], velocities=[(0, 0.1), (0, 0.1), (0.1, 0.3)])
    bodies["ax"], bodies["ay"] = (1.0, 0.0, 1 / 3), (0.0, 0.0, 1 / 7)
    contacts = contact_rows(touching([(0, 0), (1, 0)]))
    adjust_accelerations(bodies, contacts, (3, 1), 0.3, 1e-9)
    assert bodies["ax"][:2] == pytest.approx([0.5, 0.5])
    assert (bodies["ax"][2], bodies["ay"][2]) == (1 / 3, 1 / 7)
