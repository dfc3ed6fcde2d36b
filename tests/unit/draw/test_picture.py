"""What is drawn: every shape in its look, true arcs, balls, tracks and hits, in layers, composed beside a panel."""

from pathlib import Path
from xml.etree import ElementTree

import pytest

import carom
from carom import draw
from carom.draw.parts.frame import MARGIN, PANEL_WIDTH
from tests.unit.draw.svg_marks import SVG, layer, root_of, trace_of, words_in
from tests.worlds import world_of

PICTURES = Path(__file__).parents[3] / "docs" / "pictures"
LAYERS = ["ground", "sensors", "shapes", "panel", "tracks", "hits", "balls", "facts"]


def test_a_picture_makes_no_objects_of_balls_that_nobody_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    world = world_of(carom.Ball((0, 9), 1, name="first"))
    ids = world.add_balls([(3 * n, 0) for n in range(100)], radius=1.0)
    world.object(int(ids[7])).name = "eighth"
    monkeypatch.setattr(carom.Ball, "_of_row", None)
    assert draw.picture_of(world).names == {1: "first", int(ids[7]): "eighth"}


def test_the_layers_stand_in_their_order() -> None:
    assert [group.get("id") for group in root_of(world_of()).findall(f"{SVG}g")] == LAYERS


def test_a_still_picture_counts_what_there_is() -> None:
    root = root_of(world_of(carom.Circle((0, 0), 3), carom.Ball((0, 0), 1)))
    assert words_in(root.iter()) == ["name", "wall", "balls", "shapes", "1", "balls", "1"]
    assert len(layer(root, "balls").findall(f".//{SVG}circle")) == 1


def test_a_run_has_tracks_hits_and_what_they_mean() -> None:
    world = world_of(carom.Circle((0, 0), 3), carom.Ball((0, 0), 1, velocity=(7, 1)))
    trace = trace_of(world, 120)
    root = root_of(world, trace, shares=[("circle", trace.bounces)])
    assert len(layer(root, "hits").findall(f".//{SVG}circle")) == trace.bounces > 3
    tracks = layer(root, "tracks")
    assert len(tracks.findall(f".//{SVG}polyline")) == 10
    opacities = [float(group.get("opacity")) for group in tracks]
    assert opacities == sorted(opacities)
    assert {"time", "hits", "circle", "track, fading with age", "hit, sized by its impulse"} <= set(
        words_in(root.iter())
    )
    assert any("Tracks of all balls" in line for line in words_in(root.iter()))


def test_many_balls_are_one_colour_but_for_those_followed_and_the_picture_says_so() -> None:
    world = world_of(carom.Circle((0, 0), 30))
    world.add_balls([(0.5 * k - 10, 0.0) for k in range(40)], radius=0.2)
    still, moved = root_of(world), root_of(world, trace_of(world, 2))
    assert {group.get("class").split()[0] for group in layer(still, "balls")} == {"f-ball"}
    assert {"f-ball", "f-ball-1", "f-ball-2"} <= {group.get("class").split()[0] for group in layer(moved, "balls")}
    assert any("Tracks of 16 of 40 balls" in line for line in words_in(moved.iter()))


def test_strays_are_counted() -> None:
    world = carom.World(bounds=carom.Aabb(-1, -1, 1, 1))
    world.add(carom.Ball((0, 0), 0.1, velocity=(90, 0)))
    assert words_in(root_of(world, trace_of(world, 10)).iter())[-2:] == ["strays", "1"]


def test_what_left_the_stage_is_not_drawn_and_does_not_shrink_the_rest() -> None:
    world = world_of(carom.Circle((0, 0), 3), carom.Ball((1e6, 0), 1))
    picture = draw.picture_of(world, "name")
    assert picture.frame.stage.right < 4
    root = root_of(world, trace_of(world, 2))
    assert layer(root, "balls").findall(f".//{SVG}circle") == []
    assert list(layer(root, "tracks")) == []


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


@pytest.mark.slow
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
        return draw.svg(draw.picture_of(world, "toy", trace=trace_of(world, 60)))

    assert picture() == picture()


def test_drawing_a_world_does_not_change_it() -> None:
    world = carom.scenes.toy().build()
    trace = trace_of(world, 30)
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
        assert words_in(ElementTree.fromstring(draw.svg(draw.picture_of(world))).iter())[0] == "World"
        assert world.digest() == before
        world.step(0.001)
        assert world.statistics.sleeping == asleep
