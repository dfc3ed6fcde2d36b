"""The player who plays by itself, and what it foresees."""

from typing import Any

import pytest

import carom
from carom.play.pinball import Control, HighScores, Phase, Pinball, Player
from carom.play.pinball.robot.foresight import HEIGHT, Foresight, Presses, sweeps
from carom.play.pinball.robot.player import DECIDE, LATE
from carom.play.pinball.rules.table import BALL_RADIUS, STEP, Table
from tests.play.pinball.self_play import play


class Blind:
    """Foresight that sees what a test says, and keeps what it was asked."""

    def __init__(self, track: list[tuple[float, float]], worths: dict[Any, float]) -> None:
        self.places, self.worths = track, worths
        self.asked: list[Presses] = []

    def track(self, *_: object) -> list[tuple[float, float]]:
        return self.places

    def worth(self, real: Table, state: Any, presses: Presses, steps: int) -> float:
        self.asked.append(presses)
        return self.worths.get(presses, self.worths.get(state[2:], self.worths[None]))


class Chair:
    """A player at a game with a ball on the field, and what it presses."""

    def __init__(self, place: tuple[float, float], velocity: tuple[float, float], blind: Blind) -> None:
        self.game = Pinball(HighScores([]))
        self.game.press(Control.START, True)
        (self.ball,) = self.game.world.balls
        self.ball.position, self.ball.velocity = place, velocity
        self.pressed: list[tuple[Control, bool]] = []
        self.player = Player(self.game, 1, self.press)
        vars(self.player)["_foresight"] = blind

    def press(self, control: Control, down: bool) -> None:
        """Keep what is pressed, and do it."""
        self.pressed.append((control, down))
        self.game.press(control, down)

    def sit(self, ticks: int) -> None:
        """Let the player think and press, while the ball stands still."""
        for _ in range(ticks):
            self.player.tick()


ON_LEFT = [(7.0, 9.0)] * 4


def test_while_kernels_are_compiled_it_does_not_look_ahead(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(carom, "compiling", lambda: True)
    best = Presses((24, 84), ())
    chair = Chair((7.0, 12.0), (0.0, -9.0), blind := Blind(ON_LEFT, {best: 900.0, None: 100.0}))
    chair.sit(DECIDE + 100 + LATE)
    assert (chair.pressed, blind.asked) == ([], [])


def test_the_best_flip_is_made_a_little_late() -> None:
    best = Presses((24, 84), ())
    chair = Chair((7.0, 12.0), (0.0, -9.0), blind := Blind(ON_LEFT, {best: 900.0, None: 100.0}))
    chair.sit(DECIDE + 100 + LATE)
    assert chair.pressed == [(Control.LEFT, True), (Control.LEFT, False)]
    assert Presses() in blind.asked
    assert best in blind.asked
    assert Presses((24,), ()) in blind.asked  # raised to catch


def test_nothing_is_pressed_where_nothing_is_best() -> None:
    chair = Chair((7.0, 12.0), (0.0, -9.0), Blind(ON_LEFT, {Presses(): 500.0, None: 100.0}))
    chair.sit(80)
    assert chair.pressed == []


def test_a_flipper_that_is_held_is_let_go_when_no_ball_is_near() -> None:
    chair = Chair((9.3, 30.0), (0.0, 9.0), Blind([], {None: 0.0}))
    chair.game.press(Control.RIGHT, True)
    chair.game.tick()
    for _ in range(3 * DECIDE):
        chair.player.tick()
        chair.game.tick()
    assert chair.pressed == [(Control.RIGHT, False)]


def test_a_cradled_ball_is_not_held_for_ever() -> None:
    shot = Presses((0, 24, 84), ())
    chair = Chair((5.15, 9.96), (0.0, 0.0), blind := Blind(ON_LEFT, {shot: 300.0, None: -100.0}))
    chair.game.press(Control.LEFT, True)
    chair.game.tick()
    chair.ball.position, chair.ball.velocity = (5.15, 9.96), (0.0, 0.0)
    chair.sit(DECIDE + 100 + LATE)
    assert Presses() not in blind.asked
    assert chair.pressed == [(Control.LEFT, False), (Control.LEFT, True), (Control.LEFT, False)]


def test_a_ball_is_nudged_out_of_the_way_to_an_outlane_once_in_a_while() -> None:
    worths = {(0.0, -9.0): -4000.0, (-4.0, -7.5): -4000.0, (4.0, -7.5): 10.0, None: 0.0}
    chair = Chair((1.6, 16.5), (0.0, -9.0), Blind([], worths))
    chair.sit(400)
    assert chair.pressed == [(Control.NUDGE_RIGHT, True), (Control.NUDGE_RIGHT, False)]


def test_a_ball_that_is_not_lost_is_not_nudged() -> None:
    chair = Chair((1.6, 16.5), (0.0, -9.0), Blind([], {None: 0.0}))
    chair.sit(100)
    assert chair.pressed == []


def test_the_plunger_is_drawn_for_the_lane_that_blinks() -> None:
    chair = Chair((19.4, 1.143), (0.0, 0.0), Blind([], {None: 0.0}))
    chair.sit(DECIDE + 2)
    assert chair.pressed == [(Control.PLUNGER, True)]
    chair.sit(700)
    assert chair.pressed[1] == (Control.PLUNGER, False)


def test_initials_are_accepted() -> None:
    chair = Chair((9.3, 30.0), (0.0, 0.0), Blind([], {None: 0.0}))
    chair.game._stage = Phase.ENTRY
    chair.sit(3 * DECIDE)
    assert chair.pressed[0] == (Control.PLUNGER, True)


# -- foresight -------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def foresight() -> Foresight:
    return Foresight()


def test_what_is_foreseen_comes_to_pass(foresight: Foresight) -> None:
    real = Table()
    real.left.press(True)
    real.world.run(6 * STEP, STEP)
    ball = real.world.add(carom.Ball((7.0, 11.0), BALL_RADIUS, (1.0, -9.0)))
    places = foresight.track(real, (7.0, 11.0, 1.0, -9.0), Presses((0,), ()), 12, 4)
    real.left.press(False)
    real.world.run(12 * STEP, STEP)
    assert places[-1] == ball.position
    assert len(places) == 3


def test_the_worth_of_presses_is_that_of_what_the_ball_meets(foresight: Foresight) -> None:
    real = Table()
    state = (16.0, 21.8, 30.0, 0.0)
    struck = foresight.worth(real, state, Presses((2, 4), (6,)), 12)
    assert struck > 2000.0
    real.lower("drop target 2")
    assert 0.0 < foresight.worth(real, state, Presses(), 12) < 1000.0
    real.raise_targets()
    assert foresight.worth(real, state, Presses(), 12) == struck
    assert foresight.worth(real, (9.3, 6.9, 0.0, -30.0), Presses(), 12) < -7000.0
    assert foresight.worth(real, (9.3, 22.0, 0.0, 0.0), Presses(), 0) == HEIGHT * 22.0


def test_a_ball_at_rest_on_a_raised_flipper_is_worth_something(foresight: Foresight) -> None:
    real = Table()
    real.left.put(real.left.reach, True)
    cradle = foresight.worth(real, (5.15, 9.96, 0.0, 0.0), Presses(), 4)
    assert cradle > 900.0


def test_a_ball_is_in_a_flippers_sweep_over_its_outer_part_alone(foresight: Foresight) -> None:
    places = [(5.2, 9.9), (7.5, 9.0), (11.1, 9.0), (7.5, 14.0), (7.5, 8.0)]
    assert sweeps(foresight.table, places, left=True) == [1, 4]
    assert sweeps(foresight.table, places, left=False) == [2]


# -- whole games -----------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.compiled
def test_self_played_games(request: pytest.FixtureRequest) -> None:
    """Every game ends, no ball strays or is lost, few come to rest; 1,000 games with `--campaign`."""
    count = 1000 if request.config.getoption("--campaign") else 2
    game = Pinball(HighScores([]), seed=5)
    player = Player(game, seed=5)
    played = [play(game, player) for _ in range(count)]
    assert sum(one.strays for one in played) == 0
    assert sum(one.freed for one in played) <= 1 + count // 20
    if count > 100:
        idle = [play(game, None) for _ in range(count // 10)]
        assert sum(one.strays for one in idle) == 0
        assert sum(one.score for one in played) / count > 5.0 * sum(one.score for one in idle) / len(idle)


@pytest.mark.slow
@pytest.mark.compiled
def test_the_demonstration_plays_by_itself_and_flips() -> None:
    game = Pinball(seed=2)
    flips = 0
    for _ in range(30 * 480):
        game.tick()
        flips += sum(event.kind == "flipper" for event in game.take_events())
    assert game.phase is Phase.ATTRACT
    assert flips > 0
    assert game.score > 0
