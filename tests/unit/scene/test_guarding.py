"""Bare ends get their guard points, in the compound that they belong to or beside the shapes."""

import pytest

import carom
from tests.unit.scene.everything import flipper


def test_bare_ends_are_guarded_where_asked_for() -> None:
    corner = [carom.Segment((0, 0), (4, 0)), carom.Segment((0, 0), (0, 3), elasticity=0.5)]
    assert len(carom.Scene(shapes=corner).build().shapes) == 2
    world = carom.Scene(shapes=corner, guard=True).build()
    points = [shape.position for shape in world.shapes[2:]]
    assert points == [point.position for point in carom.guard_points(corner)] == [(0, 0), (4, 0), (0, 3)]


def test_a_compound_takes_its_guard_points_along() -> None:
    vane = carom.Compound([carom.Segment((1, 0), (3, 0))], (0, 0), turn_limits=(0, 2))
    vane.rotate((0, 0), 1.0)
    world = carom.Scene(shapes=[vane], guard=True).build()
    (guarded,) = world.shapes
    assert [part.kind for part in guarded.shapes] == ["segment", "point", "point"]
    assert guarded.orientation == 1.0
    guarded.rotate((0, 0), 2.0)
    edge, *points = guarded.shapes
    ends = sorted(point.position for point in points)
    assert ends == [pytest.approx(edge.p0, abs=1e-15), pytest.approx(edge.p1, abs=1e-15)]


def test_a_group_takes_its_guard_points_along() -> None:
    brick = carom.Group([carom.Segment((1, 0), (3, 0)), carom.Segment((3, 0), (3, 1))], name="brick", elasticity=0.5)
    world = carom.Scene(shapes=[brick], guard=True).build()
    (guarded,) = world.shapes
    assert [part.kind for part in guarded.shapes] == ["segment", "segment", "point", "point", "point"]
    assert {part.elasticity for part in guarded.shapes} == {0.5}
    world.remove(guarded)
    assert world._arrays.shapes.count == 0


def test_a_guarded_world_gives_a_scene_that_needs_no_guard() -> None:
    scene = carom.Scene(shapes=[flipper(), carom.Segment((0, 0), (4, 0))], guard=True)
    world = scene.build()
    twin = carom.Scene.from_world(world)
    assert not twin.guard
    assert twin.build().digest() == world.digest()


def test_guard_points_are_called_so_and_those_of_a_compound_go_by_its_name() -> None:
    wall = carom.Segment((5, 0), (9, 0), name="wall")
    world = carom.Scene(guard=True, shapes=(wall, flipper(name="flipper"))).build()
    names = [shape.name for shape in world.shapes if isinstance(shape, carom.Point)]
    assert names == ["guard point", "guard point"]
    (compound,) = [shape for shape in world.shapes if isinstance(shape, carom.Compound)]
    assert {part.name for part in compound.shapes if isinstance(part, carom.Point)} == {None}
