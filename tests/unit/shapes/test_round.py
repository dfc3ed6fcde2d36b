"""What is round: its inside, and the tangents of circles, arcs and balls alike."""

import pytest

from carom import Arc, Ball, Circle, InvalidArgument


def test_the_inside_is_strict() -> None:
    assert Circle((0, 0), 5).contains((3, 3.9))
    assert not Circle((0, 0), 5).contains((3, 4))


def test_tangents_touch_all_that_is_round() -> None:
    circle = Circle((0, 0), 3)
    assert circle.tangent_points((5, 0)) is not None
    assert circle.tangent_points((1, 0)) is None
    assert circle.tangent_points((3, 0)) == ((3.0, 0.0), (3.0, 0.0))
    for other in (Circle((9, 0), 3), Ball((9, 0), 3), Arc((9, 0), 3, 0, 1)):
        upper = circle.common_tangent(other)
        assert upper is not None
        assert (upper.p0, upper.p1) == ((0.0, 3.0), (9.0, 3.0))
    assert circle.common_tangents(Circle((1, 0), 1)) is None
    assert circle.common_tangents(Circle((2, 0), 1)) is None


@pytest.mark.parametrize(
    "shape", [Circle((1, 2), 3), Arc((1, 2), 3, 0, 1), Ball((1, 2), 3)], ids=lambda shape: shape.kind
)
def test_a_centre_is_the_position_and_both_it_and_the_radius_can_be_set(shape: Circle | Arc | Ball) -> None:
    shape.center = (4, 6)
    assert shape.position == shape.center == (4.0, 6.0)
    shape.radius = 0.5
    assert (shape.radius, shape.contains((4.4, 6)), shape.contains((4.5, 6))) == (0.5, True, False)
    with pytest.raises(InvalidArgument, match="radius must be positive, not 0"):
        shape.radius = 0
    assert shape.radius == 0.5
