"""`Worlds`: how they are made, stepped and put back, what fails in one copy alone, and what is refused."""

import copy
import pickle

import numpy as np
import pytest

import carom
from carom.typing import Detection
from carom.worlds import keeping
from tests.worlds import box, game_table, world_of

DT = 1 / 50


def test_copies_of_a_scene_of_a_world_and_of_a_shipped_scene() -> None:
    world = game_table("discrete")
    scene = carom.Scene.from_world(world)
    for source in (world, scene, "newtons_cradle"):
        worlds = carom.Worlds(source, copies=2, threads=1)
        assert len(worlds) == 2
        assert worlds.time.tolist() == [0.0, 0.0]
    assert repr(carom.Worlds(world, 3)) == f"<3 worlds: {len(world.shapes)} shapes, 3 balls each>"


def test_the_world_that_was_copied_is_let_alone() -> None:
    world = game_table("discrete")
    before = world.digest()
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.step(DT)
    worlds.shapes["bumper"].can_collide = False
    assert world.digest() == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"scene": 3}, "scene must be a Scene, a World or the name of a shipped scene, not 3"),
        ({"copies": 0}, "copies must be"),
        ({"copies": 1.5}, "copies must be"),
        ({"threads": 0}, "threads must be"),
        ({"keep_hits": 1}, "keep_hits must be"),
    ],
)
def test_what_is_no_worlds(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=message):
        carom.Worlds(**({"scene": carom.World(), "copies": 2} | arguments))  # type: ignore[arg-type]


def test_an_unknown_scene_and_a_misspelt_argument() -> None:
    with pytest.raises(carom.SceneError, match="did you mean 'pinball'"):
        carom.Worlds("pinbal", 2)
    with pytest.raises(carom.UnknownName, match="copys"):
        carom.Worlds("pinball", copys=2)  # type: ignore[call-arg]


def test_a_copy_that_is_not_finite_is_stopped_alone_and_told_once() -> None:
    worlds = carom.Worlds(game_table("discrete"), 4, threads=1)
    worlds.balls.velocity[1, 0] = np.nan
    with pytest.raises(carom.NonFiniteState, match="1 of 4 worlds are not finite") as caught:
        worlds.step(DT)
    assert caught.value.hits is not None
    assert worlds.failed.tolist() == [1]
    assert worlds.time.tolist() == [DT, 0.0, DT, DT]
    worlds.step(DT)
    assert worlds.time.tolist() == [2 * DT, 0.0, 2 * DT, 2 * DT]
    worlds.reset([1])
    assert worlds.failed.tolist() == []
    worlds.step(DT)
    assert worlds.time[1] == DT


def test_what_is_wrong_in_several_copies_is_told_at_once() -> None:
    worlds = carom.Worlds(game_table("discrete"), 4, threads=1)
    worlds.balls.velocity[3, 0] = np.nan
    worlds.balls.mass[1, 2] = -1.0
    with pytest.raises(carom.NonFiniteState, match=r"^3 of 4 worlds are not finite") as caught:
        worlds.step(DT)
    (note,) = caught.value.__notes__
    assert note.startswith("1 of 4 worlds: mass must be positive")
    assert worlds.failed.tolist() == [1, 3]
    worlds.step(DT)


def test_shapes_are_switched_after_an_interruption() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    worlds._stages = []
    worlds.shapes["bumper"].can_collide = [True, False]
    worlds.step(DT)
    assert worlds.shapes["bumper"].can_collide.tolist() == [True, False]


def test_a_ball_that_may_not_be_is_named() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    worlds.balls.mass[1, 2] = -1.0
    with pytest.raises(carom.InvalidArgument, match=r"1 of 2 worlds: mass must be positive, not -1\.0"):
        worlds.step(DT)


def test_too_many_impacts_end_the_step_of_a_copy_which_goes_on_then() -> None:
    world = world_of(
        carom.Segment((0, 0), (0, 1)), carom.Segment((1, 0), (1, 1)), carom.Ball((0.5, 0.5), 0.1, (50, 0)),
        detection="continuous", max_impacts=3,
    )  # fmt: skip
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.balls.velocity[0] = 0.0
    with pytest.raises(carom.ImpactLimit, match="1 of 2 worlds: balls"):
        worlds.step(1.0)
    assert 0.0 < worlds.time[1] < worlds.time[0] == 1.0
    assert worlds.failed.tolist() == []


def test_a_ball_that_strays_and_is_to_be_removed_is_out_of_play() -> None:
    world = world_of(
        carom.Circle((0, 0), 2.0, sensor=True), carom.Ball((0, 0), 0.5, (100, 0)), carom.Ball((0, 0), 0.25, (0, 1)),
        bounds=(-3, -3, 3, 3), remove_strays=True,
    )  # fmt: skip
    worlds = carom.Worlds(world, 2, threads=1)
    hits, alone = worlds.run(0.2, DT), world.run(0.2, DT)
    assert worlds.balls.in_play.tolist() == [[False, True]] * 2
    assert worlds.digests() == [world.digest()] * 2
    for name in carom.Hits.DTYPE.names or ():
        assert np.asarray(hits[name][hits["world"] == 1]).tolist() == np.asarray(alone[name]).tolist()


def test_a_ball_comes_back_into_play_where_its_row_says() -> None:
    worlds = carom.Worlds(game_table("continuous"), 2, threads=1)
    worlds.balls.in_play[0, 1] = False
    worlds.run(0.2, DT)
    stood = worlds.balls.position[0, 1].copy()
    worlds.run(0.1, DT)
    assert worlds.balls.position[0, 1].tolist() == stood.tolist()
    assert len(worlds[0].balls) == 2
    worlds.balls.in_play[0, 1] = True
    worlds.balls.position[0, 1] = (0.0, -0.5)
    worlds.balls.velocity[0, 1] = (1.0, 0.0)
    worlds.step(DT)
    assert worlds.balls.position[0, 1].tolist() == pytest.approx([DT, -0.5 - 3 * DT * DT])
    assert len(worlds[0].balls) == 3


def test_hits_that_nobody_asks_for_are_counted_all_the_same() -> None:
    kept, counted = (carom.Worlds(game_table("discrete"), 2, threads=1, keep_hits=keep) for keep in (True, False))
    hits = kept.run(1.0, DT)
    assert len(hits) > 4
    assert len(counted.run(1.0, DT)) == 0
    assert counted.counts.tobytes() == kept.counts.tobytes()
    by_name = counted.hits_by_shape()
    assert by_name.keys() == {"bumper", "target", "sensor", "flipper", "platform"}
    assert by_name["sensor"].tolist() == counted.shapes["sensor"].entries.tolist()


def test_hits_that_the_world_still_had_to_give_are_given_by_each() -> None:
    ball = carom.Ball((0, 0), 0.5)
    world = world_of(carom.Circle((0, 0), 2.0, sensor=True, solid=True), ball, carom.Ball((9, 9), 0.5))
    world.step(DT)
    world.remove(ball)
    worlds = carom.Worlds(world, 2, threads=1)
    assert worlds.digests() == [world.digest()] * 2
    for _ in range(2):
        assert [(hit.world, hit.kind) for hit in worlds.step(DT)] == [(0, carom.HitKind.EXIT), (1, carom.HitKind.EXIT)]
        assert len(worlds.step(DT)) == 0
        worlds.reset()
    worlds.step(DT)
    worlds.reset([1])
    assert worlds.step(DT)["world"].tolist() == [1]


def test_statistics_are_those_of_each() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    worlds.run(0.5, DT)
    world = worlds[0]
    assert dict(zip(worlds.statistics.dtype.names, worlds.statistics[0], strict=True)) == world.statistics.as_dict()


def test_where_to_reset() -> None:
    worlds = carom.Worlds(game_table("discrete"), 3, threads=1)
    for where, left in ((None, []), ([True, False, False], [1, 2]), ([2], [0, 1]), (-1, [0, 1]), ([], [0, 1, 2])):
        worlds.reset()
        worlds.step(DT)
        worlds.reset(where)
        assert np.flatnonzero(worlds.time).tolist() == left
    for wrong in ([True], [3], [0.5], "all", [-4]):
        with pytest.raises(carom.InvalidArgument, match="where must be a mask"):
            worlds.reset(wrong)


def test_only_a_world_of_the_same_scene_is_loaded() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    before = worlds.digests()
    heavier = game_table("discrete")
    heavier.gravity = (0, -7)
    moved = game_table("discrete")
    next(shape for shape in moved.shapes if shape.name == "bumper").position = (0.0, 0.9)
    more = game_table("discrete")
    more.add(carom.Ball((0, 0), 0.1))
    for other, what in ((heavier, "gravity is"), (moved, "static shapes are"), (more, "balls are")):
        with pytest.raises(carom.InvalidArgument, match=f"same scene as the copies; {what} not the same"):
            worlds.load(0, other)
    with pytest.raises(carom.InvalidArgument, match="world must be a World"):
        worlds.load(0, "world")  # type: ignore[arg-type]
    with pytest.raises(carom.InvalidArgument, match="copy must be"):
        worlds.load(2, game_table("discrete"))
    with pytest.raises(carom.InvalidArgument, match="world must be a World"):
        worlds.store(0, None)  # type: ignore[arg-type]
    with pytest.raises(carom.InvalidArgument, match="copy must be"):
        worlds.store(-3, heavier)
    assert worlds.digests() == before


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_a_world_becomes_what_a_copy_is_with_the_objects_that_it_has(detection: str) -> None:
    world = game_table(detection)
    worlds = carom.Worlds(world, 2, threads=1)
    worlds.balls.velocity[1] *= 0.5
    worlds.step(1 / 60)
    ball, shape = world.balls[0], world.shapes["bumper"]
    for index in (1, 0, -1):
        worlds.store(index, world)
        assert world.digest() == worlds.digests()[index] == worlds[index].digest()
        assert (world.balls[0], world.shapes["bumper"]) == (ball, shape)
    assert ball.position == tuple(worlds.balls.position[1, 0])


def test_a_snapshot_of_other_copies_is_refused() -> None:
    worlds, fewer = (carom.Worlds(game_table("discrete"), count, threads=1) for count in (2, 1))
    other = carom.Worlds("newtons_cradle", 2, threads=1)
    worlds.step(DT)
    before = worlds.digests()
    good = worlds.snapshot()
    count = len(worlds.shapes)
    for wrong, told in (
        (fewer.snapshot(), "must be of 2 copies, not of 1"),
        (other.snapshot(), f"must be of copies of the same scene: of {count} shapes, not of {len(other.shapes)}"),
        (good[:-1], "is damaged"),
        (b"", "must begin with the line"),
        (game_table("discrete").snapshot(), "must begin with the line"),
        (3, "must be bytes"),
    ):
        with pytest.raises(carom.SnapshotError, match=f"snapshot {told}"):
            worlds.restore(wrong)  # type: ignore[arg-type]
    assert worlds.digests() == before


def test_a_snapshot_of_which_a_part_is_damaged_changes_nothing() -> None:
    worlds = carom.Worlds(game_table("discrete"), 3, threads=1)
    whole = worlds.snapshot()
    worlds.balls.velocity[2, 0] = np.nan
    with pytest.raises(carom.NonFiniteState):
        worlds.step(DT)
    before = worlds.digests()
    parts, counts = keeping.unpacked(whole, (3, len(worlds.shapes), 2))
    with pytest.raises(carom.SnapshotError, match="damaged"):
        worlds.restore(keeping.packed([parts[0], parts[1], parts[2][:-1] + b"?"], counts))
    assert worlds.digests() == before
    assert worlds.failed.tolist() == [2]


@pytest.mark.parametrize("made", [copy.deepcopy, copy.copy, lambda worlds: pickle.loads(pickle.dumps(worlds))])
def test_copies_and_pickles_go_on_to_the_same_bits(made) -> None:  # type: ignore[no-untyped-def]
    worlds = carom.Worlds(game_table("continuous"), 2, threads=2)
    worlds.run(0.2, DT)
    worlds.balls.in_play[1, 0] = False
    twin = made(worlds)
    assert twin.digests() == worlds.digests()
    for each in (worlds, twin):
        each.step(DT)
    assert twin.digests() == worlds.digests()
    worlds.step(DT)
    assert twin.time[0] < worlds.time[0]


def test_what_steps_them_has_them_to_itself() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    del worlds._turn.free
    with pytest.raises(carom.WorldBusy):
        worlds.step(DT)


def test_each_is_a_world_of_its_own() -> None:
    worlds = carom.Worlds(game_table("discrete"), 2, threads=1)
    first, second = worlds
    first.step(DT)
    assert [first.time, second.time, *worlds.time] == [DT, 0.0, 0.0, 0.0]
    assert worlds[-1].digest() == worlds.digests()[1]
    with pytest.raises(carom.InvalidArgument, match="copy must be"):
        worlds[2]


@pytest.mark.parametrize("early", [True, False])
def test_the_mask_of_who_is_in_play_acts_whenever_it_is_asked_for(early: bool) -> None:
    world = world_of(
        carom.Ball((0, 0), 0.1, velocity=(9, 0)), carom.Ball((0, 1), 0.1), bounds=(-3, -3, 3, 3), remove_strays=True,
    )  # fmt: skip
    worlds = carom.Worlds(world, 3, threads=1)
    if early:
        assert worlds.balls.in_play.all()
    worlds.run(1.0, 0.1)
    mask = worlds.balls.in_play
    assert mask.tolist() == [[False, True]] * 3
    worlds.balls.position[1, 0] = (0.0, -1.0)
    mask[1] = True, False
    worlds.step(0.1)
    assert worlds.balls.in_play.tolist() == [[False, True], [True, False], [False, True]]
    worlds.reset([0])
    worlds.step(0.0)
    assert worlds.balls.in_play.tolist() == [[True, True], [True, False], [False, True]]


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_what_is_written_to_copies_gives_the_bits_of_what_is_set_of_objects(detection: Detection) -> None:
    base = carom.World(gravity=(0, -3), detection=detection, sleep_speed=0.01)
    base.add(*box(6, 6), carom.Circle((2, 2), 0.7, sensor=True))
    base.add(carom.Segment((3, 3), (5, 3.5), motion="kinematic", angular_velocity=1.0, elasticity=0.8))
    base.add(carom.Circle((1, 4), 0.3))
    for k in range(5):
        base.add(carom.Ball((1 + k, 1.5 + 0.7 * k), 0.25, velocity=(3 - k, 1), elasticity=0.9))
    worlds, singles = carom.Worlds(base, 3), [copy.copy(base) for _ in range(3)]
    random = np.random.default_rng(7)
    for k in range(60):
        ball, one = int(random.integers(5)), int(random.integers(3))
        vx, mass, spin = random.uniform(-4, 4), float(random.integers(1, 4)), float(random.integers(0, 3))
        single = singles[one]
        worlds.balls.velocity[one, ball], single.balls[ball].velocity = (vx, 1.0), (vx, 1.0)
        worlds.balls.mass[one, ball] = single.balls[ball].mass = mass
        spins = worlds.shapes[5].angular_velocity
        spins[one] = spin
        worlds.shapes[5].angular_velocity = spins
        single.shapes[5].angular_velocity = spin  # type: ignore[union-attr]
        switches = worlds.shapes[6].can_collide
        switches[one] = k % 3 > 0
        worlds.shapes[6].can_collide = switches
        single.shapes[6].can_collide = k % 3 > 0
        worlds.step(1 / 60)
        for other in singles:
            other.step(1 / 60)
        assert worlds.digests() == [other.digest() for other in singles]
