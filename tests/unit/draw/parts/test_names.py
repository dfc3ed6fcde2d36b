"""Names: each once, beside what it names, over no other, on the stage."""

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.parts.frame import Frame
from carom.draw.parts.labels import over_any
from carom.draw.parts.moment import Balls
from carom.draw.parts.names import MOST_BALLS, ball_boxes, moving_labels
from carom.shapes.aabb import Aabb
from tests.pages.runs import furnished_run
from tests.unit.draw.svg_marks import of_world, words_in


def test_names_stand_once_beside_what_they_name() -> None:
    world = carom.World()
    for x in range(3):
        world.add(carom.Segment((2 * x, 0), (2 * x + 1, 0), name="step"))
    world.add(carom.Circle((3, 3), 1, name="ring"))
    world.add(carom.Arc((0, 3), 1, 0.5, 2.5, name="bow"))
    world.add(carom.Point((5, 3)))
    for x in (0, 3):
        blade = carom.Segment((x, 1.5), (x + 1, 1.5))
        world.add(carom.Compound([blade, *carom.guard_points([blade])], pivot=(x, 1.5), name="oar"))
    world.add(carom.Ball((5, 1), 0.2, name="<ball>"))
    world.add(carom.Ball((50, 1), 0.2, name="far"))
    world.add(carom.Ball((5, 2), 0.2, name=""))
    marks = of_world(world, Layer.NAMES)
    assert words_in(marks["names"]) == [
        "step \N{MULTIPLICATION SIGN} 3",
        "ring",
        "bow",
        "oar \N{MULTIPLICATION SIGN} 2",
        "<ball>",
    ]


def test_names_lie_over_no_other_with_all_layers_and_what_is_left_out_is_said() -> None:
    for number in (30, 160):
        world = carom.World()
        for place in range(number):
            x, y = 2.0 * (place % 20), 2.0 * (place // 20)
            world.add(carom.Segment((x, y), (x + 1, y + 1), name=f"segment {place}"))
            world.add(carom.Ball((x + 1.0, y), 0.3, velocity=(1, 1), name=f"ball {place}"))
        picture = draw.picture_of(world, "Crowd", layers=set(Layer), size=(900, 560))
        labels = [*picture.labels.found, *moving_labels(picture).found]
        boxes = np.array([label.box for label in labels])
        for place in range(len(boxes)):
            assert not over_any(boxes[place : place + 1], np.delete(boxes, place, axis=0)).any()
        left_out = 2 * number - len(labels)
        said = [note for note in picture.panel.notes if "no room" in note]
        assert said == ([f"{left_out} names have no room."] if left_out else [])
        assert picture.panel.height <= picture.frame.height
    assert left_out > 20


def test_a_world_of_many_balls_is_labelled_without_regard_to_them() -> None:
    frame = Frame.around(Aabb(0.0, 0.0, 10.0, 10.0), 100.0)
    world = carom.World()
    world.add_balls(position=np.full((MOST_BALLS + 1, 2), 5.0), velocity=0.0, radius=0.1)
    assert len(ball_boxes(frame, Balls.of(world))) == 0
    world.remove(world.balls[0])
    assert len(ball_boxes(frame, Balls.of(world))) == MOST_BALLS


def test_names_of_what_stays_stand_where_they_stood_whatever_moves() -> None:
    pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
    film = draw.Film(furnished_run(), layers={Layer.NAMES, Layer.BALLS}, size=(640, 400))
    before = film._picture.labels
    for frame in (0, 40):
        film.frame(frame)
    assert film._picture.labels is before
    assert len(before.found) == 6
