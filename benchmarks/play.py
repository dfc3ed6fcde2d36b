"""The games: what a frame takes, its steps and its picture, without a screen."""

import os
from collections.abc import Callable
from random import Random
from statistics import median, quantiles
from time import process_time
from typing import Any

from benchmarks.common import Figure

TITLE = "Games: the processor's time for a frame, of 16.7 ms; the slowest of a hundred beside the median"
#: A sixtieth of a second, and how many frames are made before the measured ones.
FRAME, WARM = 1 / 60, 60


#: Pixels of the screens on which windows open, by what they are called.
SCREENS = {"": (1920, 1080), ", 4K": (3840, 2160)}


def frames(game: Any, count: int, before: Callable[[int], None] | None = None) -> tuple[float, float]:
    """Milliseconds of the processor for a frame of a game: the median, and what 99 of 100 do not exceed."""
    from carom.play.window import Window

    window = Window(game)
    spent = []
    for frame in range(WARM + count):
        if before is not None:
            before(frame)
        began = process_time()
        window.frame(FRAME)
        if frame >= WARM:
            spent.append(1e3 * (process_time() - began))
    return median(spent), quantiles(spent, n=100)[-1]


def pinball(count: int) -> dict[str, tuple[float, float]]:
    """Frames of the pinball game that plays itself, in each drawing mode."""
    from carom.play.pinball.rules.game import Pinball
    from carom.play.pinball.screen.app import PinballApp
    from carom.play.pinball.screen.lines import Mode

    figures = {}
    for mode in Mode:
        app = PinballApp(print, Pinball(seed=1))
        app.mode = mode
        figures[f"pinball, {mode.value}"] = frames(app, count)
    return figures


def toy(count: int) -> dict[str, tuple[float, float]]:
    """Frames of the toy with 100 balls, as it opens, and with all that can be shown."""
    from carom.play.toy.app import Toy
    from carom.play.toy.settings import SHOWN

    figures = {}
    for name, shown in (("as it opens", ()), ("all layers", tuple(SHOWN))):
        app = Toy(print)
        random = Random(1)
        world = app.desk.tables[0].world
        places = [(14.0 + 0.6 * (k % 24), 13.0 + 0.9 * (k // 24)) for k in range(100 - len(world.balls))]
        speeds = [(random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0)) for _ in places]
        world.add_balls(places, speeds, radius=0.2)
        for layer in shown:
            app.desk.change(layer, True)
        figures[f"toy with 100 balls, {name}"] = frames(app, count)
    return figures


def pool(count: int) -> dict[str, tuple[float, float]]:
    """Frames of the pool game, aiming and rolling."""
    import pygame

    from carom.play.pool.app import PoolApp

    def turn(frame: int) -> None:
        place = 300 + 5 * (frame % 100), 200 + 3 * (frame % 90)
        pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=place, rel=(1, 1), buttons=(0, 0, 0)))

    def shoot(frame: int) -> None:
        if frame % 240 == 0:
            pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_RETURN))

    return {
        "pool, aiming": frames(PoolApp(print), count, turn),
        "pool, the balls roll": frames(PoolApp(print), count, shoot),
    }


def run(quick: bool) -> list[Figure]:
    """Milliseconds of a frame of each game."""
    for driver in ("SDL_VIDEODRIVER", "SDL_AUDIODRIVER"):
        os.environ[driver] = "dummy"
    import pygame

    count = 20 if quick else 300
    figures = []
    for screen, size in SCREENS.items():
        pygame.display.get_desktop_sizes = lambda size=size: [size]
        figures += [
            Figure(f"{workload}{screen}", "carom", middle, "ms", remarks={"99 % within": f"{slow:.2f} ms"})
            for game in (pinball, toy, pool)
            for workload, (middle, slow) in game(count).items()
        ]
    pygame.quit()
    return figures
