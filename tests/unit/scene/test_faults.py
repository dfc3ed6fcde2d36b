"""What is wrong with a scene is said all at once, each fault with its path, its words and the value."""

from pathlib import Path

import pytest

import carom

FAULTY = """
name = "faulty"
colour = "red"

[world]
gravity = [0.0, nan]
detection = "fast"
substeps = 0

[[shapes]]
kind = "circle"
center = [0, 0]
radius = -1.0

[[shapes]]
kind = "segment"
start = [0, 0]
end = [0.0, 0.0]

[[shapes]]
kind = "blob"

[[shapes]]
radius = 2

[[shapes]]
kind = "arc"
center = [1, 2, 3]
radius = "big"
start_angle = true

[[shapes]]
kind = "compound"
pivot = [0, 0]
shapes = [{ kind = "point", position = [0, 0], pivot = [1, 1] }, { kind = "circle", center = [0, inf], radius = 1 }]

[[shapes]]
kind = "gate"
start = [0, 0]
end = [1, 0]
direction = [1, 0]

[[balls]]
position = [0, 0]
radius = 1
mass = 0
"a strange key" = 1
"""

FAULTS = [
    "version: is missing",
    "world.gravity[1]: must be finite, not nan",
    "world.detection: must be 'discrete' or 'continuous', not 'fast'",
    "world.substeps: must be at least 1, not 0",
    "shapes[0].radius: must be positive, not -1.0",
    "shapes[1].end: must ",
    "shapes[2].kind: must be one of 'point', 'segment', 'circle', 'arc', 'gate', 'compound', 'group', not 'blob'",
    "shapes[3].kind: is missing",
    "shapes[4].center: must be a pair of numbers, not [1, 2, 3]",
    "shapes[4].radius: must be a number, not 'big'",
    "shapes[4].start_angle: must be a number, not True",
    "shapes[4].end_angle: is missing",
    "shapes[5].shapes[1].center[1]: must be finite, not inf",
    "shapes[6].direction: must ",
    "balls[0].mass: must be positive, not 0",
    "balls[0].'a strange key': is unknown",
    "colour: is unknown",
]


def test_all_faults_of_a_file_are_told_at_once(tmp_path: Path) -> None:
    path = tmp_path / "faulty.toml"
    path.write_text(FAULTY, encoding="utf-8")
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene.load(path)
    heading, *lines = str(caught.value).split("\n  ")
    assert heading == f"{path}: {len(FAULTS)} faults"
    assert [line[: len(fault)] for line, fault in zip(lines, FAULTS, strict=True)] == FAULTS


def test_one_fault_stands_on_the_first_line(tmp_path: Path) -> None:
    path = tmp_path / "faulty.json"
    path.write_text('{"version": 1, "balls": [{"position": [0, 0], "radius": -2}]}', encoding="utf-8")
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene.load(path)
    assert str(caught.value) == f"{path}: balls[0].radius: must be positive, not -2"


def test_a_fault_is_an_error_of_values_and_of_carom() -> None:
    with pytest.raises(carom.CaromError):
        carom.Scene(guard=3)
    with pytest.raises(ValueError, match=r"^guard: must be true or false, not 3$"):
        carom.Scene(guard=3)


def test_long_values_are_cut() -> None:
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(guard="x" * 1000)
    assert len(str(caught.value)) < 120
    assert str(caught.value).endswith("...")


def test_a_field_called_like_a_kind_keeps_its_name() -> None:
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(shapes=[{"kind": "point", "position": (0, 0), "point": 1}])
    assert str(caught.value) == "shapes[0].point: is unknown; did you mean position?"


@pytest.mark.parametrize("things", [3, "circle", {"kind": "circle"}, [3], [None], ["circle"]])
@pytest.mark.parametrize("field", ["shapes", "balls"])
def test_what_is_no_table_is_said_to_be_none(field: str, things: object) -> None:
    with pytest.raises(carom.SceneError, match=rf"^{field}(\[0\])?: must be a (list|table), not "):
        carom.Scene(**{field: things})


def test_a_shape_that_no_number_can_hold_is_refused() -> None:
    with pytest.raises(carom.SceneError, match=r"^shapes\[0\].radius: must leave the shape's place and box finite"):
        carom.Scene(shapes=[{"kind": "circle", "center": (1e308, 0.0), "radius": 1.7e308}])
