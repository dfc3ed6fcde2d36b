"""The modes: three lit bumpers start them in turn, lit shots pay, all of them pay more, and every point is told of."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from carom.play.pinball.rules.events import EventKind
from carom.play.pinball.rules.lamps import BANK, BUMPERS, LANES, ORBITS, SAUCER, TARGETS, LampState
from carom.play.pinball.rules.modes import MODES
from carom.play.pinball.rules.rules import MORE_TIME, RATE
from carom.play.pinball.rules.table import Table
from carom.play.pinball.screen.dots import COLUMNS, width
from tests.play.pinball.test_rules import Played

table_once = cache(Table)
OFF, BLINK = LampState.OFF, LampState.BLINK


@pytest.fixture
def played() -> Played:
    return Played(table_once())


def shoot(played: Played, place: int) -> None:
    """Meet one of the parts that the mode wants: both sides by turns."""
    mode = played.rules.modes.mode
    assert mode is not None
    if mode.parts == ("spinner",):
        played.rules.spin(3.1416)
    else:
        played.meet(mode.parts[place % len(mode.parts)])


def test_three_lit_bumpers_start_the_modes_in_turn_and_all_shots_of_one_bring_its_reward(played: Played) -> None:
    assert played.rules.goal == "SAUCER FOR A MODE"
    played.rules.table.saucer_open = False
    assert played.rules.goal == "BUMPERS FOR A MODE"
    for mode in (*MODES, MODES[0]):
        played.events.clear()
        played.meet(*BUMPERS)
        assert [event.part for event in played.told(EventKind.MODE)] == [mode.name]
        assert [played.rules.lamps[name] for name in mode.lamps] == [BLINK] * len(mode.lamps)
        assert played.rules.goal == f"{mode.words} {mode.worth:,} {mode.seconds} S"
        for place in range(mode.shots):
            assert not played.told(EventKind.FEAT)
            shoot(played, place)
        assert [event.score for event in played.told(EventKind.SHOT)] == [mode.worth] * mode.shots
        assert [(event.part, event.score) for event in played.told(EventKind.FEAT)] == [(mode.name, mode.reward)]
        assert played.rules.modes.mode is None
        assert [played.rules.lamps[name] for name in mode.lamps] == [OFF] * len(mode.lamps)


def test_a_mode_ends_with_its_time_and_other_shots_are_none_of_its(played: Played) -> None:
    played.meet(*BUMPERS)
    played.wait(MODES[0].seconds - 1)
    assert played.meet("left target") == 500
    assert played.rules.goal == "ORBITS 8,000 1 S"
    assert played.meet("left orbit") == 2_500 + 8_000
    played.wait(1)
    assert (played.rules.modes.mode, played.rules.lamps["left orbit"]) == (None, OFF)
    assert played.meet("left orbit") == 2_500


def test_what_an_inlane_has_lit_stays_lit_after_a_mode_and_the_other_way_round(played: Played) -> None:
    played.meet(*BUMPERS)
    played.wait(MODES[0].seconds - 4)
    played.meet("left inlane")
    played.wait(5)
    assert played.rules.modes.mode is None
    assert [played.rules.lamps[name] for name in ORBITS] == [BLINK, BLINK]
    played.rules.modes._begun = 0
    played.meet(*BUMPERS)
    played.wait(6)
    assert [played.rules.lamps[name] for name in ORBITS] == [BLINK, BLINK]
    assert played.meet("left orbit") == 2_500 + 8_000, "the inlane's time is over, the mode's is not"


@pytest.mark.parametrize("end", ["ball", "tilt", "multiball"])
def test_ball_tilt_and_multiball_end_a_mode(played: Played, end: str) -> None:
    played.meet(*BUMPERS)
    if end == "ball":
        played.rules.start_ball()
    elif end == "tilt":
        played.rules.tilt()
        assert played.meet("left orbit", *BUMPERS) == 0
    else:
        played.rules._start_multiball((0.0, 0.0))
        assert played.rules.goal == "ORBITS ARE JACKPOTS"
        played.meet(*BUMPERS, *BUMPERS)
    assert played.rules.modes.mode is None
    assert len(played.told(EventKind.MODE)) == 1


ROLLED = (*ORBITS, SAUCER, *LANES, "left inlane", "right outlane")
PARTS = (*BUMPERS, *BUMPERS, *ROLLED, *TARGETS, *BANK, "wait", "spin", "ball")


@settings(max_examples=25, deadline=None)
@given(names=st.lists(st.sampled_from(PARTS), max_size=60))
def test_whatever_is_shot_every_point_is_told_of_and_the_line_fits_the_display(names: list[str]) -> None:
    played, before = Played(table_once()), 0
    for name in names:
        if name == "wait":
            played.wait(7)
        elif name == "spin":
            played.rules.spin(9.5)
        elif name == "ball":
            played.rules.start_ball()
        else:
            played.meet(name)
        assert played.rules.score == sum(event.score for event in played.events) >= before
        assert 0 < width(played.rules.goal) <= COLUMNS - 2
        before = played.rules.score
        mode = played.rules.modes.mode
        most = 0 if mode is None else (mode.seconds + MORE_TIME * names.count(SAUCER)) * RATE
        assert mode is None or (not played.rules.multiball and 0 < played.rules.modes.steps_left <= most)
