"""Orbits of an ensemble are those of balls that are alone, and their first hits are found whatever each needs."""

import numpy as np
import pytest

import carom
from carom import scenes, study
from carom.study.billiards import ensembles
from carom.study.billiards.ensembles import batches, first_hits
from carom.study.billiards.tables import Starts


def test_the_first_hits_are_those_of_a_ball_alone() -> None:
    table = study.table("sinai")
    starts = table.random_starts(6, seed=8)
    (batch,) = batches(table, starts, 1.0)
    time, along, sine = first_hits(batch, 4)
    assert time.shape == along.shape == sine.shape == (6, 4)
    for number in range(6):
        world = table.world_of(Starts(*(column[number : number + 1] for column in starts)))
        hits = world.run(60.0)[:4]
        assert hits["time"] == pytest.approx(time[number], abs=1e-9)
        walls, disc = world.shapes[:4], world.shapes[4]
        outlines = [walls, [disc]]
        for place, hit in enumerate(hits):
            outline = outlines[hit.shape is disc]
            begin = 16.0 if hit.shape is disc else 0.0
            _, one, part = hits[place : place + 1].boundary(outline)
            assert (begin + one[0], part[0]) == pytest.approx((along[number, place], sine[number, place]), abs=1e-9)


def test_a_ball_that_needs_longer_gets_its_hits(monkeypatch: pytest.MonkeyPatch) -> None:
    table = study.table(scenes.rectangle(width=8.0, height=0.5))
    starts = Starts(np.array([[0.0, 0.0], [0.0, 0.1]]), np.array([[1.0, 0.0], [0.0, 1.0]]))
    (batch,) = batches(table, starts, 1.0)
    time, _, sine = first_hits(batch, 5)
    assert time[0] == pytest.approx([4.0, 12.0, 20.0, 28.0, 36.0], abs=1e-3)
    assert time[1] == pytest.approx([0.15, 0.65, 1.15, 1.65, 2.15], abs=1e-3)
    assert np.abs(sine).max() < 1e-12


def test_an_ensemble_is_the_same_in_batches_of_any_size(monkeypatch: pytest.MonkeyPatch) -> None:
    one = study.boundary_map("circle", n=9, hits=3, seed=1)
    monkeypatch.setattr(ensembles, "BATCH", 4)
    other = study.boundary_map("circle", n=9, hits=3, seed=1)
    assert other.arc_length == pytest.approx(one.arc_length, abs=1e-9)
    assert other.sine.shape == (9, 3)


def test_a_ball_that_comes_to_rest_is_told() -> None:
    soft = [carom.Segment(a, b, elasticity=0.0) for a, b in (((0, 0), (1, 0)), ((1, 0), (0, 1)), ((0, 1), (0, 0)))]
    with pytest.raises(carom.InvalidArgument, match=r"scene must let balls bounce; one has done so .* times"):
        study.boundary_map(carom.Scene(shapes=soft), n=2, hits=50)


def test_a_hit_on_a_corner_is_where_its_walls_join() -> None:
    table = study.table("mushroom")
    # Straight up at the corner of cap and stem, a hair inside of the stem: met by the point, from below and beside.
    radius = 1e-5 * table.size
    start = Starts(np.array([[0.8 + 0.3 * radius, 1.0]]), np.array([[0.0, -1.0]]))
    (batch,) = batches(table, start, 1.0)
    hits = batch.run(1.1)
    assert hits[0].shape.kind == "segment"
    start = Starts(np.array([[0.8 - 0.3 * radius, 1.0]]), np.array([[0.0, -1.0]]))
    (batch,) = batches(table, start, 1.0)
    hits = batch.run(1.1)
    assert hits[0].shape.kind == "point"
    (along,), (sine,) = batch.boundary(hits[:1])
    lengths = [piece.wall.length for piece in table.loops[0].pieces]
    corner = [
        begin
        for begin, piece in zip(np.cumsum([0.0, *lengths]), table.loops[0].pieces, strict=False)
        if piece.ends[0] == pytest.approx((0.8, 0.0), abs=1e-9)
    ]
    assert along == pytest.approx(corner[0])
    # The point turns the ball as a circle of its radius does: .3 of it beside the middle.
    assert abs(sine) == pytest.approx(0.3, abs=1e-3)
