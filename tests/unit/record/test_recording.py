"""What a recording knows of a run: where everything was at each frame, what it had of energy, what happened."""

from math import inf, nan
from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import crowded, named, quiet

DT = 1 / 60


def crowd(seconds: float = 0.5, **options: Any) -> carom.Recording:
    """A recording of everything that a world can hold."""
    return carom.Recording.of(crowded(), seconds, DT, **options)


def test_a_frame_is_the_world_as_it_stood() -> None:
    world, twin = crowded(), crowded()
    recording = carom.Recording.of(world, 0.2, DT, name="crowd", about="all kinds")
    assert (recording.name, recording.about, len(recording)) == ("crowd", "all kinds", 13)
    assert recording.scene == carom.Scene.from_world(twin)
    for frame in range(13):
        assert recording.times[frame] == twin.time
        assert recording.ids.tolist() == twin.balls.id.tolist()
        assert np.array_equal(recording.positions[frame], twin.balls.position)
        assert np.array_equal(recording.velocities[frame], twin.balls.velocity)
        assert recording.asleep[frame].tolist() == twin._arrays.balls.used["asleep"].astype(bool).tolist()
        twin.step(DT)
    assert recording.radii.tolist() == [ball.radius for ball in twin.balls]
    assert recording.masses.tolist() == [ball.mass for ball in twin.balls]


def test_shapes_stand_where_they_stood_bit_for_bit() -> None:
    world, twin = crowded(), crowded()
    recording = carom.Recording.of(world, 0.3, DT)
    lift, mill = (
        recording.shape_ids.tolist().index(key) for key in (named(twin, "lift").id, named(twin, "mill").shapes[0].id)
    )
    twin.run(0.2, DT)
    shapes = recording.shapes_at(12)
    assert shapes[lift].p0 == named(twin, "lift").p0
    assert shapes[mill].p0 == named(twin, "mill").shapes[0].p0
    assert shapes[mill].orientation == named(twin, "mill").orientation != 0.0
    recording.pose(shapes, 0)
    assert shapes[lift].p0 == named(crowded(), "lift").p0
    with pytest.raises(carom.InvalidArgument, match="frame must be from -19 to 18, not 19"):
        recording.shapes_at(19)


def test_the_hits_are_those_of_the_run_in_order_of_time() -> None:
    world, twin = crowded(), crowded()
    recording = carom.Recording.of(world, 1.0, DT)
    hits = np.asarray(twin.run(1.0, DT))
    assert len(hits) > 10
    assert recording.hits.tobytes() == hits.tobytes()
    assert dict(recording.statistics) == twin.statistics.as_dict()
    assert world.digest() == twin.digest()


def test_a_run_without_frames_or_balls_is_a_recording_too() -> None:
    recording = carom.Recording.of(carom.World(), 0)
    assert (len(recording), recording.duration, recording.energy().tolist()) == (1, 0.0, [0.0])
    assert repr(recording) == "<recording of 1 frames, 0 balls, 0 hits>"


def test_energy_of_an_elastic_ball_stays_while_it_falls() -> None:
    world = carom.World(gravity=(0, -10), detection="continuous")
    world.add(carom.Segment((-1, 0), (1, 0)))
    world.add(carom.Ball((0, 3), 0.5, mass=2.0))
    recording = carom.Recording.of(world, 0.6, DT)
    assert recording.kinetic_energy()[0] == 0.0
    assert recording.kinetic_energy()[-1] > 10.0
    assert recording.energy() == pytest.approx(2.0 * 10.0 * 3.0)


def test_a_time_has_the_frame_before_it() -> None:
    recording = crowd(0.1)
    assert [recording.frame_at(time) for time in (-1.0, 0.0, 0.9 * DT, 1.5 * DT, 9.0)] == [0, 0, 0, 1, 6]
    assert recording.frame_at(recording.times[3]) == 3
    assert recording.duration == pytest.approx(0.1)


def test_nothing_in_a_recording_can_be_changed() -> None:
    recording = crowd(0.1)
    with pytest.raises(ValueError, match="read-only"):
        recording.positions[0, 0, 0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        recording.hits["time"] = 1.0
    with pytest.raises(TypeError):
        recording.names[1] = "x"
    with pytest.raises(AttributeError):
        recording.name = "x"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"world": None}, "world must be a World"),
        ({"seconds": -1}, "seconds must not be negative"),
        ({"dt": 0}, "dt must be positive"),
        ({"every": 0}, "every must be from 1"),
        ({"progress": 5}, "progress must be callable or None"),
    ],
)
def test_bad_arguments_are_refused_by_name(arguments: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=told):
        carom.Recording.of(**({"world": quiet(), "seconds": 1.0} | arguments))
    with pytest.raises(carom.InvalidArgument, match="world must be a World, not 5"):
        carom.Recorder(5)


def test_a_time_that_is_none_has_no_frame() -> None:
    recording = crowd(0.25)
    assert [recording.frame_at(time) for time in (-1, 0.0, 0.1, 99)] == [0, 0, 6, len(recording) - 1]
    for bad in (nan, inf, None, "1"):
        with pytest.raises(carom.InvalidArgument, match="time must be"):
            recording.frame_at(bad)  # type: ignore[arg-type]


def test_only_the_shapes_of_a_recording_are_posed() -> None:
    recording = crowd(0.25)
    shapes = recording.shapes_at(0)
    for wrong in (shapes[:-1], [], shapes[::-1], tuple(shapes)):
        with pytest.raises(carom.InvalidArgument, match="shapes must be"):
            recording.pose(wrong, 1)  # type: ignore[arg-type]
    recording.pose(shapes, 1)
