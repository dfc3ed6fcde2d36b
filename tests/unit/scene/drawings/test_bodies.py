"""What drawings are read as."""

from carom.scene.drawings.bodies import Body, Drawing
from carom.scene.faults import Faults
from carom.scene.scene import Scene


def test_bodies_and_drawings_begin_empty_and_apart() -> None:
    first, second = Body("a", None, {}), Body("b", None, {})
    first.outlines.append([])
    assert second.outlines == []
    drawing = Drawing(Faults(Scene))
    drawing.bodies.append(first)
    drawing.left_out["text"] += 1
    assert Drawing(Faults(Scene)).bodies == []
    assert Drawing(Faults(Scene)).left_out == {}
