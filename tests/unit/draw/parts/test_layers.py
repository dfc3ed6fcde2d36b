"""Each layer is drawn when it is asked for, and says what it shows: cells, boxes, names, impacts, lights."""

from typing import Any

import pytest

import carom
from carom import draw
from carom.draw import Layer
from tests.unit.draw.svg_marks import fallen, of_world
from tests.worlds import crowded


@pytest.mark.parametrize("layers", [["hit"], "hits", [Layer.HITS, 3]])
def test_other_layers_are_refused(layers: Any) -> None:
    run, told = fallen(), r"layers must be among cells, boxes, .* not "
    for show in (draw.picture_at, draw.replay_page):
        with pytest.raises(carom.InvalidArgument, match=told):
            show(run, layers=layers)
    with pytest.raises(carom.InvalidArgument, match=told):
        draw.picture_of(carom.World(), "name", layers=layers)


@pytest.mark.parametrize("size", [0, -5, 63, 9000, 800.5, "800", (10, 10), (800, 9000)])
def test_other_sizes_are_refused(size: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match="size"):
        draw.picture_at(fallen(), size=size)
    with pytest.raises(carom.InvalidArgument, match="size"):
        draw.picture_of(carom.World(), "name", size=size)


@pytest.mark.compiled
@pytest.mark.parametrize("layer", Layer)
def test_only_what_is_asked_for_is_drawn(layer: Layer) -> None:
    world = crowded()
    trace = draw.Trace(world)
    for _ in range(30):
        trace.note(world.step(1 / 60))
    marks = of_world(world, layer, trace=trace)
    assert {name.removesuffix("-moving") for name in marks} == {layer.value, "ground", "panel", "facts"}
    if layer is not Layer.LIGHTS:
        assert sum(len(group) for name, group in marks.items() if name.startswith(layer.value)) > 0


def test_no_layers_are_no_marks() -> None:
    assert set(of_world(crowded())) == {"ground", "panel", "facts"}


# -- cells -------------------------------------------------------------------------------------------------------------


# -- boxes, sectors, velocities ----------------------------------------------------------------------------------------


# -- impacts -----------------------------------------------------------------------------------------------------------


# -- names -------------------------------------------------------------------------------------------------------------
