"""Whether a ball that is pushed has room, beside where it would come to."""

from math import cos, pi, sin

import numpy as np
import pytest

from carom import Ball, Segment
from carom.constants import MOST_AT_ONCE, SQUEEZE_GAP
from carom.world.kernels.continuous.squeezing import is_squeezed
from tests.kernel_calls import in_flight, prepare_regions, shape_index
from tests.worlds import continuous_world

RADIUS = 0.5


def wall(angle: float, gap: float, **options: object) -> Segment:
    """A wall whose normal, towards a ball in the origin, has a direction, so far from the ball."""
    nx, ny, far = cos(angle), sin(angle), RADIUS + gap
    ends = ((-far * nx + way * ny, -far * ny - way * nx) for way in (-9.0, 9.0))
    return Segment(*ends, **options)  # type: ignore[arg-type]


def squeezed(*walls: tuple[float, float], turn: float = 0.0, short: int = 0, **options: object) -> bool:
    """Whether a ball that is pushed in a direction lacks the room before walls with angles, from there, and gaps.

    Its impacts came too soon after one another so many times.
    """
    press = wall(turn, 0.0, motion="kinematic", velocity=(cos(turn), sin(turn)))
    before = [wall(turn + angle, gap, **options) for angle, gap in walls]
    arrays = in_flight(continuous_world(*before, press, Ball((0, 0), RADIUS)))
    prepare_regions(arrays)
    ball, flight = arrays.balls.rows[0], arrays.flights[0]
    flight["short"] = short
    return is_squeezed(
        ball, flight, arrays.shapes.rows, *shape_index(arrays), arrays.shapes.count - 1, 0.0, cos(turn), sin(turn)
    )


@pytest.mark.parametrize("seed", range(200))
def test_it_is_squeezed_if_on_its_way_it_comes_to_a_wall_on_either_side(seed: int) -> None:
    random = np.random.default_rng(seed)
    left, right = random.uniform(pi / 2 - 0.1, pi / 2 + 0.5), random.uniform(-pi / 2 - 0.5, -pi / 2 + 0.1)
    walls = [(angle, random.uniform(0, 0.02) * RADIUS) for angle in (left, right)]
    # How far each wall is from where it has come to then, aside of which it went straight.
    after = [gap + SQUEEZE_GAP * RADIUS * cos(angle) for angle, gap in walls]
    assert squeezed(*walls, turn=random.uniform(0, 2 * pi)) == (max(after) < 0.0)


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


def test_what_moves_with_the_shape_that_pushes_closes_no_room() -> None:
    assert squeezed((pi, 0.04 * RADIUS), motion="kinematic", velocity=(0.5, 0.0))
    assert not squeezed((pi, 0.04 * RADIUS), motion="kinematic", velocity=(1.0, 0.0))
    assert squeezed((pi, 0.04 * RADIUS), motion="kinematic", velocity=(1.0, 0.0), pivot=(0, 0), angular_velocity=1.0)
    assert squeezed((pi, 0.04 * RADIUS), motion="kinematic", velocity=(1.0, 0.0), short=MOST_AT_ONCE)


def test_what_stands_still_stops_what_was_put_onto_a_ball_and_stands_still_too() -> None:
    walls = [wall(angle, gap, motion="kinematic") for angle, gap in ((pi, 0.04 * RADIUS), (0.0, 0.0))]
    arrays = in_flight(continuous_world(*walls, Ball((0, 0), RADIUS)))
    prepare_regions(arrays)
    ball, flight = arrays.balls.rows[0], arrays.flights[0]
    assert is_squeezed(ball, flight, arrays.shapes.rows, *shape_index(arrays), 1, 0.0, 1.0, 0.0)
