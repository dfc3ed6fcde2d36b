"""Points."""

from carom import Point


def test_a_point_is_where_it_was_put() -> None:
    point = Point((3, 4))
    assert (point.kind, point.position, point.closest_point((9, 9))) == ("point", (3.0, 4.0), (3.0, 4.0))
    assert point.distance((0, 0)) == 5.0
    assert tuple(point.aabb) == (3.0, 4.0, 3.0, 4.0)
    assert repr(point) == "Point((3.0, 4.0))"
