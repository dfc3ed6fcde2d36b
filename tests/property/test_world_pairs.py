"""The three broad phases find the same pairs at the same state, each once, wherever the balls are."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from carom.constants import CELL_SIDE
from tests.kernel_calls import Ball, ball_rows, found_pairs, pairs_found_ahead
from tests.strategies import numbers


@st.composite
def crowds(draw: st.DrawFn) -> list[Ball]:
    """Balls of radii over three orders of magnitude: anywhere, on cells' borders, in clusters, touching, far away."""
    largest = draw(st.sampled_from((1.0, 0.3, 7.7)))
    side = 2.0 * largest * CELL_SIDE
    width = draw(st.sampled_from((2.0, 10.0, 1000.0)))
    radii = st.one_of(st.just(largest), st.floats(0.0, 3.0).map(lambda power: largest * 10.0**-power))
    places = numbers(-width, width)
    balls: list[Ball] = [(draw(places), draw(places), largest)]
    for _ in range(draw(st.integers(1, 28))):
        radius = draw(radii)
        x, y, other = balls[draw(st.integers(0, len(balls) - 1))]
        how = draw(st.sampled_from(("anywhere", "border", "near", "touching", "same")))
        if how == "anywhere":
            x, y = draw(places), draw(places)
        elif how == "border":
            left, bottom = min(ball[0] for ball in balls), min(ball[1] for ball in balls)
            shift = st.sampled_from((0.0, radius, -radius, 0.5 * side))
            x = left + side * draw(st.integers(0, 5)) + draw(shift)
            y = bottom + side * draw(st.integers(0, 5)) + draw(shift)
        elif how == "near":
            x, y = x + draw(numbers(-1, 1)) * (radius + other), y + draw(numbers(-1, 1)) * (radius + other)
        elif how == "touching":
            x, y = x + draw(st.sampled_from((-1, 1))) * (radius + other), y + draw(st.sampled_from((-1, 0, 1))) * radius
        balls.append((x, y, radius))
    if draw(st.booleans()):
        balls.insert(draw(st.integers(0, len(balls))), (draw(st.sampled_from((1e9, -1e9))), draw(places), draw(radii)))
    return balls


@pytest.mark.slow
@given(crowds(), st.sampled_from((1, 2, 6, 9)))
@example([(0.0, 0.0, 1.0), (2.0, 2.0, 1.0), (1e9, -1e9, 1.0), (2.002, 0.0, 1.0)], 6)
def test_all_broad_phases_find_the_same_pairs_once(balls: list[Ball], levels: int) -> None:
    rows = ball_rows(balls)
    expected = found_pairs(rows, "brute")
    assert expected == [
        (i, j)
        for i in range(len(balls))
        for j in range(i + 1, len(balls))
        if max(abs(balls[i][0] - balls[j][0]), abs(balls[i][1] - balls[j][1])) <= balls[i][2] + balls[j][2]
    ]
    assert sorted(found_pairs(rows, "grid")) == expected
    assert sorted(found_pairs(rows, "quadtree", levels)) == expected


@given(st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=2, max_size=30))
def test_they_agree_on_a_lattice_of_cells_borders(places: list[tuple[int, int]]) -> None:
    side = 2.0 * CELL_SIDE
    rows = ball_rows([(side * x, side * y, 1.0) for x, y in places])
    expected = found_pairs(rows, "brute")
    assert sorted(found_pairs(rows, "grid")) == sorted(found_pairs(rows, "quadtree")) == expected


@pytest.mark.slow
@given(st.integers(0, 2**32), st.sampled_from(((1.0,), (1.0, 0.6), (1.0, 0.3), (1.0, 0.1, 0.01))), st.floats(1.0, 8.0))
def test_they_agree_on_crowds_of_balls_of_one_size_and_of_a_few(
    seed: int, sizes: tuple[float, ...], width: float
) -> None:
    rng = np.random.default_rng(seed)
    places = rng.uniform(-width, width, (30, 2)).tolist()
    rows = ball_rows([(x, y, radius) for (x, y), radius in zip(places, rng.choice(sizes, 30).tolist(), strict=True)])
    expected = found_pairs(rows, "brute")
    assert sorted(found_pairs(rows, "grid")) == sorted(found_pairs(rows, "quadtree")) == expected


@given(
    st.integers(0, 2**32), st.sampled_from(((1.0,), (1.0, 0.6))), st.sampled_from((1.0, 3.0, 8.0, 20.0, 1e3, 1e7))
)  # fmt: skip
def test_a_grid_that_is_laid_ahead_finds_them_too(seed: int, sizes: tuple[float, ...], width: float) -> None:
    rng = np.random.default_rng(seed)
    places = rng.uniform(-width, width, (30, 2)).tolist()
    places[1] = [places[0][0] + 1.9, places[0][1] - 0.1]
    rows = ball_rows([(x, y, radius) for (x, y), radius in zip(places, rng.choice(sizes, 30).tolist(), strict=True)])
    assert sorted(pairs_found_ahead(rows) or ()) == found_pairs(rows, "brute")


@settings(max_examples=25)
@given(st.integers(0, 2**32), st.sampled_from((3.0, 9.0, 40.0, 1e4)), st.sampled_from((0.0, 1.5)))
def test_the_grid_finds_all_pairs_of_balls_of_one_size(seed: int, width: float, spread: float) -> None:
    """Dense cells and cells that share their numbers; balls alone, and as many in a cell as `spread` brings there."""
    rng = np.random.default_rng(seed)
    places = np.repeat(rng.uniform(-width, width, (10, 2)), 4, axis=0) + rng.uniform(-spread, spread, (40, 2))
    if spread == 0.0:
        places = rng.uniform(-width, width, (40, 2))
    rows = ball_rows([(x, y, 1.0) for x, y in places.tolist()])
    assert sorted(found_pairs(rows, "grid")) == found_pairs(rows, "brute")


def test_the_grid_finds_the_only_pair_behind_two_others_in_the_next_cell() -> None:
    near = [(0.0, 0.0, 1.0), (1.9, 0.1, 1.0), (3.95, 0.1, 1.0), (3.95, 0.5, 1.0), (2.1, 0.9, 1.0)]
    # What stands behind them among the sorted balls is far off.
    rows = ball_rows([*near, *((x, 3.0, 1.0) for x in (20.0, 24.0, 28.0))])
    assert (1, 4) in found_pairs(rows, "brute")
    assert sorted(found_pairs(rows, "grid")) == found_pairs(rows, "brute")


@given(st.permutations(range(12)), st.sampled_from(("brute", "grid", "quadtree")))
def test_the_order_of_the_balls_does_not_change_the_pairs(order: list[int], phase: str) -> None:
    balls = [(0.9 * (k % 4), 0.7 * (k // 4), 0.5 if k % 3 else 0.05) for k in range(12)]
    shuffled = found_pairs(ball_rows([balls[k] for k in order]), phase)
    named = sorted(tuple(sorted((order[i], order[j]))) for i, j in shuffled)
    assert named == found_pairs(ball_rows(balls), "brute")


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
@pytest.mark.parametrize("balls", [[(5.0, 5.0, 1.0)], [(5.0, 5.0, 1.0)] * 9, [(0.0, 0.0, 1e-300), (0.0, 0.0, 1e300)]])
def test_they_find_all_pairs_of_what_lies_in_one_place(phase: str, balls: list[Ball]) -> None:
    assert len(found_pairs(ball_rows(balls), phase)) == len(balls) * (len(balls) - 1) // 2
