"""Makes the pictures of the games, without a screen: `python -m docs.figures.screens FOLDER`."""

import os
import sys
from pathlib import Path

import pygame

from carom.play.pinball.rules.game import Pinball
from carom.play.pinball.screen.app import PinballApp
from carom.play.pool.app import PoolApp
from carom.play.toy.app import Toy
from carom.play.window import Game, Window

FRAME = 1 / 60


def keep(game: Game, keys: list[int], frames: int, path: Path, mouse: tuple[int, int] = (0, 0)) -> None:
    """Play a game for some frames after the mouse was moved and keys were pressed; write what it shows."""
    window = Window(game)
    window.frame(FRAME)
    pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=mouse, rel=(1, 1), buttons=(0, 0, 0)))
    for key in keys:
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key))
    for _ in range(frames):
        window.frame(FRAME)
    pygame.image.save(window.surface, path)
    pygame.quit()


def main(folder: Path) -> None:
    """Write the pictures into a folder."""
    for driver in ("SDL_VIDEODRIVER", "SDL_AUDIODRIVER"):
        os.environ[driver] = "dummy"
    # As large as screens are: a smaller one makes the window smaller, and the mouse points elsewhere.
    pygame.display.get_desktop_sizes = lambda: [(1920, 1080)]
    keep(PinballApp(print, Pinball(seed=3)), [], 1320, folder / "pinball-game.jpg")
    shot = [*[pygame.K_UP] * 8, pygame.K_c, pygame.K_RETURN]
    keep(PoolApp(print), shot, 200, folder / "pool-game.jpg", mouse=(843, 440))
    toy = Toy(print)
    toy.desk.change("count", 12)
    keep(toy, [pygame.K_n, pygame.K_6, pygame.K_r], 600, folder / "toy-game.jpg")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
