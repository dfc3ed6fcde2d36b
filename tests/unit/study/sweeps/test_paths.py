"""Parameters by path: where they lead, and what they set."""

from typing import Any

import pytest

import carom
from carom.study.sweeps.paths import check_values, is_path, places_of, with_values

SCENE = carom.Scene(
    shapes=[
        carom.Circle((0, 0), 1.0, name="left bumper"),
        carom.Circle((3, 0), 1.0, name="left bumper.kick"),
        carom.Segment((0, 5), (1, 5), name="peg"),
        carom.Segment((0, 6), (1, 6), name="peg"),
        carom.Compound([carom.Circle((0, 9), 1.0)], (0, 9), name="flipper"),
    ],
    balls=[carom.Ball((0, 3), 0.5, name="cue"), carom.Ball((2, 3), 0.5)],
)


def scene_with(path: str, value: Any) -> carom.Scene:
    """The scene with a value at a path."""
    return with_values(SCENE, [(steps, value) for steps in places_of(SCENE, path)])


def test_paths_set_the_fields_that_they_name_and_nothing_else() -> None:
    table = SCENE.plain()
    for path, value, change in [
        ("world.gravity", (0, -3), lambda t: t.setdefault("world", {}).update(gravity=[0.0, -3.0])),
        ("world.gravity[1]", -3, lambda t: t.setdefault("world", {}).update(gravity=[0.0, -3.0])),
        ("shapes[0].kick", 2, lambda t: t["shapes"][0].update(kick=2.0)),
        ("shapes.left bumper.kick", 2, lambda t: t["shapes"][0].update(kick=2.0)),
        ("shapes.left bumper.kick.kick", 2, lambda t: t["shapes"][1].update(kick=2.0)),
        ("shapes.flipper.shapes[0].radius", 2, lambda t: t["shapes"][4]["shapes"][0].update(radius=2.0)),
        ("balls.cue.velocity", [1, 2], lambda t: t["balls"][0].update(velocity=[1.0, 2.0])),
        ("balls[1].radius", 0.25, lambda t: t["balls"][1].update(radius=0.25)),
    ]:
        expected = SCENE.plain()
        change(expected)
        assert carom.Scene(**expected) == scene_with(path, value), path
        assert is_path(path)
    assert SCENE.plain() == table


def test_a_name_of_several_means_all_of_them() -> None:
    assert [shape.elasticity for shape in scene_with("shapes.peg.elasticity", 0.5).shapes[:4]] == [1.0, 1.0, 0.5, 0.5]


def test_what_goes_only_together_is_set_together() -> None:
    places = {path: places_of(SCENE, path)[0] for path in ("shapes[2].start", "shapes[2].end")}
    moved = with_values(SCENE, [(places["shapes[2].start"], (1, 5)), (places["shapes[2].end"], (2, 5))])
    assert (moved.shapes[2].start, moved.shapes[2].end) == ((1, 5), (2, 5))  # type: ignore[union-attr]
    with pytest.raises(carom.SceneError, match=r"shapes\[2\]"):
        with_values(SCENE, [(places["shapes[2].start"], (1, 5))])


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("word.gravity", "must begin with world or shapes or balls"),
        ("world.gravty", "world has no field gravty; did you mean gravity"),
        ("world.gravity[2]", r"world.gravity has no item 2: there are 2"),
        ("world.friction[0]", r"world.friction has no item 0: it is no list"),
        ("world.friction.x", r"world.friction has no field x; there are none"),
        ("shapes.left bumpr.kick", "none of the shapes is called 'left bumpr'; did you mean left bumper"),
        ("shapes.zzz.kick", "names are left bumper, left bumper.kick, peg, flipper"),
        ("shapes[9].kick", r"shapes has no item 9: there are 5"),
        ("shapes[0].kind", r"shapes\[0\] has no field kind"),
        ("shapes[0]", "must lead to a field"),
        ("shapes.flipper.shapes", "must lead to a field"),
        ("balls[0]velocity", r"cannot be read from 'velocity' on"),
        ("balls[-1].velocity", "cannot be read from"),
    ],
)
def test_a_path_that_leads_nowhere_is_refused(path: str, words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words) as caught:
        places_of(SCENE, path)
    assert str(caught.value).startswith(f"parameters: {path}: ")


@pytest.mark.parametrize(
    ("path", "value", "fault"),
    [
        ("shapes.left bumper.kick", -1, r"shapes\[0\].kick: must not be negative, not -1"),
        ("shapes.flipper.shapes[0].radius", 0, r"shapes\[4\].shapes\[0\].radius: must be positive, not 0"),
        ("world.gravity", 3, "world.gravity: must be a pair of numbers, not 3"),
        ("balls.cue.mass", "heavy", r"balls\[0\].mass: must be a number, not 'heavy'"),
    ],
)
def test_a_value_that_cannot_stand_there_is_a_fault_with_its_place(path: str, value: Any, fault: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=fault) as caught:
        check_values(SCENE, path, places_of(SCENE, path), [1.0 if path.endswith("kick") else value, value])
    assert str(caught.value).count(fault.replace("\\", "").partition(":")[0]) == 1
