"""Pool with more balls: all of them within so many shots, the cue ball comes back, and pockets hold any number."""

from __future__ import annotations

from math import dist, pi
from pathlib import Path

import pygame
import pytest

from carom.cli.games import MOST_BALLS
from carom.play.pool import setups
from carom.play.pool.actions import Action
from carom.play.pool.app import PoolApp
from carom.play.pool.game import NAMES, ROOM, Fall, Phase, Pool, Setup
from carom.play.pool.preview import preview
from carom.play.pool.session import GAMES, Session
from carom.play.pool.view import NUMBERS
from carom.play.pool.words import detail, ending, headline, outlook, rule, tally
from carom.play.window import Window
from tests.play import screens

DIAGONAL = (1.0, 1.0)

#: Straight behind each other for the upper right pocket: the cue ball, the one, the eight.
BEHIND = Setup(cue=(232.0, 105.0), eight=(248.0, 121.0), more=((241.0, 114.0),))

#: The cue ball lies in the jaws.
DANGER = Setup(cue=(244.0, 117.0), eight=(100.0, 60.0), more=((63.5, 63.5),))


def shot(pool: Pool, direction: tuple[float, float], power: float) -> Pool:
    """A game after a shot, all balls of which lie still."""
    pool.shoot(direction, power)
    while pool.moving:
        pool.step()
    assert pool.world.strays == []
    return pool


def seated(setup: Setup) -> Session:
    """A sitting with the balls in a position."""
    session = Session()
    session.pool = Pool(setup)
    session.angle = pi / 4.0
    return session


def test_one_pocket_takes_all_balls_and_the_game_is_won_with_the_last() -> None:
    session = seated(BEHIND)
    pool = shot(session.pool, DIAGONAL, 0.5)
    assert [*pool.potted] == ["eight"]
    assert (pool.phase, pool.shots, pool.limit, pool.used) == (Phase.AIM, 1, 4, 1)
    assert headline(session)[0] == "Shoot again: one ball in 3 shots"
    (x, y), (cue_x, cue_y) = pool.targets[0].position, pool.cue.position
    shot(pool, (x - cue_x, y - cue_y), 0.4)
    assert pool.phase is Phase.WON
    assert {fall.pocket for fall in pool.potted.values()} == {"upper right pocket"}
    centre = next(shape.position for shape in pool.world.shapes if shape.name == "upper right pocket")
    assert all(dist(ball.position, centre) < 8.0 for ball in pool.balls[1:])
    assert pool.gone == {"eight"}
    assert ending(pool) == "All balls are down after 2 shots"


def test_a_foul_costs_a_shot_and_brings_the_cue_ball_back_to_the_base_line() -> None:
    session = seated(DANGER)
    pool = shot(session.pool, DIAGONAL, 0.3)
    assert (pool.phase, pool.shots, pool.fouls, pool.used) == (Phase.AIM, 1, 1, 2)
    assert pool.potted == {}
    x, y = pool.cue.position
    assert x == pytest.approx(254.0 / 4.0)
    # The one lies on the middle of the line.
    assert abs(y - 63.5) == pytest.approx(ROOM * pool.cue.radius, abs=3.0)
    assert min(dist(ball.position, (x, y)) for ball in pool.targets) >= ROOM * pool.cue.radius
    assert headline(session)[0] == "Foul, cue ball in hand: 2 balls in 2 shots"
    assert tally(session) == "position 1  ·  0 of 2 down  ·  shots 1 of 4  ·  1 foul  ·  won 0  ·  lost 0"
    pool.put_cue(20.0)
    assert pool.cue.position == pytest.approx((254.0 / 4.0, 20.0))
    assert pool.setup == DANGER
    # It meets balls again, and may not be put anywhere after the next shot.
    shot(pool, (DANGER.eight[0] - 63.5, DANGER.eight[1] - 20.0), 0.4)
    assert pool.eight.position != DANGER.eight
    assert (pool.base_line, pool.phase) == (None, Phase.AIM)


def test_out_of_shots_the_game_is_lost() -> None:
    pool = Pool(DANGER)
    for fouls in (1, 2):
        shot(pool, DIAGONAL, 0.3)
        assert pool.fouls == fouls
        pool.cue.position = DANGER.cue
    assert (pool.phase, pool.used) == (Phase.LOST, 4)
    assert ending(pool) == "You had 4 shots: 2 shots and 2 fouls, and 2 balls are left"
    pool.place(DANGER)
    assert (pool.phase, pool.used, pool.in_hand, pool.potted) == (Phase.AIM, 0, True, {})


def test_the_last_ball_with_a_foul_too_many_loses() -> None:
    pool = Pool(BEHIND)
    pool.shots, pool.phase = 4, Phase.ROLL
    pool.potted.update(dict.fromkeys(("one", "eight", "cue ball"), Fall("upper right pocket", 0.0)))
    pool._rest()
    assert (pool.phase, pool.used) == (Phase.LOST, 5)
    assert ending(pool) == "You had 4 shots: 4 shots and a foul"


def test_a_trial_that_fouls_and_pots_leaves_no_trace() -> None:
    for setup in (BEHIND, DANGER):
        pool = Pool(setup)
        before = pool.digest(), pool.setup, dict(pool.potted), [ball.layer for ball in pool.balls], pool.shot_from
        assert setups.wins(pool, DIAGONAL, 0.4) is (setup is BEHIND)
        after = pool.digest(), pool.setup, dict(pool.potted), [ball.layer for ball in pool.balls], pool.shot_from
        assert after == before
        assert pool.in_hand


def test_the_line_of_aim_ends_at_the_next_ball() -> None:
    pool = Pool(Setup(cue=(60.0, 60.0), eight=(100.0, 60.0), more=((150.0, 60.0),)))
    shown = preview(pool, (1.0, 0.0))
    assert shown is not None
    assert shown.struck is not None
    assert (shown.struck.ball, shown.struck.pocket) == ("one", None)
    assert shown.struck.end == pytest.approx((150.0 - 2.0 * pool.cue.radius, 60.0))
    assert outlook(pool, shown, 0.8) == "The eight meets the one"
    assert outlook(pool, shown, 0.25) == "The eight stops before the one"
    pool.shoot((1.0, 0.0), 0.8)
    pool.to_impact()
    pool.to_impact()
    assert {name for name, _ in pool.marks[1].balls} == {"eight", "one"}


@pytest.mark.parametrize("balls", [2, len(NAMES)])
def test_positions_are_the_same_for_the_same_seed_and_leave_room(balls: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setups, "wins", lambda *shot: True)
    pool = Pool.of(balls)
    first = setups.setup(pool, 0, seed=3)
    assert setups.setup(Pool.of(balls), 0, seed=3) == first != setups.setup(pool, 1, seed=3)
    places = (first.eight, *first.more)
    assert len(places) == balls
    assert all(dist(one, other) >= setups.AMONG for one in places for other in places if one is not other)
    assert all(dist(first.cue, place) >= setups.APART for place in places)


def test_a_key_leads_from_game_to_game_and_back(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setups, "wins", lambda *shot: True)
    session, seen, told = Session(balls=2), [], []
    for _ in range(5):
        seen.append(len(session.pool.targets))
        told.append(rule(session.pool).split(".")[0])
        session.begin(Action.MORE)
    assert seen == [2, 3, 5, 8, 1]
    shots = [f"Pot {balls} balls, in any order, in {most} shots" for balls, most in ((2, 4), (3, 5), (5, 8), (8, 13))]
    assert told == [*shots, "Pot the eight and keep the cue ball on the table"]
    assert (session.won, session.lost, session.number, GAMES[0]) == (0, 0, 0, 1)
    assert MOST_BALLS == len(NAMES) == max(GAMES) == len(NUMBERS) - 1


def test_words_say_what_is_down() -> None:
    session = seated(BEHIND)
    session.pool.shoot(DIAGONAL, 0.5)
    assert headline(session)[0] == "The balls roll"
    while not session.pool.potted:
        session.pool.step()
    assert headline(session)[0] == "The eight is down"
    assert detail(session) == "Hold Space to hurry"
    session.pool.potted["one"] = session.pool.potted["eight"]
    assert headline(session)[0] == "2 balls are down"
    session.pool.potted["cue ball"] = session.pool.potted["eight"]
    assert headline(session)[0] == "Foul: the cue ball is down"


def test_a_table_with_eight_balls_looks_as_it_did(renew: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setups, "wins", lambda *shot: True)
    pygame.display.init()
    app = PoolApp(lambda line: None, balls=8)
    window = Window(app)
    window.frame(1 / 60)
    screens.check("pool-eight-balls", window.surface, renew=renew, folder=tmp_path)
