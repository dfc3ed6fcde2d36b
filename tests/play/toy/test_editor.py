"""The table that is edited: things dragged, turned, added, taken away, kept as a scene file; on both tables alike."""

from __future__ import annotations

from cmath import exp
from math import hypot, pi
from pathlib import Path
from typing import Any

import pygame
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

import carom
from carom.play.toy.editor import Editor, made, whole
from carom.play.toy.items import OPTIONS
from carom.play.toy.table import Table
from tests.play.toy.playing import Player

SHELF = (21.25, 17.0)


def shape_of(player: Player, name: str) -> Any:
    """A shape of the first table by its name."""
    return next(shape for shape in player.world.shapes if shape.name == name)


def at(player: Player, place: tuple[float, float], kind: int, button: int = 1) -> None:
    """An event of the mouse at a place of the first table, and a frame."""
    x, y = player.toy.views[0].pixel(place)
    more = {"rel": (0, 0), "buttons": (0, 0, 0)} if kind == pygame.MOUSEMOTION else {"button": button}
    pygame.event.post(pygame.event.Event(kind, pos=(round(x), round(y)), **more))
    player.frames()


def test_a_shape_is_dragged_and_balls_bounce_off_it_where_it_is_then(player: Player) -> None:
    player.key(pygame.K_e)
    shelf = shape_of(player, "shelf")
    at(player, SHELF, pygame.MOUSEBUTTONDOWN)
    at(player, (21.25, 12.0), pygame.MOUSEMOTION)
    at(player, (21.25, 12.0), pygame.MOUSEBUTTONUP)
    assert shelf.position == pytest.approx((21.25, 12.0), abs=0.06)
    at(player, (14.0, 22.0), pygame.MOUSEMOTION)
    assert shelf.position == pytest.approx((21.25, 12.0), abs=0.06), "it was let go"
    ends = {shelf.p0, shelf.p1}
    assert ends <= {shape.position for shape in player.world.shapes if shape.name == "guard point"}
    hit = player.world.ray_cast((21.25, 23.0), (21.25, 1.0))
    assert hit is not None
    assert hit.shape is shelf


def test_time_stands_still_while_the_table_is_edited(player: Player) -> None:
    player.key(pygame.K_p)
    player.key(pygame.K_e)
    before = player.world.time
    player.frames(4)
    assert player.world.time == before
    player.key(pygame.K_e)
    player.frames(2)
    assert player.world.time > before


@pytest.mark.slow
def test_what_is_pointed_at_turns_by_wheel_and_keys(player: Player) -> None:
    player.key(pygame.K_e)
    shelf = shape_of(player, "shelf")
    at(player, SHELF, pygame.MOUSEMOTION)
    for _ in range(3):
        pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=1))
    player.frames()
    assert shelf.p1[1] - shelf.p0[1] == pytest.approx(shelf.length * 0.25882, rel=1e-4)  # the sine of 15°
    for _ in range(3):
        player.key(pygame.K_PERIOD)
    assert shelf.p0 == pytest.approx((18.5, 17.0))


@pytest.mark.parametrize("kind", OPTIONS["kind"])
def test_a_click_beside_all_adds_one_and_the_right_button_takes_it_away(player: Player, kind: str) -> None:
    player.key(pygame.K_e)
    player.click(("kind", kind))
    before = [shape.id for shape in player.world.shapes if shape.name != "guard point"]
    balls = len(player.world.balls)
    place = (8.0, 13.0)
    at(player, place, pygame.MOUSEBUTTONDOWN)
    at(player, place, pygame.MOUSEBUTTONUP)
    new = [
        thing
        for thing in (*player.world.shapes, *player.world.balls)
        if thing.kind == kind
        and thing.name != "guard point"
        and hypot(*(a - b for a, b in zip(thing.position, place, strict=True))) < 0.1
    ]
    assert len(new) == 1
    spot = (place[0], place[1] + 2.0) if kind == "arc" else place
    at(player, spot, pygame.MOUSEBUTTONDOWN, button=3)
    assert [shape.id for shape in player.world.shapes if shape.name != "guard point"] == before
    assert len(player.world.balls) == balls


def test_keys_edit_nothing_while_the_table_is_played_on(player: Player) -> None:
    at(player, SHELF, pygame.MOUSEMOTION)
    before = player.world.digest()
    for key in (pygame.K_a, pygame.K_x, pygame.K_COMMA, pygame.K_PERIOD):
        player.key(key)
    at(player, SHELF, pygame.MOUSEBUTTONDOWN, button=3)
    assert player.world.digest() == before


EDITS = st.lists(
    st.tuples(
        st.sampled_from(["move", "turn", "remove", *OPTIONS["kind"]]),
        st.integers(0, 30),
        st.floats(-5.0, 40.0),
        st.floats(-5.0, 30.0),
    ),
    max_size=6,
)


@pytest.mark.slow
@settings(max_examples=12, deadline=None, phases=[Phase.generate])
@given(edits=EDITS)
def test_after_any_edits_both_tables_are_the_same_and_a_scene_keeps_them(edits: list[Any]) -> None:
    first, second, editor = Table(), Table(), Editor()
    second.become(first)
    tables = [first, second]
    for name, which, x, y in edits:
        things = [thing for thing in (*first.world.shapes, *first.world.balls) if thing.name != "guard point"]
        thing = things[which % len(things)]
        if name == "move":
            editor.take(thing, thing.position)
            editor.move(tables, (x, y))
            bounds, (now_x, now_y) = first.world.bounds, thing.position
            assert bounds is not None
            assert bounds.left <= now_x <= bounds.right
            assert bounds.bottom <= now_y <= bounds.top
            editor.drop(tables)
        elif name == "turn":
            editor.turn(tables, thing, x)
        elif name == "remove":
            editor.remove(tables, thing)
        else:
            editor.add(tables, name, (x, y), 0.3)
    assert first.world.digest() == second.world.digest()
    assert first.launched == second.launched
    kept = carom.Scene.from_world(first.world).build()
    assert len(kept.shapes) == len(first.world.shapes)
    wanted = carom.guard_points(shape for shape in kept.shapes if not isinstance(shape, carom.Compound))
    assert wanted == [], "every bare end has its point"


@settings(max_examples=10, deadline=None)
@given(angle=st.floats(-7.0, 7.0), kind=st.sampled_from(["segment", "arc", "circle", "point", "ball"]))
def test_what_turns_keeps_its_place_and_its_extent(angle: float, kind: str) -> None:
    table, editor = Table(), Editor()
    thing = table.world.add(made(kind, (16.0, 20.0), 0.4))
    before = (thing.position, getattr(thing, "length", 0.0), getattr(thing, "radius", 0.0))
    editor.turn([table], thing, angle)
    after = (thing.position, getattr(thing, "length", 0.0), getattr(thing, "radius", 0.0))
    assert after[0] == pytest.approx(before[0])
    assert after[1:] == pytest.approx(before[1:])
    if kind == "segment":
        along = complex(*thing.end) - complex(*thing.start)
        # Its ends stand in the order of their x, so it may point either way.
        assert along * along == pytest.approx(16.0 * exp(2j * angle))
    if kind == "arc":
        assert (thing.start_angle - angle + pi) % (2.0 * pi) - pi == pytest.approx(0.0, abs=1e-9)


def test_a_part_is_dragged_with_all_of_its_compound(player: Player) -> None:
    paddle = shape_of(player, "paddle")
    assert whole(paddle.shapes[0]) is paddle
    player.key(pygame.K_e)
    at(player, (22.5, 9.6), pygame.MOUSEBUTTONDOWN)
    at(player, (22.5, 12.6), pygame.MOUSEMOTION)
    at(player, (22.5, 12.6), pygame.MOUSEBUTTONUP)
    assert paddle.position == pytest.approx((24.0, 13.5), abs=0.06)


@pytest.mark.slow
def test_a_table_is_kept_as_a_scene_file_and_said_where(
    player: Player, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "carom-table-1.toml").write_text("mine")
    player.desk.editor.add(player.desk.tables, "circle", (8.0, 13.0), 0.5)
    player.click("save")
    path = tmp_path / "carom-table-2.toml"
    assert player.desk.told == f"table kept as {path}"
    assert (tmp_path / "carom-table-1.toml").read_text() == "mine"
    kept = carom.Scene.load(path).build()
    assert [shape.position for shape in kept.shapes] == [shape.position for shape in player.world.shapes]
    assert kept.balls.position.tolist() == player.world.balls.position.tolist()
    assert kept.step(1 / 60) is not None
    assert player.toy._told_left > 0.0
    player.frames(60 * 6)
    assert player.toy._told_left <= 0.0
