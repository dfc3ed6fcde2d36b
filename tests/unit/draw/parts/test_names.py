"""Names: each once, beside what it names, over no other, on the stage."""

import carom
from carom.draw import Layer
from carom.draw.parts.frame import Frame
from carom.draw.parts.names import overlap, placed
from carom.shapes.aabb import Aabb
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
    ]
    assert words_in(marks["names-moving"]) == ["<ball>"]


def test_labels_lie_over_none_and_on_the_stage() -> None:
    frame = Frame.around(Aabb(0.0, 0.0, 10.0, 10.0), 100.0)
    spot = [(frame.pixel(5.0, 5.0), 4.0)]
    labels = placed(frame, [(f"name {number}", spot) for number in range(9)], [])
    assert len(labels) == 4
    boxes = [box for _, box in labels]
    assert not any(overlap(one, other) for one in boxes for other in boxes if one is not other)
    assert placed(frame, [("name", spot)], [(0.0, 0.0, 2000.0, 2000.0)]) == []
    assert placed(frame, [("n" * 400, spot)], []) == []
    corner = placed(frame, [("name", [(frame.pixel(0.0, 10.0), 4.0)])], [])
    assert corner[0][1][1] > frame.stage_top
