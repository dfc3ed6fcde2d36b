"""Every shipped scene and every layer looks as it was seen and found good; `--renew-pictures` keeps them anew."""

from functools import cache
from pathlib import Path
from typing import Any

import pytest

import carom
from carom import draw
from carom.draw import Layer, ThemeName
from tests.pictures.compare import KEPT, check, differences, pixels, pygame

#: How each shipped scene is made and for how many seconds it runs: short runs, for they are interpreted too.
RUNS: dict[str, tuple[dict[str, Any], float]] = {
    "annulus": ({}, 1.0),
    "breakout": ({}, 1.4),
    "circle": ({}, 1.0),
    "ellipse": ({"tolerance": 1e-3}, 1.0),
    "flower": ({}, 1.0),
    "galton": ({"rows": 6, "balls": 10}, 0.7),
    "gas": ({"balls": 9}, 0.4),
    "lemon": ({}, 1.0),
    "lorentz": ({}, 0.5),
    "mushroom": ({}, 1.0),
    "newtons_cradle": ({}, 0.8),
    "pinball": ({}, 0.9),
    "pool": ({}, 1.2),
    "rectangle": ({}, 1.0),
    "sinai": ({}, 1.0),
    "stadium": ({}, 1.0),
    "toy": ({}, 1.6),
    "wedge": ({}, 0.8),
}
#: The shown size of scenes, and of layers.
SCENE_SIZE, LAYER_SIZE = (900, 640), 420


@cache
def recorded(name: str) -> carom.Recording:
    """The recording of a shipped scene."""
    arguments, seconds = RUNS[name]
    world = getattr(carom.scenes, name)(**arguments).build()
    return carom.Recording.of(world, seconds, name=name.replace("_", " ").capitalize())


@cache
def parlour() -> carom.Recording:
    """A recording of a room with one of everything that a layer shows, at a moment in which much has just happened."""
    world = carom.World(detection="discrete", gravity=(0.0, -6.0), substeps=2)
    corners = [(0.0, 0.0), (8.0, 0.0), (8.0, 6.0), (0.0, 6.0)]
    walls = [carom.Segment(corners[k - 1], corners[k], elasticity=0.9, name="wall") for k in range(4)]
    for shape in [*walls, *carom.guard_points(walls)]:
        world.add(shape)
    world.add(carom.Arc((4.0, 1.2), 1.0, 3.4, 6.0, name="cup"))
    world.add(carom.Arc((8.0, 6.0), 2.0, 3.2, 4.6, name="corner"))
    world.add(carom.Circle((2.0, 3.0), 0.6, solid=True, kick=2.0, name="bumper"))
    world.add(carom.Circle((6.0, 2.2), 0.8, sensor=True, solid=True, name="eye"))
    world.add(carom.Gate((0.0, 4.2), (1.4, 4.2), direction=(0.0, 1.0), name="gate"))
    paddle = [carom.Segment((5.2, 3.8), (6.4, 3.8)), carom.Point((6.4, 3.8))]
    world.add(carom.Compound(paddle, pivot=(5.2, 3.8), angular_velocity=3.0, name="paddle"))
    for number, (x, y, vx, vy) in enumerate([(1, 1, 3, 4), (3, 5, -3, 1), (6.5, 5, -2, -2), (4, 2, 1, 0)]):
        world.add(carom.Ball((x, y), 0.25, velocity=(vx, vy), name=f"ball {number + 1}"))
    return carom.Recording.of(world, 0.8, name="Parlour")


@pytest.fixture
def renew(request: pytest.FixtureRequest) -> bool:
    """Whether pictures are to be kept anew."""
    return bool(request.config.getoption("--renew-pictures"))


def test_every_shipped_scene_has_a_picture() -> None:
    assert set(RUNS) == set(carom.scenes.names())


@pytest.mark.slow
@pytest.mark.parametrize("theme", [ThemeName.LIGHT, ThemeName.DARK, ThemeName.PRINT])
@pytest.mark.parametrize("name", RUNS)
def test_a_scene_looks_as_it_did(name: str, theme: ThemeName, renew: bool, tmp_path: Path) -> None:
    picture = draw.picture_at(recorded(name), size=SCENE_SIZE)
    check(f"{name}-{theme}", picture, theme, renew=renew, folder=tmp_path)


@pytest.mark.parametrize("layer", Layer)
def test_a_layer_looks_as_it_did(layer: Layer, renew: bool, tmp_path: Path) -> None:
    layers = {layer} if layer in {Layer.SHAPES, Layer.SENSORS} else {layer, Layer.SHAPES}
    picture = draw.picture_at(parlour(), layers=layers, size=LAYER_SIZE)
    check(f"layer-{layer}", picture, ThemeName.LIGHT, renew=renew, folder=tmp_path)


def test_a_layer_changes_its_picture() -> None:
    seen = {path.read_bytes() for path in KEPT.glob("layer-*.png")}
    assert len(seen) == len(Layer)


def test_what_is_kept_is_what_is_compared() -> None:
    names = {f"{name}-{theme}" for name in RUNS for theme in ("light", "dark", "print")}
    assert {path.stem for path in KEPT.iterdir()} == names | {f"layer-{layer}" for layer in Layer}


def test_a_missing_ball_is_seen() -> None:
    whole = draw.picture_at(recorded("toy"), size=SCENE_SIZE)
    without = draw.picture_at(recorded("toy"), layers=draw.DEFAULT_LAYERS - {Layer.BALLS}, size=SCENE_SIZE)
    surfaces = []
    for picture in (whole, without):
        painter = draw.RasterPainter(whole.frame)
        picture.draw(painter)
        surfaces.append(pixels(painter.surface))
    assert differences(surfaces[0], surfaces[0], []) == []
    assert len(differences(surfaces[0], surfaces[1], [])) > 20
    assert "pixels, not" in differences(surfaces[0], surfaces[0][1:], [])[0]


def test_no_window_is_opened() -> None:
    assert not pygame.display.get_init()
