"""Balls in flight that lie on each other, for tests of the kernels of islands."""

from collections.abc import Iterable
from copy import deepcopy
from itertools import combinations

import numpy as np

from carom import World
from carom.rows.flight import NO_BALL
from carom.rows.island import BODY, ISLAND_CONTACT
from carom.rows.relation import LASTING, LYING
from carom.world.kernels.continuous.island import enlist, fill_body, fill_contacts, join
from carom.world.kernels.continuous.jolt import jolt
from carom.world.kernels.continuous.settling import settle
from carom.world.kernels.continuous.surfaces import gap_to_shape
from carom.world.kernels.step.relations import add_relation, find_relation
from carom.world.tables import Arrays
from tests.islands import Floats
from tests.kernel_calls import in_flight, near_tables

#: How far apart may be what touches.
NEAR = 1e-6


def pairs_of(arrays: Arrays, kind: int = LYING) -> set[tuple[int, int]]:
    """All relations of a kind, as each ball knows them."""
    balls, others = range(arrays.balls.count), max(arrays.balls.count, arrays.shapes.count)
    rows = arrays.balls.rows
    return {(i, j) for i in balls for j in range(others) if find_relation(arrays.relations, rows[i], kind, j)}


def is_symmetric(pairs: Iterable[tuple[int, int]]) -> bool:
    """Whether everybody who lies on another is lain on by that."""
    found = set(pairs)
    return found == {(j, i) for i, j in found}


def joined(arrays: Arrays, pairs: Iterable[tuple[int, int]]) -> Arrays:
    """The same, where these pairs of balls lie on each other, with room for an island of all."""
    links = list(pairs)
    arrays.extend_relations(4 * (len(links) + 8 * arrays.balls.count))
    arrays.island = np.zeros(arrays.balls.count, BODY), np.zeros(len(arrays.relations), ISLAND_CONTACT)
    for i, j in links:
        join(arrays.states[0], arrays.balls.rows, arrays.relations, i, j)
    return arrays


def heap(world: World) -> Arrays:
    """Balls in flight: those that touch lie on each other, and shapes that they touch hold them."""
    arrays = in_flight(world)
    rows, shapes = arrays.balls.rows, arrays.shapes.rows
    places, radii = world.balls.position, world.balls.radius
    near = [
        (i, j)
        for i, j in combinations(range(len(places)), 2)
        if np.hypot(*(places[i] - places[j])) <= (radii[i] + radii[j]) * (1 + NEAR)
    ]
    joined(arrays, near)
    for i in range(arrays.balls.count):
        for row in range(arrays.shapes.count):
            found = gap_to_shape(shapes[row], 0.0, float(rows[i]["x"]), float(rows[i]["y"]), float(radii[i]), 0.0, 0.0)
            if found is not None and found[0] <= NEAR * radii[i]:
                add_relation(arrays.states[0], arrays.relations, rows[i], i, LASTING, row)
    return arrays


def settled(arrays: Arrays, first: int = 0, second: int = NO_BALL, struck: bool = False) -> int:
    """The number of balls of an island that is solved now."""
    tables = *near_tables(arrays), arrays.flights, arrays.relations, arrays.island
    return settle(arrays.states[0], arrays.balls.rows, *tables, first, second, struck)


def jolted(arrays: Arrays, first: int = 0, second: int = NO_BALL, struck: bool = False) -> int:
    """The number of balls that fly on otherwise after an event of these."""
    tables = *near_tables(arrays), arrays.flights, arrays.relations, arrays.island
    return jolt(arrays.states[0], arrays.balls.rows, *tables, first, second, struck)


def taken_apart(arrays: Arrays, who: Iterable[int]) -> tuple[int, int]:
    """How many bodies and contacts an island of these balls has, which are listed; none is solved."""
    bodies, _contacts = arrays.island
    count = 0
    for i in who:
        count = enlist(arrays.flights, bodies, count, i)
    for k in range(count):
        i = int(bodies[k]["ball"])
        fill_body(arrays.states[0], arrays.balls.rows[i], arrays.flights[i], bodies[k])
        bodies[k]["core"] = 1
    tables = arrays.balls.rows, arrays.flights, arrays.shapes.rows, arrays.relations, arrays.island
    return count, fill_contacts(arrays.states[0], *tables, count)


def copied(arrays: Arrays) -> Arrays:
    """The same tables once more."""
    return deepcopy(arrays)


def velocities(arrays: Arrays) -> Floats:
    """The balls' velocities where their flights begin."""
    return np.stack([arrays.balls.used["vx"], arrays.balls.used["vy"]], axis=1)


def places(arrays: Arrays) -> Floats:
    """The balls' places where their flights begin."""
    return np.stack([arrays.balls.used["x"], arrays.balls.used["y"]], axis=1)


def accelerations(arrays: Arrays) -> Floats:
    """The balls' accelerations."""
    flights = arrays.flights[: arrays.balls.count]
    return np.stack([flights["ax"], flights["ay"]], axis=1)


def kinetic(arrays: Arrays) -> float:
    """The kinetic energy of all balls where their flights begin."""
    return float((arrays.balls.used["mass"] * (velocities(arrays) ** 2).sum(axis=1)).sum() / 2)


def impetus(arrays: Arrays) -> Floats:
    """The momentum of all balls where their flights begin."""
    found: Floats = arrays.balls.used["mass"] @ velocities(arrays)
    return found
