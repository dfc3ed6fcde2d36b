"""Scenes kept in pictures of them."""

import pytest

import carom
from carom.scene.drawings.keeping import kept_in, with_scene
from carom.scene.drawings.tree import read_tree
from tests.drawings import svg

PICTURE = svg('<title>t</title><circle cx="1" cy="2" r="3"/><path d="M1 2L3 4"/>')
TABLE = {"version": 1, "name": 'a <b> & "c" \u0007 ü', "balls": [{"position": [0.1, -0.0], "radius": 5e-324}]}


def test_a_kept_scene_comes_back_to_the_last_bit() -> None:
    kept = with_scene(PICTURE, TABLE)
    assert repr(kept_in(read_tree(kept.encode()))) == repr(TABLE)
    assert kept_in(read_tree(PICTURE.encode())) is None


def test_what_programs_write_around_it_changes_nothing() -> None:
    kept = with_scene(PICTURE, TABLE)
    saved = kept.replace("<title>", '<n:view xmlns:n="n" x="3"/><title>').replace("M1 2L3 4", "M1, 2L3  4")
    assert kept_in(read_tree(saved.replace('<path d="', '<path style="fill:none" d="').encode())) == TABLE


@pytest.mark.parametrize(
    ("before", "after"),
    [('r="3"', 'r="4"'), ("<path", '<path transform="scale(2)"'), ('<circle cx="1" cy="2" r="3"/>', "")],
)
def test_a_picture_that_was_changed_is_not_the_scene_any_more(before: str, after: str) -> None:
    changed = with_scene(PICTURE, TABLE).replace(before, after)
    with pytest.raises(carom.SceneError, match=r'<metadata id="carom-scene"> .*was changed since'):
        kept_in(read_tree(changed.encode()))


@pytest.mark.parametrize("text", ["{", "[1]", "[" * 100_000])
def test_a_broken_scene_in_a_picture_is_refused(text: str) -> None:
    kept = with_scene(PICTURE, TABLE)
    begin, end = kept.index("{"), kept.rindex("}") + 1
    with pytest.raises(carom.SceneError, match="is no scene: "):
        kept_in(read_tree((kept[:begin] + text + kept[end:]).encode()))
