"""Shapes, balls and contacts draw themselves: what they are, where they touch, and their numbers."""

from math import atan2, cos, pi, sin
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.draw.alone import part_near, picture_alone
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


@given(st.floats(-8.0, 8.0), st.floats(0.3, 20.0), st.floats(0.0, 6.2), st.floats(0.1, 6.2))
def test_what_is_near_a_point_is_a_part_that_holds_it(x: float, radius: float, start: float, sweep: float) -> None:
    along = min(max(x, 0.0), 10.0)
    near = part_near(WALL, (along, 0.0), 1.5)
    assert isinstance(near, carom.Segment)
    assert near.p0[0] == pytest.approx(max(0.0, along - 1.5))
    assert near.p1[0] == pytest.approx(min(10.0, along + 1.5))
    arc = carom.Arc((1.0, 2.0), radius, start, start + sweep)
    angle = start + 0.4 * sweep
    point = (1.0 + radius * cos(angle), 2.0 + radius * sin(angle))
    part = part_near(arc, point, 1.5)
    assert isinstance(part, carom.Arc)
    assert part.distance(point) < 1e-6
    assert part.length <= min(arc.length, 3.0 if radius > 1.5 else arc.length) + 1e-6
    assert all(arc.distance(end) < 1e-6 for end in (part.p0, part.p1))
    whole = part_near(carom.Circle((1.0, 2.0), radius), point, 1.5)
    if radius > 1.5:
        assert isinstance(whole, carom.Arc)
        middle = 0.5 * (whole.start_angle + (whole.end_angle - whole.start_angle) % (2.0 * pi) + whole.start_angle)
        assert abs(atan2(sin(middle - angle), cos(middle - angle))) < 1e-6
