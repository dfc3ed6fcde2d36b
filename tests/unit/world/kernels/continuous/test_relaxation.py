"""Contacts one by one: their speed, their mass, and what a sweep leaves."""

import numpy as np
import pytest

from carom.rows.island import NO_BODY
from carom.world.kernels.continuous.relaxation import contact_speed, push, relax, sweep, weigh_contacts, worst_breach
from tests.islands import body_rows, contact_rows, free


def test_speeds_are_along_the_normal_and_relative_to_the_other_side() -> None:
    bodies = body_rows([(0, 0), (1, 0)], velocities=[(3, 4), (1, -1)])
    contacts = contact_rows([(0, 1, 0.6, 0.8), (0, NO_BODY, 0.0, 1.0)])
    contacts["bias"] = 0.5, -2.0
    free(bodies, contacts)
    assert [contact_speed(bodies, contact) for contact in contacts] == pytest.approx([0.5 + 1.2 + 4.0, 2.0])


def test_a_contact_moves_both_sides_by_their_masses() -> None:
    bodies = body_rows([(0, 0), (1, 0)], [1.0, 3.0])
    contacts = contact_rows([(0, 1, 1.0, 0.0), (1, NO_BODY, 0.0, 1.0)])
    free(bodies, contacts)
    assert contacts["effective_mass"] == pytest.approx([0.75, 3])
    push(bodies, contacts[0], 6.0)
    assert bodies["wx"].tolist() == [6, -2]
    contacts["lasting"] = 0
    weigh_contacts(bodies, contacts, 2, False)
    assert contacts["effective_mass"].tolist() == [0, 0]
    weigh_contacts(bodies, contacts, 2, True)
    assert contacts["effective_mass"] == pytest.approx([0.75, 3])


@pytest.mark.parametrize(("speed", "holds", "impulse"), [(-2.0, 0, 1.5), (2.0, 0, 0.0), (2.0, 1, -1.5)])
def test_one_contact_is_met_at_once(speed: float, holds: int, impulse: float) -> None:
    bodies = body_rows([(0, 0), (1, 0)], [1.0, 3.0], velocities=[(speed, 0), (0, 0)])
    contacts = contact_rows([(0, 1, 1.0, 0.0)])
    contacts["holds"] = holds
    free(bodies, contacts)
    worst, _ = worst_breach(bodies, contacts, 1)
    assert worst == (0 if impulse == 0 else 2)
    relax(bodies, contacts[0])
    assert contacts["impulse"][0] == pytest.approx(impulse)
    assert worst_breach(bodies, contacts, 1)[0] == pytest.approx(0, abs=1e-15)


def test_a_breach_is_no_more_than_what_an_impulse_holds_back() -> None:
    bodies = body_rows([(0, 0)], velocities=(5, 0))
    contacts = contact_rows([(0, NO_BODY, 1.0, 0.0)])
    free(bodies, contacts)
    contacts["impulse"] = 0.25
    assert worst_breach(bodies, contacts, 1) == (0.25, pytest.approx(0.25e-15))


def test_sweeps_come_nearer_and_the_last_contact_is_met_exactly() -> None:
    random = np.random.default_rng(5)
    bodies = body_rows([(i, 0) for i in range(20)], velocities=random.normal(size=(20, 2)))
    contacts = contact_rows([(i, i + 1, -1.0, 0.0) for i in range(19)])
    free(bodies, contacts)
    breaches = []
    for _ in range(30):
        sweep(bodies, contacts, 19)
        breaches.append(worst_breach(bodies, contacts, 19)[0])
        assert contact_speed(bodies, contacts[18]) >= -1e-15
    assert breaches[-1] < 0.1 * breaches[0]
