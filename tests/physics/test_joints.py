"""Joints: a path cut into tangent pieces, guarded by `guard_points`, is the path in one piece for a ball upon it."""

from collections.abc import Callable
from itertools import pairwise
from math import cos, hypot, pi, sin

import numpy as np
import pytest

from carom import Arc, Ball, Point, Segment, World, guard_points
from carom.shapes.shape import Shape

Vector = tuple[float, float]


def cut_segment(start: Vector, end: Vector, pieces: int) -> list[Shape]:
    """A segment as so many in a row, of unequal lengths."""
    shares = np.linspace(0, 1, pieces + 1) ** 1.3
    places = [(start[0] + s * (end[0] - start[0]), start[1] + s * (end[1] - start[1])) for s in shares.tolist()]
    places[-1] = end
    return [Segment(a, b, elasticity=0.6) for a, b in pairwise(places)]


def cut_arc(center: Vector, radius: float, start: float, end: float, pieces: int) -> list[Shape]:
    """An arc as so many in a row, of unequal lengths; `end` above `start`."""
    angles = (start + (end - start) * np.linspace(0, 1, pieces + 1) ** 1.2).tolist()
    return [Arc(center, radius, a, b, elasticity=0.6) for a, b in pairwise(angles)]


def slide(pieces: int) -> list[Shape]:
    """A ramp down to the right, a dip, a level stretch, a hill, and a level stretch, each tangent to the next."""
    tilt = 0.5
    # The ramp ends where the dip, of radius 6 about (0, 6), begins: at the angle -pi/2 - tilt.
    foot = (6 * sin(-tilt), 6 - 6 * cos(tilt))
    head = (foot[0] - 12 * cos(tilt), foot[1] + 12 * sin(tilt))
    return [
        *cut_segment(head, foot, pieces),
        *cut_arc((0, 6), 6, 1.5 * pi - tilt, 1.5 * pi, pieces),
        *cut_segment((0, 0), (15, 0), pieces),
        *cut_arc((15, -20), 20, pi / 2 - 0.25, pi / 2, pieces),
    ]


def bowl(pieces: int) -> list[Shape]:
    """Walls that run into a half circle."""
    return [
        *cut_segment((-6, 12), (-6, 6), pieces),
        *cut_arc((0, 6), 6, pi, 2 * pi, pieces),
        *cut_segment((6, 6), (6, 12), pieces),
    ]


def motion(path: list[Shape], ball: Ball, seconds: float, **settings: object) -> np.ndarray:
    """Where a ball is, and how fast, at every step along a guarded path."""
    world = World(detection="discrete", **settings)  # type: ignore[arg-type]
    for shape in [*guard_points(path), *path]:
        world.add(shape)
    world.add(ball)
    track = []
    for _ in range(round(seconds * 60)):
        world.step(1 / 60)
        track.append((*ball.position, *ball.velocity))
    return np.array(track)


def differ(build: Callable[[int], list[Shape]], make: Callable[[], Ball], seconds: float, pieces: int) -> float:
    """How far the motions on a path of four or three pieces and on one of many are apart, relative to the largest."""
    settings = {"gravity": (0.0, -9.81)}
    whole = motion(build(1), make(), seconds, **settings)
    cut = motion(build(pieces), make(), seconds, **settings)
    assert np.ptp(whole[:, 0]) > 5
    return float((np.abs(cut - whole) / np.abs(whole).max(axis=0)).max())


def on_the_slide() -> Ball:
    """A ball that touches the ramp near its upper end."""
    tilt = 0.5
    x, y = 6 * sin(-tilt) - 10 * cos(tilt), 6 - 6 * cos(tilt) + 10 * sin(tilt)
    return Ball((x + 0.4 * sin(tilt), y + 0.4 * cos(tilt)), 0.4, elasticity=0.5)


@pytest.mark.compiled
def test_a_ball_that_rolls_down_a_path_of_a_thousand_pieces_moves_as_down_one() -> None:
    assert differ(slide, on_the_slide, 4.0, 250) <= 1e-9


@pytest.mark.compiled
def test_a_ball_that_rolls_to_and_fro_in_a_bowl_of_a_thousand_pieces_moves_as_in_one() -> None:
    assert differ(bowl, lambda: Ball((-5.5, 9), 0.5, elasticity=0.5), 10.0, 333) <= 1e-9


def test_a_coarser_path_is_no_worse() -> None:
    assert differ(slide, on_the_slide, 4.0, 3) <= 1e-9
    assert differ(bowl, lambda: Ball((-5.5, 9), 0.5, elasticity=0.5), 4.0, 5) <= 1e-9


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("speed", [1.0, 8.0, 90.0])
def test_a_ball_that_hops_along_a_path_of_pieces_never_falls_through(speed: float) -> None:
    world = World(detection="discrete", gravity=(0, -9.81), substeps=1)
    for shape in cut_segment((-500, 0), (500, 0), 1000):
        shape.elasticity = 1.0
        world.add(shape)
    ball = world.add(Ball((-400, 3), 0.3, velocity=(speed, -speed / 20)))
    energy = hypot(*ball.velocity) ** 2 / 2 + 9.81 * 3
    for _ in range(round(800 / speed * 60)):
        world.step(1 / 60)
        assert ball.position[1] > 0
    assert hypot(*ball.velocity) ** 2 / 2 + 9.81 * ball.position[1] == pytest.approx(energy, rel=1e-9)


@pytest.mark.compiled
def test_a_ball_that_bounces_on_pieces_moves_as_on_the_whole() -> None:
    ends = []
    for pieces in (1, 1000):
        path = cut_segment((-50, 0), (50, 0), pieces)
        track = motion(path, Ball((-40, 4), 0.3, velocity=(7, 0)), 8.0, gravity=(0.0, -9.81))
        ends.append(track)
    assert np.abs(ends[0] - ends[1]).max() <= 1e-9 * 40


def test_a_smooth_path_needs_guards_at_its_two_ends_alone() -> None:
    assert len(guard_points(slide(50))) == 2
    assert len(guard_points(bowl(50))) == 2


def test_a_corner_is_met_by_its_point() -> None:
    corner = [Segment((-5, -3), (0, 0)), Segment((0, 0), (5, -3))]
    world = World(detection="discrete", substeps=1)
    guards = guard_points(corner)
    for shape in [*corner, *guards]:
        world.add(shape)
    ball = world.add(Ball((0, 1.05), radius=1, velocity=(0, -1)))
    hits = world.step(0.1)
    assert [hit.shape.kind for hit in hits] == ["point"]
    assert ball.velocity == (0, 1)


def test_a_ball_rolls_off_the_end_of_a_path_round_its_point() -> None:
    shelf = Segment((-5, 0), (0, 0), elasticity=0.5)
    world = World(detection="discrete", gravity=(0, -9.81))
    for shape in [shelf, *guard_points([shelf])]:
        world.add(shape)
    ball = world.add(Ball((-1, 0.5), radius=0.5, velocity=(0.2, 0), elasticity=0.5))
    world.run(8)
    assert ball.position[1] < -5
    assert 0.4 < ball.position[0] < 5
    assert isinstance(guard_points([shelf])[0], Point)
