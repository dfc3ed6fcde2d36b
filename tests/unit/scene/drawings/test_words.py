"""What an SVG element says of itself."""

import pytest

from carom.scene.drawings.tree import read_tree
from carom.scene.drawings.words import is_pivot, said_by, world_of
from tests.drawings import svg


def element(text: str):
    """The first element in a drawing."""
    return read_tree(svg(text).encode()).children[0]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ('<g id="g1"/>', "g1"),
        ('<g id="g1" inkscape:label="wall"/>', "wall"),
        ('<g id="g1" inkscape:label="wall kick=3"/>', "wall"),
        ('<g id="g1" inkscape:label="kick=3"/>', "g1"),
        ('<g id="g1" inkscape:label="wall" data-carom-name="floor"/>', "floor"),
        ("<g/>", None),
    ],
)
def test_attributes_name_before_labels_and_labels_before_ids(text: str, name: str | None) -> None:
    assert said_by(element(text)).name == name


def test_attributes_overrule_labels_and_are_known_by_the_way_they_are_written() -> None:
    said = said_by(element('<g inkscape:label="a kick=3 sensor=true" data-carom-kick="4" data-carom-pivot="1 2"/>'))
    assert said.options == {"kick": 4.0, "sensor": True, "pivot": (1.0, 2.0)}
    assert said.written == {"kick": "data-carom-kick", "sensor": "label sensor", "pivot": "data-carom-pivot"}
    assert said.handed_down() == {"kick": 4.0, "sensor": True}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('<g inkscape:label="a kik=3"/>', "label kik: is unknown; did you mean kick?"),
        ('<g data-carom-kick="x"/>', "data-carom-kick: must be a number, not 'x'"),
        ('<g data-carm-kick="1"/>', "data-carm-kick: is unknown; did you mean data-carom-kick?"),
        ('<g carom-ball=""/>', "carom-ball: is unknown; did you mean data-carom-ball?"),
        ('<g data-Carom_kick="1"/>', "data-Carom_kick: is unknown; did you mean data-carom-kick?"),
    ],
)
def test_what_is_wrong_begins_with_where_it_is_written(text: str, said: str) -> None:
    with pytest.raises(ValueError) as caught:
        said_by(element(text))
    assert str(caught.value) == said


def test_attributes_that_are_not_for_carom_are_passed_over() -> None:
    assert (
        said_by(element('<g data-name="a" data-carousel-mass="3" color-rendering="auto" clip-path="x"/>')).options == {}
    )


def test_a_circle_may_mark_a_pivot() -> None:
    assert is_pivot(element('<circle r="1" inkscape:label="pivot"/>'))
    assert is_pivot(element('<circle r="1" data-carom-pivot=""/>'))
    assert not is_pivot(element('<circle r="1" data-carom-pivot="1 2"/>'))
    assert not is_pivot(element('<rect inkscape:label="pivot"/>'))


def test_the_root_speaks_of_the_world() -> None:
    root = read_tree(svg("<title> a\ntable </title>", 'data-carom-gravity="0 -1" data-carom-kick="1"').encode())
    assert world_of(root) == (
        {"name": "a table", "gravity": (0.0, -1.0)},
        [world_of(root)[1][0]],
    )
    assert world_of(root)[1][0].startswith("data-carom-kick: is unknown; ")
    slip = read_tree(svg("", 'carom-gravity="0 -1"').encode())
    assert world_of(slip) == ({}, ["carom-gravity: is unknown; did you mean data-carom-gravity?"])
