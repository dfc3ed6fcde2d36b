"""A recorder notes what comes, goes and is switched off, at as many frames as it was told."""

import pickle
from math import nan
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
    recorder.note(world.step(0.0))
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


def test_what_came_and_left_between_two_notes_keeps_its_name() -> None:
    world = quiet()
    recorder = carom.Recorder(world)
    wall = world.add(carom.Segment((0, 6), (9, 6), name="late wall"))
    guest = world.add(carom.Ball((5, 5), 0.5, velocity=(0, 60), name="guest"))
    hits = world.step(DT)
    assert (hits[0].ball, hits[0].shape) == (guest, wall)
    world.remove(guest, wall)
    recorder.note(hits)
    recording = recorder.finish()
    assert recording.label_of(int(hits["ball"][0])) == "guest"
    assert recording.label_of(int(hits["shape"][0])) == "late wall"


@pytest.mark.parametrize("every", [1, 3])
def test_what_came_and_was_noted_keeps_its_name_when_it_has_left(every: int) -> None:
    world = quiet()
    recorder = carom.Recorder(world, every=every)
    guest = world.add(carom.Ball((5, 5), 0.5, name="guest"))
    ball_id = guest.id or 0
    for step in range(6):
        if step == 4:
            world.remove(guest)
            del guest
        recorder.note(world.step(DT))
    recording = recorder.finish()
    assert ball_id in recording.ids
    assert recording.names[ball_id] == "guest"


@pytest.mark.parametrize("every", [1, 4])
def test_a_world_that_has_gone_back_is_refused_and_what_was_noted_stays(every: int) -> None:
    world = crowded()
    recorder = carom.Recorder(world, every=every)
    recorder.note(world.step(DT))
    before = world.snapshot()
    for _ in range(3):
        recorder.note(world.step(DT))
    world.restore(before)
    for _ in range(2):
        with pytest.raises(carom.RecordingError, match=r"gone back from .* to .* since the last note"):
            recorder.note(world.step(DT / 2))
    recording = recorder.finish()
    assert len(recording) == 4 // every + 1
    assert recording.times[-1] == 4 * DT
    world.run(3 * DT, DT)
    recorder.note(world.step(DT))
    assert recorder.finish().times[-1] == world.time


def test_balls_that_no_recording_can_hold_are_refused_and_what_was_noted_stays() -> None:
    for field, bad in (("position", nan), ("velocity", nan), ("radius", -1.0), ("mass", 0.0)):
        world = quiet()
        recorder = carom.Recorder(world)
        recorder.note(world.step(DT))
        hits = world.step(DT)
        getattr(world.balls, field)[0] = bad
        with pytest.raises(carom.RecordingError, match="must be finite, their radii and masses positive"):
            recorder.note(hits)
        assert len(recorder.finish()) == 2


def test_a_last_step_that_no_recording_can_hold_is_left_out() -> None:
    world = quiet()
    recorder = carom.Recorder(world, every=2)
    recorder.note(world.step(DT))
    world.balls.position[0] = nan
    assert len(recorder.finish()) == 1


def test_what_are_no_hits_of_the_world_is_refused() -> None:
    world, other = crowded(), crowded()
    recorder = carom.Recorder(world)
    with pytest.raises(carom.InvalidArgument, match="hits must be those of <World"):
        recorder.note(other.step(DT))
    hits = world.step(DT)
    others = hits.counts(), carom.Worlds("toy", 1).step(DT)
    for bad in (None, [], 5, hits["time"], np.asarray(hits).reshape(-1, 1), *others):
        with pytest.raises(carom.InvalidArgument, match="hits must be those that a step or a run has returned"):
            recorder.note(bad)
    assert len(recorder.finish()) == 1
    for good in (hits, hits[:0], np.asarray(hits), pickle.loads(pickle.dumps(hits))):
        recorder.note(good)
    assert len(recorder.finish()) == 5


def test_a_name_that_is_none_is_refused_before_anything_is_noted() -> None:
    for argument in ("name", "about"):
        with pytest.raises(carom.InvalidArgument, match=f"{argument} must be a string, not 5"):
            carom.Recorder(quiet(), **{argument: 5})  # type: ignore[arg-type]
