"""What ends a run: hits counted, a shape met, a function's word, each at the end of the step in which it came true."""

from collections import Counter
from typing import Any

import numpy as np
import pytest

import carom
from tests.worlds import bits, crowded

DT = 1 / 60


def table(**settings: Any) -> carom.World:
    """Two balls among four walls, a bumper, a sensor and a wheel."""
    world = carom.World(**settings)
    corners = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
    for name, a, b in zip("SENW", corners, [*corners[1:], corners[0]], strict=True):
        world.add(carom.Segment(a, b, name=name))
    world.add(carom.Circle((1, 1), 0.3, name="bumper"), carom.Circle((-1, 1), 0.3, sensor=True, solid=True, name="eye"))
    world.add(carom.Compound([carom.Circle((1, -1), 0.2), carom.Point((1, -1.5))], (1, -1), name="wheel"))
    world.add(carom.Ball((0, 0), 0.1, (3.1, 2.2), name="red"), carom.Ball((-1, -1), 0.1, (2.0, -3.3), name="blue"))
    return world


def steps_by_hand(world: carom.World, over: Any) -> tuple[int, list[carom.Hits]]:
    """The steps that a world makes until a function of all of its steps' hits says that it is over, and the hits."""
    parts: list[carom.Hits] = []
    while not (parts and over(parts)):
        parts.append(world.step(DT))
    return len(parts), parts


def ends_like(by_hand: Any, detection: Any = "discrete", **options: Any) -> carom.World:
    """A world that has run until something; asserts that it ended with the step that is found by hand."""
    world, twin = table(detection=detection), table(detection=detection)
    hits = world.run(60.0, dt=DT, **options)
    steps, parts = steps_by_hand(twin, by_hand)
    assert round(world.time / DT) == steps < 3600
    assert bits(hits) == b"".join(bits(part) for part in parts)
    assert world.digest() == twin.digest()
    return world


def rows(parts: list[carom.Hits]) -> np.ndarray:
    """The rows of all hits so far."""
    return np.concatenate([part.view(np.ndarray) for part in parts])


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_so_many_hits_end_a_run_with_the_step_of_the_last_one(detection: Any) -> None:
    ends_like(lambda parts: len(rows(parts)) >= 12, detection, until=12)


def test_so_many_hits_of_each_ball_end_a_run() -> None:
    def over(parts: list[carom.Hits]) -> bool:
        found = Counter(rows(parts)["ball"].tolist()) + Counter(rows(parts)["shape"].tolist())
        return all(found[ball] >= 6 for ball in balls)

    balls = table().balls.id.tolist()
    ends_like(over, until_each=6)
    ends_like(lambda parts: over(parts) or len(rows(parts)) >= 3, until_each=6, until=3)


def test_balls_that_come_later_have_to_have_their_hits_too() -> None:
    world = table()

    def add_one(done: float, total: float) -> None:
        if len(world.balls) == 2:
            world.add(carom.Ball((0, -1), 0.1, (5, 5), name="late"))

    hits = world.run(60.0, progress=add_one, until_each=4)
    late = world.balls[2]
    assert sum(late in (hit.ball, hit.shape) for hit in hits) >= 4
    assert world.time < 60.0


@pytest.mark.parametrize("name", ["bumper", "eye", "wheel", "red"])
@pytest.mark.parametrize("as_object", [False, True])
def test_a_meeting_ends_a_run_once_a_ball_bounces_or_comes_in(name: str, as_object: bool) -> None:
    twin = table()
    member = next(member for member in [*twin.shapes, *twin.balls] if member.name == name)
    parts = member.shapes if isinstance(member, carom.Compound) else [member]
    wanted = {part.id for part in parts}

    def over(parts: list[carom.Hits]) -> bool:
        last = parts[-1]
        return any(hit.kind != carom.HitKind.EXIT and wanted & {hit.ball.id, hit.shape.id} for hit in last)

    world = table()
    until = next(member for member in [*world.shapes, *world.balls] if member.name == name) if as_object else name
    world.run(60.0, dt=DT, until=until)
    steps, _ = steps_by_hand(twin, over)
    assert round(world.time / DT) == steps


def test_a_compound_is_found_by_its_name_after_a_restoring() -> None:
    world = carom.World()
    bar = world.add(carom.Compound([carom.Segment((-1, 0), (1, 0))], (0, 0), name="bar"))
    world.add(carom.Ball((0, 1), 0.1, velocity=(0, -5)))
    world.restore(world.snapshot())
    hits = world.run(1.0, until="bar")
    assert [hit.shape for hit in hits] == [bar.shapes[0]]


def test_leaving_a_sensor_is_not_meeting_it() -> None:
    world = carom.World()
    eye = world.add(carom.Circle((0, 0), 1, sensor=True, solid=True))
    world.add(carom.Ball((0, 0), 0.1, (1, 0)))
    world.step(DT)
    hits = world.run(3.0, until=eye)
    assert [hit.kind for hit in hits] == [carom.HitKind.EXIT]
    assert world.time == pytest.approx(3.0 + DT)


def test_a_function_is_asked_after_every_step_and_ends_the_run_at_its_word() -> None:
    world, told = table(), []

    def over(hits: carom.Hits) -> bool:
        told.append((world.time, len(hits)))
        return world.balls.position[0, 0] > 1.0

    hits = world.run(60.0, dt=DT, until=over)
    assert [time for time, _ in told] == pytest.approx(DT * np.arange(1, len(told) + 1))
    assert sum(count for _, count in told) == len(hits)
    assert world.balls.position[0, 0] > 1.0
    assert world.time == told[-1][0] < 60.0
    again = table()
    again.run(60.0, dt=DT, until=lambda hits: again.balls.position[0, 0] > 1.0)
    assert again.digest() == world.digest()


def test_a_function_may_change_the_world_but_not_step_it() -> None:
    world = table()

    def over(hits: carom.Hits) -> bool:
        world.gravity = (0, -1)
        world.step(DT)
        return True

    with pytest.raises(carom.WorldBusy):
        world.run(1.0, until=over)
    assert world.gravity == (0, -1)
    assert world.time == pytest.approx(DT)
    world.step(DT)


@pytest.mark.parametrize("seconds", [0.0, 1e9])
def test_when_a_run_ends_does_not_depend_on_the_clock(seconds: float, monkeypatch: pytest.MonkeyPatch) -> None:
    world, twin = table(), table()
    hits = world.run(20.0, until=9, until_each=100)
    monkeypatch.setattr("carom.world.running.SLICE_SECONDS", seconds)
    assert bits(twin.run(20.0, until=9, until_each=100)) == bits(hits)
    assert twin.digest() == world.digest()


def test_what_never_comes_true_changes_nothing() -> None:
    world, twin = crowded(), crowded()
    assert bits(world.run(0.5, until=10**9, until_each=10**9)) == bits(twin.run(0.5))
    assert world.digest() == twin.digest()


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"until": 0}, "until must be from 1 to"),
        ({"until": True}, "until must be a whole number"),
        ({"until": 2.5}, "until must be a whole number"),
        (
            {"until": (1, 2)},
            "until must be a number of hits, a shape or ball of this world or its name, a function, or",
        ),
        ({"until": "bumpr"}, r"until must be the name of a shape or ball here \(did you mean bumper\?\), not 'bumpr'"),
        ({"until": carom.Point((0, 0))}, "until must be in this world"),
        ({"until_each": 0}, "until_each must be from 1 to"),
        ({"until_each": "all"}, "until_each must be a whole number"),
    ],
)
def test_what_no_run_can_wait_for_is_refused(options: dict[str, Any], told: str) -> None:
    world = table()
    before = world.digest()
    with pytest.raises(carom.InvalidArgument, match=told):
        world.run(1.0, **options)
    assert world.digest() == before
