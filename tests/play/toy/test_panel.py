"""Every switch of the panel, clicked and dragged, acts on the worlds at once."""

from itertools import combinations
from typing import Any

import pygame
import pytest

import carom
from carom.draw import Layer
from carom.play.pen import Pen
from carom.play.toy import app, beside
from carom.play.toy.items import OPTIONS, ROWS, Buttons, Choice, Numbers, Slider
from carom.play.toy.readout import LARGE, SIDE, wrapped
from carom.play.toy.sentences import SENTENCES
from carom.play.toy.settings import SHOWN
from tests.play.toy.playing import Player

SLIDERS = {row.name: row for row in ROWS if isinstance(row, Slider)}
FAR = 400


def of_world(name: str, world: Any) -> Any:
    """What a world says to the setting of a name."""
    return {
        "broad_phase": world.broad_phase,
        "restitution": world.restitution,
        "levels": world.levels,
        "motion": world.substeps,
        "collision": world.iterations,
        "gravity": -world.gravity[1],
        "friction": world.friction,
        "sleep": world.sleep_speed,
        "speed": world.max_speed,
    }.get(name)


@pytest.mark.parametrize(
    ("name", "value"), [(name, value) for name in ("broad_phase", "restitution") for value in OPTIONS[name]]
)
def test_a_button_of_a_choice_sets_the_world(player: Player, name: str, value: str) -> None:
    player.click((name, value))
    assert of_world(name, player.world) == player.desk.value(name) == value


def test_a_chosen_option_looks_chosen_when_it_is_clicked_again(player: Player) -> None:
    def looks() -> bytes:
        player.mouse(pygame.MOUSEMOTION, (5, 5))
        player.frames(2)
        area = player.toy.panel.places[("broad_phase", "quadtree")]
        return pygame.image.tobytes(player.window.surface.subsurface(area), "RGB")

    player.frames(1)
    before = looks()
    player.click(("broad_phase", "quadtree"))
    chosen = looks()
    assert chosen != before
    player.click(("broad_phase", "quadtree"))
    assert looks() == chosen


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
def test_the_detection_is_that_of_the_button(player: Player, detection: str) -> None:
    player.click(("detection", detection))
    assert [table.world.detection for table in player.desk.tables] == [detection]


def test_side_by_side_shows_two_tables_and_one_of_them_stays(player: Player) -> None:
    player.click(("detection", "both"))
    first, second = player.desk.tables
    assert (first.world.detection, second.world.detection) == ("discrete", "continuous")
    assert [view.table for view in player.toy.views] == [first, second]
    assert not player.toy.views[0].area.colliderect(player.toy.views[1].area)
    player.click(("detection", "continuous"))
    assert player.desk.tables == (second,)
    assert [view.table for view in player.toy.views] == [second]


def test_side_by_side_says_that_the_tables_stand_still_while_they_do(
    player: Player, monkeypatch: pytest.MonkeyPatch
) -> None:
    player.click(("detection", "both"))
    written: list[str] = []
    words = Pen.words
    monkeypatch.setattr(
        Pen, "words", lambda pen, what, *rest, **more: (written.append(what), words(pen, what, *rest, **more))[1]
    )
    for compiling, said in ((True, beside.WAIT), (False, beside.TRY)):
        monkeypatch.setattr(app.carom, "compiling", lambda compiling=compiling: compiling)
        written.clear()
        player.frames(1)
        assert {beside.WAIT, beside.TRY} & set(written) == {said}


@pytest.mark.slow
@pytest.mark.parametrize("name", SLIDERS)
def test_a_slider_goes_from_its_least_to_its_greatest_value(player: Player, name: str) -> None:
    for pixels, wanted in ((-FAR, SLIDERS[name].low), (FAR, SLIDERS[name].high)):
        player.slide(name, pixels)
        assert player.desk.value(name) == wanted
        if of_world(name, player.world) is not None:
            assert of_world(name, player.world) == (max(40.0, wanted) if name == "speed" else wanted)


def test_a_slider_stops_on_its_steps(player: Player) -> None:
    player.slide("gravity", 37)
    value = player.desk.value("gravity")
    assert value > 5.0
    assert value == player.world.gravity[1] * -1 == round(2 * value) / 2


@pytest.mark.slow
@pytest.mark.parametrize("name", SHOWN)
def test_a_switch_of_what_is_shown_turns_its_layers_on_and_off(player: Player, name: str) -> None:
    before = SHOWN[name] <= player.desk.settings.layers
    for expected in (not before, before):
        player.click(name)
        assert (SHOWN[name] <= player.toy.views[0]._live.layers) == expected
        assert Layer.SHAPES in player.toy.views[0]._live.layers


def test_rotate_turns_the_parts_that_can_turn_and_no_others(player: Player) -> None:
    player.click("rotating")
    turning = [shape for shape in player.world.shapes if isinstance(shape, carom.Compound)]
    assert {shape.name for shape in turning} == {"paddle", "cup", "crescent"}
    assert all(shape.rotating for shape in turning)
    player.click("rotating")
    assert not any(shape.rotating for shape in turning)


def test_mute_silences_the_speaker(player: Player) -> None:
    player.click("muted")
    assert player.toy._speaker.muted
    player.click("muted")
    assert not player.toy._speaker.muted


def test_pause_stops_time_and_step_makes_one_step(player: Player) -> None:
    before = player.world.time
    player.frames(5)
    assert player.world.time == before
    player.click("step")
    assert player.world.time == pytest.approx(before + 1 / 60)
    player.click("paused")
    assert player.world.time > before + 1 / 60


@pytest.mark.parametrize("pace", [1, 4, 10])
def test_slow_motion_makes_shorter_steps(player: Player, pace: int) -> None:
    player.click(("pace", pace))
    before = player.world.time
    player.key(pygame.K_s)
    assert player.world.time - before == pytest.approx(1 / 60 / pace)


def test_launch_and_launch_n_send_up_balls_of_the_chosen_size_and_speed(player: Player) -> None:
    player.key(pygame.K_c)
    player.slide("size", -FAR)
    player.slide("count", -FAR)
    player.click("launch")
    player.click("launch many")
    assert player.desk.lane.waiting == 2
    player.key(pygame.K_s)
    (ball,) = player.world.balls
    assert (ball.radius, player.desk.lane.waiting) == (0.1, 1)
    assert ball.velocity[1] == pytest.approx(24.0, abs=0.5)


def test_clear_takes_all_balls_and_counts_away(player: Player) -> None:
    player.click("launch many")
    player.click("clear")
    table = player.desk.tables[0]
    assert (table.in_play, table.launched, table.strays, player.desk.lane.waiting) == (0, 0, 0, 0)
    assert table.world.statistics.box_tests == 0


def test_quit_closes_the_toy(player: Player) -> None:
    player.click("quit")
    assert not player.toy.running


def test_help_is_shown_and_goes_with_a_click(player: Player) -> None:
    player.click("help")
    assert player.desk.help
    player.mouse(pygame.MOUSEBUTTONDOWN, (300, 300))
    assert not player.desk.help


def test_the_panel_shows_what_keys_have_changed(player: Player) -> None:
    player.key(pygame.K_b)
    assert player.world.broad_phase == player.desk.value("broad_phase") != "grid"
    chosen = [meaning for button, meaning in player.toy.panel._buttons.items() if button.is_selected]
    assert ("broad_phase", player.world.broad_phase) in chosen
    assert ("broad_phase", "grid") not in chosen


def test_a_slider_follows_a_setting_that_was_changed_elsewhere(player: Player) -> None:
    before = player.toy.panel.places["motion"]
    player.desk.change("motion", 16)
    player.frames(2)
    assert player.toy.panel.places["motion"].left > before.left


def test_the_figures_are_there_from_the_first_frame_on() -> None:
    player = Player()
    player.frames(1)
    assert player.toy.panel._texts["launched"] == "5"


def test_buttons_and_knobs_are_on_the_panel_and_do_not_overlap(player: Player) -> None:
    places = list(player.toy.panel.places.values())
    window = pygame.Rect(0, 0, *player.toy.size)
    assert all(window.contains(place) and player.toy.panel.holds(place.center) for place in places)
    assert not any(one.colliderect(other) for one, other in combinations(places, 2))


def test_the_words_of_buttons_fit(player: Player) -> None:
    letters = player.toy._letters
    for button in player.toy.panel._buttons:
        assert letters.width(button.text, 12) < button.rect.width - 4, button.text


def test_every_control_and_figure_has_a_sentence_that_fits_the_strip(player: Player) -> None:
    toy = player.toy
    for name, place in toy.panel.places.items():
        assert toy.panel.sentence(place.center) == SENTENCES[name]
    named = {row.name for row in ROWS if isinstance(row, Slider | Choice)}
    named |= {name for row in ROWS if isinstance(row, Buttons) for name, _ in row.buttons}
    named |= {name for row in ROWS if isinstance(row, Numbers) for name, _ in row.figures}
    chosen = {(name, value) for name, values in OPTIONS.items() for value in values}
    assert named | chosen | {"load"} == set(SENTENCES)
    for words in SENTENCES.values():
        lines = wrapped(toy._letters, words, toy._strip.width - 2 * SIDE)
        assert " ".join(lines) == words
        assert len(lines) <= 3
        assert all(toy._letters.width(line, LARGE) <= toy._strip.width - 2 * SIDE for line in lines)


def test_the_sentence_is_that_of_the_control_under_the_pointer(player: Player) -> None:
    def strip() -> bytes:
        player.frames(1)
        return pygame.image.tobytes(player.window.surface.subsurface(player.toy._strip), "RGB")

    player.mouse(pygame.MOUSEMOTION, (5, 5))
    nothing, seen = strip(), []
    for name in (("restitution", "total"), "motion", "levels"):
        player.mouse(pygame.MOUSEMOTION, player.toy.panel.places[name].center)
        seen.append(strip())
    assert len({nothing, *seen}) == 4
    left = player.toy.panel._area.left
    figures = {player.toy.panel.sentence((left + x, 90)) for x in (20, 90, 150, 220, 290)}
    assert figures == {SENTENCES[name] for name in ("launched", "in play", "asleep", "strays", "overlaps")}
    player.mouse(pygame.MOUSEMOTION, (5, 5))
    assert strip() == nothing
