"""Exponents of a run are those of its table, 0 without chaos, and carried as balls that start beside others show."""

from collections.abc import Callable
from functools import partial
from math import exp
from typing import Any

import numpy as np
import pytest

import carom
from carom import study
from carom.study.billiards.running import _before, _histories, _ManyBalls
from carom.study.billiards.tangents import walls_of
from tests.worlds import continuous_world


def room(*members: Any, **settings: Any) -> carom.World:
    """A world of the continuous mode: a square room from (-2, -2) to (2, 2), and what stands in it."""
    return continuous_world(*carom.outlines.rectangle(-2.0, -2.0, 2.0, 2.0), *members, **settings)


def test_a_change_of_several_balls_becomes_what_neighbours_show() -> None:
    apart, seconds = 1e-6, 3.0
    begin = np.array([[-1.0, -1.0, 3.0, 0.8], [0.2, 0.1, -2.0, -2.4], [1.2, -0.6, -1.6, 2.2]])

    def run(change: np.ndarray[Any, Any]) -> carom.World:
        mill = carom.Segment((-1.5, 1.2), (-0.5, 1.3), motion="kinematic", pivot=(-1.2, 1.2), angular_velocity=1.2)
        balls = [
            carom.Ball(tuple(x), radius, velocity=tuple(v), mass=mass)
            for x, v, radius, mass in zip(
                *np.split(begin + change, 2, axis=1), (0.4, 0.3, 0.35), (1, 2, 0.7), strict=True
            )
        ]
        return room(mill, *balls, gravity=(0.2, -0.7))

    world, change = run(np.zeros((3, 4))), _ManyBalls(3, seconds)
    first = change._change.copy()
    (grown,), hits = change.carried(world, walls_of(world, "world"))
    ends = []
    for sign in (1.0, -1.0):
        beside = run(sign * apart * first)
        met = beside.run(seconds, seconds)
        ends.append(np.hstack((beside.balls.position, beside.balls.velocity)))
    assert len(met) == hits > 6
    assert {"segment", "ball"} <= {hit.shape.kind for hit in met}
    seen = (ends[0] - ends[1]) / (2.0 * apart)
    assert exp(grown) * change._change == pytest.approx(seen, rel=1e-4, abs=1e-4 * np.abs(seen).max())


def test_how_fast_balls_meet_is_told_for_every_pair() -> None:
    generator = np.random.default_rng(2)
    places = [(0.9 * (place % 3) - 0.9, 0.9 * (place // 3) - 0.9) for place in range(9)]
    balls = [
        carom.Ball(place, 0.3, velocity=tuple(generator.normal(size=2)), mass=mass)
        for place, mass in zip(places, generator.uniform(0.5, 2.0, 9).tolist(), strict=True)
    ]
    world = room(*balls, gravity=(0.0, -1.0))
    ids, mass, velocity = np.array(world.balls.id), world.balls.mass.copy(), world.balls.velocity.copy()
    rows = world.run(4.0, 4.0).view(np.ndarray)
    pairs = np.isin(rows["shape"], ids)
    first, second = np.searchsorted(ids, rows["ball"]), np.where(pairs, np.searchsorted(ids, rows["shape"]), -1)
    apart, flights = _histories(rows, first, second, mass, velocity, 0.0, np.array([0.0, -1.0]))
    assert pairs.sum() > 30
    assert np.hypot(*apart) == pytest.approx(rows["speed"][pairs])
    across = np.sum(apart.T * rows["normal"][pairs], axis=1)
    one, other = mass[first[pairs]], mass[second[pairs]]
    assert -2.0 * across * one * other / (one + other) == pytest.approx(rows["impulse"][pairs])
    for ball in range(9):  # the flights of each end where it hits, one after the other
        mine = (first == ball) | (second == ball)
        lasted = [
            flight[0] if one == ball else flight[1]
            for one, flight in zip(first, zip(*flights, strict=True), strict=True)
        ]
        assert np.cumsum(np.array(lasted)[mine]) == pytest.approx(rows["time"][mine])


@pytest.mark.parametrize("length", [0, 1, 7, 60])
def test_velocities_of_second_balls_are_reckoned_one_after_the_other_to_the_last_bit(length: int) -> None:
    generator = np.random.default_rng(length)
    # Chains of impacts in which a ball is always the second: many of up to a few, and one that is long.
    former = np.arange(200)
    free = np.flatnonzero(former % 5 == 0)
    former = np.where(former % 5 == 0, former, former - 1)
    places = np.setdiff1d(np.arange(200), free)
    former, places = np.append(former[places], np.arange(200, 200 + length)), np.append(places, 201 + np.arange(length))
    after = generator.normal(size=(2, 201 + length))
    falls, pushes = generator.normal(size=(2, 2, len(places)))
    found, noted = _before(after.copy(), former, places, falls, pushes), after.copy()
    for number, (place, earlier) in enumerate(zip(places, former, strict=True)):
        expected = noted[:, earlier] + falls[:, number]
        noted[:, place] = expected - pushes[:, number]
        assert found[:, number].tolist() == expected.tolist()


@pytest.mark.parametrize("turn", [0.0, 0.8])
def test_in_a_round_room_that_stands_or_turns_there_is_no_chaos(turn: float) -> None:
    world = continuous_world(
        carom.Circle((0.0, 0.0), 2.0, motion="kinematic", angular_velocity=turn),
        carom.Ball((0.5, 0.2), 0.1, velocity=(0.4, 1.1)),
    )
    found = study.lyapunov_of(world, 300.0)
    assert (np.abs(found.spectrum) < 1.5 * found.error).all()
    assert found.seconds == pytest.approx(225.0)
    assert world.time == pytest.approx(300.0)
    assert 50 < found.hits < 150


def cell(turn: float = 0.0) -> carom.World:
    """A cell of the triangular gas with one small ball; a mirror far away may turn, and nothing else."""
    world = study.table("lorentz").ensemble(1, seed=5)
    world.add(carom.Segment((8, 8), (9, 9), motion="kinematic", angular_velocity=turn))
    return world


def heavy_ball() -> carom.World:
    """Sinai's billiard with a ball in place of the disc, so heavy that it stays where it is."""
    heavy = carom.Ball((0, 0), 1.0, mass=1e14)
    return room(heavy, carom.Ball((1.5, 1.4), 1e-4, velocity=(0.6, 0.8)))


@pytest.mark.compiled
@pytest.mark.parametrize(
    ("make", "seconds", "name"),
    [(cell, 900.0, "lorentz"), (partial(cell, 1.0), 900.0, "lorentz"), (heavy_ball, 3e3, "sinai")],
)
def test_one_orbit_shows_what_many_of_a_table_do(make: Callable[[], carom.World], seconds: float, name: str) -> None:
    found, table = study.lyapunov_of(make(), seconds), study.lyapunov(name, n=40, hits=200, seed=1)
    error = float(np.hypot(found.error[0], table.error[0]))
    assert abs(found.spectrum[0] - table.spectrum[0]) < 2.0 * error < 0.1 * table.spectrum[0]
    if name == "sinai":
        assert found.spectrum.shape == found.error.shape == (1,)
    else:
        # Without a wall that moves two are 0 as energy is kept; the other way is seen to come to the same.
        assert abs(found.spectrum[1]) < 2.0 * found.error[1] < 0.01
        assert found.spectrum.tolist() == [*found.spectrum[:2], -found.spectrum[1], -found.spectrum[0]]


def discrete() -> carom.World:
    """A world of the discrete mode."""
    return carom.World(detection="discrete")


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: 5, "world must be a World, not 5"),
        (discrete, "world must be of the continuous mode"),
        (room, "world must hold a ball"),
        (lambda: room(carom.Ball((0, 0), 0.1, elasticity=0.5)), "world must have balls of elasticity 1"),
        (lambda: room(carom.Ball((0, 0), 0.1, friction=0.5)), "world must have no friction"),
        (lambda: room(carom.Ball((0, 0), 0.1), friction=0.5), "world must have no friction"),
        (lambda: room(carom.Ball((0, 0), 0.1), sleep_speed=0.5), "world must have no sleep_speed"),
        (lambda: room(carom.Ball((0, 0), 0.1), max_speed=9.0), "world must have no max_speed"),
        (lambda: room(carom.Ball((0, 0), 0.1), carom.Circle((1, 1), 0.2, kick=1.0)), "must have walls of elasticity 1"),
        (
            lambda: continuous_world(
                carom.Ball((0, 0), 0.1, velocity=(1, 0)), bounds=(-1, -1, 1, 1), remove_strays=True
            ),
            "world must keep its balls",
        ),
    ],
)
def test_a_world_that_cannot_be_followed_is_refused(make: Callable[[], Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        study.lyapunov_of(make(), 10.0)


def test_misspelt_and_senseless_arguments_are_refused() -> None:
    with pytest.raises(carom.InvalidArgument, match="seconds must be positive, not 0"):
        study.lyapunov_of(cell(), 0.0)
    with pytest.raises(carom.UnknownName, match="did you mean seconds"):
        study.lyapunov_of(cell(), second=1.0)  # type: ignore[call-arg]
