"""Everything that was hit has something to call it, and is counted by that."""

import carom
from carom.record.members import BALLS, hits_by_label, touches_by_label
from carom.world.touches import touches_of
from tests.worlds import crowded, named


def test_everything_has_something_to_call_it() -> None:
    world = crowded()
    recording = carom.Recording.of(world, 0.0)
    mill = named(world, "mill")
    assert recording.label_of(mill.shapes[0].id) == "mill"
    assert recording.label_of(world.shapes[0].id) == "segment at (6, 0)"
    assert recording.label_of(named(world, "ball 1").id) == "ball 1"
    nameless = next(ball.id for ball in world.balls if ball.name is None)
    assert recording.label_of(nameless) == f"ball {nameless}"


def test_hits_are_counted_by_what_was_hit_whenever_it_came() -> None:
    world = carom.World(gravity=(0, -10), detection="continuous")
    world.add(carom.Segment((-5, 0), (5, 0), name="floor"))
    recorder = carom.Recorder(world, every=100)
    late = world.add(carom.Segment((-5, 4), (-2, 4)))
    brief = [world.add(carom.Ball((x, 1), 0.5, velocity=(-x, 0))) for x in (1.0, 2.5)]
    world.add(carom.Ball((-4, 5), 0.5))
    first = brief[0].id
    for step in range(60):
        recorder.note(world.step(1 / 60))
        if step == 50:
            for ball in brief:
                world.remove(ball)
    run = recorder.finish()
    assert len(run.ids) == 1
    assert run.label_of(first) == f"ball {first}"
    assert run.label_of(late.id) == f"shape {late.id}"
    counts = dict(hits_by_label(run, run.hits))
    assert set(counts) == {"floor", f"shape {late.id}", BALLS}
    assert sum(counts.values()) == len(run.hits)
    assert list(counts.values()) == sorted(counts.values(), reverse=True)
    touched = dict(touches_by_label(run, run.hits))
    assert set(touched) == set(counts)
    assert sum(touched.values()) == len(touches_of(run.hits))
    assert all(touched[label] <= counts[label] for label in counts)
