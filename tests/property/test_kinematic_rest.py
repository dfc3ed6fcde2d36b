"""A step passes over kinematic shapes that rest, and puts those that turn far away to where they are when it matters.

Nobody can tell.
"""

from contextlib import suppress
from copy import copy
from math import cos, pi, sin
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import carom
from carom.constants import FEW_TO_ASK
from tests.worlds import world_of

SPINS = st.sampled_from([0.0, 0.3, -2.5, 20.0, -300.0])
LIMITS = st.sampled_from([None, (-0.4, 0.7), (0.0, 0.05), (-7.0, 0.0)])


def wheel(spin: float, limits: tuple[float, float] | None, arm: float) -> carom.Compound:
    """A part of each kind about (0, 0)."""
    parts = [
        carom.Point((arm, 0.0)),
        carom.Segment((0.0, 0.0), (arm, 0.0)),
        carom.Gate((0.0, 0.5), (-arm, 0.5), direction=(0.0, 1.0)),
        carom.Circle((0.0, -arm), 0.5),
        carom.Arc((0.0, 0.0), arm, 2.0, 3.0),
    ]
    return carom.Compound(parts, (0.0, 0.0), angular_velocity=spin, turn_limits=limits)


def played(far: int, substeps: int, steps: int, aim: float, speed: float, turning: list[Any]) -> tuple[Any, ...]:
    """What a ball that flies at a wheel comes to, and the wheel; with so many balls that rest far away."""
    wheels = wheel(*turning)
    world = world_of(wheels, substeps=substeps, gravity=(0.0, -1.0))
    ball = carom.Ball((12.0 * cos(aim), 12.0 * sin(aim)), 0.25, velocity=(-speed * cos(aim), -speed * sin(aim)))
    world.add(ball)
    world.add(*(carom.Ball((1e4 * k, 5e4), 0.25) for k in range(1, far + 1)))
    hits = world.run(steps / 60, 1 / 60)
    of_ball = [(hit.time, hit.shape.id, *hit.point, *hit.velocity) for hit in hits]
    return of_ball, ball.position, ball.velocity, standing(wheels)


def standing(wheels: carom.Compound) -> list[tuple[float, ...]]:
    """Where its parts are: ends, orientation and box."""
    fields = ("ax", "ay", "bx", "by", "cx", "cy", "left", "bottom", "right", "top", "orientation", "orientation_before")
    return [tuple(float(part._row[field]) for field in (*fields, "spin")) for part in wheels.shapes]


@given(
    st.integers(1, 9),
    st.integers(1, 40),
    st.floats(0.0, 2.0 * pi),
    st.sampled_from([0.0, 3.0, 30.0, 1000.0]),
    st.tuples(SPINS, LIMITS, st.floats(0.6, 5.0)),
)
@example(8, 30, 0.0, 30.0, (20.0, None, 4.0))
@example(8, 30, 1.0, 30.0, (-2.5, (-0.4, 0.7), 4.0))
def test_with_many_balls_that_are_far_away_a_ball_and_a_wheel_do_the_same(
    substeps: int, steps: int, aim: float, speed: float, turning: tuple[Any, ...]
) -> None:
    # Of many balls none is asked where it is: then every shape is put to where it is in each substep.
    few, many = (played(far, substeps, steps, aim, speed, list(turning)) for far in (0, FEW_TO_ASK))
    assert few == many


@pytest.mark.parametrize("limits", [None, (-0.4, 0.7)])
def test_a_wheel_far_from_the_ball_stands_where_its_orientation_says_after_every_step(limits: Any) -> None:
    wheels, alone = wheel(2.5, limits, 3.0), wheel(2.5, limits, 3.0)
    world = world_of(wheels, carom.Ball((100.0, 0.0), 0.25), substeps=8)
    for _ in range(40):
        world.step(1 / 60)
        alone.orientation = wheels.orientation
        for part, same in zip(wheels.shapes, alone.shapes, strict=True):
            assert part.aabb == same.aabb
            assert part.position == same.position
    assert wheels.orientation == (pytest.approx(2.5 * 40 / 60) if limits is None else 0.7)


def oar(world: carom.World) -> Any:
    """The shape of a world that is alone on its pivot."""
    return world.shapes["oar"]


DEEDS: dict[str, Any] = {
    "nothing": lambda world: None,
    "turn": lambda world: setattr(oar(world), "angular_velocity", 3.0),
    "turn it": lambda world: setattr(world.shapes["wheel"], "angular_velocity", -2.0),
    "halt": lambda world: setattr(oar(world), "angular_velocity", 0.0),
    "halt it": lambda world: setattr(world.shapes["wheel"], "angular_velocity", 0.0),
    "travel": lambda world: setattr(oar(world), "velocity", (0.5, 0.25)),
    "stay": lambda world: setattr(oar(world), "velocity", (0.0, 0.0)),
    "lay": lambda world: setattr(oar(world), "position", (-4.0, 1.0)),
    "tilt": lambda world: oar(world).rotate((-6.0, 0.0), 0.3),
    "send": lambda world: oar(world).move_to((-3.0, 2.0), dt=0.05),
    "limits": lambda world: setattr(oar(world), "turn_limits", (-1.0, 0.7)),
    "free": lambda world: setattr(oar(world), "turn_limits", None),
    "lock": lambda world: setattr(oar(world), "rotating", False),
    "unlock": lambda world: setattr(oar(world), "rotating", True),
    "far": lambda world: setattr(world.balls[0], "position", (900.0, 0.0)),
    "near": lambda world: setattr(world.balls[0], "position", (-6.0, 3.0)),
    "other mode": lambda world: setattr(
        world, "detection", "discrete" if world.detection == "continuous" else "continuous"
    ),
    "undone": lambda world: world.restore(world.snapshot()),
}


@given(st.lists(st.sampled_from(sorted(DEEDS)), min_size=1, max_size=8), st.sampled_from(["discrete", "continuous"]))
@example(["nothing", "turn", "halt", "travel"], "discrete")
@example(["nothing", "send", "nothing", "nothing", "turn it"], "discrete")
def test_what_is_set_of_a_shape_at_rest_acts_in_the_next_step(deeds: list[str], detection: Any) -> None:
    wheels = wheel(0.0, None, 3.0)
    wheels.name = "wheel"
    hand = carom.Segment((-6.0, 0.0), (-3.0, 0.0), motion="kinematic", name="oar", pivot=(-6.0, 0.0))
    world = world_of(wheels, hand, detection=detection, substeps=3)
    world.add(carom.Ball((-6.0, 3.0), 0.25, velocity=(1.0, -2.0)))
    for deed in deeds:
        world.step(0.02)
        with suppress(carom.InvalidArgument):  # beyond its stops
            DEEDS[deed](world)
        # What was made of a snapshot knows nothing of what rested before.
        twin = copy(world)
        for each in (world, twin):
            each.step(0.02)
        assert world.digest() == twin.digest()
