"""Layers, masks and switches: who may collide with whom."""

import pytest

from carom import Ball, Point, World
from carom.rows.masks import may_collide


@pytest.mark.parametrize("kind", ["shape", "ball"])
@pytest.mark.parametrize(
    ("first", "second", "meets"),
    [
        ((1, 1), (1, 1), True),
        ((1, 2), (2, 1), True),
        ((1, 2), (2, 2), False),
        ((2, 3), (1, 3), True),
        ((1, 0), (1, 1), False),
        ((2**31, 2**31), (2**31, 2**31), True),
        ((4, 8), (8, 3), False),
    ],
)
def test_two_meet_iff_each_is_on_a_layer_that_the_other_meets(
    kind: str, first: tuple[int, int], second: tuple[int, int], meets: bool
) -> None:
    world = World(substeps=1)
    options = {"layer": first[0], "collides_with": first[1]}
    world.add(Ball((0, 0), radius=1, **options) if kind == "ball" else Point((0, 0), **options))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -1), layer=second[0], collides_with=second[1]))
    assert (len(world.step(0.1)) == 1) is meets
    assert (ball.velocity == (0, -1)) is not meets
    rows = world._arrays.balls.rows if kind == "ball" else world._arrays.shapes.rows
    assert may_collide(rows[0], ball._row) is meets


def test_what_cannot_collide_meets_nothing() -> None:
    world = World(substeps=1)
    post = world.add(Point((0, 0), can_collide=False))
    ball = world.add(Ball((0, 0.9), radius=1, velocity=(0, -1)))
    ghost = world.add(Ball((0.5, 0.9), radius=1, can_collide=False))
    assert len(world.step(0.1)) == 0
    assert ghost.position == (0.5, 0.9)
    post.can_collide = True
    assert [hit.shape for hit in world.step(0.1)] == [post]
    ghost.can_collide = True
    world.step(0.1)
    assert ghost.position != (0.5, 0.9)
    assert ball.position != (0, 1)
