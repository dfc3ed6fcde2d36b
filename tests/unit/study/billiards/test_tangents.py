"""Tangent maps are those of balls that start beside each other, and their products those of one map after the other."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom import study
from carom.study.billiards.ensembles import batches
from carom.study.billiards.tables import Starts
from carom.study.billiards.tangents import FEW, impact_maps, products, times, walls_of

#: How far apart neighbours start. The rounding of places is as much as a part in 1e9 of it.
APART = 1e-6


def a_room() -> carom.Scene:
    """A table under gravity with walls of every kind, hollow and not, whose arcs a ball meets from both sides."""
    walls = [
        *carom.outlines.path("M -2 -1 L 2 -1 A 1.5 1.5 0 0 1 2 1.5 L 0.5 1.5 A 0.6 0.6 0 0 0 -0.7 1.5 L -2 1.5 Z"),
        carom.Circle((-0.4, -0.2), 0.4, solid=True),
    ]
    return carom.Scene(
        world={"gravity": (0.3, -0.9), "detection": "continuous"},
        shapes=[wall for wall in walls if wall.kind != "point"],
        guard=True,
    )


def test_changes_become_what_neighbours_show() -> None:
    table = study.table(a_room())
    begin = table.random_starts(8, seed=4, speed=4.0)
    beside = [np.zeros(4), *(sign * APART * way for way in np.eye(4) for sign in (1.0, -1.0))]
    states = np.concatenate([np.hstack(begin) + step for step in beside])
    (batch,) = batches(table, Starts(states[:, :2].copy(), states[:, 2:].copy()), 4.0)
    hits = batch.run(1.6)
    ends = np.hstack((batch.world.balls.position, batch.world.balls.velocity)).reshape(9, 8, 4)
    numbers, rows = batch.numbers(hits), hits.view(np.ndarray)
    walls, kinds = walls_of(batch.world, "scene"), set()
    for orbit in range(8):
        mine = rows[numbers == orbit]
        others = [rows[numbers == orbit + 8 * step]["shape"].tolist() for step in range(9)]
        assert others == [mine["shape"].tolist()] * 9
        kinds |= {shape.kind for shape in batch.world.shapes if shape.id in others[0]}
        maps = impact_maps(walls, mine, np.diff(mine["time"], prepend=0.0), 1e-5 * table.size)
        whole = np.eye(4)
        for number in range(len(mine)):
            whole = maps[:, :, number] @ whole
        last = np.eye(4)
        last[:2, 2:] = (1.6 - mine["time"][-1]) * np.eye(2)
        seen = (ends[1::2, orbit] - ends[2::2, orbit]).T / (2.0 * APART)
        # The squares of what grew, and the rounding of what did not.
        assert last @ whole == pytest.approx(seen, rel=1e-4, abs=1e-4 * np.abs(seen).max())
        assert np.linalg.det(whole) == pytest.approx(1.0, rel=1e-9)
    assert kinds == {"segment", "arc", "circle"}


def test_walls_that_move_make_of_changes_what_neighbours_show() -> None:
    cup = carom.Arc((-0.9, 0.2), 0.8, 2.0, 5.5, motion="kinematic", pivot=(-0.3, -0.9), angular_velocity=-0.9)
    wheel = carom.Circle((1.0, 0.6), 0.4, solid=True, motion="kinematic", pivot=(0.2, 0.6), angular_velocity=1.3)
    plank = carom.Segment((0.2, -0.9), (1.4, -1.2))
    cart = carom.Compound(
        [plank, carom.Point((1.4, -1.2))], pivot=(0.6, -0.8), velocity=(-0.3, 0.2), angular_velocity=0.7
    )
    world = carom.World(detection="continuous", gravity=(0.1, -0.5))
    world.add(*carom.outlines.rectangle(-2.0, -2.0, 2.0, 2.0), cup, wheel, cart)
    begin = np.array([[0.9, -0.4, 0.2, -1.5], [-0.5, 0.4, -1.4, 0.3], [0.2, 1.2, 1.3, -0.5], [0.3, -0.3, 1.2, 0.9]])
    beside = [np.zeros(4), *(sign * APART * way for way in np.eye(4) for sign in (1.0, -1.0))]
    states = np.concatenate([begin + step for step in beside])
    world.add_balls(states[:, :2], states[:, 2:], radius=0.05, layer=2, collides_with=1)
    first, walls = int(world.balls.id[0]), walls_of(world, "world")
    rows = world.run(1.5, 1.5).view(np.ndarray)
    ends = np.hstack((world.balls.position, world.balls.velocity)).reshape(9, 4, 4)
    met: set[str] = set()
    for orbit in range(4):
        mine = rows[rows["ball"] == first + orbit]
        assert all(
            rows["shape"][rows["ball"] == first + orbit + 4 * step].tolist() == mine["shape"].tolist()
            for step in range(9)
        )
        met |= {str(shape.kind) for shape in (cup, wheel, plank) if shape.id in mine["shape"]}
        whole = np.eye(4)
        for map_of in np.moveaxis(impact_maps(walls, mine, np.diff(mine["time"], prepend=0.0), 0.05), 2, 0):
            whole = map_of @ whole
        last = np.eye(4)
        last[:2, 2:] = (1.5 - mine["time"][-1]) * np.eye(2)
        seen = (ends[1::2, orbit] - ends[2::2, orbit]).T / (2.0 * APART)
        assert last @ whole == pytest.approx(seen, rel=1e-4, abs=1e-4 * np.abs(seen).max())
    assert met == {"arc", "circle", "segment"}


def test_a_point_turns_balls_as_a_circle_of_their_radius() -> None:
    table = study.table("mushroom")
    radius = 1e-5 * table.size
    (batch,) = batches(table, Starts(np.array([[0.8 - 0.3 * radius, 1.0]]), np.array([[0.0, -1.0]])), 1.0)
    hit = batch.run(1.1)[:1]
    assert hit[0].shape.kind == "point"
    maps = impact_maps(walls_of(batch.world, "scene"), hit.view(np.ndarray), np.zeros(1), radius)
    cosine = np.sqrt(1.0 - 0.3**2)
    # What a mirror of this curvature adds to that of a front: 2/(radius·cosine), Chernov and Markarian, 2006.
    across = np.array([1.0, 0.0])
    turned = maps[2:, :2, 0] @ across
    assert np.hypot(*turned) == pytest.approx(2.0 / (radius * cosine), rel=1e-3)


@given(counts=st.lists(st.integers(0, 9), min_size=1, max_size=5), seed=st.integers(0, 1000))
@settings(max_examples=12, deadline=None)
def test_products_are_those_of_one_after_the_other(counts: list[int], seed: int) -> None:
    maps = np.random.default_rng(seed).normal(size=(4, 4, sum(counts)))
    found, logs = products(maps.copy(), np.array(counts))
    begin = 0
    for orbit, count in enumerate(counts):
        expected = np.eye(4)
        for number in range(begin, begin + count):
            expected = maps[:, :, number] @ expected
        begin += count
        assert np.exp(logs[orbit]) * found[:, :, orbit] == pytest.approx(expected, rel=1e-9, abs=1e-9 * expected.max())
    vectors = np.random.default_rng(seed).normal(size=(4, 1, len(counts)))
    assert times(found, vectors) == pytest.approx(np.einsum("ijn,jkn->ikn", found, vectors))


def test_long_products_do_not_overflow() -> None:
    maps = np.repeat((1e9 * np.eye(4))[:, :, None], 100, axis=2)
    found, logs = products(maps, np.array([100]))
    assert found[:, :, 0] == pytest.approx(np.eye(4))
    assert logs[0] == pytest.approx(100.0 * np.log(1e9))


def test_many_matrices_are_multiplied_as_few_are() -> None:
    one, other = np.random.default_rng(1).normal(size=(2, 6, 6, FEW + 9))
    assert times(one, other) == pytest.approx(np.einsum("ijn,jkn->ikn", one, other))


@pytest.mark.parametrize("how", [{"elasticity": 0.9}, {"kick": 1.0}, {"once": True}])
def test_a_wall_that_takes_or_gives_speed_is_refused(how: dict[str, Any]) -> None:
    scene = carom.Scene(shapes=[carom.Circle((0, 0), 2), carom.Circle((0, 0), 1, solid=True, **how)])
    with pytest.raises(
        carom.InvalidArgument, match="scene must have walls of elasticity 1 that stay and do not kick, not Circle"
    ):
        study.lyapunov(scene, n=2, hits=10)
