"""The hand: it drags a ball as walls allow, and throws it with the velocity of the mouse."""

from math import hypot

import pytest

import carom
from carom.play.toy.hand import FASTEST, MEMORY, Hand
from carom.play.toy.table import Table

FRAME = 1 / 60


def held(place: tuple[float, float], substeps: int = 4) -> tuple[Hand, Table, carom.Ball]:
    """A hand that holds the only ball of a table."""
    table = Table()
    table.clear()
    table.world.substeps = substeps
    ball = table.world.add(carom.Ball(place, radius=0.5))
    hand = Hand()
    hand.take(ball, place)
    return hand, table, ball


def sweep(hand: Hand, way: list[tuple[float, float]]) -> None:
    """Move the mouse along a way, a place a frame."""
    for place in way:
        hand.wait(FRAME)
        hand.move(place)


def test_a_thrown_ball_has_the_velocity_of_the_mouse() -> None:
    hand, table, ball = held((10.0, 20.0))
    sweep(hand, [(10.0 + 0.2 * step, 20.0 - 0.1 * step) for step in range(1, 12)])
    hand.throw([table])
    assert ball.velocity == pytest.approx((0.2 / FRAME, -0.1 / FRAME))
    assert hand.ball is None


def test_a_mouse_that_has_stopped_throws_nothing() -> None:
    hand, table, ball = held((10.0, 20.0))
    sweep(hand, [(11.0, 20.0), (12.0, 20.0)])
    hand.wait(2.0 * MEMORY)
    hand.throw([table])
    assert ball.velocity == (0.0, 0.0)


def test_a_mouse_that_is_stopping_throws_slowly() -> None:
    hand, table, ball = held((10.0, 20.0))
    sweep(hand, [(10.0 + 0.2 * step, 20.0) for step in range(1, 12)])
    hand.wait(0.7 * MEMORY)
    hand.throw([table])
    assert 0.0 < ball.velocity[0] < 0.5 * 0.2 / FRAME


def test_a_throw_has_a_greatest_speed() -> None:
    hand, table, ball = held((10.0, 20.0))
    sweep(hand, [(10.0 + 9.0 * step, 20.0) for step in range(1, 9)])
    hand.throw([table])
    assert hypot(*ball.velocity) == pytest.approx(FASTEST)


def test_a_held_ball_follows_the_mouse() -> None:
    hand, table, ball = held((10.0, 20.0))
    hand.move((10.3, 19.9))
    for _ in range(12):
        hand.pull([table], FRAME)
        table.step(FRAME)
    assert ball.position == pytest.approx((10.3, 19.9), abs=0.01)


@pytest.mark.compiled
@pytest.mark.parametrize(("substeps", "detection"), [(1, "discrete"), (4, "discrete"), (1, "continuous")])
def test_a_held_ball_does_not_go_through_a_wall(substeps: int, detection: str) -> None:
    hand, table, ball = held((10.0, 16.0), substeps)
    table.world.detection = detection
    hand.move((14.0, 16.0))
    for _ in range(120):
        hand.pull([table], FRAME)
        table.step(FRAME)
    upright = next(shape for shape in table.world.shapes if shape.name == "upright")
    assert ball.position[0] < upright.position[0]


def test_the_same_ball_is_held_on_every_table_that_has_it() -> None:
    hand, table, ball = held((10.0, 20.0))
    twin, empty = Table(), Table()
    twin.become(table)
    empty.clear()
    assert [one.id for one in hand.held([table, twin, empty])] == [ball.id, ball.id]
    sweep(hand, [(10.0, 20.0 + 0.1 * step) for step in range(1, 9)])
    hand.throw([table, twin])
    assert twin.world.object(ball.id).velocity == ball.velocity


def test_a_hand_that_holds_nothing_throws_nothing() -> None:
    hand = Hand()
    assert hand.velocity == (0.0, 0.0)
    hand.throw([Table()])
    assert hand.held([Table()]) == []
