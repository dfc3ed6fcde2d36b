"""Rays, moving circles, neighbours, boxes and overlaps in worlds as they stand."""

from math import inf, nan
from typing import Any

import numpy as np
import pytest

import carom
from carom import Aabb, Ball, Circle, Compound, Segment, World
from tests.worlds import world_of


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


def test_radii_may_be_an_array_too() -> None:
    world = world_of(Segment((5, -9), (5, 9)))
    assert world.circle_cast((0, 0), [1, 2], (10, 0))["fraction"].tolist() == pytest.approx([0.4, 0.3])
    assert world.circle_cast([(0, 0), (1, 0)], 1, (10, 0))["fraction"].tolist() == pytest.approx([0.4, 3 / 9])
    assert world.circle_cast((0, 0), np.array([1, 2]), [(10, 0), (20, 0)])["fraction"].tolist() == [0.4, 0.15]


def test_no_queries_have_no_answers() -> None:
    world = world_of(Segment((5, -9), (5, 9)))
    none = np.zeros((0, 2))
    assert len(world.ray_cast(none, none)) == len(world.nearest(none)) == len(world.ray_cast(none, (1, 1))) == 0


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


@pytest.mark.parametrize("none", [[], np.array([]), np.zeros((0, 2))], ids=["list", "array", "rows"])
def test_a_list_of_nothing_is_no_query(none: Any) -> None:
    world = carom.World()
    ball = world.add(carom.Ball((0, 0), 0.5))
    world.add(carom.Segment((0, 2), (1, 2)))
    assert (
        len(world.ray_cast(none, (1, 1))) == len(world.ray_cast((0, 0), none)) == len(world.ray_cast(none, none)) == 0
    )
    assert len(world.circle_cast(none, 1.0, (1, 1))) == len(world.circle_cast((0, 0), [], (1, 1))) == 0
    assert len(world.nearest(none)) == len(world.overlapping([])) == 0
    assert len(world.aim(ball, none)) == len(world.aim([])) == len(world.aim(np.array([]))) == 0
    with pytest.raises(carom.InvalidArgument, match="target must be one or as many as origin, 2, not 0"):
        world.ray_cast([(0, 0), (1, 1)], none)
    with pytest.raises(carom.InvalidArgument, match="origin must be a pair of numbers"):
        world.ray_cast((), (1, 1))
    with pytest.raises(carom.InvalidArgument, match=r"origin must be numbers of shape \('n', 2\)"):
        world.ray_cast(np.zeros((0, 3)), (1, 1))


@pytest.mark.parametrize("none", [[], np.array([]), np.zeros((0, 2))], ids=["list", "array", "rows"])
def test_no_balls_are_added_all_at_once(none: Any) -> None:
    world = carom.World()
    assert len(world.add_balls(none, radius=1.0)) == len(world.add_balls(none, velocity=none, radius=[])) == 0
    assert len(world.balls) == 0
    for wrong in ({"velocity": []}, {"radius": []}):
        with pytest.raises(carom.InvalidArgument, match=r"must be numbers of shape \(1,"):
            world.add_balls([(0, 0)], **({"radius": 1.0} | wrong))
