"""Lines and their four numbers."""

from math import inf

import pytest

from carom import InvalidArgument, Line


@pytest.mark.parametrize(
    ("line", "numbers"),
    [
        (Line((1, 2), 0.5), (0.5, 2.0, -3.0, 1.5)),
        (Line((1, 2), inf), (inf, 0.0, 1.0, inf)),
        (Line((1, 2), -inf), (inf, 0.0, 1.0, inf)),
        (Line((1, 2), 0.0), (0.0, inf, inf, 2.0)),
        (Line.through((1, 2), (1, -3)), (inf, 0.0, 1.0, inf)),
        (Line.through((5, 2), (-1, 2)), (0.0, inf, inf, 2.0)),
    ],
)
def test_the_four_numbers(line: Line, numbers: tuple[float, ...]) -> None:
    found = (line.gradient, line.inverse_gradient, line.x_intercept, line.y_intercept)
    assert found == pytest.approx(numbers)


def test_lines_meet_once_or_never() -> None:
    assert Line((0, 1), 2.0).intersection(Line((0, 4), -1.0)) == pytest.approx((1.0, 3.0))
    assert Line((2, 0), inf).intersection(Line((0, 1), 2.0)) == pytest.approx((2.0, 5.0))
    assert Line((0, 1), 2.0).intersection(Line((5, 5), 2.0)) is None
    assert Line((0, 0), inf).intersection(Line((1, 0), inf)) is None


def test_nothing_is_lost_near_the_vertical() -> None:
    steep = Line.through((1e-9, 0.0), (0.0, 1e9))
    assert steep.closest_point((1.0, 5e8)) == pytest.approx((5e-10, 5e8), rel=1e-9)
    assert steep.intersection(Line((0, 7), 0.0)) == pytest.approx((1e-9, 7.0))


def test_the_closest_point_is_square_to_the_line() -> None:
    assert Line((0, 0), 1.0).closest_point((4, 0)) == pytest.approx((2.0, 2.0))


def test_a_line_is_a_value_that_cannot_be_changed() -> None:
    line = Line((1, 2), 0.5)
    with pytest.raises(AttributeError, match="cannot be changed"):
        line.gradient = 3.0  # type: ignore[misc]
    assert repr(line) == "Line((1.0, 2.0), 0.5)"


def test_two_equal_points_make_no_line() -> None:
    with pytest.raises(InvalidArgument, match="second must differ from first"):
        Line.through((1, 2), (1, 2))
