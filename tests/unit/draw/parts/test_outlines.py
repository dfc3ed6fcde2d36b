"""How each kind of shape is drawn: its outline, its sign, and where marks stand at it."""

import re
from math import atan2, cos, hypot, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.draw.page.painter import PagePainter
from carom.draw.paint.painter import Style
from carom.draw.parts.frame import Frame
from carom.draw.parts.looks import MOVING
from carom.draw.parts.outlines import (
    GLOW,
    anchor,
    ends_of,
    glow_mark,
    has_sector,
    middle_of,
    part_near,
    sector_mark,
    shape_mark,
    tangents_of,
)
from carom.draw.picture import open_way
from carom.shapes.aabb import Aabb
from tests.unit.draw.svg_marks import SVG, layer, root_of
from tests.worlds import world_of


def test_round_things_are_round() -> None:
    root = root_of(world_of(carom.Arc((0, 0), 2, 0.5, 2.0), carom.Circle((0, 0), 3), carom.Segment((0, 0), (1, 1))))
    shapes = layer(root, "shapes")
    assert len(shapes.findall(f".//{SVG}circle")) == 1
    paths = [path.get("d") for path in shapes.iter(f"{SVG}path")]
    assert len([path for path in paths if re.fullmatch(r"M\S+ \S+A\S+ \S+ 0 0 0 \S+ \S+", path)]) == 1
    assert shapes.findall(f".//{SVG}polyline") == []


def test_a_compound_is_drawn_part_by_part_with_one_pivot() -> None:
    parts = [carom.Segment((0, 0), (2, 0)), carom.Segment((0, 1), (2, 1))]
    shapes = layer(root_of(world_of(carom.Compound(parts, pivot=(0, 0.5)))), "shapes")
    assert len(shapes.findall(f".//{SVG}path")) == 2
    assert len(shapes.findall(f".//{SVG}circle")) == 1


def test_a_gate_has_an_arrow() -> None:
    shapes = layer(root_of(world_of(carom.Gate((0, 0), (1, 0)))), "shapes")
    assert len(shapes.findall(f".//{SVG}polygon")) == 1


@pytest.mark.parametrize(("direction", "way"), [((5, 0.1), (0, 1)), ((5, -0.1), (0, -1)), (None, (0, 1))])
def test_an_arrow_stands_square_to_its_gate(direction: tuple[float, float] | None, way: tuple[float, float]) -> None:
    assert open_way(carom.Gate((0, 0), (1, 0), direction=direction)) == way


def sample(kind: str) -> carom.Shape:
    """A shape of a kind."""
    shapes: dict[str, carom.Shape] = {
        "point": carom.Point((1, 2)),
        "segment": carom.Segment((1, 2), (4, 6)),
        "gate": carom.Gate((1, 2), (4, 6)),
        "circle": carom.Circle((1, 2), 3),
        "arc": carom.Arc((1, 2), 3, 0.5, 2.0),
    }
    return shapes[kind]


KINDS = pytest.mark.parametrize("kind", ["point", "segment", "gate", "circle", "arc"])


@KINDS
def test_marks_stand_on_the_outline_square_to_it(kind: str) -> None:
    shape = sample(kind)
    middle = middle_of(shape)
    assert (middle is None) == (kind == "point")
    if middle is not None:
        place, (nx, ny) = middle
        assert shape.distance(place) == pytest.approx(0.0, abs=1e-12)
        assert hypot(nx, ny) == pytest.approx(1.0)
        # A step along the normal is a step away.
        assert shape.distance((place[0] + 0.1 * nx, place[1] + 0.1 * ny)) == pytest.approx(0.1)
    if isinstance(shape, carom.Circle):
        assert middle == ((1.0, 5.0), (0.0, 1.0))
    for place, (tx, ty) in tangents_of(shape):
        assert shape.distance(place) == pytest.approx(0.0, abs=1e-12)
        assert shape.distance((place[0] + 1e-4 * tx, place[1] + 1e-4 * ty)) <= 1.01e-4
        if kind != "circle":  # out of the shape, past its end
            assert shape.distance((place[0] + 0.1 * tx, place[1] + 0.1 * ty)) == pytest.approx(0.1)
    assert len(tangents_of(shape)) == (0 if kind == "point" else 2)


@KINDS
def test_a_name_stands_at_the_middle_and_inside_of_what_is_solid(kind: str) -> None:
    assert sample(kind).distance(anchor(sample(kind))) == pytest.approx(0.0, abs=1e-12)
    assert anchor(carom.Circle((1, 2), 3, solid=True)) == (1.0, 2.0)


@KINDS
def test_ends_are_those_of_lines_and_a_sector_that_of_an_arc(kind: str) -> None:
    shape = sample(kind)
    ends = ends_of([shape])
    assert len(ends) == (2 if kind in ("segment", "gate", "arc") else 0)
    assert all(shape.distance(end) < 1e-5 for end in ends)
    assert has_sector(shape) == (kind == "arc")


@KINDS
def test_every_kind_is_drawn_in_its_look_and_glows(kind: str) -> None:
    frame, painter = Frame.around(Aabb(0.0, 0.0, 9.0, 9.0), 0.0), PagePainter()
    painter.layer("shape")
    shape_mark(painter, frame, sample(kind), MOVING, 2.0)
    painter.layer("glow")
    glow_mark(painter, frame, sample(kind), 0.5, 1.0)
    calls = {"point": "circle", "segment": "segment", "gate": "segment", "circle": "circle", "arc": "arc"}
    assert [call[0] for call in painter.layers["shape"]] == [calls[kind]]
    assert [call[0] for call in painter.layers["glow"]] == [calls[kind]] * len(GLOW)
    styles = [painter.styles[call[1]] for call in painter.layers["glow"]]
    assert [style.opacity for style in styles if isinstance(style, Style)] == [0.5 * opacity for _, opacity in GLOW]


@pytest.mark.parametrize(("weight", "wide"), [(0.25, 0.6), (2.0, 2.0)])
def test_what_a_point_is_drawn_as_grows_with_the_lines(weight: float, wide: float) -> None:
    frame, painter = Frame.around(Aabb(0.0, 0.0, 9.0, 9.0), 0.0), PagePainter()
    painter.layer("all")
    shape_mark(painter, frame, sample("point"), MOVING, weight)
    glow_mark(painter, frame, sample("point"), 1.0, weight)
    radii = [frame.scale * call[2][2] for call in painter.layers["all"]]
    assert radii == pytest.approx([MOVING.dot * weight, *[0.5 * wide * width for width, _ in GLOW]])


def test_a_sector_is_an_arcs_area_between_its_radii() -> None:
    painter, arc = PagePainter(), carom.Arc((1, 2), 3, 0.5, 2.0)
    sector_mark(painter, arc)
    area, *radii = painter.layers[""]
    assert [call[2] for call in radii] == [[1.0, 2.0, *arc.p0], [1.0, 2.0, *arc.p1]]
    corners = list(zip(area[2][::2], area[2][1::2], strict=True))
    assert corners[0] == (1.0, 2.0)
    assert [corners[1], corners[-1]] == [pytest.approx(arc.p0), pytest.approx(arc.p1)]
    assert all(arc.distance(corner) == pytest.approx(0.0, abs=1e-12) for corner in corners[1:])
    sector_mark(painter, carom.Circle((1, 2), 3))
    assert len(painter.layers[""]) == 3


@given(st.floats(-8.0, 8.0), st.floats(0.3, 20.0), st.floats(0.0, 6.2), st.floats(0.1, 6.2))
def test_what_is_near_a_point_is_a_part_that_holds_it(x: float, radius: float, start: float, sweep: float) -> None:
    wall = carom.Segment((0, 0), (10, 0))
    along = min(max(x, 0.0), 10.0)
    near = part_near(wall, (along, 0.0), 1.5)
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
