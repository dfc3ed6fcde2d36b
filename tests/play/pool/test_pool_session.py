"""What each key does at the pool table: aim, power, shots, modes, and game after game."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, radians, sin

import pytest

from carom.play.pool import setups
from carom.play.pool.actions import BUTTONS, HELP, KEYS, Action
from carom.play.pool.game import STEP, Impact, Mark, Phase, Setup, speed_of
from carom.play.pool.preview import Leg, Preview, rest_before_impact, until_rest
from carom.play.pool.session import (
    CLICK,
    DRAW_TIME,
    FINE_NOTCH,
    FRAME_STEPS,
    HURRY,
    NOTCH,
    POWER_NOTCH,
    TURN,
    TURN_AFTER,
    Mode,
    Session,
)
from carom.play.pool.words import detail, ending, headline, impact_line, outlook, tally

EASY = Setup(cue=(238.0, 111.0), eight=(248.0, 121.0))
DANGER = Setup(cue=(244.0, 117.0), eight=(60.0, 60.0))


def seated(place: Setup | None = None) -> Session:
    """A sitting whose balls lie somewhere."""
    session = Session()
    if place is not None:
        session.pool.place(place)
        session.angle = pi / 4.0
    return session


def press(session: Session, action: Action, ticks: int = 0) -> None:
    """Press a key, hold it for some ticks, and let it go."""
    session.begin(action)
    wait(session, ticks)
    session.end(action)


def wait(session: Session, ticks: int) -> None:
    """Let some ticks go by."""
    for _ in range(ticks):
        session.tick()


def won(place: Setup = EASY) -> Session:
    """A sitting whose first game is won."""
    session = seated(place)
    session.power = 0.3
    press(session, Action.SHOOT)
    while not session.pool.over:
        session.tick()
    return session


# -- aim and power ---------------------------------------------------------------------------------------------------


def test_at_first_the_cue_points_at_the_eight() -> None:
    session = Session()
    (x, y), (to_x, to_y) = session.pool.cue.position, session.pool.eight.position
    way = hypot(to_x - x, to_y - y)
    assert session.direction == pytest.approx(((to_x - x) / way, (to_y - y) / way))


def test_the_mouse_aims_at_where_it_is() -> None:
    session = Session()
    session.point((72.0, 100.0))
    assert session.direction == pytest.approx((0.0, 1.0))
    session.point(session.pool.cue.position)
    assert session.direction == pytest.approx((0.0, 1.0))


@pytest.mark.parametrize(("action", "side"), [(Action.TURN_LEFT, 1.0), (Action.TURN_RIGHT, -1.0)])
def test_a_press_turns_by_a_notch_and_with_shift_by_a_fine_one(action: Action, side: float) -> None:
    session = Session()
    angle = session.angle
    press(session, action)
    assert session.angle - angle == pytest.approx(side * NOTCH)
    session.begin(Action.FINE)
    press(session, action)
    session.end(Action.FINE)
    assert session.angle - angle == pytest.approx(side * (NOTCH + FINE_NOTCH))


def test_a_key_that_is_held_goes_on_turning() -> None:
    session = Session()
    angle = session.angle
    ticks = round(TURN_AFTER / STEP) + 60
    press(session, Action.TURN_LEFT, ticks)
    assert session.angle - angle == pytest.approx(NOTCH + 60 * STEP * TURN, abs=2 * STEP * TURN)
    turned = session.angle
    wait(session, 20)
    assert session.angle == turned


def test_angles_stay_within_half_a_turn() -> None:
    session = Session()
    session.angle = pi - 0.001
    press(session, Action.TURN_LEFT)
    assert -pi <= session.angle < -pi + radians(1.0)


def test_power_goes_up_and_down_between_nothing_and_all() -> None:
    session = Session()
    press(session, Action.STRONGER)
    assert session.power == pytest.approx(0.5 + POWER_NOTCH)
    press(session, Action.WEAKER, 200)
    assert 0.0 <= session.power < 0.3
    session.change_power(7.0)
    assert session.power == 1.0
    press(session, Action.STRONGER, 60)
    assert session.power == 1.0


# -- shots -----------------------------------------------------------------------------------------------------------


def test_the_cue_is_drawn_while_held_and_shoots_when_let_go() -> None:
    session = Session()
    session.begin(Action.DRAW)
    wait(session, round((CLICK + 0.7 * DRAW_TIME) / STEP))
    assert session.strength == session.draw == pytest.approx(0.7, abs=0.01)
    assert session.pool.phase is Phase.AIM
    session.end(Action.DRAW)
    assert session.pool.phase is Phase.ROLL
    assert hypot(*session.pool.cue.velocity) == pytest.approx(speed_of(0.7), rel=0.02)
    assert session.draw is None


def test_the_power_that_was_set_stays_whatever_is_drawn() -> None:
    session = seated()
    session.power = 0.3
    press(session, Action.DRAW, round((CLICK + 0.7 * DRAW_TIME) / STEP))
    assert session.pool.shots == 1
    assert session.power == session.strength == 0.3


def test_a_cue_that_is_held_on_stays_drawn() -> None:
    session = Session()
    session.begin(Action.DRAW)
    wait(session, round((CLICK + DRAW_TIME) / STEP) + 1)
    before = session.draw
    wait(session, round(2.5 * DRAW_TIME / STEP))
    assert (before, session.draw) == (1.0, 1.0)


@pytest.mark.parametrize("ticks", [0, 2, round(CLICK / STEP) - 1])
def test_a_click_shoots_with_the_power_shown(ticks: int) -> None:
    session = Session()
    session.power = 0.42
    session.begin(Action.DRAW)
    wait(session, ticks)
    assert session.strength == 0.42
    session.end(Action.DRAW)
    assert session.pool.shots == 1
    assert hypot(*session.pool.cue.velocity) == pytest.approx(speed_of(0.42))


def test_while_the_cue_is_drawn_the_mouse_does_not_turn_it() -> None:
    session = Session()
    session.begin(Action.DRAW)
    angle = session.angle
    session.point((10.0, 10.0))
    assert session.angle == angle


def test_the_cue_can_be_put_down() -> None:
    session = Session()
    session.begin(Action.DRAW)
    wait(session, 30)
    press(session, Action.CANCEL)
    session.end(Action.DRAW)
    assert session.pool.phase is Phase.AIM
    assert session.pool.shots == 0


def test_return_shoots_with_the_power_shown() -> None:
    session = seated(DANGER)
    session.power = 0.25
    press(session, Action.SHOOT)
    assert session.pool.phase is Phase.ROLL
    assert session.power == 0.25
    press(session, Action.SHOOT)
    assert session.pool.shots == 1


def test_balls_hurry_while_space_is_held() -> None:
    session = Session()
    press(session, Action.SHOOT)
    wait(session, 1)
    begun = session.pool.world.time
    session.begin(Action.DRAW)
    wait(session, 4)
    assert session.pool.world.time - begun == pytest.approx(4 * HURRY * STEP)


@pytest.mark.parametrize("power", [0.0, 0.06, 0.18, 0.25])
def test_the_preview_ends_where_the_balls_will_stop(power: float) -> None:
    session = seated(Setup(cue=(100.0, 60.0), eight=(130.0, 66.0)))
    session.point((130.0, 66.0))
    session._turn(radians(3.0))
    pool, shown = session.pool, session.preview()
    assert shown is not None
    rest = rest_before_impact(pool, shown, power)
    ends = [rest or shown.aim.ghost, pool.eight.position]
    if rest is None:
        assert shown.cue is not None
        assert shown.struck is not None
        ends = [
            until_rest(pool, shown, shown.cue, shown.aim.speed, power).end,
            until_rest(pool, shown, shown.struck, shown.aim.other_speed, power).end,
        ]
    assert (rest is None) is (power > 0.1)
    pool.shoot(session.direction, power)
    while pool.moving:
        pool.step()
    assert len(pool.marks) == (rest is None)
    for ball, end in zip((pool.cue, pool.eight), ends, strict=True):
        assert ball.position == pytest.approx(end, abs=0.3)


# -- games -----------------------------------------------------------------------------------------------------------


def test_a_game_that_is_won_and_one_that_is_lost_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setups, "wins", lambda *shot: True)
    session = won()
    assert (session.won, session.lost) == (1, 0)
    assert session.since_end == 0.0
    press(session, Action.SHOOT)
    assert session.number == 1
    assert session.pool.phase is Phase.AIM
    session.pool.place(DANGER)
    session.angle = pi / 4.0
    press(session, Action.SHOOT, 0)
    wait(session, 60)
    assert session.pool.phase is Phase.LOST
    assert (session.won, session.lost) == (1, 1)
    press(session, Action.DRAW)
    assert (session.number, session.pool.phase, session.draw) == (2, Phase.AIM, None)
    press(session, Action.AGAIN)
    assert session.number == 3


def test_the_same_position_can_be_played_again() -> None:
    session = won()
    press(session, Action.SAME)
    assert session.number == 0
    assert session.pool.phase is Phase.AIM
    assert session.pool.cue.position == EASY.cue
    assert session.angle == pytest.approx(pi / 4.0)


def test_after_a_shot_the_cue_points_at_the_mouse_or_else_at_the_eight() -> None:
    session = Session()
    session.power, session.angle = 0.0, 0.0
    press(session, Action.SHOOT)
    while session.pool.phase is Phase.ROLL:
        session.tick()
    (x, y), (to_x, to_y) = session.pool.cue.position, session.pool.eight.position
    assert session.angle == pytest.approx(atan2(to_y - y, to_x - x))
    session.angle = 0.0
    press(session, Action.SHOOT)
    session.point((10.0, 10.0))
    assert session.angle == 0.0
    while session.pool.phase is Phase.ROLL:
        session.tick()
    x, y = session.pool.cue.position
    assert session.angle == pytest.approx(atan2(10.0 - y, 10.0 - x))


def test_who_turned_the_cue_by_keys_has_left_the_mouse() -> None:
    session = Session()
    session.point((72.0, 10.0))
    press(session, Action.TURN_LEFT)
    session.power = 0.0
    press(session, Action.SHOOT)
    while session.pool.phase is Phase.ROLL:
        session.tick()
    (x, y), (to_x, to_y) = session.pool.cue.position, session.pool.eight.position
    assert session.angle == pytest.approx(atan2(to_y - y, to_x - x))


# -- modes -----------------------------------------------------------------------------------------------------------


def test_step_by_step_a_press_is_one_frame() -> None:
    session = Session()
    press(session, Action.STEPS)
    press(session, Action.SHOOT)
    wait(session, 30)
    assert session.pool.age == 0.0
    press(session, Action.FRAME)
    assert session.pool.age == pytest.approx(FRAME_STEPS * STEP)
    assert pytest.approx(1.0 / 60.0) == FRAME_STEPS * STEP
    press(session, Action.STEPS)
    wait(session, 3)
    assert session.pool.age == pytest.approx((FRAME_STEPS + 3) * STEP)


def test_step_by_step_a_press_goes_on_to_the_next_impact() -> None:
    session = seated(Setup(cue=(232.0, 105.0), eight=EASY.eight))
    press(session, Action.STEPS)
    press(session, Action.TO_IMPACT)
    assert session.pool.world.time == 0.0
    session.power = 0.3
    press(session, Action.SHOOT)
    press(session, Action.TO_IMPACT)
    assert [mark.impact for mark in session.pool.marks] == [Impact.BALLS]
    press(session, Action.TO_IMPACT)
    assert len(session.pool.marks) == 2
    while session.pool.moving:
        press(session, Action.TO_IMPACT)
    assert session.won == 1


def test_a_pause_and_the_help_stop_the_balls() -> None:
    for action in (Action.PAUSE, Action.HELP):
        session = Session()
        press(session, Action.SHOOT)
        press(session, action)
        wait(session, 5)
        assert session.pool.age == 0.0
        press(session, action)
        wait(session, 5)
        assert session.pool.age == pytest.approx(5 * STEP)


def test_nothing_is_shot_in_a_pause() -> None:
    session = Session()
    press(session, Action.PAUSE)
    press(session, Action.SHOOT)
    press(session, Action.DRAW, 60)
    assert session.pool.shots == 0


@pytest.mark.parametrize(
    ("action", "mode"),
    [(Action.IMPACTS, Mode.IMPACTS), (Action.RATE, Mode.RATE), (Action.MUTE, Mode.MUTE), (Action.HELP, Mode.HELP)],
)
def test_a_switch_goes_on_and_off(action: Action, mode: Mode) -> None:
    session = Session()
    press(session, action)
    assert session.modes == {mode}
    press(session, action)
    assert session.modes == set()


def test_escape_closes_the_help_then_ends_the_sitting() -> None:
    session = Session()
    press(session, Action.HELP)
    press(session, Action.QUIT)
    assert (session.modes, session.running) == (set(), True)
    press(session, Action.QUIT)
    assert not session.running


def test_the_same_presses_end_in_the_same_bits() -> None:
    digests = set()
    for _ in range(2):
        session = seated(EASY)
        press(session, Action.TURN_LEFT, 40)
        press(session, Action.TURN_RIGHT, 40)
        press(session, Action.DRAW, 60)
        wait(session, 60)
        digests.add(session.pool.digest())
    assert len(digests) == 1


# -- words -----------------------------------------------------------------------------------------------------------


def test_the_help_names_every_key_and_every_button() -> None:
    import pygame

    keys = " ".join(words for words, _, _ in HELP)
    names = {pygame.K_LSHIFT: "Shift", pygame.K_RSHIFT: "Shift", pygame.K_KP_ENTER: "Return", pygame.K_ESCAPE: "Esc"}
    text = keys + " " + " ".join(what for _, _, what in HELP)
    pygame.display.init()
    for key in KEYS:
        name = names.get(key, pygame.key.name(key))
        assert name.lower() in text.lower().replace(",", "").split(), name
    assert {*BUTTONS.values()} < {*Action}
    assert {*KEYS.values()} == {*Action}


def test_words_say_how_the_game_stands() -> None:
    session = seated(EASY)
    session.power = 0.3
    assert headline(session)[0] == "Pot the eight"
    assert detail(session) == "The eight goes to the upper right pocket"
    session.begin(Action.DRAW)
    assert headline(session)[0] == "Pot the eight"
    wait(session, 60)
    assert headline(session)[0] == "Let go to shoot"
    press(session, Action.CANCEL)
    session.power = 0.3
    press(session, Action.SHOOT)
    assert headline(session)[0] == "The balls roll"
    assert detail(session) == "Hold Space to hurry"
    session.modes.add(Mode.STEPS)
    assert detail(session).startswith("0.000 s after the shot")
    session.modes = {Mode.IMPACTS}
    session.pool.to_impact()
    assert detail(session).startswith("Impact 1, ")
    session.modes = set()
    while "eight" not in session.pool.potted:
        session.pool.step()
    assert headline(session)[0] == "The eight is down"
    assert detail(session) == "Now the cue ball must stay on the table"
    while session.pool.moving:
        session.pool.step()
    assert headline(session)[0] == "You win"
    assert detail(session) == "The eight fell into the upper right pocket after one shot"
    assert tally(session).startswith("position 1")
    session.modes = {Mode.PAUSE}
    assert headline(session)[0] == "Paused"


def test_words_say_why_a_game_is_lost() -> None:
    session = seated(DANGER)
    assert detail(session) == "The cue ball falls into the upper right pocket"
    session.power = 0.3
    press(session, Action.SHOOT)
    while not session.pool.over:
        session.pool.step()
    assert headline(session)[0] == "You lose"
    assert detail(session) == "The cue ball fell into the upper right pocket"
    session.pool.potted["eight"] = session.pool.potted["cue ball"]
    assert ending(session.pool).endswith(", and the eight fell too")


def test_words_say_what_a_shot_would_do() -> None:
    session = Session()
    session.angle += 0.01
    aim = session.pool.world.aim(session.pool.cue, session.direction)
    assert aim is not None
    cushion, pocket = Leg((0.0, 0.0), (9.0, 0.0), None), Leg((0.0, 0.0), (0.0, 9.0), "upper left pocket")

    def said(power: float, fall: str | None = None, cue: Leg | None = None, eight: Leg | None = None) -> str:
        return outlook(session.pool, Preview(aim, fall, cue, eight), power)

    assert outlook(session.pool, None, 1.0) == "Nothing is in the way"
    assert said(1.0) == "The cue ball meets a cushion first"
    assert said(1.0, fall="upper left pocket") == "The cue ball falls into the upper left pocket"
    assert said(1.0, cue=pocket) == "The cue ball meets a cushion first, then it falls into the upper left pocket"
    assert said(1.0, eight=cushion) == "The eight meets a cushion"
    assert said(0.325, eight=cushion) == "The eight stops before a cushion"
    assert said(0.325, eight=pocket) == "The eight stops before the upper left pocket"
    assert said(0.1, cue=pocket, eight=pocket) == "The cue ball stops before it meets anything"
    follows = "The eight goes to the upper left pocket, but the cue ball falls into the upper left pocket"
    assert said(1.0, cue=pocket, eight=pocket) == follows


def test_words_say_what_met() -> None:
    def line(impact: Impact, *names: str) -> str:
        return impact_line(Mark(3, impact, 1.25, tuple((name, (0.0, 0.0)) for name in names), (0.0, 0.0), 1.0))

    assert line(Impact.BALLS, "eight", "cue ball") == "Impact 3, 1.250 s after the shot: the cue ball and the eight"
    assert line(Impact.CUSHION, "eight").endswith("the eight and a cushion")
    assert line(Impact.POCKET, "eight").endswith("the eight and the inside of a pocket")


def test_an_angle_is_where_the_cue_points() -> None:
    session = Session()
    session.angle = 0.7
    assert session.direction == (cos(0.7), sin(0.7))
