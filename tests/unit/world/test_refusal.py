"""Steps that are refused: which balls or shapes were wrong, and the world is as it was."""

import re

import numpy as np
import pytest

import carom
from tests.worlds import crowded

INF = float("inf")


NAN = float("nan")


def overflowing(state: str) -> carom.World:
    """A crowded world that will overflow, or whose state is not finite already."""
    world = crowded(balls=6)
    world.run(0.5)
    if state in ("x", "y", "vx", "vy"):
        column = world.balls.position if state in ("x", "y") else world.balls.velocity
        column[2, 0 if state in ("x", "vx") else 1] = NAN if state in ("x", "vy") else -INF
    elif state in ("radius", "mass"):
        getattr(world.balls, state)[2] = INF if state == "mass" else NAN
    elif state == "speed":
        world.balls.velocity[2] = (1.7e308, 0)
    elif state == "gravity":
        world.gravity = (1.7e308, -1.7e308)
    elif state == "bounce":
        world.add(carom.Segment((29, 0), (31, 0), elasticity=1e308))
        world.add(carom.Ball((30, 0.5), 0.4, (0, -20)))
    elif state == "fast shape":
        world.add(carom.Segment((20, 0), (21, 0), motion="kinematic", velocity=(1.7e308, 0)))
    else:
        world.add(carom.Segment((20, 0), (21, 0), motion="kinematic", angular_velocity=1.7e308))
    return world


def told(state: str, world: carom.World) -> str:
    """A pattern of the message about a world that is not finite."""
    if state in FROM_OUTSIDE:
        return rf"balls {world.balls[2].id} are not finite;"
    if state.endswith("shape"):
        return rf"shapes {world.shapes[-1].id} became infinite in the step;"
    ball = world.balls[-1 if state == "bounce" else 2].id
    return rf"balls ([\d, ]+, )?{ball}\b.* became infinite in the step;"


FROM_OUTSIDE = ("x", "y", "vx", "vy", "radius", "mass")


OVERFLOWS = ("speed", "gravity", "bounce", "fast shape", "spinning shape")


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("broad_phase", ["grid", "quadtree", "brute"])
@pytest.mark.parametrize("state", FROM_OUTSIDE + OVERFLOWS)
def test_a_state_that_is_not_finite_is_refused_and_left_as_it_was(state: str, broad_phase: str) -> None:
    world = overflowing(state)
    world.broad_phase = broad_phase
    digest, statistics = world.digest(), world.statistics.as_dict()
    rows = world._arrays.balls.used.tobytes(), world._arrays.shapes.used.tobytes()
    for _ in range(2):
        with pytest.raises(carom.NonFiniteState) as caught:
            world.step(1 / 60 if state == "bounce" else 60.0)
        assert world.digest() == digest
        assert world.statistics.as_dict() == statistics
        assert (world._arrays.balls.used.tobytes(), world._arrays.shapes.used.tobytes()) == rows
    assert len(caught.value.hits) == 0
    assert re.match(told(state, world), str(caught.value))


@pytest.mark.parametrize("state", FROM_OUTSIDE)
def test_a_world_that_was_made_finite_again_goes_on(state: str) -> None:
    world = overflowing(state)
    with pytest.raises(carom.NonFiniteState):
        world.step(0.1)
    world.balls.position[2], world.balls.velocity[2] = (5, 9), (0, 0)
    world.balls.radius[2] = world.balls.mass[2] = 0.25
    assert world.step(0.1).dtype.names
    assert np.isfinite(world.balls.position).all()


def test_many_bad_balls_are_named_in_part() -> None:
    world = carom.World()
    world.add_balls(np.zeros((14, 2)), radius=1.0)
    world.balls.position[:] = NAN
    with pytest.raises(carom.NonFiniteState, match=r"balls 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 and 4 more are not finite"):
        world.step(0.1)
