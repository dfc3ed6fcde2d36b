"""What a page is given of a run: layers, inks, counts."""

import json

import pytest

import carom
from carom.draw.page.drawing import Cast
from carom.draw.page.run import MOST_SHARES, balls_on_stage, energy_column, facts, page_run, shares, stage_box
from carom.draw.parts.layers import Layer
from carom.draw.theme import ThemeName
from carom.world.hits import HitKind
from carom.world.touches import touches_of
from tests.pages.runs import bare_runs, furnished_run
from tests.unit.draw.page.unpacking import unpacked
from tests.worlds import world_of


def test_themes_and_layers_are_those_asked_for() -> None:
    data = page_run(furnished_run(), ThemeName.DARK, {Layer.BOXES})
    assert data["theme"] == "dark"
    assert [layer["name"] for layer in data["layers"] if layer["on"]] == ["boxes"]
    assert {layer["name"] for layer in data["layers"]} == set(Layer)


def test_no_ink_is_missing_from_a_theme() -> None:
    data = page_run(furnished_run(), ThemeName.AUTO, ())
    inks = {style.get(part) for style in data["styles"] for part in ("stroke", "fill", "ink")} - {None}
    for theme in data["themes"].values():
        assert inks | set(data["ball_inks"]) <= set(theme)


def test_the_counts_are_of_names_and_end_with_all_others() -> None:
    counts = dict(shares(furnished_run()))
    touches = touches_of(furnished_run().hits)
    assert sum(counts.values()) == len(touches) < len(furnished_run().hits)
    assert counts["wall"] == sum(furnished_run().label_of(shape) == "wall" for shape in touches["shape"].tolist())


def test_a_long_list_of_counts_is_cut_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.draw.page.run.MOST_SHARES", 1)
    first, rest = shares(furnished_run())
    assert rest == ("", len(touches_of(furnished_run().hits)) - first[1])
    assert MOST_SHARES > 1


def test_a_page_knows_the_names_and_sizes_of_all_in_their_order() -> None:
    run = furnished_run()
    data = page_run(run, ThemeName.AUTO, ())
    assert data["ball_names"] == [run.label_of(int(ball)) for ball in run.ids]
    assert [shape["label"] for shape in data["shapes"]] == [run.label_of(int(shape)) for shape in run.shape_ids]
    assert data["radii"] == run.radii.tolist()
    assert data["named"] == list(range(len(run.ids)))
    assert json.loads(json.dumps(data)).keys() == data.keys()


def test_facts_count_what_there_was_and_leave_out_what_was_not() -> None:
    run = furnished_run()
    told = facts(run)
    assert told["frames"] == f"{len(run):,}"
    for label, kind in (("bounces", HitKind.BOUNCE), ("sensors entered", HitKind.ENTER)):
        assert int(told[label]) == int((run.hits["kind"] == kind).sum()) > 0
    assert int(told["touches"]) == len(touches_of(run.hits))
    assert "0" not in told.values()


def test_the_stage_is_chosen_for_the_first_frame_or_for_all_where_nothing_stands() -> None:
    alone, lost = bare_runs()["a ball alone"], bare_runs()["a ball that is lost"]
    balls = balls_on_stage(alone)
    assert len(balls.ids) == len(alone)
    assert len(balls_on_stage(lost).ids) == 1
    box = stage_box(Cast.of(alone), balls)
    assert (box.left, box.right) == pytest.approx((0.5, alone.positions[-1, 0, 0] + 0.5))


def test_the_stage_holds_the_shapes_and_the_balls_that_begin_near_them() -> None:
    world = world_of(carom.Segment((0, 0), (4, 0)), carom.Ball((2, 3), 0.5), carom.Ball((2, 90), 0.5))
    run = carom.Recording.of(world, 0.1)
    box = stage_box(Cast.of(run), balls_on_stage(run))
    assert tuple(box) == (0.0, 0.0, 4.0, 3.5)
    aside = carom.Recording.of(world_of(carom.Segment((0, 0), (4, 0)), carom.Ball((-2, -3), 0.5)), 0.1)
    assert tuple(stage_box(Cast.of(aside), balls_on_stage(aside))) == (-2.5, -3.5, 4.0, 0.0)


def test_balls_that_all_begin_far_from_the_shapes_are_on_the_stage() -> None:
    run = carom.Recording.of(world_of(carom.Segment((-1, 0), (1, 0)), carom.Ball((0, 5), 0.5)), 0.1)
    assert tuple(stage_box(Cast.of(run), balls_on_stage(run))) == (-1.0, 0.0, 1.0, 5.5)


def test_energies_come_back() -> None:
    run = furnished_run()
    column = energy_column(run)
    assert column["unit"] * unpacked(column)[0] == pytest.approx(run.kinetic_energy(), abs=column["unit"])
    nothing = energy_column(bare_runs()["nothing"])
    assert unpacked(nothing)[0].tolist() == [0]
