"""What is drawn: every shape in its look, true arcs, balls, tracks and hits, in layers, composed beside a panel."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import carom
from carom import draw
from carom.draw.parts.frame import MARGIN, PANEL_WIDTH
from carom.draw.parts.legend import seconds
from carom.draw.parts.looks import BUMPER, GATE, GUARD, MOVING, OFF, POST, SENSOR, WALL, Look, look_of
from carom.draw.picture import open_way
from tests.worlds import world_of

SVG = "{http://www.w3.org/2000/svg}"
PICTURES = Path(__file__).parents[3] / "docs" / "pictures"
LAYERS = ["ground", "sensors", "shapes", "panel", "tracks", "hits", "balls", "facts"]


def drawn(world: carom.World, trace: draw.Trace | None = None, **options: object) -> ElementTree.Element:
    """The root of the picture of a world."""
    return ElementTree.fromstring(draw.svg(draw.picture_of(world, "name", trace=trace, **options)))


def layer(root: ElementTree.Element, name: str) -> ElementTree.Element:
    """One layer of a picture."""
    return root.find(f"{SVG}g[@id='{name}']")


def words(root: ElementTree.Element) -> list[str]:
    """All words in a picture, line by line."""
    return [text.text for text in root.iter(f"{SVG}text")]


def run(world: carom.World, steps: int) -> draw.Trace:
    """The trace of some steps."""
    trace = draw.Trace(world)
    for _ in range(steps):
        trace.note(world.step(1 / 60))
    return trace


def test_a_picture_makes_no_objects_of_balls_that_nobody_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    world = world_of(carom.Ball((0, 9), 1, name="first"))
    ids = world.add_balls([(3 * n, 0) for n in range(100)], radius=1.0)
    world.object(int(ids[7])).name = "eighth"
    monkeypatch.setattr(carom.Ball, "_of_row", None)
    assert draw.picture_of(world).names == {1: "first", int(ids[7]): "eighth"}


@pytest.mark.parametrize(
    ("shape", "look"),
    [
        (carom.Segment((0, 0), (1, 0)), WALL),
        (carom.Segment((0, 0), (1, 0), elasticity=1.5), BUMPER),
        (carom.Circle((0, 0), 1, solid=True, kick=2.0), BUMPER),
        (carom.Arc((0, 0), 1, 0, 1, motion="kinematic"), MOVING),
        (carom.Circle((0, 0), 1, sensor=True), SENSOR),
        (carom.Circle((0, 0), 1, can_collide=False), OFF),
        (carom.Gate((0, 0), (1, 0)), GATE),
        (carom.Point((9, 9)), POST),
        (carom.Point((1, 0)), GUARD),
    ],
)
def test_a_shape_looks_like_what_it_does(shape: carom.Shape, look: Look) -> None:
    assert look_of(shape, frozenset({(0.0, 0.0), (1.0, 0.0)})) is look


def test_the_layers_stand_in_their_order() -> None:
    assert [group.get("id") for group in drawn(world_of()).findall(f"{SVG}g")] == LAYERS


def test_round_things_are_round() -> None:
    root = drawn(world_of(carom.Arc((0, 0), 2, 0.5, 2.0), carom.Circle((0, 0), 3), carom.Segment((0, 0), (1, 1))))
    shapes = layer(root, "shapes")
    assert len(shapes.findall(f".//{SVG}circle")) == 1
    paths = [path.get("d") for path in shapes.iter(f"{SVG}path")]
    assert len([path for path in paths if re.fullmatch(r"M\S+ \S+A\S+ \S+ 0 0 0 \S+ \S+", path)]) == 1
    assert shapes.findall(f".//{SVG}polyline") == []


def test_a_compound_is_drawn_part_by_part_with_one_pivot() -> None:
    parts = [carom.Segment((0, 0), (2, 0)), carom.Segment((0, 1), (2, 1))]
    shapes = layer(drawn(world_of(carom.Compound(parts, pivot=(0, 0.5)))), "shapes")
    assert len(shapes.findall(f".//{SVG}path")) == 2
    assert len(shapes.findall(f".//{SVG}circle")) == 1


def test_a_gate_has_an_arrow() -> None:
    shapes = layer(drawn(world_of(carom.Gate((0, 0), (1, 0)))), "shapes")
    assert len(shapes.findall(f".//{SVG}polygon")) == 1


@pytest.mark.parametrize(("direction", "way"), [((5, 0.1), (0, 1)), ((5, -0.1), (0, -1)), (None, (0, 1))])
def test_an_arrow_stands_square_to_its_gate(direction: tuple[float, float] | None, way: tuple[float, float]) -> None:
    assert open_way(carom.Gate((0, 0), (1, 0), direction=direction)) == way


def test_a_still_picture_counts_what_there_is() -> None:
    root = drawn(world_of(carom.Circle((0, 0), 3), carom.Ball((0, 0), 1)))
    assert words(root) == ["name", "wall", "balls", "shapes", "1", "balls", "1"]
    assert len(layer(root, "balls").findall(f".//{SVG}circle")) == 1


def test_a_run_has_tracks_hits_and_what_they_mean() -> None:
    world = world_of(carom.Circle((0, 0), 3), carom.Ball((0, 0), 1, velocity=(7, 1)))
    trace = run(world, 120)
    root = drawn(world, trace, shares=[("circle", trace.bounces)])
    assert len(layer(root, "hits").findall(f".//{SVG}circle")) == trace.bounces > 3
    tracks = layer(root, "tracks")
    assert len(tracks.findall(f".//{SVG}polyline")) == 10
    opacities = [float(group.get("opacity")) for group in tracks]
    assert opacities == sorted(opacities)
    assert {"time", "hits", "circle", "track, fading with age", "hit, sized by its impulse"} <= set(words(root))
    assert any("Tracks of all balls" in line for line in words(root))


def test_stronger_hits_have_larger_dots() -> None:
    world = carom.World(gravity=(0, -10))
    world.add(carom.Segment((-5, 0), (5, 0), elasticity=0.7))
    world.add(carom.Ball((0, 4), 0.5))
    trace = run(world, 200)
    circles = layer(drawn(world, trace), "hits").iter(f"{SVG}circle")
    radii = [float(circle.get("r")) for circle in circles]
    assert radii == sorted(radii, reverse=True)
    assert radii[0] > radii[-1]


def test_many_balls_are_one_colour_but_for_those_followed_and_the_picture_says_so() -> None:
    world = world_of(carom.Circle((0, 0), 30))
    world.add_balls([(0.5 * k - 10, 0.0) for k in range(40)], radius=0.2)
    still, moved = drawn(world), drawn(world, run(world, 2))
    assert {group.get("class").split()[0] for group in layer(still, "balls")} == {"f-ball"}
    assert {"f-ball", "f-ball-1", "f-ball-2"} <= {group.get("class").split()[0] for group in layer(moved, "balls")}
    assert any("Tracks of 16 of 40 balls" in line for line in words(moved))


def test_balls_of_less_than_two_pixels_have_no_rim() -> None:
    world = world_of(carom.Circle((0, 0), 1000), carom.Ball((0, 0), 0.5), carom.Ball((9, 0), 50))
    groups = list(layer(drawn(world), "balls"))
    assert [("stroke-width" in group.attrib) for group in groups] == [False, True]


def test_strays_are_counted() -> None:
    world = carom.World(bounds=carom.Aabb(-1, -1, 1, 1))
    world.add(carom.Ball((0, 0), 0.1, velocity=(90, 0)))
    assert words(drawn(world, run(world, 10)))[-2:] == ["strays", "1"]


def test_a_picture_says_when_it_does_not_show_all_hits() -> None:
    world = world_of(carom.Circle((0, 0), 3))
    trace = draw.Trace(world)
    trace.bounces = 10_000
    lines = " ".join(words(drawn(world, trace)))
    assert "Of the hits, the 1,500 strongest are shown." in lines


def test_what_left_the_stage_is_not_drawn_and_does_not_shrink_the_rest() -> None:
    world = world_of(carom.Circle((0, 0), 3), carom.Ball((1e6, 0), 1))
    picture = draw.picture_of(world, "name")
    assert picture.frame.stage.right < 4
    root = drawn(world, run(world, 2))
    assert layer(root, "balls").findall(f".//{SVG}circle") == []
    assert list(layer(root, "tracks")) == []


def test_a_track_that_leaves_the_stage_is_cut_there() -> None:
    world = world_of(carom.Segment((-1, -1), (1, -1)), carom.Segment((-1, 1), (1, 1)))
    world.add(carom.Ball((0, 0), 0.25, velocity=(6, 0)))
    places = [
        float(x)
        for line in layer(drawn(world, run(world, 60)), "tracks").iter(f"{SVG}polyline")
        for x in line.get("points").split()[::2]
    ]
    picture = draw.picture_of(world, "name")
    assert places
    assert max(places) <= picture.frame.panel_left - MARGIN


@pytest.mark.parametrize(
    "world",
    [
        world_of(),
        world_of(carom.Point((1, 1))),
        world_of(carom.Ball((1, 1), 1)),
        world_of(carom.Segment((0, 0), (1e-9, 0))),
        world_of(carom.Segment((0, 0), (1e9, 1))),
    ],
    ids=["nothing", "a point", "a ball", "tiny", "vast"],
)
def test_any_world_has_a_picture_of_ordinary_size(world: carom.World) -> None:
    picture = draw.picture_of(world, "name")
    assert PANEL_WIDTH < picture.frame.width < 1300
    assert 100 <= picture.frame.height < 1300
    assert "nan" not in draw.svg(picture)


@pytest.mark.parametrize("name", carom.scenes.names())
def test_every_shipped_scene_has_a_picture_that_holds_its_panel(name: str) -> None:
    make = getattr(carom.scenes, name)
    world = make(balls=50).build() if name in {"gas", "galton"} else make().build()
    picture = draw.picture_of(world, name, caption=make.__doc__ or "")
    root = ElementTree.fromstring(draw.svg(picture))
    panel = layer(root, "panel")
    assert max(float(text.get("y")) for text in panel.iter(f"{SVG}text")) < picture.frame.height - 0.5 * MARGIN
    assert all(float(text.get("x")) <= picture.frame.width - MARGIN for text in panel.iter(f"{SVG}text"))


def test_pictures_are_the_same_bytes_every_time() -> None:
    def picture() -> str:
        world = carom.scenes.toy().build()
        return draw.svg(draw.picture_of(world, "toy", trace=run(world, 60)))

    assert picture() == picture()


def test_drawing_a_world_does_not_change_it() -> None:
    world = carom.scenes.toy().build()
    trace = run(world, 30)
    before = world.snapshot()
    draw.svg(draw.picture_of(world, "toy", trace=trace))
    assert world.snapshot() == before


def test_another_painter_gets_the_same_marks() -> None:
    class Counter:
        """Counts the calls of each kind."""

        def __init__(self) -> None:
            self.calls: dict[str, int] = {}

        def __getattr__(self, name: str) -> object:
            return lambda *arguments: self.calls.update({name: self.calls.get(name, 0) + 1})

    counter = Counter()
    draw.picture_of(carom.scenes.toy().build(), "toy").draw(counter)
    assert counter.calls["layer"] == len(LAYERS)
    assert {"segment", "circle", "arc", "polyline", "text"} <= counter.calls.keys()


@pytest.mark.parametrize("path", sorted(PICTURES.glob("*.svg")), ids=lambda path: path.name)
def test_the_pictures_of_the_docs_are_whole_and_small(path: Path) -> None:
    assert ElementTree.parse(path).getroot().tag == f"{SVG}svg"
    assert path.stat().st_size < 400_000


@pytest.mark.parametrize(("time", "text"), [(10.0, "10"), (0.125, "0.12"), (1234.5, "1,234.5"), (0.0, "0")])
def test_times_are_short(time: float, text: str) -> None:
    assert seconds(time) == f"{text}\N{NO-BREAK SPACE}s"


def test_the_example_of_the_module_makes_a_file(tmp_path: Path) -> None:
    path = tmp_path / "toy.svg"
    path.write_text(draw.svg(draw.picture_of(carom.scenes.toy().build(), "Toy"), draw.ThemeName.DARK), encoding="utf-8")
    assert ElementTree.parse(path).getroot().get("width")


def test_a_picture_needs_no_name_and_wakes_nobody() -> None:
    sleepy = world_of(carom.Ball((0, 0), 1), carom.Ball((5, 0), 1))
    sleepy.sleep_speed = 1.0
    sleepy.run(1.0)
    for world in (carom.World(), world_of(carom.Point((0, 0))), sleepy):
        before, asleep = world.digest(), world.statistics.sleeping
        assert words(ElementTree.fromstring(draw.svg(draw.picture_of(world))))[0] == "World"
        assert world.digest() == before
        world.step(0.001)
        assert world.statistics.sleeping == asleep
