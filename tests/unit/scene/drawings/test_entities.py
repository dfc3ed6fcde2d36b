"""DXF entities as pieces, against ezdxf's own curves."""

from math import hypot, isclose, pi
from typing import Any

import ezdxf
import pytest

from carom.scene.drawings.entities import DRAWS, disc, discs_of, outlines_of
from carom.scene.drawings.pieces import Conic, Course, Cubic, Straight
from tests import clock


@pytest.fixture(scope="module")
def space() -> Any:
    """A model space to draw in."""
    return ezdxf.new("R2010").modelspace()


def near(one: Any, other: Any, within: float = 1e-9) -> bool:
    """Whether two places are one."""
    return hypot(one[0] - other[0], one[1] - other[1]) <= within


def test_lines_circles_and_arcs(space: Any) -> None:
    assert outlines_of(space.add_line((0, 1), (2, 3))) == [[Straight((0.0, 1.0), (2.0, 3.0))]]
    assert outlines_of(space.add_circle((0, 1), 2)) == [[Conic((0.0, 1.0), (2.0, 0.0), (0.0, 2.0))]]
    ((arc,),) = outlines_of(space.add_arc((0, 1), 2, 350, 80))
    assert isclose(arc.sweep, 0.5 * pi)
    ((mirrored,),) = outlines_of(space.add_arc((3, 1), 2, 0, 90, dxfattribs={"extrusion": (0, 0, -1)}))
    assert near(mirrored.start, (-5.0, 1.0))
    assert near(mirrored.end, (-3.0, 3.0))


def test_bulges_are_arcs(space: Any) -> None:
    entity = space.add_lwpolyline([(0, 0, 1.0), (2, 0, 0.0), (2, 5, 0.0)], format="xyb", close=True)
    ((arc, up, back),) = outlines_of(entity)
    assert near(arc.at(arc.begin + 0.5 * arc.sweep), (1.0, -1.0))
    assert (up, back) == (Straight((2.0, 0.0), (2.0, 5.0)), Straight((2.0, 5.0), (0.0, 0.0)))
    old = space.add_polyline2d([(0, 0, 1.0), (2, 0, 0.0), (2, 5, 0.0)], format="xyb", close=True)
    assert outlines_of(old) == [[arc, up, back]]
    assert all(type(x) is float for piece in (arc, up) for point in piece.points() for x in point)


def test_ellipses(space: Any) -> None:
    entity = space.add_ellipse((1, 2), major_axis=(3, 1), ratio=0.4, start_param=0.5, end_param=4.0)
    ((piece,),) = outlines_of(entity)
    tool = entity.construction_tool()
    for share in (0.0, 0.3, 1.0):
        (there,) = tool.vertices([0.5 + 3.5 * share])
        assert near(piece.at(piece.begin + share * piece.sweep), there)


@pytest.mark.parametrize(
    ("degree", "weights"), [(1, None), (2, None), (3, None), (4, None), (2, [1, 2, 1, 3, 1, 1, 2])]
)
def test_splines_are_followed_exactly(space: Any, degree: int, weights: list[float] | None) -> None:
    points = [(0, 0), (1, 3), (3, 4), (5, 0), (7, 2), (8, 5), (9, 1)]
    if weights is None:
        entity = space.add_open_spline(points, degree=degree)
    else:
        entity = space.add_rational_spline(points, weights, degree=degree)
    ((pieces),) = outlines_of(entity)
    tool = entity.construction_tool()
    there = list(tool.points([k / 3000.0 * tool.max_t for k in range(3001)]))
    for piece in pieces:
        places = piece.points() if not isinstance(piece, Cubic) else [piece.start, piece.end]
        for place in places:
            assert min(hypot(p.x - place[0], p.y - place[1]) for p in there) < 0.02
    assert near(pieces[0].start, points[0])
    assert near(pieces[-1].end, points[-1])
    assert {type(piece) for piece in pieces} <= ({Straight, Cubic} if degree <= 3 and weights is None else {Course})


def test_a_spline_that_is_not_clamped_is_followed_where_all_its_points_count(space: Any) -> None:
    points = [(0.0, 0.0), (6.0, 3.0), (12.0, -3.0), (18.0, 9.0), (24.0, 0.0)]
    entity = space.add_spline(dxfattribs={"degree": 3})
    entity.control_points, entity.knots = points, list(range(9))
    (pieces,) = outlines_of(entity)
    # A uniform cubic spline begins each stretch at a sixth of its first, four of its second and one of its third point.
    joints = [tuple((a + 4.0 * b + c) / 6.0 for a, b, c in zip(*points[k : k + 3], strict=True)) for k in range(3)]
    assert len(pieces) == 2
    for piece, begin, end in zip(pieces, joints, joints[1:], strict=False):
        assert near(piece.start, begin)
        assert near(piece.end, end)


def test_a_stretch_of_a_long_spline_is_followed_as_quickly_as_one_of_a_short_one(space: Any) -> None:
    ((short,),) = [outlines_of(space.add_open_spline([(k, k * k % 7) for k in range(12)], degree=5))]
    entity = space.add_open_spline([(k, k * k % 7) for k in range(6000)], degree=5)
    with clock.soon():
        ((long,),) = [outlines_of(entity)]
        places = [place for piece in long[-400:] for place in piece.points()]
    assert len(long) == 5995
    assert near(short[0].at(0.5), long[0].at(0.5))
    assert near(places[0], long[-400].start)


def test_points_are_places_and_meshes_are_none(space: Any) -> None:
    assert outlines_of(space.add_point((1, 2)))[0][0].center == (1.0, 2.0)
    assert outlines_of(space.add_polyface()) is None
    assert "TEXT" not in DRAWS


def test_hatches_fill_circles(space: Any) -> None:
    hatch = space.add_hatch()
    hatch.paths.add_edge_path().add_arc((3, 4), 2, 0, 360)
    hatch.paths.add_polyline_path([(1, 0, 1), (-1, 0, 1)], is_closed=True)
    hatch.paths.add_polyline_path([(1, 0), (-1, 0), (0, 4)], is_closed=True)
    circles = [outlines_of(space.add_circle((3, 4), 2))[0][0], outlines_of(space.add_circle((0, 0), 1))[0][0]]
    assert discs_of(hatch) == [disc(circle) for circle in circles]
