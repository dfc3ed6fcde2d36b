"""Every shipped scene runs: nothing becomes infinite, escapes, or has energy that it was not given."""

from collections.abc import Callable
from math import hypot
from typing import Any

import numpy as np
import pytest

import carom
from carom import scenes
from tests.worlds import BILLIARDS, energy, small_scene

DT = 1.0 / 60.0

#: Where the balls of each scene may be, given x, y and the radius; by so much may a ball be found within a wall, in
#: the continuous mode by rounding alone.
SLACK, ROUNDING = 0.2, 1e-9
ROOMS: dict[str, Callable[[float, float, float], bool]] = {
    "annulus": lambda x, y, r: hypot(x, y) < 2.0 - r + ROUNDING and hypot(x - 0.6, y) > 0.8 + r - ROUNDING,
    "breakout": lambda x, y, r: r - SLACK < x < 24.0 - r + SLACK and r - SLACK < y < 30.0 - r + SLACK,
    "circle": lambda x, y, r: hypot(x, y) < 2.0 - r + ROUNDING,
    "ellipse": lambda x, y, r: hypot(x / 3.0, y / 2.0) < 1.0 - r / 3.0 + ROUNDING,
    "flower": lambda x, y, r: hypot(x, y) < 2.2 - r + ROUNDING,
    "galton": lambda x, y, r: y > 0.0,
    "gas": lambda x, y, r: True,
    "lemon": lambda x, y, r: hypot(abs(x) + 1.0, y) < 3.0 - r + ROUNDING,
    "lorentz": lambda x, y, r: hypot(x, y) > 1.0 and hypot(x - 1.15, y - 1.15 * 3.0**0.5) > 1.0,
    "mushroom": lambda x, y, r: hypot(x, max(y, 0.0)) < 2.0 - r + ROUNDING and (y > 0.0 or abs(x) < 0.8),
    "newtons_cradle": lambda x, y, r: abs(y) <= 1e-12,
    "pinball": lambda x, y, r: (0.0 < x < 20.0 and 0.0 < y <= 32.0) or hypot(x - 10.0, y - 32.0) < 10.0 - r + SLACK,
    "pool": lambda x, y, r: -6.0 < x < 260.0 and -10.0 < y < 137.0,
    "rectangle": lambda x, y, r: abs(x) < 3.0 - r + ROUNDING and abs(y) < 2.0 - r + ROUNDING,
    "sinai": lambda x, y, r: max(abs(x), abs(y)) < 2.0 - r + ROUNDING and hypot(x, y) > 1.0 + r - ROUNDING,
    "stadium": lambda x, y, r: hypot(max(abs(x) - 2.0, 0.0), y) < 2.0 - r + ROUNDING,
    "toy": lambda x, y, r: 0.0 < x < 32.0 and 0.0 < y < 24.0 and (y < x + 13.0 or hypot(x - 5.0, y - 19.0) < 3.5),
    "wedge": lambda x, y, r: abs(x) < y < 2.1,
}
COARSE = {"tolerance": 1e-6}
FEW: dict[str, dict[str, Any]] = {"ellipse": COARSE, "galton": {"rows": 4, "balls": 15}, "gas": {"balls": 15}}
#: Balls that rest on each other take the continuous mode long: enough of them to make heaps in the bins.
SOME: dict[str, dict[str, Any]] = {"ellipse": COARSE, "galton": {"rows": 6, "balls": 40}, "gas": {"balls": 1000}}
ELASTIC = ("gas", "newtons_cradle", *BILLIARDS)


#: Heaps and crowds take seconds; every other scene is quick.
LONG = {"galton", "gas"}
SCENES = [pytest.param(name, marks=pytest.mark.slow if name in LONG else ()) for name in scenes.names()]


def check(world: carom.World, name: str) -> None:
    """Assert what must hold at any time."""
    assert np.isfinite(world.balls.position).all()
    assert np.isfinite(world.balls.velocity).all()
    assert world.statistics.strays == 0
    assert world.statistics.stalled == 0
    assert world.strays == []
    for (x, y), radius in zip(world.balls.position.tolist(), world.balls.radius.tolist(), strict=True):
        assert ROOMS[name](x, y, radius), (x, y, world.time)


def run(world: carom.World, name: str, seconds: int) -> int:
    """The number of hits in so many seconds, with checks four times a second."""
    count = 0
    for _ in range(4 * seconds):
        count += len(world.run(0.25, DT))
        check(world, name)
    return count


@pytest.mark.compiled
@pytest.mark.parametrize("name", SCENES)
def test_ten_seconds(name: str) -> None:
    world = getattr(scenes, name)(**{"ellipse": COARSE}.get(name, {})).build()
    before = energy(world)
    assert run(world, name, 10) > 0
    assert world.time == pytest.approx(10.0)
    if name in ELASTIC:
        assert energy(world) == pytest.approx(before, rel=1e-9)
    if name in ("galton", "pool"):
        assert energy(world) < before


@pytest.mark.compiled
@pytest.mark.parametrize("name", ["breakout", "pinball", pytest.param("gas", marks=pytest.mark.slow)])
def test_ten_seconds_in_discrete_mode(name: str) -> None:
    world = getattr(scenes, name)().build()
    world.detection = "discrete"
    before = energy(world)
    assert run(world, name, 10) > 0
    if name in ELASTIC:
        assert energy(world) == pytest.approx(before, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("name", SCENES)
def test_ten_seconds_in_continuous_mode(name: str) -> None:
    world = getattr(scenes, name)(**SOME.get(name, {})).build()
    world.detection = "continuous"
    before = energy(world)
    assert run(world, name, 10) > 0
    if name in ELASTIC:
        assert energy(world) == pytest.approx(before, rel=1e-9)


@pytest.mark.compiled
@pytest.mark.parametrize("name", scenes.names())
def test_one_second_with_few_balls(name: str) -> None:
    world = getattr(scenes, name)(**FEW.get(name, {})).build()
    run(world, name, 1)


@pytest.mark.slow
@pytest.mark.compiled
def test_the_board_makes_a_bell() -> None:
    world = scenes.galton(rows=12, balls=1000).build()
    run(world, "galton", 12)
    bins = np.floor(world.balls.position[:, 0] + 6.5)
    assert world.balls.position[:, 1].max() < 7.5
    assert abs((bins - 6.0).mean()) < 0.25
    assert 1.5 < bins.std() < 2.2  # a binomial distribution has the square root of 3
    heights = np.bincount(bins.astype(int), minlength=13)
    assert heights.argmax() in (5, 6, 7)
    assert heights[0] + heights[12] < 20


def test_the_cradle_passes_one_ball_on() -> None:
    world = scenes.newtons_cradle(balls=5).build()
    moving = set()
    for _ in range(600):
        world.step(DT)
        fast = np.flatnonzero(np.abs(world.balls.velocity[:, 0]) > 1e-9)
        assert len(fast) == 1
        assert abs(world.balls.velocity[fast[0], 0]) == pytest.approx(6.0, rel=1e-12)
        moving |= set(fast.tolist())
    assert {0, 4} <= moving


def test_the_eight_is_potted_and_stays() -> None:
    world = scenes.pool().build()
    hits = world.run(8.0, DT)
    entered = [hit for hit in hits if hit.kind == carom.HitKind.ENTER]
    assert [(hit.ball.name, hit.shape.name) for hit in entered] == [("eight", "upper right pocket")]
    assert {hits[0].ball.name, hits[0].shape.name} == {"cue ball", "eight"}
    cue, eight = world.balls
    assert eight.position[0] > 254.0 - 3.0
    assert eight.position[1] > 127.0 - 3.0
    assert 0.0 < cue.position[0] < 254.0
    assert 0.0 < cue.position[1] < 127.0
    assert cue.velocity == eight.velocity == (0.0, 0.0)


def test_the_eight_goes_as_aimed() -> None:
    world = scenes.pool().build()
    _, eight = world.balls
    way = np.array((254.0 - 1.5, 127.0 - 1.5)) - eight.position
    world.run(0.7, DT)
    assert np.array(eight.velocity) / hypot(*eight.velocity) == pytest.approx(way / hypot(*way), abs=1e-12)


def test_billiards_paths_part() -> None:
    for name in ("stadium", "sinai"):
        world = scenes.by_name(name).build()
        world.run(10.0, DT)
        places = world.balls.position
        assert max(hypot(*(places[i] - places[0])) for i in range(1, 5)) > 1.0


# -- the two tables --------------------------------------------------------------------------------------------------


def part(world: carom.World, name: str) -> carom.Compound:
    """The compound with a name."""
    (found,) = [shape for shape in world.shapes if shape.name == name]
    assert isinstance(found, carom.Compound)
    return found


def names_hit(hits: carom.Hits) -> set[str | None]:
    """The names of what was hit, or of the compound that it is part of."""
    shapes = [hit.shape for hit in hits]
    return {shape.compound.name if getattr(shape, "compound", None) else shape.name for shape in shapes}


def longest_rest(track: list[np.ndarray], within: float) -> int:
    """The most steps that any ball stayed within a square of side `within`."""
    places = np.array(track)
    window = 60
    longest = 0
    for ball in range(places.shape[1]):
        still = 0
        for begin in range(0, len(places) - window, window):
            moved = np.ptp(places[begin : begin + window, ball], axis=0).max() > within
            still = 0 if moved else still + window
            longest = max(longest, still)
    return longest


@pytest.mark.slow
@pytest.mark.compiled
def test_pinball_plays_by_itself_for_minutes() -> None:
    world = scenes.pinball().build()
    track = []
    for _ in range(120):
        for _ in range(60):
            world.step(DT)
            track.append(world.balls.position.copy())
        check(world, "pinball")
    assert longest_rest(track, 1.2) < 180


@pytest.mark.slow
@pytest.mark.compiled
def test_every_part_of_the_pinball_table_is_reached() -> None:
    world = scenes.pinball().build()
    seen = names_hit(world.run(240.0, DT))
    reached = {
        *("dome", "orbit gate", "plunger", "plunger lane", "trough", "drain", "spinner", "lane guide"),
        *("left bumper", "right bumper", "low bumper", "left target", "left post", "right post"),
        *("drop target 1", "drop target 2", "drop target 3"),
        *("left slingshot's band", "right slingshot's band", "left flipper", "right flipper"),
        *("left inlane", "right inlane", "left outlane", "right outlane", "left orbit", "right orbit"),
        *("left lane", "middle lane", "right lane"),
    }
    assert reached <= seen


@pytest.mark.compiled
def test_the_first_ball_goes_up_the_lane_and_round_the_dome() -> None:
    world = scenes.pinball().build()
    order = [hit.shape.name for hit in world.run(2.0, DT) if hit.ball.name == "first ball"]
    assert order[0] == "plunger lane"
    assert order.index("dome") < order.index("orbit gate")
    assert "launch gate" not in order
    assert world.balls[0].position[0] < 18.6


@pytest.mark.slow
@pytest.mark.compiled
def test_flippers_swing_between_their_stops_and_send_balls_up() -> None:
    world = scenes.pinball().build()
    flippers = [(part(world, "left flipper"), 1.0), (part(world, "right flipper"), -1.0)]
    seen = set()
    for step in range(3600):
        for flipper, up in flippers:
            flipper.angular_velocity = up * (22.0 if step // 15 % 2 == 0 else -22.0)
        world.step(DT)
        if step % 15 == 14:
            seen |= {flipper.orientation for flipper, _ in flippers}
            check(world, "pinball")
    left, right = flippers[0][0], flippers[1][0]
    assert left.turn_limits is not None
    assert right.turn_limits is not None
    assert seen == {*left.turn_limits, *right.turn_limits}


@pytest.mark.compiled
def test_the_toys_parts_turn_when_told_to() -> None:
    world = scenes.toy().build()
    parts = [part(world, name) for name in ("paddle", "cup", "crescent")]
    run(world, "toy", 5)
    assert [turned.orientation for turned in parts] == [0.0, 0.0, 0.0]
    for turned in parts:
        turned.rotating = True
    run(world, "toy", 60)
    assert all(abs(turned.orientation) > 50.0 for turned in parts)


@pytest.mark.compiled
def test_the_toys_launched_ball_comes_into_the_room_and_stays() -> None:
    world = scenes.toy().build()
    (launched,) = [ball for ball in world.balls if ball.name == "launched"]
    inside = False
    for _ in range(3600):
        world.step(DT)
        x, y = launched.position
        inside = inside or x < 30.0
        assert not inside or x < 30.6 or y > 18.8
    assert inside


def test_all_scenes_are_continuous_but_for_two() -> None:
    found = {name for name in carom.scenes.names() if small_scene(name).world.detection == "discrete"}
    assert found == {"galton", "toy"}
    assert carom.World().detection == "continuous"
    assert carom.Scene().world.detection == "continuous"
