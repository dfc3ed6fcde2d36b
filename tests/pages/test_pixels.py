"""The pixels of the replay page are where the recording says, and move as the reader moves the view."""

from collections.abc import Callable

import numpy as np
import pytest

import carom
from carom.draw.theme import BALL_INKS, LIGHT
from tests.pages.conftest import Replay
from tests.pages.runs import bare_runs, changing_run, furnished_run

pytestmark = pytest.mark.slow

Opened = Callable[..., Replay]


def near(colour: str, other: str, most: int = 12) -> bool:
    """Whether two colours are the same but for rounding and the edges of marks."""
    return all(abs(int(colour[at : at + 2], 16) - int(other[at : at + 2], 16)) <= most for at in (1, 3, 5))


@pytest.mark.parametrize(
    "frame", [37, *[pytest.param(frame, marks=pytest.mark.slow) for frame in (0, 1, 60, 119, 120)]]
)
def test_balls_are_where_they_were(opened: Opened, frame: int) -> None:
    recording = furnished_run()
    replay = opened(recording)
    replay.show_only("balls")
    replay.seek(float(recording.times[frame]))
    inks = replay("replay.run.ball_inks")
    for place, ink in zip(recording.positions[frame], inks, strict=True):
        assert replay.pixel(*place) == LIGHT.inks[ink]
        for x, y in ((0.45, 0.0), (-0.45, 0.0), (0.0, 0.45), (0.0, -0.45)):
            if np.hypot(*(recording.positions[frame] - place - (x, y)).T).min() > 0.4:
                assert replay.pixel(place[0] + x, place[1] + y) != LIGHT.inks[ink]


def test_what_a_ball_has_left_shows_the_ground_again(opened: Opened) -> None:
    recording = furnished_run()
    replay = opened(recording)
    replay.show_only("balls")
    start = recording.positions[0, 0]
    assert replay.pixel(*start) != LIGHT.inks["stage"]
    replay.seek(0.5)
    assert np.hypot(*(recording.positions[30] - start).T).min() > 0.5
    assert replay.pixel(*start) == LIGHT.inks["stage"]


def test_places_are_as_exact_as_a_thousandth_of_a_pixel(opened: Opened) -> None:
    recording = furnished_run()
    replay = opened(recording)
    shape = [len(recording.ids), len(recording)]
    x, y = (np.array(replay(f"[...replay.run.balls.{axis}]")).reshape(shape).T for axis in "xy")
    pixel = 13.0 / 900.0
    assert np.abs(np.stack([x, y], axis=2) - recording.positions).max() < 1e-3 * pixel
    assert np.abs(np.array(replay("[...replay.run.times]")) - recording.times).max() < 1e-8
    hits = {name: np.array(replay(f"[...replay.run.hits.{name}]")) for name in ("time", "x", "y", "normal", "speed")}
    assert np.abs(hits["time"] - recording.hits["time"]).max() < 1e-8
    bounces = recording.hits["kind"] == 0
    assert np.abs(np.stack([hits["x"], hits["y"]], axis=1) - recording.hits["point"])[bounces].max() < 1e-2 * pixel
    directions = np.stack([np.cos(hits["normal"]), np.sin(hits["normal"])], axis=1)
    assert np.abs(directions - recording.hits["normal"])[bounces].max() < 1e-3
    assert hits["speed"] == pytest.approx(recording.hits["speed"], rel=2e-3, abs=1e-3)


def test_between_frames_balls_go_straight_from_bounce_to_bounce(opened: Opened) -> None:
    recording = furnished_run()
    replay = opened(recording)
    at = "([ball, time]) => { const at = replay.motion.ballAt(ball, time); return [at.x, at.y]; }"
    middle = replay(at, [0, 0.5 * float(recording.times[4] + recording.times[5])])
    assert middle == pytest.approx(recording.positions[4:6, 0].mean(axis=0), abs=1e-4)


def test_moving_shapes_turn_as_they_did(opened: Opened) -> None:
    recording = furnished_run()
    replay = opened(recording)
    replay.show_only("shapes")
    paddle = next(number for number, shape in enumerate(recording.shapes_at(0)) if shape.name == "paddle")
    for frame in (0, 50, 110):
        shape = recording.shapes_at(frame)[paddle]
        assert isinstance(shape, carom.Segment)
        replay.seek(float(recording.times[frame]))
        for end in (shape.p0, shape.p1):
            assert near(replay.pixel(*(0.9 * np.array(end) + 0.1 * np.array(shape.pivot))), LIGHT.inks["moving"], 60)
        assert replay.pixel(2 * shape.p1[0] - shape.pivot[0], 2 * shape.p1[1] - shape.pivot[1]) == LIGHT.inks["stage"]


def test_a_target_that_drops_looks_switched_off(opened: Opened) -> None:
    replay = opened(changing_run())
    replay.show_only("shapes")
    pictures = {}
    for time in (0.05, 0.5, 1.2, 1.8, 2.5):
        replay.seek(time)
        pictures[time] = replay.picture()
    assert pictures[0.05] == pictures[0.5] == pictures[2.5]
    assert pictures[1.2] == pictures[1.8] != pictures[0.5]
    seen = {}
    for time in (0.5, 1.2):
        replay.seek(time)
        seen[time] = {replay.pixel(x, 0.0) for x in np.linspace(0.1, 3.9, 60)}
    assert LIGHT.inks["stage"] not in seen[0.5]
    assert LIGHT.inks["stage"] in seen[1.2]


def test_balls_come_and_go(opened: Opened) -> None:
    replay = opened(changing_run())
    replay.show_only("balls")
    of_balls = {LIGHT.inks[ink] for ink in BALL_INKS}
    seen = []
    for time in (0.0, 1.35, 1.6, 2.35, 2.6):
        replay.seek(time)
        seen.append([replay.pixel(*place) in of_balls for place in ((1, 1), (2, 1), (3, 1))])
    assert seen == [
        [True, False, True],
        [True, False, True],
        [False, False, True],
        [False, False, True],
        [False, True, True],
    ]


def test_a_shape_that_is_hit_lights_up(opened: Opened) -> None:
    recording = furnished_run()
    replay = opened(recording)
    replay.show_only("shapes", "lights")
    floor = int(recording.shape_ids[0])
    hit = next(hit for hit in recording.hits if hit["shape"] == floor)
    replay.seek(float(hit["time"]) - 1e-3)
    dark = replay.pixel(6.0, 0.06)
    replay.seek(float(hit["time"]) + 1e-3)
    assert replay.pixel(6.0, 0.06) != dark


# -- the view ----------------------------------------------------------------------------------------------------------


def test_arcs_are_true_at_every_zoom(opened: Opened) -> None:
    replay = opened(furnished_run())
    replay.show_only("shapes")
    for angle in (0.2, 0.31, 0.5, 0.77):
        place = 6.0 + 3.0 * np.cos(angle * np.pi), 5.0 + 3.0 * np.sin(angle * np.pi)
        replay(
            "([x, y]) => { replay.view.zoom = 200; replay.view.x = x; replay.view.y = y; replay.moved(); }", list(place)
        )
        replay.picture()
        assert near(replay.pixel(*place), LIGHT.inks["wall"], 60)
        assert replay.pixel(place[0] + 0.002, place[1] + 0.002) == LIGHT.inks["stage"]


def test_the_wheel_zooms_in_on_what_is_below_it(opened: Opened) -> None:
    replay = opened(furnished_run())
    box = replay.page.locator("#canvas").bounding_box()
    assert box is not None
    x, y = round(0.3 * box["width"]), round(0.6 * box["height"])
    world = "([x, y]) => [replay.view.worldX(x), replay.view.worldY(y)]"
    before = replay(world, [x, y])
    replay.page.mouse.move(box["x"] + x, box["y"] + y)
    replay.page.mouse.wheel(0, -600)
    replay.wait_until("replay.view.zoom > 2")
    assert replay(world, [x, y]) == pytest.approx(before, abs=1e-6)
    replay.page.mouse.wheel(0, 600)
    replay.wait_until("Math.abs(replay.view.zoom - 1) < 1e-6")


def test_dragging_moves_what_is_shown_along(opened: Opened) -> None:
    replay = opened(furnished_run())
    box = replay.page.locator("#canvas").bounding_box()
    assert box is not None
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    pixel = "[replay.view.pixelX(6), replay.view.pixelY(4)]"
    before = replay(pixel)
    replay.page.mouse.move(x, y)
    replay.page.mouse.down()
    replay.page.mouse.move(x + 50, y + 30)
    replay.page.mouse.up()
    assert replay(pixel) == pytest.approx([before[0] + 50, before[1] + 30])
    replay.page.mouse.move(x, y)
    assert replay(pixel) == pytest.approx([before[0] + 50, before[1] + 30])
    replay.page.mouse.dblclick(x, y)
    assert replay(pixel) == pytest.approx(before)


def test_two_fingers_zoom(opened: Opened) -> None:
    replay = opened(furnished_run())
    replay(
        """() => {
          const touch = (kind, pointerId, clientX, clientY) => replay.stage.canvas.dispatchEvent(
            new PointerEvent(kind, { pointerId, clientX, clientY, pointerType: "touch", bubbles: true }));
          replay.stage.canvas.setPointerCapture = () => {};
          touch("pointerdown", 1, 300, 300);
          touch("pointerdown", 2, 400, 300);
          touch("pointermove", 2, 500, 300);
          touch("pointermove", 1, 200, 300);
          touch("pointerup", 1, 200, 300);
          touch("pointerup", 2, 500, 300);
        }"""
    )
    assert replay("replay.view.zoom") == pytest.approx(3.0)


def test_buttons_and_keys_zoom(opened: Opened) -> None:
    replay = opened(furnished_run())
    before = replay.picture()
    replay.page.click("#zoom-in")
    assert replay("replay.view.zoom") == pytest.approx(1.5)
    assert replay.picture() != before
    replay.page.focus("#canvas")
    replay.page.keyboard.press("-")
    replay.page.click("#zoom-out")
    assert replay("replay.view.zoom") == pytest.approx(1 / 1.5)
    replay.page.keyboard.press("0")
    assert replay.picture() == before


def test_a_scene_far_from_the_origin_is_as_sharp_as_any(opened: Opened) -> None:
    recording = bare_runs()["far away"]
    replay = opened(recording)
    replay.show_only("balls", "shapes")
    for frame in (0, 15, 30):
        replay.seek(float(recording.times[frame]))
        assert replay.pixel(*recording.positions[frame, 0]) == LIGHT.inks["ball-1"]


def test_pointing_at_a_ball_tells_its_name_and_speed(opened: Opened) -> None:
    replay = opened(furnished_run())
    box = replay.page.locator("#canvas").bounding_box()
    assert box is not None
    x, y = replay("[replay.view.pixelX(1.5), replay.view.pixelY(1.6)]")
    replay.page.mouse.move(box["x"] + x, box["y"] + y)
    assert replay.page.inner_text("#pointed").startswith("ball a · speed 3.")
    replay.page.mouse.move(box["x"] + 5, box["y"] + 5)
    assert not replay.page.is_visible("#pointed")


@pytest.mark.parametrize("width", [390, 1280])
def test_names_lie_over_no_other_and_those_without_room_are_counted(opened: Opened, width: int) -> None:
    recording = furnished_run()
    replay = opened(recording, width)
    replay.show_only("names", "balls")
    for frame in (0, 40, 110):
        replay.seek(float(recording.times[frame]))
        labels = replay("replay.stage.names.labels.map(({ x, y, width, height }) => [x, y, width, height])")
        assert len(labels) + replay("replay.stage.names.leftOut") == 11
        assert len(labels) >= 10
        for place, (x, y, wide, high) in enumerate(labels):
            for other_x, other_y, other_wide, other_high in labels[:place]:
                assert 2 * abs(x - other_x) >= wide + other_wide or 2 * abs(y - other_y) >= high + other_high


def test_names_without_room_are_told_beside_their_switch(opened: Opened) -> None:
    world = carom.World()
    for place in range(40):
        world.add(
            carom.Segment((place % 8, 0.1 * (place // 8)), (place % 8 + 0.5, 0.1), name=f"a rather long name {place}")
        )
    replay = opened(carom.Recording.of(world, 0.1), 390)
    replay.show_only("names")
    left_out = replay("replay.stage.names.leftOut")
    assert left_out > 5
    said = "document.querySelector('.switch:has(#layer-names) .quiet').textContent"
    assert replay(said) == f"{left_out} names without room"
    replay.show_only("shapes")
    assert replay(said) == ""


def test_on_a_screen_such_as_4k_words_and_marks_are_larger_and_stay_where_they_belong(opened: Opened) -> None:
    recording = furnished_run()
    usual, large = opened(recording), opened(recording, 3840, 2160)
    assert usual("replay.view.marks") <= 1.0 < 1.5 < large("replay.view.marks") <= 2.0
    heights = [replay.page.locator("#name").bounding_box() for replay in (usual, large)]
    assert heights[0] is not None
    assert heights[1] is not None
    assert heights[1]["height"] > 1.4 * heights[0]["height"]
    scrub = large.page.locator("#scrub").bounding_box()
    assert scrub is not None
    large.page.mouse.click(scrub["x"] + 0.25 * scrub["width"], scrub["y"] + 0.5 * scrub["height"])
    assert large.time == pytest.approx(0.25 * recording.times[-1], abs=0.02)
    canvas = large.page.locator("#canvas").bounding_box()
    assert canvas is not None
    large.seek(0.0)
    x, y = large("[replay.view.pixelX(1.5), replay.view.pixelY(1.6)]")
    large.page.mouse.move(canvas["x"] + x, canvas["y"] + y)
    large.wait_until("!document.getElementById('pointed').hidden")
    told = large.page.locator("#pointed").bounding_box()
    assert told is not None
    assert abs(told["x"] - canvas["x"] - x) < 60.0
    assert abs(told["y"] - canvas["y"] - y) < 90.0
