"""What the panel says of a picture: samples of what there is, and what is left out."""

import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.page.painter import PagePainter
from carom.draw.parts.cells import Cell
from carom.draw.parts.frame import Frame
from carom.draw.parts.legend import ENTRIES, facts, legend, remarks, seconds, unnamed
from carom.draw.parts.looks import LOOKS, SENSOR, WALL
from carom.draw.parts.panel import GLYPH_WIDTH, NOTE, broken
from carom.shapes.aabb import Aabb
from tests.unit.draw.svg_marks import fallen, root_of, words_in
from tests.worlds import world_of


def legend_of(picture: draw.Picture) -> list[str]:
    """The words of a picture's legend."""
    return [entry for entry, _ in picture.panel.entries]


def test_the_legend_names_only_what_there_is() -> None:
    untouched = carom.World()
    untouched.add(carom.Ball((0, 0), 1))
    run = carom.Recording.of(untouched, 0.1)
    assert legend_of(draw.picture_at(run, layers=Layer)) == ["balls", "track, fading with age", "velocity", "box"]
    assert legend_of(draw.picture_of(carom.World(), "empty", layers=Layer)) == []
    marks = {"hit, sized by its impulse", "was just hit", "turns by speed of impact", "normal", "tangent"}
    assert marks <= set(legend_of(draw.picture_at(fallen(), layers=Layer)))


def test_a_picture_says_when_it_does_not_show_all_hits() -> None:
    world = world_of(carom.Circle((0, 0), 3))
    trace = draw.Trace(world)
    trace.bounces = 10_000
    lines = " ".join(words_in(root_of(world, trace).iter()))
    assert "Of the hits, the 1,500 strongest are shown." in lines


@pytest.mark.parametrize(("time", "text"), [(10.0, "10"), (0.125, "0.12"), (1234.5, "1,234.5"), (0.0, "0")])
def test_times_are_short(time: float, text: str) -> None:
    assert seconds(time) == f"{text}\N{NO-BREAK SPACE}s"


def test_entries_are_of_the_looks_that_occur_and_of_what_is_shown() -> None:
    everything = legend([WALL, SENSOR], ["ball-1"], list(Layer))
    words = [entry for entry, _ in everything]
    assert words[:4] == ["sensor", "wall", "balls", "track, fading with age"]
    assert len(words) == 4 + len(ENTRIES)
    assert [entry for entry, _ in legend([WALL, SENSOR], ["ball"], [Layer.SHAPES])] == ["wall"]
    assert [entry for entry, _ in legend([WALL, SENSOR], [], [Layer.BALLS, Layer.TRACKS, Layer.HITS])] == [
        "hit, sized by its impulse"
    ]


@pytest.mark.parametrize("name", [look.label for look in LOOKS] + ["balls", "track, fading with age"])
def test_samples_have_room_beside_their_words(name: str) -> None:
    samples = dict(legend(LOOKS, ["ball-1", "ball-2", "ball-3", "ball-4"], list(Layer)))
    frame, painter = Frame.around(Aabb(0.0, 0.0, 9.0, 9.0), 0.0), PagePainter()
    painter.layer("sample")
    samples[name](painter, frame, (100.0, 100.0))
    assert painter.layers["sample"]
    for call in painter.layers["sample"]:
        xs = call[2][:1] if call[0] in ("circle", "arc") else call[2][::2]
        away = [abs(frame.pixel(x, 0.0)[0] - 100.0) for x in xs]
        assert max(away) <= 0.5 * GLYPH_WIDTH + 1e-9


def test_what_is_left_out_is_said_and_nothing_else() -> None:
    cells = (Cell(Aabb(0.0, 0.0, 1.0, 1.0), 1),)
    assert remarks(list(Layer), 3, 3, 1.5, 10, cells) == ("Tracks of all balls, over the last 1.5\N{NO-BREAK SPACE}s.",)
    assert remarks([Layer.HITS], 3, 9, 1.5, 1501, cells) == ("Of the hits, the 1,500 strongest are shown.",)
    assert remarks([Layer.CELLS], 0, 9, 1.5, 0, ()) == (
        "There are no cells: every ball is tested against every shape.",
    )


def test_facts_are_of_the_world_or_of_its_run() -> None:
    world = world_of(carom.Segment((0, 0), (1, 0)), carom.Ball((0, 9), 1))
    assert facts(world, None) == (("shapes", "1"), ("balls", "1"))
    trace = draw.Trace(world)
    trace.bounces = 12_345
    world.step(0.5)
    assert facts(world, trace) == (("time", "0.5\N{NO-BREAK SPACE}s"), ("balls", "1"), ("hits", "12,345"))


def test_names_without_room_are_counted_in_a_line_of_the_panel() -> None:
    assert unnamed(0) == ()
    assert unnamed(1) == ("1 name has no room.",)
    assert broken(unnamed(12_345)[0], NOTE) == ["12,345 names have no room."]
