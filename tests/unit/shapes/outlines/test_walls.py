"""From arcs on their way to shapes: units, tolerances, joined arcs, and radii that are not enormous."""

import itertools
from cmath import exp

import pytest

import carom
from carom import Arc, InvalidArgument, Segment, Shape
from carom.shapes.outlines.bow import Bow
from carom.shapes.outlines.walls import Frame, builder, frame_of, guarded, tolerance_in, walled


def test_a_frame_makes_the_largest_coordinate_one_at_most_and_rounds_nothing() -> None:
    frame = frame_of("points", [(3.0, -700.0), (0.1, 5.0)])
    inward = frame.inward((0.1, -700.0))
    assert 0.5 <= abs(inward.imag) < 1.0
    assert frame.outward(inward) == (0.1, -700.0)
    assert frame.length(0.5) == 512.0


@pytest.mark.parametrize("size", [1e300, 1e-300])
def test_places_that_cannot_be_reckoned_with_are_refused(size: float) -> None:
    with pytest.raises(InvalidArgument, match="points must have coordinates"):
        frame_of("points", [(size, 0.0)])
    assert frame_of("points", [(0.0, 0.0)]) == Frame(0)


def test_a_tolerance_has_a_least_value_by_size_and_by_place() -> None:
    frame = frame_of("points", [(1000.0, 0.0)])
    assert tolerance_in(frame, 1024.0, 1.0) == 1.0
    assert tolerance_in(frame, 1e9, 1.0) == 2.0
    with pytest.raises(InvalidArgument, match="tolerance must be at least"):
        tolerance_in(frame, 1e-9, 1.0)
    with pytest.raises(InvalidArgument, match=r"tolerance must be at least 1\.02e-09"):
        tolerance_in(frame, 5e-10, 1e-4)


def around(*angles: float) -> list[Bow]:
    """Arcs of the unit circle about the origin from angle to angle."""
    places = [exp(1j * angle) for angle in angles]
    return [Bow(a, 1j * a, 1.0, b, 1j * b) for a, b in itertools.pairwise(places)]


def test_arcs_of_one_circle_become_one() -> None:
    (arc,) = walled(around(0.0, 0.5, 1.0, 2.0), 1e-6, Frame(1), False, {})
    assert isinstance(arc, Arc)
    assert (arc.center, arc.radius) == (pytest.approx((0.0, 0.0), abs=1e-15), pytest.approx(2.0))
    assert arc.angles == pytest.approx((0.0, 2.0))


def test_an_arc_to_the_right_runs_the_other_way() -> None:
    ways = [Bow(bow.end, -bow.into, -1.0, bow.start, -bow.out) for bow in around(0.5, 1.5)]
    (arc,) = walled(ways, 1e-6, Frame(0), False, {})
    assert isinstance(arc, Arc)
    assert arc.angles == pytest.approx((0.5, 1.5))


def test_an_arc_of_more_than_half_a_turn_is_kept_so() -> None:
    (arc,) = walled([Bow(1 + 0j, 1j, 1.0, exp(5j), 1j * exp(5j))], 1e-6, Frame(0), False, {})
    assert isinstance(arc, Arc)
    assert arc.length == pytest.approx(5.0)


def test_in_place_of_an_enormous_arc_there_is_a_segment_between_two_smaller_ones() -> None:
    turn = 1e-7
    bow = Bow(0j, 1 + 0j, turn, (exp(1j * turn) - 1.0) / (1j * turn), exp(1j * turn))
    walls = walled([bow], 1e-3, Frame(0), True, {})
    assert [wall.kind for wall in walls] == ["arc", "segment", "arc", "point", "point"]
    first, middle, last = walls[:3]
    assert isinstance(first, Arc)
    assert isinstance(middle, Segment)
    assert isinstance(last, Arc)
    assert (first.radius, last.radius) == pytest.approx((1e4, 1e4))
    assert middle.length > 0.99


def test_what_turns_by_next_to_nothing_is_a_segment() -> None:
    (wall,) = walled([Bow(0j, 1 + 0j, 1e-11, 1 + 5e-12j, exp(1e-11j))], 1e-3, Frame(0), False, {})
    assert isinstance(wall, Segment)


def test_points_are_named_as_the_walls_are() -> None:
    walls: list[Shape] = [Segment((0, 0), (1, 0), name="a", user=3)]
    assert [(shape.kind, shape.name, shape.user) for shape in guarded(walls, True)] == [
        ("segment", "a", 3),
        ("point", "a", 3),
        ("point", "a", 3),
    ]
    assert guarded(walls, False) == walls


def test_a_builder_takes_the_options_of_shapes_and_no_others() -> None:
    @builder
    def made(length: float, **options: object) -> list[object]:
        return [length, options]

    assert made(1.0, kick=2.0) == [1.0, {"kick": 2.0}]
    with pytest.raises(carom.UnknownName, match=r"lenght is no argument of made.*did you mean length"):
        made(lenght=1.0)
