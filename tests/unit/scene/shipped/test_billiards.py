"""The billiards are the rooms of the textbooks, and their balls start almost alike and meet nothing but the walls."""

import re
from collections.abc import Callable
from functools import partial
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin
from typing import Any

import pytest

import carom
from carom.scene.shipped import billiards
from carom.scene.shipped.billiards import BALLS, SPEED, SPREAD, sinai, stadium
from carom.shapes.shape import Shape
from tests.worlds import BILLIARDS, SMALL

MAKERS = [getattr(billiards, name) for name in BILLIARDS]
ALL = pytest.mark.parametrize("make", [partial(make, **SMALL.get(make.__name__, {})) for make in MAKERS], ids=BILLIARDS)


def shapes_of(scene: carom.Scene) -> list[Shape]:
    """The shapes of a scene's world, without the points that guard their ends."""
    return [shape for shape in scene.build().shapes if isinstance(shape, Shape) and not isinstance(shape, carom.Point)]


@ALL
def test_balls_start_in_one_place_in_almost_one_direction(make: Callable[[], carom.Scene]) -> None:
    balls = make().balls
    assert len(balls) == BALLS
    assert len({ball.position for ball in balls}) == 1
    speeds = [hypot(*ball.velocity) for ball in balls]
    assert speeds == pytest.approx([SPEED if make().name != "wedge" else speeds[0]] * BALLS, rel=1e-15)
    directions = [atan2(ball.velocity[1], ball.velocity[0]) for ball in balls]
    assert [later - earlier for earlier, later in pairwise(directions)] == pytest.approx([SPREAD] * (BALLS - 1))


@ALL
def test_balls_meet_walls_and_not_each_other_and_lose_nothing(make: Callable[[], carom.Scene]) -> None:
    world = make().build()
    for ball in world.balls:
        assert not any(ball.layer & other.collides_with for other in world.balls)
        for shape in world.shapes:
            assert ball.layer & shape.collides_with
            assert shape.layer & ball.collides_with
    assert {member.elasticity for member in (*shapes_of(make()), *world.balls)} == {1.0}


def test_the_stadium_is_what_lies_within_two_of_a_segment() -> None:
    walls = shapes_of(stadium())
    around = [(x, side * 2.0) for x in (-2.0, -0.5, 1.0, 2.0) for side in (-1.0, 1.0)]
    for step in range(20):
        angle = pi * (step / 19.0 - 0.5)
        around += [(side * (2.0 + 2.0 * cos(angle)), 2.0 * sin(angle)) for side in (-1.0, 1.0)]
    for place in around:
        assert min(wall.distance(place) for wall in walls) < 1e-12, place
    for x in (-2.0, -1.0, 0.0, 2.0):
        assert min(wall.distance((x, 0.0)) for wall in walls) == pytest.approx(2.0)


def test_sinais_room_is_a_square_round_a_solid_disc() -> None:
    *walls, disc = shapes_of(sinai())
    assert isinstance(disc, carom.Circle)
    assert (disc.center, disc.radius, disc.solid) == ((0.0, 0.0), 1.0, True)
    for along in (-2.0, -0.7, 0.0, 1.9):
        for place in ((along, -2.0), (along, 2.0), (-2.0, along), (2.0, along)):
            assert min(wall.distance(place) for wall in walls) == 0.0, place
    assert len(walls) == 4


def test_the_stadiums_joints_are_tangent() -> None:
    assert carom.guard_points([shape.build() for shape in stadium().shapes]) == []
    assert len(stadium().build().shapes) == len(stadium().shapes)


# -- what the tables are ---------------------------------------------------------------------------------------------


def distance_to_walls(scene: carom.Scene, place: tuple[float, float]) -> float:
    """How far a place is from the nearest wall of a scene."""
    return min(wall.distance(place) for wall in shapes_of(scene))


def turned(radius: float, count: int = 13) -> list[tuple[float, float]]:
    """Places on a circle round the origin."""
    return [(radius * cos(0.1 + 0.5 * k), radius * sin(0.1 + 0.5 * k)) for k in range(count)]


@pytest.mark.parametrize(("width", "height"), [(6.0, 4.0), (2.0, 5.0), (3.0, 3.0)])
def test_the_ellipse_is_one_to_its_tolerance_and_smooth(width: float, height: float) -> None:
    scene = billiards.ellipse(width, height, tolerance=1e-5)
    a, b = 0.5 * width, 0.5 * height
    arcs = shapes_of(scene)
    for arc in arcs:
        assert isinstance(arc, carom.Arc)
        begin, end = arc.angles
        for share in (0.0, 0.25, 0.5, 0.75, 1.0):
            angle = begin + share * ((end - begin) % (2.0 * pi))
            x, y = arc.center[0] + arc.radius * cos(angle), arc.center[1] + arc.radius * sin(angle)
            slope = 2.0 * hypot(x / (a * a), y / (b * b))
            assert abs((x / a) ** 2 + (y / b) ** 2 - 1.0) / slope < 1e-5 * max(width, height)
    assert carom.guard_points(arcs) == []
    assert sum(arc.length for arc in arcs) == pytest.approx(circumference(a, b), rel=1e-5)


def circumference(a: float, b: float) -> float:
    """That of an ellipse, by the sum over many equal steps of its angle, which is exact for what is periodic."""
    angles = [2.0 * pi * k / 2000 for k in range(2000)]
    return 2.0 * pi * sum(hypot(a * sin(t), b * cos(t)) for t in angles) / 2000


@pytest.mark.slow
def test_the_shipped_ellipse_is_one_to_a_billionth() -> None:
    arcs = shapes_of(billiards.ellipse())
    worst = 0.0
    for arc in arcs:
        assert isinstance(arc, carom.Arc)
        begin, end = arc.angles
        for share in (0.2, 0.5, 0.8):
            angle = begin + share * ((end - begin) % (2.0 * pi))
            x, y = arc.center[0] + arc.radius * cos(angle), arc.center[1] + arc.radius * sin(angle)
            worst = max(worst, abs((x / 3.0) ** 2 + (y / 2.0) ** 2 - 1.0) / (2.0 * hypot(x / 9.0, y / 4.0)))
    assert 1e-10 < worst < 6e-9  # a billionth of six, the greater axis


def test_an_annulus_has_a_disc_aside() -> None:
    for x, y in turned(1.0):
        assert distance_to_walls(billiards.annulus(3.0, 1.0, 0.5), (3.0 * x, 3.0 * y)) < 1e-12
        assert distance_to_walls(billiards.annulus(3.0, 1.0, 0.5), (x + 0.5, y)) < 1e-12


def test_a_lemon_is_what_two_discs_have_in_common() -> None:
    scene = billiards.lemon(radius=2.0, distance=1.0)
    tip = (4.0 - 0.25) ** 0.5
    for place in ((1.5, 0.0), (-1.5, 0.0), (0.0, tip), (0.0, -tip)):
        assert distance_to_walls(scene, place) < 1e-12
    assert distance_to_walls(scene, (0.0, tip + 0.1)) > 0.05


@pytest.mark.parametrize("petals", [3, 5, 8])
def test_a_flower_is_the_outline_of_its_discs(petals: int) -> None:
    scene = billiards.flower(petals, radius=1.0, distance=1.1)
    centers = [(1.1 * cos(2.0 * pi * k / petals), 1.1 * sin(2.0 * pi * k / petals)) for k in range(petals)]
    walls = shapes_of(scene)
    assert len(walls) == petals
    for wall in walls:
        assert isinstance(wall, carom.Arc)
        nearest = [min(hypot(end[0] - x, end[1] - y) for x, y in centers) for end in (wall.p0, wall.p1)]
        assert nearest == pytest.approx([1.0, 1.0], rel=1e-12)  # no end lies within a disc
    ends = [end for wall in walls if isinstance(wall, carom.Arc) for end in (wall.p0, wall.p1)]
    assert all(sum(hypot(a[0] - b[0], a[1] - b[1]) < 1e-12 for b in ends) == 2 for a in ends)


def test_a_mushroom_is_a_half_disc_on_a_stem() -> None:
    scene = billiards.mushroom(radius=2.0, width=1.0, height=1.5)
    on = [(0.0, 2.0), (2.0, 0.0), (1.0, 0.0), (0.5, -1.0), (-0.5, -1.5), (0.0, -1.5), (-1.2, 0.0)]
    assert max(distance_to_walls(scene, place) for place in on) < 1e-12
    assert distance_to_walls(scene, (0.0, 0.0)) == pytest.approx(0.5)


def test_a_wedge_leans_by_its_angle_and_holds_its_balls() -> None:
    scene = billiards.wedge(angle=0.6, height=3.0)
    assert scene.world.gravity == (0.0, -billiards.GRAVITY)
    for y in (0.5, 1.0, 2.9):
        assert distance_to_walls(scene, (y * sin(0.6) / cos(0.6), y)) < 1e-12
    for ball in scene.balls:
        rise = hypot(*ball.velocity) ** 2 / (2.0 * billiards.GRAVITY)
        assert ball.position[1] + rise < 0.6 * 3.0


def test_a_cell_of_the_lorentz_gas_is_that_of_a_triangular_lattice() -> None:
    scene = billiards.lorentz(radius=0.8, gap=0.2)
    arcs = [wall for wall in shapes_of(scene) if isinstance(wall, carom.Arc)]
    first, second = (arc.center for arc in arcs)
    # Neighbours of a triangular lattice are one diameter and one gap apart; the mirrors give the other four.
    assert hypot(second[0] - first[0], second[1] - first[1]) == pytest.approx(1.8)
    assert abs(second[0] - first[0]) == pytest.approx(0.9)
    assert [arc.radius for arc in arcs] == [0.8, 0.8]
    assert sum(arc.length for arc in arcs) == pytest.approx(0.8 * pi)


def test_what_can_be_chosen_is() -> None:
    assert billiards.stadium(length=0.0).build().shapes[0].radius == 2.0  # type: ignore[union-attr]
    assert len(billiards.stadium(length=0.0).shapes) == 2
    for make, options, place in (
        (billiards.stadium, {"length": 3.0, "radius": 1.0}, (2.5, 0.0)),
        (billiards.sinai, {"side": 3.0, "radius": 0.5}, (0.0, 1.5)),
        (billiards.circle, {"radius": 0.7}, (0.7, 0.0)),
        (billiards.rectangle, {"width": 3.0, "height": 0.5}, (0.1, 0.25)),
    ):
        assert distance_to_walls(make(**options), place) < 1e-12


@pytest.mark.parametrize(
    ("make", "options", "told"),
    [
        (billiards.sinai, {"side": 2.0, "radius": 1.0}, "radius must be less than half the side, 1.0, not 1.0"),
        (billiards.annulus, {"outer": 1.0, "inner": 1.5}, "inner must be less than the outer radius, 1.0, not 1.5"),
        (billiards.annulus, {"offset": 1.5}, "offset must be less than the difference of the radii"),
        (billiards.lemon, {"distance": 6.0}, "distance must be less than twice the radius, 6.0, not 6.0"),
        (billiards.flower, {"distance": 2.0}, "distance must be less than what leaves no gap between two petals"),
        (billiards.flower, {"petals": 2}, "petals must be from 3 to 1000, not 2"),
        (billiards.mushroom, {"width": 4.0}, "width must be less than the cap's diameter, 4.0, not 4.0"),
        (billiards.wedge, {"angle": 1.6}, "angle must be less than a right angle"),
    ],
)
def test_a_table_that_cannot_be_is_refused(
    make: Callable[..., carom.Scene], options: dict[str, Any], told: str
) -> None:
    with pytest.raises(carom.InvalidArgument, match=re.escape(told)):
        make(**options)


def test_a_ball_is_no_larger_than_its_table_bears() -> None:
    for make, options in (
        (billiards.sinai, {"radius": 1.99}),
        (billiards.annulus, {"offset": 1.19}),
        (billiards.lorentz, {"gap": 1e-3}),
        (billiards.mushroom, {"width": 1e-3}),
        (billiards.wedge, {"angle": 0.01}),
    ):
        scene = make(**options)
        assert distance_to_walls(scene, scene.balls[0].position) > 4.0 * scene.balls[0].radius > 0.0
