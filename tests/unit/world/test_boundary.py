"""Hits as places along an outline and directions: Birkhoff's coordinates."""

from math import asin, cos, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

import carom


def run_in(*shapes: Any, velocity: Any = (1.0, 0.7), position: Any = (0.1, 0.2), seconds: float = 60.0) -> carom.Hits:
    """The hits of a small ball among shapes."""
    world = carom.World(detection="continuous")
    world.add(*shapes)
    world.add(carom.Ball(position, 1e-3, velocity=velocity))
    return world.run(seconds)


def square() -> list[carom.Segment]:
    """The sides of a square of side 2, counterclockwise from the lower left corner."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [carom.Segment(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]


def stadium() -> list[carom.Shape]:
    """Two straights and two half circles, counterclockwise from the lower left."""
    return [
        carom.Segment((-1, -1), (1, -1)),
        carom.Arc((1, 0), 1, -pi / 2, pi / 2),
        carom.Segment((1, 1), (-1, 1)),
        carom.Arc((-1, 0), 1, pi / 2, 3 * pi / 2),
    ]


def naive(hit: Any, outline: list[Any], forward: list[bool]) -> tuple[float, float]:
    """The place along an outline and the sine of one hit."""
    before = 0.0
    for shape, ahead in zip(outline, forward, strict=True):
        if shape is hit.shape:
            along = shape.parameter(hit.point)
            if isinstance(shape, carom.Segment):
                tangent = shape.t0
            else:
                dx, dy = hit.point[0] - shape.center[0], hit.point[1] - shape.center[1]
                tangent = (-dy / shape.radius, dx / shape.radius)
            sign = 1 if ahead else -1
            speed = sqrt(hit.velocity[0] ** 2 + hit.velocity[1] ** 2)
            sine = sign * (hit.velocity[0] * tangent[0] + hit.velocity[1] * tangent[1]) / speed
            return before + (along if ahead else shape.length - along), sine
        before += shape.length
    raise AssertionError("not on the outline")


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(("make", "ways"), [(square, [1, 1, 0, 0]), (stadium, [1, 1, 0, 1])])
def test_the_arrays_are_what_each_hit_says_by_itself(make: Any, ways: list[int], turned: bool) -> None:
    outline = make()
    hits = run_in(*outline)
    forward = [bool(way) for way in ways]
    if turned:
        outline, forward = outline[::-1], [not way for way in forward[::-1]]
    found, arc_length, sine = hits.boundary(outline)
    assert len(found) == len(hits) > 20
    expected = [naive(hit, outline, forward) for hit in hits]
    assert np.stack([arc_length, sine], axis=1) == pytest.approx(np.array(expected), abs=1e-12)
    assert len({hit.shape for hit in hits}) == 4


def test_an_outline_is_gone_along_in_its_order_from_one_joint_to_the_next() -> None:
    for outline in (stadium(), stadium()[::-1], [*stadium()[2:], *stadium()[:2]]):
        hits = run_in(*outline, velocity=(0.31, 0.9))
        _, arc_length, _ = hits.boundary(outline)
        # Near places have near arc lengths, over the joints too: half the step along is at least the step across.
        order = np.argsort(arc_length)
        way = np.linalg.norm(np.diff(hits["point"][order], axis=0), axis=1)
        assert (way <= np.diff(arc_length[order]) + 1e-9).all()


def test_in_a_circle_the_sine_stays_and_the_place_goes_on_by_the_same_angle() -> None:
    room = carom.Circle((2, 1), 3.0)
    hits = run_in(room, position=(2.5, 1.5), velocity=(1, 0.4), seconds=200.0)
    _, arc_length, sine = hits.boundary([room])
    assert len(hits) > 20
    assert sine == pytest.approx(sine[0], abs=1e-9)
    steps = np.mod(np.diff(arc_length), room.length)
    # A chord with the angle of incidence a turns by pi - 2 a, in the outline's direction or against it.
    turn = pi - 2 * asin(abs(sine[0]))
    forward = turn if sine[0] > 0 else 2 * pi - turn
    assert steps == pytest.approx(np.full(len(steps), 3.0 * forward), abs=0.02)


def test_a_straight_hit_has_no_sine_and_a_slanted_one_its_sign() -> None:
    for velocity, expected in (((0.0, -1.0), 0.0), ((0.6, -0.8), 0.6), ((-0.6, -0.8), -0.6)):
        outline = square()
        hit, arc_length, sine = run_in(*outline, position=(0, 0), velocity=velocity, seconds=1.3).boundary(outline)
        assert sine.tolist() == pytest.approx([expected])
        assert arc_length.tolist() == pytest.approx([1.0 + 0.999 / 0.8 * velocity[0] if velocity[0] else 1.0], abs=1e-3)
        assert len(hit) == 1


def test_hits_elsewhere_are_left_out_and_those_of_sensors_count_once() -> None:
    sides, bumper = square(), carom.Circle((0.5, 0.5), 0.2)
    line = carom.Segment((-1, 0), (1, 0), sensor=True)
    hits = run_in(*sides, bumper, line)
    on_walls = hits.boundary(sides).hits
    assert 0 < len(on_walls) < len(hits)
    assert {hit.shape for hit in on_walls} <= set(sides)
    section = hits.boundary([line])
    assert {hit.kind for hit in section.hits} == {carom.HitKind.ENTER}
    assert section.arc_length == pytest.approx(section.hits["position"][:, 0] + 1.0, abs=1e-9)
    assert len(hits[:0].boundary(sides).arc_length) == 0


def test_arcs_over_angle_zero_and_their_ends_have_their_places() -> None:
    bend = carom.Arc((0, 0), 1.0, -1.0, 1.0)
    world = carom.World(detection="continuous")
    world.add(bend)
    angles = [-0.999, -0.5, 0.0, 0.5, 0.999]
    for angle in angles:
        world.add(carom.Ball((0, 0), 1e-4, velocity=(cos(angle), sin(angle)), collides_with=2))
    bend.layer = 2
    hits = world.run(1.0)
    order = np.argsort(hits["ball"])
    assert hits.boundary([bend]).arc_length[order] == pytest.approx([1.0 + angle for angle in angles])


@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda sides: [], "outline must be a list of shapes that join"),
        (lambda sides: 7, "outline must be a list of shapes that join"),
        (
            lambda sides: [sides[0], sides[2]],
            r"outline\[1\] must begin or end where outline\[0\] ends, at \(1.0, -1.0\)",
        ),
        (
            lambda sides: [sides[0], carom.Segment((1, -1), (2, 2))],
            r"outline\[1\] must be a Segment, an Arc or a Circle",
        ),
        (
            lambda sides: [sides[0].world.add(carom.Point((0, 0)))],
            r"outline\[0\] must be a Segment, an Arc or a Circle",
        ),
        (lambda sides: [sides[0], sides[1], sides[0]], r"outline\[2\] must not be in it twice"),
        (lambda sides: [*sides, sides[0].world.add(carom.Circle((9, 9), 1))], r"outline\[4\] must be the only one"),
    ],
)
def test_what_is_no_outline_is_refused(spoil: Any, told: str) -> None:
    sides = square()
    hits = run_in(*sides, seconds=3.0)
    with pytest.raises(carom.InvalidArgument, match=told):
        hits.boundary(spoil(sides))
