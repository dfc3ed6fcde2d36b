"""The rules of the pool end game, what its line of aim promises, and the marks of its impacts."""

from __future__ import annotations

from math import cos, dist, hypot, pi, sin

import pytest

import carom
from carom.play.pool import setups
from carom.play.pool.game import FASTEST, FIRST, SLOWEST, STEP, Impact, Phase, Pool, Setup, speed_of
from carom.play.pool.preview import preview, reaches, scratch

#: The eight lies in the jaws of the upper right pocket, the cue ball straight behind it.
EASY = Setup(cue=(238.0, 111.0), eight=(248.0, 121.0))

#: The cue ball lies in the jaws.
DANGER = Setup(cue=(244.0, 117.0), eight=(60.0, 60.0))

#: A soft shot wins, and after a hard one the cue ball follows into another pocket.
GREEDY = Setup(cue=(72.0, 78.0), eight=(191.0, 42.0))

DIAGONAL = (1.0, 1.0)


def play_out(pool: Pool, most: int = 6000) -> int:
    """How many steps it took until both balls lay still; no ball strays in any of them."""
    for steps in range(most):
        if not pool.moving:
            return steps
        pool.step()
        assert pool.world.strays == []
    raise AssertionError("the balls roll on and on")


def angle_between(a: tuple[float, float], b: tuple[float, float]) -> float:
    """The sine of the angle between two vectors."""
    return abs(a[0] * b[1] - a[1] * b[0]) / (hypot(*a) * hypot(*b))


# -- winning and losing ----------------------------------------------------------------------------------------------


def test_the_eight_in_a_pocket_and_the_cue_ball_on_the_table_win() -> None:
    pool = Pool(EASY)
    pool.shoot(DIAGONAL, 0.3)
    assert pool.phase is Phase.ROLL
    play_out(pool)
    assert pool.phase is Phase.WON
    assert pool.over
    assert [*pool.potted] == ["eight"]
    assert pool.potted["eight"].pocket == "upper right pocket"
    assert pool.shots == 1


def test_the_cue_ball_in_a_pocket_loses_at_once() -> None:
    pool = Pool(DANGER)
    pool.shoot(DIAGONAL, 0.3)
    while pool.phase is Phase.ROLL:
        pool.step()
    assert pool.phase is Phase.LOST
    assert pool.moving
    assert [*pool.potted] == ["cue ball"]


def test_the_same_pocket_decides_game_after_game() -> None:
    pool = Pool(DANGER)
    for _ in range(2):
        pool.place(DANGER)
        pool.shoot(DIAGONAL, 0.4)
        for _ in range(40):
            pool.step()
        assert pool.phase is Phase.LOST
        assert pool.potted["cue ball"].pocket == "upper right pocket"
    pool.place(EASY)
    pool.shoot(DIAGONAL, 0.3)
    play_out(pool)
    assert pool.phase is Phase.WON


def test_the_path_of_a_ball_that_rolls_in_untouched_ends_where_it_lies() -> None:
    pool = Pool(EASY)
    pool.shoot(DIAGONAL, 0.3)
    play_out(pool)
    pool.marks[:] = [mark for mark in pool.marks if mark.impact is Impact.BALLS]
    assert pool.path("eight")[-1] == pool.eight.position


@pytest.mark.compiled
def test_both_balls_in_pockets_lose() -> None:
    pool = Pool(GREEDY)
    pool.shoot(setups.lines(pool)[0].direction, 0.9)
    play_out(pool)
    assert pool.phase is Phase.LOST
    assert {*pool.potted} == {"cue ball", "eight"}


def test_a_shot_without_a_fall_lets_the_player_shoot_again() -> None:
    pool = Pool()
    pool.shoot((0.0, 1.0), 0.0)
    play_out(pool)
    assert pool.phase is Phase.AIM
    assert not pool.over
    assert pool.shots == 1
    pool.shoot((0.0, 1.0), 0.0)
    assert pool.shots == 2


def test_balls_that_roll_cannot_be_shot_and_a_shot_needs_a_direction() -> None:
    pool = Pool()
    pool.shoot((0.0, 0.0), 1.0)
    assert pool.phase is Phase.AIM
    pool.shoot((1.0, 0.0), 0.5)
    velocity = pool.cue.velocity
    pool.shoot((0.0, 1.0), 1.0)
    assert pool.cue.velocity == velocity
    assert pool.shots == 1


def test_a_shot_is_as_fast_as_its_power_says() -> None:
    assert [speed_of(power) for power in (-1.0, 0.0, 1.0, 2.0)] == [SLOWEST, SLOWEST, FASTEST, FASTEST]
    pool = Pool()
    pool.shoot((3.0, 4.0), 0.5)
    assert hypot(*pool.cue.velocity) == pytest.approx(speed_of(0.5))


def test_placed_again_the_balls_lie_still_where_they_lay() -> None:
    pool = Pool(EASY)
    pool.shoot(DIAGONAL, 0.3)
    for _ in range(30):
        pool.step()
    pool.place(EASY)
    assert (pool.cue.position, pool.eight.position) == (EASY.cue, EASY.eight)
    assert (pool.phase, pool.shots, pool.marks, pool.potted) == (Phase.AIM, 0, [], {})
    assert pool.step() is None


# -- rest ------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.compiled
def test_the_hardest_shots_come_to_rest_and_no_ball_is_lost() -> None:
    pool = Pool()
    for turn in range(120):
        pool.place(FIRST)
        pool.shoot((cos(0.0523 * turn), sin(0.0523 * turn)), 1.0)
        play_out(pool)
        assert pool.cue.velocity == pool.eight.velocity == (0.0, 0.0)
        for ball in (pool.cue, pool.eight):
            x, y = ball.position
            on_cloth = ball.radius * (1 - 1e-6) < x < 254 - ball.radius * (1 - 1e-6)
            on_cloth = on_cloth and ball.radius * (1 - 1e-6) < y < 127 - ball.radius * (1 - 1e-6)
            near_pocket = any(dist(shape.position, ball.position) < 14.0 for shape in pool.world.shapes if shape.sensor)
            assert on_cloth or near_pocket


@pytest.mark.compiled
def test_a_ball_that_a_pocket_holds_comes_to_rest_within_few_impacts() -> None:
    pool = Pool()
    setups.setup(pool, 2)
    shot, power = setups.winning(pool) or pytest.fail("no shot wins")
    pool.shoot(shot.direction, power)
    most = 0
    while pool.moving:
        hits = pool.step()
        most = max(most, 0 if hits is None else len(hits))
    assert 1 <= most <= 200
    assert len(pool.marks) < 10


def test_friction_takes_the_speed_at_an_even_rate() -> None:
    pool = Pool()
    pool.shoot((1.0, 0.0), 0.3)
    before = hypot(*pool.cue.velocity)
    for _ in range(12):
        pool.step()
    assert before - hypot(*pool.cue.velocity) == pytest.approx(12 * STEP * pool.world.friction)


# -- the line of aim -------------------------------------------------------------------------------------------------


def test_the_shot_goes_as_the_line_of_aim_says() -> None:
    pool = Pool(Setup(cue=(200.0, 40.0), eight=(215.0, 52.0)))
    direction = (15.0, 9.5)
    shown = preview(pool, direction)
    assert shown is not None
    assert shown.struck is not None
    assert shown.cue is not None
    pool.shoot(direction, 0.5)
    pool.to_impact()
    mark = pool.marks[0]
    places = dict(mark.balls)
    assert dist(places["cue ball"], shown.aim.ghost) < 1e-9
    assert dist(places["eight"], pool.setup.eight) < 1e-9
    assert shown.aim.other_direction is not None
    assert shown.aim.direction is not None
    assert angle_between(pool.eight.velocity, shown.aim.other_direction) < 1e-9
    assert angle_between(pool.cue.velocity, shown.aim.direction) < 1e-9


@pytest.mark.compiled
@pytest.mark.parametrize("number", range(8))
def test_both_balls_meet_next_what_their_lines_end_at(number: int) -> None:
    pool = Pool()
    setups.setup(pool, number)
    shot = setups.lines(pool)[0]
    shown = preview(pool, shot.direction)
    assert shown is not None
    assert shown.struck is not None
    assert shown.struck.pocket == shot.pocket
    pool.shoot(shot.direction, 0.8)
    play_out(pool)
    assert pool.potted["eight"].pocket == shot.pocket
    ways = [place for mark in pool.marks[1:] for name, place in mark.balls if name == "cue ball"]
    if shown.cue is not None and shown.cue.pocket is None and ways:
        assert dist(ways[0], shown.cue.end) < 1e-6


def test_the_line_of_aim_warns_of_a_pocket() -> None:
    pool = Pool(DANGER)
    shown = preview(pool, DIAGONAL)
    assert shown is not None
    assert shown.pocket == "upper right pocket"
    assert shown.struck is None


def test_after_a_cushion_the_line_goes_on_to_the_eight() -> None:
    pool = Pool(Setup(cue=(100.0, 30.0), eight=(140.0, 30.0)))
    # Down by `way` and, a cushion's elasticity less steep, up again by as much, over 40 cm in all.
    way, bounce = 30.0 - pool.cue.radius, 0.8 * pool.cue.elasticity
    steep = way * (1.0 + 1.0 / bounce) / 40.0
    shown = preview(pool, (1.0, -steep))
    assert shown is not None
    assert shown.aim.ghost == pytest.approx((100.0 + way / steep, pool.cue.radius))
    assert shown.cue is not None
    assert dist(shown.cue.end, pool.eight.position) == pytest.approx(5.715)


@pytest.mark.slow
@pytest.mark.compiled
def test_a_shot_is_strong_enough_where_the_line_says_so() -> None:
    pool = Pool(GREEDY)
    direction = setups.lines(pool)[0].direction
    shown = preview(pool, direction)
    assert shown is not None
    assert shown.struck is not None
    ends = {}
    for power in (0.2, 0.34, 0.36, 0.38, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.8):
        potted = reaches(pool, shown, shown.struck, shown.aim.other_speed, power)
        fall = scratch(pool, shown, power)
        with pool.trial():
            pool.shoot(direction, power)
            play_out(pool)
            ends[power] = [*pool.potted]
            assert ("eight" in pool.potted) == potted
            assert ("cue ball" in pool.potted) == (fall is not None)
    assert {*map(len, ends.values())} == {0, 1, 2}


def test_a_line_that_meets_nothing_is_none() -> None:
    pool = Pool()
    for shape in list(pool.world.shapes):
        pool.world.remove(shape)
    assert preview(pool, (-1.0, 0.0)) is None
    shown = preview(
        pool, (pool.eight.position[0] - pool.cue.position[0], pool.eight.position[1] - pool.cue.position[1])
    )
    assert shown is not None
    assert shown.struck is not None
    assert dist(shown.struck.start, shown.struck.end) == pytest.approx(400.0)


# -- the marks of impacts --------------------------------------------------------------------------------------------


@pytest.mark.compiled
@pytest.mark.parametrize("turn", range(12))
def test_marks_show_the_balls_where_they_touched(turn: int) -> None:
    pool = Pool()
    angle = 2.0 * pi * turn / 12.0 + 0.1
    pool.shoot((cos(angle), sin(angle)), 0.9)
    before = {ball.name: ball.position for ball in pool.world.balls}
    seen = 0
    radius = pool.cue.radius
    while pool.moving:
        pool.step()
        after = {ball.name: ball.position for ball in pool.world.balls}
        for mark in pool.marks[seen:]:
            places = dict(mark.balls)
            for name, place in places.items():
                # At most the way of one step lies between where it was then and where it was before and after.
                assert dist(before[name], place) < FASTEST * STEP
                assert dist(place, after[name]) < FASTEST * STEP
            if mark.impact is Impact.BALLS:
                assert dist(places["cue ball"], places["eight"]) == pytest.approx(2.0 * radius, abs=1e-9)
            else:
                (place,) = places.values()
                assert nearest_cushion(pool, place) == pytest.approx(radius, abs=1e-6)
        seen = len(pool.marks)
        before = after
    assert seen > 0
    assert [mark.number for mark in pool.marks] == [*range(1, seen + 1)]
    assert [mark.time for mark in pool.marks] == sorted(mark.time for mark in pool.marks)


def nearest_cushion(pool: Pool, place: tuple[float, float]) -> float:
    """How far the nearest cushion or pocket wall is from a place."""
    walls = [shape for shape in pool.world.shapes if shape.name in ("cushion", "pocket")]
    return min(dist(wall.closest_point(place), place) for wall in walls)


def test_a_path_leads_over_the_marks_to_where_the_ball_is() -> None:
    pool = Pool(EASY)
    assert pool.path("cue ball") == [EASY.cue, EASY.cue]
    pool.shoot(DIAGONAL, 0.3)
    play_out(pool)
    impacts = [dict(mark.balls) for mark in pool.marks]
    assert pool.path("cue ball")[0] == EASY.cue
    assert pool.path("cue ball")[1] == impacts[0]["cue ball"]
    assert pool.path("cue ball")[-1] == pool.cue.position
    assert pool.path("eight") == [EASY.eight, *(places["eight"] for places in impacts if "eight" in places)]


def test_what_goes_on_inside_a_pocket_is_not_marked() -> None:
    pool = Pool(DANGER)
    pool.shoot(DIAGONAL, 0.5)
    for _ in range(200):
        pool.step()
    assert [mark.impact for mark in pool.marks] == [Impact.POCKET]
    assert pool.noises[0][0] is Impact.STRIKE
    assert [impact for impact, _ in pool.noises[1:]] == [Impact.POCKET]


def test_balls_roll_on_to_the_next_impact_and_no_further() -> None:
    pool = Pool(Setup(cue=(232.0, 105.0), eight=EASY.eight))
    pool.world.step(0.5)
    pool.shoot(DIAGONAL, 0.3)
    steps = pool.to_impact()
    assert len(pool.marks) == 1
    assert pool.marks[0].time == pytest.approx(steps * STEP, abs=STEP)
    assert pool.age == pytest.approx(steps * STEP)
    assert pool.to_impact(most=2) == 2


# -- positions to begin with -----------------------------------------------------------------------------------------


def test_a_trial_leaves_no_trace() -> None:
    pool = Pool(EASY)
    pool.shoot(DIAGONAL, 0.0)
    for _ in range(5):
        pool.step()
    pool.place(EASY)
    digest, state = pool.digest(), (list(pool.marks), list(pool.noises), dict(pool.potted), pool.shots)
    assert setups.wins(pool, DIAGONAL, 0.3)
    assert pool.digest() == digest
    assert (pool.marks, pool.noises, pool.potted, pool.shots) == state
    assert not setups.wins(pool, (-1.0, 0.0), 0.0)


def test_a_winning_shot_is_found() -> None:
    pool = Pool(EASY)
    shot, power = setups.winning(pool) or pytest.fail("none")
    assert shot.pocket == "upper right pocket"
    assert shot.fullness == pytest.approx(1.0, abs=1e-3)
    assert power in setups.POWERS
    pool.place(Setup(cue=(200.0, 63.0), eight=(251.0, 63.0)))
    assert setups.winning(pool) is None


def test_shots_that_cannot_win_are_not_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = []
    monkeypatch.setattr(setups, "wins", lambda pool, direction, power: tried.append(power))
    assert setups.winning(Pool(GREEDY)) is None
    assert {*tried} < {*setups.POWERS}
    assert 0.5 in tried
    assert 0.8 not in tried


@pytest.mark.slow
@pytest.mark.compiled
def test_every_position_can_be_won_at_once() -> None:
    pool = Pool()
    places = [setups.setup(pool, number) for number in range(40)]
    assert places[0] == FIRST
    assert len({place.eight for place in places}) == 40
    for place in places:
        pool.place(place)
        shot, power = setups.winning(pool) or pytest.fail(f"{place} cannot be won")
        pool.shoot(shot.direction, power)
        play_out(pool)
        assert pool.phase is Phase.WON


def test_positions_are_the_same_for_the_same_seed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setups, "wins", lambda *shot: True)
    pool = Pool()
    first = [setups.setup(pool, number, seed=7) for number in range(3)]
    assert [setups.setup(Pool(), number, seed=7) for number in range(3)] == first
    assert setups.setup(pool, 2, seed=8) != first[2]
    for place in [setups.setup(pool, number, seed=7) for number in range(1, 60)]:
        assert dist(place.cue, place.eight) >= setups.APART
        assert all(14.0 <= x <= 240.0 and 14.0 <= y <= 113.0 for x, y in (place.cue, place.eight))


@pytest.mark.slow
@pytest.mark.compiled
def test_the_same_shots_end_in_the_same_bits() -> None:
    digests = set()
    for _ in range(2):
        pool = Pool()
        for angle in (0.3, 2.0, 4.1):
            pool.shoot((cos(angle), sin(angle)), 0.7)
            play_out(pool)
        digests.add(pool.digest())
    assert len(digests) == 1


def test_the_table_has_six_pockets_and_the_two_balls() -> None:
    pool = Pool()
    assert sum(isinstance(shape, carom.Circle) and shape.sensor for shape in pool.world.shapes) == 6
    assert [ball.name for ball in pool.world.balls] == ["cue ball", "eight"]
