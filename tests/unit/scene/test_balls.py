"""Balls go into a world and come out of it many at once, as if one by one."""

from typing import Any

from hypothesis import given
from hypothesis import strategies as st

import carom
from carom.scene.balls import described_balls
from carom.scene.capture import described
from carom.scene.descriptors import BallDescriptor
from tests.scene_tables import balls


@given(st.lists(balls, max_size=5))
def test_balls_are_added_at_once_as_they_are_one_by_one(tables: list[dict[str, Any]]) -> None:
    made = carom.Scene(balls=tables)
    world, other = made.build(), carom.World()
    for ball in made.balls:
        other.add(ball.build())
    assert world.digest() == other.digest()
    assert [ball.name for ball in world.balls] == [ball.name for ball in made.balls]


@given(st.lists(balls, max_size=5))
def test_balls_of_a_world_are_described_at_once_as_they_are_one_by_one(tables: list[dict[str, Any]]) -> None:
    world = carom.Scene(balls=tables).build()
    assert all(ball.keys() == BallDescriptor.model_fields.keys() for ball in described_balls(world))
    assert repr(carom.Scene.from_world(world).balls) == repr(tuple(described(ball) for ball in world.balls))
