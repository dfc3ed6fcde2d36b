"""Pictures show the world as it stands, what was switched off too, and fit the table."""

import sys

import numpy as np
import pytest

import carom
from carom.rl.picturing import Camera, fitting, table_box
from tests.rl_tasks import yard


def test_the_table_is_what_is_around_all_shapes() -> None:
    assert table_box(yard().build()) == carom.Aabb(0.0, 0.0, 10.0, 10.0)


@pytest.mark.parametrize(
    ("box", "size"),
    [((0, 0, 10, 10), (600, 600)), ((0, 0, 20, 42), (286, 600)), ((0, 0, 100, 1), (600, 64))],
)
def test_a_picture_has_the_shape_of_the_table(box: tuple[float, ...], size: tuple[int, int]) -> None:
    assert fitting(carom.Aabb(*box)) == size


def test_a_picture_is_of_its_own_moment() -> None:
    camera, world = Camera(yard(), (120, 100)), yard().build()
    first = camera.take(world)
    assert first.shape == (100, 120, 3)
    assert first.dtype == np.uint8
    again = first.copy()
    world.balls[0].position = (5.0, 2.0)
    assert (camera.take(world) != first).any()
    assert (first == again).all(), "a picture taken stays as it is"
    world.balls[0].position = yard().balls[0].position
    assert (camera.take(world) == first).all()


def test_a_brick_that_is_gone_is_seen_to_be() -> None:
    camera, world = Camera(yard()), yard().build()
    before = camera.take(world)
    (brick,) = [shape for shape in world.shapes if shape.name == "brick 1"]
    brick.can_collide = False
    changed = np.argwhere((camera.take(world) != before).any(axis=2))
    # Rows count from the top, 60 pixels are one unit of length.
    assert np.abs(changed / 60.0 - (10.0 - 6.5, 7.5)).max() < 0.9


def test_without_pygame_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(carom.MissingExtra, match=r"pictures of environments need pygame-ce: .*carom\[draw\]"):
        Camera(yard())
