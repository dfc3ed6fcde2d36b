"""Boxes and overlaps: what is in a box, and which balls overlap what."""

from math import pi
from typing import Any

import numpy as np
import pytest

from carom import Aabb, Arc, Ball, Circle, Gate, Point, Segment, World
from tests.worlds import world_of


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
