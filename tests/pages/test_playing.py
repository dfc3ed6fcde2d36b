"""The replay page plays, scrubs, steps, lists hits, switches layers, zooms: in a real Chromium."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from carom.draw.parts.layers import Layer
from carom.world.hits import HitKind
from tests.pages.conftest import Replay, text_of
from tests.pages.runs import NASTY, bare_runs, furnished_run, nasty_run, sleepy_run

if TYPE_CHECKING:
    from playwright.sync_api import Browser

Opened = Callable[..., Replay]


@pytest.mark.slow
def test_it_loads_without_a_word_and_without_the_network(opened: Opened) -> None:
    replay = opened(furnished_run())
    assert replay.said == []
    assert [url.partition(":")[0] for url in replay.asked] == ["file"]
    replay.page.click("#start-pause")
    replay.wait_until("replay.player.time > 0.1")
    for tab in ("statistics", "layers", "hits"):
        replay.page.click(f"#tab-{tab}")
    assert replay.said == []
    assert len(replay.asked) == 1


@pytest.mark.slow
def test_a_question_mark_lists_every_key_that_does_something(opened: Opened) -> None:
    replay = opened(furnished_run())
    replay.page.keyboard.press("?")
    assert replay.page.is_visible("#keys")
    listed = set(replay("[...document.querySelectorAll('#keys kbd')].map((key) => key.textContent)"))
    assert listed == {"space", "←", "→", "P", "N", "Home", "End", "[", "]", "+", "\N{MINUS SIGN}", "0", "T", "?"}
    for hide in ("?", "Escape"):
        replay.page.keyboard.press(hide)
        assert not replay.page.is_visible("#keys")
        replay.page.click("#help")
        assert replay.page.is_visible("#keys")
    replay.page.click("#keys h2")
    assert not replay.page.is_visible("#keys")
    assert replay.said == []


@pytest.mark.slow
def test_with_play_behind_its_address_it_begins_by_itself_but_for_who_wants_no_motion(opened: Opened) -> None:
    replay = opened(furnished_run())
    assert not replay("replay.player.playing")
    replay.page.goto(f"{replay.page.url}#play")
    for motion in ("no-preference", "reduce"):
        replay.page.emulate_media(reduced_motion=motion)  # type: ignore[arg-type]
        replay.page.reload()
        replay.page.wait_for_selector("html[data-ready]", state="attached")
        assert replay("replay.player.playing") == (motion != "reduce")
    assert replay.time == 0.0


@pytest.mark.slow
def test_a_page_around_it_stays_where_it_is_when_it_begins_by_itself(opened: Opened, tmp_path: Path) -> None:
    page = opened(furnished_run()).page
    around = tmp_path / "around.html"
    around.write_text('<iframe src="run.html#play" style="width: 100%; height: 700px; margin: 500px 0"></iframe>')
    page.goto(around.as_uri())
    page.frame_locator("iframe").locator("html[data-ready]").wait_for(state="attached")
    page.wait_for_timeout(300)
    assert page.evaluate("[scrollY, document.activeElement.tagName]") == [0, "BODY"]


@pytest.mark.slow
def test_it_may_not_use_the_network_even_if_it_tried(opened: Opened) -> None:
    replay = opened(furnished_run())
    tried = "fetch('data:text/plain,words').then(() => 'loaded', () => 'refused')"
    assert replay(tried) == "refused"


@pytest.mark.slow
@pytest.mark.parametrize("name", bare_runs())
def test_every_run_is_shown_without_a_word(opened: Opened, name: str) -> None:
    replay = opened(bare_runs()[name])
    for layer in Layer:
        replay("name => replay.layers.turn(name, true)", layer.value)
    replay.seek(0.05)
    replay.page.click("#start-pause")
    replay.page.click("#tab-statistics")
    replay.picture()
    assert replay.said == []


@pytest.mark.slow
def test_a_page_that_is_damaged_says_so(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "damaged.html"
    path.write_text(re.sub('"pieces":"[^"]*"', '"pieces":"AAAA"', text_of(furnished_run())), encoding="utf-8")
    page = browser.new_page()
    page.goto(path.as_uri())
    page.wait_for_selector("#trouble:visible")
    assert page.inner_text("#trouble").startswith("This run cannot be shown.")
    page.close()


@pytest.mark.slow
def test_it_plays_in_the_frame_that_notebooks_show(browser: Browser) -> None:
    page = browser.new_page(viewport={"width": 850, "height": 600})
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.set_content(furnished_run()._repr_html_() or "")
    (frame,) = page.frames[1:]
    frame.wait_for_selector("html[data-ready]", state="attached")
    frame.click("#step-forth")
    assert frame.evaluate("replay.player.time") > 0.0
    assert said == []
    page.close()


# -- time --------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_it_plays_pauses_and_plays_again(opened: Opened) -> None:
    replay = opened(furnished_run())
    assert replay.time == 0.0
    replay.page.click("#start-pause")
    replay.wait_until("replay.player.time > 0.2")
    assert replay.page.get_attribute("#start-pause", "aria-label") == "Pause"
    replay.page.click("#start-pause")
    paused = replay.time
    replay.page.wait_for_timeout(100)
    assert replay.time == paused
    replay.seek(2.0)
    assert replay.page.get_attribute("#start-pause", "aria-label") == "Play again"
    replay.page.click("#start-pause")
    assert replay.time < 1.0
    assert replay("replay.player.playing")


@pytest.mark.slow
def test_it_stops_at_the_end(opened: Opened) -> None:
    replay = opened(furnished_run())
    replay.seek(1.9)
    replay.page.click("#start-pause")
    replay.wait_until("!replay.player.playing")
    assert replay.time == pytest.approx(2.0)
    assert replay.page.inner_text("#time") == "2.000"


@pytest.mark.slow
def test_time_goes_on_as_fast_as_was_chosen(opened: Opened) -> None:
    replay = opened(furnished_run())
    passed = (
        "speed => { replay.player.speed = speed; replay.seek(0); replay.player.play(); for (const now of [0, 40, 120])"
    )
    passed += " replay.player.advance(now); replay.player.pause(); return replay.player.time; }"
    assert replay(passed, 1) == pytest.approx(0.12)
    assert replay(passed, 0.25) == pytest.approx(0.03)
    assert replay(passed, 8) == pytest.approx(0.96)
    replay.page.select_option("#speed", "0.5")
    assert replay("replay.player.speed") == 0.5
    replay.page.keyboard.press("Escape")
    replay.page.focus("#canvas")
    replay.page.keyboard.press("]")
    assert replay.page.input_value("#speed") == "1"


@pytest.mark.slow
def test_it_scrubs(opened: Opened) -> None:
    replay = opened(furnished_run())
    box = replay.page.locator("#scrub").bounding_box()
    assert box is not None
    replay.page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    assert replay.time == pytest.approx(1.0, abs=0.02)
    before = replay.picture()
    replay.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    replay.page.mouse.down()
    replay.page.mouse.move(box["x"] + 0.75 * box["width"], box["y"] + 0.5 * box["height"])
    replay.page.mouse.up()
    assert replay.time == pytest.approx(1.5, abs=0.02)
    assert replay.picture() != before
    assert float(replay.page.inner_text("#time")) == pytest.approx(replay.time, abs=1e-3)


@pytest.mark.slow
def test_it_steps_from_frame_to_frame(opened: Opened) -> None:
    replay = opened(furnished_run())
    times = furnished_run().times
    near = 1e-8
    replay.page.click("#step-forth")
    assert replay.time == pytest.approx(times[1], abs=near)
    replay.page.focus("#canvas")
    replay.page.keyboard.press("ArrowRight")
    assert replay.time == pytest.approx(times[2], abs=near)
    replay.page.click("#step-back")
    assert replay.time == pytest.approx(times[1], abs=near)
    replay.seek(0.5 * float(times[1] + times[2]))
    replay.page.keyboard.press("ArrowLeft")
    assert replay.time == pytest.approx(times[1], abs=near)
    replay.page.keyboard.press("End")
    assert replay.time == pytest.approx(2.0)
    replay.page.click("#step-forth")
    assert replay.time == pytest.approx(2.0)
    replay.page.keyboard.press("Home")
    replay.page.click("#step-back")
    assert replay.time == 0.0


# -- hits --------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_hit_in_the_list_leads_to_it(opened: Opened) -> None:
    replay = opened(furnished_run())
    hits = furnished_run().hits
    bounce = int(np.flatnonzero(hits["kind"] == HitKind.BOUNCE)[3])
    replay.page.locator(".row:visible").filter(has_text=f"{hits['time'][bounce]:.2f}").first.click()
    shown = int(np.argmin(np.abs(hits["time"] - replay.time)))
    assert replay.time == pytest.approx(hits["time"][shown], abs=1e-8)
    assert f"{replay.time:.2f}" == f"{hits['time'][bounce]:.2f}"
    assert not replay("replay.player.playing")
    replay.picture()
    assert replay.page.locator(".row.now").count() == 1


@pytest.mark.slow
def test_the_ball_touches_what_it_hits(opened: Opened) -> None:
    replay = opened(furnished_run())
    recording = furnished_run()
    at = "ball => { const at = replay.motion.ballAt(ball, replay.player.time); return [at.x, at.y]; }"
    balls = recording.ids.tolist()
    met = 0
    for number, hit in enumerate(recording.hits):
        if hit["kind"] != HitKind.BOUNCE or np.count_nonzero(recording.hits["time"] == hit["time"]) > 1:
            continue
        replay("hit => replay.jump(hit)", number)
        for member, side in ((hit["ball"], 1.0), (hit["shape"], -1.0)):
            if member in balls:
                ball = balls.index(member)
                center = hit["point"] + side * recording.radii[ball] * hit["normal"]
                assert replay(at, ball) == pytest.approx(center.tolist(), abs=2e-3)
                met += side < 0
    assert met > 0


@pytest.mark.slow
def test_the_next_and_the_last_hit_are_a_key_away(opened: Opened) -> None:
    replay = opened(furnished_run())
    times = np.unique(furnished_run().hits["time"])
    replay.page.focus("#canvas")
    replay.page.keyboard.press("n")
    assert replay.time == pytest.approx(times[0], abs=1e-8)
    replay.page.keyboard.press("n")
    replay.page.click("#hit-forth")
    replay.page.keyboard.press("p")
    replay.page.click("#hit-back")
    assert replay.time == pytest.approx(times[0], abs=1e-8)


@pytest.mark.slow
def test_every_tab_is_reached_by_keys_and_leaves_the_space_bar_free(opened: Opened) -> None:
    replay = opened(furnished_run())
    replay.page.focus("#tab-hits")
    for name in ("statistics", "layers"):
        replay.page.keyboard.press("Tab")
        replay.page.keyboard.press(" ")
        assert replay.page.is_visible(f"#{name}")
        assert not replay("replay.player.playing")
    replay.page.keyboard.press(" ")
    assert replay("replay.player.playing")


@pytest.mark.slow
def test_the_list_can_be_filtered_by_name(opened: Opened) -> None:
    replay = opened(furnished_run())
    recording = furnished_run()
    counts = {
        name: sum(recording.label_of(shape) == name for shape in recording.hits["shape"]) for name in ("wall", "arch")
    }
    assert replay.page.inner_text("#hits-note") == f"{len(recording.hits)} hits"
    replay.page.fill("#filter", "WALL")
    assert replay.page.inner_text("#hits-note").startswith(f"{counts['wall']} of ")
    assert all("wall" in words for words in replay.page.locator(".row:visible .what").all_inner_texts())
    replay.page.fill("#filter", "no such name")
    assert replay.page.locator(".row:visible").count() == 0
    replay.page.click("#tab-statistics")
    replay.page.click(".share:has-text('wall')")
    assert replay.page.input_value("#filter") == "wall"
    assert replay.page.is_visible("#rows")


@pytest.mark.slow
def test_the_list_says_what_it_leaves_out(opened: Opened) -> None:
    replay = opened(furnished_run())
    kept = len(furnished_run().hits)
    replay("replay.list.hits.total = 1234567, replay.list.filter('')")
    assert replay.page.inner_text("#hits-note") == f"the {kept} strongest of 1,234,567 hits"


@pytest.mark.slow
def test_the_statistics_are_those_of_the_run(opened: Opened) -> None:
    replay = opened(furnished_run())
    recording = furnished_run()
    replay.page.click("#tab-statistics")
    replay.seek(1.0)
    replay.page.wait_for_timeout(50)
    words = replay.page.inner_text("#statistics").replace("\n", " ")
    assert f"hits so far {np.count_nonzero(recording.hits['time'] <= 1.0)} balls there 4 balls asleep 0" in words
    assert f"frames {len(recording)} balls 4 shapes {len(recording.shape_ids)}" in words
    assert f"box tests {recording.statistics['box_tests']:,}" in words


@pytest.mark.slow
def test_the_statistics_know_who_sleeps(opened: Opened) -> None:
    replay = opened(sleepy_run())
    asleep = sleepy_run().asleep
    replay.page.click("#tab-statistics")
    for frame in (0, 59):
        replay.seek(float(sleepy_run().times[frame]))
        words = replay.page.inner_text("#statistics").replace("\n", " ")
        assert f"balls asleep {np.count_nonzero(asleep[frame])} " in words
    assert asleep[59].any()


# -- looks -------------------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_names_stay_text(opened: Opened) -> None:
    replay = opened(nasty_run())
    assert replay.page.text_content("#name") == replay.page.text_content("#about") == NASTY
    assert replay.page.title() == " ".join(NASTY.split(" "))
    replay.page.click("#tab-statistics")
    replay("replay.layers.turn('names', true)")
    assert replay.page.locator("b").count() == 0
    assert replay.page.locator("script").count() == 2
    assert replay.page.text_content(".share .label") == NASTY
    assert replay.said == []


@pytest.mark.slow
@pytest.mark.parametrize("layer", Layer)
def test_every_layer_can_be_switched(opened: Opened, layer: Layer) -> None:
    replay = opened(furnished_run())
    replay.seek(float(furnished_run().hits["time"][furnished_run().hits["kind"] == HitKind.BOUNCE][4]) + 0.02)
    replay.page.click("#tab-layers")
    switch = replay.page.locator(f"label:has(#layer-{layer})")
    before = replay.picture()
    switch.click()
    switched = replay.picture()
    assert switched != before
    switch.click()
    assert replay.picture() == before


@pytest.mark.slow
def test_it_follows_the_readers_theme_until_told_otherwise(opened: Opened) -> None:
    corner = (0.3, 7.7)
    light, dark = opened(furnished_run()), opened(furnished_run(), scheme="dark")
    assert light.pixel(*corner) == light.ink("stage") == "#fffefb"
    assert dark.pixel(*corner) == dark.ink("stage") != "#fffefb"
    dark.page.click("#theme")
    dark.picture()
    assert dark.pixel(*corner) == "#fffefb"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("width", "height"),
    [(390, 844), (320, 568), (844, 390), (736, 560), (850, 560), (1024, 768), (1280, 800), (2560, 1300)],
)
def test_it_fits_every_window(opened: Opened, width: int, height: int) -> None:
    replay = opened(furnished_run(), width=width, height=height)
    assert replay("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]") == [width, height]
    controls = (
        "#start-pause",
        "#step-back",
        "#hit-forth",
        "#scrub",
        "#speed",
        "#time",
        "#tab-layers",
        "#theme",
        "#fit",
    )
    for control in controls:
        box = replay.page.locator(control).bounding_box()
        assert box is not None
        assert 0 <= box["x"] <= box["x"] + box["width"] <= width
        assert 0 <= box["y"] <= box["y"] + box["height"] <= height
        covered = "name => { const box = document.querySelector(name).getBoundingClientRect();"
        covered += " return !document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2).closest(name); }"
        assert not replay(covered, control)
    assert replay("replay.view.height") > 120
