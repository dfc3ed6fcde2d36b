"""DXF drawings as scenes: layers, blocks, data, and what is refused."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import ezdxf
import pytest

import carom
from carom.scene.drawings import reading
from tests.clock import soon


def saved(folder: Path, draw: Callable[[Any, Any], None], version: str = "R2010") -> Path:
    """The file of a drawing."""
    document = ezdxf.new(version)
    document.appids.add("CAROM")
    for layer in ("walls", "bumper"):
        document.layers.add(layer)
    draw(document, document.modelspace())
    path = folder / "drawing.dxf"
    document.saveas(path)
    return path


def table(document: Any, space: Any) -> None:
    """A small table."""
    space.add_lwpolyline(
        [(0, 0, 0.5), (10, 0, 0), (10, 5, 0), (0, 5, 0)], format="xyb", close=True, dxfattribs={"layer": "walls"}
    )
    space.add_circle((3, 3), 1, dxfattribs={"layer": "bumper"}).set_xdata("CAROM", [(1000, "kick=4")])
    space.add_hatch().paths.add_edge_path().add_arc((3, 3), 1, 0, 360)
    space.add_circle((7, 3), 0.2).set_xdata("CAROM", [(1000, "ball=true mass=2"), (1000, "name=cue")])


@pytest.mark.parametrize("version", ["R12", "R2000", "R2010", "R2018"])
def test_a_table_is_read_as_it_is_drawn(tmp_path: Path, version: str) -> None:
    if version == "R12":
        scene = carom.Scene.load(
            saved(tmp_path, lambda _, space: space.add_circle((3, 3), 1, dxfattribs={"layer": "bumper"}), version)
        )
        assert scene.shapes[0].plain() == {"kind": "circle", "name": "bumper", "center": [3.0, 3.0], "radius": 1.0}
        return
    scene = carom.Scene.load(saved(tmp_path, table, version))
    assert [(one.kind, one.name) for one in scene.shapes] == [
        ("arc", "walls"), ("segment", "walls"), ("segment", "walls"), ("segment", "walls"), ("circle", "bumper"),
    ]  # fmt: skip
    assert scene.shapes[-1].plain() == {
        "kind": "circle", "name": "bumper", "center": [3.0, 3.0], "radius": 1.0, "solid": True, "kick": 4.0,
    }  # fmt: skip
    assert scene.balls[0].plain() == {"name": "cue", "position": [7.0, 3.0], "radius": 0.2, "mass": 2.0}


def test_the_name_of_a_layer_may_have_options(tmp_path: Path) -> None:
    path = saved(tmp_path, table)
    path.write_text(path.read_text().replace("\nwalls\n", "\nwalls elasticity=0.5\n"))
    assert {(one.name, one.elasticity) for one in carom.Scene.load(path).shapes[:4]} == {("walls", 0.5)}


def test_blocks_are_drawn_where_they_are_inserted(tmp_path: Path) -> None:
    def draw(document: Any, space: Any) -> None:
        block = document.blocks.new("B")
        block.add_circle((1, 0), 0.5)
        block.add_line((0, 0), (2, 0), dxfattribs={"layer": "bumper"})
        space.add_blockref("B", (10, 10), dxfattribs={"rotation": 90, "layer": "walls", "zscale": 0.0})
        array = space.add_blockref("B", (0, 0))
        array.dxf.column_count, array.dxf.column_spacing = 3, 5.0
        moving = space.add_blockref("B", (20, 0), dxfattribs={"layer": "walls"})
        moving.set_xdata("CAROM", [(1000, "angular_velocity=3")])

    scene = carom.Scene.load(saved(tmp_path, draw))
    first, line, *copies, compound = scene.shapes
    assert (first.name, first.center, first.radius) == ("walls", pytest.approx((10.0, 11.0)), 0.5)
    assert (line.name, line.end) == ("bumper", pytest.approx((10.0, 12.0)))
    assert [one.center for one in copies[::2]] == [(1.0, 0.0), (6.0, 0.0), (11.0, 0.0)]
    assert (compound.kind, compound.name, compound.pivot) == ("compound", "walls", (20.0, 0.0))
    assert (compound.angular_velocity, len(compound.shapes)) == (3.0, 2)


def test_a_stretched_block_has_ellipses(tmp_path: Path) -> None:
    def draw(document: Any, space: Any) -> None:
        document.blocks.new("B").add_circle((0, 0), 1)
        space.add_blockref("B", (0, 0), dxfattribs={"xscale": 2.0})

    scene = carom.Scene.load(saved(tmp_path, draw))
    assert {one.kind for one in scene.shapes} == {"arc"}
    box = scene.build().shapes
    assert max(one.aabb.right for one in box) == pytest.approx(2.0, abs=0.005)


def test_hidden_layers_are_no_bodies_and_the_rest_is_listed_once(tmp_path: Path) -> None:
    def draw(document: Any, space: Any) -> None:
        space.add_line((0, 0), (1, 0), dxfattribs={"layer": "walls"})
        space.add_line((0, 0), (1, 1), dxfattribs={"layer": "Defpoints"})
        space.add_line((0, 0), (2, 1))
        space.add_text("a")
        space.add_text("b")
        space.add_circle((1, 1), 0.0)
        document.layers.get("walls").off()

    with pytest.warns(carom.errors.DrawingWarning, match=r"left out: text \(2\), circle without a size \(1\)$"):
        scene = carom.Scene.load(saved(tmp_path, draw))
    assert [one.end for one in scene.shapes] == [(2.0, 1.0)]


def said_of(path: Path) -> str:
    """What is said of a drawing that is refused soon."""
    with soon(), pytest.raises(carom.SceneError) as caught:
        carom.Scene.load(path)
    return str(caught.value)


def test_mistakes_name_the_entity_and_its_line(tmp_path: Path) -> None:
    def draw(_: Any, space: Any) -> None:
        space.add_circle((3, 3), 1, dxfattribs={"layer": "bumper"}).set_xdata("CAROM", [(1000, "kik=4")])

    path = saved(tmp_path, draw)
    said = said_of(path)
    assert "CIRCLE on layer 'bumper' (handle " in said
    assert "CAROM kik: is unknown; did you mean kick?" in said

    def spaced(_: Any, space: Any) -> None:
        space.add_circle((3, 3), 1).set_xdata("CAROM", [(1000, "kick = 4")])

    assert "): CAROM: 'kick = 4': options stand at the end" in said_of(saved(tmp_path, spaced))


@pytest.mark.parametrize(
    ("draw", "words", "said"),
    [
        (lambda space: space.add_circle((0, 0), 1), "ball", "CAROM: 'ball': options stand at the end, without blanks"),
        (lambda space: space.add_circle((0, 0), 1), "velocity=3,4", "not (3.0, 4.0); a ball says ball=true"),
        (
            lambda space: space.add_lwpolyline([(0, 0), (1, 0), (2, 1)]),
            "motion=kinematic angular_velocity=3",
            "CAROM angular_velocity: needs a pivot too, such as pivot=10,20, for it is 2 pieces",
        ),
        (lambda space: space.add_circle((0, 0), 0), "kick=3", "draws nothing: it needs a size"),
    ],
)
def test_mistakes_say_what_would_be_right(tmp_path: Path, draw: Callable[[Any], Any], words: str, said: str) -> None:
    path = saved(tmp_path, lambda _, space: draw(space).set_xdata("CAROM", [(1000, words)]))
    assert said in said_of(path)


def test_a_coordinate_that_is_no_number_is_told(tmp_path: Path) -> None:
    path = saved(tmp_path, lambda _, space: space.add_line((0, 0), (7.25, 0), dxfattribs={"layer": "wall"}))
    path.write_text(path.read_text().replace("7.25", "nan"))
    said = said_of(path)
    assert "LINE on layer 'wall'" in said
    assert said.endswith("has a coordinate that is no number")


def nested(document: Any, space: Any) -> None:
    """Blocks of blocks of blocks."""
    for level in range(12):
        block = document.blocks.new(f"B{level}")
        if level == 0:
            block.add_line((0, 0), (1, 0))
        for place in range(10):
            if level:
                block.add_blockref(f"B{level - 1}", (place, 0))
    space.add_blockref("B11", (0, 0))


def endless(document: Any, space: Any) -> None:
    """A block in itself."""
    document.blocks.new("A").add_blockref("B", (0, 0))
    document.blocks.new("B").add_blockref("A", (0, 0))
    space.add_blockref("A", (0, 0))


def wide(document: Any, space: Any) -> None:
    """A block many times."""
    document.blocks.new("A").add_line((0, 0), (1, 0))
    array = space.add_blockref("A", (0, 0))
    array.dxf.column_count, array.dxf.row_count = 30000, 30000
    array.dxf.column_spacing = array.dxf.row_spacing = 2.0


@pytest.mark.parametrize(
    ("draw", "said"),
    [(nested, "draws more than"), (endless, "is inserted in itself, without end"), (wide, "draws more than")],
)
def test_hostile_blocks_are_refused(tmp_path: Path, draw: Callable[[Any, Any], None], said: str) -> None:
    assert said in said_of(saved(tmp_path, draw))


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"AutoCAD Binary DXF\r\n\x1a\x00", "is a binary DXF; it must be saved as text"),
        (b"", "is no DXF that can be read"),
        (b"no drawing", "is no DXF that can be read"),
        (b"  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n 10\nx\n", "is no DXF that can be read"),
        (b"  0\nSECTION\n" + b"  0\nLINE\n" * 1_000_000, "a drawing may have at most"),
    ],
)
def test_broken_files_are_refused(tmp_path: Path, data: bytes, said: str) -> None:
    path = tmp_path / "broken.dxf"
    path.write_bytes(data)
    assert said in said_of(path)


def test_what_ezdxf_warns_of_is_not_told_for_each_entity(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    path = saved(tmp_path, lambda _, space: [space.add_line((0, 0), (k, 1)) for k in range(1, 9)])
    lines = path.read_text().split("\n")
    handles = [k + 3 for k, line in enumerate(lines) if line == "LINE" and lines[k + 1].strip() == "5"]
    for place in handles:
        lines[place - 1] = "ABC"
    assert len(handles) == 8
    path.write_text("\n".join(lines))
    carom.Scene.load(path)
    assert not caplog.records


def test_a_drawing_is_not_looked_at_any_more_once_there_are_faults_enough(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "ENOUGH_FAULTS", 3)

    def draw(document: Any, space: Any) -> None:
        block = document.blocks.new("many")
        for k in range(5):
            block.add_line((k, 0), (k, 1)).set_xdata("CAROM", [(1000, "kik=4")])
        space.add_blockref("many", (0, 0))

    said = said_of(saved(tmp_path, draw)).splitlines()
    assert said[0].endswith(": 3 faults, and what comes after them was not looked at")
    assert ["LINE" in line for line in said[1:]] == [True] * 3
