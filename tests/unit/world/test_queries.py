"""Rays, moving circles, neighbours, boxes and overlaps in worlds as they stand."""

import pickle
from itertools import pairwise
from math import inf, nan, pi, sqrt
from typing import Any

import numpy as np
import pytest

import carom
from carom import Aabb, Arc, Ball, Circle, Compound, Gate, Point, Segment, World
from carom.world import CastHit, Neighbor
from tests.worlds import world_of

# -- rays --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("shape", "point", "normal"),
    [
        (Segment((5, -3), (5, 3)), (5, 0), (-1, 0)),
        (Segment((4, -1), (6, 1)), (5, 0), (-sqrt(0.5), sqrt(0.5))),
        (Gate((5, -3), (5, 3), (-1, 0)), (5, 0), (-1, 0)),
        (Circle((6, 0), 1), (5, 0), (-1, 0)),
        (Circle((0, 0), 5), (5, 0), (-1, 0)),
        (Circle((6, 0), 1, solid=True), (5, 0), (-1, 0)),
        (Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), (5, 0), (-1, 0)),
        (Arc((10, 0), 5, 0.5 * pi, 1.5 * pi), (5, 0), (-1, 0)),
        (Ball((6, 0), 1), (5, 0), (-1, 0)),
    ],
)
def test_a_ray_hits_each_kind_where_it_first_meets_it(shape: Any, point: Any, normal: Any) -> None:
    world = world_of(shape)
    hit = world.ray_cast((0, 0), (8, 0))
    assert hit == CastHit(shape, pytest.approx(5 / 8), pytest.approx(point), pytest.approx(normal))
    assert world.ray_cast((0, 20), (8, 20)) is None
    assert world.ray_cast((0, 0), (4.9, 0)) is None
    assert world.ray_cast((0, 0), (-8, 0)) is None or isinstance(shape, Circle)


def test_lines_are_hit_from_both_sides_and_normals_point_back() -> None:
    for shape in (Segment((5, -3), (5, 3)), Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), Circle((0, 0), 5)):
        world = world_of(shape)
        assert world.ray_cast((1, 0), (9, 0)).normal == (-1, 0)
        assert world.ray_cast((9, 0), (1, 0)).normal == (1, 0)


@pytest.mark.parametrize("shape", [Circle((0, 0), 5, solid=True), Ball((0, 0), 5)])
def test_a_ray_does_not_see_the_disc_that_it_starts_in(shape: Any) -> None:
    wall = Segment((9, -1), (9, 1))
    world = world_of(shape, wall)
    assert world.ray_cast((1, 0), (10, 0)).shape is wall
    assert world.ray_cast((-1, 0), (10, 0)).shape is wall
    assert world.ray_cast((-6, 0), (10, 0)).shape is shape


def test_a_gate_is_seen_from_its_closed_side_alone() -> None:
    world = world_of(Gate((5, -3), (5, 3), (1, 0)))
    assert world.ray_cast((0, 0), (8, 0)) is None
    assert world.ray_cast((8, 0), (0, 0)).normal == (1, 0)
    assert world.circle_cast((0, 0), 1, (8, 0)) is None
    assert world.circle_cast((8, 0), 1, (0, 0)).fraction == 0.25


def test_points_are_touched_by_circles_and_never_hit_by_rays() -> None:
    point = Point((5, 0))
    world = world_of(point)
    assert world.ray_cast((0, 0), (10, 0)) is None
    assert world.circle_cast((0, 0), 1, (10, 0)) == CastHit(point, 0.4, (5, 0), (-1, 0))


def test_the_first_of_several_is_hit_and_of_two_at_one_place_the_one_added_first() -> None:
    far, near, same = Segment((7, -1), (7, 1)), Segment((5, -1), (5, 1)), Segment((5, -1), (5, 1))
    assert world_of(far, near, same).ray_cast((0, 0), (10, 0)).shape is near
    ball, wall = Ball((6, 0), 1), Segment((5, -1), (5, 1))
    assert world_of(ball, wall).ray_cast((0, 0), (10, 0)).shape is ball
    assert world_of(Segment((5, -1), (5, 1)), Ball((6, 0), 1)).ray_cast((0, 0), (10, 0)).shape.kind == "segment"


def test_the_target_itself_is_within_reach() -> None:
    world = world_of(Segment((5, -1), (5, 1)))
    assert world.ray_cast((0, 0), (5, 0)).fraction == 1.0
    assert world.ray_cast((5, 0), (9, 0)).fraction == 0.0


def test_a_ray_of_no_length_hits_nothing() -> None:
    world = world_of(Segment((-1, 0), (1, 0)), Circle((0, 0), 1), Ball((0, 0), 2))
    assert world.ray_cast((0, 0), (0, 0)) is None
    assert world.circle_cast((0, 0), 1, (0, 0)) is None


def test_no_ray_and_no_circle_slips_through_a_joint() -> None:
    world = World()
    corners = [(0.1 * k, 0.3 * sqrt(k)) for k in range(100)]
    for start, end in pairwise(corners):
        world.add(Segment(start, end))
    inner = np.array(corners[1:-1])
    way = np.array([0.7, -1.3])
    assert world.ray_cast(inner - way, inner + way).found.all()
    line = World()
    joints = [(sqrt(k) * 0.6, sqrt(k) * 0.8) for k in range(100)]
    for start, end in pairwise(joints):
        line.add(Segment(start, end))
    inner = np.array(joints[1:-1])
    across = np.array([0.8, -0.6])
    assert line.circle_cast(inner - across, 0.3, inner + across).found.all()
    ring = world_of(*(Arc((1, 2), 3, k, k + 1) for k in range(6)), Arc((1, 2), 3, 6, 0))
    angles = np.arange(7.0)
    out = np.array([1, 2]) + 6 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    assert ring.ray_cast((1, 2), out).found.all()
    assert ring.circle_cast((1, 2), 0.5, out).found.all()


# -- moving circles ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("shape", "fraction", "point"),
    [
        (Segment((5, -3), (5, 3)), 0.3, (5, 0)),
        (Circle((8, 0), 3), 0.3, (5, 0)),
        (Circle((0, 0), 5), 0.3, (5, 0)),
        (Circle((8, 0), 3, solid=True), 0.3, (5, 0)),
        (Arc((0, 0), 5, 1.5 * pi, 0.5 * pi), 0.3, (5, 0)),
        (Ball((8, 0), 3), 0.3, (5, 0)),
        (Ball((8, 4), 3), 0.5, (6.2, 1.6)),
    ],
)
def test_a_circle_touches_each_kind_its_radius_earlier(shape: Any, fraction: float, point: Any) -> None:
    hit = world_of(shape).circle_cast((0, 0), 2, (10, 0))
    assert (hit.shape, hit.fraction, hit.point) == (shape, pytest.approx(fraction), pytest.approx(point))
    x, y = 10 * hit.fraction - hit.point[0], -hit.point[1]
    assert hit.normal == pytest.approx((x / 2, y / 2))


def test_a_circle_misses_a_bare_end_as_a_ball_does_and_touches_its_guard_point() -> None:
    world = world_of(Segment((5, 1), (5, 3)))
    assert world.circle_cast((0, 0), 2, (10, 0)) is None
    world.add(Point((5, 1)))
    assert world.circle_cast((0, 0), 2, (10, 0)).shape.kind == "point"


def test_a_circle_that_overlaps_at_the_start_touches_if_it_goes_deeper_and_may_leave() -> None:
    for shape in (Segment((1, -3), (1, 3)), Ball((4, 0), 3), Circle((4, 0), 3, solid=True), Point((1, 0))):
        world = world_of(shape)
        assert world.circle_cast((0, 0), 2, (10, 0)).fraction == 0
        assert world.circle_cast((0, 0), 2, (-10, 0)) is None


# -- what is seen ------------------------------------------------------------------------------------------------------


def test_sensors_are_seen_on_request_and_what_cannot_collide_never() -> None:
    sensor, off, ball = Segment((3, -1), (3, 1), sensor=True), Circle((5, 0), 1, can_collide=False), Ball((8, 0), 1)
    world = world_of(sensor, off, ball)
    assert world.ray_cast((0, 0), (9, 0)).shape is ball
    assert world.ray_cast((0, 0), (9, 0), sensors=True).shape is sensor
    assert world.nearest((3, 0)).shape is ball
    assert world.nearest((3, 0), sensors=True).shape is sensor
    box = Aabb(0, -2, 9, 2)
    assert world.overlapping(box) == [ball]
    assert world.overlapping(box, sensors=True) == [sensor, ball]
    ball.position, sensor.position = (5, 0), (4.5, 0)
    assert len(world.contacts()) == 0
    assert [contact.shape for contact in world.contacts(sensors=True)] == [sensor]
    ball.sensor = True
    assert world.ray_cast((0, 0), (9, 0)) is None


def test_masks_hold_both_ways() -> None:
    wall = Segment((5, -1), (5, 1), layer=0b10, collides_with=0b100)
    world = world_of(wall)
    assert world.ray_cast((0, 0), (9, 0)).shape is wall
    assert world.ray_cast((0, 0), (9, 0), collides_with=0b10).shape is wall
    assert world.ray_cast((0, 0), (9, 0), collides_with=0b101) is None
    assert world.ray_cast((0, 0), (9, 0), layer=0b110).shape is wall
    assert world.ray_cast((0, 0), (9, 0), layer=0b11) is None
    assert world.circle_cast((0, 0), 1, (9, 0), layer=1) is None
    assert world.nearest((0, 0), layer=1) is None
    assert world.overlapping(Aabb(0, 0, 9, 9), layer=1) == []


def test_a_part_of_a_compound_is_named_and_its_centre_is_not_there() -> None:
    part = Segment((5, -1), (5, 1))
    compound = Compound([part], pivot=(3, 0))
    world = world_of(compound)
    assert world.ray_cast((0, 0), (9, 0)).shape is part
    assert world.nearest((3, 0)).shape is part
    assert world.circle_cast((0, 0), 1, (9, 0)).shape.compound is compound


# -- the world as it stands --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("times", [1, 100])
def test_every_change_is_seen_at_once(times: int) -> None:
    wall, vane, ball = Segment((5, -1), (5, 1)), Segment((7, -1), (7, 1), motion="kinematic"), Ball((9, 0), 0.5)
    world = world_of(wall, vane, ball)

    def first() -> float:
        """How far a ray gets, after having been asked often enough for grids to be made."""
        fractions = {world.ray_cast((0, 0), (10, 0)).fraction for _ in range(times)}
        fractions |= set(world.ray_cast(np.zeros((times, 2)), (10, 0))["fraction"])
        assert len(fractions) == 1
        return 10 * fractions.pop()

    assert first() == 5
    wall.position = (6, 0)
    assert first() == 6
    wall.can_collide = False
    assert first() == 7
    vane.position = (7.5, 0)
    assert first() == 7.5
    vane.velocity = (-1, 0)
    for place in (7, 6.5):
        world.step(0.5)
        assert first() == place
    world.remove(vane)
    assert first() == 8.5
    world.balls.position[0] = (9.25, 0)
    assert first() == 8.75
    ball.radius = 1
    assert first() == 8.25
    state = world.snapshot()
    world.add(Segment((1, -1), (1, 1)))
    assert first() == 1
    world.restore(state)
    assert first() == 8.25
    world.add_balls([(4, 0)], radius=1)
    assert first() == 3


def test_what_moves_by_itself_is_seen_where_it_is() -> None:
    vane = Segment((0, -1), (0, 1), motion="kinematic", velocity=(0, 100))
    world = world_of(vane, *(Segment((x, 0), (x, 90)) for x in range(10, 20)))
    starts = np.full((100, 2), (-1.0, 50.0))
    assert not world.ray_cast(starts, (1, 50)).found.any()
    world.step(0.5)
    assert world.ray_cast(starts, (1, 50)).found.all()
    world.step(0.5)
    assert not world.ray_cast(starts, (1, 50)).found.any()


def test_questions_change_nothing() -> None:
    def busy() -> World:
        """A world in which much happens."""
        world = carom.scenes.toy().build()
        world.run(0.3)
        return world

    asked, left = busy(), busy()
    for world in (asked, left):
        world.add(Segment((0, 0), (1, 0.1)))
    before, counts = asked.digest(), asked.statistics.as_dict()
    for _ in range(2):
        asked.ray_cast(np.zeros((100, 2)), np.ones((100, 2)))
        asked.ray_cast((0, 0), (3, 3))
        asked.circle_cast((0, 0), 1, (3, 3))
        asked.nearest((1, 1))
        asked.overlapping(Aabb(0, 0, 5, 5))
        asked.contacts()
        asked.aim(asked.balls[0], (1, 1))
        assert asked.digest() == before
        assert asked.statistics.as_dict() == counts
        assert asked.step(0.02).tobytes() == left.step(0.02).tobytes()
        before, counts = left.digest(), left.statistics.as_dict()
        assert asked.digest() == before


def test_a_ball_that_is_nowhere_is_not_seen() -> None:
    world = World()
    world.add_balls([(1, 0), (2, 0), (3, 0)], radius=0.1)
    world.balls.position[:2] = [(nan, 0), (2, inf)]
    for times in (1, 100):
        for hit in world.ray_cast(np.zeros((times, 2)), (9, 0)):
            assert hit.shape is world.balls[2]
        assert set(world.nearest(np.zeros((times, 2)))["shape"]) == {world.balls[2].id}
    assert world.overlapping(Aabb(-9, -9, 9, 9)) == [world.balls[2]]
    assert len(world.contacts()) == 0
    assert world.aim(world.balls[2], (-1, 0)) is None
    with pytest.raises(ValueError, match="ball must be at a finite place"):
        world.aim(world.balls[0], (1, 0))


def test_an_empty_world_has_nothing_to_find() -> None:
    world = World()
    assert world.ray_cast((0, 0), (1, 1)) is None
    assert world.nearest((0, 0)) is None
    assert world.overlapping(Aabb(0, 0, 1, 1)) == []
    assert list(world.contacts()) == []
    assert list(world.nearest(np.zeros((2, 2)))) == [None, None]
    assert not world.ray_cast(np.zeros((100, 2)), (1, 1)).found.any()


# -- neighbours and boxes ----------------------------------------------------------------------------------------------


def test_the_nearest_shape_is_told_with_its_distance_and_point() -> None:
    segment, arc, ball = Segment((0, 0), (4, 0)), Arc((10, 0), 2, 0, pi), Ball((0, 29), 1)
    world = world_of(segment, arc, ball)
    assert world.nearest((7, 4)) == Neighbor(arc, pytest.approx(3), pytest.approx((8.8, 1.6)))
    assert world.nearest((-3, 4)) == Neighbor(segment, 5, (0, 0))
    assert world.nearest((2, 1)) == Neighbor(segment, 1, (2, 0))
    assert world.nearest((0, 32)) == Neighbor(ball, 2, (0, 30))
    assert world.nearest((11, -1)).shape is arc


def test_distances_are_negative_inside_of_what_is_solid() -> None:
    ball, disc, ring = Ball((0, 0), 2), Circle((20, 0), 5, solid=True), Circle((20, 0), 5)
    small = Ball((0, 1.9), 0.05)
    assert world_of(ball, small).nearest((0, 1)) == Neighbor(ball, -1, (0, 2))
    assert world_of(Ball((0, 0.5), 1), ball := Ball((0, 0), 2)).nearest((0, 1)).shape is ball
    assert world_of(disc).nearest((20, 0)).distance == -5
    assert world_of(ring).nearest((20, 1)) == Neighbor(ring, 4, (20, 5))


def test_of_two_as_near_the_one_added_first_is_nearest() -> None:
    ball, wall = Ball((-3, 0), 1), Segment((2, -1), (2, 1))
    assert world_of(ball, wall).nearest((0, 0)).shape is ball
    ball, wall = Ball((-3, 0), 1), Segment((2, -1), (2, 1))
    assert world_of(wall, ball).nearest((0, 0)).shape is wall


@pytest.mark.parametrize(
    ("shape", "box", "meets"),
    [
        (Point((1, 1)), (1, 1, 2, 2), True),
        (Point((1, 1)), (1.1, 1, 2, 2), False),
        (Segment((0, 0), (4, 4)), (1, 2, 1.5, 2.5), False),
        (Segment((0, 0), (4, 4)), (1, 2, 2, 2.5), True),
        (Segment((0, 0), (4, 4)), (1, 0, 3, 1), True),
        (Segment((0, 0), (4, 4)), (5, 4, 6, 6), False),
        (Segment((0, 0), (4, 0)), (1, -1, 2, 1), True),
        (Circle((0, 0), 5), (-1, -1, 1, 1), False),
        (Circle((0, 0), 5, solid=True), (-1, -1, 1, 1), True),
        (Circle((0, 0), 5), (3, 4, 9, 9), True),
        (Circle((0, 0), 5), (3.1, 4, 9, 9), False),
        (Circle((0, 0), 5), (-9, -9, 9, 9), True),
        (Circle((0, 0), 5), (-5, -1, -4, 1), True),
        (Ball((0, 0), 5), (3, 3, 4, 4), True),
        (Ball((0, 0), 5), (4, 4, 5, 5), False),
        (Arc((0, 0), 5, 0, 0.5 * pi), (3, 3, 4, 4), True),
        (Arc((0, 0), 5, 0.5 * pi, 0), (3, 3, 4, 4), False),
        (Arc((0, 0), 5, 0, 0.5 * pi), (-1, -1, 3, 3), False),
        (Arc((0, 0), 5, 0, 0.5 * pi), (-9, -9, 9, 9), True),
        (Arc((0, 0), 5, 0, 0.5 * pi), (-1, 4, 1, 6), True),
        (Arc((0, 0), 5, 0.1, 3), (-9, 4.5, 9, 9), True),
        (Arc((0, 0), 5, 0.1, 3), (-1, -9, 1, 4.5), False),
        (Arc((0, 0), 5, 3.2, 6.2), (-1, -9, 1, 4.5), True),
        (Arc((0, 0), 5, 2, 4), (-9, -0.1, -4, 0.1), True),
        (Arc((0, 0), 5, 4, 2), (-9, -0.1, -4, 0.1), False),
    ],
)
def test_a_box_holds_what_has_a_point_in_common_with_it(shape: Any, box: tuple[float, ...], meets: bool) -> None:
    world = world_of(shape)
    assert world.overlapping(Aabb(*box)) == ([shape] if meets else [])
    assert len(world.overlapping(np.array([box] * 100))) == 100 * meets


def test_boxes_tell_ids_in_order() -> None:
    ball, wall = Ball((0, 0), 1), Segment((0, 0), (9, 0))
    world = world_of(ball, wall)
    rows = world.overlapping([Aabb(8, -1, 9, 1), Aabb(-1, -1, 1, 1), Aabb(20, 20, 21, 21)])
    assert rows.tolist() == [(0, wall.id), (1, ball.id), (1, wall.id)]
    assert world.overlapping(np.zeros((0, 4))).tolist() == []


def test_overlaps_are_what_detect_says_of_every_pair() -> None:
    floor, bowl, gate = Segment((0, 0), (10, 0)), Circle((5, 0), 4), Gate((0, 1), (10, 1), (0, 1))
    world = world_of(floor, bowl, gate)
    first = world.add(Ball((2, 0.5), 1, velocity=(1, -2)))
    second = world.add(Ball((2.5, 1.5), 1, velocity=(-1, -1)))
    lone = world.add(Ball((7, 20), 1))
    expected = [shape.detect(ball) for ball in (first, second, lone) for shape in (floor, bowl, gate, first, second)]
    found = world.contacts()
    assert list(found) == [contact for contact in expected if contact and contact.shape.id < contact.ball.id]
    assert found["shape"].tolist() == [floor.id, bowl.id, gate.id, first.id]
    assert found["ball"].tolist() == [first.id] * 2 + [second.id] * 2
    assert {contact.ball for contact in world.contacts(layer=1)} == {first, second}
    with pytest.warns(DeprecationWarning, match=r"World\.overlaps\(\) is called World\.contacts\(\) now") as warned:
        assert world.overlaps(layer=1).tobytes() == world.contacts(layer=1).tobytes()
    assert warned[0].filename == __file__
    floor.layer, second.layer, first.collides_with = 2, 2, 1
    assert [(contact.shape, contact.ball) for contact in world.contacts()] == [(bowl, first), (gate, second)]
    second.collides_with = 0
    assert [(contact.shape, contact.ball) for contact in world.contacts()] == [(bowl, first)]


def test_more_overlaps_than_balls_are_all_found() -> None:
    world = World()
    world.add_balls(np.zeros((60, 2)), radius=1.0)
    contacts = world.contacts()
    assert len(contacts) == 60 * 59 // 2
    assert len(set(zip(contacts["shape"], contacts["ball"], strict=True))) == 60 * 59 // 2
    assert len(world.overlapping(np.array([(0, 0, 1, 1)] * 50))) == 50 * 60


# -- many at once ------------------------------------------------------------------------------------------------------


def test_an_array_of_rays_gives_a_row_for_each() -> None:
    wall = Segment((5, -1), (5, 1))
    world = world_of(wall)
    hits = world.ray_cast((0, 0), [(10, 0), (0, 10), (10, 1)])
    assert hits.found.tolist() == [True, False, True]
    assert hits["shape"].tolist() == [wall.id, 0, wall.id]
    assert hits["fraction"].tolist() == [0.5, 1.0, 0.5]
    assert hits["point"].tolist() == [[5, 0], [0, 10], [5, 0.5]]
    assert hits["normal"].tolist() == [[-1, 0], [0, 0], [-1, 0]]
    assert hits[1] is None
    assert list(hits) == [world.ray_cast((0, 0), target) for target in ((10, 0), (0, 10), (10, 1))]
    assert repr(hits) == "<CastHits: 2 of 3 found something>"
    assert list(hits[hits.found])[1].point == (5, 0.5)
    assert world.ray_cast([(0, 0), (9, 0)], (5, 0))["normal"].tolist() == [[-1, 0], [1, 0]]


def test_radii_may_be_an_array_too() -> None:
    world = world_of(Segment((5, -9), (5, 9)))
    assert world.circle_cast((0, 0), [1, 2], (10, 0))["fraction"].tolist() == pytest.approx([0.4, 0.3])
    assert world.circle_cast([(0, 0), (1, 0)], 1, (10, 0))["fraction"].tolist() == pytest.approx([0.4, 3 / 9])
    assert world.circle_cast((0, 0), np.array([1, 2]), [(10, 0), (20, 0)])["fraction"].tolist() == [0.4, 0.15]


def test_no_queries_have_no_answers() -> None:
    world = world_of(Segment((5, -9), (5, 9)))
    none = np.zeros((0, 2))
    assert len(world.ray_cast(none, none)) == len(world.nearest(none)) == len(world.ray_cast(none, (1, 1))) == 0


def test_answers_outlive_what_they_name_and_lose_their_world_in_a_pickle() -> None:
    wall = Segment((5, -1), (5, 1))
    world = world_of(wall)
    hits = world.ray_cast((0, 0), [(10, 0)])
    world.remove(wall)
    assert hits[0].shape is wall
    before = world.snapshot()
    world.add_balls([(5, 0)], radius=1)
    rows = world.ray_cast((0, 0), [(10, 0)])
    world.restore(before)
    with pytest.raises(carom.LostObject, match="has left the world"):
        rows[0]
    copied = pickle.loads(pickle.dumps(hits))
    assert copied["fraction"].tolist() == [0.5]
    with pytest.raises(carom.LostObject):
        copied[0]


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda world: world.ray_cast((0, nan), (1, 1)), r"origin\[1\] must be finite"),
        (lambda world: world.ray_cast((0, 0), 7), "target must be a pair"),
        (lambda world: world.ray_cast((0, 0), "ab"), "target must be a pair"),
        (lambda world: world.ray_cast([[0, 0], [1]], (1, 1)), "origin must be a pair"),
        (lambda world: world.ray_cast(np.zeros((3, 3)), (1, 1)), "origin must be numbers of shape"),
        (lambda world: world.ray_cast(np.full((3, 2), inf), (1, 1)), "origin.* must be finite"),
        (lambda world: world.ray_cast(np.zeros((3, 2)), np.zeros((2, 2))), "target must be one or as many as origin"),
        (lambda world: world.ray_cast((-1.7e308, 0), (1.7e308, 0)), "target must not be infinitely far away"),
        (lambda world: world.ray_cast([(-1.7e308, 0)], (1.7e308, 0)), "target must not be infinitely far away"),
        (lambda world: world.ray_cast((0, 0), (1, 1), layer=-1), "layer must be from 0"),
        (lambda world: world.ray_cast((0, 0), (1, 1), collides_with=1.5), "collides_with must be a whole number"),
        (lambda world: world.ray_cast((0, 0), (1, 1), sensors=1), "sensors must be True or False"),
        (lambda world: world.circle_cast((0, 0), 0, (1, 1)), "radius must be positive, not 0"),
        (lambda world: world.circle_cast((0, 0), "a", (1, 1)), "radius must be a number"),
        (lambda world: world.circle_cast((0, 0), [1, -1], (1, 1)), "radius.* must be positive"),
        (lambda world: world.circle_cast(np.zeros((3, 2)), [1, 1], (1, 1)), "radius must be one or as many as center"),
        (lambda world: world.nearest((1, 2, 3)), "point must be a pair"),
        (lambda world: world.nearest(None), "point must be a pair"),
        (lambda world: world.overlapping((0, 0, 1)), "aabb must be numbers of shape"),
        (lambda world: world.overlapping((1, 0, 0, 1)), "left must not exceed"),
        (lambda world: world.overlapping(np.zeros((3, 3))), "aabb must be numbers of shape"),
        (lambda world: world.overlapping([(1, 0, 0, 1)]), "aabb must have left <= right"),
        (lambda world: world.overlapping(5), "aabb must be"),
        (lambda world: world.overlapping([Aabb(0, 0, 1, 1), 3]), "aabb must be"),
        (lambda world: world.contacts(layer=2**32), "layer must be from 0"),
    ],
)
def test_bad_questions_are_refused_by_name(ask: Any, words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words):
        ask(world_of(Segment((5, -9), (5, 9))))
