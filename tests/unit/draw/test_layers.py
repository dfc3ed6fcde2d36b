"""Each layer is drawn when it is asked for, and says what it shows: cells, boxes, names, impacts, lights."""

from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.parts.cells import cells_of
from carom.draw.parts.frame import Frame
from carom.draw.parts.moment import LATEST, MOST_LATEST, strong
from carom.draw.parts.names import overlap, placed
from carom.shapes.aabb import Aabb
from tests.worlds import crowded

SVG = "{http://www.w3.org/2000/svg}"


def drawn(picture: draw.Picture) -> dict[str, list[Any]]:
    """The marks of each layer of a picture."""
    root = ElementTree.fromstring(draw.svg(picture))
    marks = {"path", "circle", "polyline", "polygon", "text"}
    return {
        group.get("id"): [mark for mark in group.iter() if mark.tag.removeprefix(SVG) in marks]
        for group in root.findall(f"{SVG}g")
    }


def words(marks: list[Any]) -> list[str]:
    """The words among some marks."""
    return [mark.text for mark in marks if mark.tag == f"{SVG}text"]


def of_world(world: carom.World, *layers: Layer, trace: draw.Trace | None = None) -> dict[str, list[Any]]:
    """The marks of a picture of a world that shows some layers."""
    return drawn(draw.picture_of(world, "name", layers=layers, trace=trace))


def at_end(recording: carom.Recording, *layers: Layer) -> dict[str, list[Any]]:
    """The marks of a picture of a recording's end."""
    return drawn(draw.picture_at(recording, layers=layers))


def fallen(seconds: float = 0.5, **options: Any) -> carom.Recording:
    """A ball that has just hit a floor at x = 1, at 0.4472 s."""
    world = carom.World(gravity=(0, -10), detection="continuous")
    world.add(carom.Segment((-3, 0), (3, 0), name="floor", **options))
    world.add(carom.Ball((1, 1.5), 0.5, name="ball"))
    return carom.Recording.of(world, seconds)


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


@pytest.mark.parametrize("broad_phase", ["grid", "quadtree"])
def test_every_shape_lies_in_cells(broad_phase: str) -> None:
    world = crowded(broad_phase=broad_phase)
    scene = carom.Scene.from_world(world)
    cells = cells_of(scene, 0.4)
    assert len(cells) > 10
    assert all(cell.shapes > 0 for cell in cells)
    for shape in scene.build().shapes:
        if not isinstance(shape, carom.Compound) and shape.motion == carom.Motion.STATIC:
            x, y = shape.position
            on_it = shape.p0 if isinstance(shape, carom.Arc) else (x, y)
            on_it = (x + shape.radius, y) if isinstance(shape, carom.Circle) else on_it
            assert any(holds(cell.box, on_it) for cell in cells), shape


def holds(box: Aabb, point: tuple[float, float]) -> bool:
    """Whether a point is in a box."""
    return box.left <= point[0] <= box.right and box.bottom <= point[1] <= box.top


def test_brute_force_has_no_cells_and_the_picture_says_so() -> None:
    marks = of_world(crowded(broad_phase="brute"), Layer.CELLS, Layer.SHAPES)
    assert marks["cells"] == []
    assert any("There are no cells" in line for line in words(marks["panel"]))
    assert "cell of the broad phase" not in words(marks["panel"])


def test_cells_end_at_the_stage() -> None:
    picture = draw.picture_of(crowded(), "name", layers=[Layer.CELLS])
    for mark in drawn(picture)["cells"]:
        if mark.tag == f"{SVG}polygon":
            x = [float(number) for number in mark.get("points").split()[::2]]
            assert min(x) >= picture.frame.stage_left - 0.01
            assert max(x) <= picture.frame.panel_left


def test_drawing_cells_leaves_the_world_as_it_is() -> None:
    world = crowded()
    world.run(0.1)
    before = world.snapshot()
    of_world(world, *Layer)
    assert world.snapshot() == before


# -- boxes, sectors, velocities ----------------------------------------------------------------------------------------


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
    tips = [mark for mark in drawn(picture)["velocities"] if mark.tag == f"{SVG}polygon"]
    x, y = zip(*np.array(tips[-1].get("points").split(), float).reshape(-1, 2).tolist(), strict=True)
    frame = picture.frame
    assert frame.stage_left - 20.0 < min(x)
    assert max(x) < frame.panel_left
    assert frame.stage_top - 20.0 < min(y)
    assert max(y) < frame.height


# -- impacts -----------------------------------------------------------------------------------------------------------


def test_the_latest_hits_have_reticles_tangents_and_normals() -> None:
    layers = (Layer.RETICLES, Layer.TANGENTS, Layer.NORMALS)
    recording = fallen()
    marks = at_end(recording, *layers)
    frame = draw.picture_at(recording, layers=layers).frame
    ring = next(mark for mark in marks["reticles"] if mark.tag == f"{SVG}circle")
    assert (float(ring.get("cx")), float(ring.get("cy"))) == pytest.approx(frame.pixel(1.0, 0.0), abs=0.02)
    assert len(marks["reticles"]) == 5
    (tangent,) = marks["tangents"]
    assert len({place.split()[1] for place in tangent.get("d")[1:].split("L")}) == 1
    assert len(marks["normals"]) == 2
    late = at_end(fallen(0.45 + 1.2 * LATEST), *layers)
    assert len(late["reticles"]) == 5  # of the second bounce


def test_a_reticle_turns_as_time_goes_by() -> None:
    seen = {ElementTree.tostring(at_end(fallen(time), Layer.RETICLES)["reticles"][1]) for time in (0.5, 0.6, 0.7)}
    assert len(seen) == 3


def test_only_the_latest_hits_are_marked() -> None:
    world = crowded(40)
    trace = draw.Trace(world)
    for _ in range(40):
        trace.note(world.step(1 / 60))
    assert len(trace.latest) == MOST_LATEST
    assert (np.diff(trace.latest["time"]) >= 0.0).all()
    recording = carom.Recording.of(crowded(40), 40 / 60)
    kept = draw.picture_at(recording).moment.latest
    assert kept.tobytes() == trace.latest.tobytes()


def test_without_a_run_tangents_and_normals_are_those_of_shapes() -> None:
    world = carom.World()
    for shape in (
        carom.Segment((0, 0), (4, 0)),
        carom.Arc((0, 0), 3, 0.5, 2.0),
        carom.Circle((0, 0), 2),
        carom.Circle((0, 0), 0.01),
        carom.Point((1, 1)),
    ):
        world.add(shape)
    marks = of_world(world, Layer.TANGENTS, Layer.NORMALS, Layer.RETICLES, Layer.LIGHTS)
    assert len(marks["tangents"]) == 6
    assert len([mark for mark in marks["normals"] if mark.tag == f"{SVG}path"]) == 3
    assert marks["reticles"] == marks["lights"] == []


def legend_of(picture: draw.Picture) -> list[str]:
    """The words of a picture's legend."""
    return [entry for entry, _ in picture.panel.entries]


def test_the_legend_names_only_what_there_is() -> None:
    untouched = carom.World()
    untouched.add(carom.Ball((0, 0), 1))
    run = carom.Recording.of(untouched, 0.1)
    assert legend_of(draw.picture_at(run, layers=Layer)) == ["balls", "track, fading with age", "velocity", "box"]
    assert legend_of(draw.picture_of(carom.World(), "empty", layers=Layer)) == []
    marks = {"hit, sized by its impulse", "was just hit", "turns by speed of impact", "normal", "tangent"}
    assert marks <= set(legend_of(draw.picture_at(fallen(), layers=Layer)))


def test_what_was_hit_glows_for_a_moment() -> None:
    assert len(at_end(fallen(0.4), Layer.LIGHTS)["lights"]) == 0
    assert len(at_end(fallen(0.5), Layer.LIGHTS)["lights"]) == 3
    assert len(at_end(fallen(0.9), Layer.LIGHTS)["lights"]) == 0


def test_posts_and_moving_parts_glow_too() -> None:
    world = carom.World()
    world.add(carom.Point((0, 0)))
    world.add(carom.Segment((2, -1), (2, 1), motion="kinematic"))
    world.add(carom.Ball((-1, 0), 0.5, velocity=(6, 0)))
    world.add(carom.Ball((1, 0), 0.4, velocity=(6, 0)))
    assert len(at_end(carom.Recording.of(world, 0.2), Layer.LIGHTS)["lights"]) == 6


@pytest.mark.parametrize(("values", "few"), [([], 1.0), ([0.0, 0.0], 1.0), ([1.0, 2.0, 3.0], 2.9)])
def test_sizes_are_relative_to_what_few_exceed(values: list[float], few: float) -> None:
    assert strong(np.array(values)) == pytest.approx(few)


# -- names -------------------------------------------------------------------------------------------------------------


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
    assert words(marks["names"]) == ["step \N{MULTIPLICATION SIGN} 3", "ring", "bow", "oar \N{MULTIPLICATION SIGN} 2"]
    assert words(marks["names-moving"]) == ["<ball>"]


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
