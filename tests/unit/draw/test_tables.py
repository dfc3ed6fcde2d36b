"""Hits, balls and shapes are tables in notebooks: names for ids, few digits, the first and the last rows."""

from html.parser import HTMLParser

import numpy as np
import pytest

import carom
from carom.draw.tables import BALL_COLUMNS, FIRST, LAST, SHAPE_COLUMNS, table_of
from carom.pictured import Tabled
from tests.pages.runs import NASTY, furnished, furnished_run


class Cells(HTMLParser):
    """The caption and the cells of a table of HTML, row by row."""

    def __init__(self, text: str | None) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.caption = ""
        self._within = ""
        self.feed(text or "")

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag in {"table", "caption", "thead", "tbody", "tr", "th", "td"}
        self._within = tag
        if tag == "tr":
            self.rows.append([])
        if tag in {"th", "td"}:
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        self._within = ""

    def handle_data(self, data: str) -> None:
        if self._within == "caption":
            self.caption += data
        else:
            self.rows[-1][-1] += data


def run_of(seconds: float = 4.0) -> tuple[carom.World, carom.Hits]:
    """The furnished room after a while, and all that was hit."""
    world = furnished()
    return world, world.run(seconds)


def test_hits_are_a_table_with_names_for_ids() -> None:
    _, hits = run_of()
    table = Cells(hits._repr_html_())
    assert table.caption == f"{len(hits)} hits"
    assert table.rows[0] == list(hits.dtype.names or ())
    assert len(table.rows) == 1 + FIRST + 1 + LAST
    assert set(table.rows[1 + FIRST]) == {"\N{HORIZONTAL ELLIPSIS}"}
    first = dict(zip(table.rows[0], table.rows[1], strict=True))
    hit = hits[0]
    assert first["ball"] == hit.ball.name
    assert first["shape"] == hit.shape.name
    assert first["kind"] == hit.kind.name.lower()
    assert first["point"] == f"({hit.point[0]:.4g}, {hit.point[1]:.4g})"
    assert first["speed"] == f"{hit.speed:.4g}"
    last = dict(zip(table.rows[0], table.rows[-1], strict=True))
    assert last["time"] == f"{hits[-1].time:.4g}"


def test_a_few_hits_are_shown_whole_and_none_as_a_head_alone() -> None:
    _, hits = run_of()
    assert len(Cells(hits[:7]._repr_html_()).rows) == 8
    assert Cells(hits[:1]._repr_html_()).caption == "1 hit"
    assert Cells(hits[:0]._repr_html_()).caption == "0 hits"


def test_touches_counts_and_answers_are_tables_too() -> None:
    world, hits = run_of()
    assert Cells(hits.touches()._repr_html_()).caption == f"{len(hits.touches())} touches"
    counts = Cells(hits.counts()._repr_html_())
    assert "wall" in {row[0] for row in counts.rows}
    assert Cells(world.contacts()._repr_html_()).caption.endswith("contacts")
    nearest = Cells(world.nearest([(6.0, 0.1), (9.0, 3.0)])._repr_html_())
    assert [row[0] for row in nearest.rows[1:]] == ["wall", "bumper"]
    misses = Cells(carom.World().ray_cast([(0, 0)], [(1, 0)])._repr_html_())
    assert misses.rows[1][0] == ""


def test_what_is_no_row_any_more_is_no_table() -> None:
    _, hits = run_of()
    assert hits.view(np.uint8)._repr_html_() is None
    assert hits[:4].reshape(2, 2)._repr_html_() is None


def test_hits_of_no_world_have_ids() -> None:
    world, hits = run_of()
    del world
    lost = hits.copy()
    lost._link = None
    assert Cells(lost._repr_html_()).rows[1][2] == f"{hits['ball'][0]}"


def test_balls_are_a_table_that_makes_no_objects_of_them() -> None:
    world = carom.World()
    world.add(carom.Ball((1, 2), 0.5, velocity=(3, 4), mass=2.0, name="mine"))
    world.add_balls(position=np.column_stack((np.arange(100.0), np.full(100, 9.0))), velocity=0.0, radius=0.25)
    known = len(world._objects)
    table = Cells(world.balls._repr_html_())
    assert len(world._objects) == known
    assert table.caption == "101 balls"
    assert table.rows[0] == list(BALL_COLUMNS)
    assert table.rows[1][1:6] == ["mine", "(1, 2)", "(3, 4)", "0.5", "2"]
    assert table.rows[-1][2] == "(99, 9)"
    assert len(table.rows) == 2 + FIRST + LAST


def test_shapes_are_a_table_with_a_row_for_each_compound() -> None:
    world = furnished()
    blade = carom.Segment((2, 6), (3, 6))
    world.add(carom.Compound([blade, *carom.guard_points([blade])], pivot=(2, 6), name="oar"))
    table = Cells(world.shapes._repr_html_())
    assert table.rows[0] == list(SHAPE_COLUMNS)
    assert len(table.rows) == 1 + len(world.shapes)
    assert table.rows[-1][:3] == ["", "compound of 3", "oar"]
    kinds = {row[2]: row[1] for row in table.rows[1:]}
    assert kinds["bumper"] == "circle"
    assert kinds["sensor"] == "segment"
    assert {row[2]: row[-1] for row in table.rows[1:]}["sensor"] == "yes"


def test_names_are_words_and_no_elements() -> None:
    world = carom.World()
    world.add(carom.Segment((0, 0), (1, 0), name=NASTY))
    assert Cells(world.shapes._repr_html_()).rows[1][2] == NASTY


def test_of_anything_else_there_is_no_table() -> None:
    with pytest.raises(TypeError, match="no tables of a Tabled"):
        table_of(Tabled())


def test_hits_of_a_recording_are_the_same_table() -> None:
    run = furnished_run()
    table = Cells(run.hits._repr_html_())
    assert table.caption == f"{len(run.hits)} hits"
    first = dict(zip(table.rows[0], table.rows[1], strict=True))
    assert first["shape"] == run.label_of(int(run.hits["shape"][0]))
    assert run.hits.reshape(1, -1)._repr_html_() is None
