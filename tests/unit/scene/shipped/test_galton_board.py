"""Galton's board: its pegs, bins and hopper are where balls find them, for every number of rows and balls."""

from itertools import pairwise
from math import comb, hypot, pi, sqrt

import numpy as np
import pytest

import carom
from carom.scene.shape_descriptors import CircleDescriptor, SegmentDescriptor
from carom.scene.shipped import galton_board as board
from carom.scene.shipped.galton_board import galton

SIZES = pytest.mark.parametrize(("rows", "balls"), [(1, 1), (2, 30), (7, 200), (12, 1000), (30, 10)])


def peg_rows(scene: carom.Scene) -> list[list[float]]:
    """Where the pegs of each row stand, the highest row first."""
    pegs = [shape for shape in scene.shapes if isinstance(shape, CircleDescriptor)]
    heights = sorted({peg.center[1] for peg in pegs}, reverse=True)
    return [sorted(peg.center[0] for peg in pegs if peg.center[1] == height) for height in heights]


def bin_walls(scene: carom.Scene) -> list[SegmentDescriptor]:
    """The walls between the bins, from the left to the right."""
    walls = [shape for shape in scene.shapes if isinstance(shape, SegmentDescriptor) and shape.name == "bin"]
    return sorted(walls, key=lambda wall: wall.start[0])


@SIZES
def test_each_peg_stands_below_the_middle_of_two(rows: int, balls: int) -> None:
    lines = peg_rows(galton(rows=rows, balls=balls))
    assert len(lines) == rows
    for line in lines:
        assert [later - earlier for earlier, later in pairwise(line)] == [1.0] * (len(line) - 1)
        assert line[0] == -line[-1]
    for upper, lower in pairwise(lines):
        assert abs(upper[0] - lower[0]) == 0.5
        assert {len(upper), len(lower)} == {rows, rows + 1}, "from one side of the board to the other"


@SIZES
def test_the_last_pegs_stand_over_the_walls_of_one_bin_more_than_rows(rows: int, balls: int) -> None:
    scene = galton(rows=rows, balls=balls)
    walls = bin_walls(scene)
    assert [wall.start[0] for wall in walls] == [wall.end[0] for wall in walls] == peg_rows(scene)[-1]
    assert len(walls) + 1 == rows + 1
    sides = [shape for shape in scene.shapes if shape.name == "board"]
    assert min(side.start[0] for side in sides) == walls[0].start[0] - 1.0
    assert max(side.end[0] for side in sides) == walls[-1].start[0] + 1.0


@pytest.mark.slow
@pytest.mark.parametrize(("rows", "balls"), [(4, 3000), (12, 4000), (30, 5000)])
def test_the_fullest_bin_is_filled_as_far_as_is_said(rows: int, balls: int) -> None:
    (depth,) = {wall.end[1] for wall in bin_walls(galton(rows=rows, balls=balls))}
    assert depth > board.LEAST_DEPTH
    fullest = balls * comb(rows, rows // 2) / 2**rows
    height = fullest * pi * board.RADIUS**2 / board.PACKING
    assert height == pytest.approx(board.BIN_FILL * depth, rel=0.08)  # Stirling's formula for the middle


@SIZES
def test_balls_lie_in_the_hopper_and_apart(rows: int, balls: int) -> None:
    scene = galton(rows=rows, balls=balls)
    places = np.array([ball.position for ball in scene.balls])
    assert len(places) == balls
    apart = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
    assert (apart[~np.eye(balls, dtype=bool)] > 2.0 * board.RADIUS).all()
    walls = [shape.build() for shape in scene.shapes if shape.name in ("board", "hopper")]
    assert all(wall.distance(tuple(place)) > board.RADIUS for wall in walls for place in places)
    opening = min(min(wall.start[1], wall.end[1]) for wall in scene.shapes if wall.name == "hopper")
    assert (places[:, 1] > opening).all()
    assert scene.world.bounds is not None
    assert places[:, 1].max() + board.RADIUS < scene.world.bounds[3]


def test_the_hopper_lets_some_balls_through_at_once() -> None:
    slopes = [shape for shape in galton().shapes if shape.name == "hopper"]
    mouths = sorted(min((slope.start, slope.end), key=lambda end: end[1]) for slope in slopes)
    assert hypot(mouths[1][0] - mouths[0][0], mouths[1][1] - mouths[0][1]) == pytest.approx(board.THROAT)


@pytest.mark.parametrize("balls", [1, 1000, 20_000])
def test_no_ball_falls_by_more_than_its_radius_in_a_substep(balls: int) -> None:
    scene = galton(balls=balls)
    (depth,) = {wall.end[1] for wall in bin_walls(scene)}
    fastest = sqrt(2.0 * -scene.world.gravity[1] * depth)
    assert fastest / 60.0 / scene.world.substeps < board.RADIUS
