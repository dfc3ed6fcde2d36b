"""What is drawn of shapes and balls: boxes, arrows, and ways as far as they are on the stage."""

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.parts.frame import MARGIN
from carom.draw.parts.scenery import on_stage, shown
from tests.unit.draw.svg_marks import SVG, layer, marks_of, of_world, root_of, trace_of
from tests.worlds import world_of


def test_boxes_of_balls_are_drawn_where_balls_are() -> None:
    world = carom.World()
    world.add(carom.Segment((0, 0), (2, 1)))
    world.add(carom.Segment((0, 0), (2, 0)))
    world.add(carom.Point((1, 1)))
    world.add(carom.Ball((1, 0.5), 0.2))
    world.add(carom.Ball((9, 9), 0.2))
    assert len(of_world(world, Layer.BOXES)["boxes"]) == 8
    marks = of_world(world, Layer.BOXES, Layer.BALLS)
    assert len(marks["boxes"]) == 8
    assert len(marks["boxes-moving"]) == 4


def test_velocities_are_arrows_of_what_moves() -> None:
    world = carom.World()
    world.add(carom.Circle((0, 0), 5))
    for x, velocity in ((-2, (3, 0)), (0, (0, 0)), (2, (0, 1.5)), (90, (1, 0))):
        world.add(carom.Ball((x, 0), 0.5, velocity=velocity))
    shafts = [mark for mark in of_world(world, Layer.VELOCITIES)["velocities"] if mark.tag == f"{SVG}path"]
    lengths = []
    for shaft in shafts:
        (x, y), (to_x, to_y) = (map(float, place.split()) for place in shaft.get("d")[1:].split("L"))
        lengths.append(np.hypot(to_x - x, to_y - y) + 7.0)
    assert len(lengths) == 2
    assert lengths[0] == pytest.approx(2.0 * lengths[1], rel=0.02)


@pytest.mark.parametrize("way", [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1)])
def test_arrows_end_beside_the_stage_at_the_latest(way: tuple[int, int]) -> None:
    world = carom.World()
    world.add(carom.Circle((0, 0), 5))
    for number in range(40):
        world.add(carom.Ball((0, 0.1 * number), 0.05, velocity=(0.01, 0)))
    world.add(carom.Ball((4.9 * way[0], 4.9 * way[1]), 0.05, velocity=(50 * way[0], 50 * way[1])))
    picture = draw.picture_of(world, "name", layers=[Layer.VELOCITIES])
    tips = [mark for mark in marks_of(picture)["velocities"] if mark.tag == f"{SVG}polygon"]
    x, y = zip(*np.array(tips[-1].get("points").split(), float).reshape(-1, 2).tolist(), strict=True)
    frame = picture.frame
    assert frame.stage_left - 20.0 < min(x)
    assert max(x) < frame.panel_left
    assert frame.stage_top - 20.0 < min(y)
    assert max(y) < frame.height


def test_a_track_that_leaves_the_stage_is_cut_there() -> None:
    world = world_of(carom.Segment((-1, -1), (1, -1)), carom.Segment((-1, 1), (1, 1)))
    world.add(carom.Ball((0, 0), 0.25, velocity=(6, 0)))
    places = [
        float(x)
        for line in layer(root_of(world, trace_of(world, 60)), "tracks").iter(f"{SVG}polyline")
        for x in line.get("points").split()[::2]
    ]
    picture = draw.picture_of(world, "name")
    assert places
    assert max(places) <= picture.frame.panel_left - MARGIN


def test_the_stretches_of_a_way_are_those_on_the_stage() -> None:
    picture = draw.picture_of(world_of(carom.Circle((0, 0), 5)), "name")
    far = picture.frame.stage.right + 1.0
    xs = [0.0, 1.0, far, far, 2.0, far, 3.0, 4.0, -3.0]
    points = np.array([(x, 0.0) for x in xs])
    stretches = [stretch[:, 0].tolist() for stretch in on_stage(picture, points)]
    assert stretches == [[0.0, 1.0], [3.0, 4.0, -3.0]]
    assert shown(picture, points).tolist() == [x < far for x in xs]
    assert on_stage(picture, points[2:4]) == []
