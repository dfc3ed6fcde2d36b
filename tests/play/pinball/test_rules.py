"""The rules of the pinball game: what gives points, what lights, and what follows from feats."""

from random import Random

import pytest

from carom.play.pinball.rules import rules as worth
from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.rules.lamps import BANK, BUMPERS, LANES, MULTIPLIERS, NAMES, ORBITS, Lamps, LampState
from carom.play.pinball.rules.rules import RATE, Rules
from carom.play.pinball.rules.table import Part, Table

ON, OFF, BLINK = LampState.ON, LampState.OFF, LampState.BLINK


@pytest.fixture(scope="module")
def table() -> Table:
    return Table()


class Played:
    """Rules, the events that they told of, and parts to strike by name."""

    def __init__(self, table: Table) -> None:
        table.reset()
        self.events: list[Event] = []
        self.rules = Rules(table, self.events.append, Random(1))
        self.rules.lamps.put(OFF, *LANES)
        self.parts = {part.name: part for part in table.parts.values()}

    def meet(self, *names: str) -> int:
        """The points that striking parts one after the other gave."""
        before = self.rules.score
        for name in names:
            self.rules.meet(self.parts[name], self.parts[name].place, 9.0)
        return self.rules.score - before

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        for _ in range(round(seconds * RATE)):
            self.rules.tick()

    def told(self, kind: EventKind) -> list[Event]:
        """The events of a kind."""
        return [event for event in self.events if event.kind is kind]


@pytest.fixture
def played(table: Table) -> Played:
    return Played(table)


def test_lamps_are_those_that_there_are() -> None:
    lamps = Lamps()
    assert len(lamps) == len(NAMES) == len(set(lamps))
    with pytest.raises(KeyError):
        lamps.put(ON, "a lamp that is not there")


@pytest.mark.parametrize(
    ("name", "points"),
    [
        ("low bumper", worth.BUMPER),
        ("left slingshot's band", worth.SLINGSHOT),
        ("left target", worth.TARGET),
        ("drop target 2", worth.DROP),
        ("middle lane", worth.LANE),
        ("left orbit", worth.ORBIT),
        ("right inlane", worth.INLANE),
        ("left outlane", worth.OUTLANE),
        ("dome", 0),
        ("orbit gate", 0),
    ],
)
def test_each_part_gives_its_points_and_tells_of_it(played: Played, name: str, points: int) -> None:
    assert played.meet(name) == points
    part = played.parts[name]
    assert played.events == [Event(part.kind, name, part.place, 9.0, points)]


def test_bumpers_light_give_double_and_rise_when_all_are_lit(played: Played) -> None:
    assert played.meet("left bumper", "left bumper") == 300
    assert played.rules.lamps["left bumper"] is ON
    played.meet("right bumper", "low bumper")
    assert [played.rules.lamps[name] for name in BUMPERS] == [OFF, OFF, OFF]
    assert played.meet("left bumper") == 200
    for _ in range(40):
        played.meet(*BUMPERS)
    assert played.meet("low bumper") == 2 * worth.BUMPER_MOST


def test_flippers_rotate_the_lit_lanes(played: Played) -> None:
    played.meet("left lane")
    played.rules.change_lanes(1)
    assert [played.rules.lamps[name] for name in LANES] == [OFF, ON, OFF]
    played.rules.change_lanes(-1)
    played.rules.change_lanes(-1)
    assert [played.rules.lamps[name] for name in LANES] == [OFF, OFF, ON]
    assert played.meet("right lane") == worth.LANE_AGAIN


def test_all_lanes_raise_the_multiplier_to_five_and_bring_one_extra_ball(played: Played) -> None:
    for times in range(4):
        played.meet(*LANES)
        assert played.rules.multiplier == times + 2
        assert [played.rules.lamps[name] for name in LANES] == [OFF, OFF, OFF]
        assert played.rules.lamps[MULTIPLIERS[times]] is ON
        assert played.rules.extra_ball is (times >= 1)
    assert len(played.told(EventKind.EXTRA)) == 1
    assert played.rules.lamps["shoot again"] is ON
    assert played.meet(*LANES) == 3 * worth.LANE + worth.LANES_SPENT
    assert played.rules.multiplier == 5


def test_an_extra_ball_comes_once_a_game(played: Played) -> None:
    played.meet(*LANES, *LANES)
    played.rules.extra_ball = False
    played.rules.start_ball()
    played.rules.lamps.put(OFF, *LANES)
    assert played.rules.multiplier == 1
    played.meet(*LANES, *LANES, *LANES)
    assert not played.rules.extra_ball
    played.rules.start_game()
    played.rules.lamps.put(OFF, *LANES)
    played.meet(*LANES, *LANES)
    assert played.rules.extra_ball


def test_the_lane_that_blinks_is_a_skill_shot_for_a_while(table: Table) -> None:
    played = Played(table)
    played.rules.start_ball()
    (aim,) = [name for name in LANES if played.rules.lamps[name] is BLINK]
    assert played.meet(aim) == worth.LANE  # before the ball has been launched
    played.rules.start_ball()
    played.rules.enter()
    (aim,) = [name for name in LANES if played.rules.lamps[name] is BLINK]
    played.rules.change_lanes(1)
    (moved,) = [name for name in LANES if played.rules.lamps[name] is BLINK]
    assert moved != aim
    assert played.meet(moved, moved) == worth.SKILL + worth.LANE_AGAIN
    played.rules.start_ball()
    played.rules.enter()
    played.wait(worth.SKILL_TIME)
    assert all(played.rules.lamps[name] is OFF for name in LANES)


def test_an_inlane_lights_the_orbits_for_a_while(played: Played) -> None:
    played.meet("left inlane")
    assert [played.rules.lamps[name] for name in ORBITS] == [BLINK, BLINK]
    assert played.meet("right orbit") == worth.ORBIT_LIT
    played.wait(worth.LIT_ORBITS)
    assert [played.rules.lamps[name] for name in ORBITS] == [OFF, OFF]
    assert played.meet("right orbit") == worth.ORBIT


def test_targets_go_down_and_come_up_after_a_bank_when_no_ball_is_in_the_way(played: Played, table: Table) -> None:
    assert played.meet("drop target 1", "drop target 3") == 2 * worth.DROP
    assert played.meet("drop target 1") == 0
    played.rules.raise_bank([])
    assert table.down == {"drop target 1", "drop target 3"}
    assert played.meet("drop target 2") == worth.DROP + worth.BANK_FIRST
    assert [event.part for event in played.told(EventKind.BANK)] == [""]
    assert played.rules.lamps["multiball"] is BLINK
    played.rules.raise_bank([])
    assert len(table.down) == 3
    played.wait(worth.BANK_REST)
    played.rules.raise_bank([(16.6, 21.8)])
    assert len(table.down) == 3
    played.rules.raise_bank([(9.0, 30.0)])
    assert table.down == set()
    assert [played.rules.lamps[name] for name in BANK] == [OFF, OFF, OFF]


def bank(played: Played) -> int:
    """The points for a whole bank, whose targets are raised again."""
    points = played.meet(*BANK)
    played.wait(worth.BANK_REST)
    played.rules.raise_bank([])
    return points


def test_the_second_bank_starts_multiball_with_growing_jackpots(played: Played) -> None:
    first, second = bank(played), bank(played)
    assert second - first == worth.BANK_MORE + worth.MULTIBALL
    assert played.rules.multiball
    assert played.rules.balls_due == 2
    assert played.rules.saver_left > 0
    assert played.rules.lamps["jackpot"] is BLINK
    assert played.meet("left orbit") == worth.JACKPOT
    assert played.meet("right orbit") == worth.JACKPOT + worth.JACKPOT_MORE
    assert bank(played) == 3 * worth.DROP + 2 * (worth.JACKPOT + 2 * worth.JACKPOT_MORE)
    assert played.told(EventKind.BANK)[-1].part == "jackpot"
    assert len(played.told(EventKind.MULTIBALL)) == 1
    played.rules.end_multiball()
    assert played.rules.lamps["multiball"] is played.rules.lamps["jackpot"] is OFF
    assert played.meet("left orbit") == worth.ORBIT


def test_the_ball_save_lasts_its_time(played: Played) -> None:
    played.rules.enter()
    assert played.rules.lamps["shoot again"] is BLINK
    played.wait(worth.SAVER - 0.5)
    assert played.rules.saver_left > 0
    played.wait(0.5)
    assert played.rules.saver_left == 0
    assert played.rules.lamps["shoot again"] is OFF


def test_a_tilt_takes_points_bonus_and_what_was_due(played: Played, table: Table) -> None:
    bank(played)
    bank(played)
    played.rules.tilt()
    assert (played.rules.bonus, played.rules.balls_due, played.rules.multiball) == (0, 0, False)
    assert played.rules.lamps["tilt"] is ON
    assert played.meet("left bumper", "drop target 1", "left orbit", *LANES) == 0
    assert table.down == set()
    played.rules.enter()
    played.rules.spin(4.0)
    assert played.rules.saver_left == 0
    assert played.rules.score == sum(event.score for event in played.events)
    played.rules.start_ball()
    assert not played.rules.tilted
    assert played.rules.lamps["tilt"] is OFF


def test_the_spinner_gives_points_by_the_half_turn(played: Played) -> None:
    for _ in range(7):
        played.rules.spin(1.0)
    assert played.rules.score == 2 * worth.SPINNER
    assert len(played.told(EventKind.SPINNER)) == 2


def test_the_bonus_grows_with_the_score_up_to_its_most_and_is_paid_multiplied(played: Played) -> None:
    played.meet("left target", "left orbit", *LANES)
    bonus, score = played.rules.bonus, played.rules.score
    assert bonus == (worth.TARGET + worth.ORBIT + 3 * worth.LANE) // 10
    assert played.rules.pay_bonus(100) == 200
    paid = 200
    while part := played.rules.pay_bonus(100):
        paid += part
    assert played.rules.score - score == paid == 2 * bonus
    for _ in range(600):
        played.meet("left outlane")
        played.meet("left orbit")
    assert played.rules.bonus == worth.BONUS_MOST


def test_every_point_is_told_of(played: Played) -> None:
    for _ in range(3):
        bank(played)
        played.meet(*LANES, *BUMPERS, *ORBITS, "left inlane", "right outlane", "right target", "right slingshot's band")
    assert played.rules.score == sum(event.score for event in played.events)


def test_a_part_without_rules_is_told_of_alone(played: Played) -> None:
    played.rules.meet(Part("left flipper", EventKind.FLIPPER_HIT, (5.0, 8.6)), (6.0, 9.0), 12.0)
    assert played.events == [Event(EventKind.FLIPPER_HIT, "left flipper", (6.0, 9.0), 12.0, 0)]
