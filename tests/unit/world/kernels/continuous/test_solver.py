"""The solver of contacts: its conditions, its twin, momentum, energy, and how far it gets with masses and chains."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.constants import SOLVER_ROUNDING, SOLVER_ROUNDS
from carom.rows.island import NO_BODY
from carom.rows.tables import Rows
from carom.world.kernels.continuous.relaxation import sweep
from carom.world.kernels.continuous.solver import descend, go_beyond, mark_loaded, set_free, solve_contacts, turn
from tests.fresh import printed
from tests.islands import (
    body_rows,
    contact_rows,
    counts_of,
    free,
    jacobian,
    kinetic_energy,
    momentum,
    pyramid,
    solved_slowly,
    stack,
)

#: What makes a random island: a seed, and how many balls and contacts.
recipes = st.tuples(st.integers(0, 2**32 - 1), st.integers(2, 40), st.integers(1, 60))


def island(recipe: tuple[int, int, int], shapes: bool = True, decades: float = 6.0) -> tuple[Rows, Rows]:
    """A random graph of contacts, some of them given twice or in parallel, which some velocities can open."""
    seed, balls, count = recipe
    random = np.random.default_rng(seed)
    bodies = body_rows(np.zeros((balls, 2)), 10 ** random.uniform(-decades / 2, decades / 2, balls))
    bodies["vx"], bodies["vy"] = random.normal(size=(2, balls))
    links = []
    for _ in range(count):
        first, second = (int(i) for i in random.choice(balls, 2, replace=False))
        angle = random.uniform(0, 2 * np.pi) if random.random() < 0.8 else random.integers(4) * np.pi / 2
        if shapes and random.random() < 0.3:
            second = NO_BODY
        links.append((first, second, np.cos(angle), np.sin(angle)))
        if random.random() < 0.1:
            links.append(links[-1])
    contacts = contact_rows(links[:count])
    # What some velocities meet has a solution; without shapes, so have those at rest.
    if shapes:
        contacts["bias"] = random.exponential(size=len(contacts)) - jacobian(bodies, contacts) @ random.normal(
            size=2 * balls
        )
    return bodies, contacts


def solve(bodies: Rows, contacts: Rows, rounds: int = SOLVER_ROUNDS, tolerance: float = 1e-10) -> float:
    free(bodies, contacts)
    return solve_contacts(bodies, contacts, counts_of(bodies, contacts), rounds, tolerance)


def attainable(contacts: Rows, tolerance: float = 1e-10) -> float:
    """The breach that is to be reached: the tolerance, or rounding of velocities if impulses are large."""
    return max(tolerance, 1.01 * SOLVER_ROUNDING * (contacts["impulse"] / contacts["effective_mass"]).max())


def speeds_after(bodies: Rows, contacts: Rows) -> np.ndarray:
    solved = np.stack([bodies["wx"], bodies["wy"]], axis=1).ravel()
    return np.asarray(jacobian(bodies, contacts) @ solved + contacts["bias"])


@pytest.mark.slow
@given(recipes)
def test_nothing_approaches_what_presses_does_not_part_and_nothing_pulls(recipe: tuple[int, int, int]) -> None:
    bodies, contacts = island(recipe)
    worst = solve(bodies, contacts)
    assert worst <= attainable(contacts)
    speeds = speeds_after(bodies, contacts)
    assert speeds.min() >= -worst - 1e-12
    assert contacts["impulse"].min() >= 0
    parting = np.minimum(speeds, contacts["impulse"] / contacts["effective_mass"])
    assert parting.max() <= worst + 1e-12


@pytest.mark.slow
@given(recipes)
def test_impulses_are_what_velocities_have_changed_by_and_never_pull(recipe: tuple[int, int, int]) -> None:
    bodies, contacts = island(recipe)
    solve(bodies, contacts)
    assert contacts["impulse"].min() >= 0
    change = jacobian(bodies, contacts).T @ contacts["impulse"] * np.repeat(bodies["inverse_mass"], 2)
    solved = np.stack([bodies["wx"] - bodies["vx"], bodies["wy"] - bodies["vy"]], axis=1).ravel()
    scale = np.abs(jacobian(bodies, contacts)).T @ contacts["impulse"] * np.repeat(bodies["inverse_mass"], 2)
    assert (np.abs(solved - change) <= 1e-12 * (1 + scale)).all()


@pytest.mark.slow
@given(recipes)
def test_it_agrees_with_a_slow_twin(recipe: tuple[int, int, int]) -> None:
    bodies, contacts = island(recipe, decades=2.0)
    assert solve(bodies, contacts, tolerance=1e-12) <= attainable(contacts)
    expected = solved_slowly(bodies, contacts)
    found = np.stack([bodies["wx"], bodies["wy"]], axis=1)
    difference = bodies["mass"][:, None] * (found - expected) ** 2
    assert difference.sum() <= 1e-20 * (1 + kinetic_energy(bodies))


@pytest.mark.slow
@given(recipes, st.integers(0, 3))
def test_without_shapes_momentum_stays_and_energy_never_rises(recipe: tuple[int, int, int], rounds: int) -> None:
    bodies, contacts = island(recipe, shapes=False)
    before, scale = momentum(bodies), (bodies["mass"] * (np.abs(bodies["vx"]) + np.abs(bodies["vy"]))).sum()
    energy = kinetic_energy(bodies)
    solve(bodies, contacts, rounds or SOLVER_ROUNDS)
    assert kinetic_energy(bodies, "wx", "wy") <= energy * (1 + 1e-14)
    bodies["vx"], bodies["vy"] = bodies["wx"], bodies["wy"]
    assert np.abs(momentum(bodies) - before).max() <= 1e-14 * scale


@pytest.mark.slow
@given(recipes, st.integers(1, 4))
def test_at_resting_shapes_energy_never_rises_wherever_it_is_cut_off(recipe: tuple[int, int, int], rounds: int) -> None:
    bodies, contacts = island(recipe)
    contacts["bias"] = 0
    energy = kinetic_energy(bodies)
    solve(bodies, contacts, rounds, 0.0)
    assert kinetic_energy(bodies, "wx", "wy") <= energy * (1 + 1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("heavy", [1.0, 1e3, 1e6])
@pytest.mark.parametrize("count", [3, 30, 100])
@pytest.mark.parametrize("falling", [True, False])
def test_stacks_under_a_heavy_ball_are_solved(count: int, heavy: float, falling: bool) -> None:
    places, links = stack(count)
    velocities = (0, -1) if falling else np.random.default_rng(1).normal(size=(count, 2))
    bodies = body_rows(places, [1.0] * (count - 1) + [heavy], velocities=velocities)
    contacts = contact_rows(links)
    assert solve(bodies, contacts, rounds=8) <= attainable(contacts)
    assert speeds_after(bodies, contacts).min() >= -attainable(contacts)
    if falling:
        assert np.abs(bodies["wy"]).max() <= 1e-7
        weights = np.cumsum(bodies["mass"][::-1])[::-1]
        assert contacts["impulse"] == pytest.approx(weights, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(("rows", "heavy"), [(7, 1.0), (7, 1e3), (10, 1.0)])
def test_pyramids_between_walls_are_solved_though_their_forces_are_not_unique(rows: int, heavy: float) -> None:
    places, links = pyramid(rows)
    bodies = body_rows(places, [1.0] * (len(places) - 1) + [heavy], velocities=(0, -1))
    contacts = contact_rows(links)
    assert solve(bodies, contacts, rounds=8) <= 1e-10
    assert np.hypot(bodies["wx"], bodies["wy"]).max() <= 1e-8


def test_where_two_shapes_close_on_a_ball_the_last_has_the_last_word() -> None:
    for last in (1.0, -1.0):
        bodies = body_rows([(0, 0)])
        contacts = contact_rows([(0, NO_BODY, -last, 0.0), (0, NO_BODY, last, 0.0)])
        contacts["bias"] = -3.0, 0.0
        assert solve(bodies, contacts) == pytest.approx(3)
        assert bodies["wx"][0] == 0
        assert np.isfinite(contacts["impulse"]).all()


def test_what_cannot_be_moved_and_what_does_not_last_takes_no_part() -> None:
    bodies = body_rows([(0, 0), (1, 0)], velocities=[(1, 0), (-1, 0)])
    bodies["inverse_mass"] = 0
    contacts = contact_rows([(1, 0, 1.0, 0.0)])
    assert solve(bodies, contacts) == 0
    bodies["inverse_mass"], contacts["lasting"] = 1, 0
    assert solve(bodies, contacts) == 0
    assert bodies["wx"].tolist() == [1, -1]


def test_given_impulses_are_taken_back_where_nothing_asks_for_them() -> None:
    bodies = body_rows([(0, 0), (1, 0)], [1.0, 3.0], velocities=[(-1, 0), (1, 0)])
    contacts = contact_rows([(1, 0, 1.0, 0.0)])
    free(bodies, contacts)
    contacts["impulse"] = 0.5
    bodies["wx"] += -0.5, 0.5 / 3
    assert solve_contacts(bodies, contacts, (2, 1), SOLVER_ROUNDS, 1e-12) <= 1e-12
    assert contacts["impulse"][0] == 0
    assert bodies["wx"] == pytest.approx([-1, 1])
    # One that may pull keeps the two together.
    free(bodies, contacts)
    contacts["holds"] = 1
    assert solve_contacts(bodies, contacts, (2, 1), SOLVER_ROUNDS, 1e-12) <= 1e-12
    assert bodies["wx"] == pytest.approx([0.5, 0.5])
    assert contacts["impulse"][0] == pytest.approx(-1.5)


@pytest.mark.parametrize("speed", [1e-300, 1e-160, 1e-30, 1e30, 1e160, 1e300])
def test_velocities_of_any_size_stay_finite_and_approach_less(speed: float) -> None:
    places, links = stack(5)
    bodies, contacts = body_rows(places, velocities=(0, -speed)), contact_rows(links)
    worst = solve(bodies, contacts, tolerance=1e-12 * speed)
    assert np.isfinite(bodies["wy"]).all()
    assert worst <= (1e-12 if 1e-100 < speed < 1e100 else 0.1) * speed


PROGRAM = """
from hashlib import blake2b
import numpy as np
from carom.compiler.door import load
from carom.world.kernels.continuous import places, resolve, spreading
from tests.islands import body_rows, contact_rows, counts_of, pyramid
random = np.random.default_rng(3)
found = blake2b()
for rows in range(2, 7):
    spots, links = pyramid(rows)
    spots = spots + random.uniform(-1e-3, 1e-3, spots.shape)
    bodies = body_rows(spots, 10 ** random.uniform(-1.5, 1.5, len(spots)), velocities=random.normal(size=spots.shape))
    contacts = contact_rows(links, 0.8)
    contacts["gap"], contacts["bend"] = random.uniform(-1e-3, 1e-3, len(links)), random.choice([0.0, 3.0, -3.0])
    bodies["gx"], bodies["gy"] = 0.1, -10.0
    counts = counts_of(bodies, contacts)
    results = [
        load(spreading.resolve_impact)(bodies, contacts, counts, 0.01),
        load(resolve.resolve_velocities)(bodies, contacts, counts, 1e-9),
        load(places.resolve_places)(bodies, contacts, counts),
        load(resolve.resolve_accelerations)(bodies, contacts, counts, 0.01, 1e-9),
        load(resolve.adjust_accelerations)(bodies, contacts, counts, 0.005, 1e-9),
    ]
    found.update(bodies.tobytes() + contacts.tobytes() + np.array(results).tobytes())
    print(found.hexdigest())
"""


@pytest.mark.slow
@pytest.mark.compiled
def test_the_same_bits_compiled_and_interpreted() -> None:
    compiled = printed(PROGRAM)
    assert compiled == printed(PROGRAM, NUMBA_DISABLE_JIT="1")
    assert len(compiled.split()) == 5


def dual(bodies: Rows, contacts: Rows) -> float:
    """What a solve minimises."""
    impulse = contacts["impulse"]
    change = jacobian(bodies, contacts).T @ impulse * np.repeat(bodies["inverse_mass"], 2)
    begun = np.stack([bodies["vx"], bodies["vy"]], axis=1).ravel()
    return float(impulse @ (jacobian(bodies, contacts) @ (begun + change / 2) + contacts["bias"]))


@given(recipes, st.floats(0, 3), st.booleans())
def test_a_step_beyond_its_limit_lowers_what_is_minimised_or_changes_nothing(
    recipe: tuple[int, int, int], decades: float, holds: bool
) -> None:
    bodies, contacts = island(recipe, decades=2.0)
    contacts["holds"][0] = holds
    free(bodies, contacts)
    counts = counts_of(bodies, contacts)
    set_free(bodies, contacts, counts)
    sweep(bodies, contacts, len(contacts))
    mark_loaded(contacts, len(contacts))
    slope = descend(bodies, contacts, counts, 0.0)
    bend, _, limit = turn(bodies, contacts, counts, 0.0)
    assume(min(slope, bend) > 1e-9)
    step = 10**decades * (limit if limit < np.inf else 1.0)
    before, impulse = dual(bodies, contacts), contacts["impulse"].copy()
    lowered = go_beyond(bodies, contacts, counts, step)
    assert contacts["impulse"][contacts["holds"] == 0].min(initial=0.0) >= 0.0
    if lowered:
        assert dual(bodies, contacts) <= before + 1e-12 * (1 + abs(before))
        expected = impulse + step * contacts["search"]
        expected[(expected < 0) & (contacts["holds"] == 0)] = 0.0
        assert (contacts["impulse"] == expected).all()
    else:
        # Up to twice the best step it is lowered wherever nothing loses its load.
        assert not step < min(limit, 2 * slope / bend) * (1 - 1e-9)
        assert (contacts["impulse"] == impulse).all()
    change = jacobian(bodies, contacts).T @ contacts["impulse"] * np.repeat(bodies["inverse_mass"], 2)
    solved = np.stack([bodies["wx"] - bodies["vx"], bodies["wy"] - bodies["vy"]], axis=1).ravel()
    assert np.abs(solved - change).max() <= 1e-11 * (1 + np.abs(change).max())


def test_many_contacts_lose_their_load_in_one_step() -> None:
    # A row of balls that lie on a floor and are thrown up, all but the last, one faster than the other.
    count = 40
    bodies = body_rows([(2.0 * i, 0.5) for i in range(count)])
    contacts = contact_rows([(i, NO_BODY, 0.0, 1.0) for i in range(count)])
    bodies["vy"] = np.arange(count, 0, -1) - 1.5
    free(bodies, contacts)
    contacts["impulse"] = 1.0
    bodies["wy"] += 1.0
    counts = counts_of(bodies, contacts)
    set_free(bodies, contacts, counts)
    mark_loaded(contacts, count)
    slope = descend(bodies, contacts, counts, 0.0)
    bend, _, limit = turn(bodies, contacts, counts, 0.0)
    assert limit < slope / bend
    assert go_beyond(bodies, contacts, counts, slope / bend)
    assert np.flatnonzero(contacts["impulse"]).tolist() == [count - 1]
