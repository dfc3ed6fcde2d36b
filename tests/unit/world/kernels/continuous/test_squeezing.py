"""Whether a ball that is pushed has room, beside how far it could go if it chose its way."""

from math import cos, pi, sin

import numpy as np
import pytest

from carom import Ball, Segment
from carom.constants import SQUEEZE_GAP
from carom.world.kernels.continuous.squeezing import is_squeezed
from tests.kernel_calls import in_flight, prepare_regions, shape_index
from tests.worlds import continuous_world

RADIUS = 0.5


def wall(angle: float, gap: float, **options: object) -> Segment:
    """A wall whose normal, towards a ball in the origin, has a direction, so far from the ball."""
    nx, ny, far = cos(angle), sin(angle), RADIUS + gap
    ends = ((-far * nx + way * ny, -far * ny - way * nx) for way in (-9.0, 9.0))
    return Segment(*ends, **options)  # type: ignore[arg-type]


def squeezed(*walls: tuple[float, float], turn: float = 0.0) -> bool:
    """Whether a ball that is pushed in a direction lacks the room before walls with angles, from there, and gaps."""
    press = wall(turn, 0.0, motion="kinematic", velocity=(cos(turn), sin(turn)))
    arrays = in_flight(
        continuous_world(*(wall(turn + angle, gap) for angle, gap in walls), press, Ball((0, 0), RADIUS))
    )
    prepare_regions(arrays)
    ball, flight = arrays.balls.rows[0], arrays.flights[0]
    return is_squeezed(
        ball, flight, arrays.shapes.rows, *shape_index(arrays), arrays.shapes.count - 1, 0.0, cos(turn), sin(turn)
    )


def way_on(walls: list[tuple[float, float]]) -> float:
    """How far a ball can be pushed along x if it goes aside as it likes, by the corners of what the walls leave it."""
    normals = np.array([(cos(angle), sin(angle)) for angle, _ in walls])
    gaps = np.array([gap for _, gap in walls])
    (a, b), (c, d) = normals
    x, _y = np.linalg.solve([[a, b], [c, d]], -gaps)
    # The corner is the farthest place where something of both normals points back along x.
    return float(x) if np.linalg.solve(normals.T, (-1.0, 0.0)).min() >= 0.0 else np.inf


@pytest.mark.parametrize("seed", range(200))
def test_between_two_walls_it_is_squeezed_where_it_cannot_go_as_far_as_it_must(seed: int) -> None:
    random = np.random.default_rng(seed)
    # Both aside, facing the ball a little; close enough that they are found, whatever cells there are.
    angles = pi / 2 + random.uniform(0.05, pi / 6 - 0.05), -pi / 2 - random.uniform(0.05, pi / 6 - 0.05)
    walls = [(angle, random.uniform(0, 0.04) * RADIUS * -cos(angle)) for angle in angles]
    assert squeezed(*walls, turn=random.uniform(0, 2 * pi)) == (way_on(walls) < SQUEEZE_GAP * RADIUS)
    wide = [(angle, 0.5 * RADIUS) for angle in angles]
    assert not squeezed(*wide)


def test_one_wall_aside_or_two_on_one_side_leave_a_way() -> None:
    assert not squeezed((pi / 2 + 0.3, 0.0))
    assert not squeezed((pi / 2 + 0.3, 0.0), (pi / 2 + 0.4, 0.0))
    assert not squeezed((pi / 2, 0.0), (-pi / 2, 0.0))  # a lane as wide as the ball
    assert squeezed((pi / 2 + 0.3, 0.0), (-pi / 2 - 0.3, 0.0))
    assert not squeezed((pi / 2 + 0.3, 0.0), (-pi / 2 + 0.4, 0.0))


def test_what_faces_the_ball_stops_it_alone() -> None:
    assert squeezed((pi, 0.04 * RADIUS))
    assert squeezed((pi - 0.9, 0.02 * RADIUS))
    assert not squeezed((pi, 0.06 * RADIUS))
    assert not squeezed((pi - 1.1, 0.02 * RADIUS))
