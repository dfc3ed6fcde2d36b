"""The ledger of an island's energy: frames, debts, work, and the share of forces that does none."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.rows.island import NO_BODY
from carom.world.kernels.continuous.ledger import (
    body_energy,
    contact_work,
    island_energy,
    take_energy,
    workless_share,
)
from tests.islands import body_rows, contact_rows


def test_energy_is_that_of_a_textbook_in_any_frame() -> None:
    bodies = body_rows([(1, 2), (3, 5)], [2.0, 3.0], velocities=[(1, 0), (0, -2)])
    assert body_energy(bodies[0], (0.5, -10), (0, 0)) == pytest.approx((1, 39))
    assert island_energy(bodies, 2, (0.5, -10), (0, 0)) == pytest.approx((7, 39 + 145.5))
    assert island_energy(bodies, 2, (0, 0), (0, -2)) == pytest.approx((5, 0))
    assert island_energy(bodies, 1, (0, 0), (0, 0)) == pytest.approx((1, 0))


@given(st.integers(0, 10**6), st.floats(-1, 3), st.floats(-2, 2))
def test_an_excess_comes_out_of_motion_and_the_rest_is_a_debt(seed: int, part: float, frame_speed: float) -> None:
    random, frame = np.random.default_rng(seed), (frame_speed, 1.0)
    bodies = body_rows(
        random.normal(size=(5, 2)), random.exponential(size=5) + 0.1, velocities=random.normal(size=(5, 2))
    )
    directions = np.stack([bodies["vx"] - frame[0], bodies["vy"] - frame[1]])
    kinetic, _ = island_energy(bodies, 5, (0, 0), frame)
    debt = take_energy(bodies, 5, part * kinetic, frame)
    left, _ = island_energy(bodies, 5, (0, 0), frame)
    assert left == pytest.approx(kinetic * min(1, max(0, 1 - part)), abs=1e-14 * kinetic)
    assert debt == pytest.approx(kinetic * max(0, part - 1), abs=1e-14 * kinetic)
    turned = np.stack([bodies["vx"] - frame[0], bodies["vy"] - frame[1]])
    assert np.abs(directions[0] * turned[1] - directions[1] * turned[0]).max() <= 1e-12
    assert ((directions * turned).sum(axis=0) >= 0).all()


def test_an_island_without_motion_owes_all_of_it() -> None:
    bodies = body_rows([(0, 0)])
    assert take_energy(bodies, 1, 2.0, (0, 0)) == 2
    assert (bodies["vx"][0], bodies["vy"][0]) == (0, 0)


@given(st.integers(0, 10**6))
def test_the_share_of_forces_does_no_work_beyond_that_of_movers(seed: int) -> None:
    random = np.random.default_rng(seed)
    bodies = body_rows(
        random.normal(size=(4, 2)), random.exponential(size=4) + 0.1, velocities=random.normal(size=(4, 2))
    )
    angles = random.uniform(0, 7, 5)
    ends = [(0, 1), (1, 2), (2, 3), (3, NO_BODY), (0, NO_BODY)]
    contacts = contact_rows([(*pair, np.cos(angle), np.sin(angle)) for pair, angle in zip(ends, angles, strict=True)])
    contacts["mean_bias"], contacts["impulse"] = random.normal(size=5), random.exponential(size=5)
    # What pulls each ball does so for half a second.
    bodies["gx"], bodies["gy"] = random.normal(size=(2, 4))

    def work_of(share: float) -> float:
        """The work of a share of the forces, from the ways that the balls go, relative to the shapes."""
        bodies["wx"], bodies["wy"] = bodies["vx"] + 0.5 * bodies["gx"], bodies["vy"] + 0.5 * bodies["gy"]
        for contact in contacts:
            for side, sign in (("first", 1), ("second", -1)):
                if contact[side] != NO_BODY:
                    body = bodies[contact[side]]
                    body["wx"] += sign * share * contact["impulse"] * contact["nx"] / body["mass"]
                    body["wy"] += sign * share * contact["impulse"] * contact["ny"] / body["mass"]
        return share * contact_work(bodies, contacts, 5)

    work = work_of(1.0)
    kinetic = bodies["mass"] * (bodies["wx"] ** 2 + bodies["wy"] ** 2 - bodies["vx"] ** 2 - bodies["vy"] ** 2) / 2
    fallen = bodies["mass"] * (
        bodies["gx"] * (bodies["vx"] + bodies["wx"]) / 4 + bodies["gy"] * (bodies["vy"] + bodies["wy"]) / 4
    )
    of_movers = -(contacts["impulse"] * contacts["mean_bias"])[3:].sum()
    assert work == pytest.approx(kinetic.sum() - fallen.sum() - of_movers, abs=1e-12)
    share = workless_share(work, bodies, 4, 0.5)
    assert 0 <= share <= 1
    assert work_of(share) <= 1e-12
    assert share == 1 or share == 0 or work_of(share) == pytest.approx(0, abs=1e-12)
