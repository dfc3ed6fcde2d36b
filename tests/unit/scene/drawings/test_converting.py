"""Drawings as scenes that a person can read."""

from pathlib import Path

import pytest

import carom
from carom.scene.drawings.converting import converted, digits_of, round_table
from tests.drawings import svg


def scene_of(folder: Path, inside: str, root: str = 'width="100mm" height="100mm"') -> carom.Scene:
    """What a drawing is converted to."""
    path = folder / "drawing.svg"
    path.write_text(svg(inside, root))
    return converted(path)


def test_numbers_are_rounded_to_the_tolerance(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, '<line id="wall" x1="10.123" y1="20.456mm" x2="300.7" y2="20.456mm"/>')
    assert scene.shapes[0].plain() == {"kind": "segment", "name": "wall", "start": [2.68, 79.54], "end": [79.56, 79.54]}


def test_an_outline_with_an_arc_stays_smooth(tmp_path: Path) -> None:
    inside = (
        '<g transform="rotate(7 100 100)"><rect x="50" y="50" width="200" height="100" rx="30"/>'
        '<path d="M 300 100 C 330 130 330 180 300 200 L 310.123 230.456 L 310.123 250.789"/></g>'
    )
    scene = scene_of(tmp_path, inside)
    points = [shape for shape in scene.build().shapes if shape.kind == "point"]
    assert len(points) == 4
    text = repr(scene.plain())
    scene.save(tmp_path / "a.toml")
    assert repr(carom.Scene.load(tmp_path / "a.toml").plain()) == text


def test_what_would_be_rounded_away_is_not(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, '<line x2="300"/><line x1="9.11" x2="9.12"/><circle cx="50" cy="50" r="0.001"/>')
    _, tiny, dot = scene.shapes
    assert tiny.start != tiny.end
    assert dot.radius == pytest.approx(0.001 * 25.4 / 96.0)


def test_compounds_are_rounded_part_by_part(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, '<g data-carom-pivot="10.123 0"><line x1="10.123" x2="300.7"/></g>')
    (compound,) = scene.shapes
    assert (compound.pivot, compound.shapes[0].end) == ((2.68, 100.0), (79.56, 100.0))


def test_a_picture_of_carom_is_converted_to_its_scene(tmp_path: Path) -> None:
    scene = carom.Scene(balls=[{"position": (0.123456789, 0), "radius": 1}])
    path = tmp_path / "picture.svg"
    path.write_text(carom.draw.svg(carom.draw.picture_of(scene.build()), scene=scene))
    assert converted(path) == scene


def test_mistakes_name_the_file(tmp_path: Path) -> None:
    with pytest.raises(carom.SceneError, match=r"drawing.svg: <line> \(line 2\): data-carom-kik"):
        scene_of(tmp_path, '<line x2="9" data-carom-kik="1"/>')


@pytest.mark.parametrize(("tolerance", "digits"), [(0.2, 1), (0.1, 1), (1.0, 0), (25.0, -1), (1e-3, 3), (0.0, 13)])
def test_digits_follow_from_the_tolerance(tolerance: float, digits: int) -> None:
    assert digits_of(tolerance) == digits


def test_there_is_no_minus_before_nothing() -> None:
    table = {"kind": "segment", "start": [-0.01, 1.0], "end": [2.0, 3.0]}
    round_table(table, 1, 13)
    assert str(table["start"]) == "[0.0, 1.0]"
