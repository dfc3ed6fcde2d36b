"""What `carom toy`, `pinball` and `pool` do: the games are imported once it is known that their packages are there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from carom.cli import files, outputs
from carom.extras import needed

if TYPE_CHECKING:
    from pathlib import Path

    from carom.play.meter import FrameMeter

#: How many balls there may be to pot in a game of pool.
MOST_BALLS = 8
#: The endings of charts.
CHARTS = (".svg", ".png", ".pdf")


def tell(line: str) -> None:
    """Say on stderr what a game has to say."""
    typer.echo(f"carom: {line}", err=True)


def toy(seconds: float | None) -> None:
    """Play with the toy."""
    needed("pygame", "pygame-ce", "play", "games")
    needed("pygame_gui", "pygame_gui", "play", "panels of games")
    from carom.play.toy import run

    report("toy", run(tell=tell, seconds=seconds), seconds)


def toy_chart(path: Path) -> None:
    """Write the chart of box tests, and print its figures."""
    outputs.check_outputs([path], CHARTS, None)
    needed("pygame", "pygame-ce", "play", "games")
    needed("pygame_gui", "pygame_gui", "play", "panels of games")
    needed("matplotlib", "matplotlib", "study", "charts")
    from carom.play.toy import write_chart

    files.write_all([path], dict.fromkeys(CHARTS, lambda file: write_chart(file, typer.echo)))


def pinball(seconds: float | None) -> None:
    """Play pinball."""
    needed("pygame", "pygame-ce", "play", "games")
    from carom.play.pinball import run

    report("pinball", run(tell=tell, seconds=seconds), seconds)


def pool(seconds: float | None, balls: int) -> None:
    """Play pool with so many balls to be potted."""
    needed("pygame", "pygame-ce", "play", "games")
    from carom.play.pool import run

    report("pool", run(tell=tell, seconds=seconds, balls=balls), seconds)


def report(name: str, meter: FrameMeter, seconds: float | None) -> None:
    """Print how long frames took, where a game was played for a given time."""
    if seconds is not None:
        typer.echo(f"{name}: {meter.line()}")
