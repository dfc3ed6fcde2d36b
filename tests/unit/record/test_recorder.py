"""A recorder notes what comes, goes and is switched off, at as many frames as it was told."""

from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import crowded, quiet

DT = 1 / 60


def crowd(seconds: float = 0.5, **options: Any) -> carom.Recording:
    """A recording of everything that a world can hold."""
    return carom.Recording.of(crowded(), seconds, DT, **options)


def test_frames_may_be_fewer_than_steps_and_the_end_is_one() -> None:
    every, some = crowd(0.25), crowd(0.25, every=4)
    assert len(some) == 5
    assert np.array_equal(some.positions, every.positions[[0, 4, 8, 12, 15]])
    assert some.hits.tobytes() == every.hits.tobytes()


def test_balls_come_and_go() -> None:
    world = quiet()
    first, second = world.balls.id.tolist()
    recorder = carom.Recorder(world)
    recorder.note(world.step(DT))
    world.remove(world.object(first))
    recorder.note(world.step(DT))
    late = world.add(carom.Ball((3, 3), 0.5, name="late"))
    recorder.note(world.step(DT))
    recording = recorder.finish()
    assert recording.ids.tolist() == [first, second, late.id]
    there = ~np.isnan(recording.positions[:, :, 0])
    assert there.tolist() == [[True, True, False]] * 2 + [[False, True, False], [False, True, True]]
    assert recording.label_of(late.id) == "late"
    assert len(recording.kinetic_energy()) == 4
    assert np.isfinite(recording.energy()).all()


def test_a_shape_that_is_switched_off_or_gone_does_not_collide() -> None:
    world = quiet()
    wall, eye = world.shapes
    recorder = carom.Recorder(world)
    wall.can_collide = False
    recorder.note(world.step(DT))
    world.remove(eye)
    recorder.note(world.step(DT))
    world.remove(wall)
    recorder.note()
    recording = recorder.finish()
    assert recording.colliding.tolist() == [[True, True], [False, True], [False, False], [False, False]]
    assert [shape.can_collide for shape in recording.shapes_at(1)] == [False, True]


def test_a_kinematic_shape_that_is_gone_stays_where_it_was_last() -> None:
    world = carom.World()
    lift = world.add(carom.Segment((0, 0), (1, 0), motion="kinematic", velocity=(1, 0)))
    recorder = carom.Recorder(world)
    recorder.note(world.step(1.0))
    world.remove(lift)
    recorder.note(world.step(1.0))
    assert recorder.finish().poses[:, 0, 0].tolist() == [0.5, 1.5, 1.5]


def test_progress_is_told_after_each_frame() -> None:
    told: list[tuple[float, float]] = []
    carom.Recording.of(quiet(), 0.5, 0.1, every=2, progress=lambda done, total: told.append((done, total)))
    assert [total for _, total in told] == [0.5] * 3
    assert [done for done, _ in told] == pytest.approx([0.2, 0.4, 0.5])
