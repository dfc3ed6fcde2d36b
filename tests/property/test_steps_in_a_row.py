"""Steps that need nothing but the kernel go a shorter way, and whatever is done between two steps ends that.

The twin forgets the shorter way before every step.
"""

from collections.abc import Callable
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

import carom
from tests.worlds import bits, crowded

Change = Callable[[carom.World], Any]


def first_ball(world: carom.World) -> carom.Ball:
    """The ball that was added first; one that is added if there is none."""
    return world.balls[0] if len(world.balls) else world.add(carom.Ball((3.0, 3.0), 0.2))


def kept_column(world: carom.World) -> None:
    """Write to a column that is kept over steps."""
    column = world.balls.elasticity
    world.step(0.02)
    column[:1] = 2.0 - column[:1] / 2.0


def turned(world: carom.World) -> None:
    """Set what moves, the other way round."""
    for shape in world.shapes:
        if shape.motion == carom.Motion.KINEMATIC:
            shape.angular_velocity = 0.5 - shape.angular_velocity


CHANGES: dict[str, Change] = {
    "nothing": lambda world: None,
    "velocity": lambda world: setattr(first_ball(world), "velocity", (1.5, -2.5)),
    "position": lambda world: setattr(first_ball(world), "position", (4.0, 4.5)),
    "radius": lambda world: setattr(first_ball(world), "radius", 0.25),
    "places": lambda world: world.balls.position.__setitem__(slice(0, 1), 5.0),
    "column": kept_column,
    "gravity": lambda world: setattr(world, "gravity", (0.0, 1.0 - world.gravity[1])),
    "detection": lambda world: setattr(world, "substeps", 5 - world.substeps),
    "turned": turned,
    "added": lambda world: world.add(carom.Ball((2.0, 6.0), 0.3), carom.Point((7.0, 7.0))),
    "removed": lambda world: world.remove(first_ball(world)),
    "removed shape": lambda world: world.remove(world.shapes[-1]) if len(world.shapes) > 4 else None,
    "restored": lambda world: world.restore(world.snapshot()),
    "statistics": lambda world: world.statistics.reset(),
    "bounded": lambda world: setattr(world, "bounds", (0.0, 0.0, 12.0, 12.0)),
    "run": lambda world: world.run(0.05, dt=0.025),
}


class Watch:
    """A world that is stepped and changed, and what it has told."""

    def __init__(self, detection: Any, quick: bool) -> None:
        self.world = crowded(balls=6, detection=detection)
        self.quick = quick
        self.told: list[bytes] = []

    def step(self, dt: float) -> None:
        """Make a step and note its hits."""
        if not self.quick:
            self.world._quick = None
        hits = self.world.step(dt)
        assert (np.diff(hits["time"]) >= 0.0).all()
        self.told.append(bits(hits))

    def outcome(self) -> tuple[Any, ...]:
        """All that was told, and the state."""
        return self.told, self.world.digest()


@pytest.mark.compiled
@given(
    detection=st.sampled_from(["discrete", "continuous"]),
    deeds=st.lists(st.tuples(st.sampled_from(sorted(CHANGES)), st.sampled_from([0.02, 0.02, 0.02, 0.0, 0.05]))),
)
def test_whatever_is_done_between_steps_acts_at_once(detection: str, deeds: list[tuple[str, float]]) -> None:
    watches = Watch(detection, quick=True), Watch(detection, quick=False)
    for watch in watches:
        for change, dt in deeds:
            watch.step(0.02)
            watch.step(0.02)
            CHANGES[change](watch.world)
            watch.step(dt)
    assert watches[0].outcome() == watches[1].outcome()


@pytest.mark.compiled
@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_the_shorter_way_is_gone(detection: str) -> None:
    watch = Watch(detection, quick=True)
    watch.step(0.02)
    watch.step(0.02)
    assert watch.world._quick is not None
