"""The saucer: it holds a ball that would strike the post behind it, for a moment, and what that brings."""

from math import cos, hypot, radians, sin

import pytest

import carom
from carom.play.pinball import Control, Event, EventKind, LampState
from carom.play.pinball.robot.foresight import Foresight, Presses
from carom.play.pinball.rules.balls import HOLD
from carom.play.pinball.rules.lamps import BUMPERS, ORBITS, SAUCER
from carom.play.pinball.rules.modes import MODES
from carom.play.pinball.rules.rules import JACKPOT, MORE_TIME, SAUCER_CATCH
from carom.play.pinball.rules.table import BALL_RADIUS, SAUCER_PLACE, STEP, Table
from carom.play.pinball.screen.effects import Effects, announced
from tests.play.pinball.desk import Desk
from tests.play.pinball.test_rules import Played

#: Where a ball is shot at the saucer from, and how.
FROM, TOWARDS = (7.3, 17.55), (-26.0, 66.0)


@pytest.fixture
def desk() -> Desk:
    return Desk()


@pytest.fixture
def played() -> Played:
    return Played(Table())


def shot(desk: Desk, place: tuple[float, float] = FROM, velocity: tuple[float, float] = TOWARDS) -> carom.Ball:
    """A ball on the field, on its way to the saucer."""
    (ball,) = desk.game.world.balls
    ball.position, ball.velocity = (9.3, 30.0), (0.0, 0.0)
    desk.tick(4)
    ball.position, ball.velocity = place, velocity
    return ball


# -- the place ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [60.0, 65.0, 70.0, 75.0])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_what_rolls_past_the_post_rolls_past_the_saucer_and_what_strikes_it_is_held(
    degrees: float, side: float
) -> None:
    table = Table()
    x, y = table.places["left post"]
    along, up = -cos(radians(degrees)), sin(radians(degrees))
    for off, met in ((side * 1.02, []), (side * 0.3, [SAUCER, "left post"])):
        place = (x + off * up - 2.0 * along, y - off * along - 2.0 * up)
        ball = table.world.add(carom.Ball(place, BALL_RADIUS, (85.0 * along, 85.0 * up)))
        names = [table.parts[hit.shape.id or 0].name for _ in range(24) for hit in table.world.step(STEP)]
        assert names[:1] == met[:1] or (not met and SAUCER not in names), (names, off)
        assert ("left post" in names) is bool(met)
        table.world.remove(ball)


def test_closed_it_lets_balls_roll_over_it() -> None:
    table = Table()
    table.saucer_open = False
    ball = table.world.add(carom.Ball((6.1, 19.5), BALL_RADIUS, (0.0, 20.0)))
    names = [table.parts[hit.shape.id or 0].name for _ in range(40) for hit in table.world.step(STEP)]
    assert SAUCER not in names
    table.reset()
    ball.position, ball.velocity = (6.1, 19.5), (0.0, 20.0)
    names = [table.parts[hit.shape.id or 0].name for _ in range(40) for hit in table.world.step(STEP)]
    assert SAUCER in names


# -- what it does ------------------------------------------------------------------------------------------------------


def test_it_holds_a_ball_for_a_while_and_lets_it_go_downward(desk: Desk) -> None:
    ball, game = shot(desk), desk.game
    desk.tick(24)
    assert desk.kinds().count(EventKind.SAUCER) == 1
    assert not game.table.saucer_open
    desk.tick(HOLD // 2)
    game.press(Control.NUDGE_RIGHT, True)
    desk.tick(40)
    assert ball.position == pytest.approx(SAUCER_PLACE, abs=0.01)
    assert hypot(*ball.velocity) < 0.5
    assert (game.balls_in_play, game.ledger.check(game.world)) == (1, True)
    assert EventKind.KICKOUT not in desk.kinds()
    desk.tick(HOLD // 2)
    assert desk.kinds().count(EventKind.KICKOUT) == 1
    assert EventKind.FREED not in desk.kinds()
    desk.tick(120)
    assert ball.position[1] < SAUCER_PLACE[1] - 2.0


def test_another_ball_is_not_held_meanwhile_and_bounces_off_the_first(desk: Desk) -> None:
    held, game = shot(desk), desk.game
    desk.tick(60)
    game._balls.serve()
    other = game.world.balls[-1]
    other.position, other.velocity = (9.3, 30.0), (0.0, 0.0)
    desk.tick(4)
    game.table.saucer_open = True
    other.position, other.velocity = (7.0, 18.3), (-13.0, 33.0)
    desk.tick(60)
    assert desk.kinds().count(EventKind.SAUCER) == 1
    assert held.position == pytest.approx(SAUCER_PLACE, abs=0.3)
    assert hypot(other.position[0] - held.position[0], other.position[1] - held.position[1]) > 1.15
    assert game.ledger.check(game.world)


def test_it_is_empty_once_its_ball_was_taken_out(desk: Desk) -> None:
    ball, game = shot(desk), desk.game
    desk.tick(24)
    game._balls.take(ball.id or 0)
    desk.tick(HOLD + 8)
    assert EventKind.KICKOUT not in desk.kinds()
    assert game._balls.catch(7) is False
    state = game._balls.states
    assert all(game._balls.catch(key) for key in list(state)[:1])


def test_after_a_tilt_it_holds_nothing(desk: Desk) -> None:
    shot(desk)
    desk.game._tilt()
    desk.tick(24)
    assert EventKind.SAUCER not in desk.kinds()


# -- what it brings ----------------------------------------------------------------------------------------------------


def test_it_starts_the_next_mode_closes_and_an_orbit_opens_it(played: Played) -> None:
    rules = played.rules
    assert (rules.goal, rules.lamps[SAUCER]) == ("SAUCER FOR A MODE", LampState.BLINK)
    assert played.meet(SAUCER) == SAUCER_CATCH
    assert rules.modes.mode is MODES[0]
    assert (rules.table.saucer_open, rules.lamps[SAUCER]) == (False, LampState.OFF)
    played.wait(MODES[0].seconds + 1)
    assert rules.goal == "BUMPERS FOR A MODE"
    played.meet(ORBITS[0])
    assert (rules.table.saucer_open, rules.lamps[SAUCER]) == (True, LampState.BLINK)
    assert rules.goal == "SAUCER FOR A MODE"


def test_in_a_mode_it_gives_more_time_and_in_multiball_it_is_a_jackpot(played: Played) -> None:
    played.meet(*BUMPERS)
    played.wait(20)
    assert played.meet(SAUCER) == SAUCER_CATCH
    mode = MODES[0]
    assert played.rules.goal == f"{mode.words} {mode.worth:,} {mode.seconds - 20 + MORE_TIME} S"
    assert [event.part for event in played.told(EventKind.MORE)] == ["10 S MORE"]
    effects = Effects()
    effects.note(played.events)
    assert effects.news is not None
    assert effects.news.words == "10 S MORE", "the display says it last"
    assert len(played.told(EventKind.MODE)) == 1
    played.rules._start_multiball((0.0, 0.0))
    assert played.rules.table.saucer_open
    assert played.meet(SAUCER) == JACKPOT
    assert played.rules.modes.mode is None


def test_a_new_ball_finds_it_open(played: Played) -> None:
    played.meet(SAUCER)
    played.rules.start_ball()
    assert (played.rules.table.saucer_open, played.rules.lamps[SAUCER]) == (True, LampState.BLINK)


@pytest.mark.parametrize(
    ("event", "words"),
    [
        (Event(EventKind.SAUCER, SAUCER, score=SAUCER_CATCH), "SAUCER"),
        (Event(EventKind.SAUCER, SAUCER, score=JACKPOT), "JACKPOT"),
        (Event(EventKind.MORE, "10 S MORE"), "10 S MORE"),
        (Event(EventKind.KICKOUT, SAUCER), ""),
    ],
    ids=["saucer", "jackpot", "more", "kickout"],
)
def test_the_display_announces_what_it_brings(event: Event, words: str) -> None:
    assert announced(event) == words


def test_it_flashes_when_it_holds_a_ball_and_when_it_lets_it_go() -> None:
    for kind in (EventKind.SAUCER, EventKind.KICKOUT):
        effects = Effects()
        effects.note([Event(kind, SAUCER)])
        assert effects.kicks(SAUCER)


def test_the_player_that_looks_ahead_sees_whether_it_is_open() -> None:
    foresight, real = Foresight(), Table()
    state = (*FROM, *TOWARDS)
    open_worth = foresight.worth(real, state, Presses(), 40)
    real.saucer_open = False
    assert foresight.worth(real, state, Presses(), 40) == pytest.approx(open_worth - 1500.0)
    real.saucer_open = True
    assert foresight.worth(real, state, Presses(), 40) == open_worth
