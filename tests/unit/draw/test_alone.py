"""Shapes, balls and contacts draw themselves: what they are, where they touch, and their numbers."""

from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.draw.alone import picture_alone
from carom.draw.parts.layers import Layer
from tests.unit.draw.svg_marks import marks_of

WALL = carom.Segment((0, 0), (10, 0), elasticity=0.8, name="wall")
BLADE = carom.Segment((2, 3), (4, 3))
THINGS = {
    "Point": carom.Point((3.0, 1e6)),
    "wall": WALL,
    "Circle": carom.Circle((1, 2), 3.0, solid=True, kick=2.0),
    "Arc": carom.Arc((1, 2), 3.0, 0.5, 2.5),
    "Gate": carom.Gate((1, 2), (3, 2), direction=(0, 1)),
    "Ball": carom.Ball((1, 2), 0.5, velocity=(3, -2)),
    "oar": carom.Compound([BLADE, *carom.guard_points([BLADE])], pivot=(3, 3), name="oar"),
    "Group": carom.Group([carom.Point((1, 2)), carom.Circle((4, 2), 1.0)]),
}


def words(svg: str) -> list[str]:
    """The words of an SVG text, which must be whole."""
    return [text for text in ElementTree.fromstring(svg).itertext() if text.strip()]


@pytest.mark.parametrize("name", THINGS)
def test_a_thing_of_no_world_shows_itself_by_its_name_with_its_numbers(name: str) -> None:
    thing = THINGS[name]
    assert name in words(thing._repr_svg_())
    marks = marks_of(picture_alone(thing))
    assert len(marks["balls" if name == "Ball" else "shapes"]) >= 1


def test_numbers_stand_beside_it() -> None:
    assert {"radius", "0.5", "(1, 2)", "velocity", "(3, -2)", "mass"} <= set(words(THINGS["Ball"]._repr_svg_()))
    assert {"kick", "2", "radius", "3"} <= set(words(THINGS["Circle"]._repr_svg_()))
    assert {"parts", "3", "pivot", "(3, 3)"} <= set(words(THINGS["oar"]._repr_svg_()))
    assert "kick" not in words(WALL._repr_svg_())


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(1e-3, 1e3))
def test_any_shape_can_be_looked_at(x: float, y: float, size: float) -> None:
    for shape in (
        carom.Point((x, y)),
        carom.Segment((x, y), (x + size, y)),
        carom.Segment((x, y), (x, y - size)),
        carom.Circle((x, y), size),
        carom.Arc((x, y), size, 0.3, 2.0),
        carom.Ball((x, y), size),
    ):
        assert "nan" not in shape._repr_svg_()


def test_a_part_of_a_world_shows_itself_as_it_stands() -> None:
    world = carom.World(gravity=(0, -1))
    ball = world.add(carom.Ball((0, 0), 0.5, name="mine"))
    world.run(1.0)
    assert f"(0, {ball.position[1]:.4g})" in words(ball._repr_svg_())
    assert "mine" in words(ball._repr_svg_())


@pytest.mark.parametrize(
    ("met", "said"),
    [
        (WALL, "Ball, wall"),
        (carom.Arc((5, 3), 3.0, 3.5, 6.0), "Ball, Arc"),
        (carom.Circle((5, -1), 1.2, solid=True), "Ball, Circle"),
        (carom.Point((5, 0.1)), "Ball, Point"),
        (carom.Ball((5, -0.2), 0.5), "Ball, Ball"),
    ],
)
def test_a_contact_shows_what_met_where_it_touches_and_the_normal(met: carom.Shape | carom.Ball, said: str) -> None:
    contact = met.detect(carom.Ball((5, 0.4), 0.5, velocity=(3, -2)))
    assert contact is not None
    picture = picture_alone(contact)
    assert {"setback", f"{contact.setback:.4g}", "normal", "speed", "3.606"} <= set(words(contact._repr_svg_()))
    assert picture.panel.name == said
    marks = marks_of(picture)
    assert len(marks["normals"]) == 2, "a line and its head"
    assert len(marks["tangents"]) == 1
    assert len(marks["shapes"]) == 2
    assert Layer.BALLS not in picture.layers, "they would hide the normal"
    stage = picture.frame.stage
    for drawn in picture.still:
        box = drawn.shape.aabb
        assert stage.left <= box.left
        assert box.right <= stage.right
        assert stage.bottom <= box.bottom
        assert box.top <= stage.top
