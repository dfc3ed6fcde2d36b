"""Screenshots and the icon: PrtScr and F12 keep the picture in a file of its own, and the window says where."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import platformdirs
import pygame
import pytest

from carom.play import files, screenshot
from carom.play.icon import icon
from carom.play.meter import FrameMeter
from carom.play.window import TOLD, Window


class Painted:
    """A game of one picture, which notes the keys that it is told of."""

    title = "carom: A Game!"
    size = (640, 120)

    def __init__(self) -> None:
        self.running = True
        self.meter = FrameMeter(60)
        self.keys: list[int] = []

    def handle(self, event: pygame.event.Event) -> None:
        if event.type == pygame.KEYDOWN:
            self.keys.append(event.key)

    def advance(self, seconds: float) -> None:
        pass

    def draw(self, surface: pygame.Surface) -> None:
        surface.fill((10, 20, 30))
        surface.fill((200, 100, 50), (5, 5, 50, 50))


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder; the user's pictures folder is another."""
    folder, current = tmp_path / "Pictures", tmp_path / "here"
    folder.mkdir()
    current.mkdir()
    monkeypatch.setattr(platformdirs, "user_pictures_path", lambda: folder)
    monkeypatch.chdir(current)
    return current


def press(window: Window, key: int) -> None:
    """Press a key, and let a frame go by."""
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key))
    window.frame(1 / 60)


def told(window: Window) -> bool:
    """Whether something is written in the corner."""
    corner = pygame.surfarray.array3d(window.surface)[:, 100:]
    return bool((corner != (10, 20, 30)).any())


@pytest.mark.parametrize("key", [pygame.K_PRINTSCREEN, pygame.K_F12])
def test_a_key_keeps_the_picture_and_the_window_says_where(here: Path, key: int) -> None:
    game = Painted()
    window = Window(game)
    written: list[str] = []
    draw = window._letters.draw
    window._letters.draw = lambda surface, words, *rest: (written.append(words), draw(surface, words, *rest))[1]  # type: ignore[method-assign]
    window.frame(1 / 60)
    press(window, key)
    (path,) = here.iterdir()
    assert written == [f"screenshot kept as {path}"]
    assert path.name == "carom-a-game-1.png"
    assert game.keys == []
    kept = pygame.surfarray.array3d(pygame.image.load(path))
    game.draw(window.surface)
    assert np.array_equal(kept, pygame.surfarray.array3d(window.surface)), "what is said is not in the picture"
    for _ in range(round(TOLD * 60) - 2):
        window.frame(1 / 60)
    assert told(window)
    window.frame(0.1)
    window.frame(0.1)
    assert not told(window)
    assert len(list(here.iterdir())) == 1


def test_no_file_is_overwritten(here: Path) -> None:
    window = Window(Painted())
    others = {1: b"one", 3: b"three"}
    for number, content in others.items():
        (here / f"carom-a-game-{number}.png").write_bytes(content)
    for _ in range(3):
        press(window, pygame.K_F12)
    names = {path.name for path in here.iterdir()}
    assert names == {f"carom-a-game-{number}.png" for number in range(1, 6)}
    for number, content in others.items():
        assert (here / f"carom-a-game-{number}.png").read_bytes() == content


def test_a_folder_that_takes_nothing_is_passed_over_and_the_last_one_is_told_of(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, refused, pictures = files.write_new, {here}, platformdirs.user_pictures_path()

    def write(folder: Path, name: str, content: bytes) -> Path:
        if folder in refused:
            raise PermissionError(13, "Permission denied")
        return real(folder, name, content)

    monkeypatch.setattr(files, "write_new", write)
    surface = pygame.Surface((3, 2))
    assert screenshot.keep(surface, "x") == f"screenshot kept as {pictures / 'x-1.png'}"
    refused.add(pictures)
    assert screenshot.keep(surface, "x") == f"screenshot not kept: {pictures} takes no file (Permission denied)"
    (pictures / "x-1.png").unlink()
    pictures.rmdir()
    assert screenshot.keep(surface, "x") == f"screenshot not kept: {here} takes no file (Permission denied)"
    assert not pictures.exists()


def test_a_window_has_an_icon_before_it_opens(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[tuple[str, tuple[int, int]]] = []
    set_icon, set_mode = pygame.display.set_icon, pygame.display.set_mode
    monkeypatch.setattr(
        pygame.display, "set_icon", lambda image: (seen.append(("icon", image.get_size())), set_icon(image))[1]
    )
    monkeypatch.setattr(
        pygame.display, "set_mode", lambda size, flags: (seen.append(("mode", size)), set_mode(size, flags))[1]
    )
    Window(Painted())
    assert seen == [("icon", (64, 64)), ("mode", Painted.size)]


def test_the_icon_is_a_picture_with_clear_corners() -> None:
    image = icon()
    assert image.get_at((0, 0)).a == 0
    assert image.get_at((32, 32)).a == 255
    assert len({tuple(image.get_at((x, y))) for x in range(64) for y in range(64)}) > 20
