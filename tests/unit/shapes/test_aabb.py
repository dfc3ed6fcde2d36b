"""Boxes: what is in them, what they touch, and how they grow."""

import copy
from dataclasses import FrozenInstanceError

import pytest

from carom import Aabb, InvalidArgument


def test_a_box_grows_from_a_point() -> None:
    box = Aabb.at((1, 2)).including((4, -6)).including((3, 0))
    assert tuple(box) == (1.0, -6.0, 4.0, 2.0)
    assert (box.width, box.height) == (3.0, 8.0)
    assert box.top_left == (1.0, 2.0)
    assert box.bottom_right == (4.0, -6.0)


def test_the_edge_belongs_to_the_box() -> None:
    box = Aabb(0, 0, 2, 1)
    assert (2, 1) in box
    assert (0.0, 0.5) in box
    assert (2.0000001, 1) not in box
    assert (1, -1e-300) not in box


def test_touching_boxes_overlap() -> None:
    box = Aabb(0, 0, 2, 1)
    assert box.overlaps(Aabb(2, 1, 3, 3))
    assert Aabb(2, 1, 3, 3).overlaps(box)
    assert not box.overlaps(Aabb(2.0000001, 0, 3, 1))
    assert not box.overlaps(box.translated((0, 1.5)))


def test_a_box_is_a_value() -> None:
    box = Aabb(0, 0, 2, 1)
    assert box == Aabb(0.0, 0.0, 2.0, 1.0)
    assert hash(box) == hash(copy.deepcopy(box))
    assert box.translated((1, -1)) == Aabb(1, -1, 3, 0)
    with pytest.raises(FrozenInstanceError):
        box.left = 1.0  # type: ignore[misc]


def test_sides_come_back_as_floats() -> None:
    assert [type(side) for side in Aabb(0, 0, 2, 1)] == [float] * 4


def test_sides_in_the_wrong_order_are_refused() -> None:
    with pytest.raises(InvalidArgument, match=r"left must not exceed right=1\.0, not 2"):
        Aabb(2, 0, 1, 1)
    with pytest.raises(InvalidArgument, match="bottom must not exceed top"):
        Aabb(0, 2, 1, 1)
